import "./styles/main.css";
import { startApp } from "./app";
import { loadCore } from "./core";
import { load } from "./keep";
import { speak } from "./language";
import { firstState } from "./state";
import { merge } from "./stored";
import { showBroken } from "./views/broken";

addEventListener("probewright-panic", event => showBroken(String((event as CustomEvent).detail)));
try {
  const [stored, core] = [await load(), loadCore()];
  await speak(merge(firstState(), stored).page.language).catch(console.warn); // words that cannot be fetched: English
  await startApp(await core, stored);
} catch (problem) {
  console.error(problem);
  showBroken(problem instanceof Error ? problem.message : String(problem));
}
