// Files in and out. What a file is the core tells by its bytes.

import type { ProgramCore } from "../core/program";
import { el } from "../dom";
import { type Bytes, decodeFrom, type Encoding, PIECE } from "../encoding";
import { type Pace, sliced, within } from "../pace";
import { say, t } from "../texts";
import type { Dialect, Recognised } from "../wire";
import { markupOf } from "./looks";
import { markInPieces } from "./mark";

/** `opened`: when, ms; what is not opened from a file has none. */
export interface ProgramFile {
  name: string;
  encoding: Encoding;
  opened?: number;
}

/** A file beside the program: a subprogram, a definition file, another program. */
export interface BesideFile extends ProgramFile {
  text: string;
}

let last = 0;

/** Now, as the time when a file is opened: no two have the same. */
export function openedNow(): number {
  last = Math.max(Date.now(), last + 1);
  return last;
}

/** Where the programs come from. */
export type Files = Partial<Record<Dialect, ProgramFile>>;

/** Where the program that is shown comes from; what comes from nowhere is saved under the usual name. */
export function fileOf(state: { form: { control: Dialect }; program: { files: Files } }): ProgramFile {
  const { control } = state.form;
  return state.program.files[control] ?? { name: t(`program-file-${control}`), encoding: "utf-8" };
}

/** A file that is not taken: why, as a key with arguments. Nothing else changes. */
export interface Refusal {
  key: string;
  args: Record<string, string | number>;
  /** The file was taken, but is meant for this control. */
  control?: Dialect;
  /** It was taken, and there is a doubt. */
  taken?: true;
}

const MEGABYTE = 1e6;
const LARGEST_SETUP = 4 * MEGABYTE;
const WINDOW = 2 ** 23; // bytes of a file that are there at once
const BEHIND = 16; // bytes, some characters
const TIMES = 3; // bytes that the page needs for one of a program: while it is put together, and its lines

const megabytes = (file: File): number => Math.ceil(file.size / MEGABYTE);

/** Why a file is not taken that has more than so many bytes. */
export function tooLarge(key: string, file: File, most: number): Refusal {
  return { key, args: { name: file.name, size: megabytes(file), most: most / MEGABYTE } };
}

/** Why a program is not taken that the browser cannot hold. */
const notHeld = (file: File): Refusal => ({
  key: "refused-program-size",
  args: { name: file.name, size: megabytes(file) },
});

/** What Chromium tells of the memory of a page. */
interface Memory {
  jsHeapSizeLimit: number;
  usedJSHeapSize: number;
}

/** Whether the browser has texts of so many characters, and room for one. */
function holds(characters: number): boolean {
  const { memory } = performance as { memory?: Memory };
  if (memory && TIMES * characters > memory.jsHeapSizeLimit - memory.usedJSHeapSize) return false;
  try {
    return "0".repeat(characters).length >= Math.floor(characters); // takes no room before somebody looks at it
  } catch {
    return false;
  }
}

/** The bytes of a file, of which a part is there at a time. */
function bytesOf(file: File): Bytes {
  let window = new Uint8Array();
  let start = 0;
  const has = (at: number): boolean => {
    const end = start + window.length;
    return at >= start && (at + PIECE + BEHIND <= end || (at < end && end === file.size));
  };
  return {
    length: file.size,
    async from(at) {
      if (!has(at)) {
        window = new Uint8Array(await file.slice(at, at + WINDOW).arrayBuffer());
        start = at;
      }
      if (!has(at)) throw new DOMException("the file is another one", "NotReadableError");
      return window.subarray(at - start);
    },
  };
}

/** How a program is encoded, or why the file is none. */
async function recognised(
  bytes: Bytes,
  core: ProgramCore,
  pace: Pace,
): Promise<Extract<Recognised, { encoding: Encoding }> | { why: string }> {
  const recogniser = core.recogniser();
  for (let at = 0; at < bytes.length; at += PIECE) {
    recogniser.take((await bytes.from(at)).subarray(0, PIECE));
    await pace.turn(at / bytes.length);
  }
  const found = recogniser.finish();
  return "why" in found ? { why: say(found.why) } : found;
}

export async function readProgram(
  file: File,
  core: ProgramCore,
  pace: Pace,
): Promise<{ text: string; file: ProgramFile; mark: string; control?: Dialect } | Refusal> {
  const { name } = file;
  const bytes = bytesOf(file);
  if (!holds(file.size / 4)) return notHeld(file); // a character has four bytes at most
  try {
    const found = await recognised(bytes, core, within(pace, 0, 0.5));
    if ("why" in found) return { key: "refused-no-program", args: { name, ...found } };
    if (found.log) return { key: "refused-no-program", args: { name, why: say(found.log) } };
    const { encoding, control } = found;
    if (!holds(encoding.startsWith("utf-16") ? file.size / 2 : file.size)) return notHeld(file);
    const text = await decodeFrom(bytes, encoding, within(pace, 0.5, 0.9));
    const kind = markupOf(text);
    if (kind) return { key: "refused-no-program", args: { name, why: t("refused-markup", { kind }) } };
    const mark = await markInPieces(text, encoding, within(pace, 0.9, 1));
    return { text, file: { name, encoding, opened: openedNow() }, mark, ...(control && { control }) };
  } catch (problem) {
    if (problem instanceof RangeError) return notHeld(file);
    if (!(problem instanceof DOMException)) throw problem;
    return { key: "refused-unreadable", args: { name } };
  }
}

/** The text of a file that is no program (a protocol, a scenario, a script), whatever its encoding. */
export async function readText(file: File, core: ProgramCore): Promise<string | Refusal> {
  const { name } = file;
  const bytes = bytesOf(file);
  try {
    const found = await recognised(bytes, core, sliced());
    if ("why" in found) return { key: "refused-no-text", args: { name, ...found } };
    return await decodeFrom(bytes, found.encoding, sliced());
  } catch (problem) {
    if (!(problem instanceof DOMException)) throw problem;
    return { key: "refused-unreadable", args: { name } };
  }
}

/** The texts of several files, or why one is not taken. */
export async function readTexts(files: readonly File[], core: ProgramCore): Promise<string[] | Refusal> {
  const read = await Promise.all(files.map(file => readText(file, core)));
  const refused = read.find(one => typeof one !== "string");
  return refused ?? read.filter(one => typeof one === "string");
}

/** What a machine exported: an archive may have parts that are no text, the others are read. */
export async function readExported(file: File, core: ProgramCore): Promise<{ name: string; text: string }> {
  const read = await readText(file, core);
  return {
    name: file.name,
    text: typeof read === "string" ? read : new TextDecoder().decode(await file.arrayBuffer()),
  };
}

/** The text of a setup file; whether it is a setup the core says. */
export async function readSetup(file: File, core: ProgramCore): Promise<string | Refusal> {
  return file.size > LARGEST_SETUP ? tooLarge("refused-setup-size", file, LARGEST_SETUP) : readText(file, core);
}

export function saveFile(content: BlobPart, name: string, type = "text/plain"): void {
  const url = URL.createObjectURL(new Blob([content], { type }));
  const link = el("a", { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
