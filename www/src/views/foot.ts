// The footer of the form, always in sight: the call as it stands now, and what is done with it.

import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { placedIn } from "../desk/placed";
import { el, on, setAttribute, setText, show } from "../dom";
import { icon } from "../icons";
import { inFocus, type State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import { withBlocks } from "./around";
import { createCode, inOneLine, piecesOf } from "./code";
import { copyText } from "./copy";
import { createMenu } from "./menu";

/** `entries`: further actions of the form, in the menu. */
export function createFoot(
  store: Store,
  actions: Actions,
  goToLine: (line: number) => void,
  entries: readonly HTMLElement[],
): { root: HTMLElement; draw(state: State, derived: Derived): void } {
  const call = el("code", { class: "foot-call" });
  const copy = el("button", { type: "button", class: "primary" }, icon("copy"), t("form-copy-call"));
  const insert = el("button", { type: "button", class: "insert" }, t("form-insert"));
  const placedText = el("span", {});
  const placed = el(
    "button",
    { type: "button", class: "placed" },
    placedText,
    el("span", { class: "placed-mark", "aria-hidden": "true" }, "✓"),
  );
  const more = createMenu("form-menu", t("form-more"), entries);
  const root = el(
    "footer",
    { class: "form-foot", "aria-label": t("form-call") },
    call,
    el("div", { class: "foot-actions" }, copy, insert, placed, more.button),
    more.list,
  );
  const drawCall = createCode(call);
  let lit: string | null = null;
  let snippet = "";
  let line: number | null = null; // in which the program has the call just so
  on(copy, "click", () => void copyText(snippet, store, "notice-copied"));
  on(insert, "click", () => {
    actions.insert(snippet);
    actions.panel("program");
  });
  on(placed, "click", () => {
    if (line !== null) goToLine(line);
  });
  return {
    root,
    draw(state, derived) {
      snippet = withBlocks(derived);
      drawCall(inOneLine(piecesOf(derived.view.snippet, derived.view.snippetPlaces), derived.cycle.control));
      const name = inFocus(state);
      if (name !== lit) bringInSight(call, name);
      lit = name;
      setAttribute(call, "title", snippet);
      setAttribute(copy, "disabled", snippet === "");
      line = placedIn(state, derived);
      show(insert, line === null);
      setAttribute(insert, "disabled", snippet === "");
      show(placed, line !== null);
      if (line !== null) setText(placedText, t("form-placed", { line }));
    },
  };
}

/** The line shows its beginning, or where this parameter is when that is cut off. */
function bringInSight(call: HTMLElement, name: string | null): void {
  const value = name === null ? null : call.querySelector<HTMLElement>(`[data-field="${CSS.escape(name)}"]`);
  const end = value ? value.offsetLeft + value.offsetWidth - call.offsetLeft : 0;
  call.classList.toggle("shifted", end > call.clientWidth); // what ends in dots draws nothing behind them
  call.scrollLeft = end > call.clientWidth ? end - call.clientWidth / 2 : 0;
}
