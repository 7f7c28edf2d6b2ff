// A fourth language is a folder: the page in one that nobody speaks, longer than English. No text is cut, and none is
// in the code.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { open, shared } from "./browser.mjs";
import { PSEUDO, speaksPseudo } from "./pseudo.mjs";
import { choosePanel, faults, PANELS } from "./room.mjs";
import { serve } from "./sources.mjs";
import { drawn, openPageMenu, searchTasks } from "./start.mjs";

const SIZES = [
  [1280, 800],
  [1024, 768],
  [390, 844],
];

/** Words to be seen or heard that are no message: every message has accents. Titles of manuals are names. */
const plain = page =>
  page.evaluate(() => {
    const names = "code, kbd, pre, .cm-editor, .editor, .code, svg, #language, [data-name], .hit-control";
    const found = new Set();
    const look = (text, node) => {
      const said = text?.replaceAll(/Measuring Cycles \d+\/\d+|NCT Probing and Digitizing Cycles \d+/g, "");
      for (const word of said?.match(/(?<![\p{L}\d_.$])[A-Za-z]?[a-z]{2,}(?![\p{L}\d_(])/gu) ?? [])
        if (/[aeiou]/.test(word)) found.add(`${word} in ${node.outerHTML.slice(0, 120)}`);
    };
    for (const node of document.body.querySelectorAll("*")) {
      if (!node.checkVisibility({ visibilityProperty: true }) || node.closest(names)) continue;
      for (const child of node.childNodes) if (child.nodeType === Node.TEXT_NODE) look(child.textContent, node);
      for (const name of ["aria-label", "title", "placeholder"]) look(node.getAttribute(name), node);
    }
    return [...found];
  });

/** Texts that do not fit into what holds them. What ends in an ellipsis is meant to. */
const cut = page =>
  page.evaluate(() => {
    const found = new Set();
    const clips = ({ overflowX }) => overflowX !== "visible";
    const holders = node => {
      const all = [];
      for (let one = node; one && one !== document.body; one = one.parentElement) all.push(one);
      return all;
    };
    const shown = [...document.body.querySelectorAll("*")].filter(
      node =>
        node.checkVisibility({ visibilityProperty: true }) &&
        !node.closest(".skip, .visually-hidden, svg, select, .editor, .cm-editor"),
    );
    for (const node of shown) {
      if (holders(node).some(one => getComputedStyle(one).clipPath !== "none")) continue; // for the ear alone
      if (node.matches("h1, h2, h3, th, label, button, [role=tab]") && node.scrollWidth > node.clientWidth + 1)
        found.add(`is wider than its place: ${node.outerHTML.slice(0, 100)}`);
      if (holders(node).some(one => getComputedStyle(one).textOverflow === "ellipsis")) continue;
      const texts = [...node.childNodes].filter(one => one.nodeType === Node.TEXT_NODE && one.textContent.trim());
      const clipping = holders(node)
        .filter(one => clips(getComputedStyle(one)))
        .map(one => one.getBoundingClientRect());
      for (const text of texts) {
        const range = document.createRange();
        range.selectNodeContents(text);
        const { left, right } = range.getBoundingClientRect();
        if (clipping.some(one => left < one.left - 1 || right > one.right + 1))
          found.add(`is cut: ${node.outerHTML.slice(0, 100)}`);
      }
    }
    return [...found];
  });

describe("a fourth language", () => {
  const chrome = shared("neither", { before, after });
  let served;
  before(async () => {
    served = await serve([speaksPseudo()]);
  });
  after(() => served.close());

  const start = async ([width, height]) => {
    const viewport = { width, height };
    const opened = await open(chrome.browser, {
      path: `${served.url}#measure`,
      bypassCSP: true,
      locale: PSEUDO,
      viewport,
    });
    await opened.page.locator(".results tbody tr").first().waitFor({ state: "attached", timeout: 60_000 });
    await opened.page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
    return opened;
  };

  // oracle: hand (a text that is longer than another language's needs no more than wrapping)
  for (const size of SIZES)
    test(`is found by itself, and nothing of it is cut, ${size.join(" × ")}`, async () => {
      const { context, page } = await start(size);
      assert.equal(await page.evaluate(() => document.documentElement.lang), PSEUDO);
      const holds = async what => {
        await drawn(page);
        assert.deepEqual(await faults(page), [], what);
        assert.deepEqual(await cut(page), [], what);
        assert.deepEqual(await plain(page), [], what);
      };
      for (const name of PANELS) {
        await choosePanel(page, name);
        await holds(name);
      }
      await choosePanel(page, "results");
      for (const tab of await page.locator(".results-main [role=tab]:visible").all()) {
        await tab.click();
        await holds(await tab.textContent());
      }
      await choosePanel(page, "tasks");
      await searchTasks(page, "CYCLE977");
      await page.locator(".hit").first().waitFor();
      await holds("search");
      await searchTasks(page, "");
      for (const end of ["first", "last"]) {
        await openPageMenu(page);
        await page.locator("#page-actions button:not(.on-phone)")[end]().click(); // the machine's data; about the page
        await page.locator("dialog[open]").waitFor();
        await holds(`${end} dialog`);
        await page.keyboard.press("Escape");
      }
      await context.close();
    });
});
