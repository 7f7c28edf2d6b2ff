// What was worked on lately: programs that were opened or saved, and forms that were left. It stays in the browser; a
// program comes from its file where the browser knows it, else as it was kept.

import type { Encoding } from "../encoding";
import type { Dialect } from "../wire";

interface Kept {
  id: string;
  at: number; // ms
  control: Dialect;
}
export interface RecentProgram extends Kept {
  name: string;
  encoding: Encoding;
  calls: number;
  lines: number;
  text: string;
  place?: FileSystemFileHandle | undefined;
}
export interface RecentForm extends Kept {
  cycle: string;
  mvar: number;
  values: Record<string, string>;
}
export type Recent = RecentProgram | RecentForm;

const DATABASE = "probewright-recent-1";
const ITEMS = "items";
const MOST = 8;
/** Characters of a program that is kept, at most. */
export const LONGEST = 4_000_000;

let opened: Promise<IDBDatabase> | null = null;

function database(): Promise<IDBDatabase> {
  opened ??= new Promise((resolve, reject) => {
    const request = indexedDB.open(DATABASE, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(ITEMS, { keyPath: "id" });
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("no database"));
  });
  return opened;
}

async function inItems<T>(mode: IDBTransactionMode, run: (items: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const transaction = (await database()).transaction(ITEMS, mode);
  const request = run(transaction.objectStore(ITEMS));
  return new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve(request.result);
    transaction.onabort = () => reject(transaction.error ?? new Error("not kept"));
  });
}

/** The last first; none where the browser keeps nothing. */
export async function recentItems(): Promise<Recent[]> {
  try {
    const all = (await inItems("readonly", items => items.getAll())) as Recent[];
    return all.sort((a, b) => b.at - a.at);
  } catch (problem) {
    console.warn("what was worked on lately is not known", problem);
    return [];
  }
}

/** Puts it before all others; the oldest goes. */
export async function putRecent(item: Recent): Promise<void> {
  try {
    await inItems("readwrite", items => items.put(item));
    for (const { id } of (await recentItems()).slice(MOST)) await removeRecent(id);
  } catch (problem) {
    console.warn("what was worked on lately is not kept", problem);
  }
}

export async function removeRecent(id: string): Promise<void> {
  await inItems("readwrite", items => items.delete(id));
}
