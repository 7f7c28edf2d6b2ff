// Blocks around a call: chosen in the form, written with the call, found again, changed and taken away.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { shared } from "./browser.mjs";
import { programWhen, searchTasks, startWithCycles as start } from "./start.mjs";

const box = (page, name) => page.locator(`details.around [data-block="${name}"]`);

describe("around", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand: what the block says it does
  test("a rework loop is found by search, written, read again, changed and removed", async () => {
    const { context, page, problems } = await start(chrome);
    await searchTasks(page, "rework");
    await page.locator('.hit[data-kind="around"]').first().click();
    await box(page, "rework").waitFor();
    assert.ok(await box(page, "rework").isChecked());
    assert.equal(await page.locator("#around-rework-program").getAttribute("aria-invalid"), "true");
    await page.locator("#around-rework-program").fill("L120");
    await page.locator("#around-rework-program").press("Tab");
    await page.getByRole("button", { name: "Write into program" }).click();
    const text = await programWhen(page, now => now.includes("PW1_GOOD"));
    assert.match(text, /PW1_AGAIN:[\s\S]*CYCLE977[\s\S]*L120[\s\S]*PW1_GOOD:/);
    assert.ok(await box(page, "rework").isChecked());
    await page.locator("#around-rework-passes").fill("5");
    await page.locator("#around-rework-passes").press("Tab");
    await page.getByRole("button", { name: "Write into program" }).click();
    await programWhen(page, now => now.includes("R99<5"));
    await page.waitForFunction(() => document.querySelector("#around-rework-passes")?.value === "5");
    await box(page, "rework").uncheck();
    await page.getByRole("button", { name: "Write into program" }).click();
    assert.match(await programWhen(page, now => !now.includes("PW1_")), /CYCLE977/);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
