// The time line: as long as the motions take at their feed, with an axis in seconds.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { open, shared } from "./browser.mjs";
import { drawn } from "./start.mjs";

describe("the time line", () => {
  const chrome = shared("neither", { before, after });

  async function begun(options) {
    const opened = await open(chrome.browser, options);
    await opened.page.locator(".track-axis > span").nth(1).waitFor();
    return opened;
  }
  const seconds = async page => Number((await page.locator(".step-time").textContent()).split("\u00a0")[0]);
  const head = page => page.locator(".track-head").evaluate(node => Number.parseFloat(node.style.left));
  const step = page => page.locator(".track input").inputValue().then(Number);
  const button = (page, name) => page.locator(".timeline").getByRole("button", { name, exact: true });

  // oracle: hand (figures of the axis lie where these seconds are)
  test("has an axis in seconds, where it measures and touches, and the ends of the call", async () => {
    const { context, page, problems } = await begun();
    const total = await seconds(page);
    assert.ok(total > 2, `${total} s`);
    assert.equal(await head(page), 100);
    const axis = await page
      .locator(".track-axis > span")
      .evaluateAll(nodes => nodes.map(node => [node.textContent, Number.parseFloat(node.style.left)]));
    for (const [text, left] of axis) {
      assert.match(text, /^[\d.]+\u00a0s$/);
      assert.ok(Math.abs(left - (100 * Number(text.split("\u00a0")[0])) / total) < 0.5, `${text} at ${left} %`);
    }
    for (const kind of ["measuring", "touches"])
      assert.match(await page.locator(`.track-${kind}`).evaluate(node => node.style.background), /gradient/);
    assert.ok((await page.locator(".track-calls > span").count()) >= 1);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("is dragged by time, and goes step by step with keys", async () => {
    const { context, page, problems } = await begun();
    const total = await seconds(page);
    const box = await page.locator(".track-line").boundingBox();
    await page.mouse.move(box.x + box.width * 0.3, box.y + 10);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.5, box.y + 10, { steps: 4 });
    await page.mouse.up();
    await drawn(page);
    const [there, at] = [await step(page), await seconds(page)];
    assert.ok(Math.abs(at / total - 0.5) < 0.15, `${at} of ${total} s`);
    assert.ok(Math.abs((await head(page)) - (100 * at) / total) < 0.5);
    await page.keyboard.press("ArrowRight");
    await drawn(page);
    assert.equal(await step(page), there + 1);
    await page.keyboard.press("Home");
    await drawn(page);
    assert.equal(await step(page), 0);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (a machine that draws slowly may be late, but never early)
  test("plays as long as the motions take", async () => {
    const { context, page, problems } = await begun();
    await button(page, "First step").click();
    await drawn(page);
    const began = Date.now();
    await button(page, "Play").click();
    await page.waitForTimeout(2500);
    const at = await seconds(page);
    const passed = (Date.now() - began) / 1000;
    assert.ok(at > 0.2 && at < passed + 1.5, `${at} s after ${passed} s`); // the step that runs is told with its end
    const share = await head(page);
    await page.waitForFunction(was => Number.parseFloat(document.querySelector(".track-head").style.left) > was, share);
    await button(page, "Pause").click();
    assert.deepEqual(problems, []);
    await context.close();
  });
});
