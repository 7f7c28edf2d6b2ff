// What is set once per machine: found, changed, refused, kept, and used by the forms of the cycles.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, open, packages, shared } from "./browser.mjs";
import { openPageMenu, unfold } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");

const PROGRAM =
  "G17 G54 G40 D1\nT1 D1\nM5\n" +
  "_MVAR=1 _SETVAL=132 _TUL=0.03 _TLL=-0.03 _TNUM=20 _KNUM=2001 _TSA=1 _PRNUM=1 _VMS=200 _FA=2\nCYCLE977\n";

/** The dialog, opened from the header; where that is narrow, from its menu. */
async function dialog(page) {
  await openPageMenu(page);
  const button = page.getByRole("button", { name: "Machine data", exact: true });
  await page.locator("#page-actions button:not([disabled])", { hasText: /^Machine data$/ }).waitFor();
  await button.click();
  return page.getByRole("dialog", { name: "Machine data" });
}

describe("machine data", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("a datum is found by words, changed, kept and taken back", async () => {
    const { context, page, problems } = await open(chrome.browser);
    const shown = await dialog(page);
    await shown.getByRole("searchbox").fill("ball diameter");
    const row = shown.locator(".datum", { hasText: "_WP[1,0]" });
    assert.ok((await shown.locator(".datum").count()) < 10, "the search narrows");
    const entry = row.locator("input");
    await entry.focus();
    assert.match(
      await shown.locator(".datum-cited").textContent(),
      /_WP\[1,0\].*Ball diameter.*Measuring Cycles 04\/2006, 9\.2\.3/i,
    );
    await entry.fill("5,995");
    await entry.press("Tab");
    await shown.locator(".datum.changed").waitFor();
    await page.keyboard.press("Escape");
    await page.waitForTimeout(500); // kept after a pause
    await page.reload();
    const again = await dialog(page);
    await again.getByRole("checkbox").check();
    assert.deepEqual(await again.locator(".datum code").allTextContents(), ["_WP[1,0]"]);
    assert.equal(await again.locator(".datum input").inputValue(), "5.995");
    await again.getByRole("button", { name: "Reset to defaults" }).click();
    await again.locator(".empty").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (core/tests/idle.rs holds the list against the code)
  test("a datum that the simulation does not read says so", async () => {
    const { context, page } = await open(chrome.browser);
    const shown = await dialog(page);
    for (const [words, count] of [
      ["_CBIT[7]", 1],
      ["_CBIT[0]", 0],
    ]) {
      await shown.getByRole("searchbox").fill(words);
      await shown.locator(".datum").first().waitFor();
      await counts(shown.getByText("No effect in the simulation."), count, words);
    }
    await context.close();
  });

  // oracle: manual B:13726 (1 to 100 %)
  test("what cannot be is told at its place, with the cure", async () => {
    const { context, page } = await open(chrome.browser);
    const shown = await dialog(page);
    await shown.getByRole("searchbox").fill("_SPEED[0]");
    const entry = shown.locator(".datum input");
    await entry.fill("120");
    await entry.press("Tab");
    const told = shown.locator(".datum-problem:visible");
    await told.waitFor();
    assert.match(await told.textContent(), /100/);
    assert.equal(await entry.getAttribute("aria-invalid"), "true");
    await context.close();
  });

  // oracle: hand (the longest choice of each datum beside the room of its field, and of each unit the digits before it)
  test("no choice is cut, and no unit covers a number", async () => {
    const { context, page } = await open(chrome.browser);
    const shown = await dialog(page);
    await shown.locator("summary").evaluateAll(all => {
      for (const one of all) one.click();
    });
    await shown.locator(".datum select").first().waitFor();
    const cut = await shown.evaluate(node => {
      const pen = document.createElement("canvas").getContext("2d");
      const ARROW = 28; // px, with the inner margin
      const long = select => {
        pen.font = getComputedStyle(select).font;
        const longest = Math.max(...[...select.options].map(({ text }) => pen.measureText(text).width));
        return longest + ARROW > select.clientWidth;
      };
      const covers = unit => {
        const room = Number.parseFloat(getComputedStyle(unit.previousElementSibling).paddingInlineEnd);
        return unit.textContent !== "" && unit.scrollWidth > room;
      };
      const name = one => one.closest(".datum").querySelector("code").textContent;
      const of = (what, wrong) => [...node.querySelectorAll(what)].filter(wrong).map(name);
      return [...of(".datum select", long), ...of(".datum .entry-line > .unit", covers)];
    });
    assert.deepEqual(cut, []);
    await context.close();
  });

  // oracle: manual B:12501-12506, B:12518-12532, B:12549-12553
  test("forms are those of the control where chosen: the mask decides them, its change is told", async () => {
    const { context, page, problems } = await open(chrome.browser);
    await unfold(page);
    const field = name => page.locator(`.field[data-field="${name}"]`);
    const snippet = page.locator(".snippet");
    const set = async (name, value) => {
      const shown = await dialog(page);
      await shown.getByRole("searchbox").fill(name);
      await shown.locator(".datum select").selectOption(value);
      await shown.getByRole("button", { name: "Done" }).click();
    };
    const problem = text => page.locator(".problem", { hasText: text }).first();
    await page
      .locator(".panel-program input[type=file]")
      .setInputFiles({ name: "part.mpf", mimeType: "text/plain", buffer: Buffer.from(PROGRAM) });
    await page.locator(".call-row").first().click();
    await field("_VMS").waitFor();
    await set("_MZ_MASK[1]", "1");
    await field("_VMS").waitFor(); // nothing changes for who did not choose it
    await set("PW-FORMS", "1");
    await field("_VMS").waitFor({ state: "detached" });
    await field("_EVNUM").waitFor({ state: "detached" });
    assert.match(await snippet.textContent(), /^; _MZ_MASK=1,1,0,0,0,0,0,0 MD18102=0 MD18080=256$/m);
    assert.match(await snippet.textContent(), /_VMS=0 _NMSP=1/);
    assert.match(await snippet.textContent(), /_CHBIT\[4\]=0 _TMV=\S+ _K=1 _EVNUM=0/);
    await page.locator("#tab-problems").click();
    await problem("_VMS=200 → 0").waitFor();
    await problem("_VMS=200 → 0").locator(".cure").click();
    await problem("_VMS=200 → 0").waitFor({ state: "detached" });
    await page.getByRole("button", { name: "Detach" }).click();
    await page.getByRole("button", { name: "Insert at cursor" }).click();
    await page.locator(".call-row").nth(1).waitFor();
    await set("_MZ_MASK[4]", "1");
    await field("_EVNUM").waitFor();
    assert.match(await snippet.textContent(), /_CHBIT\[4\]=1/);
    await problem("_MZ_MASK[4]: 0 → 1").waitFor();
    await problem("_CHBIT[4]=0 → 1").waitFor();
    await set("_MZ_MASK[0]", "0");
    await page.locator('.snippet[data-style="indirect"]').waitFor();
    assert.match(await snippet.textContent(), /CYCLE_PARA\(/);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (what is chosen can be read)
  test("each choice is as wide as what is chosen", async () => {
    for (const viewport of [
      { width: 1280, height: 800 },
      { width: 390, height: 844 },
    ]) {
      const { context, page } = await open(chrome.browser, { viewport });
      const shown = await dialog(page);
      await shown.locator('input[type="search"]').fill("_");
      await shown.locator(".datum .choice").first().waitFor();
      const widths = await shown
        .locator(".datum .choice")
        .evaluateAll(all => all.filter(one => one.checkVisibility()).map(one => one.offsetWidth));
      assert.ok(widths.length > 20 && Math.min(...widths) > 100, String(widths));
      await context.close();
    }
  });

  // oracle: axe-core, in both schemes and on a small screen
  test("nothing keeps anyone out", async () => {
    for (const options of [
      { colorScheme: "light" },
      { colorScheme: "dark", viewport: { width: 768, height: 1024 }, hasTouch: true },
    ]) {
      const { context, page } = await open(chrome.browser, { ...options, bypassCSP: true });
      const shown = await dialog(page);
      await shown.locator("summary").nth(1).click();
      await shown.locator(".datum").first().waitFor();
      await page.addScriptTag({ path: axe });
      const found = await page.evaluate(() => globalThis.axe.run(".machine-data"));
      assert.deepEqual(
        found.violations.map(one => `${one.id}: ${one.nodes[0]?.html}`),
        [],
      );
      await context.close();
    }
  });
});
