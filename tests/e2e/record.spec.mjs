// The record of a run: saved as the terminal writes it, printed as a sheet a part, and long ones without a standstill.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { open, shared } from "./browser.mjs";

const docs = new URL("../../docs/", import.meta.url);
const scenario = JSON.parse(await readFile(new URL("hole.scenario.json", docs), "utf8"));
const example = await readFile(new URL("setup.example.json", docs));

async function run(page, name, text) {
  await page
    .locator(".panel-program input[type=file]")
    .setInputFiles({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
  await page.locator(".call-row").first().waitFor({ state: "attached" });
  await page.locator(".panel-view .segments button").nth(1).click();
  await page.locator(".whole-row").first().waitFor({ timeout: 60_000 });
}

async function saved(page, button) {
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.locator(`.whole-top button:has-text("${button}")`).click(),
  ]);
  return { name: download.suggestedFilename(), text: await readFile(await download.path(), "utf8") };
}

describe("the record of a run", () => {
  const chrome = shared("neither", { before, after });

  async function measured(options = {}) {
    const started = await open(chrome.browser, options);
    const { page } = started;
    await page.locator(".results tbody tr").first().waitFor({ state: "attached" });
    await page
      .locator('input[type=file][accept*="json"]')
      .first()
      .setInputFiles({ name: "setup.json", mimeType: "application/json", buffer: example });
    await run(page, scenario.program.name, scenario.program.text);
    return started;
  }

  // oracle: peer (the terminal program: core/tests/terminal/files.rs)
  test("is saved as the terminal writes it", async () => {
    const { context, page, problems } = await measured();
    const [table, document] = [await saved(page, "CSV"), await saved(page, "JSON")];
    assert.deepEqual([table.name, document.name], ["hole.csv", "hole.json"]);
    assert.equal(table.text, await readFile(new URL("hole.record.csv", docs), "utf8"));
    assert.deepEqual(JSON.parse(document.text), JSON.parse(await readFile(new URL("hole.record.json", docs), "utf8")));
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand: 0.03 mm of the 0.1 mm that are permitted
  test("is printed with title block, limits, numbered features and what it is worth", async () => {
    const { context, page, problems } = await measured({ colorScheme: "dark" });
    await page.evaluate(() => {
      window.print = () => undefined;
    });
    await page.emulateMedia({ media: "print" });
    await page.locator('.whole-top button:has-text("Print record")').evaluate(button => button.click());
    const sheet = page.locator(".record-sheet");
    await sheet.waitFor();
    const told = (await sheet.innerText()).replaceAll("\u00a0", " ");
    for (const part of ["Measurement record", "hole.mpf", "SINUMERIK", "ball 6 mm", "132.030", "±0.100", "+0.030"])
      assert.ok(told.includes(part), `${part}\n${told}`);
    assert.match(told, /30 %/);
    assert.match(told, /machine that cut the part/);
    assert.equal(await sheet.locator(".numbered text").textContent(), "1");
    assert.ok((await sheet.locator(".record-picture path").count()) > 10);
    const pdf = await page.pdf({ preferCSSPageSize: true, format: "A4" });
    assert.equal(pdf.toString("latin1").match(/\/Type\s*\/Page\b/g)?.length, 1, "one sheet");
    assert.deepEqual(problems, []);
    await context.close();
  });
});
