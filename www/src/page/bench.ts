// Everything to be seen, in the language that counts when it is made. Another language: another bench, from the same
// state.

import type { ProgramCore, ProgramQuestion } from "../core/program";
import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { givenTo, machineTo } from "../desk/given";
import type { Practice } from "../desk/practice";
import { el, on, setText, show } from "../dom";
import type { EditorPlace } from "../editor/place";
import { listenToGuides } from "../guide";
import { icon } from "../icons";
import type { Scanner } from "../scan/scanner";
import { machine as machineIn, type State } from "../state/state";
import type { Rest, Store } from "../state/store";
import { language, t } from "../texts";
import { behind } from "../views/behind";
import { createCard } from "../views/card";
import { createCoach } from "../views/coach";
import { type Choices, createContinuing } from "../views/continuing";
import { createDefine } from "../views/define";
import { createForm } from "../views/form";
import { createFound } from "../views/found";
import { createHeader } from "../views/header";
import { createKeys } from "../views/keys";
import { createNewer } from "../views/newer";
import { createSetupFile, exportSetup } from "../views/profile";
import { createProgram } from "../views/program";
import { createRefusal } from "../views/refusal";
import { createScene } from "../views/scene";
import { createSets } from "../views/sets";
import { createSliders } from "../views/sliders";
import type { Stage } from "../views/stage";
import { createTasks } from "../views/tasks";
import { createTold } from "../views/told";
import type { Catalogue, Dialect } from "../wire";
import { createActivities, type Work } from "./activities";
import { commandsOf } from "./commands";
import { createLayout } from "./layout";
import type { Modules } from "./modules";
import type { Open } from "./open";
import { createPracticePlace } from "./practice";
import { railButton } from "./rail";
import { createScenariosWay } from "./scenarios";
import { listenToKeys } from "./shortcuts";
import { createStartPlace } from "./start";
import { showKeys } from "./tips";
import type { Where } from "./where";

/** What outlives a bench. */
export interface Parts {
  catalogue: Catalogue;
  store: Store;
  actions: Actions;
  practice: Practice;
  open: Open;
  work: Work;
  editor: EditorPlace;
  stage: Stage;
  where: Where;
  scanner: Scanner;
  continuing: Choices;
  goToField(control: Dialect, name: string): void;
  modules: Pick<Modules, "program" | "alarms" | "elsewhere" | "full">;
}

export interface Bench {
  readonly language: string;
  /** Draws what stands where and the form; gives back what draws the rest. */
  draw(state: State, derived: Derived): Rest;
  end(): void;
}

