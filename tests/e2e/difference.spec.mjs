// What touches more than what is open is shown before it is done: lines as they are and as they would be, values that
// are added and lost, and one step of the history for all of it.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { modules } from "./sources.mjs";
import { keptWhen, openProgram, shownChange, startWithEditor as start } from "./start.mjs";

const VALUES = "_MVAR=1 _SETVAL=132 _TUL=0.03 _TLL=-0.03 _TNUM=20 _KNUM=2001 _TSA=1 _PRNUM=1 _NMSP=1 _FA=2";
const CALL = `${VALUES}\nCYCLE977\n`;
const HEAD = "G17 G54 G40 D1\nT1 D1\nM5\n";
const ZERO = "_MVAR=101 _SETVAL=132 _KNUM=1 _TSA=1 _PRNUM=1 _VMS=300 _NMSP=1 _FA=2 _SZA=3\nCYCLE977\n";

const program = async (page, wanted = () => true) => {
  const { control, programs } = await keptWhen(page, ({ control, programs }) => wanted(programs?.[control] ?? ""));
  return programs[control];
};
const rows = page => page.locator(".call-row");
const style = (page, name) => page.locator(`.call-ways [data-style="${name}"]`);
const changed = page => shownChange(page).locator(".difference-row:not([data-same]):not(.difference-head)");
const press = (page, name) => shownChange(page).getByRole("button", { name, exact: true }).click();
const gone = page => shownChange(page).waitFor({ state: "hidden" });

describe("lines that edits change", () => {
  let sources, changes;
  before(async () => {
    sources = await modules();
    changes = await sources.load("/src/changes.ts");
  });
  after(() => sources.close());
  const plain = hunks =>
    hunks.map(rows =>
      rows.map(({ before, after, same }) => [before?.line, before?.text, after?.line, after?.text, same]),
    );

  // oracle: hand
  test("stand beside what they become, with the lines around them", () => {
    const text = "a\r\nb\r\nc\r\nd=1 e=2\r\nf\r\ng\r\nh\r\n";
    const edits = [
      { from: text.indexOf("1"), to: text.indexOf("1") + 1, insert: "3" },
      { from: text.indexOf("f"), to: text.indexOf("g"), insert: "" },
    ];
    const [hunk, ...more] = plain(changes.changes(text, edits));
    assert.deepEqual(more, []);
    assert.deepEqual(hunk, [
      [2, "b", 2, "b", true],
      [3, "c", 3, "c", true],
      [4, "d=1 e=2", 4, "d=3 e=2", false],
      [5, "f", undefined, undefined, false],
      [6, "g", 5, "g", true],
      [7, "h", 6, "h", true],
      [8, "", 7, "", true],
    ]);
    const marks = changes.marked("d=1 e=2", "d=3 e=2");
    assert.deepEqual(marks.after, [
      { text: "d=", marked: false },
      { text: "3", marked: true },
      { text: " e=2", marked: false },
    ]);
  });

  // oracle: hand (an LF, a CR LF, and a CR alone end a line, as in the editor)
  test("are counted at every line break", () => {
    const text = "a\rb\r\nc\nd\re";
    const edit = (from, insert, to = from) => plain(changes.changes(text, [{ from, to, insert }])).flat();
    assert.deepEqual(edit(text.indexOf("e"), "f\r", text.length), [
      [3, "c", 3, "c", true],
      [4, "d", 4, "d", true],
      [5, "e", 5, "f", false],
      [undefined, undefined, 6, "", false],
    ]);
    assert.deepEqual(edit(text.indexOf("b"), "\n"), [], "an LF behind a CR begins no line");
  });

  // oracle: self (lines put together again give the new text)
  test("give the new text, whatever is edited", () => {
    let seed = 7;
    const random = below => {
      seed = (seed * 1103515245 + 12345) % 2147483648;
      return seed % below;
    };
    for (let run = 0; run < 300; run++) {
      const line = at => `L${at}`.repeat(random(3)) + ["\n", "\r\n", "\r"][random(3)];
      const text = Array.from({ length: random(12) }, (_, at) => line(at)).join("") + "L".repeat(random(2));
      const edits = [];
      for (let at = 0; at <= text.length; at += 1 + random(9)) {
        const to = Math.min(text.length, at + random(6));
        edits.push({ from: at, to, insert: ["", "x", "y\n", "\nz", "\n", "\r", "\ru", "v\r\n", "\nw\r"][random(9)] });
        at = to + 1;
      }
      const after = edits.reduceRight((now, one) => now.slice(0, one.from) + one.insert + now.slice(one.to), text);
      const hunks = changes.changes(text, edits);
      const [was, now] = [text, after].map(one => one.split(/\r\n?|\n/));
      for (const row of hunks.flat()) {
        if (row.before) assert.equal(row.before.text, was[row.before.line - 1]);
        if (row.after) assert.equal(row.after.text, now[row.after.line - 1], JSON.stringify({ text, edits }));
      }
      const added = hunks.flat().filter(row => row.after).length - hunks.flat().filter(row => row.before).length;
      assert.equal(was.length + added, now.length, JSON.stringify({ text, edits }));
    }
  });

  // oracle: hand (a budget that a user does not feel)
  test("of ten thousand changes are there within a second", () => {
    const text = "N10 _SETVAL=10\nG0 X5\nG1 Y7\nZ8\n\nM5\n".repeat(10_000);
    const length = text.length / 10_000;
    const edits = Array.from({ length: 10_000 }, (_, at) => ({
      from: at * length + 12,
      to: at * length + 14,
      insert: "20",
    }));
    const begin = process.cpuUsage(); // of this process, whatever else is busy
    const hunks = changes.changes(text, edits);
    assert.equal(changes.countChanges(hunks), 10_000);
    const took = process.cpuUsage(begin).user / 1000;
    assert.ok(took < 1000, `${took} ms`);
  });
});

