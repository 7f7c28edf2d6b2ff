// The 3D view with its timeline. The drawing itself is loaded when it is first shown.

import { NOTHING, type SceneData } from "../core/scene";
import type { Derived } from "../desk/derive";
import { el, on, setAttribute, setText, show } from "../dom";
import type { Cloud } from "../preview/backend";
import type { Preview } from "../preview/view";
import type { Scanned } from "../state/scanned";
import { AT_END, inFocus, type State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import { type Shown, shownTheme } from "../theme";
import { createCube } from "./cube";
import { createExaggeration } from "./exaggerate";
import { createLegend, type Thinned } from "./legend";
import { missing } from "./missing";
import { createScreen } from "./screen";
import { type Stage, tool, watchTaken } from "./stage";
import { createTimeline, paceAt } from "./timeline";

const SOURCES = ["form", "program", "scan"] as const;
const FULL = 0.9; // of the greatest deviation: from there on a point has the full colour
const still = matchMedia("(prefers-reduced-motion: reduce)");

export function createScene(
  root: HTMLElement,
  store: Store,
  goToLine: (line: number) => void,
  stage: Stage,
): (state: State, derived: Derived) => void {
  const segments = el("div", { class: "segments", role: "group", "aria-label": t("view-source") });
  const buttons = SOURCES.map(source => {
    const button = el("button", { type: "button" }, t(`view-${source}`));
    on(button, "click", () => store.update({ view: { source, step: AT_END, playing: false } }));
    segments.append(button);
    return { source, button };
  });
  const tools = el("div", { class: "head-actions" });
  const note = el("p", { class: "empty", role: "status" }, t("view-loading"));
  const empty = el("p", { class: "empty over-stage", role: "status", hidden: true });
  const legend = createLegend();
  const errors = createExaggeration(store);
  const corner = el("div", { class: "stage-corner" });
  const section = tool("cut", t("view-section"), () => store.update({ view: { section: !store.state.view.section } }));
  const central = tool("perspective", t("view-central"), () =>
    store.update({ view: { central: !store.state.view.central } }),
  );
  const timeline = el("div", { class: "timeline", role: "group", "aria-label": t("timeline-scrub") });
  const screen = createScreen(store, () => timeline.querySelector("input")?.focus());
  const holder = el(
    "div",
    { class: "stage-box" },
    stage.box,
    screen.root,
    el("div", { class: "stage-cards" }, errors.root, legend.root),
    corner,
    empty,
  );
  root.append(
    el("header", { class: "panel-head" }, el("h2", {}, t("view-title")), segments, tools),
    note,
    holder,
    timeline,
  );
  const drawing = el(
    "button",
    { type: "button", class: "quiet", title: t("view-diameters-help") },
    t("view-diameters"),
  );
  on(drawing, "click", () => {
    const diameters = !store.state.view.diameters;
    store.update({ view: { diameters } });
    if (diameters) stage.preview?.setView("front"); // as a drawing has it
  });
  const drawTimeline = createTimeline(timeline, store, goToLine);

  let shown: Pick<Derived, "trace"> & { data: SceneData; theme: Shown | null; step: number; drawn: number } = {
    trace: null,
    data: NOTHING,
    theme: null,
    step: -1,
    drawn: 0,
  };
  let dressed = false; // the preview has its buttons and its name

  const dress = (preview: Preview): void => {
    if (dressed) return;
    dressed = true;
    preview.setLabel(t("view-canvas"));
    const cube = createCube(preview);
    corner.append(
      cube.root,
      tool("view", t("view-iso"), () => preview.setView("iso")),
      tool("fit", t("view-fit"), () => preview.fit()),
      section,
      central,
    );
    preview.onDraw(cube.draw);
    watchTaken(stage.box, [legend.root, errors.root, corner, screen.root], preview);
    watchCovered(legend.root, preview.setCovered);
    tools.append(drawing);
    show(note, false);
  };

  let lent = false; // another place has the stage
  return (state, derived) => {
    if (state.page.place === "jog") {
      lent = true;
      return;
    }
    if (lent) {
      lent = false;
      holder.prepend(stage.box);
      shown = { ...shown, trace: null, data: { ...NOTHING }, theme: null, step: -1 };
    }
    const scan = state.scan.made?.request.cycle === derived.cycle.cycle ? state.scan.made : null;
    const source = state.view.source === "scan" && !scan ? "form" : state.view.source;
    for (const one of buttons) {
      setAttribute(one.button, "aria-pressed", String(one.source === source));
      show(one.button, one.source !== "scan" || !!scan);
    }
    const { preview, failed } = stage;
    const data = (preview && derived.scene?.(state.view.errors)) ?? NOTHING;
    drawTimeline(state, derived, data.begins);
    screen.draw(state, derived);
    if (failed) setText(note, t("view-failed", { problem: failed }));
    if (!preview) {
      if (root.offsetParent) stage.fetch();
      return;
    }
    dress(preview);
    const points = source === "scan" && scan ? cloudOf(scan) : null;
    setText(
      empty,
      derived.trace?.steps.length || source === "scan"
        ? ""
        : source === "form"
          ? nothing(derived)
          : t(derived.run ? "motions-none" : "motions-running"),
    );
    show(empty, !!empty.textContent);
    const theme = shownTheme(state.page.theme);
    const colours = stage.colours(theme);
    if (colours && theme !== shown.theme) preview.setColours(colours);
    const fresh = derived.trace !== shown.trace;
    const drawn = points ? stage.drawn : 0;
    if (colours && (fresh || theme !== shown.theme || drawn !== shown.drawn)) {
      legend.draw(derived.trace, colours, thinned(drawn, scan));
    }
    const other = data !== shown.data;
    const focus = source === "form" ? inFocus(state) : null;
    if (other) preview.setScene(data, focus);
    errors.draw(state, data.view);
    const { step } = derived;
    if (other || step !== shown.step) {
      const runs = state.view.playing && derived.trace?.steps.at(step)?.step === "motion" && !still.matches;
      move(preview, step, runs ? paceAt(data.begins, step, state.view.speed) : 0);
    }
    preview.setCloud(points);
    preview.setArrows(source === "program" ? stage.arrows : null);
    preview.setDrawing(state.view.diameters);
    preview.setSection(state.view.section);
    preview.setCentral(state.view.central);
    setAttribute(section, "aria-pressed", String(state.view.section));
    setAttribute(central, "aria-pressed", String(state.view.central));
    preview.setFocus(focus);
    show(drawing, !!derived.trace?.drawing);
    setAttribute(drawing, "aria-pressed", String(state.view.diameters));
    shown = { trace: derived.trace, data, theme, step, drawn };
  };
}

const drawable = new WeakMap<Float32Array, Cloud>();

/** The points of a scan; the same object for as long as they are the same. */
export function cloudOf({ view, clouds, of }: Scanned): Cloud | null {
  const points = clouds[of];
  if (!points?.length) return null;
  const made = drawable.get(points) ?? { points, origin: view.origin, full: Math.max(1e-4, FULL * view[of].greatest) };
  drawable.set(points, made);
  return made;
}

/** What is not to be seen of a scan, once something of it is drawn. */
export function thinned(drawn: number, scan: Scanned | null): Thinned | null {
  const points = scan?.view.points ?? 0;
  return drawn > 0 && drawn < points ? { drawn, points } : null;
}

/** Why the call in the form shows no motions. */
function nothing(derived: Derived): string {
  return derived.view.outcome ? t("motions-none") : missing(derived);
}

let moving = 0;

/** The probe stands at the end of a step, or runs along it for so many ms. */
function move(preview: Preview, step: number, pace: number): void {
  cancelAnimationFrame(moving);
  const begin = performance.now();
  const frame = (now: number): void => {
    const fraction = pace ? Math.min(1, Math.max(0, now - begin) / pace) : 1;
    preview.setStep(step, fraction);
    if (fraction < 1) moving = requestAnimationFrame(frame);
  };
  frame(begin);
}

/** Tells how far this reaches from the left. To ask while drawing would lay out the page at each keystroke. */
function watchCovered(legend: HTMLElement, tell: (width: number) => void): void {
  new ResizeObserver(() => tell(legend.offsetWidth + legend.offsetLeft)).observe(legend);
}
