// The measuring result screen over the stage, as the control shows it while the run is at its step; NC START goes on.

import { html, nothing, render } from "lit-html";
import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { el, on, show } from "../dom";
import { guideButton } from "../guide";
import { fixed, plain } from "../numbers";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { say, t } from "../texts";
import type { Answer } from "../wire";
import { unitBehind } from "./amounts";

type Screen = NonNullable<Answer["screen"]>;
/** With the step from which it is gone, and the line of its call in the program. */
export interface ShownScreen {
  screen: Screen;
  gone: number;
  line?: number | undefined;
}

/** The screens of what is shown, in the order of the run. */
export function screens(state: State, { run, view }: Derived): ShownScreen[] {
  const own = state.view.source === "form" ? view.outcome?.answer?.screen : undefined;
  if (own) return [{ screen: own, gone: own.until === "next" ? Number.POSITIVE_INFINITY : own.at + 1 }];
  if (state.view.source !== "program" || !run) return [];
  return run.answers.flatMap(({ screen, line }, index) => {
    if (!screen) return [];
    const next = run.answers[index + 1]?.from ?? Number.POSITIVE_INFINITY;
    return [{ screen, gone: screen.until === "next" ? next : screen.at + 1, line }];
  });
}

/** Where a program waits for NC START without a result screen: M0, a text that halts. */
const waits = (state: State, { run }: Derived) => (state.view.source === "program" ? (run?.waits ?? []) : []);

/** The next step behind this one at which the control waits for NC START. */
export function haltAfter(state: State, derived: Derived, step: number): number {
  const shown = screens(state, derived).find(({ screen }) => screen.until === "start" && screen.at > step);
  const next = waits(state, derived).find(({ at }) => at > step);
  return Math.min(shown?.screen.at ?? Number.POSITIVE_INFINITY, next?.at ?? Number.POSITIVE_INFINITY);
}

/** Figures with the unit of all of them behind the last; the control says how many decimals they have. */
const figures = (values: (number | null)[], unit: string, digits: number) =>
  html`${values.map(
    value => html`<td class="figure">${value === null ? "" : unit ? fixed(value, digits) : plain(value)}</td>`,
  )}
    <td class="unit">${unitBehind(unit).trim()}</td>`;

function body(screen: Screen) {
  const { title, cycle, variant, measures, rows, values, digits } = screen;
  return html`<h3>${say(title)}</h3>
    <p>${`${cycle} · ${variant} · ${say(measures)}`}</p>
    <div class="screen-tables">
      <table ?hidden=${rows.length === 0}>
        <thead>
          <tr>
            <th></th>
            ${["set", "actual", "difference"].map(key => html`<th scope="col">${t(`screen-${key}`)}</th>`)}
            <th></th>
          </tr>
        </thead>
        <tbody>
          ${rows.map(
            ({ label, set, actual, difference, unit }) =>
              html`<tr>
                <th scope="row">${say(label)}</th>
                ${figures([set, actual, difference], unit, digits)}
              </tr>`,
          )}
        </tbody>
      </table>
      <table>
        <tbody>
          ${values.map(
            ({ label, value, unit }) =>
              html`<tr>
                <th scope="row">${say(label)}</th>
                ${figures([value], unit, digits)}
              </tr>`,
          )}
        </tbody>
      </table>
    </div>
    <p role="status">${t(`screen-until-${screen.until}`)}</p>`;
}

/** The text over a program that waits. */
const halted = (text: string) => html`<h3>${text}</h3>
  <p role="status">${t("screen-waits")}</p>`;

/** The run at this screen, with the focus on it. */
export function openScreen(store: Store, actions: Pick<Actions, "panel">, { at }: Screen): void {
  store.update({ view: { step: at, playing: false } });
  actions.panel("view");
  document.querySelector<HTMLElement>(".result-screen")?.focus();
}

/** `leave`: where the focus goes on once the screen has gone. */
export function createScreen(
  store: Store,
  leave: () => void,
): { root: HTMLElement; draw(state: State, derived: Derived): void } {
  const shown = el("div", {});
  const start = el("button", { type: "button", class: "primary" }, t("screen-start"));
  const halts = el("input", { type: "checkbox", id: "screen-halts" });
  const doing = el(
    "div",
    { class: "actions" },
    start,
    el("label", { class: "check", for: "screen-halts" }, halts, t("screen-halt")),
    guideButton("screens"),
  );
  const named = { class: "result-screen", tabindex: "0", role: "region", "aria-label": t("screen-open"), hidden: true };
  const root = el("section", named, shown, doing);
  on(start, "click", () => {
    leave();
    store.update({ view: { step: now + 1, playing: true } });
  });
  on(halts, "change", () => store.update({ view: { halts: halts.checked } }));
  let now = 0; // the step that is shown; that of the state may lie behind the last
  return {
    root,
    draw(state, derived) {
      const { step } = derived;
      now = step;
      const seen = screens(state, derived).findLast(({ screen, gone }) => screen.at <= step && step < gone)?.screen;
      const wait = waits(state, derived).find(({ at }) => at === step);
      const waiting = seen?.until === "start" || !!wait;
      const comes = waiting && doing.hidden;
      show(root, !!seen || !!wait);
      show(doing, waiting);
      if (halts.checked !== state.view.halts) halts.checked = state.view.halts;
      render(wait ? halted(wait.text) : seen ? body(seen) : nothing, shown);
      if (comes) start.scrollIntoView({ block: "nearest" }); // on a phone the stage may lie below the page's edge
    },
  };
}
