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

/** Characters that are put at once: the page copies them, which takes some milliseconds. */
const PIECE = 2 ** 19;

/** A text that lies in so many pieces, each under the key of the text and its number. */
interface Pieces {
  pieces: number;
}

const pieceOf = (key: string, number: number): string => `${key}/${number}`;
const PIECE_KEY = /^(.*)\/\d+$/;

/** undefined: nothing lies under this key. */
export async function textAt(key: string): Promise<string | undefined> {
  const found = (await inPrograms("readonly", programs => programs.get(key))) as string | Pieces | undefined;
  if (typeof found !== "object") return found;
  const parts: string[] = [];
  for (let number = 0; number < found.pieces; number++) {
    const part: unknown = await inPrograms("readonly", programs => programs.get(pieceOf(key, number)));
    if (typeof part !== "string") return undefined;
    parts.push(part);
  }
  return parts.join("");
}

/** Under which key the text lies from now on. */
export async function layText(text: string): Promise<string> {
  const key = `${Date.now()}-${Math.random().toString(36).slice(2)}`;
  if (text.length <= PIECE) {
    await inPrograms("readwrite", programs => programs.put(text, key));
    return key;
  }
  await putPieces(key, text);
  return key;
}

/** Each piece once the one before it is taken, so that the page goes on between them; all of them or none. */
async function putPieces(key: string, text: string): Promise<void> {
  const open = await database();
  const pieces = Math.ceil(text.length / PIECE);
  await new Promise<void>((resolve, reject) => {
    const transaction = open.transaction(PROGRAMS, "readwrite");
    const programs = transaction.objectStore(PROGRAMS);
    const from = (number: number): void => {
      if (number < pieces) {
        const part = text.slice(number * PIECE, (number + 1) * PIECE);
        programs.put(part, pieceOf(key, number)).onsuccess = () => from(number + 1);
        return;
      }
      programs.put({ pieces } satisfies Pieces, key);
      transaction.commit(); // the page may end before the answer
    };
    transaction.oncomplete = () => resolve();
    transaction.onabort = () => reject(transaction.error ?? new Error("not kept"));
    from(0);
  });
}

export async function removeText(key: string): Promise<void> {
  await inPrograms("readwrite", programs => programs.delete(key));
  await inPrograms("readwrite", programs => programs.delete(IDBKeyRange.bound(`${key}/`, `${key}/:`)));
}

/** Removes what closed tabs have left for longer than a browser offers to open them again. */
export async function tidy(used: readonly string[]): Promise<void> {
  const keys = await inPrograms("readonly", programs => programs.getAllKeys());
  const texts = new Set(keys.map(key => PIECE_KEY.exec(String(key))?.[1] ?? String(key)));
  for (const key of texts)
    if (!used.includes(key) && Number(/^\d+/.exec(key) ?? 0) < Date.now() - MONTH) await removeText(key);
}
