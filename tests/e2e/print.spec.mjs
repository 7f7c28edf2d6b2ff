// The print-out of the NCT macros: shown, and saved as it is shown.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import { open, shared } from "./browser.mjs";

describe("print-out", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual C:1103-1116 (header of the print-out of dimensions)
  test("is saved as it is shown", async () => {
    const { context, page, problems } = await open(chrome.browser);
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" }); // all cycles are known
    await page.locator("#task-search").fill("G110");
    await page.locator("button, [role=option], [role=treeitem]", { hasText: "G110" }).first().click();
    await page.getByRole("tab", { name: "Log" }).click();
    const shown = page.locator("pre.log", { hasText: "DIMENSION" });
    await shown.waitFor();
    const saving = page.waitForEvent("download");
    await page.getByRole("button", { name: "Save as a file" }).click();
    const text = readFileSync(await (await saving).path(), "utf8");
    assert.equal(text, `${await shown.textContent()}\n`);
    assert.match(text, /TOOL {7}NOMINAL/);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
