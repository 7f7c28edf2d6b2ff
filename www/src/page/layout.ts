// The areas of the page: the rail that leads to them, form, stage, answer and dock, skip links, and the way from area
// to area.

import type { Actions } from "../desk/actions";
import { el, on, setAttribute } from "../dom";
import { ariaKey, meantBy } from "../keys";
import type { Panel, State } from "../state/state";
import { t } from "../texts";
import { createRail } from "./rail";
import { createSheetBar } from "./sheet";
import { createSplitters } from "./splitters";

/** In the order of work, which is that of the focus. */
const PANELS: Panel[] = ["tasks", "form", "view", "program", "results", "help"];
/** The panels that help covers where they stand beside it. */
const COVERED: Panel[] = ["program", "view", "results"];

export interface Layout {
  header: HTMLElement;
  main: HTMLElement;
  panels: Record<Panel, HTMLElement>;
  /** Under the stage: what came out. */
  answer: HTMLElement;
  /** For more ways than those to the panels. */
  rail: HTMLElement;
  notice: HTMLElement;
  undo: HTMLElement;
  step(by: number): void;
  draw(state: State): void;
}

function createPanels(): Record<Panel, HTMLElement> {
  const panel = (name: Panel): HTMLElement =>
    el("section", {
      id: `panel-${name}`,
      class: `panel panel-${name}`,
      "data-panel": name,
      tabindex: "-1",
      "aria-label": t(`panel-${name}`),
    });
  return Object.fromEntries(PANELS.map(name => [name, panel(name)])) as Record<Panel, HTMLElement>;
}

function createSkip(enter: (name: Panel) => void): HTMLElement {
  const links = PANELS.map(name => {
    const link = el("a", { href: `#panel-${name}` }, t("skip-to", { panel: t(`panel-${name}`) }));
    on(link, "click", event => {
      event.preventDefault();
      enter(name);
    });
    return link;
  });
  return el("nav", { class: "skip", "aria-label": t("skip") }, ...links);
}

export function createLayout(actions: Actions, sizes: Parameters<typeof createSplitters>[1]): Layout {
  const header = el("header", { class: "top" });
  const panels = createPanels();
  const rail = createRail(actions, PANELS);
  const answer = el("div", { class: "answer-area" });
  const notice = el("span", { role: "status" });
  const undo = el("button", { type: "button", hidden: true, "aria-keyshortcuts": ariaKey("page", "undo") }, t("undo"));
  on(undo, "click", () => actions.step(1));
  const { tasks, form, view, program, results, help } = panels;
  const main = el("main", { class: "bench" });
  const splitters = createSplitters(main, sizes);
  const sheet = createSheetBar(main, actions);
  main.append(tasks, form, splitters.form, view, answer, splitters.dock, sheet.root);
  main.append(program, splitters.program, results, help);

  const enter = (name: Panel): void => {
    actions.panel(name);
    panels[name].focus();
  };
  const leaveTasks = (event: KeyboardEvent): void => {
    if (meantBy(event, "page") === "close" && !event.defaultPrevented) enter("form");
  };
  on(tasks, "keydown", leaveTasks);
  document.body.append(
    createSkip(enter),
    header,
    el("div", { class: "room" }, rail.root, main),
    el("div", { class: "notice" }, notice, undo),
  );

  let shown: State["panels"] | null = null;
  /** To the panel that stands this many after the present one, among those that are shown. */
  const step = (by: number): void => {
    const hidden: (Panel | undefined)[] = [
      shown?.left === "tasks" ? "form" : "tasks",
      shown?.right === "help" ? undefined : "help",
    ];
    const there = PANELS.filter(name => !hidden.includes(name));
    const here = there.findIndex(name => panels[name].contains(document.activeElement));
    enter(there[(here + by + there.length) % there.length] ?? "form");
  };

  return {
    header,
    main,
    panels,
    answer,
    rail: rail.root,
    notice,
    undo,
    step,
    draw(state) {
      const now = state.panels;
      if (shown && shown.panel !== now.panel && scrollY > main.offsetTop)
        scrollTo({ top: main.offsetTop, behavior: "instant" }); // where the page scrolls as a whole
      shown = now;
      for (const name of COVERED) setAttribute(panels[name], "inert", now.right === "help");
      setAttribute(answer, "inert", now.right === "help");
      setAttribute(sheet.root, "inert", now.right === "help");
      for (const name of PANELS) {
        setAttribute(panels[name], "data-active", name === now.panel);
        setAttribute(panels[name], "data-shown", name === now.left || name === now.right);
      }
      setAttribute(main, "data-left", now.left);
      setAttribute(main, "data-dock", now.dock);
      rail.draw(state);
      splitters.draw(now);
      sheet.draw(state);
    },
  };
}
