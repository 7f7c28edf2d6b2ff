// Scanning a surface: from the form over the worker to points in the view and files.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { open, packages, shared } from "./browser.mjs";
import { searchTasks } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");
const { PNG } = packages("pngjs");

/** The page with the digitizing cycle of NCT in its form, the tab of the scan open. */
async function start(chrome, options) {
  const opened = await open(chrome.browser, options);
  const { page } = opened;
  await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" }); // all cycles are known
  await searchTasks(page, "G65 P9969");
  await page.locator('.hits[data-search="G65 P9969"] .hit').first().click();
  await page.locator('.field[data-field="R"]').waitFor();
  await page.locator("#tab-scan").click();
  return opened;
}

const status = page => page.locator("#page-scan > p[role=status]");

async function scan(page) {
  await page.locator("#page-scan button.primary").click();
  await page.locator(".scan-result").waitFor({ timeout: 60_000 });
}

const figures = async page => (await page.locator(".scan-figures td").allTextContents()).map(Number);
const set = (page, name, value) => page.locator(`.field[data-field="${name}"] input`).first().fill(value);

async function saved(page, name) {
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name }).click();
  return readFile(await (await download).path(), "utf8");
}

describe("scanning a surface", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand: lines at 0, 8 … 40; of the end of the ball on a slope the distance is greater than with the ball
  // taken out
  test("points are scanned, shown and saved", async () => {
    const { context, page, problems } = await start(chrome);
    await scan(page);
    assert.match(await status(page).textContent(), /points in 6 lines/);
    const [sent, , surface] = await figures(page);
    assert.ok(surface < sent, `${surface} < ${sent}`);
    assert.ok((await page.locator(".stage svg circle").count()) > 60, "points are drawn");
    await page.locator("#scan-shown-surface").check();
    const count = Number((await status(page).textContent()).match(/\d+/)[0]);
    const lines = text => text.trimEnd().split("\n");
    assert.equal(lines(await saved(page, "Save XYZ as output")).length, count);
    assert.equal(lines(await saved(page, "Save surface XYZ")).length, count);
    const program = await saved(page, "Save NC program");
    assert.match(program, /^%\nO1000\n/);
    assert.match(program, /G1 Z-?\d+\.\d{3} F120\.000\n/);
    await set(page, "Q", "5");
    await page.waitForFunction(() => /changed/.test(document.querySelector("#page-scan > p[role=status]").textContent));
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand: a flat upper side has nothing to be taken out; white is as high as the example
  test("a picture and an STL file are surfaces", async () => {
    const { context, page, problems } = await start(chrome);
    const white = new PNG({ width: 8, height: 6 });
    white.data.fill(255);
    const facet = corners => {
      const vertices = corners.map(corner => `vertex ${corner.join(" ")}\n`);
      return `facet normal 0 0 1\nouter loop\n${vertices.join("")}endloop\nendfacet\n`;
    };
    const stl = `solid flat\n${facet([
      [-200, -200, 3],
      [200, -200, 3],
      [0, 300, 3],
    ])}endsolid flat\n`;
    for (const [name, buffer] of [
      ["white.png", PNG.sync.write(white)],
      ["flat.stl", Buffer.from(stl)],
    ]) {
      await page
        .locator("#page-scan input[type=file]")
        .setInputFiles({ name, mimeType: "application/octet-stream", buffer });
      await page.waitForFunction(
        chosen => document.querySelector("#scan-surface").selectedOptions[0].textContent === chosen,
        name,
      );
      await scan(page);
      const [sent] = await figures(page);
      assert.ok(sent <= 0.0101, `${name}: ${sent}`); // F120: 0.01 mm (C:1320)
    }
    await page
      .locator("#page-scan input[type=file]")
      .setInputFiles({ name: "text.png", mimeType: "image/png", buffer: Buffer.from("no picture") });
    await page.waitForFunction(() => /neither/.test(document.querySelector("#page-scan > p[role=status]").textContent));
    await page.evaluate(() => {
      const large = new File(["x"], "large.stl");
      Object.defineProperty(large, "size", { value: 64_000_001 });
      const input = document.querySelector("#page-scan input[type=file]");
      Object.defineProperty(input, "files", { value: [large] });
      input.dispatchEvent(new Event("change"));
    });
    await page.locator("#page-scan > p[role=status]", { hasText: /large\.stl has 65\u00a0MB;.* 64\u00a0MB/ }).waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: self
  test("a long scan tells how far it is and can be stopped; the page goes on meanwhile", async () => {
    const { context, page, problems } = await start(chrome);
    await set(page, "J", "0.05");
    await set(page, "R", "0.05");
    await page.locator("#page-scan button.primary").click();
    await page.waitForFunction(
      () => Number(document.querySelector("#page-scan [data-work=scan-scanning] progress").value) > 0.001,
      undefined,
      { timeout: 60_000 },
    );
    await set(page, "R", "2");
    await page.waitForFunction(() => /R2/.test(document.querySelector(".snippet").textContent));
    await page.locator("#page-scan").getByRole("button", { name: "Stop" }).click();
    await page.locator("#page-scan [data-work=scan-scanning] progress").waitFor({ state: "hidden" });
    assert.equal(await page.locator(".scan-result").isHidden(), true);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand: what was stopped leaves the points as they were; what was made once is there at once
  test("taking the ball out tells that it works and can be stopped", async () => {
    const { context, page, problems } = await start(chrome);
    await page.evaluate(() => {
      // a worker that takes long: it hears the question when it is told to
      const send = Worker.prototype.postMessage;
      Worker.prototype.postMessage = function post(data, ...more) {
        if (data?.cloud === "surface") globalThis.goOn = () => send.call(this, data, ...more);
        else send.call(this, data, ...more);
      };
    });
    await scan(page);
    const work = page.locator('.activity[data-work="scan-taking"]');
    const [sent, surface] = ["sent", "surface"].map(name => page.locator(`#scan-shown-${name}`));
    await surface.check();
    await work.getByRole("button", { name: "Stop" }).click();
    await work.waitFor({ state: "hidden" });
    assert.ok(await sent.isChecked());
    await surface.check();
    await work.waitFor();
    await page.evaluate(() => globalThis.goOn());
    await work.waitFor({ state: "hidden" });
    assert.ok(await surface.isChecked());
    await page.evaluate(() => {
      globalThis.goOn = null;
    });
    await sent.check();
    await surface.check();
    assert.equal(await page.evaluate(() => globalThis.goOn), null, "nothing is asked again");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: axe-core
  test("nothing stands in the way of those who do not see it", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await scan(page);
    await page.addScriptTag({ path: axe });
    const found = await page.evaluate(() =>
      globalThis.axe.run(document.querySelector("#page-scan"), { resultTypes: ["violations"] }),
    );
    assert.deepEqual(
      found.violations.map(one => `${one.id}: ${one.nodes[0].html}`),
      [],
    );
    assert.deepEqual(problems, []);
    await context.close();
  });
});
