// Every step of the work becomes part of the history as soon as form and program agree.

import { toldStep, withStep } from "../state/history";
import { type History, patched, type State } from "../state/state";

/**
 * To be called with each state that is about to be drawn; gives it with its history. `settled`: nothing more follows
 * from it by itself; `typed`: the user typed into the program since the last call.
 */
export function createRecorder(settled: (state: State) => boolean): (state: State, typed: boolean) => State {
  let last: { state: State; history: History } | null = null;
  let inEditor = false;
  const keep = (state: State): State => {
    last = { state, history: state.history };
    inEditor = false;
    return state;
  };
  return (state, typed) => {
    inEditor ||= typed;
    if (!settled(state)) return state;
    // what follows from a step back or forth is no step
    if (!last || last.history !== state.history) return keep(state);
    const told = toldStep(last.state, state, inEditor);
    if (!told) return keep(state);
    return keep(patched(state, { history: withStep(state.history, told, last.state, state, Date.now()) }));
  };
}
