// What is set once per machine: found, changed, refused, kept, and used by the forms of the cycles.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { open, packages, shared } from "./browser.mjs";

const axe = packages.resolve("axe-core/axe.min.js");

/** The dialog, opened from the header. */
async function dialog(page) {
  const button = page.getByRole("button", { name: "Machine", exact: true });
  await page.locator(".head-actions button:not([disabled])", { hasText: /^Machine$/ }).waitFor();
  await button.click();
  return page.getByRole("dialog", { name: "Machine data" });
}

describe("machine data", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("a datum is found by words, changed, kept and taken back", async () => {
    const { context, page, problems } = await open(chrome.browser);
    const shown = await dialog(page);
    await shown.getByRole("searchbox").fill("ball diameter");
    const row = shown.locator(".datum", { hasText: "_WP[1,0]" });
    assert.ok(await shown.locator(".datum").count() < 10, "the search narrows");
    const entry = row.locator("input");
    await entry.fill("5,995");
    await entry.press("Tab");
    await shown.locator(".datum.changed").waitFor();
    await page.keyboard.press("Escape");
    await page.waitForTimeout(500); // kept after a pause
    await page.reload();
    const again = await dialog(page);
    await again.getByRole("checkbox").check();
    assert.deepEqual(await again.locator(".datum code").allTextContents(), ["_WP[1,0]"]);
    assert.equal(await again.locator(".datum input").inputValue(), "5.995");
    await again.getByRole("button", { name: "All as delivered" }).click();
    await again.locator(".empty").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:13726 (1 to 100 %)
  test("what cannot be is told at its place, with the cure", async () => {
    const { context, page } = await open(chrome.browser);
    const shown = await dialog(page);
    await shown.getByRole("searchbox").fill("_SPEED[0]");
    const entry = shown.locator(".datum input");
    await entry.fill("120");
    await entry.press("Tab");
    const told = shown.locator(".datum-problem:visible");
    await told.waitFor();
    assert.match(await told.textContent(), /100/);
    assert.equal(await entry.getAttribute("aria-invalid"), "true");
    await context.close();
  });

  // oracle: axe-core, in both schemes and on a small screen
  test("nothing keeps anyone out", async () => {
    for (const options of [{ colorScheme: "light" }, { colorScheme: "dark", viewport: { width: 768, height: 1024 }, hasTouch: true }]) {
      const { context, page } = await open(chrome.browser, { ...options, bypassCSP: true });
      const shown = await dialog(page);
      await shown.locator("summary").nth(1).click();
      await shown.locator(".datum").first().waitFor();
      await page.addScriptTag({ path: axe });
      const found = await page.evaluate(() => globalThis.axe.run(".machine-data"));
      assert.deepEqual(found.violations.map((one) => `${one.id}: ${one.nodes[0]?.html}`), []);
      await context.close();
    }
  });
});
