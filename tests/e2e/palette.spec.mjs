// The palette: one field that finds and runs everything, by keyboard, by the words of other languages and controls.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { drawn, find, lengthField, openProgram, shownChange, startWithAll as start, stored } from "./start.mjs";

const palette = page => page.locator("dialog.palette[open]");
const items = (page, group) => palette(page).locator(`[aria-labelledby="palette-group-${group}"] .palette-item`);
const chosen = page => palette(page).locator('[aria-selected="true"]');

const CALL = "_MVAR=1 _SETVAL=132 _TUL=0.03 _TLL=-0.03 _TNUM=20 _KNUM=0 _TSA=1 _PRNUM=1 _NMSP=1 _FA=2\nCYCLE977\n";

describe("the palette", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("runs what has a key and shows that key, those that were run last first", async () => {
    const { context, page, problems } = await start(chrome);
    await lengthField(page).fill("41");
    await page.locator('.snippet:has-text("41")').waitFor();
    await find(page, "undo");
    assert.match(await chosen(page).textContent(), /Undo.*Ctrl\+Z/);
    await page.keyboard.press("Enter");
    await palette(page).waitFor({ state: "detached" });
    assert.notEqual(await lengthField(page).inputValue(), "41");
    await find(page, "theme dark");
    await page.keyboard.press("Enter");
    await page.locator('html[data-theme="dark"]').waitFor();
    await find(page, "go to form");
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => document.activeElement?.id === "panel-form");
    await page.keyboard.press("Control+k");
    assert.equal(await items(page, "recent").first().locator(".palette-title").textContent(), "Go to: Form");
    assert.match(await chosen(page).textContent(), /Go to: Form/);
    await page.keyboard.press("Escape");
    await page.waitForTimeout(400);
    assert.deepEqual((await stored(page)).recent, ["panel-form", "theme-dark", "undo"]);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: peer (the published list of CYCLE996; its remedies; TNC7, cycle 430: its last values are on no page)
  test("explains what newer controls and other makers have", async () => {
    const { context, page, problems } = await start(chrome);
    for (const [typed, heading, said] of [
      ["CYCLE996", "CYCLE996", /S_TC/],
      ["61422", "Alarm 61422", /CYCLE996/],
      ["54600", "SD54600", /_WP\[k,0\]/],
      ["TCH PROBE 430", "TCH PROBE 430", /Q281, Q309, Q330/],
    ]) {
      await find(page, typed);
      await palette(page)
        .locator(".palette-item")
        .filter({ hasText: heading.replace("Alarm ", "") })
        .first()
        .click();
      const card = page.locator("dialog.card[open]");
      await card.getByRole("heading", { name: heading, exact: true }).waitFor();
      assert.match(await card.textContent(), said);
      if (process.env.PICTURES) await page.screenshot({ path: `${process.env.PICTURES}/card-${typed}.png` });
      await page.keyboard.press("Escape");
      await card.waitFor({ state: "detached" }).catch(() => card.waitFor({ state: "hidden" }));
    }
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("keeps the machine in a file and takes one, as its menu does", async () => {
    const { context, page, problems } = await start(chrome);
    await find(page, "export setup");
    const download = page.waitForEvent("download");
    await page.keyboard.press("Enter");
    assert.equal((await download).suggestedFilename(), "setup.json");
    const file = await (await download).path();
    await palette(page).waitFor({ state: "detached" });
    await find(page, "import setup");
    const chooser = page.waitForEvent("filechooser");
    await drawn(page); // by then the browser hands its pickers over
    await page.keyboard.press("Enter");
    await (await chooser).setFiles({ name: "mill.json", mimeType: "application/json", buffer: await readFile(file) });
    await page.locator('.notice:has-text("Setup opened.")').waitFor();
    await find(page, "edit machine");
    await page.keyboard.press("Enter");
    await page.getByRole("dialog", { name: /^Machine: / }).waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (words of the manuals, of German and of Chinese for the same thing)
  test("leads from the words of others to our measurements, and back to the form", async () => {
    const { context, page, problems } = await start(chrome);
    for (const [words, wanted] of [
      ["Bohrung", /Hole/],
      ["bore", /Hole/],
      ["孔", /Hole/],
      ["boss G110", /G110/],
    ]) {
      await find(page, words);
      assert.match(await items(page, "measurement").first().textContent(), wanted, words);
    }
    await find(page, "gear web too wide");
    await items(page, "measurement").first().click();
    await palette(page).waitFor({ state: "detached" });
    await page.locator('[role="treeitem"][aria-selected="true"]:has-text("Web")').waitFor({ state: "attached" });
    for (const words of ["work offset", "工件零点", "Nullpunktverschiebung"]) {
      await find(page, words);
      assert.ok((await palette(page).locator(".palette-item").count()) > 0, words);
    }
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("goes to fields, calls, lines, problems, alarms and data", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, `G17 G54 G42 D1\nT1 D1\nM5\n${CALL}${"G0 X1\n".repeat(5)}${CALL}M30\n`);
    await page.locator(".call-row").nth(1).waitFor();
    await find(page, "CYCLE977");
    await counts(items(page, "call"), 2);
    await items(page, "call").nth(1).click();
    await page.locator('.opened:has-text("lines 11 to 12")').waitFor();
    await find(page, "_TSA");
    await items(page, "field").first().click();
    await page.waitForFunction(() => document.activeElement?.closest(".field")?.dataset.field === "_TSA");
    await find(page, "2");
    await page.keyboard.press("Enter");
    await page.locator('.cm-activeLine:has-text("T1 D1")').waitFor();
    await find(page, "G40");
    assert.ok((await items(page, "finding").count()) > 0, "what is wrong is found by its words");
    await find(page, "61303");
    await page.keyboard.press("Enter");
    await page.locator("dialog.card[open] h2:has-text('61303')").waitFor();
    await page.keyboard.press("Escape");
    await find(page, "_CBIT[0]");
    await items(page, "datum").first().click();
    await page.locator("dialog.machine-data[open] .datum").first().waitFor();
    await page.keyboard.press("Escape");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the control takes CR alone as the end of a line too)
  test("goes to the lines of a program whose lines end with CR", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, "G17\rT1 D1\rM30\r");
    await page.locator('.cm-line:has-text("M30")').waitFor();
    await find(page, "3");
    await page.keyboard.press("Enter");
    await page.locator('.cm-activeLine:has-text("M30")').waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the change is shown first)
  test("converts all calls, and moves by the arrow keys alone", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, `T1 D1\n${CALL}${CALL}M30\n`);
    await page.locator(".call-row").nth(1).waitFor();
    await page.locator(".cm-content").focus();
    await find(page, "convert all indirect");
    assert.match(await chosen(page).textContent(), /all 2 calls/);
    await page.keyboard.press("Enter");
    await shownChange(page).locator('h2:has-text("2 calls")').waitFor();
    await page.keyboard.press("Escape");
    await shownChange(page).waitFor({ state: "hidden" });
    await page.keyboard.press("Control+k");
    const first = await chosen(page).getAttribute("id");
    assert.equal(await page.locator("#palette-search").getAttribute("aria-activedescendant"), first);
    await page.keyboard.press("ArrowUp");
    const last = await chosen(page).getAttribute("id");
    assert.notEqual(last, first);
    await page.keyboard.press("ArrowDown");
    assert.equal(await chosen(page).getAttribute("id"), first);
    await page.locator("#palette-search").fill("qqqqqq");
    await palette(page).locator('.empty:has-text("Nothing found")').waitFor();
    await page.keyboard.press("Escape");
    await palette(page).waitFor({ state: "detached" });
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("the tooltip of a button with a key", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand (the table of keys)
  test("says the key", async () => {
    const { context, page } = await start(chrome);
    for (const button of await page.locator("button[aria-keyshortcuts]:visible:enabled").all()) {
      await button.hover();
      const [key] = (await button.getAttribute("aria-keyshortcuts")).split(" ");
      const told = key.replace("Control", "Ctrl");
      assert.ok((await button.getAttribute("title"))?.endsWith(`(${told})`), `${await button.textContent()} ${key}`);
    }
    await context.close();
  });
});
