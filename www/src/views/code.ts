// Code of which the values are places of their parameters; where these are is the core's.

import { el } from "../dom";
import type { CallView, Dialect } from "../wire";

/** What belongs to a parameter has its name. */
export interface Piece {
  text: string;
  field?: string;
}

/** A comment, and what must not be taken for one. */
const COMMENTS: Record<Dialect, RegExp> = {
  sinumerik: /("[^"\n]*")|\s*;.*$/gm,
  nct: /("[^"\n]*")|\s*\([^)\n]*\)/g,
};

/** A text in pieces; of places that overlap the first one counts. */
export function piecesOf(text: string, places: CallView["places"]): Piece[] {
  const pieces: Piece[] = [];
  let at = 0;
  for (const [field, [from, to]] of Object.entries(places).sort(([, a], [, b]) => a[0] - b[0])) {
    if (from < at || to > text.length) continue;
    pieces.push({ text: text.slice(at, from) }, { text: text.slice(from, to), field });
    at = to;
  }
  return [...pieces, { text: text.slice(at) }].filter(piece => piece.text);
}

/** The blocks of a call one after the other, without what is only said about them. */
export function inOneLine(pieces: readonly Piece[], control: Dialect): Piece[] {
  const bare = (text: string): string =>
    text.replace(COMMENTS[control], (_, quoted?: string) => quoted ?? "").replace(/\s*\n\s*/g, " ");
  const line = pieces.map(piece => (piece.field === undefined ? { text: bare(piece.text) } : piece));
  const [first, last] = [line[0], line.at(-1)];
  if (first) first.text = first.text.trimStart();
  if (last) last.text = last.text.trimEnd();
  return line.filter(piece => piece.text);
}

/** Brings code into an element. A click on a value leads to its field. */
export function createCode(root: HTMLElement): (pieces: readonly Piece[]) => void {
  root.classList.add("leads");
  let drawn = "";
  return pieces => {
    const now = JSON.stringify(pieces);
    if (now === drawn) return;
    drawn = now;
    const parts = pieces.map(({ text, field }) =>
      field === undefined ? text : el("span", { class: "code-value", "data-field": field }, text),
    );
    root.replaceChildren(...parts);
  };
}
