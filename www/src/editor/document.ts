// Long programs as the editor keeps them, a tree of lines: put together in slices before the editor is asked to take
// them.

import { Text } from "@codemirror/state";
import type { Pace } from "../pace";

const KEPT = 2; // the next one, and the one that it replaces: it may come back
const PIECE = 32_768; // characters between two looks at the clock
const BREAK = /\r\n?|\n/;

let kept: readonly { text: string; lines: Text }[] = [];

/** The lines of a program that were put together, or kept when it was replaced. */
export function linesOf(text: string): Text | undefined {
  return kept.find(one => one.text === text)?.lines;
}

export function keepLines(text: string, lines: Text): void {
  kept = [{ text, lines }, ...kept.filter(one => one.text !== text)].slice(0, KEPT);
}

/** Where the first line ends that ends at `from` or later, its line break included. */
function lineEnd(text: string, from: number): number {
  const next = new RegExp(BREAK, "g");
  next.lastIndex = from;
  return next.test(text) ? next.lastIndex : text.length;
}

export async function putTogether(text: string, pace: Pace): Promise<void> {
  let lines = Text.empty;
  for (let from = 0; from < text.length; ) {
    const to = lineEnd(text, from + PIECE);
    // ends with the empty line that the next piece goes on with
    lines = lines.append(Text.of(text.slice(from, to).split(BREAK)));
    from = to;
    await pace.turn(from / text.length);
  }
  keepLines(text, lines);
}
