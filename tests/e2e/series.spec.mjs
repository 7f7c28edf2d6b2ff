// A program run many times in the page: fields, charts, table, both for the example of the manual.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, packages, shared } from "./browser.mjs";
import { faults } from "./room.mjs";
import { modules } from "./sources.mjs";
import { start } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");

describe("the numbers of the fields", () => {
  let sources, numbers, fields;
  before(async () => {
    sources = await modules();
    numbers = await sources.load("/src/numbers.ts");
    fields = await sources.load("/src/views/series-fields.ts");
  });
  after(() => sources.close());

  // oracle: hand
  test("lose zeros behind the decimal point only", () => {
    const shown = [[100, 0], [-20, 0], [0, 0], [-0.4, 0], [100], [1.5], [10.05, 3], [-1e-9], [1e30], [Number.NaN]];
    const texts = ["100", "-20", "0", "0", "100", "1.5", "10.05", "0", "1e+30", "–"];
    assert.deepEqual(
      shown.map(args => numbers.plain(...args)),
      texts,
    );
  });

  // oracle: hand
  test("have all their decimals, as they are typed", () => {
    const all = [0.1, -2.5, 0, 1e-7, -1.25e-9, 5e-324, 0.00000123, 123456.7890123, 1 / 3];
    const texts = all.map(numbers.exact);
    assert.deepEqual(texts.slice(0, 5), ["0.1", "-2.5", "0", "0.0000001", "-0.00000000125"]);
    assert.deepEqual(texts.map(numbers.parseNumber), all);
  });

  // oracle: hand
  test("are those of the series until they are typed over", () => {
    const given = { what: "probe.tip", per: "part", mean: -0.00000025, drift: 0.1234567890123 };
    const vary = [
      { ...given, as: "normal", sigma: 1e-7, follows: { "$TC_DP6[1,1]": 1e-8 } },
      { ...given, as: "uniform", half: 2e-7, follows: {} },
    ];
    const series = { runs: 10, seed: 1, mode: "independent", vary };
    const typed = fields.typedOf(series, []);
    assert.deepEqual(fields.seriesOf(typed), series);
    typed.rows[0].spread = "0,02";
    assert.equal(fields.seriesOf(typed).vary[0].sigma, 0.02);
  });
});

