// The plain functions of the page over program text: line breaks, edits, places that move along.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { modules } from "./sources.mjs";

let sources, eol;
before(async () => {
  sources = await modules();
  eol = await sources.load("/src/eol.ts");
});
after(() => sources?.close());

const PIECES = ["\r\n", "\r", "\n", "\r\r\n", "G1 X1", "ä", ""];

/** The same numbers at every run. */
function random(seed) {
  let state = seed;
  return (below) => {
    state = (state * 1103515245 + 12345) % 2147483648;
    return Math.floor((state / 2147483648) * below);
  };
}

const some = (next, count) => Array.from({ length: count }, () => PIECES[next(PIECES.length)]).join("");

/** What an editor that takes CR LF, CR and LF as one character each makes of an offset. */
const shown = (text, offset) => text.slice(0, offset).replaceAll("\r\n", "\n").length;

// oracle: self (the definition, without a memory of earlier texts)
test("offsets in program and editor stay right over any edits", () => {
  for (let seed = 1; seed <= 300; seed++) {
    const next = random(seed);
    let text = some(next, 12);
    for (let round = 0; round < 6; round++) {
      eol.toEditor(text, 0);
      const from = next(text.length + 1);
      const to = from + next(text.length - from + 1);
      text = eol.splice(text, [{ from, to, insert: some(next, 3) }]);
      for (let at = 0; at <= text.length; at++) {
        if (text[at - 1] === "\r" && text[at] === "\n") continue;
        assert.equal(eol.toEditor(text, at), shown(text, at), JSON.stringify({ text, at }));
        assert.equal(eol.toProgram(text, shown(text, at)), at, JSON.stringify({ text, at }));
      }
    }
  }
});

// oracle: hand
test("a place moves along with the edits before it", () => {
  const edits = [{ from: 2, to: 4, insert: "abcde" }, { from: 10, to: 10, insert: "x" }];
  assert.deepEqual([0, 2, 3, 4, 9, 10, 11].map((at) => eol.carried(at, edits)), [0, 2, 2, 7, 12, 14, 15]);
});
