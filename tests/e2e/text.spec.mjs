// The plain functions of the page over program text: line breaks, edits, places that move along.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { modules } from "./sources.mjs";

let sources, eol, difference, documents;
before(async () => {
  sources = await modules();
  eol = await sources.load("/src/eol.ts");
  ({ difference } = await sources.load("/src/difference.ts"));
  documents = await sources.load("/src/editor/document.ts");
});
after(() => sources?.close());

const PIECES = ["\r\n", "\r", "\n", "\r\r\n", "G1 X1", "ä", ""];

/** The same numbers at every run. */
function random(seed) {
  let state = seed;
  return below => {
    state = (state * 1103515245 + 12345) % 2147483648;
    return Math.floor((state / 2147483648) * below);
  };
}

const some = (next, count) => Array.from({ length: count }, () => PIECES[next(PIECES.length)]).join("");

/** Never rests; tells the shares that it was told. */
function unhurried() {
  const shares = [];
  return {
    shares,
    turn: async share => {
      shares.push(share);
    },
  };
}

const lines = text => text.split(/\r\n|\r|\n/);

/** What an editor that takes CR LF, CR and LF as one character each makes of an offset. */
const shown = (text, offset) => text.slice(0, offset).replaceAll("\r\n", "\n").length;

/** That an edit makes one text the other, in the program as in an editor that has lines. */
function turns(before, after, edit) {
  if (before === after) return assert.equal(edit, null);
  const told = JSON.stringify({ before, after, edit });
  assert.equal(before.slice(0, edit.from) + edit.insert + before.slice(edit.to), after, told);
  const [from, to] = [shown(before, edit.from), shown(before, edit.to)];
  const [inEditor, wanted] = [lines(before).join("\n"), lines(after).join("\n")];
  assert.equal(inEditor.slice(0, from) + lines(edit.insert).join("\n") + inEditor.slice(to), wanted, told);
}

// oracle: self (the definition, without a memory of earlier texts)
test("offsets in program and editor, and lines, stay right over any edits", () => {
  for (let seed = 1; seed <= 300; seed++) {
    const next = random(seed);
    let text = some(next, 12);
    for (let round = 0; round < 6; round++) {
      eol.toEditor(text, 0);
      const from = next(text.length + 1);
      const to = from + next(text.length - from + 1);
      const insert = some(next, 3);
      const back = { from, to: from + insert.length, insert: text.slice(from, to) };
      const changed = eol.splice(text, [{ from, to, insert }]);
      assert.equal(changed, text.slice(0, from) + insert + text.slice(to));
      turns(text, changed, difference(text, changed)); // both remember how one was made of the other
      turns(changed, text, difference(changed, text));
      assert.equal(eol.splice(changed, [back]), text);
      text = eol.splice(text, [{ from, to, insert }]);
      for (let at = 0; at <= text.length; at++) {
        if (text[at - 1] === "\r" && text[at] === "\n") continue;
        assert.equal(eol.toEditor(text, at), shown(text, at), JSON.stringify({ text, at }));
        assert.equal(eol.toProgram(text, shown(text, at)), at, JSON.stringify({ text, at }));
        assert.equal(eol.lineAt(text, at), lines(text.slice(0, at)).length, JSON.stringify({ text, at }));
      }
    }
  }
});

// oracle: hand
test("a place moves along with the edits before it", () => {
  const edits = [
    { from: 2, to: 4, insert: "abcde" },
    { from: 10, to: 10, insert: "x" },
  ];
  assert.deepEqual(
    [0, 2, 3, 4, 9, 10, 11].map(at => eol.carried(at, edits)),
    [0, 2, 2, 7, 12, 14, 15],
  );
});

// oracle: self (the definition: the text after it is the other text; in the editor as in the program)
test("the difference of two programs makes one the other, and parts no CR LF", () => {
  for (let seed = 1; seed <= 2000; seed++) {
    const next = random(seed);
    const before = some(next, 10);
    const at = next(before.length + 1);
    const after = next(4) ? before.slice(0, at) + some(next, 2) + before.slice(at + next(4)) : some(next, 10);
    const edit = difference(before, after);
    turns(before, after, edit);
  }
});

// oracle: hand (one character changed, far from both ends and across the strides in which texts are compared)
test("the difference of two long programs is the place that was changed", () => {
  const before = "N10 G1 X1.5 Y2\r\n".repeat(20_000);
  for (const at of [0, 1, 16_383, 16_384, 16_385, 160_000, before.length - 16_384, before.length - 3]) {
    const after = `${before.slice(0, at)}%${before.slice(at + 1)}`;
    const edit = difference(before, after);
    assert.equal(eol.splice(before, [edit]), after);
    assert.ok(edit.to - edit.from <= 3 && edit.from <= at && at < edit.to, JSON.stringify({ at, edit }));
  }
});

// oracle: self (the same text split at once)
test("a long program that is put together in pieces has the lines that it has", async () => {
  for (let seed = 1; seed <= 40; seed++) {
    const next = random(seed);
    const text = Array.from({ length: 3 + next(4) }, () => some(next, 20).repeat(1 + next(3000))).join("");
    const pace = unhurried();
    await documents.putTogether(text, pace);
    assert.deepEqual(documents.linesOf(text).toJSON(), lines(text));
    assert.deepEqual(
      pace.shares,
      [...pace.shares].sort((a, b) => a - b),
      "it only goes up",
    );
    assert.ok(pace.shares.every(share => share <= 1));
  }
});

// oracle: self (the definition, without pieces)
test("the line breaks of a long program that are found in pieces are all there", async () => {
  for (const filler of ["G1 X1\r\n", "\r\r\n", "\r\n\n"]) {
    const text = `${filler.repeat(700_000)}M30`;
    await eol.learn(text, unhurried());
    for (const at of [0, 1_000_000, 1_000_001, 2_000_000, text.length - 4, text.length].filter(
      at => text.slice(at - 1, at + 1) !== "\r\n",
    ))
      assert.equal(eol.toEditor(text, at), shown(text, at), JSON.stringify({ filler, at }));
  }
});

// oracle: hand (what ends a line: CR LF, LF, or CR alone)
test("lines are counted and found whatever ends them", () => {
  for (const end of ["\n", "\r\n", "\r"]) {
    const text = ["G0", "G1 X1", "", "M30"].join(end);
    assert.equal(eol.lineCount(text), 4);
    assert.equal(eol.lineCount(text + end), 4);
    assert.equal(eol.lineAt(text + end, (text + end).length), 5);
    const second = 2 + end.length;
    assert.equal(eol.lineBegin(text, second + 3), second);
    assert.equal(eol.lineBegin(text, second), second);
    assert.equal(eol.lineBegin(text, 1), 0);
    assert.equal(eol.lineEnd(text, 0), second);
    assert.equal(eol.lineEnd(text, text.length - 1), text.length);
  }
  assert.equal(eol.lineCount(""), 1);
});
