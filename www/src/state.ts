// The one state of the page. Values in it are never changed in place: a part that changed is a new object,
// so views and computations compare by identity.

import { ENCODINGS } from "./encoding";
import type { Files, ProgramFile, Refusal } from "./files";
import type { Scanned } from "./scan/scanned";
import type {
  BasicSystem,
  CallView,
  CycleInfo,
  Diagnostic,
  Dialect,
  Edit,
  ErrorSliders,
  OwnMachine,
  Pending,
  Plane,
  ReadView,
  RunView,
  Setup,
  Style,
  TouchedLine,
  UnitFunction,
} from "./wire";

export type Panel = "tasks" | "form" | "program" | "view" | "results" | "help";
export type ResultTab = "outcome" | "problems" | "motions" | "log" | "scan";
/** What the core said about a text. It is current while the program is still that text. */
export interface Reading {
  control: Dialect;
  text: string;
  setup?: Setup | OwnMachine;
  view: ReadView;
}
export interface Ran {
  control: Dialect;
  text: string;
  setup?: Setup | OwnMachine;
  view: RunView;
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
  kind: "result" | "alarm";
  code: string;
  key: string;
  cycles: CycleInfo[];
  others: string[];
}
/** A value, and the key of what it was a code of. */
export interface Reset {
  value: string;
  before: string;
}
/** A cure that would change lines elsewhere waits for a word. It counts while the program is still that text. */
export interface Curing {
  control: Dialect;
  text: string;
  edits: Edit[];
  lines: TouchedLine[];
}
/** Nothing is asked about this text any more: the user stopped it, or it failed for a reason. */
export interface Stopped {
  control: Dialect;
  text: string;
  why: string;
}

export interface State {
  control: Dialect;
  cycle: string;
  values: Record<string, string>; // as typed
  remembered: Record<string, Record<string, string>>; // last values of the other cycles, by "control/cycle"
  programs: Partial<Record<Dialect, string>>;
  files: Files;
  sets: Record<string, Record<string, Record<string, string>>>; // named values, by "control/cycle" and name
  open: number | null; // where in the program the call begins that the form edits
  pending: readonly Pending[]; // typed in the form, not yet in the program
  errors: ErrorSliders;
  comments: boolean;
  twin: boolean; // the same task on the other control is shown
  style: Style | ""; // way of writing of the snippet, where the cycle has it; empty: as the machine has it
  setup: Setup | null; // imported machine; null: the core's own
  own: Partial<Record<Dialect, OwnMachine>>; // how the core's own begins, where that was chosen
  // the usual plane of the sort of machine that the core's own last was for a form
  suits: Partial<Record<Dialect, Plane>>;
  checked: boolean; // problems are shown at every field
  touched: Record<string, true>; // fields whose problems are shown
  source: "form" | "program" | "scan"; // whose motions the 3D view shows, or the points of the scan

  diameters: boolean; // of a turned part, as on a drawing
  panel: Panel;
  left: Panel;
  right: Panel;
  tab: ResultTab;
  theme: "system" | "light" | "dark";
  language: string; // its code; empty: what the browser wants
  unfolded: Record<string, boolean>; // branches of the task tree that were opened or closed by hand
  outline: boolean; // the list of calls stands beside the program

  search: string; // from here on: not kept
  limits: boolean; // the largest errors that the call survives are looked for
  card: Card | null;
  converting: { at: number; style: Style } | null; // the call that begins there is to be written in another way
  converted: ConvertedCall | null;
  curing: Curing | null;
  resets: Record<string, Reset>; // values that were taken away since they were codes of something else, by parameter
  mended: string | null; // the program as a cure or a conversion has left it: one step of the editor
  focus: string | null;
  step: number;
  playing: boolean;
  speed: number; // of playing
  cursor: number; // in the program
  cursorLine: number; // from 1
  notice: string; // key of a short confirmation
  reading: Reading | null;
  ran: Ran | null;
  sought: Sought | null;
  // the form follows the cursor, what was typed in the program, or edits of its call
  follow: "cursor" | "text" | "edits" | null;
  stoppedLaying: Stopped | null; // the program is not put into the editor
  stoppedReading: Stopped | null;
  stoppedRun: Stopped | null;
  refused: (Refusal & { place: "program" | "setup" }) | null; // a file that could not be opened
  scan: Scanned | null; // the last one, while the page is open
  scanProblem: string; // why the last one could not be made
  undo: Partial<State> | null; // what the last replacement of work has replaced
}

export const NO_ERRORS: ErrorSliders = {
  part: { dx: 0, dy: 0, dz: 0, size: 0, tilt: 0, taper: 0, outOfRound: 0 },
  probe: { skewX: 0, skewY: 0, radius: 0, preTravel: 0, repeatability: 0 },
};

