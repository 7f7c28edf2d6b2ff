// What differs between two states of a program, in time that a program of a million lines leaves for it.

import { madeBy, type Splice } from "./eol";

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

/**
 * A replacement that turns `before` into `after` and parts no CR LF, the smallest one unless the edit is known between
 * them; null: they are the same.
 */
export function difference(before: string, after: string): Splice | null {
  if (before === after) return null;
  const made = madeBy(before, after);
  const edit = made ? within(before, made) : smallest(before, after);
  const from = edit.from - (edit.from > 0 && before[edit.from - 1] === "\r" ? 1 : 0);
  const to = edit.to + (edit.to < before.length && before[edit.to] === "\n" ? 1 : 0);
  return { from, to, insert: before.slice(from, edit.from) + edit.insert + before.slice(edit.to, to) };
}

function smallest(before: string, after: string): Splice {
  const start = commonStart(before, after);
  const end = commonEnd(before, after, Math.min(before.length, after.length) - start);
  return { from: start, to: before.length - end, insert: after.slice(start, after.length - end) };
}

/** An edit of this text without what it leaves as it is. */
function within(text: string, { from, to, insert }: Splice): Splice {
  const edit = smallest(text.slice(from, to), insert);
  return { ...edit, from: from + edit.from, to: from + edit.to };
}
