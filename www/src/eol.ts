// The editor counts a line break as one character, the program keeps its CR LF. These translate offsets between the two.

let lastText = "";
let lastPairs = new Int32Array();

/** Offsets of the CR of every CR LF. */
function pairs(text: string): Int32Array {
  if (text !== lastText) remember(text, Int32Array.from(found(text, 0, text.length)));
  return lastPairs;
}

function remember(text: string, all: Int32Array<ArrayBuffer>): void {
  lastText = text;
  lastPairs = all;
}

/** Offsets of every CR of a CR LF, the CR from `from` on and before `to`. */
function found(text: string, from: number, to: number): number[] {
  const list: number[] = [];
  for (let at = text.indexOf("\r\n", from); at >= 0 && at < to; at = text.indexOf("\r\n", at + 2)) list.push(at);
  return list;
}

/** The pairs after one edit: only around it is the text looked at again, so that a keystroke in a long program stays cheap. */
function pairsAfter(before: Int32Array, edit: Splice, text: string): Int32Array<ArrayBuffer> {
  const from = Math.max(0, edit.from - 1); // the CR before the edit can lose or find its LF
  const end = edit.from + edit.insert.length;
  const around = found(text.slice(from, end + 1), 0, end - from).map((at) => at + from);
  const head = before.subarray(0, countBelow(before, (pair) => pair < from));
  const tail = before.subarray(countBelow(before, (pair) => pair < edit.to));
  const all = new Int32Array(head.length + around.length + tail.length);
  all.set(head);
  all.set(around, head.length);
  const shift = end - edit.to;
  const start = head.length + around.length;
  for (let index = 0; index < tail.length; index++) all[start + index] = (tail[index] as number) + shift;
  return all;
}

function countBelow(sorted: Int32Array, limit: (pair: number, index: number) => boolean): number {
  let low = 0, high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (limit(sorted[middle] as number, middle)) low = middle + 1; else high = middle;
  }
  return low;
}

/** Offset in the program → offset in the editor. */
export function toEditor(text: string, offset: number): number {
  return offset - countBelow(pairs(text), (pair) => pair + 1 < offset);
}

/** Offset in the editor → offset in the program. */
export function toProgram(text: string, offset: number): number {
  return offset + countBelow(pairs(text), (pair, index) => pair - index < offset);
}

/** The line break that the program uses. */
export function lineBreak(text: string): string {
  return pairs(text).length > 0 ? "\r\n" : "\n";
}

export interface Splice { from: number; to: number; insert: string }

/** Splices that do not overlap, offsets in the text before all of them. */
export function splice(text: string, edits: readonly Splice[]): string {
  let result = text;
  for (const edit of [...edits].sort((a, b) => b.from - a.from || b.to - a.to))
    result = result.slice(0, edit.from) + edit.insert + result.slice(edit.to);
  const [only] = edits;
  if (only && edits.length === 1 && text === lastText) remember(result, pairsAfter(lastPairs, only, result));
  return result;
}

/** Where an offset lies after the edits. What is put in right before it pushes it on; inside of what goes it falls to its begin. */
export function carried(at: number, edits: readonly Splice[]): number {
  let moved = at;
  for (const edit of edits) {
    if (at >= edit.to) moved += edit.insert.length - (edit.to - edit.from);
    else if (at > edit.from) moved += edit.from - at;
  }
  return moved;
}
