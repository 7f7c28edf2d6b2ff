// Sheets for the workshop: a page a call with its picture, the 3D view, the call and its values; and for a program all
// of them behind a table of what they came to. Made when they are printed, and taken away again.

import type { Formed } from "../core/core";
import type { ProgramCore } from "../core/program";
import type { SceneData } from "../core/scene";
import { type Derived, findCycle } from "../desk/derive";
import { titleOf } from "../desk/variants";
import { el } from "../dom";
import type { Still } from "../preview/still";
import { programMachine, type State } from "../state/state";
import { say, t } from "../texts";
import type { Answer, CallView, CycleInfo, Field, FormView } from "../wire";
import { correctedText, figureText, mainFigures } from "./amounts";
import { inOneLine, piecesOf } from "./code";
import { createPicture } from "./picture";
import type { RecordShown } from "./record";
import { recordSheet } from "./record-sheet";
import { heading } from "./sheet";
import type { Stage } from "./stage";

export type Paper = "sheet" | "report" | "record";
type Draw = typeof import("../preview/still");

const MOST = 200; // calls in a report
const VIEW = { width: 440, height: 300 }; // CSS pixels
const PICTURE = { width: 220, height: 300 };
const DEVICES = ["webgpu", "webgl2"] as const; // the best first

/** A call as it is printed. */
interface Printed {
  cycle: CycleInfo;
  view: FormView;
  scene: SceneData | null;
  line: number | null;
}

/** As the control takes it, with its unit and what a code stands for. */
function valueText(field: Field): string {
  const text = field.value.trim() || String(field.fallback ?? "");
  const unit = field.unit ? `\u00a0${t(`unit-${field.unit.replace("/", "-per-")}`)}` : "";
  const choices = field.kind === "choice" ? field.choices : [];
  const chosen = choices.find(({ value }) => String(value) === text);
  const meant = chosen ? ` (${say(chosen.label)})` : "";
  return `${field.expression ? `${field.expression} = ` : ""}${text}${unit}${meant}`;
}

function valuesOf({ fields }: FormView): HTMLElement {
  const given = fields.filter(field => field.value.trim() !== "" || field.fallback !== undefined);
  const row = (field: Field): HTMLElement =>
    el(
      "tr",
      {},
      el("th", { scope: "row" }, field.name),
      el("td", {}, say(field.label)),
      el("td", {}, valueText(field)),
    );
  const heads = ["column-name", "column-meaning", "column-value"].map(key => el("th", { scope: "col" }, t(key)));
  return el("table", {}, el("thead", {}, el("tr", {}, ...heads)), el("tbody", {}, ...given.map(row)));
}

function resultOf(answer: Answer): HTMLElement {
  const figures = mainFigures(answer).map(figureText).join("  ") || say(answer.feature);
  const text = [figures, correctedText(answer), say(answer.verdict_words)].filter(Boolean).join(" · ");
  return el("p", { class: "paper-result" }, el("strong", {}, text), " ", say(answer.why));
}

/** `fine`: the 3D view, where it is drawn already. */
function pictures({ view, scene }: Printed, { drawStill }: Draw, fine: HTMLElement | null): HTMLElement {
  const row = el("div", { class: "paper-pictures" });
  if (view.picture?.shapes.length) {
    const box = el("div", { class: "paper-picture" });
    const values = Object.fromEntries(view.fields.map(field => [field.name, field.value]));
    createPicture(box, () => undefined, PICTURE)(view.picture, null, values);
    row.append(box);
  }
  const still = stillOf({ view, scene });
  if (fine) row.append(fine);
  else if (still) {
    const box = el("div", { class: "paper-stage" });
    drawStill(box, still, VIEW);
    row.append(box);
  }
  return row;
}

function stillOf({ view, scene }: Pick<Printed, "view" | "scene">): Still | null {
  const entries = view.outcome?.trace.entries.length ?? 0;
  return scene && entries ? { data: scene, step: entries - 1, cloud: null, drawing: false, camera: null, say } : null;
}

/** The 3D view as the stage draws it, or would where it was never in sight; none where no device can do so now. */
async function fineOf(printed: Printed, { drawFine }: Draw, stage: Stage): Promise<HTMLElement | null> {
  const still = stillOf(printed);
  if (!still) return null;
  for (const way of stage.preview ? [stage.preview.backend] : DEVICES) {
    if (way === "svg") break;
    const box = el("div", { class: "paper-stage" });
    try {
      await drawFine(box, still, VIEW, way);
      return box;
    } catch (problem) {
      console.warn(problem);
    }
  }
  return null;
}

const callText = (snippet: string, { control }: CycleInfo): string =>
  inOneLine(piecesOf(snippet, {}), control)
    .map(({ text }) => text)
    .join("");

