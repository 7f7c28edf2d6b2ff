// The tooltip of a button that has a key says the key.

import { setAttribute } from "../dom";
import { keyText } from "../views/keys";

const KEY = "aria-keyshortcuts";

/** With the key behind what the button says already, once it is pointed at or has the focus. Until `end`. */
export function showKeys(end: AbortSignal): void {
  const show = ({ target }: Event): void => {
    const node = target instanceof Element ? target.closest(`button[${KEY}]`) : null;
    const [first = ""] = (node?.getAttribute(KEY) ?? "").split(" ");
    if (!node || !first) return;
    const key = ` (${keyText(first.replace(/Control|Meta/, "Ctrl"))})`;
    const name = node.getAttribute("title") ?? node.getAttribute("aria-label") ?? node.textContent?.trim() ?? "";
    if (!name.endsWith(key)) setAttribute(node, "title", name + key);
  };
  for (const event of ["pointerover", "focusin"]) document.addEventListener(event, show, { signal: end });
}
