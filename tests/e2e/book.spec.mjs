// The handbook: its pages, its search, and that it is there without scripts, from a disk and without a network.
import assert from "node:assert/strict";
import { mkdir, mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, describe, test } from "node:test";
import { pathToFileURL } from "node:url";
import { address, counts, open, packages, shared } from "./browser.mjs";
import { openPageMenu, start } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");
const hits = page => page.locator("#found li a");
const status = page => page.locator("#found [role=status]");

/** Types into the search by its key; its first lines are there. */
async function search(page, words) {
  await page.keyboard.press("/");
  await page.locator("#query:focus").waitFor();
  await page.keyboard.insertText(words);
  await hits(page).first().waitFor();
}

/** The page does not scroll sideways. */
const fits = page => page.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth);

describe("the handbook", () => {
  const chrome = shared("neither", { before, after });
  const handbook = (path, options = {}) => open(chrome.browser, { path: `book/${path}`, ...options });

  // oracle: hand (docs/alarms.md, docs/de/terms.md, docs/zh/alarms.md)
  for (const [language, asked, title, marked, ends] of [
    ["en", "FRAME cycles missing", "61016", ["frame", "cycles", "missing"], "/en/alarms.html#61016"],
    ["de", "SIGNALUBERTRAGUNG", "Signalübertragung", [], "/de/terms.html#signalübertragung"],
    ["zh", "坐标框架 缺少", "61016", ["缺少", "坐标框架"], "/zh/alarms.html#61016"],
  ])
    test(`finds parts of words in any case, and goes there by keys, ${language}`, async () => {
      const { context, page, problems } = await handbook(`${language}/index.html`);
      await search(page, asked);
      const first = hits(page).first();
      assert.equal(await first.locator(".hit-title").evaluate(node => node.firstChild.textContent), title);
      const marks = await first.locator("mark").allTextContents();
      for (const word of marked) assert.ok(marks.includes(word), `${word} of ${marks}`);
      assert.match(await status(page).innerText(), /\d+$/);
      await page.keyboard.press("ArrowDown");
      await page.keyboard.press("Enter");
      await page.waitForURL(url => decodeURI(url.href).endsWith(ends));
      assert.equal(await page.locator("html").getAttribute("lang"), language);
      await page.locator(":target").waitFor();
      assert.deepEqual(problems, []);
      await context.close();
    });

  // oracle: hand (the policy of the handbook lets a picture be drawn in its own colours)
  for (const colorScheme of ["light", "dark"])
    test(`a concept has its picture, ${colorScheme}`, async () => {
      const { context, page, problems } = await handbook("de/terms.html", { colorScheme });
      const picture = page.locator("img[src$='/mean-value.svg']");
      await picture.scrollIntoViewIfNeeded();
      assert.ok(await picture.evaluate(image => image.complete && image.naturalWidth > 300));
      assert.ok(await fits(page));
      assert.deepEqual(problems, []);
      await context.close();
    });

  // oracle: hand
  test("the search says when there is nothing, moves by arrows, and closes with Escape", async () => {
    const { context, page } = await handbook("en/alarms.html");
    await search(page, "_CHBIT[10]");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowDown");
    assert.ok(
      await hits(page)
        .nth(1)
        .evaluate(node => node === document.activeElement),
    );
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("ArrowUp");
    await page.locator("#query:focus").waitFor();
    await page.keyboard.press("Escape");
    await page.locator("#found").waitFor({ state: "hidden" });
    assert.equal(await page.locator("#query").inputValue(), "");
    await page.keyboard.insertText("qqqqq");
    await status(page).filter({ hasText: "Nothing found." }).waitFor();
    await counts(hits(page), 0);
    await context.close();
  });

  // oracle: hand (a title counts more than a heading, a heading more than text)
  test("a title comes before a heading, a heading before text", async () => {
    const { context, page } = await handbook("en/index.html");
    await search(page, "machine data");
    const titles = await hits(page)
      .locator(".hit-title")
      .evaluateAll(all => all.map(node => node.firstChild.textContent));
    assert.equal(titles[0], "Machine data");
    const named = titles.map(title => /machine data/i.test(title));
    assert.ok(named.filter(Boolean).length > 2, titles.join(", "));
    assert.ok(named.lastIndexOf(true) < named.indexOf(false), titles.join(", "));
    await context.close();
  });

  // oracle: axe-core
  for (const colorScheme of ["light", "dark"])
    test(`has names, order and contrast, ${colorScheme}`, async () => {
      const { context, page } = await handbook("en/index.html", { bypassCSP: true, colorScheme });
      for (const path of ["en/index.html", "zh/around.html", "index.html"]) {
        await page.goto(new URL(`book/${path}`, address).href);
        if (path.startsWith("zh")) await search(page, "测量");
        await page.addScriptTag({ path: axe });
        const { violations } = await page.evaluate(() => globalThis.axe.run());
        assert.deepEqual(
          violations.map(one => [one.id, one.nodes.map(node => node.html.slice(0, 200))]),
          [],
          path,
        );
      }
      await context.close();
    });

  // oracle: hand (WCAG 1.4.10)
  for (const [width, height] of [
    [320, 640],
    [320, 200],
    [1280, 800],
  ])
    test(`nothing is wider than a window of ${width} × ${height}`, async () => {
      const { context, page } = await handbook("en/index.html", { viewport: { width, height } });
      for (const path of ["en/index.html", "de/machine-data.html", "de/generations.html", "en/around.html"]) {
        await page.goto(new URL(`book/${path}`, address).href);
        assert.ok(await fits(page), path);
      }
      await search(page, "PW1_MEASURED");
      assert.ok(await fits(page), "with what was found");
      await context.close();
    });

  // oracle: hand
  test("all but the search is there without scripts, the contents of a phone too", async () => {
    const viewport = { width: 390, height: 844 };
    const { context, page, problems } = await handbook("de/alarms.html", { javaScriptEnabled: false, viewport });
    assert.ok(await page.locator("#query").isHidden());
    await page.locator(".contents-open").click();
    await page.locator("#contents").getByRole("link", { name: "Begriffe" }).click();
    await page.waitForURL(/terms\.html$/);
    await page.locator(".languages").getByText("中文").click();
    await page.waitForURL(/zh\/terms\.html$/);
    await page.locator("a.next").click();
    await page.waitForURL(/zh\/(?!terms)[a-z-]+\.html$/);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (also that book/de.json names every file that its pages need)
  test("is read and searched from a disk", async () => {
    const folder = await mkdtemp(join(tmpdir(), "handbook-"));
    try {
      const { files } = await (await fetch(new URL("book/de.json", address))).json();
      for (const name of files) {
        const path = join(folder, name);
        await mkdir(dirname(path), { recursive: true });
        await writeFile(path, Buffer.from(await (await fetch(new URL(`book/${name}`, address))).arrayBuffer()));
      }
      const context = await chrome.browser.newContext({ locale: "de-DE" });
      const page = await context.newPage();
      await page.goto(pathToFileURL(join(folder, "de/index.html")).href);
      assert.equal(await page.locator("header").evaluate(node => getComputedStyle(node).position), "sticky", "styled");
      await search(page, "61301");
      await page.keyboard.press("Enter");
      await page.waitForURL(/alarms\.html#61301$/);
      await context.close();
    } finally {
      await rm(folder, { recursive: true });
    }
  });

  // oracle: hand
  test("is not among what a first visit waits for", async () => {
    const worker = await (await fetch(new URL("sw.js", address))).text();
    assert.match(worker, /url"?:"index\.html"/);
    assert.doesNotMatch(worker, /url"?:"book\//);
  });

  // oracle: hand
  test("opens from the menu in the page's language, and stays without a network", async () => {
    const { context, page, problems } = await start(chrome, { locale: "de-DE", folded: true, serviceWorkers: "allow" });
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    await openPageMenu(page);
    const [book] = await Promise.all([
      context.waitForEvent("page"),
      page.locator("#page-actions").getByRole("link", { name: "Handbuch" }).click(),
    ]);
    await book.getByRole("heading", { level: 1 }).waitFor();
    assert.match(book.url(), /\/book\/de\/index\.html$/);
    await page.evaluate(async () => {
      const list = new URL("book/de.json", location.href);
      while (!(await caches.match(list))) await new Promise(resolve => setTimeout(resolve, 50));
    });
    await context.setOffline(true);
    await book.goto(new URL("book/de/alarms.html", address).href);
    await search(book, "Messweg");
    await book.keyboard.press("Enter");
    await book.waitForURL(/\/book\/de\/.*#/);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
