// Everything that can happen. Views call these; only these change what is kept.

import type { ProgramCore } from "../core/program";
import type { Encoding } from "../encoding";
import { lineBreak, type Splice } from "../eol";
import { NO_ERRORS } from "../errors";
import { speak } from "../language";
import { type BesideFile, fileOf, openedNow, type ProgramFile } from "../state/files";
import { stepped } from "../state/history";
import { withMark } from "../state/saved";
import {
  AT_END,
  asWritten,
  beginning,
  type Card,
  firstState,
  memoryKey,
  NOBODY,
  ownMachine,
  type Panel,
  type Patch,
  PLANES,
  patched,
  planeOf,
  profile,
  programMachine,
  programOf,
  remember,
  type Sheet,
  type State,
  setsOf,
  unitsIn,
} from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import type {
  Catalogue,
  CycleInfo,
  Diagnostic,
  Dialect,
  Edit,
  ErrorSliders,
  MachineView,
  Message,
  Offer,
  OwnMachine,
  Plane,
  RunMode,
  Setup,
  Style,
  TouchedLine,
} from "../wire";
import { sameName } from "./beside";
import { opened } from "./calls";
import { aroundAt, type Derived, findCycle } from "./derive";
import { asBegun, equipped, errorsOf, freeName, used } from "./equipped";
import { isRead, withEdits } from "./program";
import { STEPS } from "./story";
import {
  agreed,
  declined,
  mended,
  proposed,
  refused,
  replacing,
  typedIn,
  typedShown,
  withoutReplacing,
} from "./typing";

/** A file that was read; `mark`: of what it holds, null: that is not known. */
export interface Opened {
  text: string;
  file: ProgramFile;
  mark: string | null;
}

export type Variant = CycleInfo["variants"][number];

export interface Actions {
  chooseCycle(cycle: CycleInfo, variant?: Variant): void;
  /**
   * A form of its own for this variant: its worked measurement, with these values instead. On a first visit, while
   * nothing is anybody's work, its part lies off, so that there is something to correct.
   */
  measure(cycle: CycleInfo, variant: Variant, values: Record<string, string>): void;
  /**
   * The worked example is told of a variant that corrects a zero offset: `told` is the program of its values. The part
   * lies off.
   */
  tell(cycle: CycleInfo, variant: Variant, values: Record<string, string>, told: (state: State) => string): void;
  /** To a step of it, from 1; 0: it ends, and what it opened stays. */
  story(step: number): void;
  edit(name: string, value: string): void;
  touch(name: string): void;
  check(): void;
  example(variant: Variant | undefined): void;
  editProgram(edits: Splice[]): void;
  /** `mark`: of what the file holds; null: that is not known. */
  openProgram(text: string, file: ProgramFile, mark: string | null, beside?: readonly Opened[]): void;
  /** Files that lie beside the program from now on; one of the same name takes the place of that one. */
  putBeside(files: readonly Opened[]): void;
  /** A file beside the program is shown and run; what was shown lies beside it. */
  showFile(name: string): void;
  removeFile(name: string): void;
  /** The definitions of a file beside the program become part of the machine. */
  define(name: string): void;
  /** A value for a parameter of the program's own PROC, as typed. */
  argument(name: string, value: string): void;
  /** Whether what is not there stops the run. */
  strict(on: boolean): void;
  /** `target`: line up to which a block search goes. */
  mode(mode: RunMode, target: number): void;
  /** Which program of a text that holds several is run; empty: the first. */
  main(name: string): void;
  /** A value that only the machine has; null: it is assumed again. */
  machineValue(name: string, value: number | string | null): void;
  /** The program is saved in another encoding from now on. */
  encoding(encoding: Encoding): void;
  /** The file that was opened then holds what has this mark. */
  saved(control: Dialect, opened: number | undefined, mark: string): void;
  /** A profile is used from now on; null: the core's own machine. The one before stays among the others. */
  openSetup(setup: Setup | null): void;
  /** The form and the program of a control, as they were. */
  chooseControl(control: Dialect): void;
  /** One of the other profiles. */
  chooseProfile(setup: Setup): void;
  /** The profile in use is otherwise: what was done to it. */
  equip(setup: Setup, told: Message): void;
  /** A profile of the core's own machine, and it is used. */
  newProfile(): void;
  /** The profile in use once more, under another name. */
  duplicateProfile(): void;
  /** Takes the profile in use away. */
  deleteProfile(): void;
  cursor(offset: number, line: number): void;
  openCall(index: number): void;
  closeCall(): void;
  /** Way of writing of the snippet; empty: as the machine has it. */
  style(style: State["snippet"]["style"]): void;
  /** The call in the form, in the program, in another way of writing; or all calls. It is shown before it is done. */
  convert(style: Style, all?: boolean): void;
  /** The edits that a finding of the present program proposes; shown before they are made where they reach further. */
  cure(edits: Edit[], elsewhere?: TouchedLine[]): void;
  /** What cures all findings like this one; it is shown before it is done. */
  cureAll(like: Diagnostic): void;
  /** What is shown is done. */
  apply(): void;
  /** It is not. */
  discard(): void;
  /** What was typed and changes more than its own value is shown. */
  show(): void;
  /** It is not, and the form shows again what the program holds. */
  refuse(): void;
  /** That the variable by its place in the expression of a field is assigned so that the value comes true is shown. */
  assign(name: string, variable: number): void;
  /** The value of the field takes the place of the expression. */
  replaceHere(name: string): void;
  /** The expression stays. */
  keep(name: string): void;
  card(card: Card | null): void;
  insert(snippet: string): void;
  /** A block around the call is wanted from now on, and the blocks are shown. */
  around(name: string): void;
  /** A call is inserted, with the lines before it, and comes into the form. */
  write(cycle: string, values: Record<string, string>, text: string): void;
  error<G extends keyof ErrorSliders>(group: G, name: keyof ErrorSliders[G], value: number): void;
  begin(machine: OwnMachine["own"]): void;
  /** What the machine is built for, what differs in its data, and lines of its definition files; without: as before. */
  data(machine: Pick<MachineView, "basic" | "data">, definitions?: string[]): void;
  /** The machine gets what it lacks. */
  give(offer: Offer): void;
  noErrors(): void;
  panel(panel: Panel): void;
  /** How far the dock of a tablet is drawn up. */
  sheet(sheet: Sheet): void;
  /** Shows the help page of the variant in the form, or closes it. */
  help(): void;
  saveSet(name: string): void;
  loadSet(name: string): void;
  /** false: the name is taken, or it is none. */
  renameSet(name: string, next: string): boolean;
  deleteSet(name: string): void;
  /** So many steps back; forth where it is negative. */
  step(back: number): void;
  /** The page in another language, as soon as its words are there. */
  speak(language: string): void;
}