describe("a series of parts", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand: what was pressed has the focus again; the browser's own command prints what the button prints
  test("keeps the focus, and prints the same by its button and by the browser", async () => {
    const { context, page, problems } = await start(chrome);
    await page.keyboard.press("Control+k");
    await page.locator("#palette-search").fill("Series of parts");
    await page.locator(".palette-item", { hasText: "Series of parts" }).first().click();
    const shown = page.getByRole("dialog", { name: "Series of parts" });
    await shown.waitFor();
    await shown.locator(".series-fields input:focus, .series-fields select:focus").waitFor();
    for (const name of ["Example: mean value", "Run series"]) {
      await shown.getByRole("button", { name }).focus();
      await page.keyboard.press("Enter");
      await shown.getByRole("button", { name: "Stop" }).waitFor({ state: "hidden" });
      await shown.locator("button:focus", { hasText: name }).waitFor();
    }
    const paper = page.locator(".series-paper");
    const printed = async bring => {
      await bring();
      await paper.waitFor({ state: "attached" });
      const told = await paper.evaluate(sheet => sheet.innerHTML.replace(/<!--.*?-->/g, ""));
      await page.emulateMedia({ media: "print" });
      assert.equal(await shown.isVisible(), false);
      await page.emulateMedia({ media: null });
      await page.evaluate(() => dispatchEvent(new Event("afterprint")));
      await paper.waitFor({ state: "detached" });
      return told;
    };
    await page.evaluate(() => {
      window.print = () => dispatchEvent(new Event("beforeprint"));
    });
    const byButton = await printed(() => shown.getByRole("button", { name: "Print" }).click());
    assert.equal(await printed(() => page.evaluate(() => print())), byButton);
    await shown.getByRole("button", { name: "Close" }).click();
    await page.evaluate(() => print());
    assert.equal(await paper.count(), 0);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:1265-1284 (rows that its misprint leaves alone); weight 1 corrects each part above _TZL
  test("shows the mean value of the manual's table with weight 3 and weight 1, and its alarms", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await page.keyboard.press("Control+k");
    await page.locator("#palette-search").fill("Series of parts");
    await page.locator(".palette-item", { hasText: "Series of parts" }).first().click();
    const shown = page.getByRole("dialog", { name: "Series of parts" });
    await shown.getByRole("button", { name: "Example: mean value" }).click();
    await shown.getByText("10 parts, 10 to the end of the program, seed 1").waitFor();
    await shown.getByLabel("Parts", { exact: true }).fill("20");
    await shown.getByRole("button", { name: "Run series" }).click();
    await shown.getByText("20 parts, 20 to the end of the program, seed 1").waitFor();
    const tables = await shown.locator("table").evaluateAll(all =>
      all.map(({ tHead, tBodies: [body] }) => {
        const texts = row => [...row.cells].map(cell => cell.textContent);
        return { heads: texts(tHead.rows[0]), rows: [...body.rows].map(texts) };
      }),
    );
    const column = ({ heads, rows }, words) => {
      const at = heads.findIndex(head => head.includes(words));
      return rows.map(row => row[at]);
    };
    const [third, first] = tables;
    assert.deepEqual([third.rows.length, first.rows.length], [20, 20]);
    assert.deepEqual(third.rows[2].slice(0, 2), ["3", "50.060"]);
    const means = column(third, "_MV[0]");
    assert.deepEqual([means[0], means[1], means[6], means[7], means[8]], ["0.010", "0.023", "0.000", "0.010", "0.030"]);
    const changes = sums => sums.filter((sum, at) => sum !== (at ? sums[at - 1] : "0.000")).length;
    const [seldom, often] = [changes(column(third, "T20")), changes(column(first, "T21"))];
    assert.ok(often > seldom && seldom > 0, `${often} corrections, with weight 3 ${seldom}`);
    await counts(shown.locator("figure.series-chart svg[role=slider]"), 4);
    const chart = shown.getByRole("slider").first();
    await chart.focus();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowRight");
    await shown.getByText(/^Part 3 · Actual value 50\.060\smm · Setpoint 50\.000\smm/).waitFor();
    assert.match(await chart.getAttribute("aria-valuetext"), /^Part 3 · /);
    await shown.getByText("No alarm.").waitFor();
    // a desktop at 400 %: each value stands below the other, with its head
    const { width, height } = page.viewportSize();
    await page.setViewportSize({ width: 320, height: 200 });
    await shown.locator(".series-table thead").first().waitFor({ state: "hidden" });
    assert.deepEqual(await faults(page), []);
    await page.setViewportSize({ width, height });
    await page.addScriptTag({ path: axe });
    const wrong = await page.evaluate(() => window.axe.run("dialog.series").then(({ violations }) => violations));
    assert.deepEqual(
      wrong.map(({ id }) => id),
      [],
    );
    // what is no such number is refused by the name of its field, and stays as typed
    for (const [name, text, told] of [
      ["Parts", "many", /Parts: enter a whole number from 1 to 10\D?000/],
      ["Parts", "1.5", /Parts: enter a whole number/],
      ["Parts", "20", null],
      ["Seed", "-1", /Seed: enter a whole number from 0 to /],
      ["Seed", "1.5", /Seed: enter a whole number/],
      ["Seed", "", /Seed: enter a whole number/],
      ["Seed", "99999999999999999999", /Seed: enter a whole number/],
    ]) {
      const field = shown.getByLabel(name, { exact: true });
      await field.fill(text);
      await shown.getByRole("button", { name: "Run series" }).click();
      if (told) await shown.locator(".series-problem", { hasText: told }).waitFor();
      assert.equal(await field.inputValue(), text);
    }
    await shown.getByLabel("Seed", { exact: true }).fill("1");
    // a problem has the words of the fields, not those of the setup file
    await shown.getByLabel("Parts", { exact: true }).fill("20");
    await shown.getByRole("button", { name: "Add what varies" }).click();
    await shown.getByRole("button", { name: "Run series" }).click();
    const problem = shown.locator(".series-problem");
    await problem.getByText(/Varies: \d/).waitFor();
    assert.doesNotMatch(await problem.textContent(), /sigma|series\.vary/);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
