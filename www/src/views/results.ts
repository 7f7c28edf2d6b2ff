// What would it do: results, decisions, changes, alarms; beside them problems, motions and the log.

import type { Actions } from "../actions";
import type { Derived } from "../derive";
import { el, keyed, on, setAttribute, setText, show } from "../dom";
import { saveFile } from "../files";
import { fixed, plain, signed } from "../numbers";
import type { Scanner } from "../scan/scanner";
import type { ResultTab, State } from "../state";
import type { Store } from "../store";
import { say, t } from "../texts";
import type { Diagnostic, OfCall, Outcome, Step, Trace } from "../wire";
import { fieldId, problemItem, updateProblem } from "./field";
import { shownProblems } from "./form";
import { createScan } from "./scan";
import { describe } from "./steps";

const TABS: ResultTab[] = ["outcome", "problems", "motions", "log", "scan"];
type Draw = (state: State, derived: Derived) => void;

function unitText(unit: string): string {
  return unit ? t(`unit-${unit.replace("/", "-per-")}`) : "";
}

/** An inch is long: one decimal more. */
const decimals = (unit: string): number => (unit === "inch" ? 5 : 4);

/** What has no unit is a number of something: as many decimals as it needs. */
function figure(value: number, unit: string): string {
  return unit ? fixed(value, decimals(unit)) : plain(value);
}

function table(caption: string, heads: string[], body: HTMLElement): HTMLTableElement {
  return el(
    "table",
    {},
    el("caption", {}, caption),
    el("thead", {}, el("tr", {}, ...heads.map(head => el("th", { scope: "col" }, head)))),
    body,
  );
}

const row = (cells: number) => (): HTMLTableRowElement =>
  el("tr", {}, el("th", { scope: "row" }), ...Array.from({ length: cells }, () => el("td", {})));

function fill(node: HTMLElement, texts: string[]): void {
  texts.forEach((text, index) => {
    const cell = node.children[index];
    if (cell) setText(cell, text);
  });
}

/** What is changed, in words with the variable below; before, after, difference, unit. */
function changeRow(): HTMLTableRowElement {
  const name = el("th", { scope: "row" }, el("span", { class: "change-label" }), el("code", {}));
  return el("tr", {}, name, ...Array.from({ length: 4 }, () => el("td", {})));
}

function createOutcome(root: HTMLElement): Draw {
  const alarms = el("ul", { class: "alarms", "aria-label": t("outcome-alarms") });
  const results = el("tbody", {});
  const changes = el("tbody", {});
  const decisions = el("ol", { class: "decisions" });
  const decisionBox = el("section", { class: "decision-box" }, el("h3", {}, t("outcome-decisions")), decisions);
  const resultTable = table(
    t("outcome-results"),
    [t("column-name"), t("column-meaning"), t("column-value"), t("column-unit")],
    results,
  );
  const changeTable = table(
    t("outcome-changes"),
    [t("column-what"), t("column-before"), t("column-after"), t("column-difference"), t("column-unit")],
    changes,
  );
  resultTable.className = "results";
  changeTable.className = "changes";
  const none = el("p", { class: "empty" });
  const more = el("p", { class: "empty" });
  const same = el("p", { class: "empty" }, t("outcome-no-changes"));
  const assumed = el("p", { class: "assumed", role: "note" });
  const ended = el("p", { class: "ended", role: "note" });
  root.append(
    none,
    assumed,
    alarms,
    el("div", { class: "outcome" }, changeTable, same, decisionBox, resultTable, more),
    ended,
  );
  const shownNow = keptOutcome();
  let drawn: Shown | null | undefined;
  return (state, derived) => {
    const outcome = shownNow(state, derived);
    show(none, !outcome);
    setText(
      none,
      outcome
        ? ""
        : state.view.source === "program" && derived.simulates === "yes"
          ? t("outcome-running")
          : missing(derived),
    );
    const counted = outcome && !derived.run ? assumptions(derived) : "";
    show(assumed, counted !== "");
    setText(assumed, counted);
    const ending = outcome && derived.run ? say(derived.run.ending) : "";
    show(ended, ending !== "");
    setText(ended, ending);
    if (outcome === drawn) return; // each step that is played comes by here, and a long run has a thousand lines
    drawn = outcome;
    show(resultTable, (outcome?.results.length ?? 0) > 0);
    show(changeTable, !!outcome && outcome.changes.length > 0);
    show(same, !!outcome && outcome.changes.length === 0);
    keyed(
      alarms,
      outcome?.alarms ?? [],
      (one, index) => `${index}/${one.code}`,
      alarmItem,
      (node, one) => {
        updateProblem(node, { ...one, severity: one.stops ? "error" : "note" });
        if (node.lastElementChild) setText(node.lastElementChild, callText(one));
      },
    );
    show(alarms, (outcome?.alarms.length ?? 0) > 0);
    const rows = byCall(outcome?.results ?? []);
    keyed(
      results,
      rows.slice(0, ROWS),
      one => ("group" in one ? `/${one.key}` : `${one.line ?? ""}/${one.name}`),
      one => ("group" in one ? groupRow() : row(3)()),
      (node, one) => {
        if ("group" in one) fill(node, [one.group]);
        else {
          fill(node, [
            one.name,
            one.earlier === undefined ? one.label : `${one.label} · ${t("outcome-earlier")}`,
            figure(one.value, one.unit),
            unitText(one.unit),
          ]);
          node.classList.toggle("earlier", one.earlier !== undefined);
        }
      },
    );
    show(more, rows.length > ROWS);
    setText(more, t("results-more", { count: rows.slice(ROWS).filter(one => !("group" in one)).length }));
    keyed(
      changes,
      outcome?.changes ?? [],
      one => one.name,
      changeRow,
      (node, one) => {
        const [name] = node.children;
        if (name?.firstElementChild) setText(name.firstElementChild, say(one.label));
        if (name?.lastElementChild) setText(name.lastElementChild, one.name);
        [
          figure(one.before, one.unit),
          figure(one.after, one.unit),
          signed(one.after - one.before, decimals(one.unit)),
          unitText(one.unit),
        ].forEach((text, index) => {
          const cell = node.children[index + 1];
          if (cell) setText(cell, text);
        });
      },
    );
    show(decisionBox, (outcome?.decisions.length ?? 0) > 0);
    keyed(
      decisions,
      outcome?.decisions ?? [],
      (_, index) => String(index),
      () => el("li", {}),
      (node, one, index) => {
        setText(node, [callText(one), say(one.message)].filter(Boolean).join(": "));
        node.classList.toggle("taken", index === (outcome?.decisions.length ?? 0) - 1);
      },
    );
  };
}

