// What of the state outlives it: kept in the browser, put into an address, taken back by undo. Stored it is flat, under
// names that stay as they are, so that what an older page has left and addresses that somebody has sent can be opened.

import type { Pending } from "../core/pending";
import { ENCODINGS } from "../encoding";
import { NO_ERRORS } from "../errors";
import type { Plane, Setup, Style, Transverse, UnitFunction } from "../wire";
import type { BesideFile, ProgramFile } from "./files";
import { AS_SET_UP, firstState, type Patch, PIECES, PLANES, patched, SHEETS, type State, UNITS } from "./state";

/** A kept field: where it stands, and what of a stored value has the right shape; undefined: nothing, it stays. */
interface Field<G extends keyof State, F extends keyof State[G]> {
  group: G;
  field: F;
  read(value: unknown, first: State[G][F]): State[G][F] | undefined;
}

const field = <G extends keyof State, F extends keyof State[G]>(
  group: G,
  field: F,
  read: Field<G, F>["read"] = (value, first) => (typeof value === typeof first ? (value as State[G][F]) : undefined),
): Field<G, F> => ({ group, field, read });

function plainObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** Of what is stored by name what `read` takes. */
const all =
  <T>(read: (value: unknown) => T | undefined) =>
  (value: unknown): Record<string, T> | undefined => {
    if (!plainObject(value)) return undefined;
    const pairs = Object.entries(value).map(([name, one]) => [name, read(one)] as const);
    return Object.fromEntries(pairs.filter((pair): pair is [string, T] => pair[1] !== undefined));
  };
const text = (value: unknown): string | undefined => (typeof value === "string" ? value : undefined);
const flag = (value: unknown): boolean | undefined => (typeof value === "boolean" ? value : undefined);
const wholeOrNone = (value: unknown): number | null | undefined =>
  Number.isInteger(value) || value === null ? (value as number | null) : undefined;
const lines = (value: unknown): string[] | undefined =>
  Array.isArray(value) ? value.filter(one => typeof one === "string") : undefined;
const texts = all(text);
const orNone = <T>(read: (value: unknown) => Record<string, T> | undefined) =>
  all(value => read(value) ?? ({} as Record<string, T>));

function numbers<T extends Record<string, number>>(value: unknown, shape: T): T {
  const given = plainObject(value) ? value : {};
  return Object.fromEntries(
    Object.entries(shape).map(([name, zero]) => [name, Number.isFinite(given[name]) ? given[name] : zero]),
  ) as T;
}

const isFile = (value: unknown): value is ProgramFile =>
  plainObject(value) && typeof value.name === "string" && ENCODINGS.some(one => one === value.encoding);
const isBeside = (value: unknown): value is BesideFile =>
  isFile(value) && typeof (value as { text?: unknown }).text === "string";
const isPending = (value: unknown): value is Pending =>
  plainObject(value) &&
  ["control", "name", "value"].every(name => typeof value[name] === "string") &&
  Number.isInteger(value.at);

const TRANSVERSE: Transverse[] = ["DIAMOF", "DIAMON", "DIAM90"];

function around(value: unknown): State["form"]["around"] | undefined {
  if (!plainObject(value)) return value === null ? null : undefined;
  const plane = PLANES.find(one => one === value.plane);
  const units = Object.values(UNITS)
    .flat()
    .find(one => one === value.units);
  const transverse = TRANSVERSE.find(one => one === value.transverse);
  return plane && units && transverse ? { plane, units, transverse } : undefined;
}

const STYLES: (Style | "")[] = ["", "direct", "indirect", "operate"];

function data(value: unknown): Setup["data"] {
  const known = (pair: [string, unknown]): pair is [string, number | string] =>
    Number.isFinite(pair[1]) || typeof pair[1] === "string";
  return plainObject(value) ? Object.fromEntries(Object.entries(value).filter(known)) : {};
}