/** How far the part of a first visit lies off, mm. */
const LIES_OFF = { dx: 0.084, dy: -0.046 };

const LEFT: Panel[] = ["tasks", "form"];

/** The variant that the typed values choose. */
export function variantOf({ cycle, view }: Derived): Variant | undefined {
  return cycle.variants.find(one => one.mvar === view.mvar);
}

/** A variant with the addresses that it has in this plane. */
export function inPlane(variant: Variant, plane: Plane): Variant {
  return { ...variant, ...variant.planes[plane] };
}

/**
 * The core's own machine becomes one of the other sort with its usual plane, where the task is for another sort than
 * the last one on its control.
 */
function planeFor(state: State, { control, purpose: { plane } }: CycleInfo): Patch {
  const [usual] = PLANES;
  if (!plane || (state.machine.suits[control] ?? usual) === plane) return {};
  const own = ownMachine(patched(state, { form: { control } }));
  return {
    machine: {
      suits: { ...state.machine.suits, [control]: plane },
      own: { ...state.machine.own, [control]: { own: { ...own, plane } } },
    },
  };
}

/** The sort of machine that was last chosen for, told by its usual plane. */
function suits({ form: { control }, machine }: State, plane: Plane): Patch {
  return { machine: { suits: { ...machine.suits, [control]: plane } } };
}

/** The worked measurement of the cycle, with the addresses of the plane. */
function exampleOf(cycle: CycleInfo, plane: Plane): Record<string, string> {
  const own = cycle.variants.find(({ example }) =>
    Object.entries(cycle.example).every(([name, value]) => example[name] === value),
  );
  return own ? inPlane(own, plane).example : cycle.example;
}

