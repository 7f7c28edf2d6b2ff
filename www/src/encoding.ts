// In which encoding a program is written. What is read is written again with the same bytes, whatever they are: a byte
// that stands for no character, or for one that would be written with other bytes, is held as a character of its own.
// Browsers decode only; what is written follows from what they decode (tables.ts).

import type { Pace } from "./pace";
import { doubleByte, gb18030, gbk, singleByte, type Table } from "./tables";

/**
 * Labels of the WHATWG encoding standard. `-marked`: with a byte order mark, which is no part of the text: an editor
 * drops that character. `latin-1`: every byte the character of that number.
 */
export const ENCODINGS = [
  "utf-8",
  "utf-8-marked",
  "utf-16le",
  "utf-16le-marked",
  "utf-16be",
  "utf-16be-marked",
  "gbk",
  "gb18030",
  "big5",
  "shift_jis",
  "euc-kr",
  "windows-1252",
  "windows-1250",
  "windows-1251",
  "latin-1",
] as const;
export type Encoding = (typeof ENCODINGS)[number];

/** The character that holds byte 0; behind it those of the others. Nobody has a character there. */
const RAW = 0xef00;
const HELD = /[\uef00-\uefff]/;
/** What the editor marks. */
export const HELD_BYTE = /[\uef00-\uefff]/gu;

const isHeld = (point: number): boolean => point >= RAW && point <= RAW + 0xff;

/** Figures of the byte that a character holds; null: it holds none. */
export function heldByte(code: number): string | null {
  return isHeld(code) ? (code - RAW).toString(16).toUpperCase().padStart(2, "0") : null;
}

/** Bytes between two looks at the clock. */
export const PIECE = 2 ** 20;
const CHUNK = 8192; // characters that one call makes
const MARK = 0xfeff;
const LOST = 0xfffd; // half of a character, which no encoding has

/** One character at a time. `read`: how many bytes it has, and which it is, -1 for none; `write`: its bytes. */
interface Coder {
  /** Whether a byte below 0x80 is that character. */
  ascii: boolean;
  read(bytes: Uint8Array, at: number): { length: number; point: number };
  write(point: number): number[] | null;
}

const NONE = { length: 1, point: -1 };

const utf8: Coder = {
  ascii: true,
  read(bytes, at) {
    const lead = bytes[at] as number;
    const length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    let point = lead & (0x7f >> length);
    for (let next = 1; next < length; next++) {
      const byte = bytes[at + next] ?? 0;
      if (byte >> 6 !== 2) return NONE;
      point = (point << 6) | (byte & 0x3f);
    }
    const shortest = [0x80, 0x800, 0x10000][length - 2] as number;
    const sound = lead >= 0xc2 && lead <= 0xf4 && point >= shortest && point <= 0x10ffff && point >> 11 !== 0x1b;
    return sound ? { length, point } : NONE;
  },
  write: point => [...new TextEncoder().encode(String.fromCodePoint(point))],
};

function utf16(high: 0 | 1): Coder {
  const unit = (bytes: Uint8Array, at: number): number => ((bytes[at + high] ?? 0) << 8) | (bytes[at + 1 - high] ?? 0);
  const written = (unit: number): number[] => (high ? [unit & 0xff, unit >> 8] : [unit >> 8, unit & 0xff]);
  return {
    ascii: false,
    read(bytes, at) {
      if (at + 1 >= bytes.length) return NONE;
      const first = unit(bytes, at);
      if (first >> 11 !== 0x1b) return { length: 2, point: first };
      const second = at + 3 < bytes.length ? unit(bytes, at + 2) : 0;
      const pair = first >> 10 === 0x36 && second >> 10 === 0x37;
      return pair
        ? { length: 4, point: (((first & 0x3ff) << 10) | (second & 0x3ff)) + 0x10000 }
        : { length: 2, point: -1 };
    },
    write: point =>
      point < 0x10000
        ? written(point)
        : [0xd800 | ((point - 0x10000) >> 10), 0xdc00 | (point & 0x3ff)].flatMap(written),
  };
}

