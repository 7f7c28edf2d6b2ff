// Programs in every encoding: shown as what they say, saved with the bytes that were opened, but for what was changed.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { modules } from "./sources.mjs";
import { startWithEditor as start } from "./start.mjs";

const FOLDER = new URL("../encodings/", import.meta.url);
const NAMES = readdirSync(FOLDER).sort();
const bytesOf = name => readFileSync(new URL(name, FOLDER));
const programInput = page => page.locator(".panel-program input[type=file]");
const file = (name, content) => ({ name, mimeType: "application/octet-stream", buffer: Buffer.from(content) });
const choice = page => page.locator("select.encoding");
const shown = page =>
  page.evaluate(() =>
    [...document.querySelector(".editor").shadowRoot.querySelectorAll(".cm-line")]
      .map(line => line.textContent)
      .join("\n"),
  );

async function opened(page, name, content) {
  await programInput(page).setInputFiles(file(name, content));
  await page.locator('.notice:has-text("Program opened.")').waitFor();
  await page.locator(`.file-name:text-is("${name}")`).waitFor();
}

let saves = 0;

async function saved(page, button = "Save") {
  if (++saves % 8 === 0) await page.waitForTimeout(1500); // Chromium drops what is more than ten downloads at a time
  const download = page.waitForEvent("download");
  await page.locator(".panel-program").getByRole("button", { name: button, exact: true }).click();
  return readFile(await (await download).path());
}

async function type(page, text) {
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+Home");
  await page.keyboard.insertText(text);
}

const GBK = Buffer.from(
  "; \xb2\xe2\xc1\xbf\xbf\xd7\r\n_MVAR=1 _SETVAL=132 _TNUM=20 _KNUM=2001\r\nCYCLE977\r\n",
  "latin1",
); // 测量孔

