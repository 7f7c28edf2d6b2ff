// The page as an installed program: its icons, its ways in, and how a new version comes.
import assert from "node:assert/strict";
import { createServer } from "node:http";
import { after, before, describe, test } from "node:test";
import { address, counts, open, packages, shared } from "./browser.mjs";
import { drawn, keptWhen, lengthField, start, startWithCycles } from "./start.mjs";

const { PNG } = packages("pngjs");

const fetched = async path => Buffer.from(await (await fetch(new URL(path, address))).arrayBuffer());
const manifest = async () => JSON.parse((await fetched("manifest.webmanifest")).toString());

/** Red, green, blue and opacity at a place, in parts of the width. */
function pixel(png, x, y) {
  const at = 4 * (Math.floor(y * png.height) * png.width + Math.floor(x * png.width));
  return [...png.data.subarray(at, at + 4)];
}

const BALL = [224, 99, 58, 255];
const GROUND = [20, 32, 42, 255];

describe("the icons", () => {
  // oracle: hand (www/public/icon.svg: rounded corners, ball about 32 46 with radius 12 of 64)
  test("are drawn in the sizes that systems ask for", async () => {
    for (const { src, sizes, type, purpose } of (await manifest()).icons.filter(one => one.type === "image/png")) {
      const png = PNG.sync.read(await fetched(src));
      assert.equal(`${png.width}x${png.height}`, sizes, src);
      assert.equal(type, "image/png");
      const whole = purpose === "maskable";
      assert.deepEqual(pixel(png, 0, 0), whole ? GROUND : [0, 0, 0, 0], `${src}: corner`);
      assert.deepEqual(pixel(png, 0.5, whole ? (46 + 8) / 80 : 46 / 64), BALL, `${src}: ball`);
      assert.deepEqual(pixel(png, 0.5, whole ? (57 + 8) / 80 : 57 / 64), BALL, `${src}: lower end of the ball`);
    }
    const apple = PNG.sync.read(await fetched("apple-touch-icon.png"));
    assert.deepEqual([apple.width, apple.height, pixel(apple, 0, 0)], [180, 180, GROUND]);
  });

  // oracle: W3C, Web Application Manifest, icon masks: what must be seen lies in a circle of 40% of the width
  test("keep what must be seen when the maskable one is cut to a circle", async () => {
    const png = PNG.sync.read(await fetched("icon-maskable-512.png"));
    for (let y = 0; y < 1; y += 1 / 128)
      for (let x = 0; x < 1; x += 1 / 128)
        if (Math.hypot(x - 0.5, y - 0.5) > 0.4) assert.deepEqual(pixel(png, x, y), GROUND, `${x} ${y}`);
  });
});

describe("the page as a program", () => {
  const chrome = shared("neither", { before, after });

  // oracle: Chromium (what it needs to install a page), hand
  test("can be installed, and names what it is and what it opens", async () => {
    const { context, page } = await start(chrome, { serviceWorkers: "allow" });
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    const session = await context.newCDPSession(page);
    const { errors } = await session.send("Page.getAppManifest");
    assert.deepEqual(errors, []);
    const told = await session.send("Page.getInstallabilityErrors");
    // a test's browser window is none that keeps anything
    assert.deepEqual(
      told.installabilityErrors.filter(one => one.errorId !== "in-incognito"),
      [],
    );
    const { description, file_handlers, shortcuts } = await manifest();
    assert.match(description, /measuring cycles/);
    assert.deepEqual(Object.values(file_handlers[0].accept).flat(), [".mpf", ".spf", ".nc"]);
    assert.equal(shortcuts.length, 3);
    await context.close();
  });

  for (const [place, focus] of [
    ["tasks", ".tree [role=treeitem]"],
    ["program", "#program-open"],
    ["search", "#task-search"],
  ]) {
    // oracle: hand
    test(`the shortcut to ${place} leads there, at any size`, async () => {
      const { shortcuts } = await manifest();
      const { url } = shortcuts.find(one => one.url.endsWith(`=${place}`));
      for (const viewport of [
        { width: 1280, height: 800 },
        { width: 390, height: 844 },
      ]) {
        const { context, page } = await open(chrome.browser, { path: url, viewport });
        await page.locator(`${focus}:focus`).waitFor();
        assert.equal(new URL(page.url()).hash, "");
        await context.close();
      }
    });
  }

  // oracle: hand
  test("opens a program that the system hands over", async () => {
    const context = await chrome.browser.newContext({ locale: "en-GB" });
    const page = await context.newPage();
    await page.addInitScript(() => {
      const files = [{ getFile: async () => new File(["; FROM THE SYSTEM\r\nM30\r\n"], "FLANGE.MPF") }];
      Object.defineProperty(globalThis, "launchQueue", { value: { setConsumer: take => take({ files }) } });
    });
    await page.goto(address);
    await page.locator('.cm-line:has-text("; FROM THE SYSTEM")').waitFor();
    assert.equal(await page.locator(".file-name").textContent(), "FLANGE.MPF");
    await context.close();
  });

  // oracle: hand (tokens.css: the surface of the line above everything)
  test("gives the frame around it the colour of its first line", async () => {
    const { context, page } = await startWithCycles(chrome, { colorScheme: "dark" });
    const frame = () =>
      page.evaluate(() => {
        const told = [...document.querySelectorAll("meta[name=theme-color]")].filter(
          one => matchMedia(one.media).matches,
        );
        const shown = document.createElement("span");
        shown.style.color = told[0].content;
        document.body.append(shown);
        const same = getComputedStyle(shown).color === getComputedStyle(document.querySelector(".top")).backgroundColor;
        shown.remove();
        return [told.length, same];
      });
    assert.deepEqual(await frame(), [1, true]);
    for (const _ of ["light", "dark", "system"]) {
      await page.locator("#theme").click();
      await drawn(page);
      assert.deepEqual(await frame(), [1, true]);
    }
    await context.close();
  });
});

