// Files in and out. What a file is the core tells by its bytes.

import type { ProgramCore } from "../core/program";
import { el } from "../dom";
import { decode, type Encoding } from "../encoding";
import { type Pace, within } from "../pace";
import { say, t } from "../texts";
import type { Dialect } from "../wire";
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
}

const MEGABYTE = 1e6;
const LARGEST_PROGRAM = 64 * MEGABYTE;
const LARGEST_SETUP = 4 * MEGABYTE;
const PIECE = 2 ** 20; // bytes between two looks at the clock

/** Why a file is not taken that has more than so many bytes. */
export function tooLarge(key: string, file: File, most: number): Refusal {
  return { key, args: { name: file.name, size: Math.ceil(file.size / MEGABYTE), most: most / MEGABYTE } };
}

/** How a program is encoded, or why the file is none. */
async function recognised(bytes: Uint8Array, core: ProgramCore, pace: Pace): Promise<Encoding | { why: string }> {
  const recogniser = core.recogniser();
  for (let at = 0; at < bytes.length; at += PIECE) {
    recogniser.take(bytes.subarray(at, at + PIECE));
    await pace.turn(at / bytes.length);
  }
  const found = recogniser.finish();
  return "why" in found ? { why: say(found.why) } : found.encoding;
}

export async function readProgram(
  file: File,
  core: ProgramCore,
  pace: Pace,
): Promise<{ text: string; file: ProgramFile; mark: string } | Refusal> {
  if (file.size > LARGEST_PROGRAM) return tooLarge("refused-program-size", file, LARGEST_PROGRAM);
  const { name } = file;
  try {
    const bytes = new Uint8Array(await file.arrayBuffer());
    const encoding = await recognised(bytes, core, within(pace, 0, 0.5));
    if (typeof encoding !== "string") return { key: "refused-no-program", args: { name, ...encoding } };
    const text = await decode(bytes, encoding, within(pace, 0.5, 0.9));
    const mark = await markInPieces(text, encoding, within(pace, 0.9, 1));
    return { text, file: { name, encoding, opened: openedNow() }, mark };
  } catch (problem) {
    if (!(problem instanceof DOMException)) throw problem;
    return { key: "refused-unreadable", args: { name } };
  }
}

/** The text of a setup file; whether it is a setup the core says. */
export async function readSetup(file: File): Promise<string | Refusal> {
  if (file.size > LARGEST_SETUP) return tooLarge("refused-setup-size", file, LARGEST_SETUP);
  try {
    return await file.text();
  } catch {
    return { key: "refused-unreadable", args: { name: file.name } };
  }
}

export function saveFile(content: BlobPart, name: string, type = "text/plain"): void {
  const url = URL.createObjectURL(new Blob([content], { type }));
  const link = el("a", { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
