// How program and form stand to each other, and what of the state is kept: plain functions of the page, in Node.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { modules } from "./sources.mjs";

let sources, desk, state, stored, typing, history;
before(async () => {
  sources = await modules();
  [desk, state, stored, typing, history] = await Promise.all(
    ["desk/desk", "state/state", "state/stored", "desk/typing", "state/history"].map(name =>
      sources.load(`/src/${name}.ts`),
    ),
  );
});
after(() => sources.close());

const TEXT = "_SETVAL=40\nCYCLE977\n_SETVAL=30\nCYCLE977\n";
/** A call as the core reads it; `line` is its first, `from` and `to` are places in the text. */
const call = (from, to, line, values) => ({
  from,
  to,
  line,
  lastLine: line + 1,
  cycle: "CYCLE977",
  values,
  expressions: {},
  first: {},
  diagnostics: [],
});
const CALLS = [call(0, 19, 1, { _SETVAL: "40" }), call(20, 39, 3, { _SETVAL: "30" })];
const reading = text => ({ control: "sinumerik", text, view: { calls: CALLS, diagnostics: [] } });

/** A state with this program, read, with the first call in the form. */
const read = (...patches) =>
  state.patched(
    state.firstState(),
    { program: { texts: { sinumerik: TEXT }, reading: reading(TEXT) } },
    { form: { cycle: "CYCLE977", open: 0, values: { _SETVAL: "40" } } },
    ...patches,
  );
const typed = (at, value) => ({ control: "sinumerik", at, name: "_SETVAL", value });
const none = () => assert.fail("nothing is to be asked");
const LONG = "G0 X1\n".repeat(2000);

