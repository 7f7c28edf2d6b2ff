// A value typed over an expression waits until the user says what becomes of it. Meanwhile nothing else stops: the
// question belongs to its field, and leaving or saving answers it with what the program has.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import {
  keptWhen,
  openFirstCall,
  programWhen,
  shownChange,
  startWithEditor as start,
  start as startForm,
  still,
} from "./start.mjs";

const REST = "_KNUM=0 _PRNUM=1 _FA=2 _TSA=2";
const SMALL = `R2=50.02 ; bore\n_MVAR=1 _SETVAL=R2 ${REST}\nCYCLE977\n_MVAR=0 _SETVAL=0 _MA=1 ${REST}\nCYCLE978\nM30\n`;
const LONG = SMALL.replace("M30", `${"G1 X1 Y1\n".repeat(1500)}M30`); // read aside
const TYPED = "0.7";

const field = (page, name) => page.locator(`.field[data-field="${name}"]`);
const entry = (page, name) => field(page, name).locator(".entry-line > .figure");
const question = page => field(page, "_SETVAL").locator(".replaced");
const keep = page => question(page).getByRole("button", { name: "Keep R2" });
const undo = page => page.locator("#undo");
const notice = (page, text) => page.locator(`.notice:has-text("${text}")`);
const NOT_TAKEN = "The program stays as it is";
const call = (page, cycle) => page.locator(`.call-row:has-text("${cycle}")`);

/** Types over what the field holds, key by key. */
async function type(page, name, text) {
  await entry(page, name).click();
  await page.keyboard.press("Control+A");
  await page.keyboard.type(text);
}

const has = (page, name, value) =>
  page.waitForFunction(
    ([of, wanted]) => document.querySelector(`.field[data-field="${of}"] .entry-line > .figure`)?.value === wanted,
    [name, value],
  );

async function asked(chrome, text) {
  const opened = await start(chrome);
  await openFirstCall(opened.page, text);
  await has(opened.page, "_SETVAL", "R2");
  await type(opened.page, "_SETVAL", "50,1");
  await question(opened.page).getByRole("button", { name: "Change R2 to 50.1" }).waitFor();
  return opened;
}

for (const [length, text] of Object.entries({ short: SMALL, long: LONG }))
  describe(`a question that is open in a ${length} program`, () => {
    const chrome = shared("neither", { before, after });

    // oracle: hand
    test("is taken back with what was typed, and nothing else is", async () => {
      const { context, page, problems } = await asked(chrome, text);
      await page.keyboard.press("Control+Z");
      await question(page).waitFor({ state: "hidden" });
      await has(page, "_SETVAL", "R2");
      await still(page, text);
      await page.keyboard.press("Control+Y");
      await keep(page).waitFor();
      await has(page, "_SETVAL", "50,1");
      await page.keyboard.press("Control+Z");
      await question(page).waitFor({ state: "hidden" });
      await type(page, "_SETVAL", "50,2");
      await page.locator('#undo[title*="50,2"]').waitFor();
      await keep(page).click();
      await question(page).waitFor({ state: "hidden" });
      await page.locator('#undo[title*="part.mpf"]').waitFor(); // what was typed and kept out is no step
      await still(page, text);
      assert.deepEqual(problems, []);
      await context.close();
    });

    // oracle: hand
    test("ends when another call is opened: that is said, and comes back by undo", async () => {
      const { context, page, problems } = await asked(chrome, text);
      await call(page, "CYCLE978").click();
      await notice(page, NOT_TAKEN).waitFor();
      await has(page, "_SETVAL", "0");
      await notice(page, NOT_TAKEN).getByRole("button", { name: "Undo" }).click();
      await keep(page).waitFor();
      await has(page, "_SETVAL", "50,1");
      await still(page, text);
      assert.deepEqual(problems, []);
      await context.close();
    });

    // oracle: hand (the steps from the last to the first)
    test("does not stop the steps that follow", async () => {
      const { context, page, problems } = await asked(chrome, text);
      await call(page, "CYCLE978").click();
      await has(page, "_SETVAL", "0");
      await type(page, "_SETVAL", TYPED);
      const typed = await programWhen(page, now => now.includes(`_SETVAL=${TYPED}`));
      await page.locator('#undo[title*="0.7"]').waitFor();
      await page.keyboard.press("Control+Z");
      await programWhen(page, now => now === text);
      await page.keyboard.press("Control+Z");
      await keep(page).waitFor();
      await page.keyboard.press("Control+Z");
      await question(page).waitFor({ state: "hidden" });
      await has(page, "_SETVAL", "R2");
      await still(page, text);
      for (let forth = 0; forth < 3; forth++) await page.keyboard.press("Control+Y");
      assert.equal(await programWhen(page, now => now !== text), typed);
      assert.deepEqual(problems, []);
      await context.close();
    });
  });