export function createBench(parts: Parts): Bench {
  const { store, actions, open, stage, scanner } = parts;
  const core = () => parts.modules.program;
  const stop = new AbortController();
  const layout = createLayout(actions, sizes => store.update({ panels: { sizes } }));
  const { panels } = layout;
  const results = el("div", { class: "results-main" });
  panels.results.append(results);
  const sliders = el("aside", { class: "sliders", id: "sliders", "aria-label": t("sliders-title") });
  const errors = el(
    "button",
    { type: "button", class: "errors-open", "aria-controls": "sliders", title: t("sliders-open-help") },
    icon("settings"),
    t("sliders-open"),
  );
  const scene = el("div", { class: "view-main" });
  panels.view.append(scene, sliders);
  const chain = el("div", { class: "chain" }); // of the form
  const define = createDefine(store, actions, core);
  document.body.append(define.dialog);
  const told = createTold(core, () => store.state);
  const program = createProgram(panels.program, store, actions, open, parts.editor, name => define.open(name), told);
  const activities = createActivities(store, parts.work);
  const refusals = [
    createRefusal(store, "program", actions.openUnder),
    createRefusal(store, "setup", actions.openUnder),
  ] as const;
  const newer = createNewer(store);
  const sets = createSets(actions);
  const card = createCard(actions);
  const keys = createKeys();
  const continuing = createContinuing(parts.continuing, stop.signal);
  document.body.append(sets.dialog, card.dialog, keys, continuing.dialog);
  const found = (back: () => void) =>
    createFound(parts.catalogue, parts.modules, store, actions, parts.goToField, back);
  const { file, text, calls, motions } = activities;
  program.head.after(refusals[0].root, file.root, text.root, calls.root);
  layout.header.after(refusals[1].root, newer.root);
  listenToKeys(
    {
      save: program.save,
      open: program.open,
      undo: () => actions.step(1),
      redo: () => actions.step(-1),
      keys: () => keys.showModal(),
      palette: () => later()?.openPalette(),
      "next-panel": () => layout.step(1),
      "previous-panel": () => layout.step(-1),
    },
    stop.signal,
  );
  const coach = createCoach(actions);
  layout.header.after(coach.root);
  const start = createStartPlace(layout, parts, program.open, stop.signal);
  const practice = createPracticePlace(layout, parts, stop.signal);
  showKeys(stop.signal);
  let shown: { state: State; derived: Derived } | null = null;
  const setupFile = createSetupFile(open.setup);
  const scenarios = createScenariosWay(parts.modules, () => shown, stop.signal);
  const checkMachine = (): void => {
    void import("../views/machine-check").then(({ openMachineCheck }) => openMachineCheck(core, stop.signal));
  };
  const repeat = (): void => {
    const [now, has] = [shown, core()];
    if (!now || !has) return;
    const setup = machineTo(now.state, now.derived.view);
    void import("../views/repeat").then(({ openRepeat }) => openRepeat(has, setup, stop.signal));
  };
  /** A dialog that asks the core, as soon as there is one. */
  const withCore = (open: (has: ProgramCore) => Promise<void>): void => {
    const has = core();
    if (has) void open(has);
  };
  const userPrograms = (): void =>
    withCore(async has => (await import("../views/user-programs")).openUserPrograms(has, stop.signal));
  const definitions = (): void =>
    withCore(async has => {
      const ofMachine = { setup: () => machineIn(store.state), take: actions.data };
      (await import("../views/definitions")).openDefinitions(has, ofMachine, stop.signal);
    });
  const commissioning = (connection?: string): void =>
    withCore(async has => {
      const setup = shown ? machineTo(shown.state, shown.derived.view) : undefined;
      (await import("../views/commissioning")).openCommissioning(has, store, setup, stop.signal, connection);
    });
  const go = (way: string): void => {
    const all = shown ? commands(shown.derived) : [];
    all.find(({ id }) => id === way)?.run();
  };
  const explain = (page?: string): void =>
    withCore(async has => (await import("../views/terms")).openTerms(has, stop.signal, go, page));
  const terms = (concept?: string): void => explain(concept && `concept-${concept}`);
  listenToGuides(key => (key.startsWith("connection-") ? commissioning(key) : explain(key)), stop.signal);
  const asked = (): ProgramQuestion | null => {
    if (!shown) return null;
    const { state, derived } = shown;
    const { known: _, arguments: __, strict: ___, mode: ____, target: _____, file: ______, ...given } = givenTo(state);
    const setup = machineTo(state, derived.view);
    return { control: state.form.control, text: derived.program, ...(setup && { setup }), ...given };
  };
  const series = (): void => {
    const [program, has] = [asked(), core()];
    if (!program || !has) return;
    void import("../views/series").then(({ openSeries }) => openSeries(has, program, stop.signal));
  };
  const commands = commandsOf(store, actions, {
    save: program.save,
    open: program.open,
    keys: () => keys.showModal(),
    machine: () => later()?.equipment.open(),
    machineData: () => later()?.machineData.open(),
    machineCheck: checkMachine,
    repeat,
    userPrograms,
    definitions,
    terms,
    commissioning,
    series,
    importSetup: () => setupFile.click(),
    exportSetup: () => exportSetup(store, shown?.derived.view.setup),
    paper: which => void later()?.paper(which),
    practise: practice.go,
    scenarios: scenarios.open,
    check: scenarios.check,
  });
  const later = behind(
    pieces => {
      pieces.createSheet(stage, () => shown, stop.signal);
      const ways = { check: checkMachine, repeat, userPrograms, definitions, commissioning };
      const machineData = pieces.createMachineData(store, actions, core, ways);
      const difference = pieces.createDifference(actions);
      const palette = pieces.createPalette(
        store,
        actions,
        {
          catalogue: parts.catalogue,
          tables: parts.modules,
          core,
          commands,
          goTo: program.goTo,
          goToLine: program.goToLine,
          goToField: parts.goToField,
          machineData: words => later()?.machineData.open(words),
        },
        () => shown?.derived ?? null,
      );
      document.body.append(difference.dialog, palette.dialog);
      const paper = pieces.createPaper(core, () => shown, stage, stop.signal);
      return {
        paper,
        drawResults: pieces.createResults(
          results,
          layout.answer,
          store,
          actions,
          scanner,
          program.goTo,
          program.goToLine,
          { pickFiles: program.pickFiles, machineValues: () => machineData.open("", true) },
          {
            paper: (which, made) => void paper(which, made),
            series,
            program: asked,
            core,
            arrows(all) {
              stage.arrows = all;
              store.update({});
            },
          },
        ),
        drawChain: pieces.createChain(chain, store, actions),
        drawDifference: difference.draw,
        openPalette: palette.open,
        drawHelp: pieces.createHelp(panels.help, store, actions, core, terms),
        machineData,
        equipment: pieces.createEquipment(store, actions, core, machineData),
      };
    },
    () => store.update({}),
    stop.signal,
  );
  const drawForm = createForm(
    panels.form,
    store,
    actions,
    chain,
    () => sets.dialog.showModal(),
    program.goToLine,
    practice.call,
    terms,
  );
  const machine = railButton(t("facts"), "machine", { class: "rail-machine", "aria-haspopup": "dialog" });
  on(machine, "click", () => later()?.equipment.open());
  layout.rail.querySelector('[data-panel-button="help"]')?.before(machine);
  const views = [
    createHeader(
      layout.header,
      store,
      actions,
      setupFile,
      core,
      later,
      keys,
      program,
      { practise: practice.go, scenarios },
      stop.signal,
    ),
    start.drawButton,
    coach.draw,
    createScene(scene, store, program.goToLine, stage),
    (state: State, derived: Derived): void => later()?.drawDifference(state, derived),
    (state: State): void => later()?.equipment.draw(state),
    sets.draw,
    card.draw,
    continuing.draw,
  ];
  /** What the machine to practise on hides. */
  const atWork = [
    createTasks(panels.tasks, store, actions, found),
    (state: State, derived: Derived): void => later()?.drawChain(state, derived),
    (state: State, derived: Derived): void => later()?.drawResults(state, derived),
    createSliders(sliders, errors, store, actions),
    (state: State, derived: Derived): void => later()?.drawHelp(state, derived),
    program.draw, // last: the editor asks for the selection, and that lays out the page
  ];
  scene.append(motions.root);
  scene.querySelector(".segments")?.after(errors);
  return {
    language: language(),
    draw(state, derived) {
      shown = { state, derived };
      layout.draw(state);
      start.draw(state, derived);
      const work = state.page.place !== "jog";
      if (work) drawForm(state, derived);
      return () => {
        for (const view of work ? [...views, ...atWork] : views) view(state, derived);
        practice.draw(state, derived);
        for (const part of [...Object.values(activities), ...refusals, newer]) part.draw(state);
        setText(layout.notice, state.page.notice ? t(state.page.notice) : "");
        show(layout.undo, !!state.page.notice && state.page.offer);
      };
    },
    end() {
      stop.abort();
      document.body.replaceChildren();
    },
  };
}
