// The one state of the page. Values in it are never changed in place: a part that changed is a new object,
// so views and computations compare by identity.

import type { Pending } from "../core/pending";
import type { Practised } from "../core/program";
import type { SceneData } from "../core/scene";
import type { Course } from "../core/steps";
import type { Splice } from "../eol";
import { NO_ERRORS } from "../errors";
import type { Theme } from "../theme";
import type {
  BasicSystem,
  Beside,
  CallView,
  ComparedValue,
  CycleInfo,
  Diagnostic,
  Dialect,
  Edit,
  Elsewhere,
  ErrorSliders,
  Message,
  OwnMachine,
  Plane,
  PracticePart,
  PracticePiece,
  PracticeProgram,
  PracticeRefusal,
  ReadView,
  RunMode,
  RunRequest,
  RunView,
  Setup,
  Style,
  Supply,
  UnitFunction,
} from "../wire";
import type { BesideFile, Files, Refusal } from "./files";
import type { Scanned } from "./scanned";

export type Panel = "tasks" | "form" | "program" | "view" | "results" | "help";
export type ResultTab = "outcome" | "problems" | "motions" | "log" | "scan";
/** What the core said about a text. It is current while the program is still that text. */
export interface Reading {
  control: Dialect;
  text: string;
  setup?: Setup | OwnMachine;
  with?: Beside[];
  view: ReadView;
}
/** Values for the parameters of the program itself. */
export type Arguments = NonNullable<RunRequest["arguments"]>;
export interface Ran {
  control: Dialect;
  text: string;
  setup?: Setup | OwnMachine;
  times?: number; // how many times as large the errors of the part are drawn
  with?: Beside[];
  arguments?: Arguments;
  strict?: boolean;
  mode?: RunMode;
  target?: number;
  program?: string;
  file?: string;
  view: RunView; // but for its steps
  course: Course;
  scene: SceneData;
}
/** A call to open as soon as the program is read: by its number, or the first that begins in a range. */
export type Sought = { call: number } | { from: number; to: number };
/** What was said when a call was written in another way. It is shown while the program is still what came out. */
export interface ConvertedCall {
  control: Dialect;
  text: string;
  findings: Diagnostic[];
}
/** What a card tells about: a result or an alarm as written on the control, the stem of its messages, who has it. */
export interface Card {
  kind: "result" | "alarm" | "elsewhere";
  code: string;
  key: string;
  cycles: CycleInfo[];
  others: string[];
  told?: Elsewhere; // of a newer control or of another maker's
}
/** A value that was taken away: the key of what it was a code of; none: the new variant does not take it. */
export interface Reset {
  value: string;
  before?: string;
}
/** A call that begins at this place is to be written in another way; `all`: so are the others. */
export interface Converting {
  at: number;
  style: Style;
  all: boolean;
}
/** All findings of a kind are to be cured: their name, and the key of their cause. */
export interface CuringAll {
  code: string;
  key: string;
}
/** The machine is to get what the program lacks; `told`: what is said of it. */
export interface Giving {
  change: { give: Supply };
  told: Message;
}
/**
 * Edits that are shown before they are made: they touch more than what is open, or all of it. They count while the
 * program is still that text.
 */
export interface Proposal {
  control: Dialect;
  text: string;
  edits: Edit[];
  title: Message;
  said: Message | null; // what there is to say beside the values
  values: ComparedValue[];
  findings: Diagnostic[];
  converting: Converting | null; // what led to it
  notice: string; // key of what is said once they are made
  /** What was typed and leads to it: values that wait, or one over an expression, in whose place a variable changes. */
  typed: "values" | { field: string } | null;
}
/** Nothing is asked about this text any more: the user stopped it, or it failed for a reason. */
export interface Stopped {
  control: Dialect;
  text: string;
  why: string;
}

/** What counts at the call that the form has from a program: the form keeps it when it leaves the program. */
export type Surroundings = Pick<CallView, "plane" | "units" | "transverse">;

