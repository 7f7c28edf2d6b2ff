// The page loads, and only from its own origin.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { address, counts, launch, open, setups, shared } from "./browser.mjs";

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

const CORE = /\/core_bg-[^/]*\.wasm$/;

describe("without the core", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("the form stands, what is typed stays, and the result panel says what is missing", async () => {
    const { context, page } = await visit(chrome, route => route.abort());
    await page.locator("#page-outcome .empty", { hasText: "could not be loaded" }).waitFor();
    const field = page.locator('[id="field-_SETVAL"]');
    await field.fill("-1");
    await field.blur();
    assert.equal(await field.inputValue(), "-1");
    await counts(page.locator("#broken"), 0);
    await context.close();
  });
});

describe("before the core has come", () => {
  const chrome = shared("neither", { before, after });

  // oracle: self (the core, once it is there, says the same of the first visit as while the page was built)
  test("a first visit shows form and result, and both stay as they are", async () => {
    const core = held();
    const { context, page } = await visit(chrome, core.hold);
    await page.locator(".answer-line b").first().waitFor();
    const early = await shown(page);
    assert.match(early.result, /132[.,]03/);
    core.release();
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
    assert.deepEqual(await shown(page), early);
    await context.close();
  });

  // oracle: hand
  test("what is typed stays in its field, shows no call, and is answered by the core", async () => {
    const core = held();
    const { context, page } = await visit(chrome, core.hold);
    await page.locator('[id="field-_SETVAL"]').fill("-1");
    await page.waitForFunction(() => !document.querySelector(".answer-line b"));
    await counts(page.locator(".problem", { hasText: "_SETVAL" }), 0);
    assert.doesNotMatch(await page.locator(".panel-form").innerText(), /_SETVAL=/);
    core.release();
    await page.locator(".problem", { hasText: "_SETVAL" }).first().waitFor();
    assert.equal(await page.locator('[id="field-_SETVAL"]').inputValue(), "-1");
    await context.close();
  });
});

/** The page as it is seen for the first time, with this done to the core on its way. */
async function visit(chrome, core) {
  const context = await chrome.browser.newContext({ locale: "en-GB", serviceWorkers: "block" });
  const page = await context.newPage();
  await page.route(CORE, core);
  await page.goto(`${address}#measure`);
  await page.locator(".field input").first().waitFor();
  return { context, page };
}

/** A request that goes on once it is released. */
function held() {
  let release = () => {};
  const released = new Promise(resolve => {
    release = resolve;
  });
  return { hold: route => released.then(() => route.continue()), release };
}

/** Values of the form, and the line of the result. */
async function shown(page) {
  const fields = await page.locator(".field").evaluateAll(all => all.map(one => one.textContent));
  const values = await page.locator(".field input").evaluateAll(all => all.map(one => one.value));
  return { fields, values, result: await page.locator(".answer-line").innerText() };
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