// oracle: hand (the ways and their transitions as they are defined)
describe("a state", () => {
  test("is unread as long as nobody knows what the program holds now", () => {
    for (const reading of [null, { ...read().program.reading, text: "M30\n" }]) {
      const standing = desk.standing(read({ program: { reading } }));
      assert.equal(standing.is, "unread");
      assert.deepEqual(standing.question, { ask: "read", control: "sinumerik", text: TEXT });
    }
    const setup = { control: "sinumerik" };
    assert.equal(
      desk.standing(read({ machine: { setups: { sinumerik: setup } } })).question.setup,
      setup,
      "read on another machine",
    );
  });

  test("is stopped where a long program is not to be read; a short one is read all the same", () => {
    const stoppedReading = text => ({ control: "sinumerik", text, why: "" });
    const of = text =>
      desk.standing(
        read({ program: { texts: { sinumerik: text }, reading: null, stoppedReading: stoppedReading(text) } }),
      ).is;
    assert.deepEqual([of(LONG), of(TEXT)], ["stopped", "unread"]);
    assert.equal(
      desk.next(read({ program: { texts: { sinumerik: LONG }, reading: null } }), () => null),
      null,
    );
  });

  test("that is read shows the call that was looked for", () => {
    const looking = read({ desk: { sought: { call: 1 } } });
    assert.equal(desk.standing(looking).is, "looking");
    const next = desk.next(looking, none);
    assert.deepEqual([next.form.open, next.form.values, next.desk.sought], [20, { _SETVAL: "30" }, null]);
    assert.equal(desk.standing(next).is, "settled");
  });

  test("that is read follows the cursor into another call, and out of the calls keeps the form", () => {
    const at = line => desk.next(read({ desk: { follow: "cursor" }, program: { line } }), none);
    assert.deepEqual([at(4).form.open, at(4).form.values], [20, { _SETVAL: "30" }]);
    assert.deepEqual([at(9).form.open, at(9).form.values], [0, { _SETVAL: "40" }]);
    assert.equal(at(4).desk.follow, null);
  });

  test("forgets what was typed for a call that is gone", () => {
    const next = desk.next(read({ desk: { follow: "text", pending: [typed(5, "1"), typed(20, "2")] } }), none);
    assert.deepEqual(next.desk.pending, [typed(20, "2")]);
  });

  test("is typed while the form is ahead of the program, and its edits move what points into it", () => {
    const ahead = read({ desk: { pending: [typed(0, "41.5")] }, form: { open: 20 } });
    const standing = desk.standing(ahead);
    assert.equal(standing.is, "typed");
    const { ask, call, at } = standing.question;
    assert.deepEqual({ ask, call, at }, { ask: "change", call: 0, at: 0 });
    const edit = { from: 8, to: 10, insert: "41.5" };
    const answer = { steps: [[edit]], elsewhere: [], findings: [], taken: [], values: [], reaches: false };
    const next = desk.next(ahead, () => [answer]);
    assert.equal(state.programOf(next), TEXT.replace("40", "41.5"));
    assert.deepEqual([next.desk.pending, next.form.open], [[], 22]);
    assert.equal(desk.standing(next).is, "unread");
  });

  test("keeps what was typed back while it would change more than its value, and shows it", () => {
    const lines = [{ line: 1, before: "_SETVAL=40", after: "_SETVAL=41" }];
    const steps = [[{ from: 8, to: 10, insert: "41" }]];
    const values = [{ line: 4, cycle: "CYCLE977", param: "_SETVAL", key: "", before: "40", after: "41" }];
    const answer = { steps, elsewhere: lines, findings: [], taken: [], unfit: [], values, reaches: true };
    const next = desk.next(read({ desk: { pending: [typed(0, "41")] } }), () => [answer]);
    assert.deepEqual(next.desk.pending, [{ ...typed(0, "41"), asks: { text: TEXT, steps, lines, values } }]);
    assert.equal(state.programOf(next), TEXT);
    assert.equal(desk.standing(next).is, "settled");
    const shown = typing.typedShown(next);
    assert.deepEqual([shown.desk.proposed.edits, shown.desk.proposed.values], [steps[0], values]);
    assert.deepEqual(typing.declined(shown).desk, { ...next.desk, pending: [] }, "as it was");
    const agreed = typing.agreed(shown);
    assert.equal(desk.standing(agreed).is, "typed");
    const done = desk.next(agreed, () => [answer]);
    assert.deepEqual([state.programOf(done), done.desk.pending], [TEXT.replace("40", "41"), []]);
  });

  test("asks at the field first where an expression would go, then about the rest", () => {
    const replaced = { text: "R2", worth: "40", variables: [] };
    const steps = [[{ from: 8, to: 10, insert: "41" }]];
    const answer = { steps, elsewhere: [], findings: [], taken: [], unfit: [], values: [], replaced, reaches: true };
    const next = desk.next(read({ desk: { pending: [typed(0, "41")] } }), () => [answer]);
    assert.deepEqual(next.desk.pending[0].asks.replaced, replaced);
    assert.equal(typing.typedShown(next), next, "nothing to be shown yet");
    const here = { ...typed(0, "41"), agreed: "here" };
    const after = desk.next(read({ desk: { pending: [here] } }), () => [answer]);
    assert.equal(after.desk.pending[0].asks.replaced, undefined);
    assert.ok(typing.typedShown(after).desk.proposed);
  });

  test("is rewriting while a call is to be written in another way, and astray when that call is gone", () => {
    const style = "indirect";
    const rewriting = read({ desk: { converting: { at: 20, style, all: false } } });
    assert.equal(desk.standing(rewriting).is, "rewriting");
    assert.deepEqual([desk.standing(rewriting).question.call, desk.standing(rewriting).question.style], [1, style]);
    const edits = [{ from: 20, to: 39, insert: "CYCLE_977(1)" }];
    const next = desk.next(rewriting, () => ({ edits, findings: [], values: [], calls: 1 }));
    assert.equal(state.programOf(next), TEXT, "it is shown first");
    assert.deepEqual([next.desk.converting, next.desk.proposed.edits], [null, edits]);
    const done = typing.agreed(next);
    assert.equal(state.programOf(done), `${TEXT.slice(0, 20)}CYCLE_977(1)${TEXT.slice(39)}`);
    assert.equal(done.desk.proposed, null);

    const astray = read({ desk: { converting: { at: 7, style, all: false } } });
    assert.equal(desk.standing(astray).is, "astray");
    assert.equal(desk.next(astray, none).desk.converting, null);
  });

  test("gives the machine what a program lacks before anything else is asked", () => {
    const giving = { change: { give: "tools" }, told: { key: "offer-tools", args: {} } };
    const unread = read({ program: { reading: null }, desk: { giving } });
    const { is, question } = desk.standing(unread);
    assert.deepEqual([is, question.ask, question.text, question.change], ["giving", "equip", TEXT, giving.change]);
    const setup = { control: "sinumerik", name: "MILL", workpiece: [] };
    const known = state.patched(unread, { machine: { setups: { sinumerik: { ...setup, tools: {} } } } });
    const next = desk.next(known, () => ({ setup, tables: [] }), { applicate: {} });
    assert.deepEqual([next.machine.setups.sinumerik, next.machine.told], [setup, giving.told]);
    assert.deepEqual([next.desk.giving, next.page.notice, next.page.offer], [null, "notice-given", true]);
    assert.equal(desk.standing(next).is, "unread");
  });

  test("that got no answer asks nothing more about its text", () => {
    const ahead = read({ desk: { pending: [typed(0, "41")] } });
    const next = desk.failed(ahead, desk.standing(ahead).question, "broken");
    assert.deepEqual(next.desk.pending, []);
    assert.deepEqual(next.program.stoppedReading, { control: "sinumerik", text: TEXT, why: "broken" });
  });

  test("of which a part changed keeps the other parts as they are", () => {
    const before = read();
    const after = state.patched(before, { view: { step: 3 } }, { form: before.form });
    assert.equal(after.form, before.form);
    assert.equal(after.view.step, 3);
    assert.equal(before.view.step, state.AT_END);
  });
});