/** A table, and what it reads only where it writes the same. */
function byTable(table: Table): Coder {
  return {
    ascii: true,
    read(bytes, at) {
      const { length, point } = table.read(bytes, at);
      const back = point < 0 ? null : table.write(point);
      return back?.length === length && back.every((byte, index) => byte === bytes[at + index])
        ? { length, point }
        : NONE;
    },
    write: table.write,
  };
}

const latin1: Coder = {
  ascii: true,
  read: (bytes, at) => ({ length: 1, point: bytes[at] as number }),
  write: point => (point < 0x100 ? [point] : null),
};

const made = new Map<string, Coder>();

function make(label: string): Coder {
  switch (label) {
    case "utf-8":
      return utf8;
    case "utf-16le":
      return utf16(1);
    case "utf-16be":
      return utf16(0);
    case "latin-1":
      return latin1;
    case "gbk":
      return byTable(gbk());
    case "gb18030":
      return byTable(gb18030());
    case "big5":
      return byTable(doubleByte(label, lead => lead < 0xa1)); // Hong Kong's additions are written last
    case "shift_jis":
      return byTable(doubleByte(label, lead => lead === 0xed || lead === 0xee)); // as are NEC's copies of IBM's
    case "euc-kr":
      return byTable(doubleByte(label));
    default:
      return byTable(singleByte(label));
  }
}

const isMarked = (encoding: Encoding): boolean => encoding.endsWith("-marked");

/** Its tables are made when somebody needs them. */
function coderOf(encoding: Encoding): Coder {
  const label = encoding.replace("-marked", "");
  const known = made.get(label) ?? make(label);
  made.set(label, known);
  return known;
}

/** Whether it has every character that can be typed. */
export function hasAll(encoding: Encoding): boolean {
  return encoding.startsWith("utf-");
}

/** The one of the two that differ by their mark which these bytes have. */
export function asMarked(bytes: Uint8Array, encoding: Encoding): Encoding {
  const plain = encoding.replace("-marked", "") as Encoding;
  const marked = hasAll(plain) && coderOf(plain).read(bytes, 0).point === MARK;
  return marked ? (`${plain}-marked` as Encoding) : plain;
}

function textOf(units: Uint16Array): string {
  let text = "";
  for (let at = 0; at < units.length; at += CHUNK) text += String.fromCharCode(...units.subarray(at, at + CHUNK));
  return text;
}

/** The characters that begin from `from` on and before `to`; `next`: where the next one begins. */
function piece(coder: Coder, bytes: Uint8Array, from: number, to: number): { text: string; next: number } {
  const units = new Uint16Array(2 * (to - from) + 4);
  let count = 0;
  let at = from;
  while (at < to) {
    const byte = bytes[at] as number;
    if (coder.ascii && byte < 0x80) {
      units[count++] = byte;
      at++;
      continue;
    }
    const { length, point } = coder.read(bytes, at);
    const none = point < 0 || isHeld(point);
    const taken = none && coder.ascii ? 1 : length;
    if (none) for (let next = at; next < at + taken; next++) units[count++] = RAW + (bytes[next] as number);
    else if (point < 0x10000) units[count++] = point;
    else {
      units[count++] = 0xd800 | ((point - 0x10000) >> 10);
      units[count++] = 0xdc00 | (point & 0x3ff);
    }
    at += taken;
  }
  return { text: textOf(units.subarray(0, count)), next: at };
}

/** The same by the browser's own decoder, many times faster, where every character is whole. */
function wholePiece(bytes: Uint8Array, from: number, to: number): { text: string; next: number } | null {
  let next = Math.min(to, bytes.length);
  while (next < bytes.length && (bytes[next] as number) >> 6 === 2) next++;
  try {
    const text = new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes.subarray(from, next));
    return HELD.test(text) ? null : { text, next };
  } catch {
    return null;
  }
}

