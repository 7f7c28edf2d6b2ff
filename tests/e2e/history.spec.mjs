// Undo and redo of everything that changes the work, wherever the focus is, and the list of steps by name.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { isDeepStrictEqual } from "node:util";
import { shared } from "./browser.mjs";
import {
  convert,
  fromFormMenu,
  lengthField,
  openErrors,
  openMachine,
  startWithEditor as start,
  stored,
} from "./start.mjs";

const undo = page => page.locator("#undo");
const redo = page => page.locator("#redo");
const program = page => page.locator(".cm-content");
const steps = page => page.locator(".history-list button").allInnerTexts();
/** Longer than what is typed together counts as one step. */
const pause = page => page.waitForTimeout(1100);

async function changed(page, value) {
  await lengthField(page).fill(value);
  await page.locator(`.snippet:has-text("${value}")`).waitFor();
  await pause(page);
}

describe("steps of the work", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("are undone and done again in turn, with buttons that say what", async () => {
    const { context, page, problems } = await start(chrome);
    const first = await lengthField(page).inputValue();
    assert.ok(await undo(page).isDisabled());
    await changed(page, "41");
    await changed(page, "42");
    assert.match(await undo(page).getAttribute("title"), /= 42/);
    await undo(page).click();
    assert.equal(await lengthField(page).inputValue(), "41");
    await undo(page).click();
    assert.equal(await lengthField(page).inputValue(), first);
    assert.ok(await undo(page).isDisabled());
    assert.match(await redo(page).getAttribute("title"), /= 41/);
    await redo(page).click();
    await redo(page).click();
    assert.equal(await lengthField(page).inputValue(), "42");
    assert.ok(await redo(page).isDisabled());
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand: the work after each step, as it is kept
  test("of all sorts come back one by one, and again forth, wherever the focus is", async () => {
    const { context, page, problems } = await start(chrome);
    const kept = async () => {
      await page.waitForTimeout(400);
      const { control, cycle, values, programs, errors, own, files } = await stored(page);
      return { control, cycle, values, programs, errors, own, files };
    };
    const made = [
      () => lengthField(page).fill("41"),
      () => fromFormMenu(page, "Worked example"),
      () => page.getByRole("button", { name: "Insert at cursor" }).click(),
      () => lengthField(page).fill("43"),
      async () => {
        await openErrors(page);
        await page.locator(".sliders .figure, .sliders input[type=text]").first().fill("0.07");
      },
      async () => {
        await openMachine(page);
        await page.locator(".machine select").first().selectOption("G19");
      },
      async () => {
        await program(page).click();
        await page.keyboard.press("Control+End");
        await page.keyboard.insertText("M30");
      },
      () => convert(page, "indirect"),
      () => page.locator("select.encoding").selectOption("save utf-16le"),
    ];
    const seen = [await kept()];
    for (const step of made) {
      await step();
      await pause(page);
      seen.push(await kept());
    }
    for (const [index, one] of seen.entries())
      assert.ok(!index || !isDeepStrictEqual(one, seen[index - 1]), `${index}`);
    await page.locator("#history-open").click();
    const names = await steps(page);
    assert.equal(names.length, seen.length, names.join(" | "));
    await page.keyboard.press("Escape");
    const places = ["#theme", ".cm-content", "#history-open"];
    for (let left = made.length; left > 0; left--) {
      await page.locator(places[left % places.length]).focus();
      await page.keyboard.press("Control+z");
      assert.deepEqual(await kept(), seen[left - 1], `back before ${names[made.length - left]}`);
    }
    for (let done = 1; done <= made.length; done++) {
      await page.keyboard.press(done % 2 ? "Control+y" : "Control+Shift+z");
      assert.deepEqual(await kept(), seen[done], `forth to ${names[made.length - done]}`);
    }
    await page.locator("#history-open").click();
    await page.locator(".history-list button").last().click();
    assert.deepEqual(await kept(), seen[0]);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: self (drawn at random, the same in every run: whatever was done is undone to the byte, and done again)
  test("drawn at random are undone to the byte and done again", async () => {
    const { context, page, problems } = await start(chrome);
    const work = async () => {
      await page.waitForTimeout(300);
      const { cycle, values, programs, errors, own, files } = await stored(page);
      return { cycle, values, programs, errors, own, files };
    };
    const can = {
      value: number => lengthField(page).fill(String(30 + number)),
      variant: async number => {
        await page
          .locator('.field[data-field="_MVAR"] .entry-line > .figure')
          .fill(["1", "2", "101", "102"][number % 4]);
        await page.keyboard.press("Tab");
        await page.waitForTimeout(300);
        const dialog = page.locator("dialog.difference[open]");
        if (await dialog.isVisible())
          await dialog.getByRole("button", { name: number % 3 ? "Apply" : "Cancel" }).click();
      },
      insert: () => page.getByRole("button", { name: "Insert at cursor" }).click(),
      example: () => fromFormMenu(page, "Worked example"),
      text: async number => {
        await program(page).click();
        await page.keyboard.press("Control+Home");
        await page.keyboard.insertText(`; ${number} \u6d4b\u91cf\n`);
      },
      convert: async () => {
        const other = page.locator('.call-ways [data-style="indirect"]:not([aria-pressed="true"])');
        if (await other.isVisible()) await convert(page, "indirect");
      },
    };
    const order = "insert variant value convert text variant insert value variant example text".split(" ");
    const first = await work();
    for (const [index, name] of order.entries()) {
      if (name === "insert" && !(await page.getByRole("button", { name: "Insert at cursor" }).isVisible())) continue;
      await can[name](7 * index + 3);
      await pause(page);
    }
    const last = await work();
    await page.locator("#history-open").click();
    for (const name of await steps(page)) assert.ok(name.trim(), "each step has a name");
    await page.keyboard.press("Escape");
    while (await undo(page).isEnabled()) await undo(page).click();
    assert.deepEqual(await work(), first);
    while (await redo(page).isEnabled()) await redo(page).click();
    assert.deepEqual(await work(), last);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("go on from where they were taken back: what was undone then is gone", async () => {
    const { context, page } = await start(chrome);
    await changed(page, "41");
    await changed(page, "42");
    await lengthField(page).focus();
    await page.keyboard.press("Control+z");
    assert.equal(await lengthField(page).inputValue(), "41");
    await changed(page, "44");
    assert.ok(await redo(page).isDisabled());
    await page.keyboard.press("Control+z");
    assert.equal(await lengthField(page).inputValue(), "41");
    await context.close();
  });
});
