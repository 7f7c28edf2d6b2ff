// The page in another language: switched while it stands, kept, complete, and chosen as the browser wants.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { open, shared } from "./browser.mjs";
import { searchTasks } from "./start.mjs";

const HAN = /\p{Script=Han}/u;

async function start(chrome, options) {
  const opened = await open(chrome.browser, options);
  await opened.page.locator(".results tbody tr").first().waitFor({ state: "attached" });
  await opened.page.locator(".cm-content").waitFor({ state: "attached" });
  return opened;
}

/** Chooses a language; the page has changed once the choice itself was made anew. */
async function speak(page, language) {
  const old = await page.locator("#language").elementHandle();
  await page.locator("#language").selectOption(language);
  await page.waitForFunction(node => !node.isConnected, old);
  assert.equal(await page.evaluate(() => document.documentElement.lang), language);
}

/** Texts of an element and of what it tells a screen reader. */
const texts = (page, selector) =>
  page
    .locator(selector)
    .evaluateAll(nodes => nodes.flatMap(node => [node.textContent, node.ariaLabel ?? ""]).filter(Boolean));

describe("language", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("every word follows a switch; program, undo, scroll and focus stay", async () => {
    const { context, page, problems } = await start(chrome);
    const content = page.locator(".cm-content");
    await page.keyboard.press("F6"); // tasks, form, program
    for (let tries = 0; tries < 5 && !(await content.isVisible()); tries++) await page.keyboard.press("F6");
    await content.click();
    await page.keyboard.press("Control+Home");
    await page.keyboard.type("G17 ");
    await page.locator(".field.kind-real .entry-line > .figure").first().fill("x");
    await page.locator(".field .problem").first().waitFor();
    await page.waitForFunction(() => document.querySelector(".editor").shadowRoot.textContent.includes("=x "));
    const typed = await content.innerText();
    assert.match(typed, /^G17 .*=x /);
    const scrolled = await page.locator(".panel-form > .scroll").evaluate(node => {
      node.scrollTop = 120;
      return node.scrollTop;
    });

    await speak(page, "zh");
    for (const selector of [
      "#page-actions button",
      ".field-label",
      ".field .problem-text",
      ".tabs button",
      "#panel-program h2",
      ".tree-item.level-1 .tree-title",
    ]) {
      const found = await texts(page, selector);
      assert.ok(found.length > 0, selector);
      for (const text of found) assert.match(text, HAN, `${selector}: ${text}`);
    }
    assert.equal(await page.locator(".panel-form > .scroll").evaluate(node => node.scrollTop), scrolled);
    assert.equal(await content.innerText(), typed);
    assert.match(await content.getAttribute("aria-label"), HAN);
    await content.click();
    for (let undone = 0; undone < 9 && /^G17 /.test(await content.innerText()); undone++)
      await page.keyboard.press("Control+Z");
    assert.doesNotMatch(await content.innerText(), /^G17 |=x /, "what was done before the switch is undone after it");
    await page.keyboard.press("Control+F");
    assert.match(await page.locator(".cm-search").innerText(), HAN);

    await page.reload();
    await page.locator(".field").first().waitFor();
    assert.equal(await page.evaluate(() => document.documentElement.lang), "zh");
    assert.match(await page.locator(".field-label").first().textContent(), HAN);
    await speak(page, "en");
    const name = await page.locator('#language option[value="zh"]').textContent();
    assert.doesNotMatch((await page.locator("body").innerText()).replace(name, ""), HAN);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("the first visit speaks what the browser wants", async () => {
    const { context, page } = await start(chrome, { locale: "zh-CN" });
    assert.equal(await page.evaluate(() => document.documentElement.lang), "zh");
    for (const selector of ["#form-title", ".change-label", ".results tbody td:nth-child(2)"])
      for (const text of await texts(page, selector)) assert.match(text, HAN, `${selector}: ${text}`);
    await context.close();
  });

  // oracle: hand (Chinese is not written in words; the English word leads to the same place)
  test("the search finds Chinese words and English ones", async () => {
    const { context, page } = await start(chrome, { locale: "zh-CN" });
    for (const asked of ["孔", "hole", "61303"]) {
      await searchTasks(page, asked);
      await page.locator(`.hits[data-search="${asked}"] .hit`).first().waitFor();
    }
    await context.close();
  });

  // oracle: hand
  test("without a network the other language is there too", async () => {
    const { context, page } = await start(chrome, { serviceWorkers: "allow" });
    await page.evaluate(() => navigator.serviceWorker.ready.then(() => true));
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    await context.setOffline(true);
    await speak(page, "zh");
    assert.match(await page.locator("#form-title").textContent(), HAN);
    await context.close();
  });

  for (const locale of ["de-DE", "zh-CN"])
    for (const [width, height] of [
      [1280, 800],
      [768, 1024],
      [390, 844],
    ]) {
      // oracle: hand
      test(`nothing sticks out, ${locale}, ${width} × ${height}`, async () => {
        const { context, page } = await start(chrome, { locale, viewport: { width, height } });
        for (const panel of ["tasks", "form", "program", "view", "results"]) {
          const tab = page.locator(`.panel-bar [aria-controls="panel-${panel}"]`);
          if (await tab.isVisible()) await tab.click();
          assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, panel);
        }
        await context.close();
      });
    }
});
