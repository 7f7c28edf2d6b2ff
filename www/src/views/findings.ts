// What is wrong with form and program, each with the way to its place and its cure.

import { html, nothing, render } from "lit-html";
import type { Actions } from "../desk/actions";
import { lineIn } from "../desk/beside";
import type { Derived } from "../desk/derive";
import type { State } from "../state/state";
import { listed, say, t } from "../texts";
import type { Diagnostic, Offer } from "../wire";
import { focusField } from "./field";
import { shownProblems } from "./form";
import type { Lacks } from "./given";
import { offersOf, problem } from "./problem";

const LISTED = 200; // problems; the others stand in the editor, and come here when these are fixed

interface Located {
  problem: Diagnostic;
  place: string;
  go: () => void;
  cure?: () => void;
  /** Cures all of its kind, which are so many; told at the first of them. */
  all?: { count: number; cure: () => void };
}

/** The first finding of each kind of which several can be cured, and how many. */
function together({ fresh, problems }: Derived): Map<Diagnostic, number> {
  const kinds = new Map<string, Diagnostic[]>();
  for (const one of problems.filter(one => fresh && one.cure)) {
    const kind = `${one.code}/${one.message.key}`;
    const known = kinds.get(kind);
    if (known) known.push(one);
    else kinds.set(kind, [one]);
  }
  const several = [...kinds.values()].filter(kind => kind.length > 1);
  return new Map(several.map(kind => [kind[0] as Diagnostic, kind.length]));
}

function placeText({ files }: Derived, problem: Diagnostic): string {
  const { file, line } = lineIn(files, problem.line ?? 0);
  const place = t("problem-place", { line, column: problem.column ?? 1 });
  return file === undefined ? place : t("beside-place", { file, place });
}

/**
 * Of the form and of the program. What both say stands once: with the place in the form, unless only the program mends
 * it.
 */
export function located(state: State, derived: Derived, actions: Actions, goTo: (offset: number) => void): Located[] {
  const same = (one: Diagnostic): string => `${one.code}/${one.param}`;
  const opened = derived.opened;
  const ofOpened = (one: Diagnostic): boolean =>
    !!opened && (one.line ?? 0) >= opened.line && (one.line ?? 0) <= opened.lastLine;
  const told = new Set(derived.problems.filter(one => one.cure && ofOpened(one)).map(same));
  const form = shownProblems(state, derived.view).filter(one => !told.has(same(one)));
  const inForm = new Set(opened ? form.map(same) : []);
  const cured = (problem: Diagnostic): Partial<Located> =>
    problem.cure && derived.fresh ? { cure: () => actions.cure(problem.cure?.edits ?? [], problem.elsewhere) } : {};
  const alike = together(derived);
  const place = (problem: Diagnostic): Located => ({
    problem,
    place: placeText(derived, problem),
    go: () => goTo(problem.from ?? 0),
  });
  return [
    ...form.map(
      (problem): Located => ({
        problem,
        place: problem.param ?? t("panel-form"),
        go: () => {
          actions.panel("form");
          focusField(problem.param ?? "");
        },
      }),
    ),
    ...derived.problems
      .filter(one => !inForm.has(same(one)) || !ofOpened(one))
      .map(problem => {
        const count = alike.get(problem);
        const all = count ? { all: { count, cure: () => actions.cureAll(problem) } } : {};
        return { ...place(problem), ...cured(problem), ...all };
      }),
    ...(derived.run?.diagnostics ?? [])
      .filter(one => !derived.problems.some(known => known.code === one.code && known.from === one.from))
      .map(place),
  ];
}

export function createFindings(
  root: HTMLElement,
  actions: Actions,
  goTo: (offset: number) => void,
  lacks: Lacks,
): (state: State, derived: Derived) => void {
  /** What the finding says is lacking, and the way to give it. */
  const given = ({ wants = [], message }: Diagnostic) => {
    const word = String(message.args.word ?? "");
    const way = (words: string, go: () => void) =>
      html`<button type="button" class="cure" @click=${go}>${words}</button>`;
    if (wants.length) return way(t("given-open", { names: listed(wants) }), lacks.pickFiles);
    if (message.key === "run-machine-value") return way(t("given-enter-value"), lacks.machineValues);
    if (message.key === "run-parameter") return way(t("given-enter-value"), () => lacks.parameter(word));
    return nothing;
  };
  const item = ({ problem: one, place, go, cure, all }: Located) => {
    const mend = (): void => {
      cure?.();
      root.focus(); // the button goes with its finding: the focus stays in the list
    };
    const gives = (offer: Offer): void => {
      actions.give(offer);
      root.focus();
    };
    return problem(
      one,
      html`<span class="problem-actions"
        ><button type="button" class="quiet place" @click=${go}>${place}</button
        ><button type="button" class="cure" ?hidden=${!cure} @click=${mend}>
          ${one.cure ? say(one.cure.label) : ""}
        </button
        ><button type="button" class="cure-all" ?hidden=${!all} @click=${all?.cure}>
          ${all ? t("problems-cure-all", { count: all.count }) : ""}
        </button>${offersOf(one, gives)}${given(one)}</span
      >`,
    );
  };
  return (state, derived) => {
    if (state.panels.tab !== "problems") return;
    const all = located(state, derived, actions, goTo);
    const rest = all.length - LISTED;
    render(
      html`<p class="empty" ?hidden=${all.length > 0}>${t("problems-none")}</p>
        <ul class="problem-list">
          ${all.slice(0, LISTED).map(item)}
        </ul>
        <p class="empty" ?hidden=${rest <= 0}>${t("problems-more", { count: rest })}</p>`,
      root,
    );
  };
}
