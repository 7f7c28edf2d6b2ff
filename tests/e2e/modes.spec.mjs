// How a program is carried out beside AUTOMATIC: what is skipped, and a program of the 840C that becomes one of today.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { packages, shared } from "./browser.mjs";
import { startWithEditor as start } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");
const MAIN =
  "G17 G90 G54 T9 D1 M6\nG0 X64 Y38 Z130 F1000\n" +
  "_MVAR=102 _SETVAL=70 _FA=2 _TSA=2 _ID=-20 _KNUM=0 _PRNUM=1\nCYCLE977\nM30\n";
const OLD = "G17 G90 G54 T9 D1 M6\nG0 X64 Y38 Z130\nR23=102 R42=70 R28=2 R36=2 R19=-20 R10=0 R22=1\nL977\nM30\n";

async function opened(page, name, text) {
  const file = { name, mimeType: "text/plain", buffer: Buffer.from(text) };
  await page.locator(".panel-program input[type=file]").first().setInputFiles([file]);
  await page.locator('.notice:has-text("Program opened.")').waitFor();
}

describe("the mode of a run", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual B:660-668 (which modes skip the cycles)
  test("is chosen beside the run, and what is skipped is told", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await opened(page, "part.mpf", MAIN);
    await page.locator(".segments").getByRole("button", { name: "Whole program" }).click();
    await page.locator(".panel-results [id=tab-outcome]").click();
    await page.locator(".ended").waitFor();
    await page.getByLabel("Mode", { exact: true }).selectOption({ label: "Program test" });
    await page
      .locator(".given-mode")
      .getByText(/On the machine no axis moves/)
      .waitFor();
    await page.locator("#tab-problems").click();
    await page
      .getByText(/CYCLE977 is skipped: program test/)
      .first()
      .waitFor();
    await page.locator("#tab-outcome").click();
    await page.getByLabel("Mode", { exact: true }).selectOption({ label: "Block search" });
    await page.getByLabel("Block search up to line").fill("4");
    await page.getByLabel("Block search up to line").blur();
    await page.locator(".answer, .ended").first().waitFor();
    await page.addScriptTag({ path: axe });
    const wrong = await page.evaluate(() => window.axe.run(".given").then(({ violations }) => violations));
    assert.deepEqual(
      wrong.map(({ id }) => id),
      [],
    );
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual A:16128-16737 (the names beside each R parameter)
  test("a program of the 840C is written with the names of today", async () => {
    const { context, page, problems } = await start(chrome);
    await opened(page, "old.mpf", OLD);
    await page.locator("#tab-problems").click();
    const call = page.locator(".panel-results li").filter({ hasText: "measuring call of an 840C" }).first();
    await call.getByRole("button", { name: /Convert to CYCLE977/ }).click();
    await page.getByRole("button", { name: "Apply", exact: true }).click();
    const text = page.locator(".cm-content");
    await text.getByText("CYCLE977").first().waitFor();
    const wanted = "_MVAR=102 _SETVAL=70 _FA=2 _TSA=2 _ID=-20 _KNUM=0 _PRNUM=1";
    assert.ok((await text.textContent()).includes(wanted), await text.textContent());
    assert.deepEqual(problems, []);
    await context.close();
  });
});