function ownMachines(value: unknown): State["machine"]["own"] {
  const given = plainObject(value) ? value : {};
  const pairs = Object.entries(UNITS).flatMap(([control, known]) => {
    const one = plainObject(given[control]) ? given[control].own : null;
    const fits = plainObject(one) && PLANES.includes(one.plane as Plane) && known.includes(one.units as UnitFunction);
    const basic = plainObject(one) && one.basic === "inch" ? { basic: one.basic } : {};
    if (!fits) return [];
    const lines = Array.isArray(one.definitions) ? one.definitions.filter(line => typeof line === "string") : [];
    const defined = lines.length ? { definitions: lines } : {};
    return [[control, { own: { ...basic, plane: one.plane, units: one.units, data: data(one.data), ...defined } }]];
  });
  return Object.fromEntries(pairs) as State["machine"]["own"];
}

const isSetup = (value: unknown): value is Setup => plainObject(value) && String(value.control) in UNITS;

/** The profiles in use, each under its control. */
function setupsIn(values: unknown[]): State["machine"]["setups"] {
  return Object.fromEntries(values.filter(isSetup).map(one => [one.control, one]));
}

const planes = all(value => (PLANES.includes(value as Plane) ? (value as Plane) : undefined));

const DOCKS: State["panels"]["dock"][] = ["program", "results"];
const pixels = (value: unknown): number | undefined => (Number.isFinite(value) ? (value as number) : undefined);

/** All kept fields, by the names under which they are stored. */
const FIELDS = {
  control: field("form", "control"),
  cycle: field("form", "cycle"),
  values: field("form", "values", texts),
  remembered: field("form", "remembered", orNone(texts)),
  programs: field("program", "texts", texts),
  files: field(
    "program",
    "files",
    all(value => (isFile(value) ? value : undefined)),
  ),
  beside: field(
    "program",
    "beside",
    all(value => (Array.isArray(value) ? value.filter(isBeside) : undefined)),
  ),
  given: field("program", "given", orNone(texts)),
  strict: field("run", "strict"),
  saved: field("program", "saved", texts),
  sets: field("form", "sets", orNone(orNone(texts))),
  open: field("form", "open", wholeOrNone),
  around: field("form", "around", around),
  pending: field("desk", "pending", value =>
    Array.isArray(value)
      ? value.filter(isPending).map(({ control, at, name, value }) => ({ control, at, name, value }))
      : [],
  ),
  errors: field("part", "errors", value =>
    plainObject(value)
      ? { part: numbers(value.part, NO_ERRORS.part), probe: numbers(value.probe, NO_ERRORS.probe) }
      : undefined,
  ),
  comments: field("snippet", "comments"),
  twin: field("snippet", "twin"),
  style: field("snippet", "style", value => STYLES.find(one => one === value)),
  setups: field("machine", "setups", value => (plainObject(value) ? setupsIn(Object.values(value)) : undefined)),
  parked: field("machine", "parked", value => (Array.isArray(value) ? value.filter(isSetup) : undefined)),
  before: field("machine", "before", texts),
  own: field("machine", "own", value => (value === undefined ? undefined : ownMachines(value))),
  suits: field("machine", "suits", planes),
  steps: field("machine", "steps", all(flag)),
  checked: field("form", "checked"),
  touched: field(
    "form",
    "touched",
    all(value => (value === true ? value : undefined)),
  ),
  source: field("view", "source"),
  diameters: field("view", "diameters"),
  halts: field("view", "halts"),
  titles: field("view", "titles", texts),
  panel: field("panels", "panel"),
  left: field("panels", "left"),
  right: field("panels", "right"),
  tab: field("panels", "tab"),
  changed: field("page", "changed"),
  theme: field("page", "theme"),
  recent: field("page", "recent", lines),
  language: field("page", "language"),
  unfolded: field("panels", "unfolded", all(flag)),
  outline: field("panels", "outline"),
  dock: field("panels", "dock", value => DOCKS.find(one => one === value)),
  errorsShown: field("panels", "errors"),
  sizes: field("panels", "sizes", all(pixels)),
  sheet: field("panels", "sheet", value => SHEETS.find(one => one === value)),
  practised: field("jog", "lines", lines),
  practiceSeed: field("jog", "seed", wholeOrNone),
  practicePart: field("jog", "part", value => numbers(value, AS_SET_UP)),
  practicePiece: field("jog", "piece", value => PIECES.find(one => one === value)),
  practiceShown: field("jog", "revealed"),
};
type Name = keyof typeof FIELDS;
const NAMES = Object.keys(FIELDS) as Name[];
/** What a replacement of work can take away. */
const WORK = [
  "control",
  "cycle",
  "values",
  "remembered",
  "programs",
  "files",
  "beside",
  "given",
  "sets",
  "open",
  "around",
  "pending",
  "errors",
  "setups",
  "parked",
  "own",
  "suits",
  "checked",
  "touched",
] as const satisfies Name[];
const IN_LINK = [
  "control",
  "cycle",
  "values",
  "programs",
  "files",
  "beside",
  "given",
  "open",
  "around",
  "errors",
  "comments",
  "style",
  "setups",
  "own",
  "suits",
  "checked",
  "source",
] as const satisfies Name[];

