// By what a text is known again without being kept: whether a program is as it was saved last.

import type { Encoding } from "../encoding";
import type { Pace } from "../pace";

const PIECE = 2 ** 18; // characters between two looks at the clock
const WIDTH = 3; // bytes of UTF-8 for one of them, at most
const KEPT = 2; // texts whose marks are known: a program of each control

/** Two sums of 32 bits over its pieces in UTF-8, four bytes at a time. */
type Sums = [number, number];

const encoder = new TextEncoder();
let room: Uint8Array<ArrayBuffer> | null = null;

function added([a, b]: Sums, text: string, from: number): Sums {
  room ??= new Uint8Array(WIDTH * PIECE + 4);
  const { written } = encoder.encodeInto(text.slice(from, from + PIECE), room);
  room.fill(0, written, written + 4);
  const words = new Int32Array(room.buffer, 0, Math.ceil(written / 4));
  let [one, other] = [a, b];
  for (let at = 0; at < words.length; at++) {
    const word = words[at] as number;
    one = Math.imul(one ^ word, 0x9e3779b1);
    one ^= one >>> 15;
    other = Math.imul(other ^ word, 0x5f356495);
    other ^= other >>> 13;
  }
  return [one, other];
}

const FIRST: Sums = [0x243f6a88, 0x13198a2e];
let lately: readonly { mark: string; text: string }[] = [];

/** What can be told without looking at the characters. */
const head = (text: string, encoding: Encoding): string => `${encoding} ${text.length} `;

function known(text: string, encoding: Encoding, [one, other]: Sums): string {
  const mark = `${head(text, encoding)}${one >>> 0} ${other >>> 0}`;
  lately = [{ mark, text }, ...lately.filter(known => known.mark !== mark)].slice(0, KEPT);
  return mark;
}

/** The mark of a text that is written in this encoding. */
export function markOf(text: string, encoding: Encoding): string {
  let sums = FIRST;
  for (let at = 0; at < text.length; at += PIECE) sums = added(sums, text, at);
  return known(text, encoding, sums);
}

/** The same in slices, for a text of any length. */
export async function markInPieces(text: string, encoding: Encoding, pace: Pace): Promise<string> {
  let sums = FIRST;
  for (let at = 0; at < text.length; at += PIECE) {
    sums = added(sums, text, at);
    await pace.turn(at / text.length);
  }
  return known(text, encoding, sums);
}

/** Whether the mark is that of this text in this encoding. */
export function isMarkOf(mark: string, text: string, encoding: Encoding): boolean {
  if (!mark.startsWith(head(text, encoding))) return false;
  const same = lately.find(
    one => one.mark === mark || (one.text === text && one.mark.startsWith(head(text, encoding))),
  );
  return same ? same.mark === mark && same.text === text : mark === markOf(text, encoding);
}
