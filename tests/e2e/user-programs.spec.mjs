// CYCLE198 and CYCLE199: branches of chosen cycles, saved; at a call it is told what runs around it.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { open, shared } from "./browser.mjs";
import { openPageMenu } from "./start.mjs";

describe("lines around measuring cycles", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual B:2482-2508 (between the label of the cycle and M17)
  test("branches are chosen, written, saved and refused", async () => {
    const { context, page, problems } = await open(chrome.browser);
    await openPageMenu(page);
    const data = page.locator("#page-actions button:not([disabled])", { hasText: /^Machine data$/ });
    await data.waitFor();
    await data.click();
    const machine = page.getByRole("dialog", { name: "Machine data" });
    await machine.getByRole("button", { name: "Lines around measuring cycles" }).click();
    const shown = page.getByRole("dialog", { name: "Lines around measuring cycles" });
    await shown.getByLabel(/^CYCLE977/).check();
    await shown.getByLabel("Lines before the measurement").fill("M27\nG4 F0.5");
    await shown.locator("pre", { hasText: "M27" }).waitFor();
    const download = page.waitForEvent("download");
    await shown.getByRole("button", { name: "Save CYCLE198.SPF" }).click();
    const text = await readFile(await (await download).path(), "utf8");
    assert.equal(text, "_M977: ;before measurement in CYCLE977\nM27\nG4 F0.5\nM17\n");
    await shown.getByLabel(/^Variable of the CASE/).fill("_X");
    await shown.locator("pre", { hasText: "CASE _X OF 977 GOTOF _M977 DEFAULT GOTOF _MEND" }).first().waitFor();
    await shown.getByLabel("Lines after the measurement").fill("M30");
    await shown.getByText("This line is not possible between label and M17: M30").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});
