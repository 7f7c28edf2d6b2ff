// The editor counts a line break as one character, the program keeps its CR LF. These translate offsets between the
// two.

import type { Pace } from "./pace";

const KEPT = 2; // texts that are remembered: a program, and the one that it has replaced
const PIECE = 1_000_000; // characters between two looks at the clock
const STEP = 65_536; // characters between two places to which the line breaks are counted

/** A place in a text, and how many line breaks end before it. */
interface Counted {
  at: number;
  breaks: number;
}

/**
 * `pairs`: offsets of the CR of every CR LF; `counted`: places of a long text, about a step from one to the next;
 * `before`: the text that it was made of, by which edit, and what makes it that again.
 */
interface Known {
  text: string;
  pairs: Int32Array;
  counted?: readonly Counted[] | undefined;
  before?: { text: string; made: Splice; back: Splice };
}

let lately: readonly Known[] = [];

function known(text: string): Known {
  return lately.find(one => one.text === text) ?? remember({ text, pairs: found(text, 0, text.length) });
}

const pairs = (text: string): Int32Array => known(text).pairs;

/** `instead`: the text whose place it takes. */
function remember(one: Known, instead?: string): Known {
  lately = [one, ...lately.filter(({ text }) => text !== instead)].slice(0, KEPT);
  return one;
}

/** Finds the line breaks of a long text ahead of all questions, in slices. */
export async function learn(text: string, pace: Pace): Promise<void> {
  const parts: Int32Array[] = [];
  const counted: Counted[] = [];
  for (let from = 0; from < text.length; from += PIECE) {
    parts.push(found(text, from, from + PIECE));
    count(text, counted, from + PIECE);
    await pace.turn(from / text.length);
  }
  remember({ text, pairs: joined(parts), counted });
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
function pairsAfter(before: Int32Array, edit: Splice, { from, after }: Around): Int32Array {
  const end = edit.from + edit.insert.length;
  const head = before.subarray(
    0,
    countBelow(before, pair => pair < from),
  );
  const tail = before.subarray(countBelow(before, pair => pair < edit.to));
  const shift = end - edit.to;
  const here = found(after, 0, end - from).map(pair => pair + from);
  return joined([head, here, shift ? tail.map(pair => pair + shift) : tail]);
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
  const [only] = edits;
  const one = lately.find(known => known.text === text);
  if (only && edits.length === 1 && one) return spliced(one, only);
  const pieces: string[] = [];
  let at = 0;
  for (const edit of [...edits].sort((a, b) => a.from - b.from || a.to - b.to)) {
    pieces.push(text.slice(at, edit.from), edit.insert);
    at = edit.to;
  }
  return pieces.join("") + text.slice(at);
}

/**
 * One edit, and what follows from it without another look at the whole text. What brings the text before back gives
 * that itself: nothing is copied, and whoever compares the two sees at once that they are the same.
 */
function spliced(one: Known, edit: Splice): string {
  const { text, before } = one;
  const again = before && isSame(before.back, edit);
  const result = again ? before.text : text.slice(0, edit.from) + edit.insert + text.slice(edit.to);
  const around = aroundOf(text, edit);
  const counted = one.counted?.flatMap(known => countedAfter(known, edit, around));
  const pairs = pairsAfter(one.pairs, edit, around);
  const back = { from: edit.from, to: edit.from + edit.insert.length, insert: text.slice(edit.from, edit.to) };
  remember({ text: result, pairs, counted, before: { text, made: edit, back } }, text);
  return result;
}

const isSame = (one: Splice, other: Splice): boolean =>
  one.from === other.from && one.to === other.to && one.insert === other.insert;

/** The edit that has made one of two texts of the other, where that is known. */
export function madeBy(before: string, after: string): Splice | null {
  const [old, now] = [before, after].map(text => lately.find(one => one.text === text)?.before);
  if (now?.text === before) return now.made;
  return old?.text === after ? old.back : null;
}

/** What an edit changes with a character before and after it, as it was and as it is; where that begins. */
interface Around {
  from: number;
  before: string;
  after: string;
}

function aroundOf(text: string, edit: Splice): Around {
  const from = Math.max(0, edit.from - 1); // the CR before the edit can lose or find its LF
  const [head, tail] = [text.slice(from, edit.from), text.slice(edit.to, edit.to + 1)];
  return { from, before: text.slice(from, edit.to + 1), after: head + edit.insert + tail };
}

/** Line breaks whose last character lies from `from` on and before `to`: LF, CR LF, or a CR alone; what is behind. */
function eachBreak(text: string, from: number, to: number, take: (behind: number) => void): void {
  const part = text.slice(from, to);
  let [lf, cr] = [part.indexOf("\n"), part.indexOf("\r")];
  while (lf >= 0 || cr >= 0)
    if (cr >= 0 && (lf < 0 || cr < lf)) {
      if (text.charCodeAt(from + cr + 1) !== 10) take(from + cr + 1);
      cr = part.indexOf("\r", cr + 1);
    } else {
      take(from + lf + 1);
      lf = part.indexOf("\n", lf + 1);
    }
}

function breaksIn(text: string, from: number, to: number): number {
  let count = 0;
  eachBreak(text, from, to, () => count++);
  return count;
}

/** Where each line begins. */
export function beginnings(text: string): number[] {
  const begins = [0];
  eachBreak(text, 0, text.length, behind => begins.push(behind));
  return begins;
}

/** Without their line breaks. */
export function linesOf(text: string): string[] {
  const begins = beginnings(text);
  return begins.map((begin, line) => text.slice(begin, begins[line + 1]).replace(/[\r\n]+$/, ""));
}

const FIRST: Counted = { at: 0, breaks: 0 };

/** Goes on from the last of these places as far as there are steps before `end`. */
function count(text: string, counted: Counted[], end: number): Counted[] {
  let { at, breaks } = counted.at(-1) ?? FIRST;
  for (const most = Math.min(end, text.length); at + STEP <= most; at += STEP) {
    breaks += breaksIn(text, at, at + STEP);
    counted.push({ at: at + STEP, breaks });
  }
  return counted;
}

/** What is still known after one edit; a CR right before it may have become a break, or none. */
function countedAfter({ at, breaks }: Counted, edit: Splice, { from, before, after }: Around): Counted[] {
  if (at <= from) return [{ at, breaks }];
  if (at < edit.to) return [];
  const end = edit.from + edit.insert.length;
  const more = breaksIn(after, 0, end - from) - breaksIn(before, 0, edit.to - from);
  return [{ at: at + end - edit.to, breaks: breaks + more }];
}

/** Line of a place, from 1. */
export function lineAt(text: string, place: number): number {
  const one = known(text);
  one.counted ??= count(text, [], text.length);
  const { at, breaks } = one.counted.findLast(known => known.at <= place) ?? FIRST;
  return 1 + breaks + breaksIn(text, at, place);
}

/** Where the line of a place begins. */
export function lineBegin(text: string, place: number): number {
  let at = place;
  while (at > 0 && text[at - 1] !== "\n" && !(text[at - 1] === "\r" && text[at] !== "\n")) at--;
  return at;
}

/** Where the line after that of a place begins. */
export function lineEnd(text: string, place: number): number {
  const found = /\r\n?|\n/g;
  found.lastIndex = place;
  return found.test(text) ? found.lastIndex : text.length;
}

/** The lines of a text; a break at its end begins none. */
export const lineCount = (text: string): number => lineAt(text, text.length) - (/[\r\n]$/.test(text) ? 1 : 0);

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
