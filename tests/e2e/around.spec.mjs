// Blocks around a call: chosen in the form, written with the call, found again, changed and taken away. The measuring
// result screen of a run.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { shared } from "./browser.mjs";
import { focused, openProgram, programWhen, searchTasks, startWithCycles as start, startWithEditor } from "./start.mjs";

const box = (page, name) => page.locator(`details.around [data-block="${name}"]`);

/** A hole whose result screen waits for NC START. */
const MEASURED =
  "G17 G54 G40 D1\nT1 D1\nM5\n_CHBIT[10]=1 _CHBIT[11]=1\n_MVAR=1 _SETVAL=132 _TUL=0.03 _TLL=-0.03 _TNUM=20 " +
  "_KNUM=2001 _EVNUM=0 _TZL=0.01 _TSA=1 _PRNUM=1 _VMS=0 _NMSP=1 _FA=2\nCYCLE977\nG4 F1\nM30\n";

describe("around", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand: what the block says it does
  test("a rework loop is found by search, written, read again, changed and removed", async () => {
    const { context, page, problems } = await start(chrome);
    await searchTasks(page, "rework");
    await page.locator('.hit[data-kind="around"]').first().click();
    await box(page, "rework").waitFor();
    assert.ok(await box(page, "rework").isChecked());
    assert.equal(await page.locator("#around-rework-program").getAttribute("aria-invalid"), "true");
    await page.locator("#around-rework-program").fill("L120");
    await page.locator("#around-rework-program").press("Tab");
    await page.getByRole("button", { name: "Write into program" }).click();
    const text = await programWhen(page, now => now.includes("PW1_GOOD"));
    assert.match(text, /PW1_AGAIN:[\s\S]*CYCLE977[\s\S]*L120[\s\S]*PW1_GOOD:/);
    assert.ok(await box(page, "rework").isChecked());
    await page.locator("#around-rework-passes").fill("5");
    await page.locator("#around-rework-passes").press("Tab");
    await page.getByRole("button", { name: "Write into program" }).click();
    await programWhen(page, now => now.includes("R99<5"));
    await page.waitForFunction(() => document.querySelector("#around-rework-passes")?.value === "5");
    await box(page, "rework").uncheck();
    await page.getByRole("button", { name: "Write into program" }).click();
    assert.match(await programWhen(page, now => !now.includes("PW1_")), /CYCLE977/);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:12569-12578 (when it is shown, and that NC START ends it)
  test("a result screen is opened from the results, and NC START goes on", async () => {
    const { context, page, problems } = await startWithEditor(chrome);
    await openProgram(page, MEASURED);
    await page.locator(".panel-view").getByRole("button", { name: "Whole program" }).click();
    await page.locator(".screen-list li button").click();
    const screen = page.getByRole("region", { name: "Measuring result screen" });
    await focused(page, screen);
    assert.match(await screen.textContent(), /Workpiece measurement[\s\S]*132/);
    await screen.getByRole("button", { name: "NC START" }).click();
    await screen.waitFor({ state: "hidden" });
    await focused(page, page.locator(".timeline input[type=range]"));
    assert.deepEqual(problems, []);
    await context.close();
  });
});
