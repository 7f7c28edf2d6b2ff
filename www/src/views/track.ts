// The line of a trace in real time: where it measures, touches and begins a call, an axis in seconds, and where it is
// now. Times are the core's.

import { Sort, type Steps } from "../core/steps";
import { el, keyed, on, setText } from "../dom";
import { plain } from "../numbers";
import { t } from "../texts";

const MARKS = 300; // places of the line that are told apart
const TICK = 70; // CSS pixels between two figures of the axis at least
const CALLS = 100; // more boundaries than that would be a band
const MINUTES = 120; // s from which on an axis counts in minutes

/** When the steps of a trace are done, as shares of the whole. */
export interface Times {
  total: number; // s
  end(step: number): number;
  /** Part of a step. */
  during(step: number, fraction: number): number;
  /** The step that is done next to this share. */
  step(share: number): number;
}

/** `begins`: of each entry and of the end, s; steps without times are as long as each other. */
export function timesOf(begins: Float64Array, count: number): Times {
  const known = begins.length === count + 1;
  const total = known ? (begins[count] ?? 0) : 0;
  const at = (place: number): number => (total > 0 ? (begins[place] ?? 0) / total : place / Math.max(1, count));
  const end = (step: number): number => (step >= count - 1 ? 1 : at(step + 1));
  return {
    total,
    end,
    during: (step, fraction) => at(step) + fraction * (end(step) - at(step)),
    step(share) {
      let [low, high] = [0, Math.max(0, count - 1)];
      while (low < high) {
        const middle = (low + high) >> 1;
        if (end(middle) < share) low = middle + 1;
        else high = middle;
      }
      return low > 0 && share - end(low - 1) < end(low) - share ? low - 1 : low;
    },
  };
}

/** Bands of a colour where steps of a sort are, as a picture. */
function picture({ sorts }: Steps, times: Times, sort: number, colour: string): string {
  const places = new Set<number>();
  for (let step = sorts.indexOf(sort); step >= 0; step = sorts.indexOf(sort, step + 1)) {
    const [from, to] = [times.during(step, 0), times.end(step)];
    const [first, last] = [Math.floor(from * MARKS), Math.max(Math.floor(from * MARKS), Math.ceil(to * MARKS) - 1)];
    for (let place = first; place <= Math.min(last, MARKS); place++) places.add(place);
  }
  const stops = [...places]
    .sort((a, b) => a - b)
    .flatMap(place => {
      const [from, to] = [(100 * place) / MARKS, (100 * (place + 1)) / MARKS];
      return [`transparent ${from}%`, `${colour} ${from}% ${to}%`, `transparent ${to}%`];
    });
  return stops.length ? `linear-gradient(to right, ${stops.join(", ")})` : "none";
}

/** When calls begin and end, as shares of the whole; none where they are too many. */
function boundaries({ sorts }: Steps, times: Times): number[] {
  const found: number[] = [];
  for (const [step, sort] of sorts.entries()) {
    if (sort === Sort.call || sort === Sort.return) found.push(times.during(step, 0));
    if (found.length > CALLS) return [];
  }
  return found;
}

/** Round seconds of an axis with this much room, CSS pixels. */
export function ticksOf(total: number, width: number): number[] {
  const least = (total * TICK) / Math.max(width, TICK);
  const sizes = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600];
  const size = sizes.find(one => one >= least) ?? 3600 * Math.ceil(least / 3600);
  return total > 0 ? Array.from({ length: Math.floor(total / size) + 1 }, (_, i) => i * size) : [];
}

/** "12.5 s", "2:05". */
export function clockText(seconds: number, total: number, digits = 1): string {
  if (total < MINUTES) return t("timeline-seconds", { seconds: plain(Number(seconds.toFixed(digits))) });
  const whole = Math.floor(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

export interface Track {
  root: HTMLElement;
  /** What is shown, and when. */
  show(steps: Steps, begins: Float64Array): Times;
  /** Where it is now, as a share. */
  at(share: number): void;
}

/** `scrub`: for keys and who does not see; `go`: to a step. */
export function createTrack(scrub: HTMLElement, go: (step: number) => void): Track {
  const [measuring, touches] = [el("div", { class: "track-measuring" }), el("div", { class: "track-touches" })];
  const [calls, head] = [el("div", { class: "track-calls" }), el("div", { class: "track-head" })];
  const axis = el("div", { class: "track-axis" });
  const line = el("div", { class: "track-line", "aria-hidden": "true" }, measuring, touches, calls, axis, head);
  const root = el("div", { class: "track" }, line, scrub);
  let shown: { steps: Steps; begins: Float64Array; times: Times } | null = null;
  let width = 0;

  const across = (node: HTMLElement, share: number): void => {
    node.style.left = `${(100 * share).toFixed(3)}%`;
  };
  const drawAxis = (): void => {
    const total = shown?.times.total ?? 0;
    const make = (): HTMLElement => el("span", {});
    keyed(axis, ticksOf(total, width), String, make, (node, seconds) => {
      across(node, seconds / total);
      setText(node, clockText(seconds, total));
    });
  };
  const draw = (steps: Steps, times: Times): void => {
    measuring.style.background = picture(steps, times, Sort.measuring, "var(--measure)");
    touches.style.background = picture(steps, times, Sort.touch, "var(--touch)");
    keyed(
      calls,
      boundaries(steps, times),
      (_, index) => String(index),
      () => el("span", {}),
      across,
    );
    drawAxis();
  };
  const lead = (event: PointerEvent): void => {
    const box = line.getBoundingClientRect();
    if (shown && box.width) go(shown.times.step((event.clientX - box.left) / box.width));
  };
  on(root, "pointerdown", event => {
    if (event.button !== 0) return;
    event.preventDefault();
    root.setPointerCapture(event.pointerId);
    scrub.focus();
    lead(event);
  });
  on(root, "pointermove", event => {
    if (root.hasPointerCapture(event.pointerId)) lead(event);
  });
  new ResizeObserver(() => {
    if (width === line.clientWidth) return;
    width = line.clientWidth;
    drawAxis();
  }).observe(line);
  return {
    root,
    show(steps, begins) {
      if (shown?.steps === steps && shown.begins === begins) return shown.times;
      const times = timesOf(begins, steps.length);
      shown = { steps, begins, times };
      draw(steps, times);
      return times;
    },
    at: share => across(head, share),
  };
}
