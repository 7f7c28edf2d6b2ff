// Who reaches the page, and when: keyboard alone, both themes, small screens, no network, a core that breaks.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, packages, shared } from "./browser.mjs";
import { drawn, fromFormMenu, keptWhen, lengthField, start } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");

describe("reach", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("the keyboard alone is enough", async () => {
    const { context, page } = await start(chrome);
    const press = async (...keys) => {
      for (const key of keys) await page.keyboard.press(key);
    };
    const inside = () => page.evaluate(() => document.activeElement?.closest("[data-panel]")?.dataset.panel ?? "");
    await press("Tab", "Enter");
    await page.waitForFunction(() => document.activeElement?.id === "panel-tasks");
    await press("Tab");
    await page.keyboard.type("x");
    await press("Escape", "ArrowDown");
    await page.waitForFunction(() => document.activeElement?.getAttribute("role") === "treeitem");
    await press("ArrowDown", "Enter");
    // the variant under the focus is chosen, and its form takes the place of the list
    await page.waitForFunction(() => document.activeElement?.id === "panel-form");
    await counts(page.locator('[role="treeitem"][aria-selected="true"]'), 1);
    assert.ok(await page.locator(".tree").isHidden());
    for (
      let tries = 0;
      tries < 30 && !(await page.evaluate(() => document.activeElement?.matches(".field input")));
      tries++
    )
      await press("Tab");
    assert.equal(await inside(), "form");
    for (const panel of ["view", "program", "results", "form"]) {
      await press("F6");
      await page.waitForFunction(name => document.activeElement?.id === `panel-${name}`, panel);
    }
    await press("Shift+F6");
    await page.waitForFunction(() => document.activeElement?.id === "panel-results");
    await press("Tab", "ArrowRight");
    await page.locator('[role="tab"][aria-selected="true"]#tab-problems').waitFor();
    await context.close();
  });

  for (const colorScheme of ["light", "dark"]) {
    for (const viewport of [
      { width: 1280, height: 800 },
      { width: 768, height: 1024 },
    ]) {
      // oracle: axe-core
      test(`axe finds nothing serious, ${colorScheme}, ${viewport.width} wide`, async () => {
        const { context, page } = await start(chrome, { colorScheme, viewport, bypassCSP: true });
        await fromFormMenu(page, "Check");
        await drawn(page);
        await page.addScriptTag({ path: axe });
        const found = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
        const serious = found.violations.filter(one => ["serious", "critical"].includes(one.impact));
        assert.deepEqual(
          serious.map(one => `${one.id}: ${one.nodes.map(node => node.html.slice(0, 120)).join(" | ")}`),
          [],
        );
        await context.close();
      });
    }
  }

  for (const [width, height] of [
    [1280, 800],
    [1024, 768],
    [768, 1024],
  ]) {
    // oracle: hand
    test(`nothing sticks out and every target is big enough, ${width} × ${height}`, async () => {
      const { context, page } = await start(chrome, { viewport: { width, height } });
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.equal(wide, width);
      for (const name of ["Tasks", "Form", "Program", "3D view", "Result"]) {
        const tab = page.locator(".panel-bar").getByRole("button", { name, exact: true });
        if (await tab.isVisible()) await tab.click();
        await drawn(page);
        const small = await page.evaluate(() =>
          [
            ...document.querySelectorAll(
              "button, select, input:not([type=checkbox]):not([type=range]), [role=treeitem]",
            ),
          ]
            .filter(node => node.checkVisibility() && !node.closest(".skip, .gloss")) // a word in its line
            .map(node => ({ box: node.getBoundingClientRect(), html: node.outerHTML.slice(0, 80) }))
            .filter(({ box }) => box.width < 24 || box.height < 24)
            .map(({ html }) => html),
        );
        assert.deepEqual(small, []);
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
      }
      await context.close();
    });
  }

  // oracle: hand
  test("without a network the page opens again, with the work in it", async () => {
    const { context, page } = await start(chrome, { serviceWorkers: "allow" });
    await lengthField(page).fill("26.5");
    await keptWhen(page, state => Object.values(state.values ?? {}).includes("26.5"));
    await page.evaluate(() => navigator.serviceWorker.ready.then(() => true));
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    await context.setOffline(true);
    await page.reload();
    await page.locator(".field").first().waitFor();
    await page.locator(".cm-content").waitFor();
    assert.equal(await lengthField(page).inputValue(), "26.5");
    await context.close();
  });

  // oracle: hand
  test("when the core breaks, the page says so and keeps the work", async () => {
    const { context, page } = await start(chrome);
    await lengthField(page).fill("25.5");
    await page.evaluate(() => dispatchEvent(new CustomEvent("probewright-panic", { detail: "panicked at test" })));
    await page.locator("#broken").waitFor();
    assert.match(await page.locator("#broken").textContent(), /panicked at test/);
    await page.locator("#broken button").click();
    await page.locator("#broken").waitFor({ state: "detached" });
    await page.locator(".field").first().waitFor();
    assert.equal(await lengthField(page).inputValue(), "25.5");
    await counts(page.locator("#broken"), 0);
    await context.close();
  });

  // oracle: hand
  test("the theme can be chosen and stays", async () => {
    const { context, page } = await start(chrome, { colorScheme: "light" });
    const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const light = await ground();
    await page.locator("#theme").click();
    await page.locator("#theme").click();
    await page.waitForFunction(() => document.documentElement.dataset.theme === "dark");
    assert.notEqual(await ground(), light);
    await keptWhen(page, state => state.theme === "dark");
    await page.reload();
    await page.waitForFunction(() => document.documentElement.dataset.theme === "dark");
    await context.close();
  });
});
