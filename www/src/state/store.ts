// One state, one listener for drawing, at most one redraw a frame; of what somebody types the rest follows its paint.

import { type Patch, patched, type State } from "./state";

export interface Store {
  readonly state: State;
  /** Changes the state, one change after the other, and draws with the next frame. */
  update(...changes: (Patch | ((state: State) => Patch))[]): void;
  /**
   * Draws what is still to be drawn, now: for whoever goes on with what the redraw shows, as moving the focus there.
   */
  flush(): void;
  /** Draws the rest of what was drawn last, unless that is done. */
  finish(): void;
  /** What follows from the state is part of it, before it is drawn: no redraw. */
  settle(next: State): State;
}

/** What may be drawn a moment later than what the user looks at. */
export type Rest = () => void;

/** ms between two keys of one that is held down: the next one would wait for the rest, which follows the last. */
const HELD = 100;

/**
 * `draw`: gives back what is to be drawn once the browser has painted the frame; `changed`: told of each change before
 * the task is over that made it.
 */
export function createStore(first: State, draw: () => Rest | undefined, changed: () => void): Store {
  let state = first;
  let telling = false;
  let waiting = 0; // the frame asked for
  let rest: Rest | undefined;
  let left = -HELD; // when a rest was left to be drawn last, as performance.now
  const finish = (): void => {
    const open = rest;
    rest = undefined;
    open?.();
  };
  const frame = (): void => {
    waiting = 0;
    rest = undefined; // this frame draws all of it anew
    const open = draw();
    rest = open;
    if (!open) return;
    const painted = (): void => {
      if (rest === open && !waiting) finish();
    };
    const before = left;
    left = performance.now();
    if (left - before < HELD) {
      setTimeout(painted, HELD);
      return;
    }
    setTimeout(painted);
    requestAnimationFrame(painted);
  };
  const tell = (): void => {
    telling = false;
    changed();
  };
  return {
    get state() {
      return state;
    },
    update(...changes) {
      for (const change of changes) state = patched(state, typeof change === "function" ? change(state) : change);
      waiting ||= requestAnimationFrame(frame);
      if (!telling) queueMicrotask(tell);
      telling = true;
    },
    settle(next) {
      state = next;
      return state;
    },
    flush() {
      if (waiting) {
        cancelAnimationFrame(waiting);
        frame();
      }
      finish();
    },
    finish,
  };
}
