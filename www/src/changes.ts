// What edits do to a text, line by line: lines that go and come beside each other, with what stands around them.

import { beginnings, linesOf, type Splice } from "./eol";

/** A line, counted from 1. */
export interface Line {
  line: number;
  text: string;
}
/** Lines beside each other. Both: the same, where `same`, else one that became another. */
export interface Row {
  before: Line | null;
  after: Line | null;
  same: boolean;
}
/** Changes that stand near each other, with the lines around them. */
export type Hunk = Row[];
export interface Part {
  text: string;
  marked: boolean;
}

const CONTEXT = 2; // lines shown around a change
const MOST_PAIRS = 90_000; // of lines or words that are compared each with each
const ALIKE = 0.3; // of the characters: lines with fewer in common are marked as a whole

/** Lines of the old text, from 0, and what becomes of them. */
interface Block {
  first: number;
  last: number;
  edits: Splice[];
}

/** The line that holds a place; the search goes on from `from`. */
function lineAt(begins: readonly number[], place: number, from: number): number {
  let line = from;
  while (line + 1 < begins.length && (begins[line + 1] as number) <= place) line++;
  return line;
}

function blocks(text: string, edits: readonly Splice[], begins: readonly number[]): Block[] {
  const all: Block[] = [];
  let line = 0;
  for (const edit of [...edits].sort((a, b) => a.from - b.from || a.to - b.to)) {
    // where an LF comes behind a CR, the line of that CR ends later
    const joins = text[edit.from - 1] === "\r" && (edit.insert === "" || edit.insert.startsWith("\n"));
    line = lineAt(begins, joins ? edit.from - 1 : edit.from, line);
    const last = lineAt(begins, edit.to, line);
    const before = all.at(-1);
    if (before && before.last >= line) {
      before.last = Math.max(before.last, last);
      before.edits.push(edit);
    } else all.push({ first: line, last, edits: [edit] });
  }
  return all;
}

/** How far each beginning of one list agrees with each of the other, from behind. */
function common<T>(one: readonly T[], other: readonly T[]): ((i: number, j: number) => number) | null {
  const width = other.length + 1;
  if (one.length * other.length > MOST_PAIRS) return null;
  const longest = new Uint16Array((one.length + 1) * width);
  const at = (i: number, j: number): number => longest[i * width + j] ?? 0;
  for (let i = one.length - 1; i >= 0; i--)
    for (let j = other.length - 1; j >= 0; j--)
      longest[i * width + j] = one[i] === other[j] ? at(i + 1, j + 1) + 1 : Math.max(at(i + 1, j), at(i, j + 1));
  return at;
}

type Pair<T> = [T | null, T | null];

/** Two lists beside each other: what is the same in both, and what stands in one of them between that. */
function beside<T>(one: readonly T[], other: readonly T[]): Pair<T>[] {
  const longest = common(one, other);
  const pairs: Pair<T>[] = [];
  let i = 0;
  let j = 0;
  while (longest && i < one.length && j < other.length) {
    if (one[i] === other[j]) pairs.push([one[i++] as T, other[j++] as T]);
    else if (longest(i + 1, j) >= longest(i, j + 1)) pairs.push([one[i++] as T, null]);
    else pairs.push([null, other[j++] as T]);
  }
  while (i < one.length) pairs.push([one[i++] as T, null]);
  while (j < other.length) pairs.push([null, other[j++] as T]);
  return pairs;
}

/** The lines of a block as rows; a line that goes stands beside one that comes. */
function rowsOf(before: readonly string[], after: readonly string[], first: number, shift: number): Row[] {
  const rows: Row[] = [];
  let [line, now] = [first + 1, first + 1 + shift];
  let waiting = 0; // rows at the end with a line that goes and none that comes
  for (const [one, other] of beside(before, after)) {
    if (one !== null && other !== null) {
      rows.push({ before: { line: line++, text: one }, after: { line: now++, text: other }, same: true });
      waiting = 0;
    } else if (one !== null) {
      rows.push({ before: { line: line++, text: one }, after: null, same: false });
      waiting++;
    } else if (other !== null) {
      const beside = waiting > 0 ? rows[rows.length - waiting--] : undefined;
      const coming = { line: now++, text: other };
      if (beside) beside.after = coming;
      else rows.push({ before: null, after: coming, same: false });
    }
  }
  return rows;
}

