import "../styles/main.css";
import { loadCore } from "../core/core";
import { speak } from "../language";
import { load } from "../state/keep";
import { firstState } from "../state/state";
import { merge } from "../state/stored";
import { showBroken } from "../views/broken";
import { startApp } from "./app";

addEventListener("probewright-panic", event => showBroken(String((event as CustomEvent).detail)));
try {
  const [{ stored, returned }, core] = [await load(), loadCore()];
  await speak(merge(firstState(), stored).page.language).catch(console.warn); // words that cannot be fetched: English
  await startApp(await core, stored, returned);
} catch (problem) {
  console.error(problem);
  showBroken(problem instanceof Error ? problem.message : String(problem));
}