/** Which call left what the last one did not write; 0: none in this program. */

/** With which of the values that differ by the way the outcome was worked out. */
function assumptions({ assumed }: Derived): string {
  const values = Object.entries(assumed).map(([name, { value, line }]) =>
    t("outcome-assumed-value", { name, value, line }),
  );
  return values.length ? t("outcome-assumed", { values: values.join(", ") }) : "";
}

/** Why there is no outcome yet: by name, what the form still lacks. */
export function missing(derived: Derived): string {
  if (!derived.cycle.simulated) return t("outcome-not-simulated", { cycle: derived.cycle.cycle });
  if (derived.simulates === "no") return t("outcome-absent");
  if (derived.opened?.style === "operate" && derived.view.complete && !derived.view.unknown?.length)
    return t("outcome-newer");
  if (derived.simulates === "coming" && derived.view.complete) return t("outcome-coming");
  const names = [
    ...new Set(derived.view.diagnostics.filter(one => one.severity === "error" && one.param).map(one => one.param)),
  ];
  if (names.length) return t("outcome-missing", { names: names.join(", ") });
  const { unknown = [] } = derived.view;
  return unknown.length ? t("outcome-unknown", { names: unknown.join(", ") }) : t("outcome-incomplete");
}

// earlier: not written by this call
type ShownResult = { name: string; label: string; value: number; unit: string; earlier?: number } & OfCall;
interface Shown {
  results: ShownResult[];
  changes: Outcome["changes"];
  alarms: (Outcome["alarms"][number] & OfCall)[];
  decisions: ({ message: Outcome["decisions"][number] } & OfCall)[];
  log: string[];
}

const ROWS = 1000; // of results; a program may have a thousand calls

/** "CYCLE977, line 12"; empty for what belongs to no call of a program. */
function callText({ cycle, line }: OfCall): string {
  return cycle !== undefined && line !== undefined ? t("of-call", { cycle, line }) : "";
}

/** The results of a program under the calls that left them; those of the form's call by themselves. */
function byCall(results: ShownResult[]): (ShownResult | { group: string; key: string })[] {
  const some = results.some(one => one.line !== undefined);
  return results.flatMap((one, index) => {
    const first = some && (index === 0 || results[index - 1]?.line !== one.line);
    return first ? [{ group: callText(one) || t("of-program"), key: String(one.line ?? "") }, one] : [one];
  });
}

function groupRow(): HTMLTableRowElement {
  return el("tr", { class: "of-call" }, el("th", { scope: "colgroup", colspan: 4 }));
}

