// Where a file was to be opened: why it was not, or that it is meant for another control.

import { el, on, setAttribute, setText, show } from "../dom";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import type { Dialect } from "../wire";

export function createRefusal(
  store: Store,
  place: "program" | "setup",
  openUnder: (control: Dialect) => void,
): { root: HTMLElement; draw(state: State): void } {
  const text = el("p", { class: "problem", "data-severity": "error", role: "alert" });
  const close = el("button", { type: "button", class: "quiet" }, t("refused-close"));
  const under = el("button", { type: "button", hidden: true });
  const root = el("div", { class: "refusal", hidden: true }, text, under, close);
  let control: Dialect | undefined;
  on(under, "click", () => {
    if (control) openUnder(control);
  });
  on(close, "click", () => store.update({ page: { refused: null } }));
  return {
    root,
    draw(state) {
      const refused = state.page.refused?.place === place ? state.page.refused : null;
      show(root, !!refused);
      setText(text, refused ? t(refused.key, refused.args) : "");
      control = refused?.control;
      show(under, !!control);
      setText(under, control ? t("refused-under", { control: t(`control-${control}`) }) : "");
      setAttribute(text, "data-severity", control || refused?.taken ? "warning" : "error");
    },
  };
}
