// The measuring result screen over the stage, as the control shows it while the run is at its step; NC START goes on.

import { html, nothing, render } from "lit-html";
import type { Derived } from "../desk/derive";
import { el, on, setAttribute, show } from "../dom";
import { plain } from "../numbers";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { say, t } from "../texts";
import type { Answer } from "../wire";
import { amount, unitBehind } from "./amounts";

type Screen = NonNullable<Answer["screen"]>;

/** The screens of what is shown, with the step from which each is gone. */
function screens(state: State, { run, view }: Derived): { screen: Screen; gone: number }[] {
  const answers = state.view.source === "program" ? (run?.answers ?? []) : [];
  const own = state.view.source === "form" ? view.outcome?.answer?.screen : undefined;
  if (own) return [{ screen: own, gone: own.until === "next" ? Number.POSITIVE_INFINITY : own.at + 1 }];
  return answers.flatMap(({ screen }, index) => {
    if (!screen) return [];
    const next = answers[index + 1]?.from ?? Number.POSITIVE_INFINITY;
    return [{ screen, gone: screen.until === "next" ? next : screen.at + 1 }];
  });
}

/** The next step behind this one at which the control waits for NC START. */
export function haltAfter(state: State, derived: Derived, step: number): number {
  const waits = screens(state, derived).filter(({ screen }) => screen.until === "start" && screen.at > step);
  return Math.min(...waits.map(({ screen }) => screen.at));
}

const figure = (value: number | null, unit: string) =>
  html`<td class="figure">${value === null ? "" : unit ? amount(value, unit) + unitBehind(unit) : plain(value)}</td>`;

function body(screen: Screen) {
  const { title, cycle, variant, measures, rows, values } = screen;
  return html`<h3>${say(title)}</h3>
    <p>${`${cycle} · ${variant} · ${say(measures)}`}</p>
    <table ?hidden=${rows.length === 0}>
      <thead>
        <tr>
          <th></th>
          ${["set", "actual", "difference"].map(key => html`<th scope="col">${t(`screen-${key}`)}</th>`)}
        </tr>
      </thead>
      <tbody>
        ${rows.map(
          ({ label, set, actual, difference, unit }) =>
            html`<tr>
              <th scope="row">${say(label)}</th>
              ${[set, actual, difference].map(value => figure(value, unit))}
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
              ${figure(value, unit)}
            </tr>`,
        )}
      </tbody>
    </table>
    <p role="status">${t(`screen-until-${screen.until}`)}</p>`;
}

export function createScreen(store: Store): { root: HTMLElement; draw(state: State, derived: Derived): void } {
  const shown = el("div", {});
  const start = el("button", { type: "button", class: "primary" }, t("screen-start"));
  const halts = el("input", { type: "checkbox", id: "screen-halts" });
  const doing = el(
    "div",
    { class: "actions" },
    start,
    el("label", { class: "check", for: "screen-halts" }, halts, t("screen-halt")),
  );
  const root = el("section", { class: "result-screen", "aria-label": t("screen-open"), hidden: true }, shown, doing);
  on(start, "click", () => store.update(({ view }) => ({ view: { step: view.step + 1, playing: true } })));
  on(halts, "change", () => store.update({ view: { halts: halts.checked } }));
  return {
    root,
    draw(state, derived) {
      const { step } = derived;
      const now = screens(state, derived).findLast(({ screen, gone }) => screen.at <= step && step < gone)?.screen;
      show(root, !!now);
      show(doing, now?.until === "start");
      setAttribute(root, "data-until", now?.until ?? null);
      if (halts.checked !== state.view.halts) halts.checked = state.view.halts;
      render(now ? body(now) : nothing, shown);
    },
  };
}
