// Puts the parts together: one state, one draw.

import { type Answered, type Aside, createAside } from "../core/aside";
import type { Core, FormCore } from "../core/core";
import { Broken } from "../core/module";
import type { ProgramCore } from "../core/program";
import { type Actions, createActions } from "../desk/actions";
import { createDerive, type Derived, findCycle } from "../desk/derive";
import { createDesk } from "../desk/desk";
import { meant, type Seen } from "../desk/meaning";
import { isCurrent } from "../desk/program";
import { createEditorPlace } from "../editor/place";
import type { Encoding } from "../encoding";
import { unpack } from "../link";
import { createJob } from "../pace";
import { createScanner } from "../scan/scanner";
import { save } from "../state/keep";
import { firstState, machine, NO_ERRORS, type Patch, patched, remember, type State } from "../state/state";
import { createStore, type Store } from "../state/store";
import { type Flat, merge } from "../state/stored";
import { language, laterWords } from "../texts";
import { showBroken } from "../views/broken";
import { acceptDrops } from "../views/drop";
import { createStage } from "../views/stage";
import type { Catalogue, CycleInfo, RunView } from "../wire";
import { type Bench, createBench } from "./bench";
import { createGoToField, type Shows } from "./goto";
import { openProgramFile, openSetupFile, readAgain, refuseFolder } from "./open";
import { keepPlaces } from "./places";

const FIRST_OVERSIZE = 0.03; // mm: the part of the first visit is this much too big
const SAVE_AFTER = 200; // ms without a change
const NOTICE_SHOWN = 4000; // ms
const UNDO_SHOWN = 12_000; // ms; the key works longer

/** What shows most of what there is: the simulated measurement of a workpiece with the most variants. */
function firstCycle(catalogue: Catalogue): CycleInfo | undefined {
  const measured = catalogue.cycles.filter(
    ({ simulated, purpose }) => simulated && purpose.probe === "workpiece" && !purpose.calibrates,
  );
  return measured.sort((a, b) => b.variants.length - a.variants.length)[0] ?? catalogue.cycles[0];
}

/**
 * A worked measurement: the first cycle's example on a part that is a little too big, already written into the program.
 */
function firstVisit(core: Core, catalogue: Catalogue): State {
  const state = firstState();
  const cycle = firstCycle(catalogue);
  if (!cycle) return state;
  const errors = { ...NO_ERRORS, part: { ...NO_ERRORS.part, size: FIRST_OVERSIZE } };
  const { snippet } = core.form({ control: cycle.control, cycle: cycle.cycle, values: cycle.example, errors });
  return patched(state, {
    form: { control: cycle.control, cycle: cycle.cycle, values: cycle.example },
    part: { errors },
    program: { texts: { [cycle.control]: snippet } },
    desk: { sought: { from: 0, to: snippet.length } },
  });
}

async function startState(
  core: Core,
  full: () => Promise<ProgramCore>,
  catalogue: Catalogue,
  stored: Flat | null,
): Promise<State> {
  let state = stored ? merge(firstState(), stored) : firstVisit(core, catalogue);
  const packed = /^#s=(.+)$/.exec(location.hash)?.[1];
  if (packed) {
    state = merge(state, await unpack(packed));
    history.replaceState(null, "", location.pathname + location.search);
  }
  const known = (): boolean => !!findCycle(catalogue, state.form.control, state.form.cycle);
  if (!known()) await full().catch(console.error); // the first module knows the cycle of the first visit alone
  if (!known()) state = patched(state, remember(state), pickFirst(catalogue));
  if (!state.machine.setup) return state;
  return setupFits(await full(), state)
    ? state
    : patched(state, { machine: { setup: null }, page: { notice: "notice-setup-outdated" } });
}

/** A kept setup may come from an earlier version. */
function setupFits(core: ProgramCore, { form: { control, cycle }, machine: { setup } }: State): boolean {
  if (setup?.control !== control) return true;
  try {
    core.form({ control, cycle, values: {}, setup });
    return true;
  } catch {
    return false;
  }
}

function pickFirst(catalogue: Catalogue): Patch {
  const cycle = firstCycle(catalogue);
  return cycle ? { form: { control: cycle.control, cycle: cycle.cycle, values: cycle.example, open: null } } : {};
}

/** Keeps the work and says so when something below breaks; every way into the core passes here. */
function guard<A extends unknown[], R>(store: () => Store, run: (...args: A) => R): (...args: A) => R | undefined {
  return (...args) => {
    try {
      return run(...args);
    } catch (problem) {
      void save(store().state);
      if (!(problem instanceof Broken)) throw problem;
      showBroken(problem.message);
      return undefined;
    }
  };
}

