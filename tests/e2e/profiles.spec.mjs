// Machine profiles: what a program lacks is added at its finding; tools, zero offsets and part are entered, exported
// and imported; each control keeps its own machine and its own work.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { counts, packages, shared } from "./browser.mjs";
import { focused, keptWhen, startWithCycles, startWithEditor } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");

const PROGRAM = `T="PROBE_3D" M6
D1
G54
G0 X0 Y0 Z-5
_MVAR=1 _SETVAL=50 _KNUM=0 _FA=2 _TSA=1 _PRNUM=1 _VMS=0 _NMSP=1
CYCLE977
M30
`;

const chip = page => page.locator("#machine-menu-open");
const OWN = /^(SINUMERIK|NCT)/; // of the own machine the chip names the control alone
const screen = page => page.getByRole("dialog", { name: /^Machine: / });

/** The program, and the problems of its run. */
async function run(page, text) {
  const buffer = Buffer.from(text);
  await page.locator(".panel-program input[type=file]").setInputFiles({ name: "part.mpf", mimeType: "", buffer });
  await page.locator(".call-row").first().waitFor();
  await page.getByRole("button", { name: "Whole program" }).click();
  await page.locator("#tab-problems").click();
}

/** The screen of the machine, once everything is there. */
async function edit(page) {
  await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
  await chip(page).click();
  await page.locator("#profile-edit").click();
  await screen(page).waitFor();
  return screen(page);
}

const field = (dialog, name) => dialog.getByRole("textbox", { name, exact: true });

async function type(dialog, name, value) {
  const entry = field(dialog, name);
  await entry.fill(value);
  await entry.press("Enter");
}

