// Where programs were opened from, as far as the browser lets the page write there again (File System Access). Nothing
// of it outlives the page.

/** What browsers that have it add to what TypeScript knows. */
interface Place extends FileSystemFileHandle {
  requestPermission?(how: { mode: "read" | "readwrite" }): Promise<PermissionState>;
}
interface Picker {
  showOpenFilePicker?(options: {
    multiple: boolean;
    types: { description: string; accept: Record<string, string[]> }[];
  }): Promise<FileSystemFileHandle[]>;
}

/** `changed`: by another program, ms. */
interface Known {
  place: Place;
  changed: number;
}

/** What became of a program that was to be saved; all but the first have written nothing. */
export type Written = "written" | "nowhere" | "denied" | "changed" | "failed";

const known = new Map<number, Known>(); // by when the file was opened

/** `place`: none, where the page was given the content alone. */
export function keepPlace(opened: number | undefined, place: FileSystemFileHandle | undefined, file: File): void {
  if (opened === undefined) return;
  if (place) known.set(opened, { place, changed: file.lastModified });
  else known.delete(opened);
}

/** Whether the page may read it now; the user may be asked. */
export async function mayRead(place: FileSystemFileHandle): Promise<boolean> {
  try {
    await place.getFile();
    return true;
  } catch {
    const asked = await (place as Place).requestPermission?.({ mode: "read" }).catch(() => "denied");
    return asked === "granted";
  }
}

/** Where the file is that was opened then. */
export const placeAt = (opened: number | undefined): FileSystemFileHandle | undefined =>
  opened === undefined ? undefined : known.get(opened)?.place;

/** The same file, read once more. */
export function movePlace(from: number | undefined, to: number): void {
  const place = from === undefined ? undefined : known.get(from);
  if (place) known.set(to, place);
  else known.delete(to);
}

/** Writes to where the file was opened from, once the user lets the page; never over what others wrote there since. */
export async function writeBack(opened: number | undefined, content: Blob): Promise<Written> {
  const here = opened === undefined ? undefined : known.get(opened);
  if (!here) return "nowhere";
  const { place } = here;
  try {
    if (((await place.requestPermission?.({ mode: "readwrite" })) ?? "granted") !== "granted") return "denied";
    if ((await place.getFile()).lastModified !== here.changed) return "changed";
    const stream = await place.createWritable();
    await stream.write(content);
    await stream.close();
    here.changed = (await place.getFile()).lastModified;
    return "written";
  } catch (problem) {
    console.warn("the program is not written to its file", problem);
    return "failed";
  }
}

/** The files that are offered where a program is to be opened. */
export const ENDINGS = [".mpf", ".spf", ".nc", ".txt", ".arc", ".prg", ".def"];

/** Files that the user picks to be opened; null: none; undefined: the browser has no such picker. */
export async function pickPlaces(description: string): Promise<FileSystemFileHandle[] | null | undefined> {
  const picker = globalThis as Picker;
  if (!picker.showOpenFilePicker) return undefined;
  try {
    const types = [{ description, accept: { "text/plain": ENDINGS } }];
    const places = await picker.showOpenFilePicker({ multiple: true, types });
    return places.length ? places : null;
  } catch (problem) {
    return problem instanceof DOMException && problem.name === "AbortError" ? null : undefined;
  }
}
