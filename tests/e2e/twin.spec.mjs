// The same task on other controls, folded under the snippet.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { shared } from "./browser.mjs";
import { searchTasks, shownChange, startWithCycles as start } from "./start.mjs";

const twin = page => page.locator("details.twin");
const codes = page => twin(page).locator(".twin-code").allTextContents();

describe("twin", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand: a hole whose zero offset is corrected is G110 with its diameter, and follows the form
  test("shows both calls side by side while it is unfolded", async () => {
    const { context, page, problems } = await start(chrome);
    await page.locator("#field-_MVAR").fill("101");
    await page.locator("#field-_MVAR").press("Tab");
    await shownChange(page).getByRole("button", { name: "Apply" }).click();
    await page.locator("#field-_SETVAL").fill("40");
    await page.locator("#field-_KNUM").first().waitFor();
    await twin(page).locator("summary").focus();
    await page.keyboard.press("Enter");
    await twin(page).locator(".twin-call").first().waitFor();
    await page.waitForFunction(() =>
      /G110 D40\b/.test(document.querySelectorAll("details.twin .twin-code")[1]?.textContent ?? ""),
    );
    assert.match((await codes(page))[0], /CYCLE977/);
    await page.locator("#field-_SETVAL").fill("41");
    await page.waitForFunction(() =>
      /G110 D41\b/.test(document.querySelectorAll("details.twin .twin-code")[1]?.textContent ?? ""),
    );
    assert.ok((await twin(page).locator(".twin-differences li").count()) > 0);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:7929-7935, C:723 (coordinates of a corner); hand: from the start at 20 down to -10
  test("tells the corner and the depth on both sides", async () => {
    const { context, page, problems } = await start(chrome);
    const there = text =>
      page.waitForFunction(
        wanted => document.querySelectorAll("details.twin .twin-code")[1]?.textContent.includes(wanted),
        text,
      );
    const choose = async name => {
      await searchTasks(page, name);
      await page.locator(`.hits[data-search="${name}"] .hit`).first().click();
    };
    await choose("G107");
    await page.locator("#field-X").fill("100");
    await twin(page).locator("summary").click();
    await there("_SETV[2]=-100");
    await choose("G110");
    await page.locator("#field-Z").fill("-10");
    await there("_ID=-30");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the TNC measures angle and corner too; its pages are not published)
  test("says why a cycle there is not written, of an angle and a corner too", async () => {
    const { context, page, problems } = await start(chrome);
    for (const [name, heading, why] of [
      ["CYCLE998", /TCH PROBE 4[02]0/, /none shows the values of Q265/],
      ["CYCLE961", /TCH PROBE 415/, /no public document that was found/],
    ]) {
      await searchTasks(page, name);
      await page.locator(`.hits[data-search="${name}"] .hit`).first().click();
      if (
        !(await twin(page)
          .getAttribute("open")
          .then(open => open !== null))
      )
        await twin(page).locator("summary").click();
      const there = twin(page).locator(".twin-call").filter({ hasText: heading });
      await there.waitFor();
      assert.match(await there.textContent(), why);
      if (process.env.PICTURES) {
        await there.scrollIntoViewIfNeeded();
        await page.screenshot({ path: `${process.env.PICTURES}/twin-${name}.png` });
      }
    }
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual (TNC 320 9/2016, p. 396: limits of size); hand: the page shows as many columns as the core lists
  test("has a column for a control that is read and not run", async () => {
    const { context, page, problems } = await start(chrome);
    await page.locator("#field-_SETVAL").fill("40");
    await twin(page).locator("summary").click();
    const third = twin(page).locator(".twin-call").nth(2);
    await third.waitFor();
    await page.waitForFunction(() =>
      /Q262=\+40 /.test(document.querySelectorAll("details.twin .twin-code")[2]?.textContent ?? ""),
    );
    assert.match(await third.locator("h4").textContent(), /HEIDENHAIN TNC/);
    assert.equal(await twin(page).locator("section").count(), 2);
    if (process.env.PICTURES) {
      await third.scrollIntoViewIfNeeded();
      await page.screenshot({ path: `${process.env.PICTURES}/twin-1280.png` });
      await page.setViewportSize({ width: 390, height: 844 });
      await third.scrollIntoViewIfNeeded();
      await page.screenshot({ path: `${process.env.PICTURES}/twin-390.png` });
    }
    assert.deepEqual(problems, []);
    await context.close();
  });
});
