// The help page of the variant in the form: opened beside it, by mouse and keys, in the language of the page.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { packages, shared } from "./browser.mjs";
import { focused, startWithCycles as start } from "./start.mjs";

const panel = page => page.locator("#panel-help");
const headings = page => panel(page).locator(".help-page h3").allTextContents();
const first = page => panel(page).locator(".help-page li").first().textContent();

async function openHelp(page) {
  await page.locator(".help-open").focus();
  await page.keyboard.press("Enter");
  await panel(page).locator(".help-page h3").first().waitFor();
}

describe("help", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand: five sections, and between them the values to be given; its words are not fetched before
  test("opens beside the form by keys and goes the way it came", async () => {
    const fetched = [];
    const { context, page, problems } = await start(chrome);
    page.on("request", request => {
      if (/\/help-en-/.test(request.url())) fetched.push(request.url());
    });
    assert.ok(await panel(page).isHidden());
    await openHelp(page);
    assert.equal(fetched.length, 1);
    assert.deepEqual((await headings(page)).slice(0, 6), [
      "What it measures",
      "Start position of the probe",
      "Inputs",
      "Sequence",
      "What it corrects",
      "What can go wrong",
    ]);
    // oracle: manual B:12145-12406
    await panel(page).getByText("Where is this on my control?").click();
    await panel(page).getByText("Measurem. milling > Workpiece measure > Hole Shaft").waitFor();
    await page.locator("#panel-help").focus();
    await page.locator(".panel-form .field").first().waitFor();
    await focused(page, "#panel-help");
    await page.keyboard.press("Escape");
    await panel(page).waitFor({ state: "hidden" });
    await focused(page, ".help-open");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:5645-5646 (variants 1 and 2 of CYCLE977), B:5989-6024 (a shaft needs _ID)
  test("follows the variant of the form, and its values lead to their fields", async () => {
    const { context, page, problems } = await start(chrome);
    await openHelp(page);
    assert.match(await first(page), /hole/);
    await page.locator("#field-_MVAR").fill("2");
    await panel(page).locator('.help-page li:has-text("shaft")').first().waitFor();
    await panel(page).getByRole("button", { name: "_ID" }).click();
    await page.waitForFunction(() => document.activeElement?.closest(".field")?.dataset.field === "_ID");
    await panel(page).waitFor(); // it stays open while the form is filled in
    await page.locator("#field-_MVAR").fill("7");
    await panel(page).locator(".empty:visible").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual A:15844 (61303: the difference is beyond the safe area)
  test("each alarm that can come unfolds with its cure", async () => {
    const { context, page } = await start(chrome);
    await openHelp(page);
    const alarm = panel(page).locator('details:has(code:text-is("61303"))');
    await alarm.locator("summary").click();
    assert.match(await alarm.locator("p").last().textContent(), /_TSA/);
    await context.close();
  });

  // oracle: hand
  test("speaks the language of the page", async () => {
    const { context, page, problems } = await start(chrome);
    await openHelp(page);
    await page.locator(".top select:has(option[value=zh])").selectOption("zh");
    await panel(page).getByRole("heading", { name: "测量内容" }).waitFor();
    assert.match(await first(page), /孔/);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: WCAG 2.2 AA as axe-core checks it
  for (const [width, height] of [
    [1280, 800],
    [1024, 768],
    [834, 1112],
  ])
    for (const colorScheme of ["light", "dark"])
      test(`is readable, ${width} × ${height}, ${colorScheme}`, async () => {
        const { context, page } = await start(chrome, { viewport: { width, height }, colorScheme, bypassCSP: true });
        await openHelp(page);
        await page.addScriptTag({ path: packages.resolve("axe-core/axe.min.js") });
        const { violations } = await page.evaluate(() => globalThis.axe.run("#panel-help"));
        assert.deepEqual(
          violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`),
          [],
        );
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
        await context.close();
      });
});
