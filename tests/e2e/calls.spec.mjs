// A call and its program: what counts at the call stays with it, whatever form was there before, and after it.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { openMachine, openProgram, programWhen, searchTasks, shownChange, startWithAll as start } from "./start.mjs";

/** Chooses a cycle by the search. */
async function choose(page, name) {
  await searchTasks(page, name);
  await page.locator(`.hits[data-search="${name}"] .hit`).first().click();
  await page.waitForFunction(text => document.querySelector(".snippet")?.textContent.includes(text), name);
}

async function openCall(page, index = 0) {
  await page.locator(".call-row").nth(index).click();
  await page.locator(".opened").waitFor();
}

const detach = page => page.getByRole("button", { name: "Detach from program" }).click();

/** The form is drawn in these axes, right and up, and counts lengths in this unit. */
async function standsIn(page, axes, unit) {
  await page.waitForFunction(
    ([drawn, counted]) =>
      [...document.querySelectorAll(".picture .axis")].map(one => one.textContent).join("") === drawn &&
      document.querySelector('.field[data-field="_SETVAL"] .unit')?.textContent === counted,
    [axes, unit],
  );
}

const MILLED = "T1 D1\nM6\n_MVAR=1 _SETVAL=5 _TNUM=1 _KNUM=2001 _FA=1\nCYCLE977\nM30\n";
const TURNED = "T1 D1\n_MVAR=0 _SETVAL=45 _MA=2 _TNUM=7 _KNUM=1 _FA=1\nCYCLE974\nM30\n";

