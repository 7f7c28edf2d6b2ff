// What differs between two states of a program, in time that a program of a million lines leaves for it.

import type { Splice } from "./eol";

const STRIDE = 16_384; // characters compared at once

function commonStart(a: string, b: string): number {
  const most = Math.min(a.length, b.length);
  let at = 0;
  while (at + STRIDE <= most && a.slice(at, at + STRIDE) === b.slice(at, at + STRIDE)) at += STRIDE;
  while (at < most && a.charCodeAt(at) === b.charCodeAt(at)) at++;
  return at;
}

/** How many characters at the end are the same; at most `most`. */
function commonEnd(a: string, b: string, most: number): number {
  const same = (count: number, length: number): boolean =>
    a.slice(a.length - count - length, a.length - count) === b.slice(b.length - count - length, b.length - count);
  let count = 0;
  while (count + STRIDE <= most && same(count, STRIDE)) count += STRIDE;
  while (count < most && same(count, 1)) count++;
  return count;
}

/** The smallest replacement that turns `before` into `after` and parts no CR LF; null: they are the same. */
export function difference(before: string, after: string): Splice | null {
  if (before === after) return null;
  let start = commonStart(before, after);
  let end = commonEnd(before, after, Math.min(before.length, after.length) - start);
  if (start > 0 && before[start - 1] === "\r") start--;
  if (end > 0 && before[before.length - end] === "\n") end--;
  return { from: start, to: before.length - end, insert: after.slice(start, after.length - end) };
}
