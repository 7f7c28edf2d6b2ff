// The sheet of keys: it can be reached by key and by button, and every line of it is true.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { faults } from "./room.mjs";
import { modules } from "./sources.mjs";
import { drawn, lengthField, openPageMenu, openTasks, startWithEditor as start, start as startForm } from "./start.mjs";

const sheet = page => page.locator("dialog.keys[open]");

describe("the sheet of keys", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("opens with ? where nothing is typed, and from the menu", async () => {
    const { context, page, problems } = await start(chrome);
    await openTasks(page);
    await page.locator("#task-search").focus();
    await page.keyboard.press("?");
    assert.equal(await page.locator("#task-search").inputValue(), "?");
    await page.keyboard.press("Escape");
    await page.locator(".cm-content").focus();
    await page.keyboard.press("?");
    await page.locator('.cm-line:has-text("?")').waitFor();
    await counts(sheet(page), 0);
    await page.locator("#theme").focus();
    await page.keyboard.press("?");
    await sheet(page).waitFor();
    await page.keyboard.press("Escape");
    await sheet(page).waitFor({ state: "detached" });
    await page.getByRole("button", { name: "Keys" }).click();
    await sheet(page).getByRole("button", { name: "Close" }).click();
    await sheet(page).waitFor({ state: "detached" });
    await page.setViewportSize({ width: 390, height: 844 });
    await openPageMenu(page);
    await page.getByRole("button", { name: "Keys" }).click();
    await sheet(page).waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: self (the table from which the listeners are made)
  test("has a line for every key of the table, in every language", async () => {
    const sources = await modules();
    const { KEYS } = await sources.load("/src/keys.ts");
    await sources.close();
    const count = Object.values(KEYS).flatMap(commands => Object.keys(commands)).length;
    for (const locale of ["en-GB", "de-DE", "zh-CN"]) {
      for (const viewport of [
        { width: 1280, height: 800 },
        { width: 768, height: 1024 },
        { width: 390, height: 844 },
      ]) {
        const { context, page } = await startForm(chrome, { locale, viewport });
        await drawn(page);
        await page.evaluate(() => document.body.focus());
        await page.keyboard.press("?");
        await sheet(page).waitFor();
        await drawn(page);
        const lines = await sheet(page).locator("dd").allTextContents();
        assert.equal(lines.length, count);
        assert.deepEqual(
          lines.filter(line => !line || line.includes("keys-")),
          [],
        );
        assert.equal(await sheet(page).evaluate(node => node.scrollTop), 0, "it begins at its begin");
        const cut = await sheet(page).evaluate(node =>
          [...node.querySelectorAll("dt")]
            .filter(one =>
              [...one.children].some(
                key => key.getBoundingClientRect().right > one.nextElementSibling.getBoundingClientRect().left,
              ),
            )
            .map(one => one.textContent),
        );
        assert.deepEqual(cut, [], `${locale} ${viewport.width}`);
        const keys = await sheet(page).locator("kbd").allTextContents();
        assert.ok(keys.includes(locale === "de-DE" ? "Strg" : "Ctrl"), `${keys}`);
        assert.deepEqual(
          (await faults(page)).filter(one => one.includes("key")),
          [],
          `${locale} ${viewport.width}`,
        );
        if (process.env.PROBEWRIGHT_SHOTS)
          await page.screenshot({ path: `${process.env.PROBEWRIGHT_SHOTS}/keys-${locale}-${viewport.width}.png` });
        await context.close();
      }
    }
  });

  // oracle: hand
  test("and tooltips name the command key where the keyboard has one", async () => {
    const { context, page } = await start(chrome);
    await page.addInitScript(() => Object.defineProperty(navigator, "platform", { get: () => "MacIntel" }));
    await page.reload();
    const search = page.locator("#search-open");
    await search.hover();
    assert.match(await search.getAttribute("title"), /\(⌘\+K\)$/);
    assert.equal(await search.getAttribute("aria-keyshortcuts"), "Meta+K");
    await lengthField(page).fill("41");
    await page.locator('.snippet:has-text("41")').waitFor();
    await page.locator("#undo").hover();
    assert.match(await page.locator("#undo").getAttribute("title"), /\(⌘\+Z\)$/);
    await context.close();
  });

  // oracle: hand
  test("is right about the editor: search, next problem, all problems", async () => {
    const { context, page } = await start(chrome);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+f");
    await page.locator(".cm-search").waitFor();
    await page.keyboard.press("Escape");
    await page.keyboard.press("Control+Shift+M");
    await page.locator(".cm-panel-lint").waitFor();
    await context.close();
  });
});
