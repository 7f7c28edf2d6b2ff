// Whether a program is saved can be seen, and saving writes where it came from.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { address, shared } from "./browser.mjs";
import { drawn, lengthField, openTasks, startWithEditor as start } from "./start.mjs";

const CALL = "_MVAR=1 _SETVAL=132 _TNUM=20 _KNUM=2001\r\nCYCLE977\r\n";
const mark = page => page.locator(".panel-program .unsaved");

/** The title of the window, once it is this one; the mark beside the name says the same. */
async function titled(page, title) {
  await page.waitForFunction(wanted => document.title === wanted, title);
  assert.equal(await mark(page).isVisible(), title.startsWith("● "));
}

async function openFile(page, name, content) {
  const buffer = Buffer.from(content);
  await page.locator(".panel-program input[type=file]").setInputFiles({ name, mimeType: "text/plain", buffer });
  await page.waitForFunction(wanted => document.title.includes(wanted), name);
}

async function download(page, run) {
  const coming = page.waitForEvent("download");
  await run();
  const done = await coming;
  return { name: done.suggestedFilename(), text: (await readFile(await done.path())).toString() };
}

const save = page => page.locator(".panel-program").getByRole("button", { name: "Save", exact: true }).click();

describe("the title of the window", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("names the file, and says what is not saved, at every way to change it", async () => {
    const { context, page, problems } = await start(chrome);
    await titled(page, "program.mpf — Probewright");
    await openFile(page, "FLANGE.MPF", `; FLANGE\r\n${CALL}`);
    await titled(page, "FLANGE.MPF — Probewright");

    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+Home");
    await page.keyboard.type("N1 ");
    await titled(page, "● FLANGE.MPF — Probewright");
    await page.keyboard.press("Control+z");
    await titled(page, "FLANGE.MPF — Probewright");

    await page.locator(".call-row").click();
    await page.locator(".opened").waitFor();
    await lengthField(page).fill("99");
    await titled(page, "● FLANGE.MPF — Probewright");
    await page.reload();
    await page.locator(".cm-content").waitFor();
    await titled(page, "● FLANGE.MPF — Probewright");
    await download(page, () => save(page));
    await titled(page, "FLANGE.MPF — Probewright");
    await page.waitForTimeout(500); // kept
    await page.reload();
    await page.locator(".cm-content").waitFor();
    await titled(page, "FLANGE.MPF — Probewright");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("belongs to the program that Undo brings back", async () => {
    const { context, page } = await start(chrome);
    await openFile(page, "A.MPF", CALL);
    await page.locator(".cm-content").focus();
    await page.keyboard.type("N1 ");
    await titled(page, "● A.MPF — Probewright");
    await openFile(page, "B.MPF", `; B\n${CALL}`);
    await titled(page, "B.MPF — Probewright");
    await page.locator(".notice").getByRole("button", { name: "Undo" }).click();
    await titled(page, "● A.MPF — Probewright");
    await context.close();
  });

  // oracle: hand: other bytes are another file, the same bytes in another reading are not
  test("knows another encoding from another reading", async () => {
    const { context, page } = await start(chrome);
    await openFile(page, "A.MPF", `; \u00e4\n${CALL}`);
    const encoding = page.locator(".encoding");
    await encoding.selectOption("save utf-16le");
    await titled(page, "● A.MPF — Probewright");
    await encoding.selectOption("save utf-8");
    await titled(page, "A.MPF — Probewright");
    await encoding.selectOption("read latin-1");
    await page.locator('.cm-line:has-text("\u00c3")').waitFor();
    await titled(page, "A.MPF — Probewright");
    await context.close();
  });
});

/** A file of the system: what is written to it can be read in `disk`, and another program may write there too. */
const withDisk = context =>
  context.addInitScript(() => {
    const disk = {
      bytes: new TextEncoder().encode("; \u00e4\r\nN1 M0\nM30\r\n"),
      changed: 1000,
      allows: "granted",
      asked: 0,
    };
    disk.handle = {
      name: "FLANGE.MPF",
      getFile: async () => new File([disk.bytes], "FLANGE.MPF", { lastModified: disk.changed }),
      requestPermission: async () => {
        disk.asked++;
        return disk.allows;
      },
      createWritable: async () => {
        const parts = [];
        return {
          write: async bytes => parts.push(bytes),
          close: async () => {
            disk.bytes = new Uint8Array(await new Blob(parts).arrayBuffer());
            disk.changed++;
          },
        };
      },
    };
    globalThis.disk = disk;
    globalThis.showOpenFilePicker = async () => [disk.handle];
  });

const onDisk = page => page.evaluate(() => new TextDecoder("latin1").decode(disk.bytes));
const latin1 = text => Buffer.from(text).toString("latin1");
const notice = (page, text) => page.locator(".notice", { hasText: text }).waitFor();

async function startWithDisk(chrome) {
  const context = await chrome.browser.newContext({ locale: "en-GB", serviceWorkers: "block" });
  await withDisk(context);
  const page = await context.newPage();
  await page.goto(`${address}#measure`);
  await page.locator(".cm-content").waitFor();
  await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
  return { context, page };
}

describe("a file that was picked", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand (the bytes on disk, with what was typed)
  test("is opened and saved by keys, in place, with its encoding and line ends", async () => {
    const { context, page } = await startWithDisk(chrome);
    await openTasks(page);
    await page.locator("#task-search").focus();
    await page.keyboard.press("Control+o");
    await titled(page, "FLANGE.MPF — Probewright");
    assert.equal(await page.evaluate(() => disk.asked), 0, "reading asks for nothing more");
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+End");
    await page.keyboard.type("; X");
    await titled(page, "● FLANGE.MPF — Probewright");
    await page.keyboard.press("Control+s");
    await notice(page, "Saved to the file.");
    await titled(page, "FLANGE.MPF — Probewright");
    await page.keyboard.press("Control+z"); // takes back what was typed, not that it was saved
    await titled(page, "● FLANGE.MPF — Probewright");
    await page.keyboard.press("Control+y");
    await titled(page, "FLANGE.MPF — Probewright");
    assert.equal(await onDisk(page), latin1("; \u00e4\r\nN1 M0\nM30\r\n; X"));

    // the same file in another reading is still that file
    await page.locator(".encoding").selectOption("read latin-1");
    await page.locator('.cm-line:has-text("\u00c3")').waitFor();
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+End");
    await page.keyboard.type("Y");
    await titled(page, "● FLANGE.MPF — Probewright");
    await page.keyboard.press("Control+s");
    await titled(page, "FLANGE.MPF — Probewright");
    assert.equal(await onDisk(page), latin1("; \u00e4\r\nN1 M0\nM30\r\n; XY"));
    await context.close();
  });

  const hindrances = {
    "the user does not allow it": [() => Object.assign(disk, { allows: "denied" }), "No permission"],
    "another program wrote there": [
      () => Object.assign(disk, { changed: 5000, bytes: new TextEncoder().encode("OTHER") }),
      "Another program",
    ],
    "it cannot be written": [
      () => Object.assign(disk.handle, { createWritable: () => Promise.reject(new Error("disk")) }),
      "could not be written",
    ],
  };
  for (const [why, [hinder, told]] of Object.entries(hindrances)) {
    // oracle: hand
    test(`is left alone where ${why}, and the program is saved as a download`, async () => {
      const { context, page } = await startWithDisk(chrome);
      await page.locator(".panel-program").getByRole("button", { name: "Open", exact: true }).click();
      await titled(page, "FLANGE.MPF — Probewright");
      await page.locator(".cm-content").focus();
      await page.keyboard.press("Control+End");
      await page.keyboard.type("; X");
      await page.evaluate(hinder);
      const before = await onDisk(page);
      const copy = await download(page, () => page.keyboard.press("Control+s"));
      assert.deepEqual(copy, { name: "FLANGE.MPF", text: "; \u00e4\r\nN1 M0\nM30\r\n; X" });
      await notice(page, told);
      assert.equal(await onDisk(page), before);
      await context.close();
    });
  }

  // oracle: hand
  test("is not written when another file was opened since, nor after a picker that was closed", async () => {
    const { context, page } = await startWithDisk(chrome);
    await page.keyboard.press("Control+o");
    await titled(page, "FLANGE.MPF — Probewright");
    const before = await onDisk(page);
    await openFile(page, "B.MPF", CALL);
    await page.evaluate(() => {
      globalThis.showOpenFilePicker = () => Promise.reject(new DOMException("closed", "AbortError"));
    });
    await page.keyboard.press("Control+o");
    assert.deepEqual(await download(page, () => page.keyboard.press("Control+s")), { name: "B.MPF", text: CALL });
    assert.equal(await onDisk(page), before);
    await page.locator(".notice").getByRole("button", { name: "Undo" }).click();
    await titled(page, "FLANGE.MPF — Probewright");
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+End");
    await page.keyboard.type("Z");
    await page.keyboard.press("Control+s");
    await notice(page, "Saved to the file.");
    assert.match(await onDisk(page), /Z$/);
    await context.close();
  });

  // oracle: hand
  test("is one of the browser's own where it has no picker that lets the page write", async () => {
    const { context, page } = await startWithDisk(chrome);
    await page.evaluate(() => {
      globalThis.showOpenFilePicker = undefined;
    });
    const coming = page.waitForEvent("filechooser");
    await drawn(page); // by then the browser hands its pickers over
    await page.keyboard.press("Control+o");
    const chooser = await coming;
    await chooser.setFiles({ name: "C.MPF", mimeType: "text/plain", buffer: Buffer.from(CALL) });
    await titled(page, "C.MPF — Probewright");
    await context.close();
  });
});