/** What is in the form. */
export interface FormState {
  control: Dialect;
  cycle: string;
  values: Record<string, string>; // as typed
  remembered: Record<string, Record<string, string>>; // last values of the other cycles, by "control/cycle"
  sets: Record<string, Record<string, Record<string, string>>>; // named values, by "control/cycle" and name
  open: number | null; // where in the program the call begins that the form edits
  around: Surroundings | null; // null: the call is that of no program, and the machine's beginning counts
  resets: Record<string, Reset>; // values that were taken away since they do not fit the new variant, by parameter
  edits: number; // how often something was typed or chosen in the form
  checked: boolean; // problems are shown at every field
  touched: Record<string, true>; // fields whose problems are shown
  focus: string | null; // field that has the keyboard's focus, or had it last
  pointed: string | null; // what the pointer is on wherever it is named, or the cursor in the program
}

/** How the form becomes a piece of program. */
export interface SnippetState {
  comments: boolean;
  twin: boolean; // the same task on the other control is shown
  style: Style | ""; // call style, where the cycle has it; empty: as the machine has it
  around: AroundDraft | null; // blocks around the call; null: they are folded
}

/** The blocks around a call that are wanted, as long as they are not in the program. */
export interface AroundDraft {
  at: string; // the call that they are for: control, cycle, place in the program
  blocks: Record<string, Record<string, string>> | null; // values by field, by block; null: as in the program
}

/** The part that is measured. */
export interface PartState {
  errors: ErrorSliders;
  limits: boolean; // the largest errors that the call survives are looked for
}

export interface ProgramState {
  texts: Partial<Record<Dialect, string>>;
  usual: Partial<Record<Dialect, Plane>>; // the usual plane of the sort of machine that each is for
  files: Files;
  beside: Partial<Record<Dialect, BesideFile[]>>; // by name without regard to case, each once
  given: Partial<Record<Dialect, Record<string, string>>>; // values of the parameters of its PROC, as typed
  saved: Record<string, string>; // marks of what the files hold (saved.ts)
  cursor: number;
  line: number; // of the cursor, from 1
  reading: Reading | null;
  stoppedReading: Stopped | null;
  stoppedLaying: Stopped | null; // the program is not put into the editor
}

/** What is on its way between the form and the program (desk.ts). */
export interface DeskState {
  pending: readonly Pending[]; // typed in the form, not yet in the program
  sought: Sought | null;
  left: Partial<Record<Dialect, number>>; // which call the form edited when the other control was chosen
  // the form follows the cursor, what was typed in the program, or edits of its call
  follow: "cursor" | "text" | "edits" | null;
  converting: Converting | null;
  converted: ConvertedCall | null;
  curing: CuringAll | null;
  giving: Giving | null;
  proposed: Proposal | null;
  held: boolean; // something is being dragged: what that changes until its end is one step
}

export interface MachineState {
  setups: Partial<Record<Dialect, Setup>>; // the profile in use of each control; none: the core's own machine
  parked: readonly Setup[]; // the other profiles
  own: Partial<Record<Dialect, OwnMachine>>; // how the core's own begins, where that was chosen
  before: Partial<Record<Dialect, string>>; // the cycle that the form had when the other control was chosen
  suits: Partial<Record<Dialect, Plane>>; // the usual plane of the sort of machine that it last was for a form
  told: Message | null; // what was done to it last
  steps: Record<string, boolean>; // of commissioning, those that are done
}

/** The 3D view and the motions in it. */
export interface ViewState {
  source: "form" | "program" | "scan"; // whose motions are shown, or the points of the scan
  step: number;
  playing: boolean;
  speed: number; // of playing
  halts: boolean; // playing waits where the control waits for NC START
  diameters: boolean; // of a turned part, as on a drawing
  errors: number; // how many times as large those of the part are drawn
  section: boolean; // the part is cut open
  central: boolean; // projection
  titles: Record<string, string>; // of the printed record, by field: what only people know
}

/** The run of the program. */
export interface RunState {
  done: Ran | null;
  stopped: Stopped | null;
  strict: boolean; // what is not there stops it
  mode: RunMode;
  target: number; // line up to which a block search goes; 0: none is given
  main: string; // name of the program that is run of a text that holds several; empty: the first
}

export interface ScanState {
  made: Scanned | null; // the last one, while the page is open
  problem: string; // why the last one could not be made
}

/** Practising to measure in JOG. */
export interface JogState {
  lines: readonly string[]; // what was done
  seed: number | null; // by which chance put the part; none: it lies as `part` says
  part: PracticePart;
  piece: PracticePiece | null; // of the machine to practise on; none: the first
  seen: Practised | null; // what came of the lines; none: nobody asked yet
  setup: Setup | null; // the profile with which it was asked
  refused: (PracticeRefusal & { field: string; text: string }) | null; // the line that did nothing last
  told: readonly Message[]; // what of the call that is practised has no place in its mask
  program: PracticeProgram | null; // what the mask means as a program; none: nobody wants to know
  revealed: boolean; // how the part lies is shown
  step: number; // increment, µm; 0: as long as a key is held down
  rapid: boolean;
}

