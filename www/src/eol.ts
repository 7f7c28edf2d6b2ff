// The editor counts a line break as one character, the program keeps its CR LF. These translate offsets between the two.

let lastText = "";
let lastPairs: number[] = [];

/** Offsets of the CR of every CR LF. */
function pairs(text: string): number[] {
  if (text === lastText) return lastPairs;
  const found: number[] = [];
  for (let at = text.indexOf("\r\n"); at >= 0; at = text.indexOf("\r\n", at + 2)) found.push(at);
  lastText = text;
  lastPairs = found;
  return found;
}

function countBelow(sorted: number[], limit: (pair: number, index: number) => boolean): number {
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
  return result;
}
