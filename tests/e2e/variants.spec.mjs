// The digits of a measuring variant: what is chosen among them is always a variant.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, open, shared } from "./browser.mjs";
import { openTasks } from "./start.mjs";

/** After the redraw that follows what was done last. */
const drawn = page =>
  page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));

describe("the digits of a variant", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual B:5066-5084, B:15595: on a surface the fifth digit alone is a choice (with the length of the probe
  // or without), in a hole all are; one direction tells neither ball nor skew
  test("lead from one variant to another and are asked where there is a choice", async () => {
    const { context, page, problems } = await open(chrome.browser);
    const field = page.locator('.field[data-field="_MVAR"]');
    await field.waitFor();
    await page.locator(".results tbody tr").first().waitFor(); // all cycles are there
    await openTasks(page);
    await openTasks(page);
    const closed = page.locator('[role="treeitem"][aria-expanded="false"]');
    while ((await closed.count()) > 0) {
      await closed.first().click();
      await drawn(page);
    }
    await page.locator('.tree-item.level-3:has(.code:text-is("110101"))').first().click();
    const number = field.locator(".entry-line > .figure");
    const digits = field.locator(".digit select");
    const choose = async (index, value, leads, asked) => {
      await digits.nth(index).selectOption(value);
      await page.waitForFunction(
        wanted => document.querySelector('.field[data-field="_MVAR"] .figure').value === wanted,
        leads,
      );
      await drawn(page);
      assert.equal(await number.inputValue(), leads);
      await counts(digits, asked, `${leads}: digits`);
      assert.deepEqual(await field.locator('.problem[data-severity="error"]').allInnerTexts(), [], leads);
    };
    await page.waitForFunction(() => document.querySelectorAll('.field[data-field="_MVAR"] .digit').length === 5);
    await choose(0, "0", "10000", 2);
    await choose(1, "0", "0", 2);
    await choose(0, "8", "8", 4);
    await choose(0, "1", "1", 5);
    await choose(1, "1", "1001", 3);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