const PIECE: Record<PracticePiece, true> = {
  block: true,
  pocket: true,
  hole: true,
  holes: true,
  island: true,
  spigot: true,
  spigots: true,
  probe: true,
};
export const PIECES = Object.keys(PIECE) as PracticePiece[];

/** What of the page is shown where. */
export interface PanelState {
  panel: Panel;
  left: Panel;
  right: Panel;
  tab: ResultTab;
  unfolded: Record<string, boolean>; // branches of the task tree that were opened or closed by hand
  outline: boolean; // the list of calls stands beside the program
  dock: DockPanel; // the one that is shown where they do not stand side by side
  errors: boolean; // the panel of simulated errors stands beside the view
  sizes: Sizes; // of areas, as they were drawn
  sheet: Sheet; // how far the dock of a tablet is drawn up
}

export type DockPanel = "program" | "results";
/** From a strip to all that the answer leaves. */
export const SHEETS = ["peek", "half", "full"] as const;
export type Sheet = (typeof SHEETS)[number];
/** CSS pixels of areas, by name; none: as the page has it. */
export type Sizes = Partial<Record<"form" | "dock" | "program", number>>;

/** The work of another tab; `changed`: ms; `name`: of its file, else of its cycle. */
export interface OtherWork {
  from: string;
  changed: number;
  name: string;
}

export interface PageState {
  place: "start" | "work" | "jog"; // where the reader is
  changed: number; // ms, when the user last changed the work; 0: it is as the page begins
  others: readonly OtherWork[]; // which of them this tab continues is asked; none: nothing is
  theme: Theme;
  language: string; // its code; empty: what the browser wants
  search: string;
  story: number; // step of the worked example that is told, from 1; 0: none
  recent: readonly string[]; // names of the commands that were run last, the newest first
  card: Card | null;
  notice: string; // key of a short confirmation
  newer: boolean; // a newer version of the page waits
  refused: (Refusal & { place: "program" | "setup" }) | null; // a file that could not be opened
  offer: boolean; // the notice is about the last step: it can be undone beside it
}

/** What a step is called: a key of the texts, and what it names. */
export interface StepName {
  key: string;
  args: Record<string, string | number>;
}

/**
 * A step, and the work on its other side: before it what was done, after it what was undone. Of long programs it has
 * what makes them of those on this side; null: they are the same.
 */
export interface Step {
  name: StepName;
  work: Patch;
  edits: Partial<Record<Dialect, Splice | null>>;
  /** When it ended, ms. */
  at: number;
  /** What goes on with the same thing soon is the same step; empty: nothing does. */
  subject: string;
  /** What was typed waits for a word. */
  asking?: boolean;
}

/**
 * The steps that were done, and those that were undone; the last one of each is the next. `texts`: the programs that
 * stand between them.
 */
export interface History {
  past: Step[];
  future: Step[];
  texts: ProgramState["texts"];
}

export interface State {
  form: FormState;
  snippet: SnippetState;
  part: PartState;
  program: ProgramState;
  desk: DeskState;
  machine: MachineState;
  view: ViewState;
  run: RunState;
  scan: ScanState;
  jog: JogState;
  panels: PanelState;
  page: PageState;
  history: History;
}

/** What changes of a state, by subject. */
export type Patch = { [G in keyof State]?: Partial<State[G]> };

function patchGroup<G extends keyof State>(into: State, group: G, change: Partial<State[G]> | undefined): void {
  if (change && change !== into[group]) into[group] = { ...into[group], ...change };
}

/** The state with these changes, one after the other; what did not change is the same object. */
export function patched(state: State, ...patches: Patch[]): State {
  const next = { ...state };
  for (const patch of patches)
    for (const group of Object.keys(patch) as (keyof State)[]) patchGroup(next, group, patch[group]);
  return next;
}

/** A part as the setup has it. */
export const AS_SET_UP: PracticePart = {
  dx: 0,
  dy: 0,
  dz: 0,
  size: 0,
  tilt: 0,
  leanAbscissa: 0,
  leanOrdinate: 0,
};

