// Call styles: chosen for the snippet, and for the call of the program that the form edits.

import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { el, keyed, on, setAttribute, setText, show } from "../dom";
import { programOf, type State } from "../state/state";
import { t } from "../texts";
import type { Diagnostic, Style } from "../wire";
import { listProblems } from "./problem";

interface View {
  root: HTMLElement;
  draw(state: State, derived: Derived): void;
}

function findings(list: HTMLElement, all: readonly Diagnostic[]): void {
  listProblems(list, all);
  show(list, all.length > 0);
}

function buttons(
  parent: HTMLElement,
  styles: readonly Style[],
  text: (style: Style) => string,
  pressed: Style | null,
  pick: (style: Style) => void,
): void {
  keyed(
    parent,
    styles,
    style => style,
    style => {
      const node = el("button", { type: "button", "data-style": style });
      on(node, "click", () => pick(style));
      return node;
    },
    (node, style) => {
      setText(node, text(style));
      setAttribute(node, "aria-pressed", pressed ? String(style === pressed) : null);
    },
  );
}

/** Of the snippet: the ways that the cycle has, and what the chosen one cannot say. */
export function createSnippetWays(actions: Actions): { choice: HTMLElement; said: HTMLElement; draw: View["draw"] } {
  const choice = el("div", { class: "segments", role: "group", "aria-label": t("ways") });
  const said = el("ul", { class: "quiet-findings", "aria-live": "polite", "aria-label": t("ways-findings") });
  return {
    choice,
    said,
    draw(_, { cycle, style, view }) {
      show(choice, cycle.styles.length > 1);
      buttons(
        choice,
        cycle.styles,
        one => t(`way-${one}`),
        style,
        one => actions.style(one === view.preset ? "" : one),
      );
      findings(said, view.snippetFindings);
    },
  };
}

/** Of the opened call: how it is written, the other ways, and what was said when it was converted. */
export function createCallWays(actions: Actions): View {
  const now = el("span", {});
  const others = el("span", { class: "segments", role: "group", "aria-label": t("convert") });
  const said = el("ul", { class: "quiet-findings", "aria-live": "polite" });
  const line = el(
    "div",
    { class: "call-way" },
    now,
    el("span", { class: "convert", "aria-hidden": "true" }, t("convert")),
    others,
  );
  const root = el("div", { class: "call-ways" }, line, said);
  return {
    root,
    draw(state, { cycle, opened }) {
      const { converted } = state.desk;
      const current = converted?.control === state.form.control && converted.text === programOf(state);
      const all = current && converted ? converted.findings : [];
      show(line, cycle.styles.length > 1);
      show(root, !!opened && (cycle.styles.length > 1 || all.length > 0));
      if (!opened) return;
      setText(now, t("way-now", { way: t(`way-${opened.style}`) }));
      buttons(
        others,
        cycle.styles.filter(one => one !== opened.style),
        one => t(`way-${one}`),
        null,
        actions.convert,
      );
      findings(said, all);
    },
  };
}