describe("a program in its own encoding", () => {
  const chrome = shared("neither", { before, after });

  // oracle: peer (the files were written by the codecs of Python, which their names tell)
  test("is recognised, shown as what it says and saved with the same bytes", async () => {
    const { context, page, problems } = await start(chrome);
    for (const name of NAMES) {
      const [language, encoding] = name.split(".");
      const bytes = bytesOf(name);
      await opened(page, name, bytes);
      assert.equal(await choice(page).inputValue(), `read ${encoding}`, name);
      const text = bytesOf(`${language}.utf-8.mpf`).toString().replaceAll("\r\n", "\n").replaceAll("\u3000", " ");
      assert.equal((await shown(page)).replaceAll(/[\u2022\u3000]/g, " "), text, name);
      assert.deepEqual(await saved(page), bytes, name);
    }
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the bytes opened, with 孔 and a word in GBK before them)
  test("takes Chinese typed into GBK, and every other byte stays", async () => {
    const { context, page } = await start(chrome);
    await opened(page, "a.mpf", GBK);
    await type(page, "; \u5b54A\n");
    await page.locator('.cm-line:has-text("\u5b54A")').waitFor();
    assert.deepEqual(await saved(page), Buffer.concat([Buffer.from("; \xbf\xd7A\r\n", "latin1"), GBK]));
    await context.close();
  });

  // oracle: hand (ß is in Windows-1252 and not in GBK; the text in UTF-8)
  test("tells a character that the encoding lacks before it is saved, and offers UTF-8", async () => {
    const { context, page } = await start(chrome);
    await opened(page, "a.mpf", GBK);
    await type(page, "; Ma\u00df\n");
    const told = page.locator(".lacking:visible .problem");
    await told.waitFor();
    assert.match(await told.textContent(), /Line 1: GBK .*\u00df/);
    let downloads = 0;
    page.on("download", () => {
      downloads++;
    });
    await page.locator(".panel-program").getByRole("button", { name: "Save", exact: true }).click();
    await page.waitForFunction(() => document.activeElement?.textContent === "Save as UTF-8");
    assert.equal(downloads, 0);
    const offered = page.locator(".lacking:visible option");
    assert.deepEqual(await offered.evaluateAll(all => all.map(one => one.value)), [
      "utf-8",
      "utf-8-marked",
      "utf-16le",
      "utf-16le-marked",
      "utf-16be",
      "utf-16be-marked",
      "gb18030",
    ]);
    await page.locator(".lacking:visible select").selectOption("gb18030");
    await page.getByRole("button", { name: "Save as GB 18030", exact: true }).waitFor();
    await page.locator(".lacking:visible select").selectOption("utf-8");
    const bytes = await saved(page, "Save as UTF-8");
    assert.equal(
      bytes.toString(),
      "; Ma\u00df\r\n; \u6d4b\u91cf\u5b54\r\n_MVAR=1 _SETVAL=132 _TNUM=20 _KNUM=2001\r\nCYCLE977\r\n",
    );
    await told.waitFor({ state: "hidden" });
    assert.equal(await choice(page).inputValue(), "read utf-8");
    await context.close();
  });

  // oracle: peer (0xf8 is \u00f8 in Windows-1252; Shift JIS has no \u00d8, Windows-1252 no \u6c49; GBK has it as ba ba)
  test("tells in which line the character stands, and is saved in the encoding that is chosen instead", async () => {
    const { context, page, problems } = await start(chrome);
    const told = page.locator(".lacking:visible .problem");
    await opened(page, "a.mpf", Buffer.from("; \xf8 20\r\nM30\r\n", "latin1"));
    assert.equal(await choice(page).inputValue(), "read windows-1252");
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+End");
    await page.keyboard.insertText("; \u6c49");
    await told.waitFor();
    assert.match(await told.textContent(), /Line 3: Windows-1252.* no \u201c\u6c49\u201d/);
    await page.keyboard.press("Control+Home");
    await page.locator(".lacking").getByRole("button", { name: "Show character" }).click();
    await page.locator('.cm-activeLine:has-text("\u6c49")').waitFor();
    await choice(page).selectOption("save gb18030");
    await told.waitFor({ state: "hidden" });
    assert.match((await saved(page)).toString("latin1"), /\r\n; \xba\xba$/);
    const japanese = NAMES.find(name => name.includes("shift_jis"));
    await opened(page, japanese, bytesOf(japanese));
    await type(page, "; \u00d8 20\n");
    await told.waitFor();
    assert.match(await told.textContent(), /Line 1: Shift JIS.* no \u201c\u00d8\u201d/);
    await choice(page).selectOption("save windows-1252");
    await told.filter({ hasText: "Windows-1252" }).waitFor(); // it has no kana
    await choice(page).selectOption("save utf-8");
    await told.waitFor({ state: "hidden" });
    assert.match((await saved(page)).toString(), /^; \u00d8 20\r\n/);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (once it is gone, the bytes opened)
  test("says no more of a character that is taken out again", async () => {
    const { context, page } = await start(chrome);
    await opened(page, "a.mpf", GBK);
    await type(page, "\u00df");
    const told = page.locator(".lacking:visible");
    await told.waitFor();
    await page.keyboard.press("Backspace");
    await told.waitFor({ state: "hidden" });
    assert.deepEqual(await saved(page), GBK);
    await context.close();
  });

  // oracle: hand (windows-1251: Измерение; the bytes are the same whatever they are shown as)
  test("is read in another encoding by hand, with what was typed, and comes back", async () => {
    const { context, page, problems } = await start(chrome);
    const bytes = Buffer.from("; \xc8\xe7\xec\xe5\xf0\xe5\xed\xe8\xe5\r\nM30\r\n", "latin1");
    await opened(page, "a.mpf", bytes);
    await choice(page).selectOption("read windows-1251");
    await page.locator('.cm-line:has-text("; \u0418\u0437\u043c\u0435\u0440\u0435\u043d\u0438\u0435")').waitFor();
    assert.deepEqual(await saved(page), bytes);
    for (const encoding of [
      "gbk",
      "gb18030",
      "utf-8",
      "big5",
      "euc-kr",
      "shift_jis",
      "utf-16le",
      "windows-1250",
      "latin-1",
      "windows-1252",
    ]) {
      await choice(page).selectOption(`read ${encoding}`);
      await page.waitForFunction(
        value => document.querySelector("select.encoding").value === value,
        `read ${encoding}`,
      );
      assert.deepEqual(await saved(page), bytes, encoding);
    }
    await choice(page).selectOption("read windows-1251");
    await page.locator('.cm-line:has-text("; \u0418\u0437\u043c\u0435\u0440\u0435\u043d\u0438\u0435")').waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: peer (the files were written by the codecs of Python, which their names tell)
  test("is saved in another encoding by hand", async () => {
    const { context, page } = await start(chrome);
    await opened(page, "zh.gbk.mpf", bytesOf("zh.gbk.mpf"));
    for (const encoding of ["utf-8", "utf-8-marked", "utf-16le", "utf-16be-marked", "gbk"]) {
      await choice(page).selectOption(`save ${encoding}`);
      await page.waitForFunction(
        value => document.querySelector("select.encoding").value === value,
        `read ${encoding}`,
      );
      assert.deepEqual(await saved(page), bytesOf(`zh.${encoding}.mpf`), encoding);
    }
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+z"); // nothing of the text was changed: the encoding of before
    assert.deepEqual(await saved(page), bytesOf("zh.utf-16be-marked.mpf"));
    await context.close();
  });

  // oracle: hand (all sequences of two bytes, in lines; the bytes opened)
  test("keeps bytes that stand for no character, and marks them", async () => {
    const { context, page } = await start(chrome);
    const broken = Buffer.concat([GBK, Buffer.from([0x3b, 0xff, 0x80, 0xb2, 0x0d, 0x0a]), bytesOf("zh.gbk.mpf")]);
    await opened(page, "broken.mpf", broken);
    assert.equal(await choice(page).inputValue(), "read gbk");
    await counts(page.locator(".cm-held"), 3);
    assert.equal(await page.locator(".cm-held").first().textContent(), "FF");
    await page.locator('.cm-line:has-text("\u6d4b\u91cf\u5b54")').first().waitFor();
    assert.deepEqual(await saved(page), broken);
    const pairs = [];
    for (let lead = 0x80; lead < 0x100; lead++)
      for (let trail = 0x40; trail < 0x100; trail++) pairs.push(lead, trail, 0x0a);
    const four = [];
    for (let a = 0x81; a < 0xff; a++)
      for (let c = 0x81; c < 0xff; c += 5) four.push(a, 0x30 + (a % 10), c, 0x30 + (c % 10), 0x0a);
    const all = Buffer.concat([Buffer.from([...pairs, ...four]), Buffer.from(CHARACTERS)]);
    await opened(page, "all.mpf", all);
    for (const encoding of ["gbk", "gb18030", "shift_jis", "big5", "euc-kr", "utf-8", "utf-16be", "windows-1252"]) {
      await choice(page).selectOption(`read ${encoding}`);
      await page.waitForFunction(
        value => document.querySelector("select.encoding").value === value,
        `read ${encoding}`,
      );
      assert.ok((await saved(page)).equals(all), encoding);
    }
    await context.close();
  });

  // oracle: hand (the work as an older page has kept it: each byte one character)
  test("that an older page has kept is saved with its bytes", async () => {
    const { context, page } = await start(chrome);
    await page.waitForFunction(() => localStorage.getItem("probewright-1"));
    await page.addInitScript(text => {
      const kept = JSON.parse(localStorage.getItem("probewright-1"));
      localStorage.setItem(
        "probewright-1",
        JSON.stringify({
          ...kept,
          by: "",
          programs: { sinumerik: text },
          files: { sinumerik: { name: "old.mpf", encoding: "latin-1" } },
        }),
      );
      sessionStorage.clear();
    }, GBK.toString("latin1"));
    await page.reload();
    await page.locator('.file-name:text-is("old.mpf")').waitFor();
    assert.deepEqual(await saved(page), GBK);
    await choice(page).selectOption("read gbk");
    await page.locator('.cm-line:has-text("\u6d4b\u91cf\u5b54")').waitFor();
    assert.deepEqual(await saved(page), GBK);
    await context.close();
  });
});

const CHARACTERS = "\uef41 \u{1f600} \ue5e5 \ufeff \ufffd\n"; // among them those of our own

describe("what is no program", () => {
  const chrome = shared("neither", { before, after });
  const files = {
    "a.png": [Buffer.from("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "latin1"), /a\.png was not opened: it is a picture/],
    "b.zip": [Buffer.from("PK\x03\x04\x14\0", "latin1"), /it is an archive/],
    "c.pdf": [Buffer.from("%PDF-1.7\n%\xe2\xe3\xcf\xd3\n", "latin1"), /it is a PDF document/],
    "d.mpf": [
      Buffer.from(Array.from({ length: 4096 }, (_, i) => (Math.imul(i, 2654435761) >>> 13) & 0xff)),
      /it contains no text/,
    ],
  };
  for (const [name, [content, why]] of Object.entries(files)) {
    // oracle: hand (the beginnings that the formats prescribe)
    test(`is refused and the program stays: ${name}`, async () => {
      const { context, page, problems } = await start(chrome);
      const earlier = await saved(page);
      await programInput(page).setInputFiles(file(name, content));
      const told = page.locator(".refusal:visible .problem");
      await told.waitFor();
      assert.match(await told.textContent(), why);
      assert.deepEqual(await saved(page), earlier);
      assert.deepEqual(problems, []);
      await context.close();
    });
  }
});

/** Numbers from 0 to 1, the same in every run. */
function numbers(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

// oracle: self (what is read is written again, whatever the bytes are, and a change touches its own)
describe("any bytes at all", () => {
  let sources, encoding;
  before(async () => {
    sources = await modules();
    encoding = await sources.load("/src/encoding.ts");
  });
  after(() => sources.close());

  const ascii = (text, label) => {
    const bytes = Buffer.from(text, label.startsWith("utf-16") ? "utf16le" : "latin1");
    return label.startsWith("utf-16be") ? bytes.swap16() : bytes;
  };
  /** Bytes as text has them and as nothing has, an even number; the last one begins no character. */
  const drawn = (next, label) => {
    const kinds = [() => next() * 256, () => 128 + next() * 128, () => 32 + next() * 96, () => 0x81 + next() * 0x1e];
    const bytes = Array.from({ length: 2 * Math.floor(next() * 40) }, () =>
      Math.floor(kinds[Math.floor(next() * 4)]()),
    );
    return Buffer.concat([Buffer.from(bytes), ascii("\n", label)]);
  };

  test("in any encoding come back, and of a changed value only its own are others", async () => {
    const pace = { turn: async () => {} };
    for (const label of encoding.ENCODINGS) {
      const next = numbers(17);
      for (let round = 0; round < 300; round++) {
        const [begin, end] = [drawn(next, label), drawn(next, label)];
        const whole = value => Buffer.concat([begin, ascii(`_SETVAL=${value}\n`, label), end]);
        const bytes = whole("132");
        const found = encoding.asMarked(bytes, label);
        const text = await encoding.decode(bytes, found, pace);
        const what = `${label}, ${bytes.toString("hex")}`;
        assert.deepEqual(Buffer.from(encoding.encode(text, found)), bytes, what);
        const at = text.indexOf("_SETVAL=132\n") + "_SETVAL=".length;
        assert.ok(at >= 8, what);
        const changed = `${text.slice(0, at)}51.25${text.slice(at + 3)}`;
        assert.equal(encoding.lacking(changed, found), -1, what);
        assert.deepEqual(Buffer.from(encoding.encode(changed, found)), whole("51.25"), what);
      }
    }
  });

  // oracle: self (what is said to be lacking is what cannot be saved)
  test("are told as lacking where a character is typed that the encoding has not, and nowhere else", () => {
    const next = numbers(4);
    for (const label of encoding.ENCODINGS) {
      for (let round = 0; round < 500; round++) {
        const typed = String.fromCodePoint(Math.floor(next() ** 2 * 0x2fa20) % 0xd800 || 0x6e2c);
        const text = `; ${typed}\n`;
        const lacks = encoding.lacking(text, label) >= 0;
        assert.equal(encoding.encode(text, label) === null, lacks, `${label} ${typed.codePointAt(0).toString(16)}`);
      }
    }
  });
});