/** Step of a trace that stands for its last: everything done, all touches to be seen. */
export const AT_END = Number.MAX_SAFE_INTEGER;

/** How many times as large the errors of a part can be drawn. */
export const EXAGGERATIONS = [1, 10, 100, 1000];

/** How fast motions are played; at the highest a run of a thousand calls takes two minutes. */
export const SPEEDS = [0.5, 1, 2, 5, 20, 100];

/** Nothing is asked about other tabs. */
export const NOBODY: PageState["others"] = [];

export function firstState(): State {
  return {
    form: {
      control: "sinumerik",
      cycle: "",
      values: {},
      remembered: {},
      sets: {},
      open: null,
      around: null,
      resets: {},
      edits: 0,
      checked: false,
      touched: {},
      focus: null,
      pointed: null,
    },
    snippet: { comments: true, twin: false, style: "", around: null },
    part: { errors: NO_ERRORS, limits: false },
    program: {
      texts: {},
      usual: {},
      files: {},
      beside: {},
      given: {},
      saved: {},
      cursor: 0,
      line: 1,
      reading: null,
      stoppedReading: null,
      stoppedLaying: null,
    },
    desk: {
      pending: [],
      sought: null,
      left: {},
      follow: null,
      converting: null,
      converted: null,
      curing: null,
      giving: null,
      proposed: null,
      held: false,
    },
    machine: { setups: {}, parked: [], own: {}, before: {}, suits: {}, told: null, steps: {} },
    view: {
      source: "form",
      step: AT_END,
      playing: false,
      speed: 1,
      halts: true,
      diameters: false,
      errors: 1,
      section: false,
      central: false,
      titles: {},
    },
    run: { done: null, stopped: null, strict: false, mode: "automatic", target: 0, main: "" },
    scan: { made: null, problem: "" },
    jog: {
      lines: [],
      seed: null,
      part: AS_SET_UP,
      piece: null,
      seen: null,
      setup: null,
      refused: null,
      told: [],
      program: null,
      revealed: true,
      step: 1000,
      rapid: false,
    },
    panels: {
      panel: "form",
      left: "form",
      right: "results",
      tab: "outcome",
      unfolded: {},
      outline: true,
      dock: "program",
      errors: false,
      sizes: {},
      sheet: "half",
    },
    page: {
      place: "work",
      theme: "system",
      language: "",
      search: "",
      story: 0,
      recent: [],
      card: null,
      notice: "",
      newer: false,
      refused: null,
      offer: false,
      changed: 0,
      others: NOBODY,
    },
    history: { past: [], future: [], texts: {} },
  };
}

/** Under what the values and value sets of a cycle are kept. */
export function memoryKey({ control, cycle }: Pick<FormState, "control" | "cycle">): string {
  return `${control}/${cycle}`;
}

/** The parameter in focus: it is lit wherever it is named or drawn. */
export function inFocus({ form: { pointed, focus } }: State): string | null {
  return pointed ?? focus;
}

/** The call of the program that the form edits, as it was read last. */
export function openCall({ program: { reading }, form: { control, open } }: State): CallView | undefined {
  return reading?.control === control ? reading.view.calls.find(one => one.from === open) : undefined;
}

/** The values in the form as the program has them: an expression, and not what it is worth today. */
export function asWritten(state: State): Record<string, string> {
  const call = openCall(state);
  const { values } = state.form;
  if (!call) return values;
  const one = (name: string, value: string): string =>
    value === call.values[name] ? (call.expressions[name] ?? value) : value;
  return Object.fromEntries(Object.entries(values).map(([name, value]) => [name, one(name, value)]));
}

/** The values in the form among those that are kept. */
export function remember(state: State): { form: Pick<FormState, "remembered"> } {
  return { form: { remembered: { ...state.form.remembered, [memoryKey(state.form)]: asWritten(state) } } };
}

/** By what the user knows the work: the file of its program, else the cycle in the form. */
export function workName({ form: { control, cycle }, program }: State): string {
  return program.files[control]?.name ?? cycle;
}

/** The program of the control that the form is for. */
export function programOf(state: State): string {
  return state.program.texts[state.form.control] ?? "";
}

/** The files beside the program; none: there are none. */
export function besideOf(state: State): { with?: BesideFile[] } {
  const files = state.program.beside[state.form.control];
  return files?.length ? { with: files } : {};
}

