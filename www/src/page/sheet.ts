// Program and result of a tablet, a sheet from below: a strip, half or all of the room under the answer. Its edge is
// dragged, moved by keys, or by two buttons.

import type { Actions } from "../desk/actions";
import { el, on, setAttribute } from "../dom";
import { type IconName, icon } from "../icons";
import { meantBy } from "../keys";
import { type DockPanel, SHEETS, type Sheet, type State } from "../state/state";
import { t } from "../texts";

const DOCKS: DockPanel[] = ["program", "results"];
const FLING = 0.4; // px in a ms, from which on the direction counts and not the place
const MOVE = 160; // ms, as folds take
const still = matchMedia("(prefers-reduced-motion: reduce)");

/** The bar at the top of the sheet. */
export function createSheetBar(bench: HTMLElement, actions: Actions): { root: HTMLElement; draw(state: State): void } {
  const grip = el("div", {
    role: "slider",
    class: "sheet-grip",
    tabindex: "0",
    "aria-label": t("sheet"),
    "aria-orientation": "vertical",
    "aria-valuemin": 0,
    "aria-valuemax": SHEETS.length - 1,
    title: t("sheet-help"),
  });
  let sheet: Sheet = "half";
  const set = (at: number): void => actions.sheet(SHEETS[Math.min(SHEETS.length - 1, Math.max(0, at))] ?? sheet);
  const move = (by: number): void => set(SHEETS.indexOf(sheet) + by);
  const button = (of: IconName, name: string, by: number): HTMLButtonElement => {
    const node = el("button", { type: "button", class: "quiet", "aria-label": t(name), title: t(name) }, icon(of));
    on(node, "click", () => move(by));
    return node;
  };
  const [up, down] = [button("up", "sheet-up", 1), button("down", "sheet-down", -1)];
  const panels = DOCKS.map(panel => {
    const node = el("button", { type: "button" }, t(`panel-${panel}`));
    on(node, "click", () => actions.panel(panel));
    return { panel, node };
  });
  const root = el(
    "div",
    { class: "sheet-bar", role: "group", "aria-label": t("sheet") },
    el("div", { class: "segments" }, ...panels.map(({ node }) => node)),
    grip,
    el("div", { class: "head-actions" }, down, up),
  );

  on(grip, "keydown", event => {
    const command = meantBy(event, "splitter");
    if (!command) return;
    event.preventDefault();
    if (command === "least") set(0);
    else if (command === "most") set(SHEETS.length - 1);
    else if (command === "maximise") set(sheet === "full" ? 1 : SHEETS.length - 1);
    else move(command === "nearer" ? 1 : -1);
  });
  on(grip, "dblclick", () => set(sheet === "full" ? 1 : SHEETS.length - 1));
  on(grip, "pointerdown", event => {
    if (event.button !== 0) return;
    const [from, since] = [event.clientY, event.timeStamp];
    let [last, speed] = [from, 0];
    const drag = (to: PointerEvent): void => {
      speed = (to.clientY - from) / Math.max(1, to.timeStamp - since);
      last = to.clientY;
      bench.style.setProperty("--sheet", `${Math.round(bench.getBoundingClientRect().bottom - last)}px`);
    };
    const end = (): void => {
      grip.removeEventListener("pointermove", drag);
      const height = bench.getBoundingClientRect().bottom - last;
      bench.style.removeProperty("--sheet");
      if (last === from) return;
      if (Math.abs(speed) > FLING) move(speed < 0 ? 1 : -1);
      else set(nearest(height / bench.clientHeight));
    };
    grip.setPointerCapture(event.pointerId);
    grip.addEventListener("pointermove", drag);
    grip.addEventListener("lostpointercapture", end, { once: true });
  });

  let shown: State["panels"] | null = null;
  return {
    root,
    draw({ panels: now }) {
      if (shown === now) return;
      const before = root.offsetParent ? root.getBoundingClientRect().top : null;
      const other = shown !== null && shown.sheet !== now.sheet;
      shown = now;
      sheet = now.sheet;
      setAttribute(bench, "data-sheet", sheet);
      const at = SHEETS.indexOf(sheet);
      setAttribute(grip, "aria-valuenow", at);
      setAttribute(grip, "aria-valuetext", t(`sheet-${sheet}`));
      setAttribute(up, "disabled", at === SHEETS.length - 1);
      setAttribute(down, "disabled", at === 0);
      for (const { panel, node } of panels) setAttribute(node, "aria-pressed", String(panel === now.dock));
      if (other && before !== null) slide(before - root.getBoundingClientRect().top);
    },
  };

  /** From where it stood to where it stands. */
  function slide(by: number): void {
    if (still.matches) return;
    const docks = [root, ...DOCKS.map(name => bench.querySelector(`.panel-${name}`))];
    for (const node of docks)
      node?.animate([{ translate: `0 ${by}px` }, { translate: "0 0" }], { duration: MOVE, easing: "ease-out" });
  }
}

/** The stop nearest to a share of the height. */
function nearest(share: number): number {
  const stops = [0.13, 0.34, 0.88];
  const off = stops.map(stop => Math.abs(stop - share));
  return off.indexOf(Math.min(...off));
}
