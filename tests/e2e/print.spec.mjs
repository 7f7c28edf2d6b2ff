// The print-out of the NCT macros, shown and saved as it is shown; and the page on paper.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import { counts, open, shared } from "./browser.mjs";
import { searchTasks } from "./start.mjs";

describe("print-out", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual C:1103-1116 (header of the print-out of dimensions)
  test("is saved as it is shown", async () => {
    const { context, page, problems } = await open(chrome.browser);
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" }); // all cycles are known
    await searchTasks(page, "G110");
    await page.locator("button, [role=option], [role=treeitem]", { hasText: "G110" }).first().click();
    await page.getByRole("tab", { name: "Log" }).click();
    const shown = page.locator("pre.log", { hasText: "DIMENSION" });
    await shown.waitFor();
    const saving = page.waitForEvent("download");
    await page.getByRole("button", { name: "Save as file" }).click();
    const text = readFileSync(await (await saving).path(), "utf8");
    assert.equal(text, `${await shown.textContent()}\n`);
    assert.match(text, /TOOL {7}NOMINAL/);
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("the page on paper", () => {
  const chrome = shared("neither", { before, after });

  for (const [name, options] of Object.entries({
    "a wide window": {},
    "a phone that never showed the view": { viewport: { width: 390, height: 844 } },
    "a dark page": { colorScheme: "dark" },
  })) {
    // oracle: hand
    test(`has file, date, form, result, 3D view and the whole program: ${name}`, async () => {
      const { context, page, problems } = await open(chrome.browser, options);
      await page.locator(".results tbody tr").first().waitFor({ state: "attached" });
      const lines = [
        ...Array.from({ length: 300 }, (_, i) => `N${i + 1} G0 X${i}`),
        "_MVAR=1 _SETVAL=132 _TNUM=20 _KNUM=2001 _FA=2 _TSA=1",
        "CYCLE977",
        "M30",
      ];
      await page.locator(".panel-program input[type=file]").setInputFiles({
        name: "part one.mpf",
        mimeType: "text/plain",
        buffer: Buffer.from(`${lines.join("\r\n")}\r\n`),
      });
      await page.locator('.file-name:text-is("part one.mpf")').waitFor({ state: "attached" });
      await page.waitForLoadState("networkidle");
      await page.emulateMedia({ media: "print" });
      // the drawing is fetched once the page has time: who prints before has a sheet without it
      await page.waitForFunction(() => {
        dispatchEvent(new Event("beforeprint"));
        return document.querySelector(".sheet-picture");
      });
      const head = await page.locator(".sheet-head").innerText();
      assert.match(head, /part one\.mpf/);
      assert.match(head, /SINUMERIK/);
      assert.match(head, new RegExp(`${new Date().getFullYear()}`));
      assert.deepEqual(await page.locator(".sheet-program li").allInnerTexts(), lines);
      assert.ok((await page.locator(".sheet-picture path").count()) > 10);
      assert.ok((await page.locator(".sheet-view .legend li").count()) > 2);
      const { width, height } = await page.locator(".sheet-picture").boundingBox();
      assert.ok(width > 250 && height > 120, `${width} × ${height}`);
      for (const part of ["#panel-form .field", "#panel-results tbody tr", ".sheet-view", ".sheet-program"])
        await page.locator(part).first().waitFor();
      for (const part of [".top", ".panel-bar", ".editor", ".timeline", "#panel-tasks"])
        assert.ok(await page.locator(part).first().isHidden(), part);
      await page.evaluate(() => dispatchEvent(new Event("afterprint")));
      await counts(page.locator(".sheet"), 0);
      assert.deepEqual(problems, []);
      await context.close();
    });
  }

  // oracle: hand
  test("tells how many lines of a long program it leaves out", async () => {
    const { context, page } = await open(chrome.browser);
    await page.locator(".results tbody tr").first().waitFor();
    await page
      .locator(".panel-program input[type=file]")
      .setInputFiles({ name: "long.mpf", mimeType: "text/plain", buffer: Buffer.from("N10 G0 X0\n".repeat(2345)) });
    await page.locator('.file-name:text-is("long.mpf")').waitFor();
    await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
    await counts(page.locator(".sheet-program li"), 2000);
    assert.match(await page.locator(".sheet-program p").textContent(), /345\D.*2345/);
    await context.close();
  });
});
