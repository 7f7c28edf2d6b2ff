// Everything to be seen, in the language that counts when it is made. Another language: another bench, from the same
// state.

import type { Aside } from "../core/aside";
import type { ProgramCore } from "../core/program";
import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { isCurrent } from "../desk/program";
import { el, setText, show } from "../dom";
import type { EditorPlace } from "../editor/place";
import type { Encoding } from "../encoding";
import type { Job } from "../pace";
import type { Scanner } from "../scan/scanner";
import { type Patch, programOf, type State, type Stopped } from "../state/state";
import type { Store } from "../state/store";
import { language, t } from "../texts";
import { type Activity, createActivity } from "../views/activity";
import { behind } from "../views/behind";
import { createCard } from "../views/card";
import { createForm } from "../views/form";
import { createFound } from "../views/found";
import { createHeader } from "../views/header";
import { createProgram } from "../views/program";
import { createRefusal } from "../views/refusal";
import { createScene } from "../views/scene";
import { createSets } from "../views/sets";
import { createSliders } from "../views/sliders";
import type { Stage } from "../views/stage";
import { createTasks } from "../views/tasks";
import type { AlarmInfo, Catalogue, Dialect } from "../wire";
import { createLayout } from "./layout";

/** What outlives a bench. */
export interface Parts {
  catalogue: Catalogue;
  store: Store;
  actions: Actions;
  open: { program(file: File): void; again(encoding: Encoding): void; setup(file: File): void };
  /** A file being opened; a program that the page has, being made ready for the editor. */
  opening: Job;
  laying: Job;
  editor: EditorPlace;
  stage: Stage;
  reader: Aside;
  runner: Aside;
  scanner: Scanner;
  goToField(control: Dialect, name: string): void;
  /** As soon as it is there. */
  core(): ProgramCore | null;
  alarms: Promise<AlarmInfo[]>;
}

export interface Bench {
  readonly language: string;
  draw(state: State, derived: Derived): void;
  end(): void;
}

export function createBench({
  catalogue,
  store,
  actions,
  open,
  opening,
  laying,
  editor,
  stage,
  reader,
  runner,
  scanner,
  goToField,
  core,
  alarms,
}: Parts): Bench {
  const stop = new AbortController();
  const layout = createLayout(actions, stop.signal);
  const { panels } = layout;
  const results = el("div", { class: "results-main" });
  const sliders = el("aside", { class: "sliders", "aria-label": t("sliders-title") });
  panels.results.append(results, sliders);
  const program = createProgram(panels.program, store, actions, open, editor);
  const activities = [
    fetching(store, opening),
    ofProgram(store, "laying", LAYING, laying),
    ofProgram(store, "reading", READING, { busy: reader.busy, stop: reader.stop }), // only a run can wait
    ofProgram(store, "running", RUN, runner, state => state.view.source === "program"),
  ] as const;
  const refusals = [createRefusal(store, "program"), createRefusal(store, "setup")] as const;
  const sets = createSets(actions);
  const card = createCard(actions);
  document.body.append(sets.dialog, card.dialog);
  const found = (back: () => void) => createFound(catalogue, alarms, store, actions, goToField, back);
  const [file, text, calls, motions] = activities;
  program.head.after(refusals[0].root, file.root, text.root, calls.root);
  layout.header.after(refusals[1].root);
  panels.view.append(motions.root);
  let shown: { state: State; derived: Derived } | null = null;
  const later = behind(
    pieces => {
      pieces.createSheet(stage, () => shown, stop.signal);
      return {
        drawResults: pieces.createResults(results, store, actions, scanner, program.goTo),
        drawHelp: pieces.createHelp(panels.help, store, actions, core),
        machineData: pieces.createMachineData(store, actions, core),
      };
    },
    () => store.update({}),
    stop.signal,
  );
  const views = [
    createHeader(layout.header, store, actions, open.setup, core, () => later()?.machineData ?? null),
    createTasks(panels.tasks, store, actions, found),
    createForm(panels.form, store, actions, () => sets.dialog.showModal()),
    createScene(panels.view, store, program.goToLine, stage),
    (state: State, derived: Derived): void => later()?.drawResults(state, derived),
    createSliders(sliders, store, actions),
    (state: State, derived: Derived): void => later()?.drawHelp(state, derived),
    sets.draw,
    card.draw,
    program.draw, // last: the editor asks for the selection, and that lays out the page
  ];
  return {
    language: language(),
    draw(state, derived) {
      shown = { state, derived };
      layout.draw(state);
      for (const view of views) view(state, derived);
      for (const part of [...activities, ...refusals]) part.draw(state);
      setText(layout.notice, state.page.notice ? t(state.page.notice) : "");
      show(layout.undo, !!state.page.notice && !!state.page.undo);
    },
    end() {
      stop.abort();
      document.body.replaceChildren();
    },
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
