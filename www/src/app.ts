// Puts the parts together: one state, one draw.

import { createActions, type Actions } from "./actions";
import { Broken, type Core } from "./core";
import { createDerive, findCycle } from "./derive";
import { el, setText } from "./dom";
import { createLayout } from "./layout";
import { unpack } from "./link";
import { firstState, load, merge, NO_ERRORS, save, type State } from "./state";
import { createStore, type Store } from "./store";
import { t } from "./texts";
import { showBroken } from "./views/broken";
import { createForm } from "./views/form";
import { createHeader } from "./views/header";
import { createProgram } from "./views/program";
import { createResults } from "./views/results";
import { createScene } from "./views/scene";
import { createSliders } from "./views/sliders";
import { createTasks } from "./views/tasks";
import type { Catalogue } from "./wire";

const FIRST_OVERSIZE = 0.03; // mm: the part of the first visit is this much too big
const SAVE_AFTER = 200; // ms without a change

/** A worked measurement: the first cycle's example on a part that is a little too big, already written into the program. */
function firstVisit(core: Core, catalogue: Catalogue): State {
  const state = firstState();
  const cycle = catalogue.cycles[0];
  if (!cycle) return state;
  const errors = { ...NO_ERRORS, part: { ...NO_ERRORS.part, size: FIRST_OVERSIZE } };
  const { snippet } = core.form({ control: cycle.control, cycle: cycle.cycle, values: cycle.example, errors });
  return { ...state, control: cycle.control, cycle: cycle.cycle, values: cycle.example, errors, programs: { [cycle.control]: snippet }, open: 0 };
}

async function startState(core: Core, catalogue: Catalogue): Promise<State> {
  const stored = load();
  let state = stored ? merge(firstState(), stored) : firstVisit(core, catalogue);
  const packed = /^#s=(.+)$/.exec(location.hash)?.[1];
  if (packed) {
    state = merge(state, await unpack(packed));
    history.replaceState(null, "", location.pathname + location.search);
  }
  return findCycle(catalogue, state.control, state.cycle) ? state : { ...state, ...pickFirst(catalogue) };
}

function pickFirst(catalogue: Catalogue): Partial<State> {
  const cycle = catalogue.cycles[0];
  return cycle ? { control: cycle.control, cycle: cycle.cycle, values: cycle.example, open: null } : {};
}

/** Keeps the work and says so when something below breaks; every way into the core passes here. */
function guard<A extends unknown[]>(store: () => Store, run: (...args: A) => void): (...args: A) => void {
  return (...args) => {
    try {
      run(...args);
    } catch (problem) {
      save(store().state);
      if (problem instanceof Broken) showBroken(problem.message);
      else throw problem;
    }
  };
}

export async function startApp(core: Core): Promise<void> {
  const catalogue = core.catalogue();
  const derive = createDerive(core, catalogue);
  let draw = (): void => undefined;
  const store = createStore(await startState(core, catalogue), guard(() => store, () => draw()));
  const plain = createActions(store, core, catalogue);
  const actions = Object.fromEntries(Object.entries(plain).map(([name, run]) => [name, guard(() => store, run as (...args: unknown[]) => void)])) as unknown as Actions;

  const layout = createLayout(actions);
  const { panels } = layout;
  const results = el("div", { class: "results-main" });
  const sliders = el("aside", { class: "sliders", "aria-label": t("sliders-title") });
  panels.results.append(results, sliders);
  const program = createProgram(panels.program, store, actions);
  const goToLine = (line: number): void => program.goTo(lineStart(store.state.programs[store.state.control] ?? "", line));
  const views = [
    createHeader(layout.header, store), createTasks(panels.tasks, store, actions), createForm(panels.form, store, actions),
    program.draw, createScene(panels.view, store, goToLine), createResults(results, store, actions, program.goTo), createSliders(sliders, store, actions),
  ];
  let noticed = 0;
  let saving = 0;
  let warned = false;
  const keep = (): void => {
    if (save(store.state) || warned) return;
    warned = true;
    store.update({ notice: "notice-not-kept" });
  };
  draw = () => {
    const state = store.state;
    clearTimeout(saving);
    saving = window.setTimeout(keep, SAVE_AFTER); // sooner when the page goes or the core breaks
    const derived = derive(state);
    layout.draw(state);
    for (const view of views) view(state, derived);
    setText(layout.notice, state.notice ? t(state.notice) : "");
    clearTimeout(noticed);
    if (state.notice) noticed = window.setTimeout(() => store.update({ notice: "" }), 4000);
  };
  addEventListener("pagehide", () => save(store.state));
  store.update({});
}

function lineStart(text: string, line: number): number {
  let at = 0;
  for (let count = 1; count < line; count++) {
    const next = text.indexOf("\n", at);
    if (next < 0) break;
    at = next + 1;
  }
  return at;
}
