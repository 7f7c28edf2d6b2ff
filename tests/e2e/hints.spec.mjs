// What a finding advises is said with all that it names: no text of the page shows how it was to be put together.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { startWithEditor as start } from "./start.mjs";

const LOCALES = { "en-GB": "Assign R99 before the call", "de-DE": "R99 vor dem Aufruf", "zh-CN": "R99" };
const REST = "_KNUM=0 _PRNUM=1 _FA=2 _TSA=2";
// values that lack, are no numbers, too large, out of range, unusual, of no variant, unknown before the program runs
const WRONG = ["", "R99", "x y", "1e99", "-5", "0", "0.5", "99999", "2*R98+R99", "200000"];

const input = (page, name) => page.locator(`.field[data-field="${name}"] .entry-line > .figure`);

/** Texts in which something was not put in. */
const raw = page =>
  page.evaluate(() => {
    const texts = [...document.querySelectorAll("body *")].flatMap(node => [
      ...[...node.childNodes].flatMap(one => (one.nodeType === Node.TEXT_NODE ? [one.data] : [])),
      ...["title", "aria-label"].map(name => node.getAttribute(name) ?? ""),
    ]);
    return texts.filter(text => /\{\s*\$/.test(text));
  });

describe("what a finding advises", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  for (const [locale, told] of Object.entries(LOCALES))
    test(`is said with its arguments in ${locale}`, async () => {
      const { context, page, problems } = await start(chrome, { locale });
      const warned = [];
      page.on("console", message => {
        if (message.type() === "warning" && /messages:/.test(message.text())) warned.push(message.text());
      });
      const text = `_MVAR=1 _SETVAL=40 ${REST}\nCYCLE977\n_MVAR=0 _SETVAL=R99 ${REST}\nCYCLE978\nCYCLE979\nM30\n`;
      await page
        .locator(".panel-program input[type=file]")
        .setInputFiles({ name: "part.mpf", mimeType: "text/plain", buffer: Buffer.from(text) });
      await page.locator(".call-row").nth(2).waitFor();
      await page.locator(".call-row").first().click();
      await page.locator(".opened").waitFor();
      await input(page, "_SETVAL").fill("R99");
      await page.locator(`.field[data-field="_SETVAL"] .hint:has-text("${told}")`).waitFor();
      const names = await page
        .locator(".field[data-field]:visible")
        .evaluateAll(all => all.map(one => one.dataset.field));
      assert.ok(names.length > 4);
      for (const name of names)
        for (const value of WRONG) {
          const field = input(page, name);
          if (!(await field.isVisible())) continue;
          const before = await field.inputValue();
          await field.fill(value);
          await page.evaluate(() => new Promise(done => requestAnimationFrame(() => setTimeout(done, 30))));
          assert.deepEqual(await raw(page), [], `${name}=${value}`);
          await field.fill(before);
        }
      await page.locator('[role="tab"]').nth(1).click(); // of the program
      await page.locator(".panel-results .problem").first().waitFor();
      assert.deepEqual(await raw(page), []);
      assert.deepEqual(warned, []);
      await counts(page.locator(".call-row"), 3);
      assert.deepEqual(problems, []);
      await context.close();
    });
});