function sheetOf(printed: Printed, head: HTMLElement, draw: Draw, fine: HTMLElement | null): HTMLElement {
  const { cycle, view, line } = printed;
  const variant = cycle.variants.find(one => one.mvar === view.mvar);
  const code = variant && cycle.numbered ? `${cycle.cycle} · ${variant.mvar}` : cycle.cycle;
  const place = line === null ? "" : ` · ${t("paper-line", { line })}`;
  return el(
    "section",
    { class: "paper-sheet" },
    head,
    el("h2", {}, titleOf(cycle, view), " ", el("small", {}, `${code}${place}`)),
    pictures(printed, draw, fine),
    !!view.outcome?.answer && resultOf(view.outcome.answer),
    view.snippet !== "" && el("pre", {}, callText(view.snippet, cycle)),
    valuesOf(view),
  );
}

function tableOf(all: readonly Printed[], head: HTMLElement, more: number): HTMLElement {
  const cells = ({ view, cycle, line }: Printed, index: number): string[] => {
    const answer = view.outcome?.answer;
    const main = answer ? mainFigures(answer) : [];
    return [
      String(index + 1),
      answer ? say(answer.feature) : cycle.cycle,
      line === null ? "" : String(line),
      main.map(figureText).join("  ") || "–",
      answer ? say(answer.verdict_words) : "–",
      (answer && correctedText(answer)) || t("bar-nothing"),
    ];
  };
  const heads = ["number", "feature", "line", "actual", "verdict", "corrects"].map(one =>
    el("th", { scope: "col" }, t(`whole-${one}`)),
  );
  const rows = all.map((one, index) => el("tr", {}, ...cells(one, index).map(text => el("td", {}, text))));
  return el(
    "section",
    { class: "paper-table" },
    head,
    el("h2", {}, t("paper-report")),
    el("table", {}, el("thead", {}, el("tr", {}, ...heads)), el("tbody", {}, ...rows)),
    more > 0 && el("p", {}, t("paper-more", { more })),
  );
}

/** A call of the program as the form would show it. */
function printedCall(core: ProgramCore, state: State, { catalogue }: Derived, call: CallView): Printed | null {
  const cycle = findCycle(catalogue, call.control, call.cycle);
  if (!cycle) return null;
  const { scene, ...view } = core.form({
    control: call.control,
    cycle: call.cycle,
    values: call.values,
    expressions: call.expressions,
    plane: call.plane,
    units: call.units,
    transverse: call.transverse,
    written: call.style,
    errors: state.part.errors,
    predict: true,
    ...programMachine(state),
  });
  return { cycle, view, scene: scene?.(1) ?? null, line: call.lastLine };
}

function inForm({ cycle, view, opened }: Derived): Printed {
  const { scene, ...form } = view as Formed;
  return { cycle, view: form, scene: scene?.(1) ?? null, line: opened?.lastLine ?? null };
}

/**
 * Prints a sheet of the call in the form, the record of a run, or the report of the program: without a graphics card
 * the stage would draw hundreds of pictures for minutes, so those are simple ones.
 */
export function createPaper(
  core: () => ProgramCore | null,
  shown: () => { state: State; derived: Derived } | null,
  stage: Stage,
  end: AbortSignal,
): (paper: Paper, shown?: RecordShown) => Promise<void> {
  const root = document.documentElement;
  const clear = (): void => {
    for (const one of document.querySelectorAll(".paper")) one.remove();
    delete root.dataset.paper;
  };
  addEventListener("afterprint", clear, { signal: end });
  return async (paper, record) => {
    const draw = await import("../preview/still");
    const here = shown();
    const all = core();
    if (!here || !all) return;
    const { state, derived } = here;
    if (paper === "record") {
      const measured = record ?? derived.run;
      if (!measured) return;
      clear();
      document.body.append(el("div", { class: "paper" }, recordSheet(state, derived, measured, draw)));
      root.dataset.paper = paper;
      return print();
    }
    const head = (): HTMLElement => heading(state, derived);
    const { calls } = derived.read;
    const printed =
      paper === "sheet"
        ? [inForm(derived)]
        : calls.slice(0, MOST).flatMap(call => printedCall(all, state, derived, call) ?? []);
    const [first] = printed;
    const fine = paper === "sheet" && first ? await fineOf(first, draw, stage) : null;
    clear();
    const table = paper === "report" ? [tableOf(printed, head(), calls.length - printed.length)] : [];
    document.body.append(
      el("div", { class: "paper" }, ...table, ...printed.map(one => sheetOf(one, head(), draw, fine))),
    );
    root.dataset.paper = paper;
    print();
  };
}
