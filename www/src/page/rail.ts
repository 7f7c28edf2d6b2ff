// The way to the areas of the page: beside them on a large screen; on a phone five tabs under them, the last of which
// opens the menu with all that has no tab.

import type { Actions } from "../desk/actions";
import { el, on, setAttribute } from "../dom";
import { type IconName, icon } from "../icons";
import type { Panel, State } from "../state/state";
import { t } from "../texts";

const ICONS: Record<Panel, IconName> = {
  tasks: "calls",
  form: "measure",
  view: "solid",
  program: "file",
  results: "gauge",
  help: "help",
};

/** What a phone has in its menu. */
const WITHOUT_TAB: Panel[] = ["tasks", "help"];

/** A button with an icon and its name below. */
export function railButton(name: string, of: IconName, attributes: Record<string, string> = {}): HTMLButtonElement {
  return el("button", { type: "button", ...attributes }, icon(of), el("span", {}, name));
}

export function createRail(
  actions: Actions,
  panels: readonly Panel[],
): { root: HTMLElement; draw(state: State): void } {
  const root = el("nav", { class: "panel-bar", "aria-label": t("panels") });
  const buttons = new Map<Panel, HTMLButtonElement>();
  for (const name of panels) {
    const button = railButton(t(`panel-${name}`), ICONS[name], {
      "aria-controls": `panel-${name}`,
      "data-panel-button": name,
    });
    on(button, "click", () =>
      name === "help" && button.hasAttribute("data-shown") ? actions.help() : actions.panel(name),
    );
    root.append(button);
    buttons.set(name, button);
  }
  const more = railButton(t("panel-more"), "more", { class: "rail-more", popovertarget: "page-actions" });
  root.append(more);
  return {
    root,
    draw({ panels: { panel, left, right } }) {
      for (const [name, button] of buttons) {
        setAttribute(button, "aria-current", name === panel ? "true" : null);
        setAttribute(button, "data-shown", name === left || name === right);
      }
      setAttribute(more, "aria-current", WITHOUT_TAB.includes(panel) ? "true" : null);
    },
  };
}
