// Stepping through the motions: first, back, play, on, last, and a scrubber.

import { el, on, setAttribute, setText } from "../dom";
import type { Derived } from "../derive";
import type { State } from "../state";
import type { Store } from "../store";
import { t } from "../texts";
import { describe } from "./steps";

/** Milliseconds that a step takes while playing. */
export const PACE = 450;
const PACE_STILL = 130; // of a step in which nothing moves

export function createTimeline(root: HTMLElement, store: Store, goToLine: (line: number) => void): (state: State, derived: Derived) => void {
  let count = 0;
  let current = 0;
  let timer = 0;
  let line: number | null = null;
  const go = (step: number, playing = false): void => store.update({ step: Math.max(0, Math.min(count - 1, step)), playing });
  const button = (sign: string, label: string, run: () => void): HTMLButtonElement => {
    const node = el("button", { type: "button", class: "transport", "aria-label": label, title: label }, sign);
    on(node, "click", run);
    return node;
  };
  const play = button("▶", t("timeline-play"), () => {
    const { playing } = store.state;
    go(!playing && current >= count - 1 ? 0 : current, !playing);
  });
  const scrub = el("input", { type: "range", min: 0, step: 1, "aria-label": t("timeline-scrub") });
  const where = el("output", { class: "figure" });
  const what = el("p", { class: "step-text" });
  const place = el("button", { type: "button", class: "quiet place" });
  on(scrub, "input", () => go(Number(scrub.value)));
  on(place, "click", () => { if (line !== null) goToLine(line); });
  root.append(
    el("div", { class: "transport-row" },
      button("|◀◀", t("timeline-first"), () => go(0)), button("|◀", t("timeline-back"), () => go(current - 1)), play,
      button("▶|", t("timeline-on"), () => go(current + 1)), button("▶▶|", t("timeline-last"), () => go(count - 1)), scrub, where),
    el("div", { class: "step-row" }, what, place),
  );
  const tick = (): void => {
    if (store.state.playing) go(current + 1, current + 1 < count - 1);
  };
  return (state, derived) => {
    const entries = derived.trace?.entries ?? [];
    count = entries.length;
    const step = current = derived.step;
    const entry = entries[step];
    setAttribute(scrub, "max", Math.max(0, count - 1));
    if (Number(scrub.value) !== step) scrub.value = String(step);
    setText(where, count ? `${step + 1} / ${count}` : "–");
    setText(what, entry ? describe(entry) : t("motions-none"));
    setAttribute(scrub, "aria-valuetext", entry ? describe(entry) : null);
    line = state.source === "program" ? entry?.line ?? null : derived.opened?.lastLine ?? null;
    setText(place, line === null ? "" : t("motions-line", { line }));
    place.hidden = line === null;
    setText(play, state.playing ? "❚❚" : "▶");
    setAttribute(play, "aria-label", t(state.playing ? "timeline-pause" : "timeline-play"));
    clearTimeout(timer);
    if (state.playing) timer = window.setTimeout(tick, entry?.step === "motion" ? PACE : PACE_STILL);
  };
}
