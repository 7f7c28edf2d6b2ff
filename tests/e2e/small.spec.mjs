// The page where there is little room: phones, tablets, and a window that is enlarged to 200 and 400 % (1280 × 800 is
// then 640 × 400 and 320 × 200 CSS pixels). Everything can be reached, nothing is cut, nothing scrolls in two
// directions (WCAG 1.4.10).
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { choosePanel, faults, PANELS, unreachable } from "./room.mjs";
import { drawn, focused, lengthField, openPageMenu, openTasks, start } from "./start.mjs";

const SIZES = [
  [320, 640],
  [360, 640],
  [390, 844],
  [768, 1024],
  [1024, 768],
  [1280, 800],
  [1366, 500],
  [1024, 420],
  [640, 400],
  [320, 200],
];

describe("little room", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand (the answer is always in sight)
  for (const [width, height] of [
    [360, 640],
    [390, 844],
  ])
    test(`what a call came to is in sight beside the 3D view of a phone, ${width} × ${height}`, async () => {
      const { context, page } = await start(chrome, { viewport: { width, height } });
      await choosePanel(page, "view");
      await page.locator(".stage svg").first().waitFor();
      const answer = page.locator(".answer-part b").first();
      await answer.waitFor();
      for (const place of [0, 120]) {
        await page.evaluate(top => scrollTo({ top }), place);
        await drawn(page);
        const { y, height: high } = await answer.boundingBox();
        const tabs = await page.locator(".panel-bar").boundingBox();
        assert.ok(y > 0 && y + high <= tabs.y, `${y} to ${y + high}, tabs from ${tabs.y}`);
      }
      await context.close();
    });

  // What stands in a panel is whole and can be reached.
  const panels = async page => {
    for (const name of PANELS) {
      await choosePanel(page, name);
      assert.deepEqual(await faults(page), [], name);
      assert.deepEqual(await unreachable(page.locator(`#panel-${name} :is(button, select)`)), [], name);
    }
  };

  // The value that is typed stays in sight, whatever its call becomes below it.
  const typing = async page => {
    await choosePanel(page, "form");
    const field = lengthField(page);
    await field.focus();
    await page.keyboard.press("Control+a");
    await page.keyboard.type("31.25");
    await page.locator('.snippet:has-text("31.25")').waitFor({ state: "attached" });
    await drawn(page);
    const place = await field.evaluate(node => {
      const { left, top, right, bottom } = node.getBoundingClientRect();
      return {
        inside: left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight,
        seen: document.elementFromPoint((left + right) / 2, (top + bottom) / 2) === node,
      };
    });
    assert.deepEqual(place, { inside: true, seen: true });
  };

  // The page's own actions, and a dialog of theirs.
  const actions = async (page, phone) => {
    await openPageMenu(page);
    const all = page.locator("#page-actions, .top-actions").locator(":is(button, select, a):visible");
    await counts(all, phone ? 14 : 11);
    assert.deepEqual(await unreachable(all), []);
    await page.locator("#page-actions button").last().click();
    const dialog = page.locator("dialog[open]");
    await dialog.waitFor();
    assert.deepEqual(await faults(page), []);
    assert.deepEqual(await unreachable(dialog.locator("button").last()), []);
  };

  for (const locale of ["en-GB", "de-DE", "zh-CN"]) {
    for (const [width, height] of SIZES) {
      // oracle: hand (WCAG 1.4.10)
      test(`all is there, and a value is typed and seen, ${width} × ${height}, ${locale}`, async () => {
        const { context, page, problems } = await start(chrome, {
          viewport: { width, height },
          locale,
          hasTouch: width < 800,
        });
        await page.locator(".results tbody tr").first().waitFor({ state: "attached" });
        await typing(page);
        await panels(page);
        await actions(page, width < 768 && height >= 400); // tasks, help, machine and practice have no tab there
        assert.deepEqual(problems, []);
        await context.close();
      });
    }
  }

  for (const [width, height] of [
    [320, 200],
    [390, 844],
  ]) {
    // oracle: hand
    test(`the data of the machine can be changed, ${width} × ${height}`, async () => {
      const { context, page } = await start(chrome, { viewport: { width, height } });
      await page
        .locator("#page-actions button:not([disabled])", { hasText: /^Machine data$/ })
        .waitFor({ state: "attached" });
      await openPageMenu(page);
      await page.locator("#page-actions button", { hasText: /^Machine data$/ }).click();
      const dialog = page.locator("dialog[open]");
      await dialog.locator("summary").nth(1).click();
      const entry = dialog.locator(".datum input:visible, .datum select:visible").first();
      await entry.waitFor();
      assert.deepEqual(await unreachable(entry), []);
      assert.deepEqual(await faults(page), []);
      assert.deepEqual(await unreachable(dialog.locator(".actions button")), []);
      await context.close();
    });
  }

  // oracle: hand
  test("the menu closes with Escape, with a click elsewhere, and when something is chosen", async () => {
    const { context, page } = await start(chrome, { viewport: { width: 390, height: 844 } });
    const menu = page.locator(".rail-more");
    const list = page.locator("#page-actions");
    const opens = async () => {
      await menu.click();
      await list.waitFor();
    };
    await opens();
    await page.keyboard.press("Escape");
    await list.waitFor({ state: "hidden" });
    await focused(page, ".rail-more");
    await opens();
    await page.locator(".panel-form h2").click();
    await list.waitFor({ state: "hidden" });
    await opens();
    await list.getByRole("button", { name: "About" }).click();
    await page.locator("dialog[open]").waitFor();
    assert.ok(await list.isHidden());
    await context.close();
  });

  // oracle: hand (one of each list is chosen)
  test("forced colours mark what is chosen and nothing else", async () => {
    const { context, page } = await start(chrome, { forcedColors: "active" });
    await openTasks(page);
    await page.locator(".call-row").waitFor();
    const marked = await page.evaluate(() => {
      const colourOf = name => {
        const node = document.body.appendChild(document.createElement("i"));
        node.style.cssText = `forced-color-adjust: none; color: ${name}`;
        const { color } = getComputedStyle(node);
        node.remove();
        return color;
      };
      const canvas = colourOf("Canvas");
      const count = (selector, side) =>
        [...document.querySelectorAll(selector)]
          .filter(node => node.checkVisibility() && getComputedStyle(node)[side] !== canvas)
          .map(node => node.getAttribute("aria-selected") ?? "no choice");
      return {
        tasks: count(".level-3", "borderLeftColor"),
        calls: count(".call-row", "borderLeftColor"),
        tabs: count(".tabs [role=tab]", "borderBottomColor"),
        fields: count(".field:not(.wrong, .doubtful)", "borderLeftColor"),
      };
    });
    assert.deepEqual(marked, { tasks: ["true"], calls: ["true"], tabs: ["true"], fields: [] });
    await context.close();
  });
});
