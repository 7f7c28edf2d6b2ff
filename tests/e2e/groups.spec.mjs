// The sections of a form: open where something must be filled in, else one line that says what differs.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { drawn, focused, keptWhen, start } from "./start.mjs";

const folded = page => page.locator('.group-head[aria-expanded="false"]');
const open = page => page.locator('.group-head[aria-expanded="true"]');

describe("sections of a form", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("stand open where something must be filled in, and hide nothing that is wrong", async () => {
    const { context, page, problems } = await start(chrome, { folded: true });
    assert.ok((await folded(page).count()) > 0);
    await counts(page.locator('.group-fields[hidden] [aria-required="true"]'), 0);
    // each field belongs to one section, and each folded section has its line
    const all = await page.locator(".field").count();
    await counts(page.locator(".group .field"), all);
    for (const line of await folded(page).locator(".group-sum").allTextContents()) assert.match(line, /\S/);
    for (const line of await open(page).locator(".group-sum").allTextContents()) assert.equal(line, "");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("are opened by hand, by the keyboard, and stay so for the next cycle and the next day", async () => {
    const { context, page } = await start(chrome, { folded: true });
    const head = folded(page).first();
    const topic = await head.evaluate(node => node.closest(".group").dataset.topic);
    const it = page.locator(`.group[data-topic="${topic}"]`);
    await head.focus();
    await page.keyboard.press("Enter");
    await it.locator(".field").first().waitFor();
    await page.keyboard.press("Tab");
    await focused(page, it.locator(".group-fields :focus"));
    await keptWhen(page, state => state.unfolded?.[`form/${topic}`] === true);
    await page.reload();
    await it.locator(".field").first().waitFor();
    await it.locator(".group-head").click();
    await it.locator(".field").first().waitFor({ state: "hidden" });
    await context.close();
  });

  // oracle: hand
  test("open all at once, and the line names what was changed", async () => {
    const { context, page } = await start(chrome, { folded: true });
    await page.locator(".fields-all").click();
    await drawn(page);
    await counts(folded(page), 0);
    const last = page.locator(".group").last();
    const input = last.locator(".field .entry-line > .figure").first();
    const label = await last.locator(".field-label").first().textContent();
    await input.fill("7");
    await last.locator(".group-head").click();
    await page.locator(`.group-sum:has-text("${label}")`).waitFor();
    await context.close();
  });
});
