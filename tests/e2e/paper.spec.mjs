// Set-up sheets and the report of a program, as they come out of the printer: pages of the PDF, and their words.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, shared } from "./browser.mjs";
import { fromPageMenu, openProgram, startWithAll as start, startWithCycles } from "./start.mjs";

const chrome = shared("neither", { before, after });
const device = shared("webgl2", { before, after });
const paper = page => page.locator(".paper");

/** The page with what is printed, which stays there. */
async function printed(page, what) {
  await page.evaluate(() => {
    window.print = () => document.documentElement.setAttribute("data-printed", "");
    document.documentElement.removeAttribute("data-printed");
  });
  await fromPageMenu(page, what);
  await page.locator("html[data-printed]").waitFor({ state: "attached" });
}

async function pages(page, format) {
  const pdf = await page.pdf({ format, printBackground: false });
  return pdf.toString("latin1").match(/\/Type\s*\/Page\b(?!s)/g).length;
}

const ELEMENTS = ["hole", "corner", "angle", "sphere", "turned", "tool", "probe", "points"];
const LANGUAGES = {
  "en-GB": ["Print setup sheet", "Print report"],
  "de-DE": ["Einrichteblatt drucken", "Bericht drucken"],
  "zh-CN": ["打印调整卡", "打印报告"],
};
const FORMATS = ["A4", "Letter"];

/** All that is laid out on paper, CSS pixels: what is drawn over the edge of its sheet is lost. */
const sticksOut = node => {
  const { left, right } = node.getBoundingClientRect();
  return [...node.querySelectorAll("td, th, pre, p, h2, .paper-picture, .paper-stage")].filter(one => {
    const box = one.getBoundingClientRect();
    return box.left < left - 1 || box.right > right + 1;
  }).length;
};

describe("a setup sheet", () => {
  // oracle: hand (a call is a page, whatever is measured; the page is 186 mm wide between its margins)
  for (const [locale, [name]] of Object.entries(LANGUAGES))
    test(`is one page for each kind of element, on A4 and on Letter, ${locale}`, async () => {
      const { context, page, problems } = await start(chrome, { locale });
      for (const element of ELEMENTS) {
        await page.locator(".to-start").click();
        await page.locator(`.tile[data-element="${element}"]`).click();
        await page.locator(".start-answer button.primary").click();
        await page.locator("#panel-form .field").first().waitFor();
        for (const format of FORMATS) {
          await printed(page, name); // what was printed is taken away again
          await counts(paper(page).locator(".paper-sheet"), 1);
          assert.ok((await paper(page).locator(".paper-pictures > *").count()) > 0, `${element}: a picture`);
          assert.equal(await pages(page, format), 1, `${element} ${format}`);
        }
        await printed(page, name);
        await page.emulateMedia({ media: "print" });
        assert.equal(await paper(page).evaluate(sticksOut), 0, element);
        await page.emulateMedia({ media: null });
        await page.evaluate(() => dispatchEvent(new Event("afterprint")));
        await counts(paper(page), 0);
      }
      assert.deepEqual(problems, []);
      await context.close();
    });

  // oracle: hand
  test("says file, date, call, values with unit and meaning, and the result, black on white in the dark", async () => {
    const { context, page } = await start(chrome, { colorScheme: "dark" });
    await printed(page, "Print setup sheet");
    await page.emulateMedia({ media: "print" });
    const text = await paper(page).innerText();
    assert.match(text, /program\.mpf/);
    assert.match(text, new RegExp(`${new Date().getFullYear()}`));
    assert.match(text, /Hole: correct a tool/);
    assert.match(text, /_SETVAL\s+Setpoint diameter\s+132\smm/);
    assert.match(text, /Ø 132\.030/);
    assert.match(text, /_MVAR=1 _SETVAL=132/);
    assert.ok((await paper(page).locator(".paper-stage path").count()) > 10);
    assert.ok((await paper(page).locator(".paper-picture .shape").count()) > 3);
    assert.equal(await paper(page).evaluate(node => getComputedStyle(node).color), "rgb(0, 0, 0)");
    await context.close();
  });
});

describe("a setup sheet of a browser with WebGL2", () => {
  // oracle: hand (the part is grey metal on paper that is white, in the dark too; the picture has three pixels for one)
  test("shows what the stage shows, in light colours", async () => {
    const { context, page, problems } = await start(device, { colorScheme: "dark" });
    await page.locator('.stage [data-backend="webgl2"]').waitFor({ state: "attached" });
    await printed(page, "Print setup sheet");
    const picture = paper(page).locator(".paper-stage img");
    await counts(picture, 1);
    const [width, corner, greys] = await picture.evaluate(image => {
      const { naturalWidth: width, naturalHeight: height } = image;
      const pen = new OffscreenCanvas(width, height).getContext("2d");
      pen.drawImage(image, 0, 0);
      const { data } = pen.getImageData(0, 0, width, height);
      let greys = 0;
      for (let i = 0; i < data.length; i += 4) {
        const [least, most] = [Math.min(...data.slice(i, i + 3)), Math.max(...data.slice(i, i + 3))];
        if (most - least < 30 && least > 40 && most < 215) greys += 1;
      }
      return [width, Math.min(...data.slice(0, 3)), greys / (width * height)];
    });
    assert.equal(width, 1320);
    assert.ok(corner > 220, `${corner}`);
    assert.ok(greys > 0.05 && greys < 0.6, `${greys}`);
    assert.ok((await paper(page).locator(".paper-stage text").count()) > 3, "letters over it");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the same picture, though the stage was never in sight)
  test("shows it where the stage was never in sight", async () => {
    const { context, page, problems } = await startWithCycles(device, { viewport: { width: 390, height: 844 } });
    await counts(page.locator(".stage [data-backend]"), 0);
    await printed(page, "Print setup sheet");
    await counts(paper(page).locator(".paper-stage img"), 1);
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("a report", () => {
  const call = size => `_MVAR=1 _SETVAL=${size} _TNUM=20 _KNUM=2001 _TUL=0.05 _TLL=-0.05 _FA=2 _TSA=1\nCYCLE977\n`;

  // oracle: hand (a table, and behind it a page a call)
  test("has a table of the measurements and a page a call", async () => {
    const { context, page, problems } = await start(chrome);
    await openProgram(page, `G17 G54\n${call(40)}${call(50)}${call(60)}M30\n`, "FLANGE.MPF");
    await page.locator(".call-row").nth(2).waitFor();
    await printed(page, "Print report");
    await page.emulateMedia({ media: "print" });
    assert.match(await paper(page).locator(".paper-table").innerText(), /FLANGE\.MPF.*40\.030.*50\.030.*60\.030/s);
    assert.deepEqual(await paper(page).locator(".paper-sheet h2 small").allInnerTexts(), [
      "CYCLE977 · 1 · Line 3",
      "CYCLE977 · 1 · Line 5",
      "CYCLE977 · 1 · Line 7",
    ]);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (a page a call behind that of the table)
  for (const [locale, [, name]] of Object.entries(LANGUAGES))
    test(`is a page a call on A4 and on Letter, ${locale}`, async () => {
      const { context, page } = await start(chrome, { locale });
      const text = `G17 G54\n${call(40)}${call(50)}M30\n`;
      const file = { name: "FLANGE.MPF", mimeType: "text/plain", buffer: Buffer.from(text) };
      await page.locator(".panel-program input[type=file]").setInputFiles(file);
      await page.locator(".call-row").nth(1).waitFor();
      for (const format of FORMATS) {
        await printed(page, name);
        assert.equal(await pages(page, format), 3, format);
      }
      await context.close();
    });
});
