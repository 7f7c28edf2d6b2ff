// The work is kept in the browser with every change, before the key that made it is over. Local storage is written even
// while the page is left, but holds little and is slow for much: of a longer program it has the key of a text in the
// database, and what was edited since. Once nothing is typed any more, the database gets the whole text. A page that
// dies therefore loses nothing, except a change of more than INLINE characters of such a program, as when a file is
// opened: until the database has it, some milliseconds later, the text before is the one that is kept.
// Where the page is open twice, each tab has its own work in session storage and comes back to it. Local storage has
// the work that was changed last, in whatever tab: with that a later visit begins. A tab with earlier work leaves it
// there.

import { difference } from "../difference";
import type { Splice } from "../eol";
import type { Dialect } from "../wire";
import { layText, removeText, textAt, tidy } from "./depot";
import type { BesideFile } from "./files";
import type { State } from "./state";
import { type Flat, kept, preferences } from "./stored";

const STORE = "probewright-1";
const INLINE = 20_000; // characters of a program, or of an edit of a longer one, that are written with every change
const REST = 200; // ms without a change, after which the database gets a longer program
const HUGE = 4_000_000; // characters: of such a program the database keeps the text before an edit that is told

/** Characters of a file beside the program that are written with every change. */
const SMALL = 2000;

const COPY = ""; // of no visit: what a tab began with and left
const EARLIER = 1; // ms: a page has kept it that did not tell when it was changed

/** A program in the database: under which key, and what was edited since. */
interface Apart {
  key: string;
  edit?: Splice;
}

/** `by`: which visit of the page wrote it. An earlier page listed the long programs; each lies under its control. */
interface Stored extends Flat {
  programs?: Partial<Record<Dialect, string>>;
  apart?: Dialect[] | Partial<Record<Dialect, Apart>>;
  by?: string;
}

/** `layAfter`: ms, after which long programs are to be laid down; none: they lie as they are. */
export interface Saved {
  kept: boolean;
  layAfter?: number;
}

/** A file beside the program, of which a longer one lies in the database; it never changes, and is the same object. */
type StoredBeside = Omit<BesideFile, "text"> & { text?: string; key?: string };

const visit = Math.random().toString(36).slice(2);

/** What the database holds; `own`: this visit has put it there, and nobody else takes it away. */
const lying: Partial<Record<Dialect, { key: string; text: string; own: boolean }>> = {};
const besides = new WeakMap<BesideFile, string>(); // under which keys they lie
const said: Partial<Record<Dialect, Apart>> = {}; // where a long program is to be found, as it could be told last
let last: Flat = {}; // as it was written

const read = (storage: Storage): Stored | null => JSON.parse(storage.getItem(STORE) ?? "null") as Stored | null;

/** What the last visit left; what this tab left, where another one wrote since. */
function newest(): Stored | null {
  const [own, last] = [read(sessionStorage), read(localStorage)];
  return own && last?.by !== own.by ? own : last;
}

function apartIn({ apart = {} }: Stored): [Dialect, Apart][] {
  if (Array.isArray(apart)) return apart.map(control => [control, { key: control }]);
  return Object.entries(apart) as [Dialect, Apart][];
}

async function fetched({ key, edit }: Apart, control: Dialect): Promise<string | undefined> {
  const text = await textAt(key);
  if (text === undefined) return undefined;
  lying[control] = { key, text, own: false };
  return edit ? text.slice(0, edit.from) + edit.insert + text.slice(edit.to) : text;
}

function besideIn({ beside }: Flat): StoredBeside[] {
  const all = Object.values((beside ?? {}) as Record<string, unknown>);
  return all.flatMap(files => (Array.isArray(files) ? (files as StoredBeside[]) : []));
}

/** Those that lie in the database, with their text. */
async function fetchBeside(stored: Flat): Promise<void> {
  for (const file of besideIn(stored)) {
    const { key } = file;
    if (!key) continue;
    const text = await textAt(key);
    delete file.key;
    if (text === undefined) continue;
    file.text = text;
    besides.set(file as BesideFile, key);
  }
}

const longBeside = (state: State): BesideFile[] =>
  Object.values(state.program.beside)
    .flat()
    .filter(file => file.text.length > SMALL);

function storedBeside(state: State): Record<string, StoredBeside[]> {
  const one = ({ text, ...file }: BesideFile, key: string | undefined): StoredBeside =>
    key ? { ...file, key } : { ...file, text };
  const pairs = Object.entries(state.program.beside).map(([control, files]) => [
    control,
    files.flatMap(file => {
      const key = besides.get(file);
      return key || file.text.length <= SMALL ? [one(file, key)] : []; // until the database has it
    }),
  ]);
  return Object.fromEntries(pairs) as Record<string, StoredBeside[]>;
}

