// Long work beside the page: what it is, how long it takes already, and the way to stop it; afterwards why there is no
// answer.

import { el, on, setAttribute, setText, show } from "../dom";
import { plain } from "../numbers";
import { programOf, type State, type Stopped } from "../state/state";
import { sayProblem, t } from "../texts";

const QUIET = 300; // ms of work that are not worth a word
const TICK = 250; // ms
const SHORT = 0.05; // million characters or MB that would be told as none

/** `size`: characters or bytes that it is about, those of the program unless told; `halt` where the work can wait. */
export interface Activity {
  busy(): { since: number; share?: number; halted?: number; size?: number } | null;
  stopped(state: State): Stopped | null;
  stop(): void;
  again(): void;
  halt?(on: boolean): void;
}

/** `name` is the first part of the keys of its texts. */
export function createActivity(name: string, work: Activity): { root: HTMLElement; draw(state: State): void } {
  const what = el("span", { role: "status" });
  const seconds = el("span", { class: "figure", "aria-hidden": "true" });
  const bar = el("progress", { "aria-label": t(`${name}-working`) });
  const halt = el("button", { type: "button", class: "quiet" });
  const stop = el("button", { type: "button", class: "quiet" }, t("activity-stop"));
  const again = el("button", { type: "button", class: "quiet" }, t("activity-again"));
  const root = el(
    "div",
    { class: "activity", "data-work": name, hidden: true },
    bar,
    what,
    seconds,
    el("div", { class: "activity-buttons" }, halt, stop, again),
  );
  let timer = 0;
  on(halt, "click", () => work.halt?.(work.busy()?.halted === undefined));
  on(stop, "click", work.stop);
  on(again, "click", work.again);

  const draw = (state: State): void => {
    const busy = work.busy();
    const halted = busy?.halted !== undefined;
    const passed = busy ? (busy.halted ?? performance.now()) - busy.since : 0;
    const stopped = work.stopped(state);
    const working = passed > QUIET || halted;
    show(root, working || !!stopped);
    for (const part of [bar, seconds, stop]) show(part, working);
    show(halt, working && !!work.halt);
    show(again, !working);
    setText(halt, t(halted ? "activity-go-on" : "activity-halt"));
    const size = (busy?.size ?? programOf(state).length) / 1e6;
    const long = size < SHORT ? "working" : "working-on";
    if (working) setText(what, t(`${name}-${halted ? "halted" : long}`, { size: plain(size, 1) }));
    else
      setText(
        what,
        stopped ? t(stopped.why ? `${name}-failed` : `${name}-stopped`, { why: sayProblem(stopped.why) }) : "",
      );
    setAttribute(bar, "value", busy?.share);
    const parts = [t("activity-seconds", { seconds: (passed / 1000).toFixed(1) })];
    if (busy?.share !== undefined) parts.unshift(t("activity-share", { percent: Math.floor(busy.share * 100) }));
    setText(seconds, parts.join(" · "));
    clearTimeout(timer);
    if (busy && !halted) timer = window.setTimeout(() => draw(state), working ? TICK : QUIET);
  };
  return { root, draw };
}
