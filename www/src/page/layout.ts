// The panels, the bar that chooses among them on small screens, skip links, and the way from panel to panel.

import type { Actions } from "../desk/actions";
import { el, on, setAttribute } from "../dom";
import { ariaKey } from "../keys";
import type { Panel, State } from "../state/state";
import { t } from "../texts";

const PANELS: Panel[] = ["tasks", "form", "program", "view", "results", "help"];
/** The panels that help covers where all panels stand side by side. */
const COVERED: Panel[] = ["program", "view", "results"];

export interface Layout {
  header: HTMLElement;
  panels: Record<Panel, HTMLElement>;
  notice: HTMLElement;
  undo: HTMLElement;
  step(by: number): void;
  draw(state: State): void;
}

export function createLayout(actions: Actions): Layout {
  const header = el("header", { class: "top" });
  const panels = Object.fromEntries(
    PANELS.map(name => [
      name,
      el("section", {
        id: `panel-${name}`,
        class: `panel panel-${name}`,
        "data-panel": name,
        tabindex: "-1",
        "aria-label": t(`panel-${name}`),
      }),
    ]),
  ) as Record<Panel, HTMLElement>;
  const bar = el("nav", { class: "panel-bar", "aria-label": t("panels") });
  const buttons = new Map<Panel, HTMLButtonElement>();
  for (const name of PANELS) {
    const button = el("button", { type: "button", "aria-controls": `panel-${name}` }, t(`panel-${name}`));
    on(button, "click", () => actions.panel(name));
    bar.append(button);
    buttons.set(name, button);
  }
  const skip = el(
    "nav",
    { class: "skip", "aria-label": t("skip") },
    ...PANELS.map(name => {
      const link = el("a", { href: `#panel-${name}` }, t("skip-to", { panel: t(`panel-${name}`) }));
      on(link, "click", event => {
        event.preventDefault();
        enter(name);
      });
      return link;
    }),
  );
  const notice = el("span", { role: "status" });
  const undo = el("button", { type: "button", hidden: true, "aria-keyshortcuts": ariaKey("page", "undo") }, t("undo"));
  on(undo, "click", () => actions.step(1));
  const main = el("main", { class: "bench" }, ...PANELS.map(name => panels[name]));
  document.body.append(skip, header, bar, main, el("div", { class: "notice" }, notice, undo));

  const enter = (name: Panel): void => {
    actions.panel(name);
    panels[name].focus();
  };
  /** To the panel that stands this many after the present one, among those that are shown. */
  const step = (by: number): void => {
    const shown = PANELS.filter(name => name !== "help" || panels.help.hasAttribute("data-shown"));
    const here = shown.findIndex(name => panels[name].contains(document.activeElement));
    enter(shown[(here + by + shown.length) % shown.length] ?? "form");
  };

  let last: Panel | null = null;
  return {
    header,
    panels,
    notice,
    undo,
    step,
    draw(state) {
      if (last !== null && last !== state.panels.panel && scrollY > bar.offsetTop)
        scrollTo({ top: bar.offsetTop, behavior: "instant" }); // where the page scrolls as a whole
      last = state.panels.panel;
      for (const name of COVERED) setAttribute(panels[name], "inert", state.panels.right === "help");
      for (const [name, button] of buttons) {
        setAttribute(button, "aria-current", name === state.panels.panel ? "true" : null);
        setAttribute(button, "data-shown", name === state.panels.left || name === state.panels.right ? "" : null);
        setAttribute(panels[name], "data-active", name === state.panels.panel ? "" : null);
        setAttribute(panels[name], "data-shown", name === state.panels.left || name === state.panels.right ? "" : null);
      }
    },
  };
}
