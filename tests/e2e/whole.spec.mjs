// Whole programs: the outline of their calls, warnings with their remedies, and call styles.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { convert, focused, fromPageMenu, openProgram, programWhen, startWithEditor as start } from "./start.mjs";

async function openWithCalls(page, text) {
  await openProgram(page, text);
  await page.locator(".call-row").first().waitFor();
}

const VALUES =
  "_MVAR=1 _SETVAL=132 _TUL=0.03 _TLL=-0.03 _TNUM=20 _KNUM=2001 _EVNUM=0 " +
  "_TZL=0.01 _TSA=1 _PRNUM=1 _VMS=0 _NMSP=1 _FA=2";
const GOOD = `G17 G54 G40 D1\nT1 D1\nM5\n${VALUES}\nCYCLE977\n`;
const rows = page => page.locator(".call-row");

describe("the outline of a program", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("tells line, cycle, variant and state of each call, and opens it", async () => {
    const { context, page, problems } = await start(chrome);
    await openWithCalls(page, `${VALUES}\nCYCLE977\n_MVAR=77777\nCYCLE977\nM30\n`);
    await rows(page).nth(1).waitFor();
    assert.match(await rows(page).first().textContent(), /CYCLE977.*line 2.*Hole/);
    assert.equal(await rows(page).nth(1).getAttribute("data-state"), "error");
    await rows(page).nth(1).click();
    await page.locator('.opened:has-text("lines 3 to 4")').waitFor();
    await page.locator('.call-row[aria-selected="true"][data-call="1"]').waitFor();
    await page.locator(".outline").focus();
    await page.keyboard.press("Home");
    await page.keyboard.press("Enter");
    await page.locator('.opened:has-text("lines 1 to 2")').waitFor();
    await page.getByRole("button", { name: "2 calls" }).click();
    await page.locator(".outline").waitFor({ state: "hidden" });
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("of a thousand calls holds few elements and reaches the last", async () => {
    const { context, page, problems } = await start(chrome);
    await openWithCalls(page, `${`${VALUES}\nCYCLE977\n`.repeat(1000)}M30\n`);
    await page.getByRole("button", { name: "1000 calls" }).waitFor();
    assert.ok((await rows(page).count()) < 60, "only rows in sight exist");
    await page.locator(".outline").focus();
    await page.keyboard.press("End");
    await page.locator('.call-row[aria-posinset="1000"]').waitFor();
    await page.keyboard.press("Enter");
    await page.locator('.opened:has-text("lines 1999 to 2000")').waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("follows what is pasted", async () => {
    const { context, page } = await start(chrome);
    await openWithCalls(page, `${VALUES}\nCYCLE977\nM30\n`);
    await page.locator(".cm-line").last().click();
    await page.keyboard.insertText(`\n${VALUES}\nCYCLE978\nM30\n`);
    await page.locator('.call-row:has-text("CYCLE978")').waitFor();
    await context.close();
  });
});

describe("a finding that can be mended", () => {
  const chrome = shared("neither", { before, after });
  const wrong = GOOD.replace("G40 ", "G42 ");

  const cures = page => page.locator(".problem .cure:visible");
  async function openProblems(page) {
    await page.locator("#tab-problems").click();
    await cures(page).first().waitFor();
  }

  // oracle: hand (the line that the button names is there afterwards, and nothing else is different)
  test("is mended by one click in the list, and by one step undone", async () => {
    const { context, page, problems } = await start(chrome);
    await openWithCalls(page, wrong);
    await openProblems(page);
    const cure = cures(page).filter({ hasText: "G40" }).first();
    await cure.focus();
    await page.keyboard.press("Enter");
    const text = await programWhen(page, now => now.includes("G40"));
    assert.equal(text.replace(/^.*G40.*\n/m, ""), wrong, "only a line is added");
    await cures(page).filter({ hasText: "G40" }).first().waitFor({ state: "detached" });
    await focused(page, "#page-problems"); // the focus stays in the list
    await page.locator(".cm-content").click();
    await page.keyboard.press("Control+z");
    assert.equal(await programWhen(page, now => !now.includes("G40")), wrong);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("is mended in the editor, with the keyboard", async () => {
    const { context, page, problems } = await start(chrome);
    await openWithCalls(page, wrong);
    await openProblems(page);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+Shift+M");
    const action = page.locator('.cm-panel-lint .cm-diagnosticAction:has-text("G40")').first();
    await action.waitFor();
    await action.click();
    await programWhen(page, now => now.includes("G40"));
    await action.waitFor({ state: "detached" });
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("a call whose values differ by the way", () => {
  const chrome = shared("neither", { before, after });
  const outcome = page => page.locator(".results-main");
  const sub = "%_N_HOLE_SPF\nPROC HOLE(REAL _D)\n_MVAR=1 _SETVAL=_D _KNUM=0 _PRNUM=1 _FA=3 _TSA=2\nCYCLE977\nM17\n";

  // oracle: hand (the first call of the subprogram gives 40, part 0.03 mm too big)
  test("is worked out with what arrives first, and says so until another value is typed", async () => {
    const { context, page, problems } = await start(chrome);
    await openWithCalls(page, `%_N_MAIN_MPF\nG17 G40 G54 T9 D1\nHOLE(40)\nHOLE(25)\nM30\n${sub}`);
    await rows(page).first().click();
    const assumed = outcome(page).locator(".assumed");
    await assumed.filter({ hasText: "_SETVAL = 40 (line 3)" }).waitFor();
    await outcome(page).locator('tr:has-text("_OVR[4]"):has-text("40.0300")').waitFor();
    await page.getByRole("button", { name: "Detach" }).click();
    await page.locator('.field[data-field="_SETVAL"] .entry-line > .figure').fill("30");
    await outcome(page).locator('tr:has-text("_OVR[4]"):has-text("30.0300")').waitFor();
    assert.equal(await assumed.isVisible(), false);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (where the axis stands only the machine knows)
  test("names what only a run tells", async () => {
    const { context, page } = await start(chrome);
    await openWithCalls(
      page,
      "G17 G40 G54 T9 D1\nR1=$AA_IW[X]\n_MVAR=1 _SETVAL=R1 _KNUM=0 _PRNUM=1 _FA=3 _TSA=2\nCYCLE977\nM30\n",
    );
    await rows(page).first().click();
    await outcome(page)
      .locator(
        'text="Known only when the program runs: _SETVAL. Run the whole program in the 3D view, or enter a number."',
      )
      .waitFor();
    await context.close();
  });
});

describe("ways of writing", () => {
  const chrome = shared("neither", { before, after });
  const snippet = page => page.locator(".snippet");

  // oracle: manual B:11734 (CYCLE_PARA and the parameterizing call)
  test("are chosen for the snippet, kept, and carried by a link", async () => {
    const { context, page, problems } = await start(chrome);
    await page.locator('.ways [data-style="indirect"]').click();
    await page.locator('.snippet[data-style="indirect"]').waitFor();
    assert.match(await snippet(page).textContent(), /CYCLE_PARA\(/);
    await page.waitForFunction(() => JSON.parse(localStorage.getItem("probewright-1") ?? "{}").style === "indirect");
    await page.reload();
    await page.locator('.snippet[data-style="indirect"]').waitFor();
    await fromPageMenu(page, "Copy link");
    await page.waitForFunction(() => location.hash.startsWith("#s="));
    const other = await start(chrome, { path: new URL(page.url()).hash });
    await other.page.locator('.snippet[data-style="indirect"]').waitFor();
    assert.deepEqual(problems, []);
    await other.context.close();
    await context.close();
  });

  // oracle: self (back in the first way the call means the same)
  test("a call of a program is converted in place, in one step, and back", async () => {
    const { context, page, problems } = await start(chrome);
    await openWithCalls(page, GOOD);
    await rows(page).first().click();
    const ways = page.locator(".call-ways");
    await ways.locator('text="Call style: direct"').waitFor();
    const value = page.locator('.field[data-field="_SETVAL"] .entry-line > .figure');
    assert.equal(await value.inputValue(), "132");
    await convert(page, "indirect");
    await ways.locator('text="Call style: indirect"').waitFor();
    await programWhen(page, now => now.includes("CYCLE_PARA("));
    assert.equal(await value.inputValue(), "132");
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+z");
    assert.equal(await programWhen(page, now => !now.includes("CYCLE_PARA(")), GOOD);
    assert.deepEqual(problems, []);
    await context.close();
  });
});

/** Three holes one after the other; the second one is looked for where it is not. */
const HOLES = `G17 G54 G40 D1
T1 D1
M5
${VALUES} _TMV=0.02 _TDIF=0.06 _K=1
CYCLE977
G0 X0
_SETVAL=131.98
CYCLE977
_SETVAL=132
CYCLE977
M30
`;

describe("the measurements of a whole program", () => {
  const chrome = shared("neither", { before, after });
  const row = page => page.locator(".whole-row");

  async function whole(page, text) {
    await openWithCalls(page, text);
    await page.getByRole("button", { name: "Whole program" }).click();
    await row(page).first().waitFor();
  }

  // oracle: hand
  test("have a row each, which is its line and its step", async () => {
    const { context, page, problems } = await start(chrome, { viewport: { width: 1440, height: 900 } });
    await whole(page, HOLES);
    const shown = await row(page).allTextContents();
    assert.ok(shown.length >= 1, shown.join("\n"));
    assert.match(shown[0], /^1.*Hole.*5/);
    await row(page).first().click();
    await page.locator('.whole-row[aria-selected="true"][data-place="0"]').waitFor();
    await page.locator('.cm-activeLine:has-text("CYCLE977")').waitFor();
    await page.locator(".whole-table").focus();
    await page.keyboard.press("End");
    await page.keyboard.press("Enter");
    await page.locator(`.whole-row[aria-selected="true"][data-place="${shown.length - 1}"]`).waitFor();
    await page.locator('.cm-line:has-text("CYCLE977")').first().click();
    await page.locator('.whole-row[aria-selected="true"][data-place="0"]').waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (RFC 4180; a mark of UTF-8, a decimal comma and semicolons in German)
  test("are saved as a table for the language that is shown", async () => {
    for (const [locale, comma] of [
      ["en", ","],
      ["de", ";"],
    ]) {
      const { context, page } = await start(chrome, { locale });
      await page
        .locator(".panel-program input[type=file]")
        .setInputFiles({ name: "part.mpf", mimeType: "text/plain", buffer: Buffer.from(HOLES) });
      await page.locator(".call-row").first().waitFor();
      await page.locator(".panel-view .segments button").nth(1).click();
      await row(page).first().waitFor();
      const [download] = await Promise.all([
        page.waitForEvent("download"),
        page.locator('.whole-top button:has-text("CSV")').click(),
      ]);
      assert.equal(download.suggestedFilename(), "part.csv");
      const bytes = await download.createReadStream().then(async stream => Buffer.concat(await stream.toArray()));
      assert.deepEqual([...bytes.subarray(0, 3)], [0xef, 0xbb, 0xbf]);
      const lines = bytes.toString("utf8").slice(1).trimEnd().split("\r\n");
      assert.equal(lines[0].split(comma).length, 19, lines[0]);
      assert.ok(lines[1].includes(`CYCLE977${comma}`), lines[1]);
      await context.close();
    }
  });

  // oracle: hand: without scatter nothing is uncertain; JCGM 100, eq. 10: two touches and two of the calibration make u
  // of a diameter 2σ; it is 0.03 mm too large, which is its limit
  test("get their certainty on a machine whose probe scatters", async () => {
    const { context, page, problems } = await start(chrome, { viewport: { width: 1280, height: 800 } });
    const certainty = page.getByRole("button", { name: "Certainty" });
    for (const scatter of [0, 0.001]) {
      const setup = JSON.parse(readFileSync(new URL("../../docs/setup.example.json", import.meta.url), "utf8"));
      setup.probe.repeatability = [scatter, 1];
      const buffer = Buffer.from(JSON.stringify(setup));
      await page
        .locator(".top input[type=file]")
        .setInputFiles({ name: "setup.json", mimeType: "application/json", buffer });
      await page.locator('.notice:has-text("Setup opened.")').waitFor();
      if (!scatter)
        await whole(page, `G17 G54\nT9 D1 M6\nG0 X180 Y130\nZ20\n${VALUES} _TMV=0.02 _TDIF=0.06\nCYCLE977\nM30\n`);
      await row(page).first().waitFor();
      await certainty.click();
      const told = scatter ? "Neither good nor bad: 1." : "Nothing spreads:";
      await page.locator(".whole-certain").getByText(told).waitFor();
    }
    const [, expanded] = (await row(page).locator(".cell-actual").textContent()).match(/±(0\.00\d\d)/);
    assert.ok(Math.abs(Number(expanded) - 0.004) < 0.0008, expanded);
    const cut = await row(page)
      .locator(".cell-actual")
      .evaluate(cell => cell.scrollWidth > cell.clientWidth);
    assert.equal(cut, false, "the uncertainty is in sight");
    assert.match(await page.locator(".answer-certain").textContent(), /Ø 132\.\d+ ± 0\.00\d\d/);
    assert.match(await row(page).locator(".verdict").getAttribute("title"), /Neither good nor bad is proven\. good \d/);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("of a thousand calls hold few elements, and the worst comes first at once", async () => {
    const { context, page } = await start(chrome, { viewport: { width: 1440, height: 900 } });
    const calls = "CYCLE977\n".repeat(400);
    await whole(page, HOLES.replace("CYCLE977\nG0 X0\n", calls));
    assert.ok((await row(page).count()) < 60, "only rows in sight exist");
    const took = await page.evaluate(async () => {
      const began = performance.now();
      [...document.querySelectorAll(".whole-top button")][0].click();
      await new Promise(requestAnimationFrame);
      return performance.now() - began;
    });
    assert.ok(took < 500, `${took} ms`);
    await counts(page.locator('[role="columnheader"][aria-sort="ascending"] [data-column="verdict"]'), 1);
    await context.close();
  });
});
