// Where a file was to be opened: why it was not.

import { el, on, setText, show } from "../dom";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";

export function createRefusal(
  store: Store,
  place: "program" | "setup",
): { root: HTMLElement; draw(state: State): void } {
  const text = el("p", { class: "problem", "data-severity": "error", role: "alert" });
  const close = el("button", { type: "button", class: "quiet" }, t("refused-close"));
  const root = el("div", { class: "refusal", hidden: true }, text, close);
  on(close, "click", () => store.update({ page: { refused: null } }));
  return {
    root,
    draw(state) {
      const refused = state.page.refused?.place === place ? state.page.refused : null;
      show(root, !!refused);
      setText(text, refused ? t(refused.key, refused.args) : "");
    },
  };
}
