// The page loads, and only from its own origin.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { address, launch, open, setups, shared } from "./browser.mjs";

for (const setup of Object.keys(setups)) {
  describe(`browser with ${setup}`, () => {
    const chrome = shared(setup, { before, after });

    // oracle: hand
    test("the page loads without an error and asks nobody else", async () => {
      const { context, page, problems } = await open(chrome.browser);
      await page.waitForLoadState("networkidle");
      assert.match(await page.title(), /Probewright/);
      assert.deepEqual(problems, []);
      await context.close();
    });
  });
}

describe("without the part of the core that simulates", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand (the first module alone answers fields, checks, snippet and picture)
  test("the form works and the result panel says what is missing", async () => {
    const context = await chrome.browser.newContext({ locale: "en-GB", serviceWorkers: "block" });
    const page = await context.newPage();
    await page.route(/\/program_bg-[^/]*\.wasm$/, route => route.abort());
    await page.goto(address);
    await page.locator("#page-outcome .empty", { hasText: "could not be loaded" }).waitFor();
    const field = page.locator('[id="field-_SETVAL"]');
    await field.fill("-1");
    await field.blur();
    await page.locator(".problem", { hasText: "_SETVAL" }).first().waitFor();
    assert.equal(await page.locator("#broken").count(), 0);
    await context.close();
  });
});

describe("the set-ups are what they say", () => {
  // oracle: browser (the interfaces that it offers)
  test("WebGPU and WebGL2 are there or not", async () => {
    const wanted = { webgpu: [true, true], webgl2: [false, true], neither: [false, false] };
    for (const [setup, expected] of Object.entries(wanted)) {
      assert.deepEqual(await offered(setup), expected, setup);
    }
  });
});

async function offered(setup) {
  const browser = await launch(setup);
  try {
    const { page } = await open(browser);
    return await page.evaluate(async () => {
      const adapter = await navigator.gpu?.requestAdapter().catch(() => null);
      return [Boolean(adapter), Boolean(document.createElement("canvas").getContext("webgl2"))];
    });
  } finally {
    await browser.close();
  }
}