/** Whether the worked measurement of a variant is still as it was: then another variant brings its own. */
export function isExample(cycle: CycleInfo, values: Record<string, string>, plane: Plane): boolean {
  return cycle.variants.some(variant =>
    Object.entries(inPlane(variant, plane).example).every(([name, value]) => (values[name] ?? "") === value),
  );
}

/** The worked measurement with the addresses of another plane, where the form holds one as it is. */
function turned(cycle: CycleInfo | undefined, state: State, plane: Plane): Patch {
  const { values, open } = state.form;
  const { sought } = state.desk;
  const filled = (all: Record<string, string>): string =>
    JSON.stringify(
      Object.entries(all)
        .filter(([, value]) => value)
        .sort(),
    );
  const held = cycle?.variants.find(one => filled(inPlane(one, planeOf(state)).example) === filled(values));
  return held && open === null && sought === null ? { form: { values: inPlane(held, plane).example } } : {};
}

export function createActions(store: Store, catalogue: Catalogue, core: () => ProgramCore | null): Actions {
  const now = (): State => store.state;

  /** A change that takes work away: it is said, and can be undone beside that. */
  const replace = (notice: string, ...patches: Patch[]): void => {
    store.update(...patches, { page: { notice, offer: true } });
    store.flush(); // editor and form have to hold it before the next key
  };

  const edits = (pairs: [string, string][]): void =>
    store.update(state =>
      patched(typedIn(state, pairs), { form: { edits: state.form.edits + 1 }, page: { offer: false } }),
    );

  const withSets = (sets: Record<string, Record<string, string>>): Patch => ({
    form: { sets: { ...now().form.sets, [memoryKey(now().form)]: sets } },
  });

  const actions: Actions = {
    chooseCycle(cycle, chosen) {
      const state = now();
      const same = cycle.control === state.form.control && cycle.cycle === state.form.cycle;
      const suited = planeFor(state, cycle);
      const plane = planeOf(
        same ? state : patched(state, suited, { form: { control: cycle.control, open: null, around: null } }),
      );
      const variant = chosen && inPlane(chosen, plane);
      if (same && variant)
        return edits(Object.entries(isExample(cycle, state.form.values, plane) ? variant.example : variant.values));
      const values = same
        ? state.form.values
        : (state.form.remembered[memoryKey(cycle)] ?? variant?.example ?? exampleOf(cycle, plane));
      store.update(remember(state), suited, {
        form: {
          control: cycle.control,
          cycle: cycle.cycle,
          values: { ...values, ...variant?.values },
          open: same ? state.form.open : null,
          around: same ? state.form.around : null,
          resets: {},
          touched: {},
          checked: false,
        },
        desk: { sought: null },
        view: { step: AT_END, source: "form" },
        page: { offer: false },
      });
    },
    measure(cycle, chosen, given) {
      const state = now();
      const suited = planeFor(state, cycle);
      const own: Patch = { form: { control: cycle.control, open: null, around: null } };
      const { example } = inPlane(chosen, planeOf(patched(state, suited, own)));
      const { errors } = state.part;
      const lies: Patch =
        state.page.changed === 0 ? { part: { errors: { ...errors, part: { ...errors.part, ...LIES_OFF } } } } : {};
      store.update(remember(state), suited, own, lies, {
        form: { cycle: cycle.cycle, values: { ...example, ...given }, resets: {}, touched: {}, checked: false },
        desk: { sought: null },
        view: { step: AT_END, source: "form" },
        panels: { panel: "form", left: "form" },
        page: { offer: false },
      });
    },
    tell(cycle, chosen, given, told) {
      actions.measure(cycle, chosen, given);
      store.update({ part: { errors: { ...NO_ERRORS, part: { ...NO_ERRORS.part, ...LIES_OFF } } } });
      const { control } = cycle;
      const file: ProgramFile = { name: t(`program-file-${control}`), encoding: "utf-8", opened: openedNow() };
      actions.openProgram(told(now()), file, null);
      store.update({ desk: { sought: { call: 0 } }, page: { notice: "" } });
      actions.story(1);
    },
    story(step) {
      const telling = STEPS[step - 1];
      if (telling) store.update({ page: { story: step } }, telling.show);
      else store.update({ page: { story: 0, notice: "notice-story-left", offer: true }, view: { playing: false } });
    },
    edit: (name, value) => edits([[name, value]]),
    touch(name) {
      if (!now().form.touched[name]) store.update({ form: { touched: { ...now().form.touched, [name]: true } } });
    },
    check: () => store.update({ form: { checked: true } }),
    example(variant) {
      const cycle = findCycle(catalogue, now().form.control, now().form.cycle);
      if (cycle)
        replace("notice-example", {
          form: {
            values: variant ? inPlane(variant, planeOf(now())).example : exampleOf(cycle, planeOf(now())),
            open: null,
            resets: {},
            touched: {},
            checked: false,
          },
          desk: { sought: null },
          view: { step: AT_END },
        });
    },
    editProgram: edits =>
      store.update(state => patched(withEdits(state, edits), { desk: { follow: "text" }, page: { offer: false } })),
    openProgram(text, file, mark, more = []) {
      const { control } = now().form;
      const { texts: programs, files, beside } = now().program;
      const { pending } = now().desk;
      const others = withFiles(beside[control], more).filter(one => !sameName(one.name, file.name));
      const marks = [...more, { file, mark }];
      const marked = marks.reduce(
        (state, one) => patched(state, withMark(state, control, one.file.opened, one.mark)),
        now(),
      );
      replace(
        text ? "notice-opened" : "notice-opened-empty",
        { program: { saved: marked.program.saved } },
        {
          program: {
            texts: { ...programs, [control]: text },
            files: { ...files, [control]: file },
            beside: { ...beside, [control]: others },
            stoppedReading: null,
            reading: null,
            cursor: 0,
            line: 1,
          },
          desk: { pending: pending.filter(one => one.control !== control), sought: null },
          form: { open: null },
          run: { done: null, stopped: null },
          page: { refused: null },
        },
      );
    },
    putBeside(more) {
      const { control } = now().form;
      const { beside } = now().program;
      const marked = more.reduce(
        (state, { file, mark }) => patched(state, withMark(state, control, file.opened, mark)),
        now(),
      );
      replace(
        "notice-beside",
        { program: { saved: marked.program.saved } },
        besideAnew({
          ...beside,
          [control]: withFiles(beside[control], more),
        }),
      );
    },
    showFile(name) {
      store.flush(); // what was typed last belongs to the file that is left
      const state = now();
      const { control } = state.form;
      const { texts, files, beside } = state.program;
      const all = beside[control] ?? [];
      const wanted = all.find(one => sameName(one.name, name));
      if (!wanted) return;
      const { text, ...file } = wanted;
      const left = programOf(state);
      const others = all.flatMap(one => (one !== wanted ? [one] : left ? [{ ...fileOf(state), text: left }] : []));
      store.update(besideAnew({ ...beside, [control]: others }), {
        program: {
          texts: { ...texts, [control]: text },
          files: { ...files, [control]: file },
          reading: null,
          cursor: 0,
          line: 1,
        },
        desk: { pending: state.desk.pending.filter(one => one.control !== control), sought: null },
        form: { open: null },
        run: { done: null, stopped: null },
        page: { offer: false },
      });
      store.flush(); // the editor has to hold it before the next key
    },
    removeFile(name) {
      const { control } = now().form;
      const { beside } = now().program;
      const left = (beside[control] ?? []).filter(one => !sameName(one.name, name));
      replace("notice-beside-removed", besideAnew({ ...beside, [control]: left }));
    },
    define(name) {
      const state = now();
      const { control } = state.form;
      const file = state.program.beside[control]?.find(one => sameName(one.name, name));
      const request = { control, ...programMachine(state), change: { define: file?.text ?? "" } };
      const view = file && core()?.equip(request);
      if (!view) return; // the module is still on its way
      actions.equip(view.setup, { key: "step-define", args: { file: name } });
      const left = (state.program.beside[control] ?? []).filter(one => one !== file);
      replace("notice-defined", besideAnew({ ...state.program.beside, [control]: left }));
    },
    argument(name, value) {
      const { control } = now().form;
      const { given } = now().program;
      const { [name]: _, ...others } = given[control] ?? {};
      const values = value.trim() ? { ...others, [name]: value } : others;
      store.update({
        program: { given: { ...given, [control]: values } },
        run: { stopped: null },
        page: { offer: false },
      });
    },
    strict: strict => store.update({ run: { strict, stopped: null } }),
    mode: (mode, target) => store.update({ run: { mode, target, stopped: null } }),
    main: main => store.update({ run: { main, stopped: null } }),
    machineValue(name, value) {
      const setup = profile(now());
      const own = ownMachine(now());
      const { [name]: _, ...others } = (setup ? setup.data : own.data) ?? {};
      const data = value === null ? others : { ...others, [name]: value };
      const { control } = now().form;
      const machine: Patch["machine"] = setup
        ? used(now(), { ...setup, data })
        : { own: { ...now().machine.own, [control]: { own: { ...own, data } } } };
      const told: Message = { key: "step-machine-value", args: { name } };
      store.update({ machine: { ...machine, told }, run: { stopped: null }, page: { offer: false } });
    },
    encoding: encoding =>
      store.update(state => ({
        program: { files: { ...state.program.files, [state.form.control]: { ...fileOf(state), encoding } } },
        page: { offer: false },
      })),
    saved: (control, opened, mark) => store.update(state => withMark(state, control, opened, mark)),
    openSetup(setup) {
      const { control, remembered } = now().form;
      const cycle = catalogue.cycles.find(one => one.control === setup?.control);
      const values = cycle && (remembered[memoryKey(cycle)] ?? cycle.example);
      const other: Patch =
        setup && cycle && values && setup.control !== control
          ? {
              form: { control: setup.control, cycle: cycle.cycle, values, open: null, around: null, touched: {} },
              desk: { sought: null },
            }
          : {};
      replace(setup ? "notice-setup" : "notice-own-setup", remember(now()), other, {
        machine: inUse(now(), setup?.control ?? control, setup),
        ...(setup ? { part: { errors: errorsOf(setup, catalogue.applicate) } } : {}),
        view: { step: AT_END },
        page: { refused: null },
      });
    },
    chooseControl(control) {
      const state = now();
      if (control === state.form.control) return;
      const known = findCycle(catalogue, control, state.machine.before[control] ?? "");
      const cycle = known ?? catalogue.cycles.find(one => one.control === control);
      if (!cycle) return;
      actions.chooseCycle(cycle);
      store.update({ machine: { before: { ...state.machine.before, [state.form.control]: state.form.cycle } } });
    },
    chooseProfile(setup) {
      actions.chooseControl(setup.control);
      actions.openSetup(setup);
    },
    equip(setup, told) {
      store.update(equipped(now(), setup, told, catalogue), { page: { offer: false } });
    },
    newProfile() {
      const { control } = now().form;
      const view = core()?.equip({ control, setup: { own: ownMachine(now()) } });
      if (!view) return; // the module is still on its way
      const setup = { ...view.setup, name: freeName(now(), t("profile-new")) };
      replace("notice-profile-new", { machine: inUse(now(), control, setup), view: { step: AT_END } });
    },
    duplicateProfile() {
      const setup = profile(now());
      if (!setup) return;
      const name = freeName(now(), setup.name ?? "");
      replace("notice-profile-new", { machine: inUse(now(), setup.control, { ...setup, name }) });
    },
    deleteProfile() {
      const { control } = now().form;
      const { [control]: _, ...setups } = now().machine.setups;
      replace("notice-profile-deleted", { machine: { setups, told: { key: "step-profile-delete", args: {} } } });
    },
    cursor: (cursor, cursorLine) =>
      store.update(state => ({
        program: { cursor, line: cursorLine },
        desk: { follow: state.desk.follow ?? "cursor" },
      })),
    openCall(index) {
      const state = now();
      const call = isRead(state) ? state.program.reading?.view.calls[index] : undefined;
      store.update(call ? opened(state, call) : { desk: { sought: { call: index } } });
    },
    closeCall: () =>
      store.update(state => {
        const pending = state.desk.pending.filter(one => !one.asks);
        return { form: { values: asWritten(state), open: null }, desk: { sought: null, pending } };
      }),
    style: style => store.update({ snippet: { style } }),
    convert: (style, all = false) =>
      store.update(state => {
        const at = state.form.open ?? (all ? 0 : null);
        return at === null ? {} : { desk: { converting: { at, style, all } } };
      }),
    cure(edits, elsewhere = []) {
      const state = now();
      if (!isRead(state)) return;
      if (!elsewhere.length) return store.update(mended(state, edits, "notice-mended"));
      const title = { key: "asks-title", args: { count: elsewhere.length } };
      store.update(proposed(state, { edits, title, notice: "notice-applied" }));
    },
    cureAll: ({ code, message: { key } }) => store.update({ desk: { curing: { code, key } } }),
    apply() {
      store.update(agreed);
      store.flush(); // editor and form have to hold it before the next key
    },
    discard: () => store.update(declined),
    show: () => store.update(state => (state.desk.proposed ? {} : typedShown(state))),
    refuse: () => store.update(refused),
    assign: (name, variable) =>
      store.update(state => {
        const change = replacing(state, name)?.asks.replaced.variables[variable]?.change;
        const found = replacing(state, name)?.asks.replaced.variables[variable]?.name ?? "";
        if (!change) return {};
        const title = { key: "difference-typed", args: { name: found, value: change.value } };
        const { edits, values } = change;
        return proposed(state, { edits, values, title, notice: "notice-assigned", typed: { field: name } });
      }),
    replaceHere: name =>
      store.update(state => {
        const here = replacing(state, name);
        const pending = state.desk.pending.map(one =>
          one === here ? { ...one, asks: undefined, agreed: "here" as const } : one,
        );
        return { desk: { pending } };
      }),
    keep: name => store.update(state => withoutReplacing(state, name)),
    card: card => store.update({ page: { card } }),
    insert(snippet) {
      const state = now();
      const place = insertion(programOf(state), state.program.cursor, snippet);
      const to = place.from + place.insert.length;
      const next = withEdits(state, [place]);
      store.update(
        patched(next, {
          program: { cursor: to },
          form: { open: null },
          desk: { sought: { from: place.from, to }, pending: next.desk.pending.filter(one => !one.asks) },
          page: { notice: "notice-inserted", offer: false },
        }),
      );
      store.flush(); // the editor has to hold it before the next key
    },
    around(name) {
      const at = aroundAt(now());
      const { around } = now().snippet;
      const blocks = around?.at === at ? around.blocks : null;
      store.update({ snippet: { around: { at, blocks: { ...blocks, [name]: blocks?.[name] ?? {} } } } });
      store.flush(); // who wants it goes on in it
    },
    write(cycle, values, text) {
      const state = now();
      store.update(remember(state), {
        form: { cycle, values, open: null, around: null, resets: {}, touched: {}, checked: true },
        view: { step: AT_END, source: "form" },
        panels: { panel: "form", left: "form" },
      });
      actions.insert(text);
    },
    error(group, name, value) {
      const errors = now().part.errors;
      store.update({
        part: { errors: { ...errors, [group]: { ...errors[group], [name]: value } } },
        view: { step: AT_END },
        page: { offer: false },
      });
    },
    noErrors: () => replace("notice-no-errors", { part: { errors: NO_ERRORS }, view: { step: AT_END } }),
    help() {
      const closes = now().panels.right === "help";
      store.update(
        closes
          ? { panels: { panel: "form", left: "form", right: firstState().panels.right } }
          : { panels: { panel: "help", right: "help" } },
      );
      store.flush(); // the focus goes there
    },
    saveSet(name) {
      const sets = setsOf(now());
      const next = withSets({ ...sets, [name]: asWritten(now()) });
      if (sets[name]) replace("notice-set-replaced", next);
      else store.update(next, { page: { notice: "notice-set-saved" } });
    },
    loadSet(name) {
      const values = asWritten(now());
      const set = setsOf(now())[name] ?? {};
      const names = [...new Set([...Object.keys(values), ...Object.keys(set)])];
      const changes = names
        .filter(one => (values[one] ?? "") !== (set[one] ?? ""))
        .map((one): [string, string] => [one, set[one] ?? ""]);
      replace("notice-set-loaded", patched(typedIn(now(), changes), { form: { touched: {}, checked: false } }));
    },
    renameSet(name, next) {
      const sets = setsOf(now());
      if (!next || (next !== name && sets[next])) return false;
      store.update(
        withSets(Object.fromEntries(Object.entries(sets).map(([one, values]) => [one === name ? next : one, values]))),
      );
      return true;
    },
    deleteSet(name) {
      const { [name]: _, ...rest } = setsOf(now());
      replace("notice-set-deleted", withSets(rest));
    },
    step(back) {
      store.flush(); // what was typed just now is a step too
      const there = stepped(now(), back);
      if (!there) return;
      const page = { notice: back > 0 ? "notice-undone" : "notice-redone", offer: false };
      store.update(there, { desk: { sought: null, follow: null, proposed: null }, view: { step: AT_END }, page });
      store.flush(); // editor and form have to hold it before the next key
    },
    speak(language) {
      speak(language).then(
        () => store.update({ page: { language } }),
        () => store.update({ page: { notice: "notice-no-language" } }),
      );
    },
    begin(own) {
      const { control } = now().form;
      const setup = profile(now());
      const turns = own.plane !== beginning(now()).plane;
      const chosen = turns ? own : { units: own.units };
      const described: Patch["machine"] = setup
        ? used(now(), { ...setup, plane: own.plane, active: { ...setup.active, units: own.units } })
        : { own: { ...now().machine.own, [control]: { own: { ...ownMachine(now()), ...chosen } } } };
      const cycle = findCycle(catalogue, control, now().form.cycle);
      const suited = turns && cycle?.purpose.plane ? suits(now(), cycle.purpose.plane) : {};
      store.update({ machine: described }, suited, turned(cycle, now(), own.plane), asBegun(now()), {
        view: { step: AT_END },
      });
    },
    data({ basic, data }, definitions) {
      const { control } = now().form;
      const { own } = now().machine;
      const setup = profile(now());
      const before = beginning(now());
      // rebuilt, it begins in the new system
      const units = basic === (before.basic ?? "mm") ? before.units : unitsIn(control, before.units, basic);
      const defined = definitions && { definitions };
      const described: Patch["machine"] = setup
        ? used(now(), { ...setup, units: basic, active: { ...setup.active, units }, data, ...defined })
        : { own: { ...own, [control]: { own: { ...ownMachine(now()), basic, units, data, ...defined } } } };
      store.update({ machine: described }, asBegun(now()), { view: { step: AT_END } });
    },
    give(offer) {
      const giving = { change: { give: offer.supply }, told: offer.label };
      store.update({ desk: { giving }, page: { changed: Date.now(), others: NOBODY } });
      store.flush();
    },
    panel(panel) {
      const docked = panel === "program" || panel === "results";
      store.update({
        panels: {
          panel,
          [LEFT.includes(panel) ? "left" : "right"]: panel,
          ...(docked ? { dock: panel } : {}),
          sheet: sheetFor(panel, now().panels.sheet),
        },
      });
      store.flush(); // who shows a panel goes on in it, mostly with the focus
    },
    sheet: sheet => store.update({ panels: { sheet } }),
  };
  return actions;
}

