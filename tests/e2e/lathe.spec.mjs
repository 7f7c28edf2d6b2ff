// A turning machine in the 3D view: its diameters as on a drawing, and the words of the errors where a tool is touched.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { open, shared } from "./browser.mjs";

/** The page with this cycle in the form, as it was left; everything is drawn. */
async function left(browser, work, options) {
  const { context, page, problems } = await open(browser, options);
  await page.addInitScript((kept) => localStorage.setItem("probewright-1", kept), JSON.stringify({ control: "sinumerik", ...work }));
  await page.reload({ waitUntil: "load" });
  await page.locator(".results tbody tr").first().waitFor({ state: "attached" });
  await page.locator("[data-backend]").first().waitFor({ state: "attached" });
  return { context, page, problems };
}

const letters = (page) => page.locator(".stage svg[aria-hidden] text").allTextContents();

describe("a turning machine", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand (a part of 45 mm that is 0.2 mm larger; the control counts X as a diameter)
  test("shows its diameters as on a drawing when asked", async () => {
    const part = { dx: 0, dy: 0, dz: 0, size: 0.2, tilt: 0, taper: 0, outOfRound: 0 };
    const probe = { skewX: 0, skewY: 0, radius: 0, preTravel: 0, repeatability: 0 };
    const values = { _MVAR: "0", _MA: "2", _SETVAL: "45", _FA: "3", _TSA: "3", _TUL: "2", _TLL: "-2", _KNUM: "0" };
    const { context, page, problems } = await left(chrome.browser, { cycle: "CYCLE974", values, errors: { part, probe } });
    const button = page.getByRole("button", { name: "Diameters" });
    assert.equal(await button.getAttribute("aria-pressed"), "false");
    assert.ok(!(await letters(page)).some((text) => text.includes("Ø")));
    await button.click();
    assert.equal(await button.getAttribute("aria-pressed"), "true");
    await page.locator(".stage text", { hasText: "Ø45.000 +0.200" }).waitFor();
    const shown = await letters(page);
    assert.ok(shown.filter((text) => text === "Ø45.200").length >= 2, `${shown}`); // of the part, and where it was touched
    assert.ok(shown.some((text) => /^X Ø\d/.test(text)), `${shown}`);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("has no such button where nothing turns, and says what the sliders are where a tool touches its probe", async () => {
    const { context, page, problems } = await left(chrome.browser, { cycle: "CYCLE971" });
    assert.equal(await page.getByRole("button", { name: "Diameters" }).isVisible(), false);
    await page.getByLabel("Length L1", { exact: true }).waitFor({ state: "attached" });
    assert.equal(await page.getByLabel("Skew X", { exact: true }).count(), 0);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