// oracle: hand: the texts as they were; a step of a long program holds what was edited, and not the program
describe("steps of a long program", () => {
  const withText = (before, text) => state.patched(before, { program: { texts: { sinumerik: text } } });
  const stepTo = (before, text, subject, at) => {
    const after = withText(before, text);
    const step = { name: { key: "step-program", args: { line: 1 } }, subject };
    return state.patched(after, { history: history.withStep(before.history, step, before, after, at) });
  };
  const back = (from, count) => state.patched(from, history.stepped(from, count));

  test("bring each state back, also where more came between them, and forth again", () => {
    const texts = ["G1 X1 Y1\r\n".repeat(30_000)];
    let now = withText(state.firstState(), texts[0]);
    for (let n = 1; n < 6; n++) {
      const text = texts[n - 1];
      texts.push(`${text.slice(0, 5000 * n)}N${n}${text.slice(5000 * n + (n % 3))}`);
      now = stepTo(stepTo(now, `${text} `, "typed", 5000 * n), texts[n], "typed", 5000 * n + 1);
    }
    const characters = JSON.stringify(now.history.past).length;
    assert.ok(now.history.past.length === 5 && characters < 10_000, `${characters} characters in five steps`);
    for (const text of texts.slice(0, -1).reverse()) {
      now = back(now, 1);
      assert.equal(state.programOf(now), text);
    }
    now = back(now, -3);
    assert.equal(state.programOf(now), texts[3]);
    const followed = withText(now, `;${texts[3]}`); // which is no step
    now = stepTo(followed, `;${texts[3]}M30`, "", 90_000);
    assert.equal(state.programOf(back(now, 1)), `;${texts[3]}`);
    assert.equal(state.programOf(back(now, 2)), texts[2]);
    assert.equal(state.programOf(back(back(now, 3), -3)), `;${texts[3]}M30`);
  });
});

// oracle: hand (the names are those of version 0.1: what is stored and what was sent must open)
describe("what is kept", () => {
  test("is flat, under names that stay", () => {
    const kept = stored.kept(read());
    assert.deepEqual(
      [kept.control, kept.cycle, kept.values, kept.programs, kept.open, kept.pending, kept.style, kept.right],
      ["sinumerik", "CYCLE977", { _SETVAL: "40" }, { sinumerik: TEXT }, 0, [], "", "results"],
    );
    assert.ok(!("reading" in kept) && !("form" in kept));
    assert.deepEqual(stored.kept(stored.merge(state.firstState(), JSON.parse(JSON.stringify(kept)))), kept);
  });

  test("is taken as far as it has the right shape", () => {
    const bad = {
      control: 5,
      values: { _SETVAL: 40, _FA: "2" },
      files: { sinumerik: { name: "a.mpf", encoding: "none" } },
      open: "3",
      pending: [{ name: "x" }],
      errors: { part: { dx: "1", dy: 2 } },
      style: "odd",
      suits: { sinumerik: "G20" },
      touched: null,
      unfolded: { a: true, b: 1 },
      practised: ["start", 5],
      practicePart: { dx: "1", tilt: 2 },
      practicePiece: "cube",
    };
    const next = stored.merge(read(), bad);
    assert.deepEqual(next.form.values, { _FA: "2" });
    assert.deepEqual([next.form.control, next.form.open, next.form.touched], ["sinumerik", 0, {}]);
    assert.deepEqual([next.program.files, next.desk.pending, next.machine.suits], [{}, [], {}]);
    assert.deepEqual([next.snippet.style, next.panels.unfolded], ["", { a: true }]);
    assert.deepEqual(next.part.errors.part, { ...read().part.errors.part, dy: 2 });
    assert.deepEqual(next.jog.part, { ...state.AS_SET_UP, tilt: 2 });
    assert.deepEqual([next.jog.lines, next.jog.piece], [["start"], null]);
    assert.equal(stored.merge(read(), null).form.open, 0);
  });

  test("comes back with undo, and nothing else does", () => {
    const before = read();
    const after = state.patched(before, { form: { values: {}, open: null }, view: { step: 1 } });
    const undone = state.patched(after, stored.work(before));
    assert.deepEqual([undone.form.values, undone.form.open, undone.view.step], [{ _SETVAL: "40" }, 0, 1]);
  });
});
