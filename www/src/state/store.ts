// One state, one listener for drawing, at most one redraw a frame.

import { type Patch, patched, type State } from "./state";

export interface Store {
  readonly state: State;
  /** Changes the state, one change after the other, and draws with the next frame. */
  update(...changes: (Patch | ((state: State) => Patch))[]): void;
  /**
   * Draws what is still to be drawn, now: for whoever goes on with what the redraw shows, as moving the focus there.
   */
  flush(): void;
  /** What follows from the state is part of it, before it is drawn: no redraw. */
  settle(next: State): State;
}

/** `changed`: told of each change before the task is over that made it. */
export function createStore(first: State, draw: () => void, changed: () => void): Store {
  let state = first;
  let telling = false;
  let waiting = 0; // the frame asked for
  const frame = (): void => {
    waiting = 0;
    draw();
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
      if (!waiting) return;
      cancelAnimationFrame(waiting);
      frame();
    },
  };
}