describe("a conversion", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand (old and new list); the values are compared by the core's own tests
  test("is shown with what is added and lost, and done only when it is applied", async () => {
    const { context, page, problems } = await start(chrome);
    const text = HEAD + ZERO;
    await openProgram(page, text);
    await rows(page).first().click();
    await style(page, "operate").click();
    await shownChange(page).waitFor();
    assert.match(await shownChange(page).locator("h2").textContent(), /Line 5.*newer controls/);
    assert.match(await shownChange(page).locator('[data-sort="lost"]').textContent(), /_VMS = 300/);
    assert.deepEqual(await changed(page).locator("del").allTextContents(), ZERO.trimEnd().split("\n"));
    assert.match((await changed(page).locator("ins").allTextContents()).join(), /^CYCLE977\(101,1/);
    await page.waitForFunction(() => document.activeElement?.textContent === "Apply");
    assert.equal(await program(page), text, "nothing is done yet");
    await page.keyboard.press("Escape");
    await gone(page);
    assert.equal(await program(page), text);
    await style(page, "operate").click();
    await shownChange(page).waitFor();
    await page.keyboard.press("Enter");
    await gone(page);
    await program(page, now => now.includes("CYCLE977(101"));
    assert.match(await page.locator("#undo").getAttribute("title"), /Convert/);
    await page.locator("#undo").click();
    assert.equal(await program(page, now => !now.includes("CYCLE977(")), text);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (three calls with lists of arguments, one step back)
  test("of all calls is one change, walked through by F7 and undone as one", async () => {
    const { context, page, problems } = await start(chrome);
    const text = HEAD + CALL + `G0 X1\n`.repeat(9) + CALL + `G0 X1\n`.repeat(9) + CALL;
    await openProgram(page, text);
    await rows(page).nth(1).click();
    await style(page, "indirect").click();
    await press(page, "All 3 calls");
    await shownChange(page).locator('h2:has-text("3 calls")').waitFor();
    await counts(shownChange(page).locator(".difference-hunk"), 3);
    const here = () => page.evaluate(() => document.activeElement?.querySelector("[data-side=before]")?.textContent);
    const seen = [];
    for (const key of ["F7", "F7", "F7", "F7", "Shift+F7"]) {
      await page.keyboard.press(key);
      seen.push(await here());
    }
    assert.deepEqual(seen, ["4", "15", "26", "4", "26"]);
    await page.keyboard.press("Enter");
    await gone(page);
    const after = await program(page, now => now.includes("CYCLE_PARA("));
    assert.equal(after.match(/\(977,/g).length, 3);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+z");
    assert.equal(await program(page, now => !now.includes("CYCLE_PARA(")), text);
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("fixes of several findings", () => {
  const chrome = shared("neither", { before, after });
  const wrong = `${HEAD}${"X\u22125\n".repeat(40)}${CALL}`;
  const all = page => page.locator(".problem .cure-all:visible").first();

  // oracle: hand (each wrong character is one that the language has, and nothing else is different)
  test("are shown together, made together, and undone as one", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, wrong);
    await page.locator("#tab-problems").click();
    await all(page).click();
    await shownChange(page).locator('h2:has-text("Fix 40 problems")').waitFor();
    await counts(changed(page), 40);
    assert.deepEqual(await changed(page).first().locator("mark").allTextContents(), ["\u2212", "-"]);
    await press(page, "Cancel");
    await gone(page);
    assert.equal(await program(page), wrong);
    await all(page).click();
    await press(page, "Apply");
    await gone(page);
    assert.equal(await program(page, now => now !== wrong), wrong.replaceAll("\u2212", "-"));
    await page.locator("#undo").click();
    assert.equal(await program(page, now => now.includes("\u2212")), wrong);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("of a thousand lines show some at once and the others when asked for, below each other on a phone", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, `${HEAD}${"X\u22125\nG0 X1\nG0 X1\nG0 X1\nG0 X1\nG0 X1\n".repeat(1000)}`);
    await page.locator("#tab-problems").click();
    await all(page).click();
    await shownChange(page).locator('h2:has-text("Fix 1000 problems")').waitFor();
    await counts(changed(page), 200);
    await press(page, "Show 800 more changes");
    await counts(changed(page), 400);
    const sides = async () =>
      changed(page)
        .first()
        .evaluate(row => ["before", "after"].map(side => row.querySelector(`.difference-text[data-side=${side}]`)))
        .then(() =>
          page.evaluate(() => {
            const row = document.querySelector(".difference-row:not([data-same]):not(.difference-head)");
            const [old, now] = ["before", "after"].map(side =>
              row.querySelector(`.difference-text[data-side=${side}]`).getBoundingClientRect(),
            );
            return now.left > old.left ? "beside" : now.top >= old.bottom - 1 ? "below" : "over";
          }),
        );
    assert.equal(await sides(), "beside");
    await page.setViewportSize({ width: 390, height: 844 });
    assert.equal(await sides(), "below");
    const fits = await shownChange(page).evaluate(
      node => node.scrollWidth <= node.clientWidth && node.getBoundingClientRect().right <= innerWidth + 1,
    );
    assert.ok(fits, "nothing is cut off");
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("what is typed and changes more than its own value", () => {
  const chrome = shared("neither", { before, after });
  const entry = (page, name) => page.locator(`.field[data-field="${name}"] .entry-line > .figure`);
  const SHARED = "G17 T1 D1\n_MVAR=1 _SETVAL=132 _KNUM=0 _TSA=1 _PRNUM=1 _FA=2\nCYCLE977\n_SETVAL=40\nCYCLE977\nM30\n";

  const opened = async text => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, text);
    await rows(page).first().click();
    await page.locator(".opened").waitFor();
    return { context, page, problems };
  };

  // oracle: hand (data of the channel: the second call reads what the first one was given)
  test("is shown with the other calls that read it, and done or left as one", async () => {
    const { context, page, problems } = await opened(SHARED);
    await entry(page, "_SETVAL").fill("133");
    assert.equal(await program(page, now => now !== SHARED), SHARED.replace("132", "133"), "its own value alone");
    await page.keyboard.press("Control+Z");
    await program(page, now => now === SHARED);
    await entry(page, "_FA").fill("3");
    await page.locator(".asks").waitFor();
    await page.keyboard.press("Tab");
    await page.locator(".asks").waitFor();
    await entry(page, "_TSA").focus(); // the field is left
    await shownChange(page).locator('[data-sort="changed"]').waitFor();
    assert.match(await shownChange(page).locator('[data-sort="changed"]').textContent(), /_FA = 2 → 3.*3, 5/s);
    await press(page, "Cancel");
    await gone(page);
    assert.equal(await entry(page, "_FA").inputValue(), "2");
    assert.equal(await program(page), SHARED);
    await entry(page, "_FA").fill("3");
    await page.locator(".asks").waitFor();
    await page.keyboard.press("Enter");
    await press(page, "Apply");
    await gone(page);
    assert.equal(await program(page, now => now !== SHARED), SHARED.replace("_FA=2", "_FA=3"));
    await page.keyboard.press("Control+Z");
    assert.equal(await program(page, now => now === SHARED), SHARED);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:5641-5667 (with a zero offset there is no tool, and no tolerance band)
  test("names the values that another variant does not know before they go", async () => {
    const { context, page, problems } = await opened(`${HEAD}${CALL}M30\n`);
    const text = `${HEAD}${CALL}M30\n`;
    const choose = async () => {
      await page.locator('.field[data-field="_MVAR"] .entry-line > .figure').fill("101");
      await page.keyboard.press("Tab");
      await shownChange(page).locator('[data-sort="lost"]').waitFor();
    };
    await choose();
    assert.match(await shownChange(page).locator('[data-sort="lost"]').textContent(), /_TNUM = 20.*_TUL = 0\.03/s);
    assert.match(await shownChange(page).locator('[data-sort="lost"]').textContent(), /_KNUM = 2001/);
    assert.equal(await program(page), text);
    await press(page, "Cancel");
    await gone(page);
    assert.equal(await entry(page, "_MVAR").inputValue(), "1");
    assert.equal(await program(page), text);
    await choose();
    await press(page, "Apply");
    await gone(page);
    const after = await program(page, now => now.includes("_MVAR=101"));
    assert.doesNotMatch(after, /_TNUM|_TUL|_TLL|_KNUM/, "as the difference had it");
    await page.locator('.field[data-field="_KNUM"]:has-text("2001 was cleared")').waitFor();
    await page.keyboard.press("Control+Z");
    assert.equal(await program(page, now => now === text), text, "undo brings back every byte");
    assert.deepEqual(problems, []);
    await context.close();
  });
});