/** What edits, with places in `text`, do to it. */
export function changes(text: string, edits: readonly Splice[]): Hunk[] {
  const begins = beginnings(text);
  const endOf = (line: number): number => begins[line + 1] ?? text.length;
  // the end of its last line begins no line of its own, but for the last one of the text
  const upTo = (last: number, piece: string): string[] =>
    last + 1 < begins.length ? linesOf(piece).slice(0, -1) : linesOf(piece);
  const lines = (from: number, to: number): string[] =>
    from < to ? upTo(to - 1, text.slice(begins[from], endOf(to - 1))) : [];
  const hunks: Hunk[] = [];
  let hunk: Hunk = [];
  let [done, shift] = [0, 0]; // lines that are shown or passed, and how much later the next one stands afterwards
  const unchanged = (from: number, to: number): Row[] =>
    lines(from, to).map((one, index) => ({
      before: { line: from + index + 1, text: one },
      after: { line: from + index + 1 + shift, text: one },
      same: true,
    }));
  for (const { first, last, edits: own } of blocks(text, edits, begins)) {
    const [start, end] = [begins[first] as number, endOf(last)];
    let [at, made] = [start, ""];
    for (const edit of own) {
      made += text.slice(at, Math.max(at, edit.from)) + edit.insert;
      at = Math.max(at, edit.to);
    }
    made += text.slice(at, end);
    const [before, after] = [upTo(last, text.slice(start, end)), upTo(last, made)];
    if (hunk.length && first - done > 2 * CONTEXT) {
      hunk.push(...unchanged(done, done + CONTEXT));
      hunks.push(hunk);
      hunk = [];
    }
    hunk.push(...unchanged(hunk.length ? done : Math.max(done, first - CONTEXT), first));
    hunk.push(...rowsOf(before, after, first, shift));
    shift += after.length - before.length;
    done = last + 1;
  }
  if (hunk.length) hunks.push([...hunk, ...unchanged(done, Math.min(done + CONTEXT, begins.length))]);
  return hunks.filter(one => one.some(row => !row.same));
}

/** How often lines that change stand together. */
export function countChanges(hunks: readonly Hunk[]): number {
  return hunks.reduce(
    (sum, hunk) => sum + hunk.filter((row, at) => !row.same && (hunk[at - 1]?.same ?? true)).length,
    0,
  );
}

const WORDS = /[\p{L}_$][\p{L}\p{N}_$]*|\d+(?:\.\d+)?|\s+|./gsu;

/** Parts of the same kind together. */
function joined(parts: readonly Part[]): Part[] {
  const all: Part[] = [];
  for (const part of parts) {
    const last = all.at(-1);
    if (last?.marked === part.marked) last.text += part.text;
    else all.push({ ...part });
  }
  return all;
}

/** Two lines, with what differs between them marked; with little in common all of both is. */
export function marked(before: string, after: string): { before: Part[]; after: Part[] } {
  const split = (text: string): string[] => text.match(WORDS) ?? [];
  const [one, other] = [split(before), split(after)];
  const length = (words: readonly string[]): number => words.reduce((sum, word) => sum + word.trim().length, 0);
  const pairs = one.length * other.length > MOST_PAIRS ? [] : beside(one, other);
  const shared = pairs.flatMap(([left, right]) => (left !== null && right !== null ? [left] : []));
  if (length(shared) < ALIKE * Math.max(length(one), length(other)))
    return { before: [{ text: before, marked: true }], after: [{ text: after, marked: true }] };
  const side = (which: 0 | 1): Part[] =>
    joined(
      pairs.flatMap(pair => {
        const text = pair[which];
        return text === null ? [] : [{ text, marked: pair[1 - which] === null }];
      }),
    );
  return { before: side(0), after: side(1) };
}
