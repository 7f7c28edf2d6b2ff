// A newer version of the page is there: a quiet line, which waits.

import { el, on, setText, show } from "../dom";
import { lay } from "../state/keep";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { reload } from "../state/update";
import { t } from "../texts";

export function createNewer(store: Store): { root: HTMLElement; draw(state: State): void } {
  const text = el("p", { role: "status" });
  const now = el("button", { type: "button" }, t("newer-reload"));
  const later = el("button", { type: "button", class: "quiet" }, t("newer-later"));
  const root = el("div", { class: "newer", "data-empty": true }, text, now, later);
  on(now, "click", () => void lay(() => store.state).then(reload));
  on(later, "click", () => store.update({ page: { newer: false } }));
  return {
    root,
    draw({ page: { newer } }) {
      root.toggleAttribute("data-empty", !newer);
      for (const button of [now, later]) show(button, newer);
      setText(text, newer ? t("newer-ready") : "");
    },
  };
}
