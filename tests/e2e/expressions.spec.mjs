// Expressions at the fields: what a call writes as R2 stays R2 until the user says otherwise, and what is typed as an
// expression is written as one. With mouse and keyboard, as a user does it.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { openFirstCall, programWhen, searchTasks, shownChange, startWithEditor as start, still } from "./start.mjs";

const REST = "_KNUM=0 _PRNUM=1 _FA=2 _TSA=2";

const field = (page, name) => page.locator(`.field[data-field="${name}"]`);
const entry = (page, name) => field(page, name).locator(".entry-line > .figure");
const note = (page, name) => field(page, name).locator(".replaced");
const worth = (page, name, text) => field(page, name).locator(`.worth:text-is("${text}")`);
const mark = (page, name) => field(page, name).locator(".fx");
const snippet = page => page.locator(".snippet");

/** Types over what the field holds, key by key. */
async function type(page, name, text) {
  await entry(page, name).click();
  await page.keyboard.press("Control+A");
  await page.keyboard.type(text);
}

describe("a number typed over an expression", () => {
  const chrome = shared("neither", { before, after });
  const text = `R2=7\nG0 X=R2\nR2=50.02 ; bore\n_MVAR=1 _SETVAL=R2 ${REST}\nCYCLE977\nG1 X=R2+1 F100\nR2=3\nM30\n`;

  // oracle: hand (R2 of line 3 is read in lines 4 and 6; that of line 1 in line 2)
  test("waits, and the variable can be changed where it is assigned", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(page, text);
    await worth(page, "_SETVAL", "= 50.02").waitFor();
    await mark(page, "_SETVAL").waitFor();
    await type(page, "_SETVAL", "51,5");
    await note(page, "_SETVAL").locator('ins:text-is("R2=51.5 ; bore")').waitFor();
    assert.equal(await note(page, "_SETVAL").locator("del").textContent(), "R2=50.02 ; bore");
    const lines = note(page, "_SETVAL").locator("li > p:first-child button");
    assert.deepEqual(
      (await lines.allTextContents()).map(one => one.trim()),
      ["Line 4", "Line 6"],
    );
    await still(page, text);
    await lines.nth(1).click();
    await page.locator('.cm-activeLine:has-text("G1 X=R2+1")').waitFor();
    await still(page, text);
    await note(page, "_SETVAL").getByRole("button", { name: "Change R2 to 51.5" }).click();
    await shownChange(page).locator('ins:has-text("R2=51.5 ; bore")').waitFor();
    await shownChange(page).locator('[data-sort="changed"] code:text-is("_SETVAL = 50.02 → 51.5")').waitFor();
    await page.keyboard.press("Escape");
    await shownChange(page).waitFor({ state: "hidden" });
    await still(page, text);
    await note(page, "_SETVAL").getByRole("button", { name: "Change R2 to 51.5" }).click();
    await shownChange(page).getByRole("button", { name: "Apply" }).click();
    assert.equal(await programWhen(page, now => now !== text), text.replace("50.02", "51.5"));
    await worth(page, "_SETVAL", "= 51.5").waitFor();
    assert.equal(await entry(page, "_SETVAL").inputValue(), "R2");
    await note(page, "_SETVAL").waitFor({ state: "hidden" });
    await page.keyboard.press("Control+Z");
    assert.equal(await programWhen(page, now => now === text), text, "one step");
    await worth(page, "_SETVAL", "= 50.02").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("takes its place only when that is chosen, by key too", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(page, text);
    await worth(page, "_SETVAL", "= 50.02").waitFor();
    await type(page, "_SETVAL", "60");
    await note(page, "_SETVAL").getByRole("button", { name: "Change R2 to 60" }).waitFor(); // after the last key
    await page.keyboard.press("Escape");
    await note(page, "_SETVAL").waitFor({ state: "hidden" });
    assert.equal(await entry(page, "_SETVAL").inputValue(), "R2");
    await still(page, text);
    await type(page, "_SETVAL", "60");
    await note(page, "_SETVAL").getByRole("button", { name: "Change R2 to 60" }).waitFor(); // after the last key
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => document.activeElement?.textContent.includes("Change R2 to 60"));
    await page.keyboard.press("Tab");
    await page.keyboard.press("Enter");
    const replaced = text.replace("_SETVAL=R2", "_SETVAL=60");
    assert.equal(await programWhen(page, now => now !== text), replaced);
    await mark(page, "_SETVAL").waitFor({ state: "hidden" });
    await page.keyboard.press("Control+Z");
    await programWhen(page, now => now === text);
    await worth(page, "_SETVAL", "= 50.02").waitFor();
    // what is taken away key by key is no answer either
    await entry(page, "_SETVAL").click();
    await page.keyboard.press("End");
    await page.keyboard.press("Backspace");
    await page.keyboard.press("Backspace");
    await note(page, "_SETVAL").getByRole("button", { name: "Remove here" }).waitFor();
    await still(page, text);
    await note(page, "_SETVAL").getByRole("button", { name: "Keep R2" }).click();
    await note(page, "_SETVAL").waitFor({ state: "hidden" });
    assert.equal(await entry(page, "_SETVAL").inputValue(), "R2");
    await still(page, text);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (2 R3 = 60 where R3 is 30; R1 is calculated)
  test("is solved for the variable, and what cannot be changed says why", async () => {
    const { context, page, problems } = await start(chrome);
    const other = `R3=25\nR1=R3/5\n_MVAR=1 _SETVAL=2*R3 ${REST.replace("_FA=2", "_FA=R1")}\nCYCLE977\nM30\n`;
    await openFirstCall(page, other);
    await worth(page, "_SETVAL", "= 50").waitFor();
    await type(page, "_FA", "4");
    await note(page, "_FA").getByText("it is calculated in line 2").waitFor();
    await counts(note(page, "_FA").locator(".replaced-assign"), 0);
    await note(page, "_FA").getByRole("button", { name: "Keep R1" }).click();
    await type(page, "_SETVAL", "60");
    await note(page, "_SETVAL").getByRole("button", { name: "Change R3 to 30" }).click();
    await shownChange(page).getByRole("button", { name: "Apply" }).click();
    assert.equal(await programWhen(page, now => now !== other), other.replace("R3=25", "R3=30"));
    await worth(page, "_SETVAL", "= 60").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("an expression typed into a field", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("is written as it is typed, with a decimal point, and counts with its worth", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(page, `R2=50\n_MVAR=1 _SETVAL=40 ${REST}\nCYCLE977\nM30\n`);
    await entry(page, "_SETVAL").waitFor();
    await type(page, "_SETVAL", "R2+0,5");
    await programWhen(page, now => now.includes("_SETVAL=R2+0.5 "));
    await worth(page, "_SETVAL", "= 50.5").waitFor();
    await page.locator('.results-main tr:has-text("_OVR[0]"):has-text("50.5")').waitFor();
    await type(page, "_SETVAL", "50+0,25");
    await programWhen(page, now => now.includes("_SETVAL=50+0.25 "));
    await worth(page, "_SETVAL", "= 50.25").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (atan2 of 1 and 1 is 45 degrees)
  test("may use functions, and its decimal commas are told, but for those between arguments", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(page, `R1=2500\n_MVAR=1 _SETVAL=40 ${REST}\nCYCLE977\nM30\n`);
    await entry(page, "_SETVAL").waitFor();
    for (const [typed, written, number] of [
      ["SQRT(R1)+0,5", "SQRT(R1)+0.5", "50.5"],
      ["ABS(-50)", "ABS(-50)", "50"],
      ["ATAN2(1,1)+5,5", "ATAN2(1,1)+5.5", "50.5"],
      ["ROUND(49.7)", "ROUND(49.7)", "50"],
    ]) {
      await type(page, "_SETVAL", typed);
      await programWhen(page, now => now.includes(`_SETVAL=${written} `));
      await worth(page, "_SETVAL", `= ${number}`).waitFor();
      const told = field(page, "_SETVAL").getByText(`Decimal point in the program: ${written}`);
      await told.waitFor({ state: typed === written ? "detached" : "visible" });
    }
    await type(page, "_FA", "2,25");
    await programWhen(page, now => now.includes("_FA=2.25 "));
    await field(page, "_FA").getByText("Decimal point in the program: 2.25").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (nothing assigns R9)
  test("without a value says so at the field, and takes no expression away", async () => {
    const { context, page, problems } = await start(chrome);
    const text = `R2=50\n_MVAR=1 _SETVAL=R2 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2\nCYCLE977\nM30\n`;
    await openFirstCall(page, text);
    await worth(page, "_SETVAL", "= 50").waitFor();
    await type(page, "_SETVAL", "R9");
    await note(page, "_SETVAL").waitFor();
    await still(page, text);
    await note(page, "_SETVAL").getByRole("button", { name: "Replace here" }).click();
    await programWhen(page, now => now.includes("_SETVAL=R9 "));
    await field(page, "_SETVAL").locator('.problem:has-text("R9 has no value here")').waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("counts in a form without a program, and is inserted as it is typed", async () => {
    const { context, page, problems } = await start(chrome);
    await page.getByRole("button", { name: "Detach" }).click();
    await page.locator(".opened").waitFor({ state: "hidden" });
    await type(page, "_SETVAL", "130+2,5");
    await worth(page, "_SETVAL", "= 132.5").waitFor();
    assert.match(await snippet(page).textContent(), /_SETVAL=130\+2\.5/);
    await page.locator('.results-main tr:has-text("_OVR[0]"):has-text("132.5")').waitFor();
    await type(page, "_SETVAL", "R9");
    await page.keyboard.press("Tab");
    await field(page, "_SETVAL").locator('.problem:has-text("R9 has no value here")').waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (an address takes a variable as it is, what is calculated in brackets)
  test("is put into brackets where the control needs them", async () => {
    const { context, page, problems } = await start(chrome);
    await searchTasks(page, "G101");
    await page.locator('.hits[data-search="G101"] .hit').first().click();
    await page.waitForFunction(() => document.querySelector(".snippet")?.textContent.includes("G101"));
    await openFirstCall(page, "%O0001\nG17 G54 G90\n#101=40\nG101 X#101\nM30\n", "part.nc");
    await worth(page, "X", "= 40").waitFor();
    assert.equal(await entry(page, "X").inputValue(), "#101");
    await type(page, "X", "#101+1,5");
    await programWhen(page, now => now.includes("G101 X[#101+1.5]\n"));
    await worth(page, "X", "= 41.5").waitFor();
    await type(page, "X", "50");
    await note(page, "X").getByRole("button", { name: "Change #101 to 48.5" }).click();
    await shownChange(page).getByRole("button", { name: "Apply" }).click();
    await programWhen(page, now => now.includes("#101=48.5\nG101 X[#101+1.5]\n"));
    assert.deepEqual(problems, []);
    await context.close();
  });
});
