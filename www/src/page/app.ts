// Puts the parts together: one state, one draw.

import { type Aside, createAside } from "../core/aside";
import { Broken } from "../core/module";
import { createActions } from "../desk/actions";
import { createDerive } from "../desk/derive";
import { createDesk, isSettled } from "../desk/desk";
import { lastKnown, meant, type Seen } from "../desk/meaning";
import { createPractice } from "../desk/practice";
import { suited } from "../desk/program";
import { createEditorPlace } from "../editor/place";
import { keepHandbook } from "../handbook";
import { createJob, painted } from "../pace";
import { createScanner } from "../scan/scanner";
import { save } from "../state/keep";
import { machine, NOBODY, patched, type State } from "../state/state";
import { createStore, type Rest, type Store } from "../state/store";
import { type Flat, worked } from "../state/stored";
import { watchForUpdate } from "../state/update";
import { language } from "../texts";
import { showBroken } from "../views/broken";
import { createPointing, type Pointing } from "../views/pointing";
import { createStage } from "../views/stage";
import type { Catalogue } from "../wire";
import type { Work } from "./activities";
import { createBench, type Parts } from "./bench";
import { createCertain } from "./certain";
import { packedWork, startState } from "./first";
import { createGoToField, type Shows } from "./goto";
import { createKeeping, createNoticing } from "./keeping";
import { takeLaunch } from "./launch";
import { createModules, type Modules } from "./modules";
import { createOpen } from "./open";
import { keepPlaces } from "./places";
import { createRecorder } from "./recorder";
import { askRun, withMotions, withRun } from "./running";
import { createTabs } from "./tabs";
import { createWhere, firstPlace } from "./where";

/** Keeps the work and says so when something below breaks; every way into the core passes here. */
function guard<A extends unknown[], R>(store: () => Store, run: (...args: A) => R): (...args: A) => R | undefined {
  return (...args) => {
    try {
      return run(...args);
    } catch (problem) {
      save(store().state);
      if (!(problem instanceof Broken)) throw problem;
      showBroken(problem.message);
      return undefined;
    }
  };
}

/** `stored`: what was kept the last time; `returned`: to a tab that has its own work already. */
export async function startApp(stored: Flat | null, returned: boolean): Promise<void> {
  let answers = (): void => undefined; // before anything is drawn
  const modules = createModules(() => answers());
  const { catalogue } = modules;
  const calm = createCalm();
  void calm.comes.then(() => {
    void import("../styles/fonts.css").catch(console.error);
    afterLoad(() => {
      void watchForUpdate(store);
      setTimeout(() => void keepHandbook(), HANDBOOK_AFTER);
    });
  });
  const packed = packedWork();
  const framed = parent !== window && location.hash === "#framed";
  const place = packed ? "work" : firstPlace(stored);
  const example = !stored && !packed && place === "work"; // what it needs of the catalogue is there
  const first = patched(await startState(modules, stored, packed), { page: { place } });
  let draw = (): Rest | undefined => undefined;
  const guardedly = <R>(run: () => R): (() => R | undefined) => guard(() => store, run);
  const drawn = guardedly(() => {
    const rest = draw();
    return rest && guardedly(rest);
  });
  let tellFrame = (): void => undefined; // of an editor that shows the page
  const store = createStore(first, drawn, () => {
    keep();
    tellFrame();
  });
  const keep = createKeeping(store);
  const absent = (problem: unknown): void => {
    console.error(problem);
    modules.goWithout();
    store.update({ page: { notice: "outcome-absent" } });
  };
  const continuing = createTabs(store, !returned && !packed, work => startState(modules, work, null));
  const parts = { ...createParts(catalogue, store, modules, calm.comes, absent), continuing };
  draw = createDraw(parts, keep);
  answers = () => store.update({});
  answers();
  for (const leaving of ["focusin", "pointerdown", "drop"]) addEventListener(leaving, store.finish, true);
  await painted(); // the form stands
  setTimeout(calm.begin, PATIENCE);
  try {
    await (example ? modules.bring() : modules.full());
    store.update({});
    await painted(); // what the call comes to stands
    await modules.full();
    store.update({});
  } catch (problem) {
    absent(problem);
  }
  const takeFrame = async (): Promise<void> => {
    const { createFrame } = await import("./frame");
    tellFrame = createFrame(store, parts.actions, parts.open);
  };
  takeLaunch(store, parts.actions, parts.open);
  if (framed) void takeFrame();
  calm.begin();
}

const HANDBOOK_AFTER = 20_000; // ms: what the user waits for comes first, however slow the line
const PATIENCE = 1500; // ms that editor, stage and types wait for the first result

/** The time when form and result stand, and everything else may come. */
interface Calm {
  readonly comes: Promise<void>;
  begin(): void;
}

function createCalm(): Calm {
  let begin = (): void => undefined;
  const comes = new Promise<void>(resolve => {
    begin = resolve;
  });
  return { comes, begin };
}