/** Step of a trace that stands for its last: everything done, all touches to be seen. */
export const AT_END = Number.MAX_SAFE_INTEGER;

/** How fast motions are played; at the highest a run of a thousand calls takes two minutes. */
export const SPEEDS = [0.5, 1, 2, 5, 20, 100];

export function firstState(): State {
  return {
    control: "sinumerik",
    cycle: "",
    values: {},
    remembered: {},
    programs: {},
    files: {},
    sets: {},
    open: null,
    pending: [],
    errors: NO_ERRORS,
    comments: true,
    twin: false,
    style: "",
    setup: null,
    own: {},
    suits: {},
    checked: false,
    touched: {},
    source: "form",
    diameters: false,
    panel: "form",
    left: "form",
    right: "results",
    tab: "outcome",
    theme: "system",
    language: "",
    unfolded: {},
    outline: true,
    search: "",
    limits: false,
    card: null,
    converting: null,
    converted: null,
    curing: null,
    resets: {},
    mended: null,
    focus: null,
    step: AT_END,
    playing: false,
    speed: 1,
    cursor: 0,
    cursorLine: 1,
    notice: "",
    reading: null,
    ran: null,
    sought: null,
    follow: null,
    stoppedLaying: null,
    stoppedReading: null,
    stoppedRun: null,
    refused: null,
    scan: null,
    scanProblem: "",
    undo: null,
  };
}

const NOT_KEPT = [
  "search",
  "limits",
  "card",
  "converting",
  "converted",
  "curing",
  "resets",
  "mended",
  "focus",
  "step",
  "playing",
  "speed",
  "cursor",
  "cursorLine",
  "notice",
  "reading",
  "ran",
  "sought",
  "follow",
  "stoppedLaying",
  "stoppedReading",
  "stoppedRun",
  "refused",
  "scan",
  "scanProblem",
  "undo",
] as const satisfies (keyof State)[];
/** What a replacement of work can take away. */
const WORK = [
  "control",
  "cycle",
  "values",
  "remembered",
  "programs",
  "files",
  "sets",
  "open",
  "pending",
  "errors",
  "setup",
  "own",
  "suits",
  "checked",
  "touched",
] as const satisfies (keyof State)[];
const IN_LINK = [
  "control",
  "cycle",
  "values",
  "programs",
  "files",
  "open",
  "errors",
  "comments",
  "style",
  "setup",
  "own",
  "suits",
  "checked",
  "source",
] as const satisfies (keyof State)[];

/** Under what the values and value sets of a cycle are kept. */
export function memoryKey({ control, cycle }: Pick<State, "control" | "cycle">): string {
  return `${control}/${cycle}`;
}

/** The call of the program that the form edits, as it was read last. */
export function openCall({ reading, control, open }: State): CallView | undefined {
  return reading?.control === control ? reading.view.calls.find(one => one.from === open) : undefined;
}

/** The values in the form as the program has them: an expression, and not what it is worth today. */
export function asWritten(state: State): Record<string, string> {
  const call = openCall(state);
  if (!call) return state.values;
  const one = (name: string, value: string): string =>
    value === call.values[name] ? (call.expressions[name] ?? value) : value;
  return Object.fromEntries(Object.entries(state.values).map(([name, value]) => [name, one(name, value)]));
}

/** The values in the form among those that are kept. */
export function remember(state: State): Pick<State, "remembered"> {
  return { remembered: { ...state.remembered, [memoryKey(state)]: asWritten(state) } };
}

/** The program of the control that the form is for. */
export function programOf(state: State): string {
  return state.programs[state.control] ?? "";
}

/** The imported machine, for a control that it has; else the core's own with what was chosen for it. */
export function machine(state: State): { setup?: Setup | OwnMachine } {
  const { control, setup, own } = state;
  if (setup?.control === control) return { setup };
  const chosen = own[control];
  return chosen ? { setup: chosen } : {};
}

export function kept(state: State): Partial<State> {
  const copy: Partial<State> = { ...state };
  for (const name of NOT_KEPT) delete copy[name];
  return copy;
}

/** The work as it is, to come back to it. */
export function work(state: State): Partial<State> {
  return Object.fromEntries(WORK.map(name => [name, state[name]]));
}

/** The named values of the chosen cycle. */
export function setsOf(state: State): Record<string, Record<string, string>> {
  return state.sets[memoryKey(state)] ?? {};
}

export function shared(state: State): Partial<State> {
  return Object.fromEntries(IN_LINK.map(name => [name, state[name]]));
}

function plainObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

const texts = (value: unknown): Record<string, string> =>
  plainObject(value)
    ? Object.fromEntries(Object.entries(value).filter((pair): pair is [string, string] => typeof pair[1] === "string"))
    : {};

