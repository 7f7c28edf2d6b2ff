import "./styles/main.css";
import { startApp } from "./app";
import { loadCore } from "./core";
import { choose } from "./texts";
import { showBroken } from "./views/broken";

addEventListener("probewright-panic", (event) => showBroken(String((event as CustomEvent).detail)));
document.documentElement.lang = choose(navigator.languages);
try {
  await startApp(await loadCore());
} catch (problem) {
  console.error(problem);
  showBroken(problem instanceof Error ? problem.message : String(problem));
}
