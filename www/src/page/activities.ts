// Work that takes its time, told where its outcome will be seen, and to be stopped there.

import type { Aside } from "../core/aside";
import { isCurrent } from "../desk/program";
import type { Job } from "../pace";
import { type Patch, programOf, type State, type Stopped } from "../state/state";
import type { Store } from "../state/store";
import { type Activity, createActivity } from "../views/activity";

/** Work beside the page: what is asked of the core on threads of its own, and what goes on in slices. */
export interface Work {
  /** Reading the program; running it; how certain a measurement is. */
  reader: Aside;
  runner: Aside;
  judge: Aside;
  /** A file being opened; a program that the page has, being made ready for the editor. */
  opening: Job;
  laying: Job;
}

export function createActivities(store: Store, { opening, laying, reader, runner }: Work) {
  return {
    file: fetching(store, opening),
    text: ofProgram(store, "laying", LAYING, laying),
    calls: ofProgram(store, "reading", READING, { busy: reader.busy, stop: reader.stop }), // only a run can wait
    motions: ofProgram(store, "running", RUN, runner, state => state.view.source === "program"),
  };
}

const stopped = (state: State): Stopped => ({ control: state.form.control, text: programOf(state), why: "" });

/** A file that is stopped on the way was never there. */
function fetching(store: Store, opening: Job) {
  const stop = (): void => {
    opening.stop();
    store.update({});
  };
  return createActivity("opening", { busy: opening.busy, stopped: () => null, stop, again: stop });
}

/** Where it is kept that something was stopped. */
const LAYING = {
  of: (state: State) => state.program.stoppedLaying,
  put: (stoppedLaying: Stopped | null): Patch => ({ program: { stoppedLaying } }),
};
const READING = {
  of: (state: State) => state.program.stoppedReading,
  put: (stoppedReading: Stopped | null): Patch => ({ program: { stoppedReading } }),
};
const RUN = {
  of: (state: State) => state.run.stopped,
  put: (stopped: Stopped | null): Patch => ({ run: { stopped } }),
};

/** Work on the text of the program. Once it is stopped nothing is asked about that text any more. */
function ofProgram(
  store: Store,
  name: string,
  kept: { of(state: State): Stopped | null; put(stopped: Stopped | null): Patch },
  work: Pick<Activity, "busy" | "stop" | "halt">,
  counts = (_: State): boolean => true,
) {
  return createActivity(name, {
    ...work,
    stopped: state => (counts(state) && isCurrent(kept.of(state), state) ? kept.of(state) : null),
    stop: () => {
      work.stop();
      store.update(state => kept.put(stopped(state)));
    },
    again: () => store.update(kept.put(null)),
  });
}
