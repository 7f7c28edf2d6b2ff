// What belongs to a program: subprograms and definition files that are dropped with it or after it, values for its own
// parameters, values that only the machine has.
import assert from "node:assert/strict";
import { mkdir, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { counts, packages, shared } from "./browser.mjs";
import { faults } from "./room.mjs";
import { focused, keptWhen, startWithEditor as start, start as startAnywhere } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");
const MAIN = "G17 G54 G90\r\nR1=LIMIT[1]\r\nSUB(3)\r\nM30\r\n";
const SUB = "PROC SUB(REAL A)\nR2=A*2\nM17\n";
const DEF = "DEF NCK REAL LIMIT[3]=SET(1,7.5,2)\nM17\n";
const file = (name, text) => ({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
const input = page => page.locator(".panel-program input[type=file]").first();
const beside = (page, name) => page.locator(".beside-file").filter({ hasText: name });

/** All motions of the program are shown, and the result of its run. */
async function run(page) {
  await page.locator(".segments").getByRole("button", { name: "Whole program" }).click();
  await page.locator(".panel-results [id=tab-outcome]").click();
  await page.locator(".ended").waitFor();
}
const ends = (page, how) => page.locator(".ended").getByText(how, { exact: true }).waitFor();
const TO_ITS_END = "The program ran to its end.";

async function openAll(page, ...files) {
  await input(page).setInputFiles(files);
  await page.locator('.notice:has-text("Program opened.")').waitFor();
}

async function saved(page) {
  const download = page.waitForEvent("download");
  await page.locator(".panel-program").getByRole("button", { name: "Save", exact: true }).click();
  const done = await download;
  return { name: done.suggestedFilename(), bytes: await readFile(await done.path()) };
}

/** Drops what lies at a path, as the system does: only so does the browser know a folder. */
async function dropPath(context, page, path) {
  const session = await context.newCDPSession(page);
  const { x, y } = await page.locator(".cm-content").boundingBox();
  const data = { items: [], files: [path], dragOperationsMask: 1 };
  for (const type of ["dragEnter", "dragOver", "drop"])
    await session.send("Input.dispatchDragEvent", { type, x: x + 5, y: y + 5, data });
}

describe("files with a program", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand (LIMIT[1] and the argument are there only with the files)
  test("are found by its calls and its variables, and each is saved as it was", async () => {
    const { context, page, problems } = await start(chrome);
    const latin = Buffer.from("; \xe4\r\nPROC SUB(REAL A)\r\nR2=A*2\r\nM17\r\n", "latin1");
    await openAll(page, file("part.mpf", MAIN), { ...file("SUB.SPF", ""), buffer: latin }, file("GUD4.DEF", DEF));
    await page.waitForFunction(() => {
      const names = [...document.querySelectorAll(".beside-name")].map(one => one.textContent.trim());
      return names.join() === "GUD4.DEF,part.mpf,SUB.SPF";
    });
    assert.deepEqual((await saved(page)).bytes, Buffer.from(MAIN));
    await run(page);
    await ends(page, TO_ITS_END);
    await page.locator("#tab-problems").click();
    const about = page.locator("#page-problems .problem-text").filter({ hasText: /SUB|LIMIT/ });
    await about.waitFor({ state: "detached" });
    await beside(page, "SUB.SPF").locator(".beside-name").click();
    await page.locator('.cm-line:has-text("PROC SUB")').waitFor();
    const back = await saved(page);
    assert.equal(back.name, "SUB.SPF");
    assert.deepEqual(back.bytes, latin);
    await beside(page, "part.mpf").locator(".beside-name").click();
    await page.locator('.cm-line:has-text("SUB(3)")').waitFor();
    assert.deepEqual((await saved(page)).bytes, Buffer.from(MAIN));
    await keptWhen(page, state => state.beside?.sinumerik?.length === 2);
    await page.reload();
    await beside(page, "GUD4.DEF").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("come out of a folder, are removed and come back by undo", async () => {
    const { context, page } = await start(chrome);
    const folder = await mkdtemp(join(tmpdir(), "programs-"));
    await mkdir(join(folder, "SPF.DIR"));
    await writeFile(join(folder, "PART.MPF"), MAIN);
    await writeFile(join(folder, "SPF.DIR", "SUB.SPF"), SUB);
    await dropPath(context, page, folder);
    await beside(page, "SUB.SPF").waitFor();
    await page.locator('.beside-file[data-shown]:has-text("PART.MPF")').waitFor();
    await page.getByRole("button", { name: "Remove SUB.SPF" }).click();
    await beside(page, "SUB.SPF").waitFor({ state: "detached" });
    await focused(page, "#beside-add");
    await page.locator(".notice button").click();
    await beside(page, "SUB.SPF").waitFor();
    await context.close();
    await rm(folder, { recursive: true });
  });

  // oracle: hand: the second program has a parameter, the first has none
  test("hold several programs in one text, of which one is chosen to run", async () => {
    const { context, page } = await start(chrome);
    const text = "%_N_ONE_MPF\nR1=1\nM30\n%_N_TWO_MPF\nPROC TWO(REAL DEPTH)\nR1=2+DEPTH\nM30\n";
    await openAll(page, file("two.arc", text));
    await run(page);
    await ends(page, TO_ITS_END);
    await counts(page.locator("#given-DEPTH"), 0);
    await page.locator("#run-program").selectOption("TWO");
    await page.locator("#given-DEPTH").fill("3");
    // the page is drawn while one types: what is not yet taken stays
    await page.locator("#run-strict").evaluate(box => box.click());
    await page.locator("#run-strict").evaluate(box => box.click());
    assert.equal(await page.locator("#given-DEPTH").inputValue(), "3");
    await page.locator("#given-DEPTH").press("Enter");
    await ends(page, TO_ITS_END);
    await page.locator(".panel-results").getByText("R1", { exact: true }).waitFor();
    assert.match(await page.locator(".panel-results").textContent(), /R1\s*5\b/);
    await context.close();
  });

  // oracle: hand
  test("that are missing are wanted by name, and a click opens them", async () => {
    const { context, page } = await start(chrome);
    await openAll(page, file("part.mpf", "G17 G54\nSUB(3)\nM30\n"));
    await page.locator("#tab-problems").click();
    const chooser = page.waitForEvent("filechooser");
    await page.getByRole("button", { name: "Open SUB" }).click();
    await (await chooser).setFiles([file("sub.spf", SUB)]);
    await beside(page, "sub.spf").waitFor();
    await page.getByRole("button", { name: "Open SUB" }).waitFor({ state: "detached" });
    await run(page);
    await ends(page, TO_ITS_END);
    await context.close();
  });

  // oracle: hand
  test("tell what is wrong in them by their own name and line, and a click shows it there", async () => {
    const { context, page } = await start(chrome);
    await openAll(page, file("part.mpf", "G17 G54\nSUB(3)\nM30\n"), file("SUB.SPF", "PROC SUB(REAL A)\nR1=((2\nM17\n"));
    await page.locator("#tab-problems").click();
    const place = page.locator("#page-problems .place").filter({ hasText: "SUB.SPF: line 2" }).first();
    await place.waitFor();
    await place.click();
    await page.locator('.beside-file[data-shown]:has-text("SUB.SPF")').waitFor();
    await page.locator('.cm-activeLine:has-text("R1=((2")').waitFor();
    await context.close();
  });

  // oracle: hand
  test("say that a file and its PROC have different names", async () => {
    const { context, page } = await start(chrome);
    await openAll(page, file("part.mpf", "G17 G54\nOTHER(3)\nM30\n"), file("OTHER.SPF", SUB));
    await page.locator("#tab-problems").click();
    await page.locator('#page-problems .problem-text:has-text("its file name, OTHER")').waitFor();
    await context.close();
  });

  // oracle: hand (the definition that is there before the click)
  test("with definitions become part of the machine, which is said before and can be undone", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await openAll(page, file("part.mpf", "G17 G54\nR1=LIMIT[1]\nM30\n"));
    await input(page).setInputFiles([file("GUD4.DEF", DEF)]);
    await page.locator('.notice:has-text("Files added.")').waitFor();
    await page.getByRole("button", { name: "Add to machine" }).click();
    const dialog = page.locator("dialog.define[open]");
    await dialog.locator(".define-lines").getByText("DEF NCK REAL LIMIT[3]=SET(1,7.5,2)", { exact: true }).waitFor();
    await page.addScriptTag({ path: axe });
    const { violations } = await page.evaluate(() => globalThis.axe.run("dialog.define"));
    assert.deepEqual(violations, []);
    await dialog.getByRole("button", { name: "Add to machine" }).click();
    await beside(page, "GUD4.DEF").waitFor({ state: "detached" });
    await keptWhen(page, state => state.setups?.sinumerik?.definitions?.length === 1);
    await run(page);
    await ends(page, TO_ITS_END);
    await page.locator(".top").getByRole("button", { name: "Undo" }).first().click();
    await beside(page, "GUD4.DEF").waitFor();
    await keptWhen(page, state => !state.setups?.sinumerik?.definitions?.length);
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("a run is given", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("values for the parameters of the program itself", async () => {
    const { context, page } = await start(chrome);
    await openAll(page, file("sub.spf", "PROC SUB(REAL DEPTH, INT COUNT=2)\nR1=DEPTH+COUNT\nM17\n"));
    await run(page);
    await ends(page, "The program stopped in line 2.");
    await page.locator("#tab-problems").click();
    await page.locator("#page-problems").getByRole("button", { name: "Enter value" }).click();
    await focused(page, "#given-DEPTH");
    await page.keyboard.type("5,5");
    await page.keyboard.press("Tab");
    await page.locator('.ended:has-text("ran to its end")').waitFor();
    await keptWhen(page, state => state.given?.sinumerik?.DEPTH === "5,5");
    await context.close();
  });

  // oracle: hand
  test("values of the machine, and without them it says what it assumed", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await openAll(page, file("part.mpf", "G17 G54\nIF $A_IN[3]==1\nR1=1\nENDIF\nM30\n"));
    await run(page);
    const assumed = page.locator('.lack[data-lack="values"]');
    await assumed.filter({ hasText: "$A_IN[3] = 0 (line 2)" }).waitFor();
    await assumed.getByRole("button", { name: "Enter values" }).click();
    const field = page.locator('[data-value="$A_IN[3]"] input');
    await focused(page, field);
    await field.fill("1");
    await field.press("Tab");
    await page.locator('[data-value="$A_IN[3]"][data-typed="true"]:has-text("line 2")').waitFor();
    await page.addScriptTag({ path: axe });
    const { violations } = await page.evaluate(() => globalThis.axe.run(".machine-values"));
    assert.deepEqual(violations, []);
    await page.locator("dialog.machine-data").getByRole("button", { name: "Done" }).click();
    await assumed.waitFor({ state: "detached" });
    await keptWhen(page, state => state.own?.sinumerik?.own?.data?.["$A_IN[3]"] === 1);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (each line as it is in its own file)
  test("files, and what came out is told by their names and lines", async () => {
    const { context, page, problems } = await start(chrome);
    const measuring = "PROC SUB(REAL A)\nM77\n_MVAR=1 _SETVAL=132 _PRNUM=1 _FA=2 _TSA=1 _KNUM=0\nCYCLE977\nL105\nM17\n";
    await openAll(page, file("part.mpf", "G17 G54 T1 D1 M5\nSUB(3)\nM30\n"), file("SUB.SPF", measuring));
    await run(page);
    await page.locator('.ended:has-text("M77 (SUB.SPF:2)")').waitFor();
    await page.locator('.whole-row:has-text("SUB.SPF:4")').waitFor();
    const download = page.waitForEvent("download");
    await page.locator('.whole-top button:has-text("CSV")').click();
    const table = await readFile(await (await download).path(), "utf8");
    assert.match(table, /^1,SUB\.SPF:4,CYCLE977,/m);
    await page.getByLabel("Stop if anything is missing").check();
    await page.locator('.ended:has-text("stopped in SUB.SPF, line 5")').waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("the wish to stop at what is missing", async () => {
    const { context, page } = await start(chrome);
    await openAll(page, file("part.mpf", "G17 G54\nR1=$A_IN[3]\nSUB(3)\nM30\n"));
    await run(page);
    await page.locator('.ended:has-text("ran to its end")').waitFor();
    await page.getByLabel("Stop if anything is missing").check();
    await page.locator('.ended:has-text("stopped in line 2")').waitFor();
    await page.getByLabel("Stop if anything is missing").uncheck();
    await page.locator('.ended:has-text("ran to its end")').waitFor();
    await context.close();
  });

  // oracle: self (room.mjs) and axe-core
  for (const viewport of [
    { width: 1280, height: 800 },
    { width: 768, height: 1024 },
    { width: 390, height: 844 },
  ])
    test(`all of it with room for it at ${viewport.width}`, async () => {
      const { context, page } = await startAnywhere(chrome, { viewport, bypassCSP: true });
      const panel = async name => {
        const tab = page.locator(`.panel-bar [data-panel-button="${name}"]`);
        if (await tab.isVisible()) await tab.click();
      };
      await openAll(
        page,
        file("part.mpf", "PROC PART(REAL DEPTH=3, STRING[20] A_NAME)\nR1=$A_IN[3]+$A_IN[4]\nSUB(3)\nL105\nM30\n"),
        file("SUB.SPF", SUB),
        file("A_VERY_LONG_NAME_OF_DEFINITIONS.DEF", DEF),
      );
      await panel("program");
      await beside(page, "SUB.SPF").waitFor();
      assert.deepEqual(await faults(page), []);
      await panel("view");
      await page.locator(".segments").getByRole("button", { name: "Whole program" }).click();
      await panel("results");
      const dock = page.locator('.dock-tabs [data-dock="results"], .panel-bar [data-panel-button="results"]').first();
      if (await dock.isVisible()) await dock.click();
      await page.locator(".lacks .lack").first().waitFor();
      assert.deepEqual(await faults(page), []);
      await page.addScriptTag({ path: axe });
      const { violations } = await page.evaluate(() =>
        globalThis.axe.run({ include: [[".panel-program"], [".panel-results"]] }),
      );
      assert.deepEqual(violations, []);
      await context.close();
    });
});
