// A button that opens a list of further actions above or below itself.

import { type Attributes, el, on } from "../dom";
import { icon } from "../icons";

/**
 * `label` names the button, which shows three dots or what it is given. Other buttons may have the menu as their
 * `popovertarget`.
 */
export function createMenu(
  id: string,
  label: string,
  entries: readonly (HTMLElement | null)[],
  face: readonly (Node | string)[] = [icon("more")],
  attributes: Attributes = {},
): { button: HTMLButtonElement; list: HTMLElement } {
  const button = el(
    "button",
    {
      type: "button",
      id: `${id}-open`,
      class: "icon-button",
      "aria-label": label,
      title: label,
      popovertarget: id,
      ...attributes,
    },
    ...face,
  );
  const list = el("div", { id, class: "menu", popover: "auto", role: "group", "aria-label": label }, ...entries);
  const opens = `[popovertarget="${id}"]`;
  on(list, "beforetoggle", () => {
    const all = [...document.querySelectorAll(opens)];
    place(list, (all.find(one => one.checkVisibility()) ?? button).getBoundingClientRect());
  });
  // before the entry does anything: the focus is back where the menu was opened, and a dialog gives it back there
  const chosen = ({ target }: Event): void => {
    if (target instanceof Element && target.closest("button:not([data-stays]), a")) list.hidePopover();
  };
  list.addEventListener("click", chosen, { capture: true });
  on(list, "focusout", ({ relatedTarget: to }) => {
    if (to instanceof Element && !list.contains(to) && !to.closest(opens)) list.hidePopover();
  });
  return { button, list };
}

/** On the side of the button on which there is more room. */
function place(list: HTMLElement, { left, right, top, bottom }: DOMRect): void {
  const set = (name: string, value: number | null): void =>
    value === null ? void list.style.removeProperty(name) : list.style.setProperty(name, `${Math.max(0, value)}px`);
  const below = innerHeight - bottom > top;
  const after = innerWidth - left > right;
  set("--from-top", below ? bottom : null);
  set("--from-bottom", below ? null : innerHeight - top);
  set("--from-left", after ? left : null);
  set("--from-right", after ? null : innerWidth - right);
  set("--room", (below ? innerHeight - bottom : top) - 8);
}
