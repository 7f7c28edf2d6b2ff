// The sheet of keys: all that the keyboard does, by where it does it.

import { el, on } from "../dom";
import { isMac, KEYS, partsOf } from "../keys";
import { optional, t } from "../texts";

const SYMBOLS: Record<string, string> = {
  ArrowLeft: "←",
  ArrowRight: "→",
  ArrowUp: "↑",
  ArrowDown: "↓",
  Escape: "Esc",
};

/** As it stands on the keyboard of who reads it. */
function label(part: string): string {
  if (part === "Ctrl" && isMac) return "⌘";
  return SYMBOLS[part] ?? (optional(`key-${part === " " ? "space" : part.toLowerCase()}`) || part);
}

/** A combination of keys as text. */
export function keyText(key: string): string {
  return partsOf(key).map(label).join("+");
}

/** A combination of keys, as it stands on the keyboard. */
export function keyLabel(key: string): HTMLElement {
  const parts = partsOf(key).flatMap(part => ["+", el("kbd", {}, label(part))]);
  return el("span", { class: "key" }, ...parts.slice(1));
}

function group([name, commands]: [string, Record<string, readonly string[]>]): HTMLElement {
  const lines = Object.entries(commands).flatMap(([command, keys]) => [
    el("dt", {}, ...keys.map(keyLabel)),
    el("dd", {}, t(`keys-${name}-${command}`)),
  ]);
  return el("section", {}, el("h3", {}, t(`keys-${name}`)), el("dl", {}, ...lines));
}

export function createKeys(): HTMLDialogElement {
  const close = el("button", { type: "button", class: "primary" }, t("keys-close"));
  const dialog = el(
    "dialog",
    { "aria-labelledby": "keys-title", class: "about keys" },
    el("h2", { id: "keys-title", tabindex: "-1", autofocus: true }, t("keys-title")),
    el("div", { class: "key-groups" }, ...Object.entries(KEYS).map(group)),
    el("div", { class: "actions" }, close),
  );
  on(close, "click", () => dialog.close());
  return dialog;
}
