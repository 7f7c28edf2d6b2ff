// What the call or the program would do: alarms, changes, decisions, results.

import { html, nothing, render, type TemplateResult } from "lit-html";
import { guard } from "lit-html/directives/guard.js";
import type { Actions } from "../desk/actions";
import { lineIn } from "../desk/beside";
import type { Derived } from "../desk/derive";
import { el } from "../dom";
import { guidePart } from "../guide";
import { fixed, plain, signed } from "../numbers";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { listed, say, t } from "../texts";
import type { FileStart, OfCall, Outcome, WrittenFile } from "../wire";
import { createGiven, type Lacks } from "./given";
import { missing } from "./missing";
import { offersOf, problem } from "./problem";
import { openScreen, type ShownScreen, screens } from "./screen";
import { createWhole, type WholeWays } from "./whole";

// earlier: not written by this call
/** A call, and the file beside the program in which it stands. */
type OfPlace = OfCall & { file?: string };
type ShownResult = { name: string; label: string; value: number; unit: string; earlier?: number } & OfPlace;
export interface Shown {
  results: ShownResult[];
  /** How many more there are, which are not shown. */
  more: number;
  changes: Outcome["changes"];
  alarms: (Outcome["alarms"][number] & OfPlace)[];
  decisions: ({ message: Outcome["decisions"][number] } & OfPlace)[];
  log: string[];
  written?: WrittenFile[];
}

const ROWS = 1000; // of results, decisions and alarms; a program may have thousands of calls

function unitText(unit: string): string {
  return unit ? t(`unit-${unit.replace("/", "-per-")}`) : "";
}

/** An inch is long: one decimal more. */
const decimals = (unit: string): number => (unit === "inch" ? 5 : 4);

/** What has no unit is a number of something: as many decimals as it needs. */
function figure(value: number, unit: string): string {
  return unit ? fixed(value, decimals(unit)) : plain(value);
}

/** "CYCLE977, line 12"; empty for what belongs to no call of a program. */
function callText({ cycle, line, file }: OfPlace): string {
  const text = cycle !== undefined && line !== undefined ? t("of-call", { cycle, line }) : "";
  return text && file !== undefined ? t("beside-place", { file, place: text }) : text;
}

/** The call by the line of its file. */
function placed<T extends OfCall>(files: readonly FileStart[] | undefined, one: T): T & OfPlace {
  return one.line === undefined ? one : { ...one, ...lineIn(files, one.line) };
}

/** Of the form's call, or of the whole program while that is shown. */
export function shownOutcome(state: State, derived: Derived): Shown | null {
  const run = derived.run;
  if (state.view.source === "program") {
    if (!run) return null;
    const { files } = run;
    const results = run.results.slice(0, ROWS).map(one => ({
      ...placed(files, one),
      label: one.label ? say(one.label) : "",
      unit: one.unit ?? "",
    }));
    const alarms = run.alarms.map(one => placed(files, one));
    const more = run.results.length - results.length;
    return { ...run, results, more, alarms, decisions: run.decisions.map(one => placed(files, one)) };
  }
  const outcome = derived.view.outcome;
  return outcome
    ? {
        ...outcome,
        decisions: outcome.decisions.map(message => ({ message })),
        results: outcome.results.map(one => ({ ...one, label: say(one.label) })),
        more: 0,
      }
    : null;
}

/** What is shown; the same object as long as it is made of the same. */
function keptOutcome(): (state: State, derived: Derived) => Shown | null {
  let made: { of: unknown[]; shown: Shown | null } | null = null;
  return (state, derived) => {
    const of = [state.view.source === "program", derived.run, derived.cycle, derived.view.outcome];
    if (!made?.of.every((one, index) => one === of[index])) made = { of, shown: shownOutcome(state, derived) };
    return made.shown;
  };
}

/** With which of the values that differ by the way the outcome was worked out. */
function assumptions({ assumed }: Derived): string {
  const values = Object.entries(assumed).map(([name, { value, line }]) =>
    t("outcome-assumed-value", { name, value, line }),
  );
  return values.length ? t("outcome-assumed", { values: listed(values) }) : "";
}

function absent(state: State, derived: Derived): string {
  return state.view.source === "program" && derived.simulates === "yes" ? t("outcome-running") : missing(derived);
}

function table(kind: string, caption: string, heads: string[], rows: TemplateResult[]): TemplateResult {
  return html`<table class=${kind} ?hidden=${rows.length === 0}>
    <caption>${caption}</caption>
    <thead><tr>${heads.map(head => html`<th scope="col">${head}</th>`)}</tr></thead>
    <tbody>${rows}</tbody>
  </table>`;
}

/** What is changed, in words with the variable below; before, after, difference, unit. */
function changeRow({ name, label, before, after, unit }: Outcome["changes"][number]): TemplateResult {
  return html`<tr>
    <th scope="row"><span class="change-label">${say(label)}</span><code>${name}</code></th>
    <td>${figure(before, unit)}</td>
    <td>${figure(after, unit)}</td>
    <td>${signed(after - before, decimals(unit))}</td>
    <td>${unitText(unit)}</td>
  </tr>`;
}