describe("a question that is open", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("stops no step after a reload either", async () => {
    const { context, page, problems } = await asked(chrome, SMALL);
    await keptWhen(page, ({ pending }) => pending?.length === 1);
    await page.reload();
    await keep(page).waitFor();
    await page.waitForFunction(() => document.querySelector("#undo")?.disabled === true);
    await type(page, "_FA", "3");
    const other = await programWhen(page, now => now !== SMALL);
    assert.equal(other, SMALL.replace("_FA=2", "_FA=3"));
    await page.locator("#undo:enabled").waitFor();
    await undo(page).click();
    await programWhen(page, now => now === SMALL);
    await keep(page).waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("is answered when the program is saved, which is said", async () => {
    const { context, page, problems } = await asked(chrome, SMALL);
    const saved = page.waitForEvent("download");
    await page.keyboard.press("Control+S");
    assert.equal(await readFile(await (await saved).path(), "utf8"), SMALL);
    await notice(page, NOT_TAKEN).waitFor();
    await question(page).waitFor({ state: "hidden" });
    await has(page, "_SETVAL", "R2");
    await notice(page, NOT_TAKEN).getByRole("button", { name: "Undo" }).click();
    await keep(page).waitFor();
    await has(page, "_SETVAL", "50,1");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the program has 50.02 + 0.03 until something is chosen)
  test("leaves the call in the program, with the results of the program", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(page, SMALL);
    await page.locator('.form-foot .placed:has-text("In program, line 3")').waitFor();
    await page.locator('.answer:has-text("Ø 50.050 (+0.030)")').waitFor(); // told a moment later
    const answer = await page.locator(".answer").innerText();
    await type(page, "_SETVAL", "51,5");
    await question(page).getByRole("button", { name: "Change R2 to 51.5" }).waitFor();
    await page.locator('.form-foot .placed:has-text("In program, line 3")').waitFor();
    await page.locator(".form-foot .insert").waitFor({ state: "hidden" });
    assert.equal(await page.locator(".answer").innerText(), answer);
    assert.match(await page.locator(".foot-call").getAttribute("title"), /_SETVAL=R2/);
    await has(page, "_SETVAL", "51,5");
    await counts(page.locator(".call-row"), 2);
    await question(page).getByRole("button", { name: "Replace here" }).click();
    await programWhen(page, now => now.includes("_SETVAL=51.5"));
    await page.waitForFunction(before => document.querySelector(".answer")?.innerText !== before, answer);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("names three of many lines at first, with what can be chosen in sight", async () => {
    const { context, page, problems } = await start(chrome);
    const many = SMALL.replace("M30", `${"G1 X=R2\n".repeat(13)}M30`);
    await openFirstCall(page, many);
    await has(page, "_SETVAL", "R2");
    await type(page, "_SETVAL", "51");
    await question(page).getByRole("button", { name: "Change R2 to 51" }).waitFor();
    const lines = question(page).locator("li > p:first-child button:not(.replaced-more)");
    await counts(lines, 3);
    for (const one of await question(page).locator(".actions button").all())
      await page.waitForFunction(
        node => {
          const box = node.getBoundingClientRect();
          const there = document.elementFromPoint((box.left + box.right) / 2, (box.top + box.bottom) / 2);
          return node === there && box.bottom <= innerHeight;
        },
        await one.elementHandle(),
      );
    await question(page).getByRole("button", { name: "and 11 more" }).click();
    await counts(lines, 14);
    await page.waitForFunction(() => document.activeElement?.textContent.includes("Line 8"));
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("undo behind a dialog", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("does nothing, whatever the dialog", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(page, SMALL);
    await type(page, "_FA", "3");
    const now = await programWhen(page, text => text !== SMALL);
    await page.locator("#undo:enabled").waitFor();
    await type(page, "_SETVAL", "51");
    await question(page).getByRole("button", { name: "Change R2 to 51" }).click();
    await shownChange(page).waitFor();
    await page.keyboard.press("Control+Z");
    await still(page, now);
    await shownChange(page).waitFor();
    await page.keyboard.press("Escape");
    await shownChange(page).waitFor({ state: "hidden" });
    await keep(page).click();
    await question(page).waitFor({ state: "hidden" });
    await page.locator('.call-ways [data-style="indirect"]').click();
    await shownChange(page).waitFor();
    await page.keyboard.press("Control+Z");
    await page.keyboard.press("Control+Y");
    await still(page, now);
    await shownChange(page).waitFor();
    await page.keyboard.press("Escape");
    await shownChange(page).waitFor({ state: "hidden" });
    await page.keyboard.press("Control+Z");
    await programWhen(page, text => text === SMALL);
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("what is told at the edge of the page", () => {
  const chrome = shared("neither", { before, after });
  const SIZES = { phone: [390, 844], tablet: [820, 1180], wide: [1280, 800] };

  // oracle: hand
  for (const [name, [width, height]] of Object.entries(SIZES))
    test(`covers nothing of the form on a ${name}`, async () => {
      const { context, page, problems } = await startForm(chrome, { viewport: { width, height } });
      await page
        .locator(".panel-program input[type=file]")
        .setInputFiles({ name: "part.mpf", mimeType: "text/plain", buffer: Buffer.from(SMALL) });
      const told = page.locator('.notice:has-text("Program opened.")');
      await told.waitFor();
      await page.evaluate(() => scrollTo({ top: 0, behavior: "instant" }));
      const { bottom } = await told.evaluate(node => node.getBoundingClientRect().toJSON());
      const form = await page.locator("#panel-form, .panel:visible").first().boundingBox();
      const beside = await told.evaluate(
        (node, right) => node.getBoundingClientRect().left >= right,
        form.x + form.width,
      );
      assert.ok(beside || bottom <= form.y + 1, `${bottom} over ${form.y}`);
      assert.deepEqual(problems, []);
      await context.close();
    });

  // oracle: hand
  test("says which character is lacking in no more lines than it needs, with its buttons below", async () => {
    const { context, page, problems } = await start(chrome);
    const latin = Buffer.from("; Pr\xfcfen\nG1 X1\nM30\n", "latin1");
    await page
      .locator(".panel-program input[type=file]")
      .setInputFiles({ name: "part.mpf", mimeType: "text/plain", buffer: latin });
    await page.locator('.cm-line:has-text("Prüfen")').click();
    await page.keyboard.press("Home");
    await page.keyboard.insertText("; \u0416\n");
    const bar = page.locator(".lacking");
    await bar.waitFor();
    const text = await bar.locator(".problem").boundingBox();
    const box = await bar.boundingBox();
    assert.ok(text.width > 0.8 * box.width, `${text.width} of ${box.width}`);
    const buttons = await bar.locator("button, select").all();
    const tops = await Promise.all(buttons.map(async one => (await one.boundingBox()).y));
    assert.ok(Math.max(...tops) - Math.min(...tops) < 8, `in one row: ${tops}`);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
