// Stepping through the motions: first, back, play, on, last, a scrubber, and how fast it plays.

import { NO_STEPS } from "../core/steps";
import type { Derived } from "../desk/derive";
import { el, on, setAttribute, setText } from "../dom";
import { type IconName, icon } from "../icons";
import { plain } from "../numbers";
import { SPEEDS, type State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import { lineText } from "./given";
import { haltAfter } from "./screen";
import { describe } from "./steps";
import { clockText, createTrack } from "./track";

const PACE_STILL = 130; // ms that a step takes in which nothing moves, so that it is seen
const FRAME = 16; // ms; more often nothing is drawn
const LATE = 1000; // ms; what comes later, as after a pause of the whole machine, is not made up for
const still = matchMedia("(prefers-reduced-motion: reduce)");

/** Milliseconds that a step takes at its real feed. `begins`: of each entry, s. */
function paceOf(begins: Float64Array, step: number): number {
  const long = 1000 * ((begins[step + 1] ?? 0) - (begins[step] ?? 0));
  return long > 0 ? long : PACE_STILL;
}

/** Milliseconds that a motion takes at this speed; 0 where several of them pass between two frames. */
export function paceAt(begins: Float64Array, step: number, speed: number): number {
  const pace = paceOf(begins, step) / speed;
  return pace < FRAME ? 0 : pace;
}

/** The step that is played after so many ms, the next one at least: at high speed several pass from frame to frame. */
function reached(begins: Float64Array, count: number, step: number, ms: number, speed: number): number {
  let left = ms * speed;
  let next = step;
  do {
    left -= paceOf(begins, next);
    next += 1;
  } while (next < count - 1 && left >= paceOf(begins, next));
  return next;
}

export function createTimeline(
  root: HTMLElement,
  store: Store,
  goToLine: (line: number) => void,
): (state: State, derived: Derived, begins: Float64Array) => void {
  let count = 0;
  let current = 0;
  let timer = 0;
  let line: number | null = null;
  let runs = false;
  const go = (step: number, playing = false): void =>
    store.update({ view: { step: Math.max(0, Math.min(count - 1, step)), playing } });
  const button = (sign: IconName, label: string, run: () => void): HTMLButtonElement => {
    const node = el("button", { type: "button", class: "transport", "aria-label": label, title: label }, icon(sign));
    on(node, "click", run);
    return node;
  };
  const play = button("play", t("timeline-play"), () => {
    const { playing } = store.state.view;
    go(!playing && current >= count - 1 ? 0 : current, !playing);
  });
  const scrub = el("input", { type: "range", min: 0, step: 1, "aria-label": t("timeline-scrub") });
  const track = createTrack(scrub, step => go(step));
  let running = 0; // frame that draws where a step is that is being played
  const where = el("output", { class: "figure" });
  const what = el("p", { class: "step-text" });
  const time = el("span", { class: "figure step-time" });
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
      button("first", t("timeline-first"), () => go(0)),
      button("previous", t("timeline-back"), () => go(current - 1)),
      play,
      button("next", t("timeline-on"), () => go(current + 1)),
      button("last", t("timeline-last"), () => go(count - 1)),
      track.root,
      where,
      speed,
    ),
    el("div", { class: "step-row" }, what, time, place),
  );
  return (state, derived, begins) => {
    const steps = derived.trace?.steps ?? NO_STEPS;
    count = steps.length;
    const { step } = derived;
    current = step;
    const entry = steps.at(step);
    const times = track.show(steps, begins);
    track.at(times.end(step));
    setText(time, times.total ? `${clockText(times.end(step) * times.total, times.total, 2)}` : "");
    setAttribute(scrub, "max", Math.max(0, count - 1));
    if (Number(scrub.value) !== step) scrub.value = String(step);
    setText(where, count ? `${step + 1} / ${count}` : "–");
    const words = entry && describe(entry, derived.catalogue.cycles);
    setText(what, words ?? t("motions-none"));
    setAttribute(scrub, "aria-valuetext", words ?? null);
    line = state.view.source === "program" ? (entry?.line ?? null) : (derived.opened?.lastLine ?? null);
    setText(place, line === null ? "" : lineText(derived.files, line));
    place.hidden = line === null;
    if (state.view.playing !== runs) play.replaceChildren(icon(state.view.playing ? "pause" : "play"));
    runs = state.view.playing;
    for (const name of ["aria-label", "title"])
      setAttribute(play, name, t(state.view.playing ? "timeline-pause" : "timeline-play"));
    speed.value = String(state.view.speed);
    clearTimeout(timer);
    cancelAnimationFrame(running);
    if (!state.view.playing) return;
    const began = performance.now();
    const lasts = entry?.step === "motion" && !still.matches ? paceAt(begins, step, state.view.speed) : 0;
    const run = (now: number): void => {
      const fraction = Math.min(1, Math.max(0, now - began) / lasts);
      track.at(times.during(step, fraction));
      if (fraction < 1) running = requestAnimationFrame(run);
    };
    if (lasts) run(began);
    const tick = (): void => {
      if (!store.state.view.playing) return;
      const far = reached(begins, count, step, Math.min(LATE, performance.now() - began), state.view.speed);
      const halt = state.view.halts ? haltAfter(state, derived, step) : Number.POSITIVE_INFINITY;
      const next = Math.min(far, halt);
      go(next, next < count - 1 && next < halt);
    };
    timer = window.setTimeout(tick, Math.max(FRAME, paceOf(begins, step) / state.view.speed));
  };
}
