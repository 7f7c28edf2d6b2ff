// Four users from the start screen to what they came for, with their clicks, keys and values counted.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import { open, shared } from "./browser.mjs";
import { drawn } from "./start.mjs";
import { fits, user, within } from "./user.mjs";

const chrome = shared("neither", { before, after });

/** A first visit, once all variants are known. */
async function visit(options = {}) {
  const opened = await open(chrome.browser, { path: "", ...options });
  const { context, page } = opened;
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.locator(".start .tile").first().waitFor();
  await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
  return { ...opened, one: user(page) };
}

const tile = (page, element) => page.locator(`.tile[data-element="${element}"]`);
const answer = (page, name) => page.locator(".start-answer").getByRole("button", { name, exact: true });
const openForm = page => answer(page, "Open form");
const field = (page, name) => page.locator(`.field[data-field="${name}"] .entry-line > .figure`);
/** The value in the line of a folded section: a click there opens its field. */
const way = (page, name) => page.locator(`.group-sum [data-leads="${name}"]`);
const copyCall = page => page.getByRole("button", { name: "Copy call" });
const copied = page => page.evaluate(() => navigator.clipboard.readText());
const result = page => page.locator(".answer");

describe("a setter measures a bore and corrects G54", () => {
  // oracle: hand (the way of a setter: six actions, three values; G54 is the first zero offset)
  test("with its diameter, measuring path and safe area, at 1280 × 800", async context => {
    const { context: tab, page, problems, one } = await visit();
    assert.ok(await fits(page), "nothing to scroll at the start");
    await one.click(tile(page, "hole"));
    await one.click(answer(page, "Zero offset"));
    assert.match(await page.locator(".start-code").textContent(), /· 101/);
    await one.click(openForm(page));
    await page.locator(":focus[aria-required=true]").waitFor();
    await one.type(field(page, "_SETVAL"), "50.02");
    await one.click(way(page, "_FA"));
    await one.type(field(page, "_FA"), "6");
    await one.click(way(page, "_TSA"));
    await one.type(field(page, "_TSA"), "0.5");
    await one.click(copyCall(page));
    assert.match(await copied(page), /_MVAR=101 _SETVAL=50\.02 _KNUM=1 .*_FA=6 _TSA=0\.5/);
    await result(page)
      .filter({ hasText: /50\.050.*G54.*\+0\.084.*−0\.046.*Within the safe area/s })
      .waitFor();
    await one.inSight(result(page));
    assert.ok(await fits(page), "nothing to scroll at the end");
    within(one, { actions: 6, values: 3 }, context);
    assert.deepEqual(problems, []);
    await tab.close();
  });
});

/** A program as a CAM system writes it: a bore measured after each of twelve passes, once with a digit too many. */
function flange() {
  const call = (index, tul) => [
    `N${index}00 T9 D1 ; probe`,
    `G0 X0 Y0 Z10`,
    `Z-7`,
    `_MVAR=0001 _SETVAL=132 _TUL=${tul} _TLL=-0.05 _TNUM=20 _KNUM=2001 _TSA=1 _FA=2 ; pass ${index}`,
    `CYCLE977\t; keep`,
    `G0 Z50`,
  ];
  const milling = index =>
    Array.from({ length: 24 }, (_, step) => `N${index}${step + 10} G1 X${step} Y-${step}.5 F900`);
  const passes = Array.from({ length: 12 }, (_, at) => [
    ...milling(at + 1),
    ...call(at + 1, at === 7 ? "0.005" : "0.05"),
  ]);
  return `${["; FLANGE OP20 äöü", "G17 G54 G90 G40", ...passes.flat(), "M30"].join("\r\n")}\r\n`;
}

