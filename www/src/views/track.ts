// The line of a trace in real time: where it measures, touches and begins a call, an axis in seconds, and where it is
// now. Times are the core's.

import { el, keyed, on, setText } from "../dom";
import { plain } from "../numbers";
import { t } from "../texts";
import type { Trace } from "../wire";

type Entries = Trace["entries"];

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

/** Bands of a colour, as a picture. */
function picture(bands: readonly (readonly [number, number])[], colour: string): string {
  const places = new Set(
    bands.flatMap(([from, to]) => {
      const [first, last] = [Math.floor(from * MARKS), Math.max(Math.floor(from * MARKS), Math.ceil(to * MARKS) - 1)];
      return Array.from({ length: Math.min(last, MARKS) - first + 1 }, (_, i) => first + i);
    }),
  );
  const stops = [...places]
    .sort((a, b) => a - b)
    .flatMap(place => {
      const [from, to] = [(100 * place) / MARKS, (100 * (place + 1)) / MARKS];
      return [`transparent ${from}%`, `${colour} ${from}% ${to}%`, `transparent ${to}%`];
    });
  return stops.length ? `linear-gradient(to right, ${stops.join(", ")})` : "none";
}

function bandsOf(entries: Entries, times: Times, wanted: (entry: Entries[number]) => boolean): [number, number][] {
  return entries.flatMap((entry, step): [number, number][] =>
    wanted(entry) ? [[times.during(step, 0), times.end(step)]] : [],
  );
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
  show(entries: Entries, begins: Float64Array): Times;
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
  let shown: { entries: Entries; begins: Float64Array; times: Times } | null = null;
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
  const draw = (entries: Entries, times: Times): void => {
    const isMeasuring = (one: Entries[number]): boolean => one.step === "motion" && one.kind === "measuring";
    const isTouch = (one: Entries[number]): boolean => one.step === "touch" && one.by === undefined;
    measuring.style.background = picture(bandsOf(entries, times, isMeasuring), "var(--measure)");
    touches.style.background = picture(bandsOf(entries, times, isTouch), "var(--touch)");
    const boundaries = bandsOf(entries, times, one => one.step === "call" || one.step === "return");
    const few = boundaries.length <= CALLS ? boundaries : [];
    keyed(
      calls,
      few,
      (_, index) => String(index),
      () => el("span", {}),
      (node, [from]) => across(node, from),
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
    show(entries, begins) {
      if (shown?.entries === entries && shown.begins === begins) return shown.times;
      const times = timesOf(begins, entries.length);
      shown = { entries, begins, times };
      draw(entries, times);
      return times;
    },
    at: share => across(head, share),
  };
}
