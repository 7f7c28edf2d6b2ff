// What a text looks like that was opened as a program: some are something else, and in some no line reads as a block.

import { linesOf } from "../eol";

const MARKUP: readonly (readonly [kind: string, begins: RegExp])[] = [
  ["HTML", /^<(?:!doctype\s+html|html|head|body)\b/i],
  ["XML", /^<(?:[?!]|[a-z_][\w:.-]*[\s/>])/i],
  ["JSON", /^(?:\{\s*(?:"|\}\s*$)|\[\s*["{[\]])/],
];

/** By what a text is no program but something that is written for other readers. */
export function markupOf(text: string): string | undefined {
  const begin = text
    .slice(0, 1000)
    .replace(/^\uFEFF/, "")
    .trimStart();
  return MARKUP.find(([, begins]) => begins.test(begin))?.[0];
}

const FIRST = 20_000; // characters that are looked at
const WORDS = "DEF|REDEF|PROC|EXTERN|IF|WHILE|FOR|REPEAT|LOOP|UNTIL|GOTO[FBS]?|CASE|M?CALL|EXTCALL|MSG|SETMS";

/** How a block begins, or what nothing but a block has. */
const BLOCK = [
  /^[;(%:]/, // comment, head
  /^\/?\d?\s*[NO]\d/i,
  /^[A-Z](?:[-+]?\.?\d|\d*\s*=|#|\[)/i,
  /^[$#]?[A-Z_$]?[\w$]+(?:\[[^\]]*\])?\s*=/i, // assignment
  /^[A-Z_]\w*\(/i, // call
  /^[A-Z_][A-Z0-9_]+:?$/, // call or label alone
  new RegExp(`^(?:${WORDS})\\b`),
  /(?:^|\s)[GM]\d{1,3}(?:\s|$)/i,
];

/** Whether one of the first lines reads as a block, or there is none. */
export function looksLikeProgram(text: string): boolean {
  const lines = linesOf(text.slice(0, FIRST))
    .map(line => line.trim())
    .filter(Boolean);
  return !lines.length || lines.some(line => BLOCK.some(begins => begins.test(line)));
}
