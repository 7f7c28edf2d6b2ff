// The test of a probe: programs, simulated touches, values of a real machine, wrong entries.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { counts, open, packages, shared } from "./browser.mjs";
import { openPageMenu } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");
// oracle: hand (see core/src/series/repeat.rs)
const DRIFTING = "20.0012 20.0013 20.0027 20.0028 20.0028 20.0041 20.0054 20.0051 20.0061 20.0060";

describe("the test of a probe", () => {
  const chrome = shared("neither", { before, after });

  test("touches are simulated, values pasted, programs saved, wrong entries told", async () => {
    const { context, page, problems } = await open(chrome.browser, { bypassCSP: true });
    await openPageMenu(page);
    const data = page.locator("#page-actions button:not([disabled])", { hasText: /^Machine data$/ });
    await data.waitFor();
    await data.click();
    await page.getByRole("dialog", { name: "Machine data" }).getByRole("button", { name: "Test a probe" }).click();
    const shown = page.getByRole("dialog", { name: "Test a probe" });
    await shown.getByText(/^10 touches, mean 25/).waitFor();
    await counts(shown.locator(".repeat-notes li"), 1); // the probe of the core's own machine does not scatter
    const hint = async (label, text) =>
      await shown
        .getByLabel(label)
        .and(page.locator(`[placeholder="${text}"]`))
        .waitFor();
    await hint("Feed", "150\u{a0}mm/min");
    await hint("End without a signal", "50\u{a0}mm");
    await shown.getByLabel("Axis").selectOption("Z"); // along the probe its ball goes ahead
    await hint("End without a signal", "-50\u{a0}mm");
    await shown.getByLabel("End without a signal").fill("30");
    await shown.getByText(/other side of the start, such as Z-30/).waitFor();
    await shown.getByLabel("End without a signal").fill("");
    await shown.getByLabel("Axis").selectOption("X");
    await shown.getByText(/^10 touches, mean 25/).waitFor();
    await shown.getByLabel("Values of the real machine").fill(DRIFTING);
    await shown.getByText("10 touches, mean 20.00375 mm").waitFor();
    await shown.getByText(/^Proposed _TZL = 0.003/).waitFor();
    await shown.getByText(/^The values drift/).waitFor();
    await page.addScriptTag({ path: axe });
    const wrong = await page.evaluate(() => window.axe.run("dialog[open]").then(({ violations }) => violations));
    assert.deepEqual(
      wrong.map(({ id }) => id),
      [],
    );
    await shown.getByLabel("Axis").selectOption("Y");
    await shown.getByLabel("Measuring input").selectOption("2");
    await shown.getByLabel("Number of touches").fill("25");
    await shown.locator("pre", { hasText: "MEAS=2 G1 Y50" }).waitFor({ state: "attached" });
    const download = page.waitForEvent("download");
    await shown.getByRole("button", { name: "Save repeat program" }).click();
    const program = await readFile(await (await download).path(), "utf8");
    assert.match(program, /DEF REAL PW_VAL\[25\]/);
    assert.match(program, /;Repeat accuracy: touches of one place/);
    await shown.getByLabel("Values of the real machine").fill("20.1 many");
    await shown.getByText("many is not a number.").waitFor();
    await shown.getByLabel("Feed").fill("fast");
    await shown.getByText("fast is not a number.").waitFor();
    const marked = label => shown.getByLabel(label).and(page.locator('[aria-invalid="true"]')).waitFor();
    await marked("Feed");
    await shown.getByLabel("Feed").fill("");
    await shown.getByLabel("Values of the real machine").fill("");
    await shown.getByLabel("Number of touches").fill("-4");
    await shown.getByText("The number of touches must be a whole number from 2 to 500.").waitFor();
    await marked("Number of touches");
    assert.deepEqual(problems, []);
    await context.close();
  });
});
