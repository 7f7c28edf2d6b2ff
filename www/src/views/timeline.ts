// Stepping through the motions: first, back, play, on, last, a scrubber, and how fast it plays.

import type { Derived } from "../desk/derive";
import { el, on, setAttribute, setText } from "../dom";
import { plain } from "../numbers";
import { SPEEDS, type State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import type { Trace } from "../wire";
import { describe } from "./steps";

const PACE = 450; // ms that a motion takes while playing
const PACE_STILL = 130; // and a step in which nothing moves
const FRAME = 16; // ms; more often nothing is drawn
const LATE = 1000; // ms; what comes later, as after a pause of the whole machine, is not made up for

type Entries = Trace["entries"];
const paceOf = (entries: Entries, step: number): number => (entries[step]?.step === "motion" ? PACE : PACE_STILL);

/** Milliseconds that a motion takes at this speed; 0 where several of them pass between two frames. */
export function paceAt(speed: number): number {
  return PACE / speed < FRAME ? 0 : PACE / speed;
}

/** The step that is played after so many ms, the next one at least: at high speed several pass from frame to frame. */
function reached(entries: Entries, step: number, ms: number, speed: number): number {
  let left = ms * speed;
  let next = step;
  do {
    left -= paceOf(entries, next);
    next += 1;
  } while (next < entries.length - 1 && left >= paceOf(entries, next));
  return next;
}

export function createTimeline(
  root: HTMLElement,
  store: Store,
  goToLine: (line: number) => void,
): (state: State, derived: Derived) => void {
  let count = 0;
  let current = 0;
  let timer = 0;
  let line: number | null = null;
  const go = (step: number, playing = false): void =>
    store.update({ view: { step: Math.max(0, Math.min(count - 1, step)), playing } });
  const button = (sign: string, label: string, run: () => void): HTMLButtonElement => {
    const node = el("button", { type: "button", class: "transport", "aria-label": label, title: label }, sign);
    on(node, "click", run);
    return node;
  };
  const play = button("▶", t("timeline-play"), () => {
    const { playing } = store.state.view;
    go(!playing && current >= count - 1 ? 0 : current, !playing);
  });
  const scrub = el("input", { type: "range", min: 0, step: 1, "aria-label": t("timeline-scrub") });
  const where = el("output", { class: "figure" });
  const what = el("p", { class: "step-text" });
  const place = el("button", { type: "button", class: "quiet place" });
  on(scrub, "input", () => go(Number(scrub.value)));
  on(place, "click", () => {
    if (line !== null) goToLine(line);
  });
  const speed = el(
    "select",
    { class: "speed", "aria-label": t("timeline-speed"), title: t("timeline-speed") },
    ...SPEEDS.map(times => el("option", { value: times }, t("timeline-times", { times: plain(times) }))),
  );
  on(speed, "change", () => store.update({ view: { speed: Number(speed.value) } }));
  root.append(
    el(
      "div",
      { class: "transport-row" },
      button("|◀◀", t("timeline-first"), () => go(0)),
      button("|◀", t("timeline-back"), () => go(current - 1)),
      play,
      button("▶|", t("timeline-on"), () => go(current + 1)),
      button("▶▶|", t("timeline-last"), () => go(count - 1)),
      scrub,
      where,
      speed,
    ),
    el("div", { class: "step-row" }, what, place),
  );
  return (state, derived) => {
    const entries = derived.trace?.entries ?? [];
    count = entries.length;
    const { step } = derived;
    current = step;
    const entry = entries[step];
    setAttribute(scrub, "max", Math.max(0, count - 1));
    if (Number(scrub.value) !== step) scrub.value = String(step);
    setText(where, count ? `${step + 1} / ${count}` : "–");
    const words = entry && describe(entry, derived.catalogue.cycles);
    setText(what, words ?? t("motions-none"));
    setAttribute(scrub, "aria-valuetext", words ?? null);
    line = state.view.source === "program" ? (entry?.line ?? null) : (derived.opened?.lastLine ?? null);
    setText(place, line === null ? "" : t("motions-line", { line }));
    place.hidden = line === null;
    setText(play, state.view.playing ? "❚❚" : "▶");
    for (const name of ["aria-label", "title"])
      setAttribute(play, name, t(state.view.playing ? "timeline-pause" : "timeline-play"));
    speed.value = String(state.view.speed);
    clearTimeout(timer);
    if (!state.view.playing) return;
    const began = performance.now();
    const tick = (): void => {
      if (!store.state.view.playing) return;
      const next = reached(entries, step, Math.min(LATE, performance.now() - began), state.view.speed);
      go(next, next < count - 1);
    };
    timer = window.setTimeout(tick, Math.max(FRAME, paceOf(entries, step) / state.view.speed));
  };
}
