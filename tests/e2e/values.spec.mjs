// What becomes of the values of a call: expressions stay, what a new variant does not know goes, what stands in other
// lines is asked first; and to which call a result belongs.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { shared } from "./browser.mjs";
import {
  convert,
  fromFormMenu,
  openFirstCall,
  openTasks,
  programWhen,
  searchTasks,
  shownChange,
  startWithEditor as start,
  still,
} from "./start.mjs";

async function choose(page, name) {
  await searchTasks(page, name);
  await page.locator(`.hits[data-search="${name}"] .hit`).first().click();
  await page.waitForFunction(text => document.querySelector(".snippet")?.textContent.includes(text), name);
}

const field = (page, name) => page.locator(`.field[data-field="${name}"]`);
const entry = (page, name) => field(page, name).locator(".entry-line > .figure");
const snippet = page => page.locator(".snippet");
const REST = "_KNUM=0 _PRNUM=1 _FA=2 _TSA=2";

describe("an expression of the program", () => {
  const chrome = shared("neither", { before, after });
  const text = `R2=50.02\n_MVAR=1 _SETVAL=R2 ${REST}\nCYCLE977\nM30\n`;

  // oracle: hand (R2 is 50.02 today)
  test("is shown with its worth, and stays when another field is edited and the call is converted", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(page, text);
    await field(page, "_SETVAL").locator('.worth:text-is("= 50.02")').waitFor();
    assert.equal(await entry(page, "_SETVAL").inputValue(), "R2");
    assert.match(await snippet(page).textContent(), /_SETVAL=R2/);
    await page.locator('.results-main tr:has-text("_OVR[0]"):has-text("50.02")').waitFor();
    await entry(page, "_FA").fill("4");
    assert.equal(await programWhen(page, now => now.includes("_FA=4")), text.replace("_FA=2", "_FA=4"));
    await convert(page, "indirect");
    const indirect = await programWhen(page, now => now.includes("CYCLE_PARA("));
    assert.match(indirect, /\(977,1,R2[,)]/);
    await convert(page, "direct");
    assert.match(await programWhen(page, now => !now.includes("CYCLE_PARA(")), /_SETVAL=R2/);
    await entry(page, "_SETVAL").fill("R2+1");
    await field(page, "_SETVAL").locator('.worth:text-is("= 51.02")').waitFor();
    await entry(page, "_SETVAL").fill("51");
    await field(page, "_SETVAL").getByRole("button", { name: "Replace here" }).click();
    await field(page, "_SETVAL").locator(".worth").waitFor({ state: "hidden" });
    assert.match(await programWhen(page, now => now.includes("_SETVAL=51")), /^R2=50\.02$/m);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("goes along when the form leaves the program", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(page, text);
    await field(page, "_SETVAL").locator(".worth").waitFor();
    await page.getByRole("button", { name: "Detach" }).click();
    await page.locator(".opened").waitFor({ state: "hidden" });
    assert.equal(await entry(page, "_SETVAL").inputValue(), "R2");
    assert.match(await snippet(page).textContent(), /_SETVAL=R2/);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (worth 50 where it stands, 7 at the call)
  test("keeps a call from being converted where it would mean something else, and the reason is told", async () => {
    const { context, page, problems } = await start(chrome);
    const moved = `R2=50\n_MVAR=1 _SETVAL=R2 ${REST}\nR2=7\nCYCLE977\nM30\n`;
    await openFirstCall(page, moved);
    await page.locator('.call-ways [data-style="indirect"]').click();
    await page.locator('.call-ways .problem:has-text("PW192")').waitFor();
    await still(page, moved);
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("a change that lands in another line", () => {
  const chrome = shared("neither", { before, after });
  const hole = `%_N_HOLE_SPF\nPROC HOLE(REAL _D)\n_MVAR=1 _SETVAL=_D ${REST}\nCYCLE977\nM17\n`;
  const text = `%_N_MAIN_MPF\nG17 G40 G54 T9 D1\nHOLE(40) ; ring\nM30\n${hole}`;
  const asks = page => page.locator(".asks");

  // oracle: hand
  test("is asked first, with the line as it is and as it would be", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(page, text);
    const value = entry(page, "_SETVAL");
    await field(page, "_SETVAL").locator('.worth:text-is("= 40")').waitFor();
    await value.fill("41");
    await asks(page).locator('li:has-text("Line 3")').waitFor();
    assert.equal(await asks(page).locator("del").textContent(), "HOLE(40) ; ring");
    assert.equal(await asks(page).locator("ins").textContent(), "HOLE(41) ; ring");
    await still(page, text); // nothing is done yet
    await value.fill("42");
    await asks(page).locator('ins:text-is("HOLE(42) ; ring")').waitFor();
    await asks(page).getByRole("button", { name: "Cancel" }).click();
    await asks(page).waitFor({ state: "hidden" });
    assert.equal(await value.inputValue(), "_D");
    await still(page, text);
    await value.fill("43");
    await asks(page).waitFor();
    await value.press("Enter");
    await page.waitForFunction(() => document.activeElement?.textContent === "Apply");
    await page.keyboard.press("Enter");
    assert.equal(await programWhen(page, now => now !== text), text.replace("(40)", "(43)"));
    await asks(page).waitFor({ state: "hidden" });
    await entry(page, "_FA").fill("3");
    assert.match(await programWhen(page, now => now.includes("_FA=3")), /HOLE\(43\)/);
    assert.equal(await asks(page).isVisible(), false, "the call's own lines are not asked about");
    await value.fill("44");
    await asks(page).waitFor();
    await value.press("Escape");
    await asks(page).waitFor({ state: "hidden" });
    assert.deepEqual(problems, []);
    await context.close();
  });
});

/** What is shown before it is done is done. */
async function apply(page) {
  await shownChange(page).getByRole("button", { name: "Apply" }).click();
  await shownChange(page).waitFor({ state: "hidden" });
}

describe("another variant", () => {
  const chrome = shared("neither", { before, after });
  async function zeroOffset(page) {
    const select = field(page, "_MVAR")
      .locator('.digit select:has(option:text-matches("zero offset|ZO", "i"))')
      .first();
    const value = await select.locator('option:text-matches("zero offset|ZO", "i")').first().getAttribute("value");
    await select.selectOption(value);
  }

  // oracle: manual B:5641-5667 (a zero offset knows no tool and no bands), hand (2001 is a radius of D1, and no frame)
  test("keeps nothing in the call that it does not know, and says so", async () => {
    const { context, page, problems } = await start(chrome);
    await page.locator(".opened").waitFor();
    const first = await programWhen(page, now => /_TNUM=/.test(now) && /_KNUM=2001/.test(now));
    assert.match(first, /_TZL=/);
    await zeroOffset(page);
    await apply(page);
    const now = await programWhen(page, text => /_MVAR=101\b/.test(text) && !/_KNUM=2001/.test(text));
    for (const name of ["_TNUM", "_TZL", "_TMV", "_TDIF"]) assert.doesNotMatch(now, new RegExp(`${name}=`), now);
    await field(page, "_KNUM").locator('.problem:has-text("2001")').waitFor();
    await page.locator('.call-ways .problem:has-text("_TNUM")').waitFor();
    await page.locator(".notice").getByRole("button", { name: "Undo" }).click();
    assert.equal(await programWhen(page, text => /_MVAR=1\b/.test(text)), first);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:5641-5667
  test("brings its own worked measurement into the call, and leaves nothing of the one before", async () => {
    const { context, page, problems } = await start(chrome);
    await page.locator(".opened").waitFor();
    const first = await programWhen(page, now => /_TNUM=/.test(now));
    await openTasks(page);
    await page.locator('[role="treeitem"]', { hasText: /^101/ }).first().click();
    await apply(page);
    const zero = await programWhen(page, now => /_MVAR=101\b/.test(now) && /_KNUM=1\b/.test(now));
    for (const name of ["_TNUM", "_TZL", "_TMV", "_TDIF"]) assert.doesNotMatch(zero, new RegExp(`${name}=`), zero);
    await openTasks(page);
    await page.locator('[role="treeitem"]', { hasText: /^1/ }).first().click();
    const again = await programWhen(page, now => /_MVAR=1\b/.test(now) && /_KNUM=2001/.test(now));
    const words = text => text.split(/\s+/).filter(Boolean).sort();
    assert.deepEqual(words(again), words(first));
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:5641-5667, hand (on the way there the number is that of no variant)
  test("by its number keeps no code of the one before, also past a number that is none", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(page, `_MVAR=1 _SETVAL=132 _TNUM=20 ${REST.replace("_KNUM=0", "_KNUM=2001")}\nCYCLE977\nM30\n`);
    for (const number of ["99999", "101"]) {
      await entry(page, "_MVAR").fill(number);
      await entry(page, "_MVAR").press("Tab");
      await programWhen(page, text => text.includes(`_MVAR=${number}`));
    }
    await field(page, "_KNUM").locator('.problem:has-text("2001")').waitFor();
    await programWhen(page, text => !text.includes("_KNUM=2001"));
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:8208-8330 (the axes of a variant of CYCLE971)
  test("clears a value that it does not take, with a note there", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(page, "_MVAR=12 _MA=103 _PRNUM=1 _FA=1 _TSA=1\nCYCLE971\nM30\n");
    assert.equal(await entry(page, "_MA").inputValue(), "103");
    await entry(page, "_MVAR").fill("10000");
    await entry(page, "_MVAR").press("Tab");
    await apply(page);
    await field(page, "_MA").locator('.problem:has-text("103 was cleared")').waitFor();
    const text = await programWhen(page, now => now.includes("_MVAR=10000") && !now.includes("_MA="));
    assert.doesNotMatch(text, /_MA/);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (what is typed in the program stays as it is typed)
  test("typed in the program takes nothing out of it", async () => {
    const { context, page, problems } = await start(chrome);
    const text = `_MVAR=1 _SETVAL=132 _TNUM=20 ${REST.replace("_KNUM=0", "_KNUM=1")}\nCYCLE977\nM30\n`;
    await openFirstCall(page, text);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+Home");
    for (let at = 0; at < "_MVAR=1".length; at++) await page.keyboard.press("ArrowRight");
    await page.keyboard.type("01");
    await still(page, text.replace("_MVAR=1", "_MVAR=101"));
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("marks a wrong value at its field though nobody typed it", async () => {
    const { context, page, problems } = await start(chrome);
    await page.getByRole("button", { name: "Detach" }).click();
    await fromFormMenu(page, "Worked example");
    await zeroOffset(page);
    await field(page, "_KNUM").locator('.problem:has-text("2001")').waitFor();
    assert.equal(await entry(page, "_KNUM").inputValue(), "");
    await entry(page, "_KNUM").fill("777");
    await entry(page, "_FA").focus();
    await field(page, "_KNUM").locator('.problem[data-severity="error"]').waitFor();
    assert.equal(await entry(page, "_KNUM").getAttribute("aria-invalid"), "true");
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("the plane of the default machine", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual B:1669-1680 (turning in G18), hand: milling in G17, whatever was in between
  test("is that of the sort of machine, by whichever way a form comes", async () => {
    const { context, page, problems } = await start(chrome);
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
    const plane = page.locator("#machine-plane");
    await choose(page, "CYCLE974");
    assert.equal(await plane.inputValue(), "G18");
    await choose(page, "G101");
    assert.equal(await plane.inputValue(), "G17");
    await choose(page, "CYCLE977");
    assert.equal(await plane.inputValue(), "G17");
    await choose(page, "CYCLE974");
    await choose(page, "G101");
    await choose(page, "CYCLE994");
    assert.equal(await plane.inputValue(), "G18");
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("the results of a program", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("stand under the call that left them", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(
      page,
      `G17 G54 G40 T9 D1\nM6\n_MVAR=1 _SETVAL=132 ${REST}\nCYCLE977\n_SETVAL=131\nCYCLE977\nM30\n`,
    );
    await page.getByRole("button", { name: "Whole program" }).click();
    const groups = page.locator(".results tr.of-call");
    await groups.nth(1).waitFor();
    assert.deepEqual((await groups.allTextContents()).slice(0, 2), ["CYCLE977, line 4", "CYCLE977, line 6"]);
    const sizes = await page.locator('.results tr:has(th:text-is("_OVR[0]")) td:nth-child(3)').allTextContents();
    assert.deepEqual(sizes, ["132.0000", "131.0000"]);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
