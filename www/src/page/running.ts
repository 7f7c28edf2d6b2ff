// The run of the program, while its motions are shown: asked aside, and its answer put into the state.

import type { Answered, Aside } from "../core/aside";
import type { Derived } from "../desk/derive";
import { isCurrent } from "../desk/program";
import { beginningIn, patched, programMachine, programPlane, type State } from "../state/state";
import type { RunView } from "../wire";

/** Lets the program run on the opened machine, else on that of the form, while its motions are shown. */
export function askRun(runner: Aside, state: State, { view, program: text }: Derived): void {
  const { control } = state.form;
  const { done: ran, stopped: stoppedRun } = state.run;
  if (state.view.source !== "program") return;
  const opened = state.machine.setup?.control === control ? state.machine.setup : undefined;
  const setup = opened ?? (view.setup ? beginningIn(view.setup, programPlane(state)) : programMachine(state).setup);
  const { errors: times } = state.view;
  const done = isCurrent(ran, state) && ran?.setup === setup && ran?.times === times;
  if (!done && !isCurrent(stoppedRun, state))
    runner.want({ ask: "run", control, text, times, ...(setup ? { setup } : {}) });
}

/** With what a run did, or why there is nothing. */
export function withRun(answered: Answered | null, state: State): State {
  if (answered?.question.ask !== "run" || !isCurrent(answered.question, state)) return state;
  const {
    question: { control, text, setup, times },
    json,
    scene,
    problem,
  } = answered;
  if (json === undefined || !scene) return patched(state, { run: { stopped: { control, text, why: problem ?? "" } } });
  return patched(state, { run: { done: { control, text, setup, times, view: JSON.parse(json) as RunView, scene } } });
}
