// The page in several tabs: a new one asks whose work it continues, and none takes away what another one has kept.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { drawn, keptWhen, lengthField, STORE, startWithEditor, stored } from "./start.mjs";

const question = page => page.locator("dialog.continuing[open]");
const choices = page => question(page).getByRole("button");
const value = page => lengthField(page).inputValue();
const LINE = "N10 G1 X10.5 Y20.25 F500 ; line\n";

/** Another tab with the page, as far as its form. */
async function another(page) {
  const next = await page.context().newPage();
  await next.goto(page.url());
  await ready(next);
  return next;
}

async function ready(page) {
  await page.locator(".cm-content").waitFor();
  await page.locator(".field").first().waitFor();
  await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
}

async function reload(page) {
  await page.reload();
  await ready(page);
}

/** Long enough for an answer of the other tabs. */
async function isNotAsked(page) {
  await page.waitForTimeout(500);
  await counts(question(page), 0);
}

describe("a new tab beside one with work", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("asks, and goes on with a copy on Escape; each keeps its own, a later visit has the last change", async () => {
    const { context, page, problems } = await startWithEditor(chrome);
    await ready(page);
    await lengthField(page).fill("31.25");
    const other = await another(page);
    await question(other).waitFor();
    const { cycle } = await stored(page);
    assert.match(await choices(other).first().textContent(), new RegExp(`${cycle}.* \\d\\d:\\d\\d`));
    await counts(choices(other), 2, "the copy that is shown, and to start anew");
    assert.ok(
      await choices(other)
        .first()
        .evaluate(one => one.matches(":focus")),
    );
    await other.keyboard.press("Escape");
    await question(other).waitFor({ state: "detached" });
    assert.equal(await value(other), "31.25");
    await lengthField(other).fill("44.5");
    await keptWhen(other, state => JSON.stringify(state).includes("44.5"));
    for (const [tab, own] of [
      [page, "31.25"],
      [other, "44.5"],
    ]) {
      await reload(tab);
      await isNotAsked(tab);
      assert.equal(await value(tab), own);
    }
    const third = await another(page);
    await question(third).waitFor();
    assert.equal(await value(third), "44.5");
    await counts(choices(third), 3, "both works, and to start anew");
    await choices(third).nth(1).click();
    await question(third).waitFor({ state: "detached" });
    await third.waitForFunction(() => document.querySelector(".snippet").textContent.includes("31.25"));
    assert.equal(await value(third), "31.25");
    for (const tab of [third, other, page]) await tab.close();
    const later = await context.newPage();
    await later.goto(page.url());
    await ready(later);
    await isNotAsked(later);
    assert.equal(await value(later), "44.5", "not what was closed last");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("starts anew by keyboard, and a tab with nothing of its own keeps no work from a later visit", async () => {
    const { context, page, problems } = await startWithEditor(chrome);
    await ready(page);
    const example = await value(page);
    await lengthField(page).fill("31.25");
    const other = await another(page);
    await question(other).waitFor();
    // the copy that it began with is what was kept last
    await other.evaluate(name => localStorage.setItem(name, sessionStorage.getItem(name)), STORE);
    await other.keyboard.press("Tab");
    await other.keyboard.press("Enter");
    await question(other).waitFor({ state: "detached" });
    await other.waitForFunction(() => !document.querySelector(".snippet").textContent.includes("31.25"));
    assert.equal(await value(other), example);
    await other.locator("#theme").click();
    await reload(other);
    await isNotAsked(other);
    assert.equal(await value(other), example);
    await page.close();
    await other.close({ runBeforeUnload: false });
    const later = await context.newPage();
    await later.goto(page.url());
    await ready(later);
    assert.equal(await value(later), "31.25");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("is not asked where nobody has worked, and asks no more once somebody works in it", async () => {
    const { context, page } = await startWithEditor(chrome);
    await ready(page);
    const other = await another(page);
    await isNotAsked(other);
    await lengthField(other).fill("31.25");
    const third = await another(page);
    await question(third).waitFor();
    await lengthField(third).fill("44.5");
    await question(third).waitFor({ state: "detached" });
    assert.deepEqual([await value(other), await value(third)], ["31.25", "44.5"]);
    await context.close();
  });

  // oracle: hand
  test("copies a program that is too long for local storage, and each tab keeps it as its own", async () => {
    const { context, page } = await startWithEditor(chrome);
    await ready(page);
    await page.locator(".panel-program input[type=file]").setInputFiles({
      name: "part.mpf",
      mimeType: "text/plain",
      buffer: Buffer.from(LINE.repeat(12_000)),
    });
    await page.locator('.file-name:text-is("part.mpf")').waitFor();
    const other = await another(page);
    await question(other).waitFor();
    await other.locator('.file-name:text-is("part.mpf")').waitFor();
    for (const [tab, key] of [
      [page, "7"],
      [other, "8"],
    ]) {
      await tab.bringToFront();
      await tab.locator(".cm-content").click();
      await tab.keyboard.press("Control+Home");
      await tab.keyboard.press("End");
      await tab.keyboard.press(key);
      await drawn(tab);
      await tab.waitForTimeout(500);
    }
    for (const [tab, key] of [
      [page, "7"],
      [other, "8"],
    ]) {
      await tab.bringToFront();
      await reload(tab);
      await tab.locator(`.cm-line:has-text("; line${key}")`).first().waitFor();
      await isNotAsked(tab);
    }
    const third = await another(page);
    await choices(third).nth(1).click();
    await third.locator('.cm-line:has-text("; line7")').first().waitFor();
    await context.close();
  });
});
