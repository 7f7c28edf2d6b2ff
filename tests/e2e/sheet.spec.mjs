// The dock of a tablet is a sheet: a strip, half, or all that the answer leaves; by buttons, keys and by hand.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { faults } from "./room.mjs";
import { drawn, focused, keptWhen, start } from "./start.mjs";

const chrome = shared("neither", { before, after });
const grip = page => page.locator(".sheet-grip");
const stop = page => grip(page).getAttribute("aria-valuenow").then(Number);
const button = (page, name) => page.locator(".sheet-bar").getByRole("button", { name, exact: true });
const box = (page, selector) => page.locator(selector).first().boundingBox();

/** The page with its answer, without motion unless it is what counts. */
async function tablet([width, height], options = {}) {
  const opened = await start(chrome, { viewport: { width, height }, reducedMotion: "reduce", ...options });
  await opened.page.locator(".answer .verdict").waitFor();
  return opened;
}

/** Drags the grip to this height of the window. */
async function drag(page, to, steps) {
  const { x, y, width, height } = await grip(page).boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2, to, { steps });
  await page.waitForTimeout(steps > 1 ? 500 : 0); // slowly: the place counts, not the swing
  await page.mouse.move(x + width / 2, to + 1);
  await page.mouse.up();
  await drawn(page);
}

describe("the sheet", () => {
  for (const size of [
    [1024, 768],
    [768, 1024],
  ]) {
    // oracle: hand (the answer is always in sight, and nothing is cut)
    test(`has three heights, ${size.join(" × ")}`, async () => {
      const { context, page, problems } = await tablet(size);
      assert.equal(await stop(page), 1);
      const heights = [];
      for (const [press, at] of [
        ["Lower", 0],
        ["Raise", 1],
        ["Raise", 2],
      ]) {
        await button(page, press).click();
        await drawn(page);
        assert.equal(await stop(page), at);
        assert.deepEqual(await faults(page), []);
        await page.locator(".answer .verdict").waitFor();
        const answer = await box(page, ".answer");
        const bar = await box(page, ".sheet-bar");
        assert.ok(answer.y + answer.height <= bar.y + 1, "the answer lies above the sheet");
        heights.push(size[1] - bar.y);
      }
      assert.ok(heights[0] < 110 && heights[1] > 1.8 * heights[0] && heights[2] > 1.5 * heights[1], `${heights}`);
      assert.ok(await button(page, "Raise").isDisabled());
      await keptWhen(page, ({ sheet }) => sheet === "full");
      assert.deepEqual(problems, []);
      await context.close();
    });
  }

  // oracle: hand
  test("is moved by keys, and says where it is", async () => {
    const { context, page } = await tablet([1024, 768]);
    await grip(page).focus();
    for (const [key, at, text] of [
      ["ArrowUp", 2, "Full height"],
      ["ArrowDown", 1, "Half"],
      ["Home", 0, "Strip"],
      ["End", 2, "Full height"],
      ["Enter", 1, "Half"],
    ]) {
      await page.keyboard.press(key);
      await drawn(page);
      assert.equal(await stop(page), at, key);
      assert.equal(await grip(page).getAttribute("aria-valuetext"), text);
    }
    await context.close();
  });

  // oracle: hand
  test("follows the hand and stops at the nearest height, a swing counts by its direction", async () => {
    const { context, page } = await tablet([1024, 768]);
    await drag(page, 200, 20);
    assert.equal(await stop(page), 2);
    await drag(page, 730, 20);
    assert.equal(await stop(page), 0);
    await drag(page, 150, 1);
    assert.equal(await stop(page), 1, "one stop further, though all is nearer");
    await context.close();
  });

  // oracle: hand
  test("rises for a panel that is wanted, and makes room for the stage", async () => {
    const { context, page } = await tablet([1024, 768]);
    await button(page, "Lower").click();
    await page.locator('.panel-bar [aria-controls="panel-results"]').click();
    await drawn(page);
    assert.equal(await stop(page), 1);
    await page.locator("#panel-results").waitFor();
    await button(page, "Raise").click();
    await drawn(page);
    assert.ok(await page.locator("#panel-view").isHidden());
    await page.locator(".skip a").nth(2).focus();
    await page.keyboard.press("Enter");
    await drawn(page);
    await page.locator("#panel-view").waitFor();
    await context.close();
  });

  // oracle: hand
  test("stands beside a rail that leads to the machine, which a phone has in its menu", async () => {
    const { context, page } = await tablet([1024, 768]);
    const machine = page.locator(".panel-bar").getByRole("button", { name: "Machine" });
    await machine.click();
    await page.locator("dialog.equipment[open]").waitFor();
    await page.keyboard.press("Escape");
    await page.setViewportSize({ width: 390, height: 844 });
    await drawn(page);
    assert.ok(await machine.isHidden());
    await counts(page.locator(".panel-bar button:visible"), 5);
    const more = page.locator(".rail-more");
    await more.click();
    await page.locator("#page-actions").getByRole("button", { name: "Machine", exact: true }).click();
    await page.locator("#profile-edit").waitFor();
    await page.keyboard.press("Escape");
    await focused(page, more);
    await more.click();
    await page.locator("#page-actions").getByRole("button", { name: "Help" }).click();
    await focused(page, "#panel-help");
    await page.locator(".rail-more[aria-current]").waitFor();
    await context.close();
  });

  // oracle: hand (WCAG 2.3.3)
  test("slides only for who likes motion", async () => {
    for (const reducedMotion of ["no-preference", "reduce"]) {
      const { context, page } = await tablet([1024, 768], { reducedMotion });
      await page.evaluate(() => {
        const animate = Element.prototype.animate;
        globalThis.moves = 0;
        Element.prototype.animate = function (...how) {
          if (this.matches(".sheet-bar")) globalThis.moves++;
          return animate.apply(this, how);
        };
      });
      await button(page, "Raise").click();
      await drawn(page);
      const moves = await page.evaluate(() => globalThis.moves);
      assert.equal(moves, reducedMotion === "reduce" ? 0 : 1);
      await context.close();
    }
  });
});
