// The focus of the keyboard behind what it opened, went off or went away: it is never on nothing.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { shared } from "./browser.mjs";
import { focused, startWithEditor } from "./start.mjs";

const chrome = shared("neither", { before, after });

/** Opens the menu of the page and chooses an entry, by keyboard alone. */
async function choose(page, name) {
  await page.locator("#page-actions-open").press("Enter");
  await page.locator("#page-actions").getByRole("button", { name, exact: true }).press("Enter");
}

describe("the focus comes back", () => {
  // oracle: hand
  test("to the menu whose entry opened a dialog", async () => {
    const { context, page, problems } = await startWithEditor(chrome);
    for (const [entry, dialog] of [
      ["About", "dialog.about"],
      ["Machine data", "dialog.machine-data"],
      ["Scenarios", "dialog[open]"],
    ]) {
      await choose(page, entry);
      await page.locator(`${dialog}:visible`).waitFor();
      await page.keyboard.press("Escape");
      await focused(page, "#page-actions-open");
    }
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("to the way out of a dialog when its button goes off", async () => {
    const { context, page, problems } = await startWithEditor(chrome);
    await choose(page, "Machine data");
    const data = page.locator("dialog.machine-data");
    await data.getByRole("searchbox").fill("_WP[1,0]");
    await data.locator(".datum input").first().fill("5.9");
    await page.keyboard.press("Tab");
    const reset = data.getByRole("button", { name: "Reset to defaults" });
    await reset.press("Enter");
    await focused(page, data.getByRole("button", { name: "Done", exact: true }));
    assert.equal(await reset.isDisabled(), true);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
