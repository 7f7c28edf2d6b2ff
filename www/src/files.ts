// Files in and out. A program's bytes are kept: what is no UTF-8 is taken byte by byte and saved in the same way.

import { el } from "./dom";
import type { Pace } from "./pace";

/** `utf-8-marked`: with a mark at its begin, which is no part of the text: an editor drops that character. */
export const ENCODINGS = ["utf-8", "utf-8-marked", "latin-1"] as const;
export type Encoding = typeof ENCODINGS[number];
export interface ProgramFile { name: string; encoding: Encoding }
/** A file that is not taken: why, as a key with arguments. Nothing else changes. */
export interface Refusal { key: string; args: Record<string, string | number> }

const MEGABYTE = 1e6;
const LARGEST_PROGRAM = 64 * MEGABYTE;
const LARGEST_SETUP = 4 * MEGABYTE;
const PIECE = 2 ** 20; // bytes between two looks at the clock
const CHUNK = 8192; // bytes that one call makes characters of
const MARK = "\ufeff"; // at the begin of some files in UTF-8

/** The text of a file, a piece after the other. */
async function inPieces(file: File, pace: Pace, text: (bytes: Uint8Array, last: boolean) => string): Promise<string> {
  const parts: string[] = [];
  for (let at = 0; at < file.size; at += PIECE) {
    const bytes = await file.slice(at, at + PIECE).arrayBuffer();
    parts.push(text(new Uint8Array(bytes), at + PIECE >= file.size));
    await pace.turn(at / file.size);
  }
  return parts.join("");
}

/** Every byte the character of that number. */
function byBytes(bytes: Uint8Array): string {
  let text = "";
  for (let at = 0; at < bytes.length; at += CHUNK) text += String.fromCharCode(...bytes.subarray(at, at + CHUNK));
  return text;
}

/** UTF-8 where it is that; else byte by byte. */
async function decoded(file: File, pace: Pace): Promise<{ text: string; encoding: Encoding }> {
  const decoder = new TextDecoder("utf-8", { fatal: true, ignoreBOM: true });
  try {
    const text = await inPieces(file, pace, (bytes, last) => decoder.decode(bytes, { stream: !last }));
    return text.startsWith(MARK) ? { text: text.slice(MARK.length), encoding: "utf-8-marked" } : { text, encoding: "utf-8" };
  } catch (problem) {
    if (!(problem instanceof TypeError)) throw problem;
    return { text: await inPieces(file, pace, byBytes), encoding: "latin-1" };
  }
}

/** null: a character that the encoding lacks was typed in. */
export function encode(text: string, encoding: Encoding): Uint8Array<ArrayBuffer> | null {
  if (encoding !== "latin-1") return new TextEncoder().encode(encoding === "utf-8-marked" ? MARK + text : text);
  const bytes = new Uint8Array(text.length);
  for (let at = 0; at < text.length; at++) {
    const code = text.charCodeAt(at);
    if (code > 0xff) return null;
    bytes[at] = code;
  }
  return bytes;
}

function tooLarge(key: string, file: File, most: number): Refusal {
  return { key, args: { name: file.name, size: Math.ceil(file.size / MEGABYTE), most: most / MEGABYTE } };
}

export async function readProgram(file: File, pace: Pace): Promise<{ text: string; file: ProgramFile } | Refusal> {
  if (file.size > LARGEST_PROGRAM) return tooLarge("refused-program-size", file, LARGEST_PROGRAM);
  try {
    const { text, encoding } = await decoded(file, pace);
    return { text, file: { name: file.name, encoding } };
  } catch (problem) {
    if (!(problem instanceof DOMException)) throw problem;
    return { key: "refused-unreadable", args: { name: file.name } };
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
