// What only paper shows: the file, the machine and the date above everything, the 3D view as a picture that stays, and
// the whole program, of which the editor holds the lines in sight alone. Made when somebody prints, and taken away
// again.

import type { Derived } from "../desk/derive";
import { el } from "../dom";
import { linesOf } from "../eol";
import { fileOf } from "../state/files";
import type { State } from "../state/state";
import { language, say, t } from "../texts";
import { facts } from "./header";
import { createLegend } from "./legend";
import { cloudOf, thinned } from "./scene";
import type { Stage } from "./stage";

const MOST_LINES = 2000; // some thirty sheets
const SIZE = { width: 680, height: 340 }; // of the view, CSS pixels: as wide as a sheet between its margins
const DOTS = 4096; // scanned points on paper
const PATIENCE = 1000; // ms until the drawing is fetched, idle or not

type Draw = typeof import("../preview/still");

/** With the customs of the reader's country where it is one of the language. */
export function now(): string {
  const customs = navigator.language.startsWith(language()) ? navigator.language : language();
  return new Date().toLocaleString(customs, { dateStyle: "long", timeStyle: "short" });
}

/** File, machine and date above a sheet. */
export function heading(state: State, derived: Derived): HTMLElement {
  const machine = facts(derived.cycle.control, derived.view)
    .map(({ text }) => text)
    .join(" · ");
  return el(
    "header",
    { class: "sheet sheet-head" },
    el("strong", {}, fileOf(state).name),
    el("span", {}, machine),
    el("span", {}, `${t("app-name")} · ${now()}`),
  );
}

function view(stage: Stage, state: State, derived: Derived, { drawStill }: Draw): HTMLElement | null {
  const scan =
    state.view.source === "scan" && state.scan.made?.request.cycle === derived.cycle.cycle ? state.scan.made : null;
  const { trace, scene, step } = derived;
  if (!trace || !scene || !(trace.steps.length || scan)) return null;
  const picture = el("div", { class: "sheet-picture" });
  const colours = drawStill(
    picture,
    {
      data: scene(1),
      step,
      cloud: scan && cloudOf(scan),
      drawing: state.view.diameters,
      camera: stage.preview?.camera ?? null,
      say,
    },
    SIZE,
  );
  const legend = createLegend();
  legend.draw(trace, colours, scan && thinned(Math.min(DOTS, scan.view.points), scan));
  return el("section", { class: "sheet sheet-view" }, el("h2", {}, t("view-title")), picture, legend.root);
}

function program(text: string): HTMLElement {
  const lines = linesOf(text);
  if (lines.at(-1) === "") lines.pop();
  const more = lines.length - MOST_LINES;
  return el(
    "section",
    { class: "sheet sheet-program" },
    el("h2", {}, t("program-title")),
    el("ol", {}, ...lines.slice(0, MOST_LINES).map(line => el("li", {}, line))),
    more > 0 && el("p", {}, t("print-lines", { more, all: lines.length })),
  );
}

/** `shown`: what the page shows now. The drawing is fetched once the page has nothing else to do, or soon. */
export function createSheet(
  stage: Stage,
  shown: () => { state: State; derived: Derived } | null,
  end: AbortSignal,
): void {
  let draw: Draw | null = null;
  let made: HTMLElement[] = [];
  const clear = (): void => {
    for (const part of made) part.remove();
    made = [];
  };
  const bring = (): void =>
    void import("../preview/still").then(module => {
      draw = module;
    }, console.warn);
  const idle = globalThis.requestIdleCallback ?? ((run: () => void) => setTimeout(run)); // not in every browser
  idle(bring, { timeout: PATIENCE }); // a machine that draws by its processor is never idle
  addEventListener(
    "beforeprint",
    () => {
      clear();
      const here = shown();
      // an open dialog is printed alone
      if (!here || document.documentElement.dataset.paper || document.querySelector("dialog:modal")) return;
      const { state, derived } = here;
      const head = heading(state, derived);
      const picture = draw && view(stage, state, derived, draw);
      const text = program(derived.program);
      made = [head, ...(picture ? [picture] : []), text];
      document.body.prepend(head);
      document.body.append(...made.slice(1));
    },
    { signal: end },
  );
  addEventListener("afterprint", clear, { signal: end });
}
