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
    await page.goto(`${address}#measure`);
    await page.locator("#page-outcome .empty", { hasText: "could not be loaded" }).waitFor();
    const field = page.locator('[id="field-_SETVAL"]');
    await field.fill("-1");
    await field.blur();
    await page.locator(".problem", { hasText: "_SETVAL" }).first().waitFor();
    assert.equal(await page.locator("#broken").count(), 0);
    await context.close();
  });
});

describe("what the first form waits for", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand (names of cycles stand in a module as they are written)
  test("is a module that knows one cycle, the other knows them all", async () => {
    const { context, page } = await open(chrome.browser, { serviceWorkers: "block" });
    const modules = {};
    page.on("request", request => {
      const module = /\/(core|program)_bg-[^/]*\.wasm$/.exec(request.url())?.[1];
      if (module) modules[module] = request.url();
    });
    await page.reload();
    await page.waitForLoadState("networkidle");
    const named = { core: await names(modules.core), program: await names(modules.program) };
    assert.deepEqual([named.core.size, [...named.core].every(name => named.program.has(name))], [1, true]);
    assert.ok(named.program.size > 30, `${[...named.program]}`);
    await context.close();
  });
});

/** Names of measuring cycles and macros in the bytes of a module; the figure of another text may stand behind one. */
async function names(module) {
  const bytes = Buffer.from(await (await fetch(module)).arrayBuffer());
  return new Set(bytes.toString("latin1").match(/CYCLE(?:9\d\d|1[01]\d)|G1(?:0[1-9]|10)(?!\d)|G65 P99\d\d/g));
}

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
