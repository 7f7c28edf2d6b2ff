// The editor counts a line break as one character, the program keeps its CR LF. These translate offsets between the
// two.

import type { Pace } from "./pace";

const KEPT = 2; // texts whose pairs are remembered: a program, and the one that it has replaced
const PIECE = 1_000_000; // characters between two looks at the clock

let lately: readonly { text: string; pairs: Int32Array }[] = [];

/** Offsets of the CR of every CR LF. */
function pairs(text: string): Int32Array {
  return lately.find(one => one.text === text)?.pairs ?? remember(text, found(text, 0, text.length));
}

/** `instead`: the text whose place it takes. */
function remember(text: string, pairs: Int32Array, instead?: string): Int32Array {
  lately = [{ text, pairs }, ...lately.filter(one => one.text !== instead)].slice(0, KEPT);
  return pairs;
}

/** Finds the line breaks of a long text ahead of all questions, in slices. */
export async function learn(text: string, pace: Pace): Promise<void> {
  const parts: Int32Array[] = [];
  for (let from = 0; from < text.length; from += PIECE) {
    parts.push(found(text, from, from + PIECE));
    await pace.turn(from / text.length);
  }
  remember(text, joined(parts));
}

/** Offsets of every CR of a CR LF, the CR from `from` on and before `to`. */
function found(text: string, from: number, to: number): Int32Array {
  const part = text.slice(from, to + 1);
  let list = new Int32Array(64);
  let count = 0;
  for (let at = part.indexOf("\r\n"); at >= 0; at = part.indexOf("\r\n", at + 2)) {
    if (count === list.length) list = joined([list, new Int32Array(count)]);
    list[count++] = from + at;
  }
  return list.slice(0, count);
}

function joined(parts: readonly Int32Array[]): Int32Array<ArrayBuffer> {
  const all = new Int32Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/**
 * The pairs after one edit: only around it is the text looked at again, so that a keystroke in a long program stays
 * cheap.
 */
function pairsAfter(before: Int32Array, edit: Splice, text: string): Int32Array {
  const from = Math.max(0, edit.from - 1); // the CR before the edit can lose or find its LF
  const end = edit.from + edit.insert.length;
  const head = before.subarray(
    0,
    countBelow(before, pair => pair < from),
  );
  const tail = before.subarray(countBelow(before, pair => pair < edit.to));
  const shift = end - edit.to;
  return joined([head, found(text, from, end), shift ? tail.map(pair => pair + shift) : tail]);
}

function countBelow(sorted: Int32Array, limit: (pair: number, index: number) => boolean): number {
  let low = 0,
    high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (limit(sorted[middle] as number, middle)) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Offset in the program → offset in the editor. */
export function toEditor(text: string, offset: number): number {
  return offset - countBelow(pairs(text), pair => pair + 1 < offset);
}

/** Offset in the editor → offset in the program. */
export function toProgram(text: string, offset: number): number {
  return offset + countBelow(pairs(text), (pair, index) => pair - index < offset);
}

/** The line break that the program uses. */
export function lineBreak(text: string): string {
  return pairs(text).length > 0 ? "\r\n" : "\n";
}

export interface Splice {
  from: number;
  to: number;
  insert: string;
}

/** Splices that do not overlap, offsets in the text before all of them. */
export function splice(text: string, edits: readonly Splice[]): string {
  const pieces: string[] = [];
  let at = 0;
  for (const edit of [...edits].sort((a, b) => a.from - b.from || a.to - b.to)) {
    pieces.push(text.slice(at, edit.from), edit.insert);
    at = edit.to;
  }
  const result = pieces.join("") + text.slice(at);
  const [only] = edits;
  const known = lately.find(one => one.text === text);
  if (only && edits.length === 1 && known) remember(result, pairsAfter(known.pairs, only, result), text);
  return result;
}

/**
 * Where an offset lies after the edits. What is put in right before it pushes it on; inside of what goes it falls to
 * its begin.
 */
export function carried(at: number, edits: readonly Splice[]): number {
  let moved = at;
  for (const edit of edits) {
    if (at >= edit.to) moved += edit.insert.length - (edit.to - edit.from);
    else if (at > edit.from) moved += edit.from - at;
  }
  return moved;
}
