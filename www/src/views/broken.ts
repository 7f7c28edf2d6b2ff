// The core broke. Say what happened, keep the work, offer the way on.

import { el, on } from "../dom";
import { reload as reloadPage } from "../state/update";
import { t } from "../texts";

export function showBroken(what: string): void {
  if (document.getElementById("broken")) return;
  const reload = el("button", { type: "button", class: "primary" }, t("broken-reload"));
  on(reload, "click", () => void reloadPage());
  const dialog = el(
    "dialog",
    { id: "broken", class: "about", "aria-labelledby": "broken-title" },
    el("h2", { id: "broken-title" }, t("broken-title")),
    el("p", {}, t("broken-kept")),
    el("pre", { class: "log", tabindex: "0" }, what),
    el("div", { class: "actions" }, reload),
  );
  document.body.append(dialog);
  dialog.showModal();
}