describe("plane and units of a call", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual B:1669-1680 (turning in G18), hand: milling in G17
  test("are those of its own machine after a form for another one, in the program and by the search", async () => {
    const { context, page, problems } = await start(chrome);
    await choose(page, "CYCLE974");
    await standsIn(page, "ZX", "mm");
    await openCall(page); // that of the first visit
    await standsIn(page, "XY", "mm");
    await choose(page, "CYCLE974");
    await openProgram(page, MILLED);
    await standsIn(page, "ZX", "mm");
    await openCall(page);
    await standsIn(page, "XY", "mm");
    await choose(page, "CYCLE974");
    await standsIn(page, "ZX", "mm");
    await choose(page, "CYCLE977");
    await standsIn(page, "XY", "mm");
    await openProgram(page, TURNED);
    await standsIn(page, "XY", "mm");
    await openCall(page);
    await standsIn(page, "ZX", "mm");
    await choose(page, "CYCLE977");
    await standsIn(page, "XY", "mm");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the number and what it counts stay together)
  test("stay when it leaves the program, over a reload, and go with another cycle", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, `G18 G70\n${MILLED}`);
    await openCall(page);
    await standsIn(page, "ZX", "inch");
    await detach(page);
    await page.locator(".opened").waitFor({ state: "hidden" });
    await standsIn(page, "ZX", "inch");
    assert.equal(await page.locator(".at-call").textContent(), "At the call: G18 G70");
    await page.waitForTimeout(500); // kept after a pause
    await page.reload();
    await page.locator(".results tbody tr").first().waitFor({ state: "attached" });
    await standsIn(page, "ZX", "inch");
    await openMachine(page);
    await page.locator("#machine-plane").selectOption("G19");
    await standsIn(page, "YZ", "mm");
    await page.locator(".at-call").waitFor({ state: "hidden" });
    await openMachine(page);
    await page.locator("#machine-plane").selectOption("G17");
    await openCall(page);
    await standsIn(page, "ZX", "inch");
    await choose(page, "CYCLE979");
    await page.locator(".at-call").waitFor({ state: "hidden" });
    await page.locator('.fields .unit:text-is("mm")').first().waitFor();
    await counts(page.locator('.fields .unit:text-is("inch")'), 0);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (in the header it is chosen for the program too)
  test("are those that are chosen by hand, where the program says nothing", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, TURNED);
    await openCall(page);
    await standsIn(page, "ZX", "mm");
    assert.equal(await page.locator("#machine-plane").inputValue(), "G18");
    await openMachine(page);
    await page.locator("#machine-units").selectOption("G70");
    await standsIn(page, "ZX", "inch");
    await openMachine(page);
    await page.locator("#machine-plane").selectOption("G17");
    await standsIn(page, "XY", "inch");
    await openMachine(page);
    await page.locator("#machine-units").selectOption("G71");
    await standsIn(page, "XY", "mm");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (a long program is read aside: until then what is known of the call counts)
  test("stay while a long program is read again after each key", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, `G18 G70\n${"G0 X1\n".repeat(3000)}${MILLED}`);
    await openCall(page);
    await standsIn(page, "ZX", "inch");
    await page.evaluate(() => {
      window.units = new Set();
      const unit = document.querySelector('.field[data-field="_SETVAL"] .unit');
      new MutationObserver(() => window.units.add(unit.textContent)).observe(unit, {
        childList: true,
        characterData: true,
        subtree: true,
      });
    });
    await page.locator('.field[data-field="_SETVAL"] .figure').fill("5.25");
    await page.waitForFunction(() => !document.querySelector(".activity:not([hidden])"));
    await page.locator('.snippet:has-text("_SETVAL=5.25")').waitFor();
    await page.waitForTimeout(500);
    assert.deepEqual(await page.evaluate(() => [...window.units]), []);
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("the call in the form", () => {
  const chrome = shared("neither", { before, after });
  const insert = page => page.getByRole("button", { name: "Insert at cursor" });
  const placed = page => page.locator(".placed");
  const field = (page, name) => page.locator(`.field[data-field="${name}"] .entry-line > .figure`);

  /** Lines of the snippet. */
  const lengthOf = async page => (await page.locator(".snippet").textContent()).trim().split("\n").length;

  /** Either the button that inserts the call, or the line in which it stands; never both, never none. */
  async function stands(page, line) {
    const [one, other] = line === null ? [insert, placed] : [placed, insert];
    await one(page).waitFor();
    await other(page).waitFor({ state: "hidden" });
    if (line !== null) await page.locator(`.placed:has-text("In program, line ${line}")`).waitFor();
  }

  // oracle: hand (lines counted in the text)
  test("is inserted, or in the program with its line, after every change of form and text", async () => {
    const { context, page, problems } = await start(chrome);
    await stands(page, 3); // of the first visit
    await openProgram(page, `${MILLED}${MILLED}`);
    await stands(page, null);
    await openCall(page, 1);
    await stands(page, 9); // of two equal calls the open one
    await openCall(page, 0);
    await stands(page, 4);
    await field(page, "_SETVAL").fill("6.5");
    await page.locator('.cm-line:has-text("_SETVAL=6.5")').waitFor();
    await stands(page, 4);
    await field(page, "_SETVAL").fill("6,5.5"); // nothing that can be written
    await stands(page, null);
    await field(page, "_SETVAL").fill("7");
    await stands(page, 4);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+Home");
    await page.keyboard.insertText("; above\n");
    await stands(page, 5);
    await detach(page);
    await stands(page, null);
    const lines = await lengthOf(page);
    await insert(page).click(); // at the cursor, in line 2
    await stands(page, 1 + lines);
    await choose(page, "CYCLE979");
    await stands(page, null);
    assert.deepEqual(problems, []);
    await context.close();
  });

  const HEADS = {
    "a file of the control": "%_N_BORE_MPF\n;$PATH=/_N_WKS_DIR/_N_A_WPD\n; bore\nDEF REAL SIZE\n",
    "a subprogram": "PROC BORE(REAL SIZE)\r\nEXTERN CHECK(REAL)\r\nN5 DEF INT I\r\n",
    "lines that end with CR": "%_N_BORE_MPF\rDEF REAL SIZE\r",
    "no head": "",
  };
  // oracle: hand
  for (const [name, head] of Object.entries(HEADS))
    test(`is inserted behind the head of a program: ${name}`, async () => {
      const { context, page, problems } = await start(chrome);
      const rest = head.includes("\r\n") ? "G0 X1\r\nM30\r\n" : "; first\nG0 X1\nM30\n";
      await openProgram(page, head + rest);
      await stands(page, null);
      await insert(page).click();
      const now = await programWhen(page, text => text !== head + rest);
      assert.ok(now.startsWith(head), now);
      assert.ok(now.endsWith(rest), now);
      assert.match(now.slice(head.length, -rest.length), /CYCLE977\r?\n$/);
      assert.deepEqual(problems, []);
      await context.close();
    });

  // oracle: hand
  test("is found by its link", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, "_MVAR=1 _SETVAL=5 _TNUM=1 _KNUM=2001 _FA=1\nCYCLE977\nG0 X100\nCYCLE977\nM30\n");
    await openCall(page, 1);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+End");
    await stands(page, 4);
    await placed(page).focus();
    await page.keyboard.press("Enter");
    await page.locator('.cm-activeLine:has-text("CYCLE977")').waitFor();
    assert.match(await page.locator(".cm-lineNumbers .cm-activeLineGutter").textContent(), /4/);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the program holds 40 until the other line may change)
  test("is where it is while a change of another line waits, with what the program holds", async () => {
    const { context, page, problems } = await start(chrome);
    const hole = "%_N_HOLE_SPF\nPROC HOLE(REAL _D)\n_MVAR=1 _SETVAL=_D _TNUM=1 _KNUM=0 _FA=1\nCYCLE977\nM17\n";
    await openProgram(page, `%_N_MAIN_MPF\nG17 T9 D1\nHOLE(40)\nM30\n${hole}`);
    await openCall(page);
    await stands(page, 8);
    await field(page, "_SETVAL").fill("41");
    await page.locator(".asks").waitFor();
    await stands(page, 8);
    assert.match(await page.locator(".foot-call").getAttribute("title"), /_SETVAL=_D/);
    await page.locator(".asks").getByRole("button", { name: "Cancel" }).click();
    await stands(page, 8);
    await field(page, "_SETVAL").fill("41");
    await page.locator(".asks").getByRole("button", { name: "Show the change" }).click();
    await shownChange(page).locator('ins:has-text("HOLE(41)")').waitFor();
    await stands(page, 8);
    await shownChange(page).getByRole("button", { name: "Apply" }).click();
    await stands(page, 8);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (a long program is read aside)
  test("is in a long program at once when it is inserted there", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, "G0 X1\n".repeat(3000));
    await stands(page, null);
    const lines = await lengthOf(page);
    await insert(page).click();
    await stands(page, lines);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