function alarmItem(): HTMLLIElement {
  const item = problemItem();
  item.append(el("span", { class: "of-call" }));
  return item;
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

/** Of the form's call, or of the whole program while that is shown. */
function shownOutcome(state: State, derived: Derived): Shown | null {
  const run = derived.run;
  if (state.view.source === "program") {
    if (!run) return null;
    const results = run.results.map(one => ({ ...one, label: one.label ? say(one.label) : "", unit: one.unit ?? "" }));
    return { ...run, results };
  }
  const outcome = derived.view.outcome;
  return outcome
    ? {
        ...outcome,
        decisions: outcome.decisions.map(message => ({ message })),
        results: outcome.results.map(one => ({ ...one, label: say(one.label) })),
      }
    : null;
}

const LISTED = 200; // problems; the others stand in the editor, and come here when these are mended

interface Located {
  problem: Diagnostic;
  place: string;
  go: () => void;
  cure?: () => void;
}

function createProblems(root: HTMLElement, actions: Actions, goTo: (offset: number) => void): Draw {
  const list = el("ul", { class: "problem-list" });
  const none = el("p", { class: "empty" }, t("problems-none"));
  const rest = el("p", { class: "empty" });
  root.append(none, list, rest);
  const targets = new WeakMap<Element, () => void>();
  const mend = (button: HTMLElement): void => {
    // the button goes with its finding: the focus stays in the list
    targets.get(button)?.();
    root.focus();
  };
  const make = (): HTMLLIElement => {
    const item = problemItem();
    const go = el("button", { type: "button", class: "quiet place" });
    const cure = el("button", { type: "button", class: "cure" });
    on(go, "click", () => targets.get(go)?.());
    on(cure, "click", () => mend(cure));
    item.append(el("span", { class: "problem-actions" }, go, cure));
    return item;
  };
  return (state, derived) => {
    if (state.panels.tab !== "problems") return;
    const all = located(state, derived, actions, goTo);
    show(none, all.length === 0);
    show(rest, all.length > LISTED);
    setText(rest, t("problems-more", { count: all.length - LISTED }));
    keyed(
      list,
      all.slice(0, LISTED),
      (one, index) => `${index}/${one.problem.code}`,
      make,
      (node, one) => {
        updateProblem(node, one.problem);
        const [go, cure] = (node.lastElementChild as HTMLElement).children as unknown as [HTMLElement, HTMLElement];
        setText(go, one.place);
        targets.set(go, one.go);
        show(cure, !!one.cure);
        setText(cure, one.problem.cure ? say(one.problem.cure.label) : "");
        if (one.cure) targets.set(cure, one.cure);
      },
    );
  };
}

/**
 * Of the form and of the program. What both say stands once: with the place in the form, unless only the program mends
 * it.
 */
function located(state: State, derived: Derived, actions: Actions, goTo: (offset: number) => void): Located[] {
  const same = (one: Diagnostic): string => `${one.code}/${one.param}`;
  const opened = derived.opened;
  const ofOpened = (one: Diagnostic): boolean =>
    !!opened && (one.line ?? 0) >= opened.line && (one.line ?? 0) <= opened.lastLine;
  const told = new Set(derived.problems.filter(one => one.cure && ofOpened(one)).map(same));
  const form = shownProblems(state, derived.view.diagnostics).filter(one => !told.has(same(one)));
  const inForm = new Set(opened ? form.map(same) : []);
  const cured = (problem: Diagnostic): Partial<Located> =>
    problem.cure && derived.fresh ? { cure: () => actions.cure(problem.cure?.edits ?? [], problem.elsewhere) } : {};
  const place = (problem: Diagnostic): Located => ({
    problem,
    place: t("problem-place", { line: problem.line ?? 0, column: problem.column ?? 1 }),
    go: () => goTo(problem.from ?? 0),
  });
  return [
    ...form.map(
      (problem): Located => ({
        problem,
        place: problem.param ?? t("panel-form"),
        go: () => {
          actions.panel("form");
          document.getElementById(fieldId(problem.param ?? ""))?.focus();
        },
      }),
    ),
    ...derived.problems
      .filter(one => !inForm.has(same(one)) || !ofOpened(one))
      .map(problem => ({ ...place(problem), ...cured(problem) })),
    ...(derived.run?.diagnostics ?? [])
      .filter(one => !derived.problems.some(known => known.code === one.code && known.from === one.from))
      .map(place),
  ];
}

const BLOCK = 1000; // motions listed at once: those around the step

function createMotions(root: HTMLElement, store: Store): Draw {
  const list = el("ol", { class: "motions", tabindex: "-1" });
  const none = el("p", { class: "empty" }, t("motions-none"));
  const rest = el("p", { class: "empty" });
  root.append(none, rest, list);
  let drawn: Trace | null = null;
  let first = 0;
  const make = (): HTMLLIElement => {
    const item = el("li", {}, el("button", { type: "button", class: "motion" }));
    on(item, "click", () => store.update({ view: { step: Number(item.dataset.step), playing: false } }));
    return item;
  };
  return (state, derived) => {
    if (state.panels.tab !== "motions") return;
    const { trace, step } = derived;
    const from = Math.floor(step / BLOCK) * BLOCK;
    show(none, !trace?.entries.length);
    if (trace !== drawn || from !== first) {
      drawn = trace;
      first = from;
      setAttribute(list, "start", from + 1);
      keyed(
        list,
        trace?.entries.slice(from, from + BLOCK) ?? [],
        (_, index) => String(index),
        make,
        (node, entry, index) => {
          node.dataset.step = String(from + index);
          setAttribute(node, "data-kind", entry.step === "motion" ? entry.kind : entry.step);
          const button = node.firstElementChild;
          if (button) setText(button, stepLine(entry, from + index));
        },
      );
      setText(
        rest,
        t("motions-block", { from: from + 1, to: from + list.children.length, count: trace?.entries.length ?? 0 }),
      );
      show(rest, (trace?.entries.length ?? 0) > BLOCK);
    }
    const current = list.children[step - from];
    for (const node of list.querySelectorAll('[aria-current="step"]'))
      if (node !== current) node.removeAttribute("aria-current");
    if (current && current.getAttribute("aria-current") !== "step") {
      setAttribute(current, "aria-current", "step");
      if (state.panels.tab === "motions") current.scrollIntoView({ block: "nearest" });
    }
  };
}

function stepLine(entry: Step & { line?: number }, index: number): string {
  const line = entry.line ? ` · ${t("motions-line", { line: entry.line })}` : "";
  return `${index + 1}  ${describe(entry)}${line}`;
}

function createLog(root: HTMLElement): Draw {
  const none = el("p", { class: "empty" }, t("log-none"));
  const text = el("pre", { class: "log", tabindex: "0", "aria-label": t("tab-log") });
  const save = el("button", { type: "button" }, t("log-save"));
  const actions = el("div", { class: "actions" }, save);
  root.append(none, text, actions);
  on(save, "click", () => saveFile(`${text.textContent ?? ""}\n`, "print.txt"));
  return (state, derived) => {
    const log = shownOutcome(state, derived)?.log ?? [];
    show(none, log.length === 0);
    show(text, log.length > 0);
    show(actions, log.length > 0);
    setText(text, log.join("\n"));
  };
}

export function createResults(
  root: HTMLElement,
  store: Store,
  actions: Actions,
  scanner: Scanner,
  goTo: (offset: number) => void,
): Draw {
  const bar = el("div", { role: "tablist", class: "tabs", "aria-label": t("panel-results") });
  root.append(el("h2", { class: "visually-hidden" }, t("panel-results")), bar);
  const tabs = new Map<ResultTab, { button: HTMLButtonElement; page: HTMLElement }>();
  for (const name of TABS) {
    const button = el("button", { type: "button", role: "tab", id: `tab-${name}`, "aria-controls": `page-${name}` });
    const page = el("div", {
      role: "tabpanel",
      id: `page-${name}`,
      "aria-labelledby": `tab-${name}`,
      class: "scroll",
      tabindex: "0",
    });
    on(button, "click", () => store.update({ panels: { tab: name } }));
    bar.append(button);
    root.append(page);
    tabs.set(name, { button, page });
  }
  on(bar, "keydown", event => {
    const move = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (!move) return;
    const there = TABS.filter(name => !tabs.get(name)?.button.hidden);
    const next = there[(there.indexOf(store.state.panels.tab) + move + there.length) % there.length] ?? "outcome";
    store.update({ panels: { tab: next } });
    tabs.get(next)?.button.focus();
  });
  const page = (name: ResultTab): HTMLElement => tabs.get(name)?.page ?? root;
  const draws: Draw[] = [
    createOutcome(page("outcome")),
    createProblems(page("problems"), actions, goTo),
    createMotions(page("motions"), store),
    createLog(page("log")),
    createScan(page("scan"), store, scanner),
  ];
  return (state, derived) => {
    const problems = located(state, derived, actions, goTo).length;
    for (const [name, { button, page: body }] of tabs) {
      const chosen =
        name === (state.panels.tab === "scan" && !derived.cycle.surfaces.length ? "outcome" : state.panels.tab);
      show(button, name !== "scan" || derived.cycle.surfaces.length > 0);
      setText(
        button,
        name === "problems" && problems > 0 ? t("tab-problems-count", { count: problems }) : t(`tab-${name}`),
      );
      setAttribute(button, "aria-selected", String(chosen));
      setAttribute(button, "tabindex", chosen ? 0 : -1);
      show(body, chosen);
    }
    for (const draw of draws) draw(state, derived);
  };
}
