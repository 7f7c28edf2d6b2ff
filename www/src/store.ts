// One state, one listener for drawing, at most one redraw a frame.

import type { State } from "./state";

export interface Store {
  readonly state: State;
  update(patch: Partial<State> | ((state: State) => Partial<State>)): void;
}

export function createStore(first: State, draw: () => void): Store {
  let state = first;
  let waiting = false;
  const frame = (): void => {
    waiting = false;
    draw();
  };
  return {
    get state() { return state; },
    update(patch) {
      const change = typeof patch === "function" ? patch(state) : patch;
      state = { ...state, ...change };
      if (waiting) return;
      waiting = true;
      requestAnimationFrame(frame);
    },
  };
}