/** `stored`: what was kept the last time. */
export async function startApp(core: Core, stored: Flat | null): Promise<void> {
  const catalogue = core.catalogue();
  let programCore: ProgramCore | null = null;
  let forms: FormCore = core;
  let came = (_: ProgramCore): void => undefined;
  const coming = new Promise<ProgramCore>(resolve => {
    came = resolve;
  });
  let fetching: Promise<ProgramCore> | null = null;
  const fetched = async (): Promise<ProgramCore> => {
    const [part] = await Promise.all([
      import("../core/program").then(module => module.loadProgramCore()),
      laterWords(),
    ]);
    forms = programCore = part;
    catalogue.cycles = part.catalogue().cycles;
    came(programCore);
    return programCore;
  };
  const full = (): Promise<ProgramCore> =>
    (fetching ??= fetched().catch((problem: unknown) => {
      fetching = null; // the next one who asks tries again
      throw problem;
    }));
  const derive = createDerive(() => forms, catalogue);
  let draw = (): void => undefined;
  const store = createStore(
    await startState(core, full, catalogue, stored),
    guard(
      () => store,
      () => draw(),
    ),
  );
  const aside = (): Aside =>
    createAside(
      () => programCore?.module,
      () => store.update({}),
    );
  const [reader, runner] = [aside(), aside()];
  const settle = createDesk(() => programCore, reader);
  const plain = createActions(store, catalogue);
  const actions = Object.fromEntries(
    Object.entries(plain).map(([name, run]) => [name, guard(() => store, run as (...args: unknown[]) => void)]),
  ) as unknown as Actions;

  const absent = (problem: unknown): void => {
    // the form goes on without
    console.error(problem);
    forms = { ...core, simulates: "no" };
    store.update({ page: { notice: "outcome-absent" } });
  };
  const shows: Shows = (cycle, values, name) =>
    forms
      .form({
        control: cycle.control,
        cycle: cycle.cycle,
        values,
        ...machine(patched(store.state, { form: { control: cycle.control } })),
      })
      .fields.some(field => field.name === name);
  const [opening, laying] = [createJob(() => store.update({})), createJob(() => store.update({}))];
  const editor = createEditorPlace(laying, () => store.update({}));
  const open = {
    program: (file: File): void => void openProgramFile(file, full, store, actions, opening, editor).catch(absent),
    again: (encoding: Encoding): void => void readAgain(encoding, store, actions, opening, editor),
    setup: (file: File): void => void openSetupFile(file, full, store, actions).catch(absent),
  };
  acceptDrops(open.program, open.setup, name => refuseFolder(name, store));
  const scanner = createScanner(() => programCore?.module, store);
  const stage = createStage(store);
  const makeBench = (): Bench =>
    createBench({
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
      core: () => programCore,
      alarms: coming.then(part => part.alarms()),
      goToField: createGoToField(
        catalogue,
        guard(() => store, shows),
        store,
        actions,
      ),
    });
  let bench = makeBench();
  /** The page in the words that count now; everything stays where it was, once the new one is drawn. */
  const remade = (): (() => void) => {
    const [places, place] = [keepPlaces(), editor.editor?.keepPlace()];
    bench.end();
    bench = makeBench();
    return () => {
      places();
      place?.();
    };
  };
  let seen: Seen | null = null; // as it was drawn last
  let noticed = "";
  let hiding = 0;
  let saving = 0;
  let warned = false;
  const keep = async (): Promise<void> => {
    if ((await save(store.state)) || warned) return;
    warned = true;
    store.update({ page: { notice: "notice-not-kept" } });
  };
  draw = () => {
    let state = store.settle(withRun(runner.take(), settle(store.state)));
    clearTimeout(saving);
    saving = window.setTimeout(() => void keep(), SAVE_AFTER); // sooner when the page goes or the core breaks
    let derived = derive(state);
    const next = meant(seen, { state, derived });
    if (next !== state) {
      state = store.settle(settle(next));
      derived = derive(state);
    }
    seen = { state, derived };
    run(runner, state, derived);
    const back = bench.language === language() ? null : remade();
    bench.draw(state, derived);
    back?.();
    if (state.page.notice === noticed) return;
    noticed = state.page.notice;
    clearTimeout(hiding);
    if (noticed)
      hiding = window.setTimeout(
        () => store.update({ page: { notice: "" } }),
        state.page.undo ? UNDO_SHOWN : NOTICE_SHOWN,
      );
  };
  addEventListener("pagehide", () => void save(store.state));
  store.update({});
  await new Promise(requestAnimationFrame); // the form stands
  try {
    await full();
    store.update({});
  } catch (problem) {
    absent(problem);
  }
}

/** Lets the program run on the opened machine, else on that of the form, while its motions are shown. */
function run(runner: Aside, state: State, { view, program: text }: Derived): void {
  const { control } = state.form;
  const { done: ran, stopped: stoppedRun } = state.run;
  if (state.view.source !== "program") return;
  const opened = state.machine.setup?.control === control ? state.machine.setup : undefined;
  const setup = opened ?? view.setup ?? machine(state).setup;
  const done = isCurrent(ran, state) && ran?.setup === setup;
  if (!done && !isCurrent(stoppedRun, state)) runner.want({ ask: "run", control, text, ...(setup ? { setup } : {}) });
}

function withRun(answered: Answered | null, state: State): State {
  if (answered?.question.ask !== "run" || !isCurrent(answered.question, state)) return state;
  const {
    question: { control, text, setup },
    json,
    scene,
    problem,
  } = answered;
  if (json === undefined || !scene) return patched(state, { run: { stopped: { control, text, why: problem ?? "" } } });
  return patched(state, { run: { done: { control, text, setup, view: JSON.parse(json) as RunView, scene } } });
}