function resultRow({ name, label, value, unit, earlier }: ShownResult): TemplateResult {
  return html`<tr class=${earlier === undefined ? "" : "earlier"}>
    <th scope="row">${name}</th>
    <td>${earlier === undefined ? label : `${label} · ${t("outcome-earlier")}`}</td>
    <td>${figure(value, unit)}</td>
    <td>${unitText(unit)}</td>
  </tr>`;
}

const groupRow = (title: string): TemplateResult =>
  html`<tr class="of-call"><th scope="colgroup" colspan="4">${title}</th></tr>`;

/** The results of a program under the calls that left them; those of the form's call by themselves. */
function byCall(results: ShownResult[]): (ShownResult | string)[] {
  const some = results.some(one => one.line !== undefined);
  return results.flatMap((one, index) => {
    const first =
      some && (index === 0 || results[index - 1]?.line !== one.line || results[index - 1]?.file !== one.file);
    return first ? [callText(one) || t("of-program"), one] : [one];
  });
}

const decided = (one: Shown["decisions"][number]): string =>
  [callText(one), say(one.message)].filter(Boolean).join(": ");

function body({ alarms, changes, decisions, results, more }: Shown, give: Actions["give"]): TemplateResult {
  const rows = byCall(results);
  const unseen = more + rows.slice(ROWS).filter(one => typeof one !== "string").length;
  const last = decisions.length - 1;
  return html`<ul class="alarms" aria-label=${t("outcome-alarms")} ?hidden=${alarms.length === 0}>
      ${alarms.slice(0, ROWS).map(one =>
        problem(
          { ...one, severity: one.stops ? "error" : "note" },
          html`<span class="of-call">${callText(one)}</span
            ><span class="problem-actions">${offersOf(one, give)}</span>`,
        ),
      )}
    </ul>
    <p class="empty" ?hidden=${alarms.length <= ROWS}>${t("outcome-more", { count: alarms.length - ROWS })}</p>
    <div class="outcome">
      ${table(
        "changes",
        t("outcome-changes"),
        [t("column-what"), t("column-before"), t("column-after"), t("column-difference"), t("column-unit")],
        changes.map(changeRow),
      )}
      <p class="empty" ?hidden=${changes.length > 0}>${t("outcome-no-changes")}</p>
      <section class="decision-box" ?hidden=${decisions.length === 0}>
        <h3>${t("outcome-decisions")}</h3>
        <ol class="decisions">
          ${decisions
            .slice(0, ROWS)
            .map((one, index) => html`<li class=${index === last ? "taken" : ""}>${decided(one)}</li>`)}
        </ol>
        <p class="empty" ?hidden=${decisions.length <= ROWS}
          >${t("outcome-more", { count: decisions.length - ROWS })}</p
        >
      </section>
      ${table(
        "results",
        t("outcome-results"),
        [t("column-name"), t("column-meaning"), t("column-value"), t("column-unit")],
        rows.slice(0, ROWS).map(one => (typeof one === "string" ? groupRow(one) : resultRow(one))),
      )}
      <p class="empty" ?hidden=${unseen === 0}>${t("results-more", { count: unseen })}</p>
    </div>`;
}

/** The measuring result screens of the run, each a button that opens it. */
function screenList(
  shown: ShownScreen[],
  files: readonly FileStart[] | undefined,
  open: (one: ShownScreen) => void,
): TemplateResult {
  const name = ({ screen: { cycle, measures }, line }: ShownScreen): string =>
    [callText(placed(files, { cycle, line })) || cycle, say(measures)].join(" · ");
  return html`<section class="screen-list" ?hidden=${shown.length === 0}>
    <h3>${t("outcome-screens", { count: shown.length })} ${guidePart("screens")}</h3>
    <ul>
      ${shown
        .slice(0, ROWS)
        .map(one => html`<li><button type="button" @click=${() => open(one)}>${name(one)}</button></li>`)}
    </ul>
    <p class="empty" ?hidden=${shown.length <= ROWS}>${t("outcome-more", { count: shown.length - ROWS })}</p>
  </section>`;
}

export function createOutcome(
  page: HTMLElement,
  store: Store,
  actions: Actions,
  goToLine: (line: number) => void,
  lacks: Lacks,
  ways: WholeWays,
): (state: State, derived: Derived) => void {
  const whole = createWhole(store, actions, goToLine, ways);
  const root = el("div");
  const [before, behind] = [el("div"), el("div", { class: "lacks" })];
  page.append(before, whole.root, root, behind);
  const given = createGiven(before, behind, actions, lacks);
  const shownNow = keptOutcome();
  return (state, derived) => {
    given(state, derived);
    whole.draw(state, derived);
    const outcome = shownNow(state, derived);
    const counted = outcome && !derived.run ? assumptions(derived) : "";
    const ending = outcome && derived.run ? say(derived.run.ending) : "";
    // each step that is played comes by here, and a long run has a thousand lines
    const all = guard([outcome], () => (outcome ? body(outcome, actions.give) : nothing));
    const seen = guard([outcome], () =>
      screenList(screens(state, derived), derived.run?.files, one => openScreen(store, actions, one.screen)),
    );
    render(
      html`<p class="empty" ?hidden=${!!outcome}>${outcome ? "" : absent(state, derived)}</p>
        <p class="assumed" role="note" ?hidden=${!counted}>${counted}</p>
        ${seen}${all}
        <p class="ended" role="note" ?hidden=${!ending}>${ending}</p>`,
      root,
    );
  };
}