/** The machine of the form: for a call of the program that of the program. */
export function machine(state: State): { setup?: Setup | OwnMachine } {
  if (state.form.open !== null) return programMachine(state);
  const setup = profile(state);
  if (setup) return { setup };
  const chosen = state.machine.own[state.form.control];
  return chosen ? { setup: chosen } : {};
}

/** The profile in use of the control that the form is for. */
export function profile({ form: { control }, machine: { setups } }: State): Setup | undefined {
  return setups[control];
}

/** The profile in use; else the core's own machine with what was chosen for it. */
export function programMachine(state: State): { setup?: Setup | OwnMachine } {
  const { control } = state.form;
  const { own } = state.machine;
  const setup = profile(state);
  if (setup) return { setup };
  const chosen = own[control];
  const plane = programPlane(state);
  if (plane === ownMachine(state).plane) return chosen ? { setup: chosen } : {};
  return { setup: beginningIn(chosen ?? BARE[control], plane) };
}

/**
 * The plane in which the program begins: on the core's own machine, unless another one was chosen for it, the usual one
 * of the sort of machine that it is for, whatever the form was for last.
 */
export function programPlane(state: State): Plane {
  const { control } = state.form;
  const { suits } = state.machine;
  const { plane } = ownMachine(state);
  const setup = profile(state);
  if (setup) return setup.plane;
  return plane === (suits[control] ?? PLANES[0]) ? (state.program.usual[control] ?? plane) : plane;
}

const made = new WeakMap<object, Partial<Record<Plane, object>>>();

/** A machine that begins in this plane: always the same object. */
export function beginningIn<M extends Setup | OwnMachine>(machine: M, plane: Plane): M {
  if (plane === ("own" in machine ? machine.own.plane : machine.plane)) return machine;
  const known = made.get(machine) ?? {};
  made.set(machine, known);
  known[plane] ??= "own" in machine ? { own: { ...machine.own, plane } } : { ...machine, plane };
  return known[plane] as M;
}

/** The named values of the chosen cycle. */
export function setsOf(state: State): Record<string, Record<string, string>> {
  return state.form.sets[memoryKey(state.form)] ?? {};
}

/** How the core's own machine begins now. */
export function ownMachine({ form: { control }, machine: { own } }: State): OwnMachine["own"] {
  const [plane = "G17"] = PLANES;
  const [units = "G71"] = UNITS[control];
  return own[control]?.own ?? { plane, units };
}

/** How the machine that counts begins: the profile in use, else the core's own. */
export function beginning(state: State): OwnMachine["own"] {
  const { control } = state.form;
  const setup = profile(state);
  const own = ownMachine(state);
  if (!setup) return state.form.open === null ? own : { ...own, plane: programPlane(state) };
  return {
    basic: setup.units,
    plane: setup.plane,
    units: setup.active?.units ?? unitsIn(control, own.units, setup.units),
  };
}

/** The working plane of the call in the form: that of its place in a program, else that in which the machine begins. */
export function planeOf(state: State): Plane {
  return state.form.around?.plane ?? beginning(state).plane;
}

/** Plane and units of the call in the form, likewise. */
export function systemOf(state: State): OwnMachine["own"] {
  return { plane: planeOf(state), units: state.form.around?.units ?? beginning(state).units };
}

/** The G function of this kind, feeds and data included or not, that counts in this system. */
export function unitsIn(control: Dialect, units: UnitFunction, basic: BasicSystem): UnitFunction {
  if (INCH.includes(units) === (basic === "inch")) return units;
  const place = UNITS[control].indexOf(units);
  return UNITS[control][place % 2 ? place - 1 : place + 1] ?? units;
}

/** What may be chosen for the core's own machine, in pairs of mm and inch; the first counts where nothing was. */
export const PLANES: Plane[] = ["G17", "G18", "G19"];
export const UNITS: Record<Dialect, UnitFunction[]> = {
  sinumerik: ["G71", "G70", "G710", "G700"],
  nct: ["G21", "G20"],
};
export const INCH: UnitFunction[] = ["G70", "G700", "G20"];

/** The core's own machines as they are. */
const BARE: Record<Dialect, OwnMachine> = {
  sinumerik: { own: { plane: "G17", units: "G71" } },
  nct: { own: { plane: "G17", units: "G21" } },
};
