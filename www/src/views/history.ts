// Undo and redo, and all steps by name: a click on one goes back or forth to where it was done.

import type { Actions } from "../desk/actions";
import { el, keyed, on, setAttribute, setText, svg } from "../dom";
import { ariaKey } from "../keys";
import type { History, State, Step } from "../state/state";
import { t } from "../texts";

const ARROWS = {
  undo: "M8 4 3.5 8.5 8 13M4 8.5h8a4.5 4.5 0 0 1 0 9h-2",
  redo: "M12 4l4.5 4.5L12 13M16 8.5H8a4.5 4.5 0 0 0 0 9h2",
  history: "M6 8l4 4 4-4",
};

function icon(name: keyof typeof ARROWS): SVGSVGElement {
  return svg("svg", { class: "icon", viewBox: "0 0 20 20", "aria-hidden": "true" }, svg("path", { d: ARROWS[name] }));
}

function iconButton(name: keyof typeof ARROWS, attributes: Record<string, string>): HTMLButtonElement {
  return el("button", { type: "button", class: "quiet icon-button", ...attributes }, icon(name) as unknown as Node);
}

function nameOf({ name: { key, args } }: Step): string {
  return t(key, args.encoding ? { encoding: t(`encoding-${args.encoding}`) } : args);
}

/** The states between the steps, the newest first: how many steps back it is, and what led to it. */
function places({ past, future }: History): { back: number; text: string }[] {
  const undone = future.map((step, index) => ({ back: index - future.length, text: nameOf(step) }));
  const done = past.map((step, index) => ({ back: past.length - 1 - index, text: nameOf(step) })).reverse();
  return [...undone, ...done, { back: past.length, text: t("history-begin") }];
}

export function createHistory(actions: Actions): { root: HTMLElement; draw(state: State): void } {
  const undo = iconButton("undo", {
    id: "undo",
    "aria-label": t("undo"),
    "aria-keyshortcuts": ariaKey("page", "undo"),
  });
  const redo = iconButton("redo", {
    id: "redo",
    "aria-label": t("redo"),
    "aria-keyshortcuts": ariaKey("page", "redo"),
  });
  const open = iconButton("history", { id: "history-open", popovertarget: "history" });
  const list = el("ol", { class: "history-list" });
  const all = el("div", { id: "history", class: "history", popover: "auto", "aria-label": t("history") }, list);
  on(undo, "click", () => actions.step(1));
  on(redo, "click", () => actions.step(-1));
  on(all, "beforetoggle", () => {
    const { left, bottom } = open.getBoundingClientRect();
    all.style.setProperty("--from-left", `${left}px`);
    all.style.setProperty("--from-top", `${bottom}px`);
  });
  let shown: History | null = null;
  const tell = (button: HTMLButtonElement, key: string, step: Step | undefined): void => {
    setAttribute(button, "disabled", !step);
    setAttribute(button, "title", step ? t(key, { step: nameOf(step) }) : t(`${key}-none`));
  };
  const draw = ({ history }: State): void => {
    if (history === shown) return;
    shown = history;
    tell(undo, "history-undo", history.past.at(-1));
    tell(redo, "history-redo", history.future.at(-1));
    keyed(
      list,
      places(history),
      (_, index) => String(index),
      () => {
        const button = el("button", { type: "button", class: "quiet" });
        on(button, "click", () => {
          all.hidePopover();
          actions.step(Number(button.dataset.back));
        });
        return el("li", {}, button);
      },
      (node, { back, text }) => {
        const button = node.firstElementChild as HTMLButtonElement;
        setAttribute(button, "data-back", back);
        setAttribute(button, "data-undone", back < 0);
        setAttribute(button, "aria-current", back === 0 ? "step" : null);
        setText(button, text);
      },
    );
  };
  setAttribute(open, "aria-label", t("history"));
  setAttribute(open, "title", t("history"));
  return {
    root: el("div", { class: "steps", role: "group", "aria-label": t("history") }, undo, redo, open, all),
    draw,
  };
}
