// The start screen: from what is to be measured to a call, by mouse and by keyboard, and what else it leads to.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, open, packages, shared } from "./browser.mjs";
import { faults } from "./room.mjs";
import { drawn, focused, lengthField } from "./start.mjs";

const chrome = shared("neither", { before, after });

/** A first visit, once all variants are known. */
async function visit(options = {}) {
  const opened = await open(chrome.browser, { path: "", ...options });
  await opened.page.locator(".start .tile").first().waitFor();
  await opened.page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
  return opened;
}

const tile = (page, element) => page.locator(`.tile[data-element="${element}"]`);
const primary = page => page.locator(".start-answer button.primary");
const pressed = page => page.locator('.start-answer [aria-pressed="true"]').allTextContents();

/** Nothing of the page has to be scrolled to. */
const fits = page =>
  page.evaluate(
    () => document.documentElement.scrollHeight <= innerHeight && document.documentElement.scrollWidth <= innerWidth,
  );

describe("a first visit", () => {
  // oracle: hand (the way of a setter: six actions, three values; G54 is the first zero offset)
  test("leads from a bore and G54 to the copied call", async () => {
    const { context, page, problems } = await visit();
    await context.grantPermissions(["clipboard-read", "clipboard-write"]);
    assert.ok(await fits(page), "nothing to scroll at the start");
    let actions = 0;
    const act = async run => {
      actions++;
      await run;
    };
    await act(tile(page, "hole").click());
    await act(page.getByRole("button", { name: "Zero offset" }).click());
    assert.match(await page.locator(".start-code").textContent(), /· 101/);
    await act(primary(page).click());
    const field = page.locator(":focus");
    assert.equal(await field.getAttribute("aria-required"), "true", "the first value is asked for");
    await act(field.fill("50.02"));
    await act(page.getByRole("button", { name: "Copy call" }).click());
    const call = await page.evaluate(() => navigator.clipboard.readText());
    assert.match(call, /=101\b/);
    assert.match(call, /50\.02/);
    assert.ok(actions <= 6, `${actions} actions`);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (a first part lies off, and askew where its angle is measured: there is something to correct)
  test("shows a part whose angle is corrected", async () => {
    const { context, page } = await visit();
    await tile(page, "angle").click();
    await primary(page).click();
    await page.locator(".answer", { hasText: "C +0.120°" }).waitFor();
    await context.close();
  });

  // oracle: hand
  test("does so with the keyboard alone", async () => {
    const { context, page } = await visit();
    await tile(page, "hole").focus();
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.locator(":focus").getAttribute("data-element"), "shaft");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("Home");
    await focused(page, "[data-element=hole]");
    await page.keyboard.press("Enter");
    await focused(page, primary(page));
    await page.keyboard.press("Enter");
    await page.locator("#panel-form .field").first().waitFor();
    assert.equal(await page.locator(":focus").getAttribute("aria-required"), "true");
    await context.close();
  });

  // oracle: hand
  test("comes back by the browser's Back, and loses nothing", async () => {
    const { context, page } = await visit();
    await tile(page, "shaft").click();
    await primary(page).click();
    await page.locator(":focus").fill("31.25");
    await page.goBack();
    await tile(page, "shaft").waitFor();
    assert.equal(await page.locator("#panel-form .field").first().isVisible(), false);
    await page.goForward();
    await page.locator("#panel-form .field").first().waitFor();
    assert.equal(await lengthField(page).inputValue(), "31.25");
    await page.reload();
    await page.locator("#panel-form .field").first().waitFor();
    await page.locator(".to-start").click();
    await tile(page, "hole").waitFor();
    await context.close();
  });

  // oracle: hand (whoever has work kept sees it)
  test("is over once there is work", async () => {
    const { context, page } = await visit();
    await primary(page).click();
    await page.locator(":focus").fill("31.25");
    await drawn(page);
    const later = await context.newPage();
    await later.goto(new URL(page.url()).origin + new URL(page.url()).pathname);
    await later.locator("#panel-form .field").first().waitFor();
    await counts(later.locator(".tile"), 0);
    await context.close();
  });
});

describe("the elements", () => {
  // oracle: hand (a form that is open shows the title of what was chosen)
  for (const control of ["SINUMERIK", "NCT"])
    test(`each leads to a form, ${control}`, async () => {
      const { context, page } = await visit();
      await page.getByRole("button", { name: control, exact: true }).click();
      const elements = await page.locator(".tile").evaluateAll(all => all.map(one => one.dataset.element));
      assert.ok(elements.length >= 10, `${elements}`);
      for (const element of elements) {
        await tile(page, element).click();
        const code = (await page.locator(".start-code").textContent()).trim().split(" · ")[0];
        await primary(page).click();
        await page.locator("#panel-form .field").first().waitFor();
        assert.ok((await page.locator("#panel-form").textContent()).includes(code), `${element}: ${code}`);
        await page.locator(".to-start").click();
        await tile(page, element).waitFor();
      }
      await context.close();
    });

  // oracle: hand (another answer keeps the others as far as there is such a variant)
  test("follow their options", async () => {
    const { context, page } = await visit();
    await tile(page, "hole").click();
    await page.getByRole("button", { name: "Tool offset" }).click();
    const group = page.locator('.start-option [role="group"]').last();
    await group.getByRole("button").last().click();
    assert.match(await page.locator(".start-code").textContent(), /· 1001/);
    await page.getByRole("button", { name: "Zero offset" }).click();
    assert.match(await page.locator(".start-code").textContent(), /· 1101/, `${await pressed(page)}`);
    await context.close();
  });
});

describe("what is chosen", () => {
  // oracle: hand
  test("is what the pictogram shows, and stays in another language", async () => {
    const { context, page } = await visit();
    await tile(page, "corner").click();
    assert.ok((await pressed(page)).includes("Outside"), "an outer corner is drawn");
    await page.getByRole("button", { name: "Inside", exact: true }).click();
    await page.locator("#language").selectOption("de");
    await page.locator('.start h2:has-text("messen")').waitFor();
    assert.equal(await tile(page, "corner").getAttribute("aria-checked"), "true");
    assert.match(await page.locator(".start-code").textContent(), /· 105/);
    await context.close();
  });
});

describe("the start screen has room", () => {
  const SIZES = [
    [1280, 800],
    [1024, 768],
    [390, 844],
    [320, 640],
  ];
  // oracle: hand
  for (const locale of ["en-GB", "de-DE", "zh-CN"])
    test(`for everything that it says, ${locale}`, async () => {
      const { context, page } = await visit({ locale });
      for (const [width, height] of SIZES) {
        await page.setViewportSize({ width, height });
        for (const element of ["hole", "tool", "probe"]) {
          await tile(page, element).click();
          await drawn(page);
          assert.deepEqual(await faults(page), [], `${width} ${element}`);
        }
      }
      await context.close();
    });

  // oracle: axe-core
  test("and can be used by everybody", async () => {
    for (const colorScheme of ["light", "dark"]) {
      const { context, page } = await visit({ colorScheme, bypassCSP: true });
      await page.addScriptTag({ path: packages.resolve("axe-core/axe.min.js") });
      const found = await page.evaluate(async () => {
        const { violations } = await globalThis.axe.run();
        return violations.map(one => `${one.id}: ${one.nodes.map(node => node.target.join(" ")).join(", ")}`);
      });
      assert.deepEqual(found, [], colorScheme);
      await context.close();
    }
  });
});

describe("what was worked on lately", () => {
  // oracle: hand
  test("stands at the start: a program and a form that was left, to be opened again or removed", async () => {
    const { context, page } = await visit();
    await tile(page, "shaft").click();
    await primary(page).click();
    await page.locator(":focus").fill("31.25");
    await drawn(page);
    await page.locator(".to-start").click();
    const items = page.locator(".start-recent li");
    await items.first().waitFor();
    assert.match(await items.first().textContent(), /Shaft/);
    const text = "; FLANGE\n_MVAR=1 _SETVAL=30\nCYCLE977\nM30\n";
    await page
      .locator("#panel-program input[type=file]")
      .first()
      .setInputFiles({ name: "FLANGE.MPF", mimeType: "text/plain", buffer: Buffer.from(text) });
    await page.locator('.cm-line:has-text("; FLANGE")').waitFor();
    await page.locator(".to-start").click();
    await page.locator('.start-recent li:has-text("FLANGE.MPF")').waitFor();
    await page.locator('.start-recent li:has-text("Shaft") button').first().click();
    await page.locator("#panel-form .field").first().waitFor();
    assert.equal(await lengthField(page).inputValue(), "31.25");
    await page.locator(".to-start").click();
    const program = page.locator('.start-recent li:has-text("FLANGE.MPF")');
    assert.match(await program.textContent(), /Calls: 1, lines: 4/);
    await program.locator("button").last().click();
    await program.waitFor({ state: "detached" });
    await context.close();
  });
});
