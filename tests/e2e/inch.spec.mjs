// A machine that is basic system inches: chosen once, active in the form, the program text, the simulation, links and
// setups.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { open, packages, shared } from "./browser.mjs";
import { fromMachineMenu, fromPageMenu, openErrors } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");

async function start(chrome, options) {
  const opened = await open(chrome.browser, options);
  await opened.page.locator(".results tbody tr").first().waitFor({ state: "attached" });
  return opened;
}

/** The dialog, opened from the header. */
async function dialog(page) {
  await fromPageMenu(page, "Machine data");
  return page.getByRole("dialog", { name: "Machine data" });
}

async function build(page, unit) {
  const shown = await dialog(page);
  await shown.getByLabel("Basic system").selectOption(unit);
  await shown.getByRole("button", { name: "Done" }).click();
}

const unitOf = (page, field) => page.locator(`.field[data-field="${field}"] .unit`).first().textContent();
const fact = (page, name) => page.locator(`.facts div:has(dt:text-is("${name}")) dd`).textContent();

/** What the call would change: before, after, difference, unit. */
const changes = page => page.locator(".changes tbody tr td").allTextContents();

async function saved(page) {
  const download = page.waitForEvent("download");
  await fromMachineMenu(page, "Export setup");
  return JSON.parse(await readFile(await (await download).path(), "utf8"));
}

describe("a machine basic system inches", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual B:1787-1795 (units of parameters), hand (0.635 mm are 0.025 inch on the diameter, half of it on the
  // radius)
  test("shows, writes, simulates and exports in inches", async () => {
    const { context, page, problems } = await start(chrome);
    assert.equal(await unitOf(page, "_SETVAL"), "mm");
    assert.deepEqual((await changes(page)).slice(1), ["0.0150", "+0.0150", "mm"]);
    await build(page, "inch");
    await page.waitForFunction(() => document.querySelector("#machine-units").value === "G70");
    assert.equal(await unitOf(page, "_SETVAL"), "inch");
    assert.equal(await fact(page, "Control"), "SINUMERIK, basic system inch");
    assert.equal(await fact(page, "Probe"), "ball Ø 0.2362 inch");
    const field = page.locator('.field[data-field="_SETVAL"] .entry-line > .figure');
    await field.fill("5.2");
    await openErrors(page);
    await page.locator(".slider:has(#error-part-size) .figure").fill("0.635");
    await page.locator('.changes tbody td:text-is("inch")').first().waitFor();
    assert.match(await page.locator(".snippet").textContent(), /_SETVAL=5\.2\b/);
    assert.deepEqual((await changes(page)).slice(1), ["0.01250", "+0.01250", "inch"]);
    const setup = await saved(page);
    assert.deepEqual([setup.units, setup.active.units], ["inch", "G70"]);
    assert.ok(Math.abs(setup.workpiece[0].size[0] - 5.2 * 25.4) < 1e-9, "the part is as large as the call says");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("stays so over a reload and in a link, and goes back", async () => {
    const { context, page, problems } = await start(chrome, { permissions: ["clipboard-read", "clipboard-write"] });
    await build(page, "inch");
    await page.waitForTimeout(500); // kept after a pause
    await page.reload();
    await page.locator(".results tbody tr").first().waitFor();
    assert.equal(await unitOf(page, "_SETVAL"), "inch");
    await fromPageMenu(page, "Copy link");
    await page.waitForFunction(() => location.hash.startsWith("#s="));
    const address = page.url();
    const other = await open(chrome.browser, { path: new URL(address).hash });
    await other.page.locator(".results tbody tr").first().waitFor();
    assert.equal(await unitOf(other.page, "_SETVAL"), "inch");
    assert.equal(await (await dialog(other.page)).getByLabel("Basic system").inputValue(), "inch");
    await other.context.close();
    await build(page, "mm");
    await page.waitForFunction(() => document.querySelector("#machine-units").value === "G71");
    assert.equal(await unitOf(page, "_SETVAL"), "mm");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:13594-13596 (the data are converted), B:13442 (active ball, 6 mm in truth), hand (5.08 mm are
  // 0.2 inch)
  test("keeps the sizes of its data; the datum itself chooses too", async () => {
    const { context, page } = await start(chrome);
    const shown = await dialog(page);
    const search = shown.getByRole("searchbox");
    const datum = async (name, value) => {
      await search.fill(name);
      const entry = shown.locator(`.datum:has(code:text-is("${name}")) input`);
      if (value !== undefined) {
        await entry.fill(value);
        await entry.press("Tab");
      }
      return entry;
    };
    assert.equal(await fact(page, "Calibration"), "matches the probe");
    await datum("_WP[0,0]", "5.08");
    await page.locator('.facts dd:text-is("does not match the probe")').waitFor({ state: "attached" });
    await shown.getByLabel("Basic system").selectOption("inch");
    assert.equal(await (await datum("_WP[0,0]")).inputValue(), "0.2");
    await datum("MD10240", "1");
    await page.waitForFunction(() => document.querySelector("#machine-data-basic").value === "mm");
    assert.equal(await (await datum("_WP[0,0]")).inputValue(), "5.08");
    await context.close();
  });

  // oracle: axe-core
  test("is chosen with the keyboard alone, and nothing keeps anyone out", async () => {
    const { context, page } = await start(chrome, { colorScheme: "dark", bypassCSP: true });
    await page.locator(".menu-open").click();
    await page.getByRole("button", { name: "Machine data", exact: true }).focus();
    await page.keyboard.press("Enter");
    const shown = page.getByRole("dialog", { name: "Machine data" });
    await shown.waitFor();
    await shown.getByLabel("Basic system").focus();
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Escape");
    await page.waitForFunction(() => document.querySelector("#machine-units").value === "G70");
    await page.addScriptTag({ path: axe });
    const found = await page.evaluate(() => globalThis.axe.run());
    assert.deepEqual(
      found.violations.map(one => `${one.id}: ${one.nodes[0]?.html}`),
      [],
    );
    await context.close();
  });
});
