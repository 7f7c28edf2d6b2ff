// What is opened and saved: programs as bytes, setups, named values; nothing is lost by a wrong file or a wrong click.
import assert from "node:assert/strict";
import { mkdtemp, readFile, rmdir } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { fromFormMenu, fromMachineMenu, lengthField, openErrors, startWithEditor as start } from "./start.mjs";

const programInput = page => page.locator(".panel-program input[type=file]");
const setupInput = page => page.locator(".top input[type=file]");
const file = (name, content, mimeType = "application/octet-stream") => ({
  name,
  mimeType,
  buffer: Buffer.from(content),
});
const refusal = page => page.locator(".refusal:visible .problem");

async function saved(page, panel, name) {
  const download = page.waitForEvent("download");
  if (panel === ".top") await fromMachineMenu(page, name);
  else await page.locator(panel).getByRole("button", { name, exact: true }).click();
  const done = await download;
  return { name: done.suggestedFilename(), bytes: await readFile(await done.path()) };
}

/** Drops a file onto an element, as a person does. */
async function drop(page, selector, name, text) {
  const data = await page.evaluateHandle(
    ([called, content]) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([content], called));
      return transfer;
    },
    [name, text],
  );
  for (const type of ["dragover", "drop"]) await page.dispatchEvent(selector, type, { dataTransfer: data });
}

/** Drops what lies at a path, as the system does: only so does the browser know a folder. */
async function dropPath(context, page, path) {
  const session = await context.newCDPSession(page);
  const { x, y } = await page.locator(".cm-content").boundingBox();
  const data = { items: [], files: [path], dragOperationsMask: 1 };
  for (const type of ["dragEnter", "dragOver", "drop"])
    await session.send("Input.dispatchDragEvent", { type, x: x + 5, y: y + 5, data });
}

const CALL = "_MVAR=1 _SETVAL=132 _TNUM=20 _KNUM=2001\r\nCYCLE977\r\n";
const ALL_BYTES = Buffer.concat([
  Buffer.from(Array.from({ length: 256 }, (_, byte) => byte)),
  Buffer.from(`\r\n${CALL}`),
]);

