// The run of the program, while its motions are shown: asked aside, and its answer put into the state.

import { type Answered, type Aside, isGiant } from "../core/aside";
import { type Columns, courseOf, stepsOf } from "../core/steps";
import type { Derived } from "../desk/derive";
import { type Given, givenTo, machineTo } from "../desk/given";
import { isCurrent, isOfNow } from "../desk/program";
import { patched, type Ran, type State } from "../state/state";
import type { RunView } from "../wire";
import type { Work } from "./activities";

/** Lets the program run on the opened machine, else on that of the form, while its motions are shown. */
export function askRun({ runner, reader }: Work, state: State, { view, program: text }: Derived): void {
  const { control } = state.form;
  const { done: ran, stopped: stoppedRun } = state.run;
  if (state.view.source !== "program") return;
  if (isGiant(text) && reader.busy()) {
    runner.stop();
    return;
  }
  const setup = machineTo(state, view);
  const { errors: times } = state.view;
  const { known: isKnown, ...given } = givenTo(state);
  if (!isKnown) return; // what the program is given depends on what it holds
  const known = !!ran && isOfNow(ran, state) && ran.setup === setup && isGiven(ran, given);
  const done = known && ran?.times === times;
  if (!done && !isCurrent(stoppedRun, state))
    runner.want({ ask: "run", control, text, times, known, ...(setup ? { setup } : {}), ...given });
}

/** With what is to be seen of a run that goes on. */
export function withMotions(derived: Derived, runner: Aside, { view: { source } }: State): Derived {
  const seen = source === "program" && !derived.run ? runner.busy()?.seen : undefined;
  return seen ? { ...derived, scene: () => seen } : derived;
}

const isGiven = (ran: Ran, given: Given): boolean =>
  ran.arguments === given.arguments &&
  ran.strict === given.strict &&
  ran.mode === given.mode &&
  ran.target === given.target &&
  ran.program === given.program &&
  ran.file === given.file;

function cameTo(view: RunView, steps: Columns | undefined): Pick<Ran, "view" | "course"> {
  if (!steps) return { view, course: courseOf(view.trace) };
  const { entries: _, ...trace } = view.trace;
  return { view, course: { ...trace, steps: stepsOf(steps) } };
}

/** With what a run did, or why there is nothing. */
export function withRun(answered: Answered | null, state: State): State {
  if (answered?.question.ask !== "run" || !isOfNow(answered.question, state)) return state;
  const { question, json, parts, scene, steps, problem } = answered;
  const { control, text, setup, times, known, with: beside, arguments: values, ...how } = question;
  const { strict, mode, target, program, file } = how;
  if (json === undefined || !scene) return patched(state, { run: { stopped: { control, text, why: problem ?? "" } } });
  const came = known ? state.run.done : cameTo({ ...(JSON.parse(json) as RunView), ...parts }, steps);
  if (!came) return state;
  const { view, course } = came;
  return patched(state, {
    run: {
      done: {
        control,
        text,
        setup,
        times,
        view,
        course,
        scene,
        with: beside,
        arguments: values,
        strict,
        mode,
        target,
        program,
        file,
      },
    },
  });
}
