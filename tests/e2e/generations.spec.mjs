// A call in the argument list of a newer control: its own arguments are fields, and a change touches its place only.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { shared } from "./browser.mjs";
import { openFirstCall, openProgram, programWhen, startWithAll as start, unfold } from "./start.mjs";

const CALL = 'CYCLE978(100,10001,,1,50,5,5,1,2,1,"",,0,1,1,-1,,,0,,1,1,)';
const PROGRAM = `G17 G54 T9 D1 M6\nG0 X60 Y0\n${CALL} ; edge\nG54\nM30\n`;

describe("an argument list of newer controls", () => {
  const chrome = shared("neither", { before, after });
  const field = (page, name) => page.locator(`.field[data-field="${name}"]`);

  // oracle: peer (argument 9 is the direction, 1 plus and 2 minus); hand: nothing else of the program changes
  test("has its direction as a field, and a change of it stays in its place", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(page, PROGRAM);
    await unfold(page);
    const direction = field(page, "S_MD").locator(".entry-line > .figure");
    assert.equal(await direction.inputValue(), "2");
    const cut = await field(page, "_KNUM")
      .locator(".entry-line > .figure")
      .evaluate(box => {
        return [box.value, box.scrollWidth - box.clientWidth];
      });
    assert.deepEqual(cut, ["10001", 0], "the box shows all five digits of a coarse zero offset");
    await direction.focus();
    await page.waitForFunction(() => document.querySelector(".explain")?.textContent.includes("Argument 9"));
    if (process.env.PICTURES) await page.screenshot({ path: `${process.env.PICTURES}/list-1280.png` });
    await direction.fill("1");
    await programWhen(page, now => now === PROGRAM.replace("5,5,1,2,1", "5,5,1,1,1"));
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the field is named as the screen of the control names it, and says what is written beside it)
  test("says of a field which argument it is", async () => {
    const { context, page } = await start(chrome);
    await openFirstCall(page, PROGRAM);
    await unfold(page);
    await field(page, "_FA").locator(".entry-line > .figure").focus();
    await page.waitForFunction(() => document.querySelector(".explain")?.textContent.includes("S_FA"));
    assert.match(await page.locator(".explain").textContent(), /Argument 6 .*DFA/);
    await context.close();
  });

  // oracle: peer (published lists: the 4th argument of CYCLE996 is the diameter of the ball; alarm 61424 names it)
  test("tells an argument under the pointer, and has a row for a cycle without form", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, "G17 G54\nCYCLE977(101,1,,1,50,,,2,5)\nCYCLE996(1,,1,24.99)\nM30\n");
    const rows = page.locator(".call-row");
    if (!(await rows.first().isVisible())) await page.locator("button[aria-controls=outline]").click();
    await rows.nth(1).waitFor();
    assert.equal(await rows.count(), 2);
    assert.equal(await rows.nth(1).getAttribute("data-state"), "explained");
    assert.match(await rows.nth(1).textContent(), /CYCLE996.*kinematics/);
    await rows.nth(1).click();
    const line = page.locator(".editor .cm-line", { hasText: "CYCLE996" });
    // where the last but two of its letters stands
    const at = await line.evaluate(node => {
      const range = document.createRange();
      range.selectNodeContents(node);
      const { left, top, width, height } = range.getBoundingClientRect();
      const letters = node.textContent.length;
      return { x: left + (width * (letters - 3.5)) / letters, y: top + height / 2 };
    });
    await page.mouse.move(at.x - 40, at.y);
    await page.mouse.move(at.x, at.y);
    await page.locator(".cm-told").waitFor();
    assert.match(await page.locator(".cm-told").textContent(), /S_SETV: .*ball/i);
    if (process.env.PICTURES) await page.screenshot({ path: `${process.env.PICTURES}/told-1280.png` });
    // by key as well: at the caret, until it is closed or the caret moves
    await line.click();
    await page.mouse.move(0, 0);
    await page.keyboard.press("End");
    await page.keyboard.press("ArrowLeft");
    await page.locator(".cm-told").waitFor({ state: "detached" });
    // what is said is taken away again at once
    const said = await page.locator(".cm-announced").evaluateHandle(node => {
      const heard = [];
      new MutationObserver(() => heard.push(node.textContent)).observe(node, { childList: true, subtree: true });
      return heard;
    });
    await page.keyboard.press("Control+i");
    await page.locator(".cm-told").waitFor();
    assert.match(await said.evaluate(heard => heard.join("\n")), /S_SETV: .*ball/i);
    await page.keyboard.press("Escape");
    await page.locator(".cm-told").waitFor({ state: "detached" });
    await page.keyboard.press("Control+i");
    await page.locator(".cm-told").waitFor();
    await page.keyboard.press("Home");
    await page.locator(".cm-told").waitFor({ state: "detached" });
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: peer (published list of CYCLE977: hundreds 0 of argument 1 only measures, no argument takes _VMS or _TNUM,
  // argument 20 is S_TUL); hand (the help page is that of the older control and says so)
  test("has the words of the list, and its own arguments as fields", async () => {
    const { context, page, problems } = await start(chrome);
    const call = "CYCLE977(1,,,1,50,,,2,5,0,,,,,1,,,0,1,1,-1,,,,,1,1)";
    const program = `G17 G54 T9 D1 M6\nG0 X60 Y0\n${call}\nM30\n`;
    await openFirstCall(page, program);
    await unfold(page);
    await page.getByRole("heading", { name: "Hole: measure only" }).first().waitFor();
    for (const name of ["_VMS", "_TNUM", "_TNAME"])
      assert.equal(await field(page, name).locator(".required:visible").count(), 0);
    assert.equal(await field(page, "_VMS").count(), 0);
    assert.equal(await field(page, "_PRNUM").locator("select").count(), 0, "no type of probe");
    const zero = program.replace("(1,,", "(101,1,");
    await field(page, "_MVAR").locator(".entry-line > .figure").fill("101");
    await programWhen(page, now => now === program.replace("(1,,", "(101,,"));
    await field(page, "_KNUM").locator(".entry-line > .figure").fill("1");
    await programWhen(page, now => now === zero);
    await unfold(page);
    await field(page, "_TUL").locator(".entry-line > .figure").fill("0.5");
    await programWhen(page, now => now === zero.replace("0,1,1,-1", "0,1,0.5,-1"));
    if (process.env.PICTURES) await page.screenshot({ path: `${process.env.PICTURES}/list-words-1280.png` });
    await page.locator(".help-open").click();
    await page.locator(".help-older", { hasText: "older controls" }).waitFor();
    if (process.env.PICTURES) await page.screenshot({ path: `${process.env.PICTURES}/list-help-1280.png` });
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (a program that is read and not run is refused in one sentence)
  test("a program of another maker has its calls, and one refusal of its run", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, "0 BEGIN PGM A MM\n1 TCH PROBE 427 MEASURE COORDINATE ~\n  Q263=+1 ;1ST POINT\n2 M30\n");
    const rows = page.locator(".call-row");
    if (!(await rows.first().isVisible())) await page.locator("button[aria-controls=outline]").click();
    await rows.first().waitFor();
    assert.match(await rows.first().textContent(), /TCH PROBE 427/);
    await page.locator(".segments").getByRole("button", { name: "Whole program" }).click();
    await page.locator("#tab-problems").click();
    const listed = page.locator("#page-problems");
    await listed.getByText(/Program of HEIDENHAIN TNC, probe cycles: 1\. It is read, checked/).waitFor();
    assert.equal(await page.getByText("PW310").count(), 0);
    if (process.env.PICTURES) await page.screenshot({ path: `${process.env.PICTURES}/tnc-1280.png` });
    assert.deepEqual(problems, []);
    await context.close();
  });
});
