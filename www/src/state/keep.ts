// The work is kept in the browser. Local storage is written even while the page is left, but holds little; a long
// program lies in a database beside it. Where the page is open twice, the newest work of all is what a new tab begins
// with, and each tab comes back to its own, which session storage holds; of long programs there is only the newest.

import type { Dialect } from "../wire";
import type { State } from "./state";
import { type Flat, kept } from "./stored";

const STORE = "probewright-1";
const PROGRAMS = "programs";
const LONG = 200_000; // characters of a program that no longer goes into local storage

/** `by`: which visit of the page wrote it. */
interface Stored extends Flat {
  programs?: Partial<Record<Dialect, string>>;
  apart?: Dialect[];
  by?: string;
}

const visit = Math.random().toString(36).slice(2);

function database(): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(STORE, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(PROGRAMS);
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("no database"));
  });
}

async function inPrograms<T>(mode: IDBTransactionMode, run: (programs: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const open = await database();
  try {
    return await new Promise<T>((resolve, reject) => {
      const transaction = open.transaction(PROGRAMS, mode);
      const request = run(transaction.objectStore(PROGRAMS));
      transaction.oncomplete = () => resolve(request.result);
      transaction.onabort = () => reject(transaction.error ?? new Error("not kept"));
    });
  } finally {
    open.close();
  }
}

const lying: Partial<Record<Dialect, string>> = {}; // what the database holds

async function put(control: Dialect, text: string): Promise<void> {
  if (lying[control] === text) return;
  await inPrograms("readwrite", programs => programs.put(text, control));
  lying[control] = text;
}

const read = (storage: Storage): Stored | null => JSON.parse(storage.getItem(STORE) ?? "null") as Stored | null;

/** What the last visit left; what this tab left, where another one wrote since. */
function newest(): Stored | null {
  const [own, last] = [read(sessionStorage), read(localStorage)];
  return own && last?.by !== own.by ? own : last;
}

export async function load(): Promise<Flat | null> {
  try {
    const stored = newest();
    for (const control of stored?.apart ?? []) {
      const text: unknown = await inPrograms("readonly", programs => programs.get(control));
      if (!stored || typeof text !== "string") continue;
      lying[control] = text;
      stored.programs = { ...stored.programs, [control]: text };
    }
    return stored;
  } catch (problem) {
    console.warn("what is kept cannot be read", problem);
    return null;
  }
}

/** false: the browser keeps nothing here (private window) or no more. What goes into local storage is there at once. */
export async function save(state: State): Promise<boolean> {
  const programs = Object.entries(state.program.texts) as [Dialect, string][];
  const apart = programs.filter(([, text]) => text.length > LONG);
  const short = Object.fromEntries(programs.filter(([, text]) => text.length <= LONG));
  try {
    const stored: Stored = { ...kept(state), programs: short, apart: apart.map(([control]) => control), by: visit };
    for (const storage of [localStorage, sessionStorage]) storage.setItem(STORE, JSON.stringify(stored));
    for (const [control, text] of apart) await put(control, text);
    return true;
  } catch (problem) {
    console.warn("the work is not kept", problem);
    return false;
  }
}
