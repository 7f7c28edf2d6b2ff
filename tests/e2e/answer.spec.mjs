// The line that says what a call came to: in sight in every state, in figures, words and a gauge, and behind its call.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { openErrors, openFirstCall, start, startWithEditor, stored } from "./start.mjs";

const bar = page => page.locator(".answer");
const verdict = page => bar(page).locator(".verdict");
const error = (page, name) => page.locator(`.slider:has(#error-part-${name}) .figure`);

/** Waits until the verdict is this one. */
const judged = (page, wanted) => page.locator(`.answer .verdict[data-verdict="${wanted}"]`).waitFor();

describe("the answer", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand (a hole of 132 mm in the first form, tolerance 0.03; a hole too large is scrap)
  test("says diameter, deviation, correction, verdict and why, all in sight at 1280 × 800", async () => {
    const { context, page, problems } = await start(chrome, { viewport: { width: 1280, height: 800 } });
    await verdict(page).waitFor();
    await openErrors(page);
    await error(page, "size").fill("0.028");
    await page.locator('.answer .off:text-is("+0.028")').waitFor();
    await judged(page, "within");
    assert.match(await bar(page).textContent(), /Diameter.*Ø \d+\.\d{3}.*\+0\.028.*T\d+ D\d.*R.\+0\.014/s);
    await error(page, "size").fill("0.04");
    await judged(page, "scrap");
    await counts(page.locator(".answer .needle-bad"), 1);
    assert.match(await bar(page).locator(".why").textContent(), /0\.04.mm/);
    const box = await bar(page).boundingBox();
    assert.ok(box.y >= 0 && box.y + box.height <= 800, JSON.stringify(box));
    assert.ok(box.width > 300 && box.height >= 72, JSON.stringify(box));
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: JCGM 100, eq. 10 (two touches and their calibration, each with σ: U = 2 · 2σ), hand (on the limit a hole is
  // good or scrap)
  test("says how certain it is, where the probe spreads only", async () => {
    const { context, page, problems } = await start(chrome, { viewport: { width: 1280, height: 800 } });
    const certain = bar(page).locator(".answer-certain");
    await verdict(page).waitFor();
    await counts(certain, 0);
    await openErrors(page);
    const repeatability = page.locator(".slider:has(#error-probe-repeatability) .figure");
    await error(page, "size").fill("0");
    await repeatability.fill("0.001");
    await page.locator('.answer-certain[data-proof="good"]').waitFor();
    const [, expanded] = (await certain.textContent()).match(/Ø \d+\.\d{4} ± (0\.00\d\d).mm \(k = 2\)/);
    assert.ok(Math.abs(Number(expanded) - 0.004) < 0.0007, expanded);
    await error(page, "size").fill("0.03");
    await page.locator('.answer-certain[data-proof="undecided"]').waitFor();
    assert.match(await certain.textContent(), /good \d.*%, scrap \d.*%.*Largest contribution: .* of the probe/s);
    const box = await bar(page).boundingBox();
    assert.ok(box.y >= 0 && box.y + box.height <= 800, JSON.stringify(box));
    await repeatability.fill("0");
    await certain.waitFor({ state: "detached" });
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("names the alarm, and does not rely on colour", async () => {
    const { context, page } = await start(chrome);
    await verdict(page).waitFor();
    await openErrors(page);
    await error(page, "size").fill("1.5");
    await judged(page, "alarm");
    assert.match(await verdict(page).textContent(), /61303/);
    await counts(verdict(page).locator("svg"), 1);
    await context.close();
  });

  // oracle: hand (a call with a value that its check refuses is not carried out: no older figure stays in sight)
  test("is empty while the check refuses the call, and comes back", async () => {
    const { context, page, problems } = await start(chrome);
    await verdict(page).waitFor();
    const setpoint = page.locator('.field[data-field="_SETVAL"] .entry-line > .figure');
    const before = await setpoint.inputValue();
    await setpoint.fill("-1");
    await bar(page).locator(".answer-none", { hasText: "_SETVAL" }).waitFor();
    await counts(verdict(page), 0);
    assert.doesNotMatch(await page.locator(".answer-line").textContent(), /Ø/);
    await page.waitForFunction(() => document.querySelector(".answer [role=status]").textContent === "");
    await setpoint.fill("");
    await bar(page).locator(".answer-none").waitFor();
    await setpoint.fill(before);
    await verdict(page).waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (a program that stops before its first measurement: why, and what helps, where the answer would be)
  test("says what stopped the program, and adds what is missing", async () => {
    const { context, page } = await startWithEditor(chrome);
    const call = "_MVAR=101 _SETVAL=50 _KNUM=1 _PRNUM=1 _VMS=0 _NMSP=1 _FA=8 _TSA=5";
    await openFirstCall(page, `G54 G17\nT="PROBE_3D" M6\nD1\nG0 X0 Y0 Z-10\n${call}\nCYCLE977\nM30\n`);
    await page.getByRole("button", { name: "Whole program" }).click();
    const told = bar(page).locator(".answer-none[data-stopped]", { hasText: "Tool PROBE_3D does not exist" });
    await told.waitFor();
    await told.getByRole("button", { name: "Add probe PROBE_3D" }).click();
    await verdict(page).waitFor();
    await context.close();
  });

  // oracle: hand (WCAG 4.1.3: told once, when nothing more follows)
  test("is told once it rests", async () => {
    const { context, page } = await start(chrome);
    await verdict(page).waitFor();
    await page.waitForFunction(() => document.querySelector(".answer [role=status]").textContent !== "");
    await page.evaluate(() => {
      const live = document.querySelector(".answer [role=status]");
      window.said = [];
      new MutationObserver(() => window.said.push(live.textContent)).observe(live, { childList: true, subtree: true });
    });
    await error(page, "size").evaluate(field => {
      for (const value of ["0.01", "0.015", "0.02", "0.025"]) {
        field.value = value;
        field.dispatchEvent(new InputEvent("input", { bubbles: true }));
      }
    });
    await page.waitForFunction(() => window.said.at(-1)?.includes("+0.025"));
    assert.equal(await page.evaluate(() => window.said.length), 1, "not at every key");
    await context.close();
  });

  // oracle: hand
  test("stands behind the call in the program and is no part of it", async () => {
    const { context, page } = await startWithEditor(chrome);
    await verdict(page).waitFor();
    const text = "G17 G54 G90\n_MVAR=101 _SETVAL=50 _KNUM=1 _PRNUM=1 _FA=6 _TSA=0.5\nCYCLE977\nM30\n";
    await page
      .locator(".panel-program input[type=file]")
      .setInputFiles({ name: "part.mpf", mimeType: "text/plain", buffer: Buffer.from(text) });
    await page.locator(".call-row").first().click();
    await openErrors(page);
    await error(page, "dx").fill("0.084");
    const hint = page.locator('.cm-line:has-text("CYCLE977") .cm-hint');
    await hint.filter({ hasText: /Ø 50\.030 · X.\+0\.084/ }).waitFor();
    assert.equal((await stored(page)).programs.sinumerik, text);
    await context.close();
  });
});
