// Long programs: read, changed and run beside the page, the newest question alone, and to be stopped.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { chooseLarge, counts, open, shared } from "./browser.mjs";
import { startWithEditor as start } from "./start.mjs";

const CALL = "_MVAR=1 _SETVAL=132 _TNUM=20 _KNUM=2001\r\nCYCLE977\r\n";
const BLOCK = "N10 G1 F1200 X12.345 Y-6.789\r\n";

/** A program of about 300 KB with three calls. */
const LONG = `${BLOCK.repeat(5000)}${CALL}${BLOCK.repeat(5000)}${CALL}${CALL}M30\r\n`;

const rows = page => page.locator(".call-row");
const chosen = text => ({ name: "part.mpf", mimeType: "text/plain", buffer: Buffer.from(text) });

const fileInput = page => page.locator(".panel-program input[type=file]");

const openFile = (page, text) => fileInput(page).setInputFiles(chosen(text));

const openLarge = (page, pieces) => chooseLarge(fileInput(page), "part.mpf", pieces);

const count = (page, wanted) =>
  page.waitForFunction(number => document.querySelectorAll(".call-row").length === number, wanted);

/** The program as the page saves it. */
async function saved(page) {
  const download = page.waitForEvent("download");
  await page.locator(".panel-program").getByRole("button", { name: "Save" }).click();
  return readFile(await (await download).path(), "utf8");
}

/** The program, once it is what is waited for: the form's values reach it through the worker. */
async function savedWhen(page, wanted) {
  for (let tries = 0; tries < 100; tries++) {
    if ((await saved(page)) === wanted) return;
    await page.waitForTimeout(50);
  }
  assert.equal(await saved(page), wanted);
}

/** Lets no worker start until it is called. */
async function hold(page) {
  let release;
  const held = new Promise(resolve => {
    release = resolve;
  });
  await page.route("**/worker-*.js", async route => {
    await held;
    await route.continue();
  });
  return release;
}

/** Lets no byte of a file arrive until it is called. */
async function holdFiles(page) {
  await page.evaluate(() => {
    const read = Blob.prototype.arrayBuffer;
    const held = new Promise(resolve => {
      globalThis.releaseFiles = resolve;
    });
    Blob.prototype.arrayBuffer = async function () {
      await held;
      return read.call(this);
    };
  });
  return () => page.evaluate(() => globalThis.releaseFiles());
}

