// Concepts and terms of the manuals, and commissioning as a list of steps.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, packages, shared } from "./browser.mjs";
import { find, keptWhen, startWithEditor as start } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");

async function command(page, name) {
  await find(page, name);
  await page.getByRole("option", { name }).first().waitFor();
  await page.keyboard.press("Enter");
}

async function accessible(page, root) {
  await page.addScriptTag({ path: axe });
  const wrong = await page.evaluate(where => window.axe.run(where).then(({ violations }) => violations), root);
  assert.deepEqual(
    wrong.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`),
    [],
  );
}

describe("concepts, terms and commissioning", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("a term is found by a word, and a field leads to its concept", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await command(page, "Concepts and terms");
    const dialog = page.getByRole("dialog", { name: "Concepts and terms" });
    await dialog.getByText("Trigger point", { exact: true }).first().waitFor();
    await dialog.getByRole("searchbox").fill("additive offset _DLNUM");
    await dialog.getByText("Additive offset (DL)", { exact: true }).waitFor();
    assert.ok((await dialog.locator(".term:visible").count()) < 6);
    await dialog.getByRole("searchbox").fill("nobody says this");
    await dialog.getByText("No guide, concept or term has these words.").waitFor();
    await accessible(page, "dialog[open]");
    await page.keyboard.press("Escape");
    await page.keyboard.press("Escape");
    await counts(page.locator("dialog[open]"), 0);
    await page.locator(".fields input[id$='_FA']").first().focus();
    await page.getByRole("button", { name: "Concept", exact: true }).click();
    await page.locator("details.term-page[open]").getByText(/_FA/).first().waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("a step that is done is done when the page comes back", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await command(page, "Commissioning and upgrade");
    const way = page.locator("#steps-path");
    await way.selectOption("adv-new");
    await page.getByText("0 of 13 done").waitFor();
    await page.locator(".commission-steps input").nth(1).check();
    await page.getByText("1 of 13 done").waitFor();
    await accessible(page, "dialog[open]");
    await way.selectOption({ label: "Connections of probes" });
    await page.getByText("X121.1", { exact: false }).first().waitFor();
    await page.keyboard.press("Escape");
    await keptWhen(page, kept => Object.values(kept.steps ?? {}).includes(true));
    await page.reload();
    await page.locator(".fields").first().waitFor();
    await command(page, "Commissioning and upgrade");
    await page.locator("#steps-path").selectOption("adv-new");
    await page.getByText("1 of 13 done").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});