describe("a new version of the page", () => {
  const chrome = shared("neither", { before, after });
  const served = { version: 1 };
  let server;
  let url;

  // The page as it is, and a second build of it: another index.html, which the service worker knows.
  before(async () => {
    server = createServer(async (request, response) => {
      const from = await fetch(new URL(`.${request.url}`, address));
      let body = Buffer.from(await from.arrayBuffer());
      if (served.version > 1 && /\/(index\.html)?$/.test(request.url.split("?")[0]))
        body = Buffer.from(
          body.toString().replace("<title>", `<meta name="build" content="${served.version}"><title>`),
        );
      if (served.version > 1 && request.url.endsWith("/sw.js")) {
        const next = body.toString().replace(/("?url"?:"index\.html","?revision"?:")\w+/, `$1${served.version}`);
        assert.notEqual(next, body.toString());
        body = Buffer.from(next);
      }
      response.writeHead(from.status, {
        "content-type": from.headers.get("content-type"),
        "cache-control": "no-cache",
      });
      response.end(body);
    });
    await new Promise(done => server.listen(0, "127.0.0.1", done));
    url = `http://127.0.0.1:${server.address().port}/`;
  });
  after(() => server.close());

  const offer = page => page.locator(".newer p", { hasText: "new version" });
  const build = page => page.evaluate(() => document.querySelector("meta[name=build]")?.content ?? "1");

  async function opened(context) {
    const page = await context.newPage();
    await page.goto(`${url}#measure`);
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    return page;
  }

  // oracle: hand
  test("waits until it is wanted, and the work goes along", async () => {
    served.version = 1;
    const context = await chrome.browser.newContext({ locale: "en-GB" });
    const page = await opened(context);
    await counts(offer(page), 0, "the first visit is no new version");
    await lengthField(page).fill("26.5");
    served.version = 2;
    await page.reload();
    await offer(page).waitFor();
    assert.equal(await build(page), "1", "the old one goes on");
    const other = await opened(context);
    await offer(other).waitFor();
    await other.locator(".newer").getByRole("button", { name: "Later" }).click();
    await offer(other).waitFor({ state: "detached" });
    assert.equal(
      await other
        .locator(".newer")
        .boundingBox()
        .then(box => box?.height ?? 0),
      0,
    );

    await lengthField(page).fill("27.5"); // at once, before it is kept by itself
    await Promise.all([
      page.waitForEvent("load"),
      page.locator(".newer").getByRole("button", { name: "Reload" }).click(),
    ]);
    await page.locator(".field").first().waitFor();
    assert.equal(await build(page), "2");
    assert.equal(await lengthField(page).inputValue(), "27.5");
    await counts(offer(page), 0);

    await offer(other).waitFor(); // its version is gone
    assert.equal(await build(other), "1", "and is not taken from under it");
    await keptWhen(page, state => Object.values(state.values ?? {}).includes("27.5"));
    await context.close();
  });
});