function numbers<T extends Record<string, number>>(value: unknown, shape: T): T {
  const given = plainObject(value) ? value : {};
  return Object.fromEntries(
    Object.entries(shape).map(([name, zero]) => [name, Number.isFinite(given[name]) ? given[name] : zero]),
  ) as T;
}

const isFile = (value: unknown): value is ProgramFile =>
  plainObject(value) && typeof value.name === "string" && ENCODINGS.some(one => one === value.encoding);
const isPending = (value: unknown): value is Pending =>
  plainObject(value) &&
  ["control", "name", "value"].every(name => typeof value[name] === "string") &&
  Number.isInteger(value.at);

const STYLES: Style[] = ["direct", "indirect", "operate"];

/** How the core's own machine begins now. */
export function ownMachine({ control, own }: State): OwnMachine["own"] {
  const [plane = "G17"] = PLANES;
  const [units = "G71"] = UNITS[control];
  return own[control]?.own ?? { plane, units };
}

/** How the machine that counts begins: the opened one, else the core's own. */
export function beginning(state: State): OwnMachine["own"] {
  const { control, setup } = state;
  const own = ownMachine(state);
  if (setup?.control !== control) return own;
  return {
    basic: setup.units,
    plane: setup.plane,
    units: setup.active?.units ?? unitsIn(control, own.units, setup.units),
  };
}

/** The working plane of the call in the form: that of the opened call, else the one in which the machine begins. */
export function planeOf(state: State): Plane {
  return openCall(state)?.plane ?? beginning(state).plane;
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

function data(value: unknown): Setup["data"] {
  const known = (pair: [string, unknown]): pair is [string, number | string] =>
    Number.isFinite(pair[1]) || typeof pair[1] === "string";
  return plainObject(value) ? Object.fromEntries(Object.entries(value).filter(known)) : {};
}

function ownMachines(value: unknown): State["own"] {
  const given = plainObject(value) ? value : {};
  const pairs = Object.entries(UNITS).flatMap(([control, known]) => {
    const one = plainObject(given[control]) ? given[control].own : null;
    const fits = plainObject(one) && PLANES.includes(one.plane as Plane) && known.includes(one.units as UnitFunction);
    const basic = plainObject(one) && one.basic === "inch" ? { basic: one.basic } : {};
    return fits ? [[control, { own: { ...basic, plane: one.plane, units: one.units, data: data(one.data) } }]] : [];
  });
  return Object.fromEntries(pairs) as State["own"];
}

/** A stored state or one out of a link may be old, cut or hand-made: only what has the right shape is taken. */
export function merge(state: State, data: unknown): State {
  if (!plainObject(data)) return state;
  const next = { ...state };
  for (const [name, first] of Object.entries(firstState())) {
    const value = data[name];
    if (value !== undefined && typeof value === typeof first && first !== null) Object.assign(next, { [name]: value });
  }
  if (plainObject(data.values)) next.values = texts(data.values);
  if (plainObject(data.programs)) next.programs = texts(data.programs);
  if (plainObject(data.remembered))
    next.remembered = Object.fromEntries(
      Object.entries(data.remembered).map(([name, values]) => [name, texts(values)]),
    );
  if (plainObject(data.sets))
    next.sets = Object.fromEntries(
      Object.entries(data.sets).map(([cycle, sets]) => [
        cycle,
        plainObject(sets)
          ? Object.fromEntries(Object.entries(sets).map(([name, values]) => [name, texts(values)]))
          : {},
      ]),
    );
  if (plainObject(data.files))
    next.files = Object.fromEntries(Object.entries(data.files).filter(([, file]) => isFile(file)));
  if (plainObject(data.errors))
    next.errors = {
      part: numbers(data.errors.part, NO_ERRORS.part),
      probe: numbers(data.errors.probe, NO_ERRORS.probe),
    };
  if (Number.isInteger(data.open)) next.open = data.open as number;
  if (data.open === null) next.open = null;
  if (next.style && !STYLES.includes(next.style)) next.style = state.style;
  next.unfolded = Object.fromEntries(Object.entries(next.unfolded).filter(([, open]) => typeof open === "boolean"));
  next.pending = Array.isArray(data.pending)
    ? data.pending.filter(isPending).map(({ control, at, name, value }) => ({ control, at, name, value }))
    : [];
  if (data.own !== undefined) next.own = ownMachines(data.own);
  const planes = plainObject(data.suits)
    ? data.suits
    : Object.fromEntries(Object.entries(next.own).map(([control, { own }]) => [control, own.plane]));
  next.suits = Object.fromEntries(
    Object.entries(planes).filter(([, plane]) => PLANES.includes(plane as Plane)),
  ) as State["suits"];
  if (plainObject(data.setup)) next.setup = data.setup as unknown as Setup;
  return next;
}
