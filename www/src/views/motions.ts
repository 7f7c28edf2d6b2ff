// The steps of the motions that are shown, and the one at which the probe stands.

import { html, render } from "lit-html";
import { type Course, NO_STEPS, type Shown, type Steps } from "../core/steps";
import type { Derived } from "../desk/derive";
import { setAttribute } from "../dom";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import type { CycleInfo, FileStart } from "../wire";
import { lineText } from "./given";
import { describe } from "./steps";

const BLOCK = 1000; // motions listed at once: those around the step

function stepLine(entry: Shown, index: number, cycles: CycleInfo[], files: FileStart[]): string {
  const line = entry.line ? ` · ${lineText(files, entry.line)}` : "";
  return `${index + 1}  ${describe(entry, cycles)}${line}`;
}

export function createMotions(root: HTMLElement, store: Store): (state: State, derived: Derived) => void {
  let drawn: Course | null | undefined;
  let first = 0;
  const item = (entry: Shown, index: number, cycles: CycleInfo[], files: FileStart[]) =>
    html`<li
      data-step=${index}
      data-kind=${entry.step === "motion" ? entry.kind : entry.step}
      @click=${() => store.update({ view: { step: index, playing: false } })}
    ><button type="button" class="motion">${stepLine(entry, index, cycles, files)}</button></li>`;
  const list = (steps: Steps, from: number, cycles: CycleInfo[], files: FileStart[]) => {
    const to = Math.min(steps.length, from + BLOCK);
    const block = Array.from({ length: to - from }, (_, i) => steps.at(from + i)).filter(entry => entry !== undefined);
    const shown = { from: from + 1, to, count: steps.length };
    return html`<p class="empty" ?hidden=${steps.length > 0}>${t("motions-none")}</p>
      <p class="empty" ?hidden=${steps.length <= BLOCK}>${t("motions-block", shown)}</p>
      <ol class="motions" tabindex="-1" start=${from + 1}>
        ${block.map((entry, index) => item(entry, from + index, cycles, files))}
      </ol>`;
  };
  /** As a step is played one line changes, and not a thousand are drawn. */
  const mark = (current: Element | undefined): void => {
    for (const node of root.querySelectorAll('[aria-current="step"]'))
      if (node !== current) node.removeAttribute("aria-current");
    if (!current || current.hasAttribute("aria-current")) return;
    setAttribute(current, "aria-current", "step");
    current.scrollIntoView({ block: "nearest" });
  };
  return (state, { trace, step, catalogue, files }) => {
    if (state.panels.tab !== "motions") return;
    const from = Math.floor(step / BLOCK) * BLOCK;
    if (trace !== drawn || from !== first) render(list(trace?.steps ?? NO_STEPS, from, catalogue.cycles, files), root);
    [drawn, first] = [trace, from];
    mark(root.querySelector("ol")?.children[step - from]);
  };
}