/** `returned`: the tab has been here before. */
export async function load(): Promise<{ stored: Flat | null; returned: boolean }> {
  try {
    const stored = newest();
    const returned = read(sessionStorage) !== null;
    if (stored) stored.changed ??= EARLIER;
    const apart = stored ? apartIn(stored) : [];
    for (const [control, one] of apart) {
      const text = await fetched(one, control);
      if (stored && text !== undefined) stored.programs = { ...stored.programs, [control]: text };
    }
    const all = [newest(), read(localStorage)].filter(one => one !== null);
    const used = all.flatMap(one => [
      ...apartIn(one).map(([, { key }]) => key),
      ...besideIn(one).flatMap(({ key }) => key ?? []),
    ]);
    if (stored) await fetchBeside(stored);
    void tidy(used).catch(console.warn);
    return { stored, returned };
  } catch (problem) {
    console.warn("what is kept cannot be read", problem);
    return { stored: null, returned: false };
  }
}

const longPrograms = (state: State): [Dialect, string][] =>
  (Object.entries(state.program.texts) as [Dialect, string][]).filter(([, text]) => text.length > INLINE);

/** Whether it can be told where this program lies. */
function told(control: Dialect, text: string): boolean {
  const base = lying[control];
  const edit = base && difference(base.text, text);
  if (!base || (edit && edit.insert.length > INLINE)) return false;
  said[control] = { key: base.key, ...(edit ? { edit } : {}) };
  return true;
}

/** Whether the database needs nothing more to have the program. */
function lies(control: Dialect, text: string): boolean {
  const base = lying[control];
  if (!base?.own) return false;
  return base.text === text || (text.length > HUGE && told(control, text));
}

function asStored(state: State, flat: Flat, long: [Dialect, string][]): Stored {
  const controls = long.map(([control]) => control);
  const programs = Object.entries(state.program.texts).filter(([control]) => !controls.includes(control as Dialect));
  const apart = controls.flatMap(control => (said[control] ? [[control, said[control]]] : []));
  return {
    ...flat,
    beside: storedBeside(state),
    programs: Object.fromEntries(programs),
    apart: Object.fromEntries(apart),
    by: visit,
  };
}

function write(state: State, flat: Flat): Saved {
  const long = longPrograms(state);
  const all = long.map(([control, text]) => told(control, text)).every(Boolean);
  const besideLies = longBeside(state).every(file => besides.has(file));
  const allLie = besideLies && long.every(([control, text]) => lies(control, text));
  const json = JSON.stringify(asStored(state, flat, long));
  sessionStorage.setItem(STORE, json);
  const newest = read(localStorage);
  const later = Number(newest?.changed ?? 0) > state.page.changed;
  localStorage.setItem(STORE, later ? JSON.stringify(left(newest, state)) : json);
  last = flat;
  return { kept: true, ...(allLie ? {} : { layAfter: all && besideLies ? REST : 0 }) };
}

/**
 * Later work than that of this tab, with what it chose since. If this tab wrote it, it began with a copy and has work
 * of its own now: what lies there is not that any more.
 */
function left(newest: Stored | null, state: State): Flat & Pick<Stored, "by"> {
  const by = newest?.by === visit ? COPY : newest?.by;
  return { ...newest, ...preferences(state), by };
}

/** Keeps what has changed, at once. The browser may keep nothing here (private window) or no more. */
export function save(state: State): Saved {
  const flat = kept(state);
  const names = Object.keys(flat) as (keyof Flat)[];
  if (names.every(name => name in last && flat[name] === last[name])) return { kept: true };
  try {
    return write(state, flat);
  } catch (problem) {
    console.warn("the work is not kept", problem);
    return { kept: false };
  }
}

let laid: Promise<unknown> = Promise.resolve(); // what is under way, and all before it

/** Lays the long programs down in the database, one after the other. false: it takes nothing. */
export function lay(now: () => State): Promise<boolean> {
  const next = laid.then(() => layAll(now));
  laid = next;
  return next;
}

async function layAll(now: () => State): Promise<boolean> {
  try {
    for (const file of longBeside(now())) {
      if (besides.has(file)) continue;
      besides.set(file, await layText(file.text));
      write(now(), kept(now()));
    }
    for (const [control, text] of longPrograms(now())) {
      if (lies(control, text)) continue;
      const key = await layText(text);
      const before = lying[control];
      lying[control] = { key, text, own: true };
      write(now(), kept(now()));
      if (before?.own) await removeText(before.key);
    }
    return true;
  } catch (problem) {
    console.warn("the work is not kept", problem);
    return false;
  }
}
