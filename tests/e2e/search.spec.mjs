// Search over everything, and the list of what can be measured.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, open, shared } from "./browser.mjs";
import { openTasks, searchTasks, startWithCycles as start } from "./start.mjs";

async function search(page, text) {
  await searchTasks(page, text);
  await page.locator(`.hits[data-search="${text}"] .hit`).first().waitFor();
}

/** Code and title of what stands first of all. */
const best = page => page.locator(".hit").first();
const card = page => page.locator("dialog.card[open]");

describe("search", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual A:15848 (61303: the difference is beyond the safe area)
  test("the number of an alarm opens its card: meaning, cure, cycles", async () => {
    const { context, page, problems } = await start(chrome);
    await search(page, "61303");
    assert.equal(await best(page).locator("code mark").textContent(), "61303");
    await best(page).click();
    await card(page).waitFor();
    assert.match(await card(page).locator("h2").textContent(), /61303/);
    assert.match(await card(page).locator(".card-meaning").textContent(), /safe area/);
    assert.match(await card(page).textContent(), /_TSA/);
    const cycles = card(page).locator(".card-cycles button");
    assert.ok((await cycles.count()) > 1, "more than one cycle raises it");
    const cycle = await cycles.last().locator("code").textContent();
    await cycles.last().click();
    await card(page).waitFor({ state: "hidden" });
    await page.locator(`.tree-item.holds-choice:has-text("${cycle}")`).waitFor({ state: "attached" });
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:5943 (safety zone of CYCLE977), as typed with and without the mark of the name
  test("the name of a parameter leads to its field, in a variant that has it", async () => {
    const { context, page, problems } = await start(chrome);
    for (const typed of ["_SZA", "sza"]) {
      await search(page, typed);
      assert.equal(await best(page).getAttribute("data-kind"), "parameter");
      assert.equal(await best(page).locator("code").textContent(), "_SZA");
    }
    await counts(page.locator('.field[data-field="_SZA"]'), 0, "the first form has no protection zone");
    await best(page).click();
    await page.waitForFunction(() => document.activeElement?.closest(".field")?.dataset.field === "_SZA");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (words of the manuals for the same thing)
  test("words find measurements, the best first, whatever else is typed", async () => {
    const { context, page } = await start(chrome);
    await search(page, "bore");
    const measurements = page.locator('.hit[data-kind="measurement"]');
    assert.match(await measurements.first().textContent(), /CYCLE977.*Hole/, "of the control in use");
    await search(page, "Bohrung");
    assert.match(await measurements.first().textContent(), /CYCLE977.*Hole/, "by its German name");
    await search(page, "boss G110");
    assert.match(await measurements.first().textContent(), /G110/, "the other control by its names");
    await search(page, "gear web too wide");
    assert.equal(await best(page).getAttribute("data-kind"), "measurement");
    assert.match(await measurements.first().textContent(), /web/i);
    assert.ok((await page.locator("mark").count()) > 0, "what was found is marked");
    await measurements.first().click();
    await page.locator("#form-title").waitFor();
    await searchTasks(page, "");
    await page.locator('[role="treeitem"][aria-selected="true"]:has-text("Web")').waitFor();
    await context.close();
  });

  // oracle: hand
  test("a slip in a word is forgiven, a result has a card", async () => {
    const { context, page } = await start(chrome);
    await search(page, "calibrte");
    assert.match(await best(page).textContent(), /calibrat/i);
    await search(page, "_OVR[4]");
    assert.equal(await best(page).getAttribute("data-kind"), "result");
    await best(page).click();
    await card(page).waitFor();
    assert.ok((await card(page).locator(".card-cycles li").count()) > 0);
    await page.keyboard.press("Escape");
    await card(page).waitFor({ state: "hidden" });
    await best(page).click();
    await card(page).waitFor();
    await context.close();
  });

  // oracle: hand
  test("the keyboard alone is enough, and nothing found is said", async () => {
    const { context, page } = await start(chrome);
    await openTasks(page);
    await page.locator("#task-search").focus();
    await page.keyboard.type("61303");
    await page.locator(".hit").first().waitFor();
    await page.keyboard.press("ArrowDown");
    await page.waitForFunction(() => document.activeElement?.matches(".hit"));
    await page.keyboard.press("Enter");
    await card(page).waitFor();
    await page.keyboard.press("Escape");
    await card(page).waitFor({ state: "hidden" });
    await searchTasks(page, "qqqqqq");
    await page.locator('.found:has-text("Nothing found for “qqqqqq”")').waitFor();
    await counts(page.locator(".hit"), 0);
    await page.locator("#task-search").press("Escape");
    await page.locator('[role="treeitem"]').first().waitFor();
    await context.close();
  });

  // oracle: hand
  test("is no part of the first load", async () => {
    const { context, page } = await open(chrome.browser);
    const fetched = [];
    page.on("request", request => fetched.push(new URL(request.url()).pathname));
    await page.reload();
    await page.locator(".field").first().waitFor();
    await page.locator(".cm-content").waitFor();
    const before = fetched.filter(path => path.endsWith(".js")).length;
    await search(page, "61303");
    assert.ok(fetched.filter(path => path.endsWith(".js")).length > before, "the search comes when it is used");
    await context.close();
  });
});

describe("the list of what can be measured", () => {
  const chrome = shared("neither", { before, after });
  const items = (page, level) => page.locator(`[role="treeitem"][aria-level="${level}"]`);

  // oracle: hand
  test("is open around the choice only, and stays as it was set", async () => {
    const { context, page } = await start(chrome);
    await openTasks(page);
    assert.ok((await items(page, 1).count()) > 2, "groups by machine and purpose");
    await counts(page.locator('[aria-level="1"][aria-expanded="true"]'), 1);
    await counts(page.locator('[aria-level="2"][aria-expanded="true"]'), 1);
    const closed = page.locator('[aria-level="1"][aria-expanded="false"]').first();
    const name = await closed.locator(".tree-title").textContent();
    await closed.click();
    await page.locator('[aria-level="1"][aria-expanded="true"]').nth(1).waitFor();
    await page.waitForFunction(
      () => Object.keys(JSON.parse(localStorage.getItem("probewright-1") ?? "{}").unfolded ?? {}).length > 0,
    );
    await page.reload();
    await page.locator(`[aria-level="1"][aria-expanded="true"]:has-text("${name}")`).waitFor();
    await context.close();
  });

  // oracle: hand (the catalogue as the page holds it)
  test("holds every cycle once", async () => {
    const { context, page } = await start(chrome);
    await openTasks(page);
    const closed = page.locator('[aria-level="1"][aria-expanded="false"]');
    for (let left = await closed.count(); left > 0; left--) {
      await closed.first().click();
      await page.waitForFunction(
        wanted => document.querySelectorAll('[aria-level="1"][aria-expanded="false"]').length === wanted,
        left - 1,
      );
    }
    const codes = await items(page, 2).locator(".code").allTextContents();
    assert.ok(codes.length >= 6);
    assert.equal(new Set(codes).size, codes.length);
    await context.close();
  });
});