/** All that a bench is made of; `calm`: then the larger parts of it may come; `absent`: the core does not. */
function createParts(
  catalogue: Catalogue,
  store: Store,
  modules: Modules,
  calm: Promise<void>,
  absent: (problem: unknown) => void,
): Omit<Parts, "continuing"> & { modules: Modules; pointing: Pointing } {
  const actions = guarded(
    createActions(store, catalogue, () => modules.program),
    store,
  );
  const work = createWork(store, modules);
  const editor = createEditorPlace(work.laying, calm, () => store.update({}));
  const { opening } = work;
  const pointing = createPointing(store);
  const shows = guard(() => store, createShows(store, modules));
  return {
    catalogue,
    store,
    actions,
    practice: guarded(
      createPractice(store, () => modules.program),
      store,
    ),
    modules,
    work,
    editor,
    open: createOpen({ full: modules.full, store, actions, opening, editor }, absent),
    scanner: createScanner(() => modules.program?.module, store),
    stage: createStage(store, pointing, calm),
    pointing,
    where: createWhere(store),
    goToField: createGoToField(catalogue, shows, store, actions),
  };
}

/** What would only hold up the page while it loads. */
function afterLoad(run: () => void): void {
  if (document.readyState === "complete") run();
  else addEventListener("load", run, { once: true });
}

function guarded<A extends object>(plain: A, store: Store): A {
  const actions = Object.entries(plain).map(([name, run]) => [
    name,
    guard(() => store, working(store, run as (...args: unknown[]) => unknown)),
  ]);
  return Object.fromEntries(actions) as unknown as A;
}

/** The work is changed now, if this changes it. */
function working<A extends unknown[], R>(store: Store, run: (...args: A) => R): (...args: A) => R {
  return (...args) => {
    const before = store.state;
    const result = run(...args);
    if (worked(before, store.state)) store.update({ page: { changed: Date.now(), others: NOBODY } });
    return result;
  };
}

function createWork(store: Store, modules: Modules): Work {
  const changed = (): void => store.update({});
  const aside = (): Aside => createAside(() => modules.program?.module, changed);
  return { reader: aside(), runner: aside(), judge: aside(), opening: createJob(changed), laying: createJob(changed) };
}

const createShows =
  (store: Store, modules: Modules): Shows =>
  ({ control, cycle }, values, name) => {
    const own = machine(patched(store.state, { form: { control } }));
    return modules.forms.form({ control, cycle, values, ...own }).fields.some(field => field.name === name);
  };

/** Whether somebody types values of the form, which shows everything else as it did. */
function isTyping(before: State | null, { form, panels, page, view }: State): boolean {
  return (
    form.values !== before?.form.values &&
    form.cycle === before?.form.cycle &&
    !form.open === !before.form.open && // what is typed moves the call
    panels === before.panels &&
    page.place === before.page.place &&
    view.source === before.view.source
  );
}

/** What is drawn follows from the state: first what the state itself becomes by it, then all that shows it. */
function createDraw(parts: Parts & { modules: Modules; pointing: Pointing }, keep: () => void): () => Rest | undefined {
  const { store, modules, editor, work } = parts;
  const { reader, runner, judge } = work;
  const certain = createCertain(judge);
  const derive = createDerive(() => modules.forms, parts.catalogue);
  const desk = createDesk(() => modules.program, reader, parts.catalogue);
  const settle = (state: State): State => {
    const read = desk(state);
    const next = suited(read, parts.catalogue);
    return next === read ? read : desk(next);
  };
  const notice = createNoticing(store);
  const record = createRecorder(state => !state.desk.held && (!modules.program || isSettled(state)));
  let bench = createBench(parts);
  let seen: Seen | null = null; // as it was drawn last
  let before: State | null = null;
  /** The page in the words that count now; everything stays where it was, once the new one is drawn. */
  const remade = (): (() => void) => {
    const [places, place] = [keepPlaces(), editor.editor?.keepPlace()];
    bench.end();
    bench = createBench(parts);
    return () => {
      places();
      place?.();
    };
  };
  return () => {
    const { follow } = store.state.desk;
    const typed = follow === "text";
    let state = store.settle(withRun(runner.take(), settle(store.state)));
    let derived = derive(state);
    const next = meant(seen, { state, derived }, modules.forms);
    if (next !== state) {
      state = store.settle(settle(next));
      derived = derive(state);
    }
    state = store.settle(record(state, typed));
    keep();
    seen = lastKnown(seen, { state, derived });
    askRun(work, state, derived);
    const back = bench.language === language() ? null : remade();
    const drawRest = bench.draw(state, certain(state, withMotions(derived, runner, state)));
    const rest = (): void => {
      drawRest();
      parts.pointing.draw(state);
      back?.();
      notice(state);
    };
    const later = !before || (!follow && !back && !state.desk.held && isTyping(before, state)); // the first form too
    before = state;
    if (later) return rest;
    rest();
    return undefined;
  };
}
