// Dimensions in the 3D view: those of the focused field; the diameters of a turning machine as on a drawing, and the
// words of the errors where a tool is touched.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, open, shared } from "./browser.mjs";
import { openErrors, searchTasks, unfold } from "./start.mjs";

/** The page with the worked measurement of this cycle's first variant in the form; everything is drawn. */
async function chosen(browser, cycle) {
  const { context, page, problems } = await open(browser);
  await unfold(page);
  await searchTasks(page, cycle);
  await page.locator(`.hits[data-search="${cycle}"] .hit`).first().click();
  await page.locator(".results tbody tr").first().waitFor({ state: "attached" });
  await page.locator("[data-backend]").first().waitFor({ state: "attached" });
  return { context, page, problems };
}

const letters = page => page.locator(".stage svg[aria-hidden] text").allTextContents();

describe("dimensions in the 3D view", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand (the part's own size is there; a way comes with its field, and what is focused stands out)
  test("explain the focused field", async () => {
    const { context, page, problems } = await chosen(chrome.browser, "CYCLE977");
    const named = name => page.locator(`.stage svg[aria-hidden] text[data-field="${name}"]`);
    const ink = name => named(name).getAttribute("fill");
    await named("_SETVAL").waitFor({ state: "attached" });
    const plain = await ink("_SETVAL");
    await counts(named("_FA"), 0);
    const figure = name => page.locator(`.field[data-field="${name}"] .figure`).first();
    await figure("_FA").focus();
    await named("_FA").waitFor({ state: "attached" });
    const lit = await ink("_FA");
    assert.notEqual(lit, plain);
    assert.equal(await ink("_SETVAL"), plain);
    await figure("_SETVAL").focus();
    await named("_FA").waitFor({ state: "detached" });
    assert.equal(await ink("_SETVAL"), lit);
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("a turning machine", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual B:10623 (the example's set diameter of 45 mm), hand (the part is 0.2 mm larger)
  test("shows its diameters as on a drawing when asked", async () => {
    const { context, page, problems } = await chosen(chrome.browser, "CYCLE974");
    const button = page.getByRole("button", { name: "Diameters" });
    await button.waitFor();
    assert.equal(await button.getAttribute("aria-pressed"), "false");
    assert.ok(!(await letters(page)).some(text => text.includes("Ø")));
    await button.click();
    await page.getByRole("button", { name: "Diameters", pressed: true }).waitFor();
    await openErrors(page);
    await page.getByRole("textbox", { name: /^Size/ }).fill("0.2");
    await page.locator(".stage text", { hasText: "Ø45.000 +0.200" }).waitFor({ state: "attached" });
    const shown = await letters(page);
    // of the part, and where it was touched
    assert.ok(shown.filter(text => text === "Ø45.200").length >= 2, `${shown}`);
    assert.ok(
      shown.some(text => /^X Ø\d/.test(text)),
      `${shown}`,
    );
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("has no such button where nothing turns, and says what the sliders are for a tool at its probe", async () => {
    const { context, page, problems } = await chosen(chrome.browser, "CYCLE971");
    await openErrors(page);
    await page.getByLabel("Length L1", { exact: true }).waitFor({ state: "attached" });
    await counts(page.getByRole("button", { name: "Diameters" }), 0);
    await counts(page.getByLabel("Skew X", { exact: true }), 0);
    assert.equal(await page.getByLabel("Out-of-roundness", { exact: true }).isVisible(), false);
    await page.getByLabel("Taper", { exact: true }).waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});
