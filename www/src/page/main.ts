import "../styles/main.css";
import address from "@pkg/core/core_bg.wasm?url";
import { compile } from "../core/module";
import { speak } from "../language";
import { load } from "../state/keep";
import { firstState } from "../state/state";
import { merge } from "../state/stored";
import { showBroken } from "../views/broken";
import { startApp } from "./app";

addEventListener("probewright-panic", event => showBroken(String((event as CustomEvent).detail)));
try {
  void compile(address).catch(() => undefined); // it comes while the form is made; whoever needs it hears of a problem
  const { stored, returned } = await load();
  await speak(merge(firstState(), stored).page.language).catch(console.warn); // words that cannot be fetched: English
  await startApp(stored, returned);
} catch (problem) {
  console.error(problem);
  showBroken(problem instanceof Error ? problem.message : String(problem));
}