/** What is neither: when the work was changed and saved, and what is practised. */
const PASSING = [
  "changed",
  "saved",
  "practised",
  "practiceSeed",
  "practicePart",
  "practicePiece",
  "practiceShown",
] as const satisfies Name[];

/** Fields by their stored names. */
export type Flat = { [N in Name]?: unknown };

function held(state: State, name: Name): unknown {
  const { group, field } = FIELDS[name];
  return (state[group] as unknown as Record<string, unknown>)[field];
}

const flat = (state: State, names: readonly Name[]): Flat =>
  Object.fromEntries(names.map(name => [name, held(state, name)]));

const put = (name: Name, value: unknown): Patch => ({ [FIELDS[name].group]: { [FIELDS[name].field]: value } });

export const kept = (state: State): Flat => flat(state, NAMES);
/** What is kept and is no work: how the user wants the page to be. */
export const preferences = (state: State): Flat =>
  flat(
    state,
    NAMES.filter(name => !WORK.some(one => one === name) && !PASSING.some(one => one === name)),
  );
export const shared = (state: State): Flat => flat(state, IN_LINK);

/** The work as it is, to come back to it. */
export function work(state: State): Patch {
  const groups: Record<string, Record<string, unknown>> = {};
  for (const name of WORK) {
    const { group, field } = FIELDS[name];
    groups[group] = { ...groups[group], [field]: held(state, name) };
  }
  return groups as Patch;
}

const AUTHORED = [
  "programs",
  "files",
  "beside",
  "given",
  "sets",
  "pending",
  "errors",
  "setups",
  "parked",
] as const satisfies Name[];

/**
 * Whether somebody has worked between these two: to open another call of the program is no work, nor to choose control,
 * unit or plane, with which another form may come.
 */
export function worked(before: State, after: State): boolean {
  const differs = (name: Name): boolean => held(before, name) !== held(after, name);
  const chosen = after.form.open !== null || differs("control") || differs("own");
  const names: Name[] = chosen ? [...AUTHORED] : [...AUTHORED, "cycle", "values"];
  return names.some(differs);
}

/** An earlier page kept one machine. */
function earlierSetup({ setup }: Record<string, unknown>): State["machine"]["setups"] | undefined {
  return plainObject(setup) ? setupsIn([setup]) : undefined;
}

/** A stored state or one out of a link may be old, cut or hand-made: only what has the right shape is taken. */
export function merge(state: State, stored: unknown): State {
  if (!plainObject(stored)) return state;
  const data: Record<string, unknown> = { ...stored, setups: earlierSetup(stored) ?? stored.setups };
  const first = firstState();
  const taken = NAMES.flatMap((name): Patch[] => {
    const read = FIELDS[name].read as (value: unknown, first: unknown) => unknown;
    const value = read(data[name], held(first, name));
    return value === undefined ? [] : [put(name, value)];
  });
  const next = patched(state, ...taken);
  if (plainObject(data.suits)) return next;
  const own = Object.entries(next.machine.own).map(([control, { own }]) => [control, own.plane]);
  return patched(next, put("suits", Object.fromEntries(own)));
}
