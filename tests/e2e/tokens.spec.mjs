// The colours of the page: text and marks are told from every ground that they stand on, in each theme.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { shared } from "./browser.mjs";
import { drawn, start } from "./start.mjs";

const GROUNDS = ["surface", "surface-raised", "well", "ground", "accent-soft", "step-line"];
const TEXTS = ["ink", "ink-quiet", "ink-code", "accent", "error", "warning", "note", "good"];
const CODE = ["code-comment", "code-keyword", "code-call", "code-variable", "code-number"];
const MARKS = ["rule-strong", "touch", "zone", "probe", "path", "tolerance", "view-lit", "focus"];
/** Text on the ground of its own kind. */
const PAIRS = [
  ["accent-ink", "accent"],
  ["error", "error-soft"],
  ["warning", "warning-soft"],
  ["warning", "measure-soft"],
  ["good", "good-soft"],
];

/** Relative luminance of `#rrggbb` (WCAG 2.2). */
function luminance(colour) {
  const parts = [1, 3, 5].map(at => Number.parseInt(colour.slice(at, at + 2), 16) / 255);
  const [red, green, blue] = parts.map(part => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

function contrast(one, other) {
  const [light, dark] = [luminance(one), luminance(other)].sort((a, b) => b - a);
  return (light + 0.05) / (dark + 0.05);
}

describe("the colours", () => {
  const chrome = shared("neither", { before, after });

  const pairs = [
    ...[...TEXTS, ...CODE].flatMap(text => GROUNDS.map(ground => [text, ground, 4.5])),
    ...MARKS.flatMap(mark => ["surface", "ground", "well"].map(ground => [mark, ground, 3])),
    ...PAIRS.map(pair => [...pair, 4.5]),
  ];

  // oracle: peer (WCAG 2.2, 1.4.3 and 1.4.11)
  for (const theme of ["light", "dark", "contrast"])
    test(`are told from their grounds, ${theme}`, async () => {
      const { context, page } = await start(chrome, { colorScheme: "light" });
      while ((await page.evaluate(() => document.documentElement.dataset.theme)) !== theme) {
        await page.locator("#theme").evaluate(button => button.click());
        await drawn(page);
      }
      const names = [...new Set(pairs.flatMap(pair => pair.slice(0, 2)))];
      const value = await page.evaluate(
        all =>
          Object.fromEntries(all.map(name => [name, getComputedStyle(document.body).getPropertyValue(`--${name}`)])),
        names,
      );
      for (const name of names) assert.match(value[name], /^#[0-9a-f]{6}$/, name);
      const low = pairs
        .map(([one, other, least]) => ({ one, other, least, is: contrast(value[one], value[other]) }))
        .filter(({ is, least }) => is < least);
      assert.deepEqual(low, []);
      await context.close();
    });

  // oracle: hand
  test("are those of high contrast where the system wants it", async () => {
    const { context, page } = await start(chrome, { contrast: "more" });
    assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "contrast");
    await page.emulateMedia({ contrast: "no-preference", colorScheme: "dark" });
    await page.waitForFunction(() => document.documentElement.dataset.theme === "dark");
    await context.close();
  });
});
