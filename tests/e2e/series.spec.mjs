// A program run many times in the page: fields, charts, table, both for the example of the manual.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, packages, shared } from "./browser.mjs";
import { start } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");

describe("a series of parts", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual B:1265-1284 (rows that its misprint leaves alone); weight 1 corrects each part above _TZL
  test("shows the mean value of the manual's table with weight 3 and weight 1, and its alarms", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await page.keyboard.press("Control+k");
    await page.locator("#palette-search").fill("Series of parts");
    await page.locator(".palette-item", { hasText: "Series of parts" }).first().click();
    const shown = page.getByRole("dialog", { name: "Series of parts" });
    await shown.getByRole("button", { name: "Example: mean value" }).click();
    await shown.getByText("10 parts are done.").waitFor();
    await shown.getByLabel("Parts", { exact: true }).fill("20");
    await shown.getByRole("button", { name: "Run series" }).click();
    await shown.getByText("20 parts are done.").waitFor();
    const cells = await shown
      .locator("table")
      .evaluateAll(tables =>
        tables.map(({ tBodies: [body] }) => [...body.rows].map(row => [...row.cells].map(cell => cell.textContent))),
      );
    const [third, first] = cells;
    assert.deepEqual([third.length, first.length], [20, 20]);
    assert.deepEqual(third[2].slice(0, 2), ["3", "50.060"]);
    const means = third.map(row => row[3]);
    assert.deepEqual([means[0], means[1], means[6], means[7], means[8]], ["0.010", "0.023", "0.000", "0.010", "0.030"]);
    const changes = rows => rows.filter((row, at) => row[2] !== (at ? rows[at - 1][2] : "0.000")).length;
    assert.ok(changes(first) > changes(third), `${changes(first)} corrections, with weight 3 ${changes(third)}`);
    await counts(shown.locator("figure.series-chart svg[role=img]"), 4);
    await shown.getByText("No alarm.").waitFor();
    await page.addScriptTag({ path: axe });
    const wrong = await page.evaluate(() => window.axe.run("dialog.series").then(({ violations }) => violations));
    assert.deepEqual(
      wrong.map(({ id }) => id),
      [],
    );
    await shown.getByLabel("Parts", { exact: true }).fill("many");
    await shown.getByRole("button", { name: "Run series" }).click();
    await shown.getByText("This is no number: many").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});