/** Bytes that come in pieces, as those of a file. */
export interface Bytes {
  length: number;
  /** From a place on: all that are left, or some characters more than a piece. */
  from(at: number): Promise<Uint8Array> | Uint8Array;
}

export const decode = (bytes: Uint8Array, encoding: Encoding, pace: Pace): Promise<string> =>
  decodeFrom({ length: bytes.length, from: at => bytes.subarray(at) }, encoding, pace);

export async function decodeFrom(all: Bytes, encoding: Encoding, pace: Pace): Promise<string> {
  const coder = coderOf(encoding);
  const parts: string[] = [];
  for (let at = 0; at < all.length; ) {
    const bytes = await all.from(at);
    const marked = at === 0 && isMarked(encoding) && coder.read(bytes, 0).point === MARK;
    const begin = marked ? coder.read(bytes, 0).length : 0;
    const to = Math.min(begin + PIECE, bytes.length);
    const { text, next } = (coder === utf8 ? wholePiece(bytes, begin, to) : null) ?? piece(coder, bytes, begin, to);
    parts.push(text);
    at += next;
    await pace.turn(at / all.length);
  }
  return parts.join("");
}

/** A pair of surrogates or a unit alone; half a pair is the sign for a lost character. */
function pointAt(text: string, at: number): number {
  const point = text.codePointAt(at) as number;
  return point >> 11 === 0x1b ? LOST : point;
}

/** Where the first character stands that the encoding lacks, from `from` on and before `to`; -1: nowhere. */
export function lacking(text: string, encoding: Encoding, from = 0, to = text.length): number {
  if (hasAll(encoding)) return -1;
  const coder = coderOf(encoding);
  const half = from > 0 && text.charCodeAt(from) >> 10 === 0x37;
  for (let at = half ? from - 1 : from; at < to; at++) {
    if (text.charCodeAt(at) < 0x80) continue;
    const point = pointAt(text, at);
    if (!isHeld(point) && !coder.write(point)) return at;
    if (point > 0xffff) at++;
  }
  return -1;
}

/** Where a piece of a text ends that begins there: it parts no pair of surrogates. */
export function pieceEnd(text: string, from: number): number {
  const to = Math.min(from + PIECE, text.length);
  return text.charCodeAt(to - 1) >> 10 === 0x36 && to < text.length ? to - 1 : to;
}

/** As [`encode`], for a text of any length. */
export async function encodeInPieces(text: string, encoding: Encoding, pace: Pace): Promise<Blob | null> {
  const plain = encoding.replace("-marked", "") as Encoding;
  const parts: Blob[] = [];
  let from = 0;
  do {
    const to = pieceEnd(text, from);
    const bytes = encode(text.slice(from, to), from === 0 ? encoding : plain);
    if (!bytes) return null;
    parts.push(new Blob([bytes]));
    from = to;
    await pace.turn(from / text.length);
  } while (from < text.length);
  return new Blob(parts);
}

/** null: a character was typed in that the encoding lacks. */
export function encode(text: string, encoding: Encoding): Uint8Array<ArrayBuffer> | null {
  const coder = coderOf(encoding);
  const marked = isMarked(encoding) ? String.fromCharCode(MARK) : "";
  if (coder === utf8 && !HELD.test(text)) return new TextEncoder().encode(marked + text);
  const all = marked + text;
  let bytes = new Uint8Array(2 * all.length + 16);
  let count = 0;
  for (let at = 0; at < all.length; at++) {
    if (count + 4 > bytes.length) bytes = grown(bytes);
    const unit = all.charCodeAt(at);
    if (coder.ascii && unit < 0x80) {
      bytes[count++] = unit;
      continue;
    }
    const point = pointAt(all, at);
    const written = isHeld(point) ? [point - RAW] : coder.write(point);
    if (!written) return null;
    for (const byte of written) bytes[count++] = byte;
    if (point > 0xffff) at++;
  }
  return bytes.slice(0, count);
}

function grown(bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  const larger = new Uint8Array(2 * bytes.length);
  larger.set(bytes);
  return larger;
}