describe("what a program lacks", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("is added with one click at its finding, which is one step back", async () => {
    const { context, page, problems } = await startWithEditor(chrome);
    await run(page, PROGRAM);
    const give = page.locator("#page-problems .cure", { hasText: "Add probe PROBE_3D" });
    await give.click();
    await give.waitFor({ state: "detached" });
    assert.match(await chip(page).textContent(), /Machine 1/);
    assert.match(await page.locator("#undo").getAttribute("title"), /^Undo: Add probe PROBE_3D/);
    await page.locator("#undo").click();
    await give.waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("machine profiles", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("a new one gets tools, a zero offset and a part, is exported and imported again", async () => {
    const { context, page, problems } = await startWithEditor(chrome);
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
    await chip(page).click();
    await page.locator("#profile-create").click();
    const dialog = screen(page);
    await type(dialog, "Name", "Mill 1");
    await dialog.getByRole("tab", { name: "Tools" }).click();
    for (const [tool, name, length] of [
      ["T1", "DRILL_8", "120.5"],
      ["T2", "PROBE_3D", "50"],
    ]) {
      await dialog.locator("#equipment-add").click();
      await type(dialog, `Tool name, ${tool} D1`, name);
      await type(dialog, `Length L1, ${tool} D1 ${name}`, length);
    }
    await dialog.getByRole("combobox", { name: "Type, T2 D1 PROBE_3D" }).selectOption("3D probe");
    await type(dialog, "Length L1, T1 D1 DRILL_8", "long");
    assert.match(await dialog.getByRole("alert").filter({ hasText: "long" }).textContent(), /long/);
    await type(dialog, "Length L1, T1 D1 DRILL_8", "121");
    await dialog.getByRole("tab", { name: "Zero offsets" }).click();
    await type(dialog, "X coarse, G54", "100");
    await type(dialog, "Y coarse, G54", "-20,5");
    await dialog.getByRole("radio", { name: "Active: G54" }).check();
    await dialog.getByRole("tab", { name: "Part" }).click();
    await dialog.locator("#equipment-shape").selectOption("Hole");
    await dialog.locator("#equipment-add").click();
    await type(dialog, "Diameter", "50");
    await type(dialog, "Position X", "100");
    await type(dialog, "Position Y", "-20.5");
    await dialog.locator("#equipment-close").click();
    const kept = await keptWhen(page, state => state.setups?.sinumerik?.workpiece?.[0]?.at[1] === -20.5);
    const setup = kept.setups.sinumerik;
    assert.equal(setup.name, "Mill 1");
    assert.deepEqual(setup.tools[1].edges[1].length, [121, 0, 0]);
    assert.equal(setup.tools[2].edges[1].type, 710);
    assert.deepEqual(setup.frames.G54.coarse, [100, -20.5, 0]);
    assert.equal(setup.active.frame, "G54");

    await run(page, PROGRAM);
    await page.locator("#tab-outcome").click();
    await page.locator(".results tr", { hasText: "_OVR[4]" }).waitFor();
    assert.match(await page.locator(".results tr", { hasText: "_OVR[4]" }).textContent(), /50\.0000/);

    await chip(page).click();
    const download = page.waitForEvent("download");
    await page.locator("#profile-export").click();
    const file = await download;
    assert.equal(file.suggestedFilename(), "Mill-1.json");
    const bytes = await readFile(await file.path());
    assert.deepEqual(JSON.parse(bytes.toString()), setup);
    await context.close();

    const other = await startWithEditor(chrome);
    await other.page.locator(".top input[type=file]").setInputFiles({
      name: "Mill-1.json",
      mimeType: "application/json",
      buffer: bytes,
    });
    await other.page.locator("#machine-menu-open", { hasText: "Mill 1" }).waitFor();
    assert.deepEqual((await keptWhen(other.page, state => state.setups?.sinumerik)).setups.sinumerik, setup);
    assert.deepEqual([...problems, ...other.problems], []);
    await other.context.close();
  });

  // oracle: hand (a number that ends under its unit cannot be read)
  test("each number ends before its unit", async () => {
    const { context, page } = await startWithCycles(chrome);
    await edit(page);
    const covered = await page.locator(".equipment-field .figure").evaluateAll(figures =>
      figures.flatMap(figure => {
        const unit = figure.parentElement.querySelector(".unit");
        if (!unit?.textContent.trim() || !figure.checkVisibility()) return [];
        const end = figure.getBoundingClientRect().right - Number.parseFloat(getComputedStyle(figure).paddingRight);
        const text = document.createRange();
        text.selectNodeContents(unit);
        return end > text.getBoundingClientRect().left ? [figure.id] : [];
      }),
    );
    assert.deepEqual(covered, []);
    await context.close();
  });

  // oracle: hand
  test("a tool probe is added and undone in its table", async () => {
    const { context, page, problems } = await startWithEditor(chrome);
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
    await chip(page).click();
    await page.locator("#profile-edit").click();
    await screen(page).getByRole("tab", { name: "Tool probes" }).click();
    const boxes = screen(page).locator(".equipment-box");
    await counts(boxes, 0);
    await screen(page).locator("#equipment-shape").selectOption({ label: "Cube" });
    await screen(page).locator("#equipment-add").click();
    await boxes.filter({ hasText: "Cube 1" }).waitFor();
    await screen(page).getByRole("button", { name: "Undo" }).click();
    await boxes.waitFor({ state: "detached" });
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("several are kept, chosen, duplicated, renamed and deleted, each a step back", async () => {
    const { context, page, problems } = await startWithEditor(chrome);
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
    await chip(page).click();
    await page.locator("#profile-create").click();
    await screen(page).locator("#equipment-close").click();
    await chip(page).click();
    await page.locator("#profile-copy").click();
    await page.locator("#machine-menu-open", { hasText: "Machine 2" }).waitFor();
    await chip(page).click();
    await page.locator("#profile-rename").fill("Lathe");
    await page.locator("#profile-rename").press("Enter");
    await page.locator("#machine-menu-open", { hasText: "Lathe" }).waitFor();
    await page.keyboard.press("Escape");
    await keptWhen(page, state => state.parked?.length === 1);
    await page.reload();
    await page.locator("#machine-menu-open", { hasText: "Lathe" }).waitFor();
    await chip(page).click();
    await page.locator(".profile-list button", { hasText: "Machine 1" }).click();
    await page.locator("#machine-menu-open", { hasText: "Machine 1" }).waitFor();
    await chip(page).click();
    await page.locator("#profile-delete").click();
    await page.locator("#machine-menu-open", { hasText: OWN }).waitFor();
    await page.locator("#undo").click();
    await page.locator("#machine-menu-open", { hasText: "Machine 1" }).waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("each control keeps its task and its machine", async () => {
    const { context, page, problems } = await startWithEditor(chrome);
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
    await chip(page).click();
    await page.locator("#profile-create").click();
    await screen(page).locator("#equipment-close").click();
    const title = await page.locator("#form-title").textContent();
    await page.locator('.top > .control-switch [data-control="nct"]').click();
    await page.locator("#machine-menu-open", { hasText: OWN }).waitFor();
    assert.notEqual(await page.locator("#form-title").textContent(), title);
    await page.locator('.top > .control-switch [data-control="sinumerik"]').click();
    await page.locator("#machine-menu-open", { hasText: "Machine 1" }).waitFor();
    assert.equal(await page.locator("#form-title").textContent(), title);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: self (the setup of an earlier page is the profile in use)
  test("the machine that an earlier page kept is a profile", async () => {
    const { context, page, problems } = await startWithEditor(chrome);
    const edited = await edit(page);
    await type(edited, "Name", "Old mill");
    await edited.locator("#equipment-close").click();
    await keptWhen(page, state => state.setups?.sinumerik?.name === "Old mill");
    await page.addInitScript(() => {
      const { setups, parked: _, ...kept } = JSON.parse(localStorage.getItem("probewright-1"));
      if (setups) localStorage.setItem("probewright-1", JSON.stringify({ ...kept, setup: setups.sinumerik }));
      sessionStorage.clear();
    });
    await page.reload();
    await page.locator("#machine-menu-open", { hasText: "Old mill" }).waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: the rules of axe, and hand
  test("everything is done with the keyboard, and each tab has names", async () => {
    const { context, page, problems } = await startWithCycles(chrome, {
      viewport: { width: 390, height: 844 },
      bypassCSP: true,
    });
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
    await page.locator(".rail-more").focus(); // the machine of a phone is in its menu
    await page.keyboard.press("Enter");
    await page.locator("#page-actions").getByRole("button", { name: "Machine", exact: true }).focus();
    await page.keyboard.press("Enter");
    await page.locator("#profile-edit").focus();
    await page.keyboard.press("Enter");
    const dialog = screen(page);
    await dialog.locator("#equipment-tab-machine").focus();
    await page.addScriptTag({ path: axe });
    for (const tab of ["machine", "tools", "offsets", "probe", "toolprobes", "part"]) {
      await focused(page, `#equipment-tab-${tab}`);
      const found = await page.evaluate(() => globalThis.axe.run(".equipment"));
      const told = found.violations.map(one => `${tab}: ${one.id} ${one.nodes.map(node => node.html).join(" ")}`);
      assert.deepEqual(told, []);
      const wide = await dialog.evaluate(node => node.scrollWidth - node.clientWidth);
      assert.ok(wide <= 0, `${tab}: ${wide} px too wide`);
      await page.keyboard.press("ArrowRight");
    }
    await dialog.locator("#equipment-tab-part").focus();
    await page.keyboard.press("Enter");
    await dialog.locator("#equipment-add").focus();
    await page.keyboard.press("Enter");
    await focused(page, "#part-0-equip-diameter");
    await page.keyboard.press("Control+A");
    await page.keyboard.type("32");
    await page.keyboard.press("Tab");
    await keptWhen(page, state => state.setups?.sinumerik?.workpiece?.[0]?.size[0] === 32);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