describe("a programmer has a program of 12 calls", () => {
  // oracle: hand (the eighth call allows 0.005 mm where the part has 0.03 mm; only its digits are other bytes)
  test("finds the one beyond its tolerance, mends its value and saves", async context => {
    const { context: tab, page, problems, one } = await visit();
    const text = flange();
    assert.equal(text.split("\r\n").length - 1, 363);
    await one.drop(page.locator(".start-drop"), "FLANGE.MPF", text);
    await page.locator('.call-row[aria-posinset="1"]').waitFor();
    await one.click(page.getByRole("button", { name: "Whole program" }));
    await one.click(page.locator(".whole-top button").first());
    const worst = page.locator('.whole-row[data-place="0"]');
    assert.match(await worst.textContent(), /^8.*132\.030/);
    await one.click(worst);
    await page.locator(".opened").waitFor({ state: "attached" });
    await one.scroll(way(page, "_TUL"));
    await one.click(way(page, "_TUL"));
    await one.type(field(page, "_TUL"), "0.05");
    await page.locator('.whole-counts:has-text("12 within, 0 out")').waitFor();
    const saving = page.waitForEvent("download");
    await one.press("Control+s");
    const bytes = readFileSync(await (await saving).path());
    assert.deepEqual(bytes, Buffer.from(text.replace("_TUL=0.005", "_TUL=0.05")), "every other byte is the same");
    within(one, { actions: 7, values: 1 }, context);
    assert.deepEqual(problems, []);
    await tab.close();
  });
});

describe("a turning shop with both controls", () => {
  // oracle: hand (45 is a diameter, T7 the tool that turned it)
  test("measures a turned diameter", async context => {
    const { context: tab, page, problems, one } = await visit();
    await one.click(tile(page, "turned"));
    await one.click(answer(page, "Tool offset"));
    await one.click(openForm(page));
    await page.locator(":focus[aria-required=true]").waitFor();
    await one.type(field(page, "_SETVAL"), "44.98");
    await one.click(copyCall(page));
    assert.match(await copied(page), /_SETVAL=44\.98.*CYCLE974/s);
    await one.inSight(result(page));
    within(one, { actions: 4, values: 1 }, context);

    // and at the machine beside it, with the other control
    const other = user(page);
    await other.click(page.locator(".to-start"));
    await other.click(page.getByRole("button", { name: "NCT", exact: true }));
    await other.click(tile(page, "hole"));
    await other.click(openForm(page));
    await page.locator(":focus[aria-required=true]").waitFor();
    await other.type(field(page, "D"), "50.02");
    await other.click(copyCall(page));
    assert.match(await copied(page), /G110 D50\.02/);
    await other.inSight(result(page));
    within(other, { actions: 5, values: 1 }, context);
    assert.ok(await fits(page));
    assert.deepEqual(problems, []);
    await tab.close();
  });

  // oracle: hand
  test("calibrates the probe of the lathe", async context => {
    const { context: tab, page, problems, one } = await visit();
    await one.click(tile(page, "probe"));
    await one.click(answer(page, "Lathe"));
    await one.click(openForm(page));
    await page.locator("#panel-form .field").first().waitFor();
    await drawn(page);
    await one.click(copyCall(page));
    assert.match(await copied(page), /CYCLE973/);
    await one.inSight(result(page));
    within(one, { actions: 4, values: 0 }, context);
    assert.deepEqual(problems, []);
    await tab.close();
  });
});

describe("somebody with a keyboard alone, at 400 % and in forced colours", () => {
  // oracle: WCAG 2.2, 1.4.10, 2.1.1, 2.4.7, 2.4.11
  test("measures a bore", async context => {
    const viewport = { width: 320, height: 200 };
    const { context: tab, page, problems, one } = await visit({ viewport, forcedColors: "active" });
    const is = selector => page.evaluate(wanted => !!document.activeElement?.matches(wanted), selector);
    const until = async (key, selector) => {
      for (let tries = 0; tries < 40 && !(await is(selector)); tries++) await one.press(key);
      assert.ok(await is(selector), `${key} leads to ${selector}`);
    };
    await until("Tab", ".tile");
    await one.press("Enter");
    await one.press("Enter");
    await page.locator(":focus[aria-required=true]").waitFor();
    await one.type(page.locator(":focus"), "50.02");
    await until("Tab", ".form-foot .primary");
    await one.press("Enter");
    assert.match(await copied(page), /_SETVAL=50\.02/);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), viewport.width);
    within(one, { actions: 30, values: 1 }, context);
    assert.deepEqual(problems, []);
    await tab.close();
  });
});
