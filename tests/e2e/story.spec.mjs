// The worked example, told in five steps: what it shows is simulated, and its end is a corrected part.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, open, shared } from "./browser.mjs";
import { faults } from "./room.mjs";

const chrome = shared("neither", { before, after });

async function begin(options = {}) {
  const opened = await open(chrome.browser, { path: "", ...options });
  await opened.page.locator(".start-story").click();
  await opened.page.locator(".story").waitFor();
  return opened;
}

const next = page => page.locator(".story").getByRole("button").nth(1);

describe("the worked example", () => {
  // oracle: self (a closed loop: what was corrected is measured as nothing)
  for (const control of ["SINUMERIK", "NCT"])
    test(`ends with a corrected part, ${control}`, async () => {
      const opened = await open(chrome.browser, { path: "" });
      const { context, page, problems } = opened;
      await page.getByRole("button", { name: control, exact: true }).click();
      await page.locator(".start-story").click();
      await page.locator(".story p", { hasText: "X 0.084 and Y −0.046" }).waitFor();
      for (let step = 2; step <= 4; step++) await next(page).click();
      await page.locator(".story p", { hasText: "X +0.084" }).waitFor();
      await next(page).click();
      await page.locator(".story p", { hasText: "Now it corrects: nothing" }).waitFor();
      await counts(page.locator(".call-row"), 2);
      assert.deepEqual(problems, []);
      await context.close();
    });

  // oracle: hand (the program of before is one step back)
  test("leaves what was there before within reach", async () => {
    const { context, page } = await begin();
    await page.locator(".story").getByRole("button", { name: "Leave" }).click();
    await page.locator(".story").waitFor({ state: "hidden" });
    await page.locator(".notice").getByRole("button", { name: "Undo" }).click();
    await page.locator(".call-row").nth(1).waitFor({ state: "detached" });
    await context.close();
  });

  // oracle: hand
  for (const [width, height] of [
    [1280, 800],
    [390, 844],
    [320, 640],
  ])
    for (const locale of ["en-GB", "de-DE", "zh-CN"])
      test(`has room, ${width} × ${height}, ${locale}`, async () => {
        const { context, page } = await begin({ viewport: { width, height }, locale });
        for (let step = 1; step < 5; step++) {
          assert.deepEqual(await faults(page), [], `step ${step}`);
          await next(page).click();
        }
        assert.deepEqual(await faults(page), [], "step 5");
        await context.close();
      });
});
