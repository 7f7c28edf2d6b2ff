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

/** The hole of the example, measured on its machine, so many times. */
async function measured(chrome, options = {}, times = 1) {
  const started = await open(chrome.browser, options);
  const { page } = started;
  await page.locator(".results tbody tr").first().waitFor({ state: "attached" });
  await page
    .locator('input[type=file][accept*="json"]')
    .first()
    .setInputFiles({ name: "setup.json", mimeType: "application/json", buffer: example });
  const calls = Array.from({ length: times }, () => "CYCLE977\n").join("");
  await run(
    page,
    scenario.program.name,
    scenario.program.text.replace(/^.*CYCLE977.*\n/m, line => line + calls.slice(9)),
  );
  return started;
}

describe("the record of a run", () => {
  const chrome = shared("neither", { before, after });

  // oracle: peer (the terminal program: core/tests/terminal/files.rs)
  test("is saved as the terminal writes it", async () => {
    const { context, page, problems } = await measured(chrome);
    const [table, document] = [await saved(page, "CSV"), await saved(page, "JSON")];
    assert.deepEqual([table.name, document.name], ["hole.csv", "hole.json"]);
    assert.equal(table.text, await readFile(new URL("hole.record.csv", docs), "utf8"));
    assert.deepEqual(JSON.parse(document.text), JSON.parse(await readFile(new URL("hole.record.json", docs), "utf8")));
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand: 0.03 mm of the 0.1 mm that are permitted
  test("is printed with title block, limits, numbered features and what it is worth", async () => {
    const { context, page, problems } = await measured(chrome, { colorScheme: "dark" });
    await page.evaluate(() => {
      window.print = () => undefined;
    });
    await page.locator(".record-fill summary").click();
    for (const [title, text] of [
      ["part", "Flange 12"],
      ["order", "A-4711"],
      ["machine", "Mill 3"],
    ])
      await page.locator(`[data-title="${title}"]`).fill(text);
    await page.locator('[data-title="machine"]').blur();
    await page.emulateMedia({ media: "print" });
    await page.locator('.whole-top button:has-text("Print record")').evaluate(button => button.click());
    const sheet = page.locator(".record-sheet");
    await sheet.waitFor();
    const told = (await sheet.innerText()).replaceAll("\u00a0", " ");
    const filled = ["Flange 12", "A-4711", "Mill 3"];
    const shown = ["Measurement record", "hole.mpf", "SINUMERIK", "ball 6 mm", "132.030", "±0.100", "+0.030"];
    for (const part of [...shown, ...filled]) assert.ok(told.includes(part), `${part}\n${told}`);
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

describe("the record of several measurements", () => {
  const chrome = shared("webgl2", { before, after });

  // oracle: hand: a sheet a part, with a picture of which something is to be seen
  test("of one part has room on a sheet", async () => {
    const { context, page, problems } = await measured(chrome, {}, 5);
    await page.evaluate(() => {
      window.print = () => undefined;
    });
    await page.emulateMedia({ media: "print" });
    const sheet = page.locator(".record-sheet");
    for (const format of ["A4", "Letter"]) {
      await page.locator('.whole-top button:has-text("Print record")').evaluate(button => button.click());
      await sheet.waitFor();
      assert.equal(await sheet.locator(".record-call").count(), 5);
      const pdf = await page.pdf({ preferCSSPageSize: true, format });
      assert.equal(pdf.toString("latin1").match(/\/Type\s*\/Page\b/g)?.length, 1, format);
    }
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("a protocol of the machine", () => {
  const chrome = shared("webgl2", { before, after });

  // oracle: hand: a hole of 132 mm that the machine found 0.15 mm too large, of 0.1 mm that are permitted
  test("takes the place of the simulated values, in the table, on the part and in the record", async () => {
    const { context, page, problems } = await measured(chrome, { viewport: { width: 1440, height: 900 } });
    const give = text =>
      page
        .locator(".protocol input[type=file]")
        .setInputFiles({ name: "real.csv", mimeType: "text/csv", buffer: Buffer.from(text) });
    await give("Nr;Soll;Ist\nBohrung;132;132,15\nPlatz;77;77,2\n");
    await page.locator('.protocol-top:has-text("1 line of the protocol fits")').waitFor();
    await page.locator('.whole-row[data-verdict="scrap"]:has-text("132.150")').waitFor();
    await page.locator('.answer-line:has-text("132.150"):has-text("real.csv")').waitFor();
    assert.match(await page.locator(".protocol-lines summary").textContent(), /1/);
    assert.match(await page.locator(".protocol-lines").textContent(), /Platz;77;77,2/);
    await page.waitForFunction(() => document.querySelectorAll(".stage path.arrow").length === 4);
    const { text } = await saved(page, "CSV");
    assert.match(text, /,132,-0\.1,0\.1,132\.15,0\.15,1\.5,mm,beyond,Scrap,/);
    await page.locator(".protocol-columns summary").click();
    await page.locator(".protocol-columns select").nth(4).selectOption("3");
    await page.locator('.protocol-top:has-text("fit")').waitFor();
    await page.getByRole("button", { name: "Back to the simulation" }).click();
    await page.locator('.whole-row:has-text("132.150")').waitFor({ state: "detached" });
    await page.locator('.answer-line:has-text("132.030"):has-text("Corrects T20 D1")').waitFor();
    await page.waitForFunction(() => document.querySelectorAll(".stage path.arrow").length === 0);
    await give("---\n");
    await page.locator('.protocol [role="alert"]:has-text("empty")').waitFor();
    const log = (name, text) => ({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
    await page
      .locator(".protocol input[type=file]")
      .setInputFiles([log("LOG_1_1.MPF", "what\n"), log("LOG_1.MPF", "Line;Actual\n8;132.12\n")]);
    await page.locator('.whole-row[data-verdict="scrap"]:has-text("132.120")').waitFor();
    await page.locator('.protocol-top:has-text("LOG_1.MPF, LOG_1_1.MPF")').waitFor();
    assert.match(await page.locator(".protocol-lines").textContent(), /LOG_1_1\.MPF:1/);
    assert.equal(await page.locator(".protocol-columns select").nth(4).inputValue(), "2");
    await give("\x89PNG\0\0\0\rIHDR");
    await page.locator('.protocol [role="alert"]:has-text("no text")').waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});
