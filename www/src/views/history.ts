// Undo and redo, and all steps by name: a click on one goes back or forth to where it was done.

import type { Actions } from "../desk/actions";
import { el, keyed, on, setAttribute, setText } from "../dom";
import { type IconName, icon } from "../icons";
import { ariaKey } from "../keys";
import type { History, State, Step } from "../state/state";
import { t } from "../texts";

function iconButton(name: IconName, attributes: Record<string, string>): HTMLButtonElement {
  return el("button", { type: "button", class: "quiet icon-button", ...attributes }, icon(name));
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
  const open = iconButton("down", { id: "history-open", popovertarget: "history" });
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
