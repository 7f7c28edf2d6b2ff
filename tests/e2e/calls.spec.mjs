// A call and its program: what counts at the call stays with it, whatever form was there before, and after it.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { shared } from "./browser.mjs";
import { startWithEditor } from "./start.mjs";

async function start(chrome, options) {
  const opened = await startWithEditor(chrome, options);
  await opened.page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
  return opened;
}

async function openProgram(page, text) {
  await page
    .locator(".panel-program input[type=file]")
    .setInputFiles({ name: "part.mpf", mimeType: "text/plain", buffer: Buffer.from(text) });
  await page.locator('.notice:has-text("Program opened.")').waitFor();
}

/** Chooses a cycle by the search. */
async function choose(page, name) {
  await page.locator("#task-search").fill(name);
  await page.locator(`.hits[data-search="${name}"] .hit`).first().click();
  await page.waitForFunction(text => document.querySelector(".snippet")?.textContent.includes(text), name);
}

async function openCall(page, index = 0) {
  await page.locator(".call-row").nth(index).click();
  await page.locator(".opened").waitFor();
}

const detach = page => page.getByRole("button", { name: "Detach from program" }).click();

/** The form is drawn in these axes, right and up, and counts lengths in this unit. */
async function standsIn(page, axes, unit) {
  await page.waitForFunction(
    ([drawn, counted]) =>
      [...document.querySelectorAll(".picture .axis")].map(one => one.textContent).join("") === drawn &&
      document.querySelector('.field[data-field="_SETVAL"] .unit')?.textContent === counted,
    [axes, unit],
  );
}

const MILLED = "T1 D1\nM6\n_MVAR=1 _SETVAL=5 _TNUM=1 _KNUM=2001 _FA=1\nCYCLE977\nM30\n";
const TURNED = "T1 D1\n_MVAR=0 _SETVAL=45 _MA=2 _TNUM=7 _KNUM=1 _FA=1\nCYCLE974\nM30\n";

describe("plane and units of a call", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual B:1669-1680 (turning in G18), hand: milling in G17
  test("are those of its own machine after a form for another one, in the program and by the search", async () => {
    const { context, page, problems } = await start(chrome);
    await choose(page, "CYCLE974");
    await standsIn(page, "ZX", "mm");
    await openCall(page); // that of the first visit
    await standsIn(page, "XY", "mm");
    await choose(page, "CYCLE974");
    await openProgram(page, MILLED);
    await standsIn(page, "ZX", "mm");
    await openCall(page);
    await standsIn(page, "XY", "mm");
    await choose(page, "CYCLE974");
    await standsIn(page, "ZX", "mm");
    await choose(page, "CYCLE977");
    await standsIn(page, "XY", "mm");
    await openProgram(page, TURNED);
    await standsIn(page, "XY", "mm");
    await openCall(page);
    await standsIn(page, "ZX", "mm");
    await choose(page, "CYCLE977");
    await standsIn(page, "XY", "mm");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the number and what it counts stay together)
  test("stay when it leaves the program, over a reload, and go with another cycle", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, `G18 G70\n${MILLED}`);
    await openCall(page);
    await standsIn(page, "ZX", "inch");
    await detach(page);
    await page.locator(".opened").waitFor({ state: "hidden" });
    await standsIn(page, "ZX", "inch");
    assert.equal(await page.locator(".at-call").textContent(), "At the call: G18 G70");
    await page.waitForTimeout(500); // kept after a pause
    await page.reload();
    await page.locator(".results tbody tr").first().waitFor({ state: "attached" });
    await standsIn(page, "ZX", "inch");
    await page.locator("#machine-plane").selectOption("G19");
    await standsIn(page, "YZ", "mm");
    await page.locator(".at-call").waitFor({ state: "hidden" });
    await page.locator("#machine-plane").selectOption("G17");
    await openCall(page);
    await standsIn(page, "ZX", "inch");
    await choose(page, "CYCLE979");
    await page.locator(".at-call").waitFor({ state: "hidden" });
    await page.locator('.fields .unit:text-is("mm")').first().waitFor();
    assert.equal(await page.locator('.fields .unit:text-is("inch")').count(), 0);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (in the header it is chosen for the program too)
  test("are those that are chosen by hand, where the program says nothing", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, TURNED);
    await openCall(page);
    await standsIn(page, "ZX", "mm");
    assert.equal(await page.locator("#machine-plane").inputValue(), "G18");
    await page.locator("#machine-units").selectOption("G70");
    await standsIn(page, "ZX", "inch");
    await page.locator("#machine-plane").selectOption("G17");
    await standsIn(page, "XY", "inch");
    await page.locator("#machine-units").selectOption("G71");
    await standsIn(page, "XY", "mm");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (a long program is read aside: until then what is known of the call counts)
  test("stay while a long program is read again after each key", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, `G18 G70\n${"G0 X1\n".repeat(3000)}${MILLED}`);
    await openCall(page);
    await standsIn(page, "ZX", "inch");
    await page.evaluate(() => {
      window.units = new Set();
      const unit = document.querySelector('.field[data-field="_SETVAL"] .unit');
      new MutationObserver(() => window.units.add(unit.textContent)).observe(unit, {
        childList: true,
        characterData: true,
        subtree: true,
      });
    });
    await page.locator('.field[data-field="_SETVAL"] .figure').fill("5.25");
    await page.waitForFunction(() => !document.querySelector(".activity:not([hidden])"));
    await page.locator('.snippet:has-text("_SETVAL=5.25")').waitFor();
    await page.waitForTimeout(500);
    assert.deepEqual(await page.evaluate(() => [...window.units]), []);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
