// A database for long programs. A text that lies there is never changed: a new one has a new key, so that whoever
// refers to a key, another tab too, finds the text that was meant.

const DATABASE = "probewright-1";
const PROGRAMS = "programs";
const MONTH = 30 * 24 * 3600 * 1000; // ms

let opened: Promise<IDBDatabase> | null = null;

function database(): Promise<IDBDatabase> {
  opened ??= new Promise((resolve, reject) => {
    const request = indexedDB.open(DATABASE, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(PROGRAMS);
    request.onsuccess = () => {
      request.result.onclose = () => {
        opened = null;
      };
      resolve(request.result);
    };
    request.onerror = () => {
      opened = null;
      reject(request.error ?? new Error("no database"));
    };
  });
  return opened;
}

async function inPrograms<T>(mode: IDBTransactionMode, run: (programs: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const open = await database();
  return new Promise((resolve, reject) => {
    const transaction = open.transaction(PROGRAMS, mode);
    const request = run(transaction.objectStore(PROGRAMS));
    transaction.oncomplete = () => resolve(request.result);
    transaction.onabort = () => reject(transaction.error ?? new Error("not kept"));
    if (mode === "readwrite") transaction.commit(); // the page may end before the answer
  });
}

/** undefined: nothing lies under this key. */
export async function textAt(key: string): Promise<string | undefined> {
  const text: unknown = await inPrograms("readonly", programs => programs.get(key));
  return typeof text === "string" ? text : undefined;
}

/** Under which key the text lies from now on. */
export async function layText(text: string): Promise<string> {
  const key = `${Date.now()}-${Math.random().toString(36).slice(2)}`;
  await inPrograms("readwrite", programs => programs.put(text, key));
  return key;
}

export async function removeText(key: string): Promise<void> {
  await inPrograms("readwrite", programs => programs.delete(key));
}

/** Removes what closed tabs have left for longer than a browser offers to open them again. */
export async function tidy(used: readonly string[]): Promise<void> {
  const keys = await inPrograms("readonly", programs => programs.getAllKeys());
  for (const key of keys.map(String))
    if (!used.includes(key) && Number(/^\d+/.exec(key) ?? 0) < Date.now() - MONTH) await removeText(key);
}