/** The files beside the program with these. */
function withFiles(before: readonly BesideFile[] = [], more: readonly Opened[]): BesideFile[] {
  const added = more.map(({ text, file }) => ({ ...file, text }));
  const isNew = ({ name }: BesideFile): boolean => !added.some(one => sameName(one.name, name));
  return [...before.filter(isNew), ...added].sort((a, b) => a.name.localeCompare(b.name));
}

/** With other files beside the program: what was stopped may go on. */
function besideAnew(beside: State["program"]["beside"]): Patch {
  return { program: { beside, stoppedReading: null }, run: { stopped: null } };
}

/** Another profile in use; the one before stays among the others. */
function inUse({ machine: { setups, parked } }: State, control: Dialect, setup: Setup | null): Patch["machine"] {
  const { [control]: before, ...rest } = setups;
  const others = parked.filter(one => one !== setup);
  return {
    setups: setup ? { ...rest, [control]: setup } : rest,
    parked: before && before !== setup ? [...others, before] : others,
    told: null,
  };
}

/** The sheet leaves room for a panel that is wanted. */
function sheetFor(panel: Panel, sheet: Sheet): Sheet {
  const docked = panel === "program" || panel === "results";
  return (docked && sheet === "peek") || (panel === "view" && sheet === "full") ? "half" : sheet;
}

/** Whole lines before the line of the cursor, or after the last line when the cursor stands at its end. */
function insertion(text: string, cursor: number, snippet: string): Splice {
  const eol = lineBreak(text);
  const body = snippet.replace(/\n+$/, "").replaceAll("\n", eol);
  const atEnd = cursor >= text.length && text.length > 0 && !text.endsWith("\n");
  if (atEnd) return { from: text.length, to: text.length, insert: eol + body + eol };
  const start = text.lastIndexOf("\n", cursor - 1) + 1;
  return { from: cursor === 0 ? 0 : start, to: cursor === 0 ? 0 : start, insert: body + eol };
}
