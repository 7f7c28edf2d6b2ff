// Scenarios: one is made of the program that is open, and holds; another part does not; the built-in ones all hold.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { fileURLToPath } from "node:url";
import { counts, packages, shared } from "./browser.mjs";
import { startWithEditor as start } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");
const EXAMPLE = fileURLToPath(new URL("../../docs/hole.scenario.json", import.meta.url));

async function menu(page, entry) {
  await page.locator(".menu-open").click();
  await page.locator("#page-actions").getByRole("button", { name: entry, exact: true }).click();
}

const passed = (page, words) => page.locator(".scenarios-outcome strong").getByText(words, { exact: true }).waitFor();

async function pick(page, files) {
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Run scenarios …" }).click();
  await (await chooser).setFiles(files);
}

/** What a source begins with, and how many there are at least: each names chapters of a manual. */
const IN_ENGLISH = [
  [/^Worked example: .+\d{4}, \d/, 45],
  [/^Figures: .+\d{4}, \d/, 15],
  [/^Closed loop: .+\d{4}, \d/, 35],
];
const IN_GERMAN = [
  [/^Beispiel: .+\d{4}, \d/, 45],
  [/^Zahlen: .+\d{4}, \d/, 15],
  [/^Gegenprobe: .+\d{4}, \d/, 35],
];

describe("scenarios", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand (the hole of the example is 132.03 mm)
  test("are made of the program that is open, and tell what differs", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    const program = "R1=2+3\nG0 X10\nM30\n";
    const opened = { name: "part.mpf", mimeType: "text/plain", buffer: Buffer.from(program) };
    await page.locator(".panel-program input[type=file]").first().setInputFiles([opened]);
    await page.locator('.notice:has-text("Program opened.")').waitFor();
    await menu(page, "Scenarios");
    const download = page.waitForEvent("download");
    await page.getByRole("button", { name: "Save program as scenario" }).click();
    const saved = await download;
    assert.equal(saved.suggestedFilename(), "part.scenario.json");
    const scenario = JSON.parse(await readFile(await saved.path(), "utf8"));
    assert.equal(scenario.program.text, program);

    const text = await readFile(EXAMPLE, "utf8");
    const other = text.replaceAll("132.03", "132.04").replace("0.03 mm too big", "other");
    const json = (name, text) => ({ name, mimeType: "application/json", buffer: Buffer.from(text) });
    await pick(page, [
      { ...json("hole.scenario.json", ""), buffer: Buffer.from(`\ufeff${text}`, "utf16le") }, // as editors save it too
      json("other.scenario.json", other),
      json("part.scenario.json", JSON.stringify(scenario)),
      json("wrong.scenario.json", '{\n "program": 1}'),
    ]);
    await passed(page, "Passed: 2 of 4");
    const rows = page.locator(".scenarios-list > li");
    await counts(rows, 4);
    const differing = await rows.filter({ hasText: "other.scenario.json" }).textContent();
    assert.match(differing, /_OVR\[4\] = 132\.03\. Expected: 132\.04\./);
    assert.match(await rows.filter({ hasText: "wrong.scenario.json" }).textContent(), /2.*13.*program/);
    await page.addScriptTag({ path: axe });
    const { violations } = await page.evaluate(() => globalThis.axe.run("dialog.scenarios"));
    assert.deepEqual(violations, []);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual (each of the built-in cases says where its figures come from)
  test("that are built in prove the installation, in every language", async () => {
    for (const [locale, menuName, check, words, kinds] of [
      ["en-GB", "About", "Check this installation", /^Passed: (\d+) of \1$/, IN_ENGLISH],
      ["de-DE", "Info", "Installation prüfen", /^Bestanden: (\d+) von \1$/, IN_GERMAN],
    ]) {
      const { context, page, problems } = await start(chrome, { locale });
      await menu(page, menuName);
      await page.locator("dialog.about").getByRole("button", { name: check }).click();
      await page.locator(".scenarios progress").waitFor();
      await page.locator(".scenarios progress").waitFor({ state: "detached", timeout: 60_000 });
      assert.match(await page.locator(".scenarios-outcome strong").textContent(), words);
      await counts(page.locator('.scenarios-list > li[data-good="false"]'), 0);
      assert.ok((await page.locator(".scenarios-list > li").count()) >= 107);
      const sources = await page.locator(".scenario-source").allTextContents();
      for (const [source, least] of kinds) {
        assert.ok(sources.filter(one => source.test(one)).length >= least, `${source}: ${sources}`);
      }
      // the button that stops them is gone when it is pressed: the focus comes back to the one that carried them out
      const again = page.locator(".scenarios-ways button", { hasText: check });
      await again.focus();
      await page.keyboard.press("Enter");
      await page.locator(".scenarios progress + button").focus();
      await page.keyboard.press("Enter");
      await page.locator(".scenarios-ways button:focus", { hasText: check }).waitFor();
      assert.deepEqual(problems, []);
      await context.close();
    }
  });
});
