// What is dragged between two areas to share the room out: with the pointer, with the arrow keys, and with Enter or a
// double click to give one of them all there is and to take it back.

import { el, on, setAttribute } from "../dom";
import { meantBy } from "../keys";
import type { Sizes, State } from "../state/state";
import { t } from "../texts";

type Area = keyof Sizes;
/** Which way it is dragged, in which direction its area grows, and the least pixels of it and of what is beside it. */
interface Kind {
  axis: "x" | "y";
  grows: 1 | -1;
  least: number;
  leaves: number;
}
const KINDS: Record<Area, Kind> = {
  form: { axis: "x", grows: 1, least: 320, leaves: 420 },
  dock: { axis: "y", grows: -1, least: 96, leaves: 200 },
  program: { axis: "x", grows: 1, least: 240, leaves: 280 },
};
const STEP = 24; // px that an arrow key moves

export interface Splitters extends Record<Area, HTMLElement> {
  draw(state: State["panels"]): void;
}

/** `keep`: the sizes as they are from now on. */
export function createSplitters(bench: HTMLElement, keep: (sizes: Sizes) => void): Splitters {
  let sizes: Sizes = {};
  const set = (area: Area, size: number | undefined): void => {
    const { [area]: _, ...others } = sizes;
    keep(size === undefined ? others : { ...others, [area]: Math.round(size) });
  };
  const one = (area: Area): { root: HTMLElement; draw(): void } =>
    createSplitter(
      area,
      bench,
      () => sizes[area],
      size => set(area, size),
    );
  const made = { form: one("form"), dock: one("dock"), program: one("program") };
  let drawn: Sizes | null = null;
  return {
    form: made.form.root,
    dock: made.dock.root,
    program: made.program.root,
    draw(state) {
      if (state.sizes === drawn) return;
      sizes = state.sizes;
      drawn = sizes;
      for (const splitter of Object.values(made)) splitter.draw();
    },
  };
}

/** The panel whose size it sets. */
const PANEL_OF: Record<Area, string> = {
  form: ".panel-form, .panel-tasks",
  dock: ".panel-program, .panel-results",
  program: ".panel-program",
};

function createSplitter(
  area: Area,
  bench: HTMLElement,
  size: () => number | undefined,
  set: (size: number | undefined) => void,
): { root: HTMLElement; draw(): void } {
  const { axis, grows, least, leaves } = KINDS[area];
  const root = el("div", {
    role: "separator",
    class: `splitter splitter-${area}`,
    tabindex: "0",
    "aria-orientation": axis === "x" ? "vertical" : "horizontal",
    "aria-label": t(`splitter-${area}`),
    title: t("splitter-help"),
    "aria-valuemin": least,
  });
  const shown = (): number => {
    const panel = [...bench.querySelectorAll<HTMLElement>(PANEL_OF[area])].find(node => node.offsetParent !== null);
    return (axis === "x" ? panel?.offsetWidth : panel?.offsetHeight) ?? least;
  };
  /** The most that leaves its neighbours their least. */
  const most = (): number => {
    const room = axis === "x" ? bench.clientWidth : bench.clientHeight;
    const before = area === "program" ? root.offsetLeft - shown() : 0;
    return Math.max(least, room - before - leaves);
  };
  const within = (wanted: number): number => Math.min(most(), Math.max(least, wanted));
  let before: number | undefined; // what it was before it was given all
  const lay = (wanted: number | undefined): void => {
    if (wanted === undefined) bench.style.removeProperty(`--${area}`);
    else bench.style.setProperty(`--${area}`, `${Math.round(wanted)}px`);
  };
  const tell = (): void => {
    setAttribute(root, "aria-valuenow", shown());
    setAttribute(root, "aria-valuemax", most());
  };
  const toggle = (): void => {
    const full = shown() >= most() - 1;
    if (!full) before = size();
    set(full ? before : most());
  };

  on(root, "pointerdown", event => {
    if (event.button !== 0) return;
    const place = (one: PointerEvent): number => (axis === "x" ? one.clientX : one.clientY);
    const [from, began] = [place(event), shown()];
    let wanted: number | null = null;
    const move = (to: PointerEvent): void => {
      wanted = within(began + (place(to) - from) * grows);
      lay(wanted);
    };
    const end = (): void => {
      root.removeEventListener("pointermove", move);
      if (wanted !== null && wanted !== began) set(wanted);
    };
    root.setPointerCapture(event.pointerId);
    root.addEventListener("pointermove", move);
    root.addEventListener("lostpointercapture", end, { once: true });
  });
  on(root, "dblclick", toggle);
  on(root, "keydown", event => {
    const command = meantBy(event, "splitter");
    if (!command) return;
    event.preventDefault();
    const way = command === "further" ? grows : -grows;
    if (command === "maximise") toggle();
    else if (command === "least") set(least);
    else if (command === "most") set(most());
    else set(within(shown() + way * STEP));
  });
  new ResizeObserver(tell).observe(bench);

  return {
    root,
    draw() {
      lay(size());
      tell();
    },
  };
}