describe("a long file", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand (the program before)
  test("that is stopped while it is opened leaves the program as it was", async () => {
    const { context, page, problems } = await start(chrome);
    const earlier = await saved(page);
    const release = await holdFiles(page);
    await openFile(page, LONG);
    const activity = page.locator(".activity[data-work=opening]");
    await activity.locator('text="Opening the program (0.3 MB) … The previous one remains until then."').waitFor();
    await activity.getByRole("button", { name: "Stop" }).click();
    await activity.waitFor({ state: "hidden" });
    await release();
    await page.waitForTimeout(300);
    assert.equal(await saved(page), earlier);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("loses nothing that is typed while it is opened: Undo brings it back", async () => {
    const { context, page, problems } = await start(chrome);
    const earlier = await saved(page);
    const release = await holdFiles(page);
    await openFile(page, LONG);
    await page.locator(".activity[data-work=opening]").waitFor();
    await page.locator(".cm-line").first().click();
    await page.keyboard.press("Control+Home");
    await page.keyboard.insertText("G110 H1\n");
    await release();
    await count(page, 3);
    assert.equal(await saved(page), LONG);
    await page.locator(".cm-line").first().click();
    await page.keyboard.press("Control+z");
    await page.locator('.cm-line:has-text("G110 H1")').waitFor();
    await page.keyboard.press("Control+y");
    await count(page, 3);
    assert.equal(await saved(page), LONG);
    await page.locator("#undo").click();
    await page.locator('.cm-line:has-text("G110 H1")').waitFor();
    assert.equal(await saved(page), `G110 H1\n${earlier}`);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the bytes)
  for (const [name, piece, times, end] of [
    ["of one line of ten million characters", "X12.3456 ", 1_111_111, `\r\n${CALL}`],
    ["of a million empty lines", "\n", 1_000_000, CALL],
  ])
    test(`${name} is opened, and its call found`, async () => {
      const { context, page, problems } = await start(chrome);
      await openLarge(page, [
        [piece, times],
        [end, 1],
      ]);
      await page.locator('.notice:has-text("Program opened.")').waitFor();
      await count(page, 1);
      assert.equal(await saved(page), piece.repeat(times) + end);
      await page.locator(".call-row").click();
      await page.locator('.cm-line:has-text("_SETVAL=132")').waitFor();
      assert.deepEqual(problems, []);
      await context.close();
    });

  // oracle: hand (a screen shows some dozen lines; without care all of them are laid out, and the page stands still)
  test("is laid out as far as it is seen, also where the editor is out of sight", async () => {
    const { context, page, problems } = await start(chrome);
    await page.setViewportSize({ width: 500, height: 300 });
    await page.locator(".panel-program").waitFor({ state: "hidden" });
    await page.evaluate(() => new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    await openFile(page, LONG);
    await page.locator(".cm-line").nth(3).waitFor({ state: "attached" });
    assert.ok((await page.locator(".cm-line").count()) < 500);
    await page.setViewportSize({ width: 1280, height: 800 });
    await count(page, 3);
    assert.equal(await saved(page), LONG);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the bytes)
  test("that is kept is put into the editor again beside the page", async () => {
    const { context, page, problems } = await start(chrome);
    await page.evaluate(() => {
      const put = IDBObjectStore.prototype.put;
      IDBObjectStore.prototype.put = function (...args) {
        this.transaction.addEventListener("complete", () => {
          globalThis.kept = true;
        });
        return put.apply(this, args);
      };
    });
    await openFile(page, LONG);
    await count(page, 3);
    await page.waitForFunction(() => globalThis.kept);
    await page.reload();
    await page.locator('.cm-line:has-text("N10 G1")').first().waitFor();
    await count(page, 3);
    assert.equal(await saved(page), LONG);
    await rows(page).nth(1).click();
    await page.locator('.cm-line:has-text("_SETVAL=132")').first().waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("a long program", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("is read in a worker that needs no second download of the core", async () => {
    const { context, page, problems } = await open(chrome.browser);
    await page.waitForLoadState("networkidle"); // what the first visit still fetches does not count
    const fetched = [];
    page.on("request", request => fetched.push(new URL(request.url()).pathname));
    await page.reload();
    await page.locator(".field").first().waitFor();
    assert.equal(fetched.filter(path => path.includes("worker")).length, 0, "the first form needs no worker");
    await openFile(page, LONG);
    await count(page, 3);
    assert.equal(fetched.filter(path => path.includes("/core_bg")).length, 1, "the core is fetched once");
    assert.equal(fetched.filter(path => /worker/.test(path)).length, 1);
    assert.equal(page.workers().length, 1);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("can be typed into while it is read, and the newest text counts", async () => {
    const { context, page, problems } = await start(chrome);
    const release = await hold(page);
    await openFile(page, LONG);
    await page.locator(".cm-line").first().click();
    await page.keyboard.press("Control+Home");
    await page.keyboard.insertText("G110 H1\nCYCLE978\n");
    await page.locator(".activity[data-work=reading] progress").waitFor();
    assert.equal(await page.locator(".cm-line").first().textContent(), "G110 H1");
    release();
    await count(page, 4);
    await page.locator(".activity[data-work=reading]").waitFor({ state: "hidden" });
    await page.locator('.call-row:has-text("CYCLE978"):has-text("line 2")').waitFor();
    assert.equal(await saved(page), `G110 H1\r\nCYCLE978\r\n${LONG}`);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the text before, with one value replaced)
  test("takes what is typed in the form at that place only, however fast it is typed", async () => {
    const { context, page, problems } = await start(chrome);
    await openFile(page, LONG);
    await count(page, 3);
    await rows(page).nth(1).click();
    await page.locator(".opened").waitFor();
    const field = page.locator('.field[data-field="_SETVAL"] .entry-line > .figure');
    for (const value of ["1", "13", "133", "133.", "133.5"]) await field.fill(value);
    const place = LONG.indexOf("_SETVAL=132", LONG.indexOf("CYCLE977"));
    await savedWhen(page, `${LONG.slice(0, place)}_SETVAL=133.5${LONG.slice(place + "_SETVAL=132".length)}`);
    assert.equal(await field.inputValue(), "133.5");
    await page.locator('.call-row[aria-selected="true"]').waitFor();
    await rows(page).first().click();
    await page.waitForFunction(() => document.querySelector('[data-field="_SETVAL"] .figure').value === "132");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("keeps the values of each call apart when another is opened before they are written", async () => {
    const { context, page } = await start(chrome);
    await openFile(page, LONG);
    await count(page, 3);
    await rows(page).nth(1).click();
    await page.locator(".opened").waitFor();
    await page.evaluate(() => {
      // within one frame, before anything is answered
      const field = document.querySelector('[data-field="_SETVAL"] .figure');
      field.value = "140";
      field.dispatchEvent(new Event("input", { bubbles: true }));
      document.querySelectorAll(".call-row")[2].click();
    });
    const place = LONG.indexOf("_SETVAL=132", LONG.indexOf("CYCLE977"));
    await savedWhen(page, `${LONG.slice(0, place)}_SETVAL=140${LONG.slice(place + "_SETVAL=132".length)}`);
    assert.equal(await page.locator('[data-field="_SETVAL"] .figure').inputValue(), "132");
    await context.close();
  });

  // oracle: hand
  test("tells how far the reading is, takes keys meanwhile, and can be stopped on the way", async () => {
    const { context, page, problems } = await start(chrome);
    const activity = page.locator(".activity[data-work=reading]");
    await page.evaluate(() => {
      globalThis.shares = [];
      const bar = document.querySelector(".activity[data-work=reading] progress");
      new MutationObserver(() => {
        if (bar.hasAttribute("value")) globalThis.shares.push(bar.value);
      }).observe(bar, { attributeFilter: ["value"] });
    });
    await openLarge(page, [
      [BLOCK, 1_500_000],
      [CALL, 1],
    ]);
    // within the page: from outside, the reading may be over before a button that has just come is taken as still
    const [said, typed] = await page.evaluate(async () => {
      for (let frames = 0; frames < 1200 && !globalThis.shares.some(share => share > 0); frames++)
        await new Promise(requestAnimationFrame);
      const box = document.querySelector(".activity[data-work=reading]");
      const text = box.textContent;
      const field = document.querySelector('.field[data-field="_SETVAL"] .entry-line > .figure');
      Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value").set.call(field, "133.5");
      field.dispatchEvent(new Event("input", { bubbles: true }));
      for (let frames = 0; frames < 2; frames++) await new Promise(requestAnimationFrame);
      [...box.querySelectorAll("button")].find(button => button.textContent === "Stop").click();
      return [text, field.value];
    });
    assert.match(said, /\d%/);
    assert.equal(typed, "133.5");
    await activity.locator('text="Reading was stopped. The calls of this program are not known."').waitFor();
    const shares = await page.evaluate(() => globalThis.shares);
    assert.deepEqual(
      shares,
      [...shares].sort((a, b) => a - b),
      "it only goes up",
    );
    assert.ok(shares.every(share => share <= 1));
    await activity.getByRole("button", { name: "Try again" }).click();
    await count(page, 1);
    await activity.waitFor({ state: "hidden" });
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("reading can be stopped and tried again", async () => {
    const { context, page } = await start(chrome);
    const release = await hold(page);
    await openFile(page, LONG);
    const activity = page.locator(".activity[data-work=reading]");
    await activity.getByRole("button", { name: "Stop" }).click();
    await activity.locator('text="Reading was stopped. The calls of this program are not known."').waitFor();
    await counts(rows(page), 0);
    release();
    await activity.getByRole("button", { name: "Try again" }).click();
    await count(page, 3);
    await activity.waitFor({ state: "hidden" });
    await context.close();
  });

  // oracle: hand (a run that waits does not end, one that goes on does)
  test("running can be paused and goes on", async () => {
    const { context, page, problems } = await start(chrome);
    const release = await hold(page);
    await page.getByRole("button", { name: "Whole program" }).click();
    const activity = page.locator(".panel-view .activity");
    await activity.getByRole("button", { name: "Pause" }).click();
    await activity.locator('text="The run is paused."').waitFor();
    release();
    await page.waitForTimeout(1000); // the worker is there by now, and waits
    assert.equal(page.workers().length, 1);
    await activity.locator('text="The run is paused."').waitFor();
    await activity.getByRole("button", { name: "Continue" }).click();
    await activity.waitFor({ state: "hidden" });
    await page.locator(".results tbody tr").first().waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("running can be stopped and tried again", async () => {
    const { context, page, problems } = await start(chrome);
    const release = await hold(page);
    await page.getByRole("button", { name: "Whole program" }).click();
    const activity = page.locator(".panel-view .activity");
    await activity.getByRole("button", { name: "Stop" }).click();
    await activity.locator('text="The run was stopped."').waitFor();
    release();
    await activity.getByRole("button", { name: "Try again" }).click();
    await page.locator(".results tbody tr").first().waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});
