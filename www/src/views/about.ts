// About: licence, marks, and what a simulation cannot do.

import { el, on } from "../dom";
import { guideButton } from "../guide";
import { t } from "../texts";

const LINES = ["about-what", "about-offline", "about-prove-out", "about-marks", "about-independent", "about-licence"];

/** `check`: the worked measurements of the manuals in this browser. */
export function createAbout(check: () => void): HTMLDialogElement {
  const close = el("button", { type: "button", class: "primary" }, t("about-close"));
  const proof = el("button", { type: "button" }, t("scenarios-check"));
  const dialog = el(
    "dialog",
    { "aria-labelledby": "about-title", class: "about" },
    el("h2", { id: "about-title" }, t("about-title")),
    ...LINES.map(key => el("p", {}, t(key))),
    el("div", { class: "actions" }, proof, guideButton("installation"), close),
  );
  on(close, "click", () => dialog.close());
  on(proof, "click", () => {
    dialog.close();
    check();
  });
  return dialog;
}