describe("a program file", () => {
  const chrome = shared("neither", { before, after });

  const files = {
    "CR LF": Buffer.from(`; \u00e4\r\n${CALL}M30\r\n`),
    "all line ends mixed": Buffer.from(`A\r\rB\n\r\n${CALL}C\r`),
    "a mark at the begin": Buffer.from(`\ufeff; \u6d4b\u91cf\n${CALL}`),
    "no UTF-8 (GB 18030)": Buffer.concat([Buffer.from([0x3b, 0xb2, 0xe2, 0xc1, 0xbf, 0x0d, 0x0a]), Buffer.from(CALL)]),
    "every byte there is": ALL_BYTES,
    nothing: Buffer.alloc(0),
  };
  for (const [name, bytes] of Object.entries(files)) {
    // oracle: hand (the bytes opened)
    test(`is saved with the same bytes: ${name}`, async () => {
      const { context, page, problems } = await start(chrome);
      await programInput(page).setInputFiles(file("part one.mpf", bytes));
      const told = bytes.length > 0 ? "Program opened." : "Opened: the file is empty.";
      await page.locator(`.notice:has-text("${told}")`).waitFor();
      const back = await saved(page, ".panel-program", "Save");
      assert.deepEqual(back.bytes, bytes);
      assert.equal(back.name, "part one.mpf");
      assert.deepEqual(problems, []);
      await context.close();
    });
  }

  // oracle: hand (the bytes opened, with one value replaced)
  test("that is no UTF-8 changes at one value only", async () => {
    const { context, page } = await start(chrome);
    await programInput(page).setInputFiles(file("a.mpf", files["no UTF-8 (GB 18030)"]));
    await page.locator(".call-row").click();
    await page.locator(".opened").waitFor();
    await page.locator('.field[data-field="_SETVAL"] .entry-line > .figure').fill("99");
    await page.locator('.cm-line:has-text("_SETVAL=99")').waitFor();
    const { bytes } = await saved(page, ".panel-program", "Save");
    assert.equal(bytes.toString("latin1"), files["no UTF-8 (GB 18030)"].toString("latin1").replace("=132", "=99"));
    await context.close();
  });

  // oracle: hand (the bytes opened, with what was typed behind the mark)
  test("keeps the mark at its begin when its first line is changed", async () => {
    const { context, page } = await start(chrome);
    await programInput(page).setInputFiles(file("a.mpf", files["a mark at the begin"]));
    await page.locator(".call-row").waitFor();
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+Home");
    await page.keyboard.type("N1 ");
    await page.locator('.cm-line:has-text("N1 ;")').waitFor();
    const { bytes } = await saved(page, ".panel-program", "Save");
    assert.equal(bytes.toString(), `\ufeffN1 ; \u6d4b\u91cf\n${CALL}`);
    await context.close();
  });

  // oracle: hand
  test("that is a folder is told, and the program stays", async () => {
    const { context, page } = await start(chrome);
    const earlier = await saved(page, ".panel-program", "Save");
    const folder = await mkdtemp(join(tmpdir(), "folder-"));
    await dropPath(context, page, folder);
    await page.getByText("it is a folder", { exact: false }).waitFor();
    assert.deepEqual(await saved(page, ".panel-program", "Save"), earlier);
    await context.close();
    await rmdir(folder);
  });

  // oracle: hand
  test("dropped onto the editor replaces the program, and Undo brings it back", async () => {
    const { context, page } = await start(chrome);
    const earlier = await saved(page, ".panel-program", "Save");
    await drop(page, ".cm-content", "dropped.mpf", `; dropped\n${CALL}`);
    await page.locator('.cm-line:has-text("; dropped")').waitFor();
    assert.equal((await saved(page, ".panel-program", "Save")).bytes.toString(), `; dropped\n${CALL}`);
    await page.locator(".notice").getByRole("button", { name: "Undo" }).click();
    await page.locator('.cm-line:has-text("; dropped")').waitFor({ state: "detached" });
    assert.deepEqual(await saved(page, ".panel-program", "Save"), earlier);
    await context.close();
  });

  const NO_PROGRAMS = {
    "drawing.pdf": ["%PDF-1.7\n1 0 obj\n", /drawing\.pdf was not opened: it is a PDF document/],
    "photo.png": ["\x89PNG\r\n\x1a\n\0\0\0\rIHDR", /photo\.png was not opened: it is a picture/],
    "job.mpf": ["PK\x03\x04\x14\0\x08\0", /job\.mpf was not opened: it is an archive, such as ZIP/],
    "page.mpf": ["<html><body>hello</body></html>", /page\.mpf was not opened: it is HTML, not a program/],
    "site.nc": ["\n <!DOCTYPE html>\n<p>G1 X1", /site\.nc was not opened: it is HTML, not a program/],
    "data.spf": ['<?xml version="1.0"?>\n<part/>', /data\.spf was not opened: it is XML, not a program/],
    "setup.mpf": ['{\n  "units": "mm"\n}', /setup\.mpf was not opened: it is JSON, not a program/],
    "note.mpf": ["{\\rtf1\\ansi G1 X1}", /note\.mpf was not opened: it is an office document/],
    "tool.mpf": ["MZ\x90\0\x03\0\0\0\x04\0\0\0\xff\xff\0\0", /tool\.mpf was not opened: it contains no text/],
  };
  // oracle: hand (the beginnings that the formats prescribe)
  test("that is no program is refused with what it is, and nothing of the work is lost", async () => {
    const { context, page, problems } = await start(chrome);
    await lengthField(page).fill("77");
    await page.locator('.cm-line:has-text("77")').first().waitFor();
    const earlier = await saved(page, ".panel-program", "Save");
    const call = await page.locator(".opened").textContent();
    for (const [name, [content, told]] of Object.entries(NO_PROGRAMS)) {
      await programInput(page).setInputFiles(file(name, Buffer.from(content, "latin1")));
      await refusal(page).filter({ hasText: name }).waitFor();
      assert.match(await refusal(page).textContent(), told);
      assert.match(await refusal(page).textContent(), /Your program is unchanged\./);
    }
    assert.deepEqual(await saved(page, ".panel-program", "Save"), earlier);
    assert.equal(await page.locator(".opened").textContent(), call);
    assert.equal(await lengthField(page).inputValue(), "77");
    assert.deepEqual(problems, []);
    await context.close();
  });

  const LETTER = "Dear colleague,\n\nplease find the drawing of part A4 in the folder: it is new.\n\nRegards\nAnna\n";
  const PROGRAMS = [
    "%_N_BORE_MPF\n;$PATH=/_N_WKS_DIR/_N_A_WPD\nM30\n",
    "; only a comment\n",
    "R1=5\n",
    "BORE(5)\n",
    'FEHLER:\nMSG("x")\n',
    "SUPA D0 G0 Z200\n",
    "#100=5\n",
  ];
  // oracle: hand
  test("in which no line reads as a block is opened with a word about it; programs are without", async () => {
    const { context, page, problems } = await start(chrome);
    await programInput(page).setInputFiles(file("letter.txt", LETTER));
    await refusal(page).filter({ hasText: "letter.txt was opened, but no line in it reads as a block" }).waitFor();
    await page.locator('.refusal:visible .problem[data-severity="warning"]').waitFor();
    await page.locator('.cm-line:has-text("Dear colleague")').waitFor();
    for (const [at, text] of PROGRAMS.entries()) {
      await programInput(page).setInputFiles(file(`part${at}.mpf`, text));
      await page.locator(`.file-name:text-is("part${at}.mpf")`).waitFor();
      await refusal(page).waitFor({ state: "hidden" });
    }
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("that is refused while help covers the program is told all the same", async () => {
    const { context, page, problems } = await start(chrome);
    await page.getByRole("button", { name: "Help", exact: true }).first().click();
    await page.locator("#panel-help[data-shown]").waitFor();
    await drop(page, ".panel-form", "drawing.pdf", "%PDF-1.7\n");
    await page.locator(".panel-program .refusal:visible").waitFor();
    assert.equal(await page.locator(".panel-program").getAttribute("inert"), null);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("that the browser cannot hold is refused in the program panel, and the program stays", async () => {
    const { context, page } = await start(chrome);
    const earlier = await saved(page, ".panel-program", "Save");
    await page.evaluate(() => {
      const transfer = new DataTransfer();
      const large = new File(["x"], "large.mpf");
      Object.defineProperty(large, "size", { value: 9e9 });
      transfer.items.add(large);
      const input = document.querySelector(".panel-program input[type=file]");
      Object.defineProperty(input, "files", { value: [large] });
      input.dispatchEvent(new Event("change"));
    });
    assert.match(await refusal(page).textContent(), /large\.mpf was not opened: it has 9000\u00a0MB, more than/);
    await counts(page.locator(".panel-program .refusal:visible"), 1);
    assert.deepEqual(await saved(page, ".panel-program", "Save"), earlier);
    await page.locator(".panel-program .refusal button.quiet").click();
    await page.locator(".panel-program .refusal").waitFor({ state: "hidden" });
    await context.close();
  });

  // oracle: manual (C:1159): the beginning of a file tells its control
  test("of another control is opened, and the way there shown", async () => {
    const { context, page, problems } = await start(chrome);
    await programInput(page).setInputFiles(file("bore.nc", "O1000\nG17 T9 H1\nM19\nM59\nG110 D50 S1\nM30\n"));
    assert.match(await refusal(page).textContent(), /bore\.nc was opened\. It begins like a program for NCT/);
    await counts(page.locator(".call-row"), 0);
    await page.getByRole("button", { name: "Open under NCT" }).click();
    await page.locator(".call-row").waitFor();
    assert.match(await page.locator("#form-title").textContent(), /\S/);
    await counts(page.locator(".refusal:visible"), 0);
    const { name, bytes } = await saved(page, ".panel-program", "Save");
    assert.equal(name, "bore.nc");
    assert.match(bytes.toString(), /^O1000\nG17 T9 H1\n/);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("of any length survives a reload", async () => {
    const { context, page, problems } = await start(chrome);
    const text = `${"N10 G1 X1.5 Y2\r\n".repeat(100_000)}${CALL}`;
    await page.evaluate(() => {
      const put = IDBObjectStore.prototype.put;
      IDBObjectStore.prototype.put = function (...args) {
        this.transaction.addEventListener("complete", () => {
          globalThis.kept = true;
        });
        return put.apply(this, args);
      };
    });
    await programInput(page).setInputFiles(file("long.mpf", text));
    await page.waitForFunction(() => globalThis.kept);
    await page.reload();
    await page.locator(".cm-content").waitFor();
    await page.locator(".call-row").waitFor();
    assert.equal((await saved(page, ".panel-program", "Save")).bytes.toString(), text);
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("a setup file", () => {
  const chrome = shared("neither", { before, after });

  // oracle: self (the file that the page wrote)
  test("comes back the same in another browser", async () => {
    const { context, page } = await start(chrome);
    await openErrors(page);
    await page.locator("#error-probe-skew-x").fill("0.1");
    await page.locator("#error-part-dx").fill("0.5");
    await page.locator('.results td:text-is("0.0300")').first().waitFor();
    const first = await saved(page, ".top", "Export setup");
    const setup = JSON.parse(first.bytes.toString());
    assert.equal(setup.probe.skew[0], 0.1);
    await context.close();
    const other = await start(chrome);
    await setupInput(other.page).setInputFiles({
      name: "setup.json",
      mimeType: "application/json",
      buffer: first.bytes,
    });
    await other.page.locator('.notice:has-text("Setup opened.")').waitFor();
    const second = await saved(other.page, ".top", "Export setup");
    assert.equal(second.bytes.toString(), first.bytes.toString());
    assert.deepEqual(other.problems, []);
    await fromMachineMenu(other.page, /^Default machine/);
    await other.page.locator('.notice:has-text("Default machine restored.")').waitFor();
    await other.context.close();
  });

  const wrong = {
    "no JSON": ["x.json", "G0 X0", /x\.json is not a setup and was not opened: .*line 1, column 1/],
    "another schema": [
      "package.json",
      '{ "name": "x", "version": 1 }',
      /package\.json is not a setup and was not opened: .*name/,
    ],
    "a control that there is not": [
      "f.json",
      '{ "control": "fanuc", "probe": { "radius": 1, "length": 1 } }',
      /not a setup and was not opened: .*fanuc/,
    ],
    binary: ["b.json", Buffer.from([0, 255, 254, 1, 2]), /b\.json was not opened: it contains no text/],
    "far too large": [
      "large.json",
      Buffer.alloc(4_500_000, 32),
      /large\.json was not opened: it has 5\u00a0MB, but a setup may have at most 4\u00a0MB\./,
    ],
  };
  for (const [name, [called, content, told]] of Object.entries(wrong)) {
    // oracle: hand
    test(`that is ${name} is refused below the header, and nothing is lost`, async () => {
      const { context, page, problems } = await start(chrome);
      await lengthField(page).fill("31.25");
      await page.locator('.snippet:has-text("31.25")').waitFor();
      const earlier = await saved(page, ".top", "Export setup");
      await setupInput(page).setInputFiles(file(called, content, "application/json"));
      await refusal(page).waitFor();
      assert.match(await refusal(page).textContent(), told);
      assert.deepEqual(await saved(page, ".top", "Export setup"), earlier);
      assert.equal(await lengthField(page).inputValue(), "31.25");
      await counts(page.locator("#broken"), 0);
      assert.deepEqual(problems, []);
      await context.close();
    });
  }
});

describe("a kept setup", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("of another version is left out and told, and the page works", async () => {
    const { context, page, problems } = await start(chrome);
    await page.waitForFunction(() => localStorage.getItem("probewright-1"));
    await page.addInitScript(() => {
      const kept = JSON.parse(localStorage.getItem("probewright-1"));
      localStorage.setItem("probewright-1", JSON.stringify({ ...kept, setup: { control: kept.control, gone: 1 } }));
    });
    await page.reload();
    await page.locator('.notice:has-text("The stored setup does not fit this version")').waitFor();
    await page.locator(".results tbody tr").first().waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("the page in two tabs", () => {
  const chrome = shared("neither", { before, after });
  const programs = page =>
    page.evaluate(() =>
      Object.values(JSON.parse(sessionStorage.getItem("probewright-1") ?? "{}").programs ?? {}).join(),
    );

  // oracle: hand
  test("comes back in each to its own work, and in a new one to the newest", async () => {
    const { context, page, problems } = await start(chrome);
    const other = await context.newPage();
    await other.goto(page.url());
    for (const [tab, text] of [
      [page, "; first tab"],
      [other, "; second tab"],
    ]) {
      await tab.bringToFront();
      await tab.locator(".cm-content").click();
      await tab.keyboard.type(text);
      await tab.waitForFunction(text => sessionStorage.getItem("probewright-1")?.includes(text), text);
    }
    await page.reload();
    await page.locator('.cm-line:has-text("; first tab")').waitFor();
    assert.doesNotMatch(await programs(page), /second tab/);
    const third = await context.newPage();
    await third.goto(page.url());
    await third.locator(".cm-content").waitFor();
    await third.waitForFunction(() => sessionStorage.getItem("probewright-1"));
    assert.match(await programs(third), /; (first|second) tab/);
    await other.reload();
    await other.locator('.cm-line:has-text("; second tab")').waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("work that is replaced", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("by the worked example comes back with Ctrl+Z, and goes again with Ctrl+Y", async () => {
    const { context, page } = await start(chrome);
    await lengthField(page).fill("31.25");
    await fromFormMenu(page, "Worked example");
    await page.waitForFunction(() => document.querySelector(".snippet").textContent.includes("31.25") === false);
    await page.keyboard.press("Control+z");
    await page.locator('.snippet:has-text("31.25")').waitFor();
    assert.equal(await lengthField(page).inputValue(), "31.25");
    await page.keyboard.press("Control+y");
    await page.waitForFunction(() => document.querySelector(".snippet").textContent.includes("31.25") === false);
    await context.close();
  });

  // oracle: hand
  test("is brought back after a later edit, which is not offered beside the notice of another", async () => {
    const { context, page } = await start(chrome);
    const first = await lengthField(page).inputValue();
    await lengthField(page).fill("12.5");
    await fromFormMenu(page, "Worked example");
    await page.locator(".notice").getByRole("button", { name: "Undo" }).waitFor();
    await lengthField(page).fill("31.25");
    await page.locator(".notice").getByRole("button", { name: "Undo" }).waitFor({ state: "hidden" });
    await page.locator("#theme").focus();
    await page.keyboard.press("Control+z");
    assert.notEqual(await lengthField(page).inputValue(), "31.25");
    await page.keyboard.press("Control+z");
    assert.equal(await lengthField(page).inputValue(), "12.5");
    await page.keyboard.press("Control+z");
    assert.equal(await lengthField(page).inputValue(), first);
    await context.close();
  });
});

describe("value sets", () => {
  const chrome = shared("neither", { before, after });
  const names = page => page.locator(".sets input").evaluateAll(inputs => inputs.map(input => input.value));

  // oracle: hand
  test("are saved, loaded, renamed and deleted by keyboard alone, and survive a reload", async () => {
    const { context, page, problems } = await start(chrome);
    const press = async (...keys) => {
      for (const key of keys) await page.keyboard.press(key);
    };
    const openSets = async () => {
      await page.locator("#form-menu-open").focus();
      await press("Enter");
      await page.getByRole("button", { name: "Value sets" }).focus();
      await press("Enter");
      await page.locator("dialog .sets-new").waitFor();
    };
    await lengthField(page).fill("31.25");
    await openSets();
    await page.keyboard.type("small hole");
    await press("Enter");
    await page.locator(".sets li").waitFor();
    await press("Escape");
    await lengthField(page).fill("77.5");
    await openSets();
    await page.keyboard.type("large hole");
    await press("Enter");
    await page.locator(".sets li").nth(1).waitFor();
    assert.deepEqual(await names(page), ["small hole", "large hole"]);
    await press("Escape");
    await page.waitForFunction(() => localStorage.getItem("probewright-1")?.includes("large hole"));
    await page.reload();
    await page.locator(".field").first().waitFor();
    await openSets();
    await press("Tab", "Tab"); // the button that saves, then the name of the first set
    await press("End");
    await page.keyboard.type(" A");
    await press("Tab");
    await page.locator('.sets button[aria-label="Load small hole A"]').waitFor();
    assert.deepEqual(await names(page), ["small hole A", "large hole"]);
    await page.locator('.sets button[aria-label="Load small hole A"]').focus();
    await press("Enter");
    await page.locator('.snippet:has-text("31.25")').waitFor();
    assert.equal(await lengthField(page).inputValue(), "31.25");
    await openSets();
    await page.locator('.sets button[aria-label="Delete large hole"]').focus();
    await press("Enter");
    await page.waitForFunction(() => document.querySelectorAll(".sets li").length === 1);
    await page.locator("dialog").getByRole("button", { name: "Undo" }).click();
    await page.waitForFunction(() => document.querySelectorAll(".sets li").length === 2);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("loaded into an opened call change the program there", async () => {
    const { context, page } = await start(chrome);
    await page.locator(".opened").waitFor();
    const field = await lengthField(page).evaluate(input => input.closest(".field").dataset.field);
    await fromFormMenu(page, "Value sets");
    await page.locator("#sets-name").fill("first");
    await page.keyboard.press("Enter");
    await page.locator(".sets li").waitFor();
    await page.keyboard.press("Escape");
    const earlier = await saved(page, ".panel-program", "Save");
    await lengthField(page).fill("77.5");
    await page.locator(`.cm-line:has-text("${field}=77.5")`).waitFor();
    await fromFormMenu(page, "Value sets");
    await page.locator('.sets button[aria-label="Load first"]').click();
    await page.locator(`.cm-line:has-text("${field}=77.5")`).waitFor({ state: "detached" });
    assert.deepEqual(await saved(page, ".panel-program", "Save"), earlier);
    await context.close();
  });
});
