// The machine to practise measuring in JOG: an edge by mouse and by keyboard alone, every function in every language.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, open, shared } from "./browser.mjs";
import { faults } from "./room.mjs";
import { drawn, focused } from "./start.mjs";

const chrome = shared("neither", { before, after });

const field = (page, name) => page.locator(`#jog-${name}`);
const axis = (page, key) => page.locator(`.jog-axis[data-axis="${key}"]`);
const position = (page, letter) => page.locator(`[data-position="${letter}"]`);
const step = (page, name) => page.locator(".jog-steps").getByRole("button", { name, exact: true });
const start = page => page.locator(".jog-start");

/** Tab until this has the focus. */
async function tabTo(page, selector) {
  for (let presses = 0; presses < 60; presses++) {
    if (await page.locator(selector).evaluateAll(all => all.includes(document.activeElement))) return;
    await page.keyboard.press("Tab");
  }
  assert.fail(`no way to ${selector}`);
}

/** Visible controls that are smaller than a finger needs. */
const small = page =>
  page.evaluate(() =>
    [...document.querySelectorAll(".jog :is(button, select, summary, input:not([type=checkbox], [type=file]))")]
      .filter(node => node.checkVisibility() && !node.matches(".gloss")) // a word in its line
      .filter(node => node.getBoundingClientRect().height < 24 || node.getBoundingClientRect().width < 24)
      .map(node => node.outerHTML.slice(0, 80)),
  );

/** What is written upon the stage, where the buttons of the view stand. */
const covered = page =>
  page.evaluate(() => {
    const hint = document.querySelector(".jog-hint").getBoundingClientRect();
    return [...document.querySelectorAll(".jog-stage .stage-tool")]
      .filter(node => {
        const { left, right, top, bottom } = node.getBoundingClientRect();
        return left < hint.right && right > hint.left && top < hint.bottom && bottom > hint.top;
      })
      .map(node => node.getAttribute("aria-label"));
  });

describe("an edge", () => {
  // oracle: hand (the left face of the block is at X 0 of the machine, the slider puts it to X 1.5)
  test("is set by mouse, rejected, hit and exported", async () => {
    const { context, page, problems } = await open(chrome.browser, { path: "" });
    await page.locator(".start-practice").click();
    await page.locator("[data-mask=set_edge]").click();
    await page.locator("#jog-part-dx ~ .figure").fill("1.5");
    await page.keyboard.press("Enter");
    await field(page, "zo").selectOption("G54");
    await field(page, "x0").fill("far");
    await page.keyboard.press("Enter");
    await page.locator('[data-field="x0"] .jog-why').getByText("far").waitFor();
    await field(page, "x0").fill("10");
    await page.keyboard.press("Enter");
    await step(page, "10000").click();
    for (let presses = 0; presses < 3; presses++) await axis(page, "Z-").click();
    await axis(page, "Z+").hover();
    await page.mouse.wheel(0, 100); // backwards
    await position(page, "Z").getByText("\u221210.0000").waitFor();
    for (let presses = 0; presses < 4; presses++) await axis(page, "X+").click();
    await page.locator(".jog-raised").waitFor();
    await axis(page, "X-").click();
    await page.locator(".jog-raised").waitFor({ state: "detached" });
    await start(page).click();
    await page.locator(".jog-activation").waitFor();
    await page.locator('.jog-deviation[data-near="true"]').waitFor();
    assert.match(await page.locator(".jog-written").textContent(), /G54, X coarse\s*−20\.0000 → −8\.5000 mm/);
    await start(page).click();
    await page.locator(".jog-activation").waitFor({ state: "detached" });
    assert.equal(await page.locator(".jog-positions thead th").nth(1).textContent(), "G54");
    await page.locator(".jog-record summary").click();
    assert.match(await page.locator(".jog-measured").textContent(), /Edge|edge/);
    const [table] = await Promise.all([
      page.waitForEvent("download"),
      page.locator(".jog-record").getByRole("button", { name: "CSV" }).click(),
    ]);
    assert.match((await (await table.createReadStream()).toArray()).join(""), /G54 X 11\.5 mm/);
    await page.locator(".jog-record summary").click();
    const [saved] = await Promise.all([
      page.waitForEvent("download"),
      page.getByRole("button", { name: "Save script" }).click(),
    ]);
    const script = (await (await saved.createReadStream()).toArray()).join("");
    assert.match(script, /^; part x=1\.5 .*\n; piece block\nmask set_edge\nzo = G54\nx0 = 10\njog Z-40\n/);
    await page.getByRole("button", { name: "Start again" }).click();
    await page.locator("[data-mask=set_edge]").waitFor();
    await page
      .locator(".jog > input[type=file]")
      .setInputFiles({ name: "practice.jog", mimeType: "text/plain", buffer: Buffer.from(script) });
    await page.locator('.jog-deviation[data-near="true"]').waitFor();
    assert.equal(await page.locator(".jog-positions thead th").nth(1).textContent(), "G54");
    await page.getByRole("button", { name: "To the program" }).click();
    await page.locator("#panel-form .field").first().waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:2602 (RESET cancels the measurement)
  test("is not measured where RESET comes while the probe is seen to move", async () => {
    const { context, page, problems } = await open(chrome.browser, { path: "#jog" });
    await page.locator("[data-mask=set_edge]").click();
    await field(page, "zo").selectOption("G54");
    await step(page, "10000").click();
    for (let presses = 0; presses < 3; presses++) await axis(page, "Z-").click();
    // both in the page: the motion is seen for a moment only
    await start(page).evaluate(async node => {
      node.click();
      for (let frames = 0; frames < 3; frames++) await new Promise(requestAnimationFrame);
      document.querySelector(".jog-reset").click();
    });
    await page.locator(".jog-ahead").getByText("touch at").waitFor(); // NC start would measure again
    await counts(page.locator(".jog-written"), 0, "nothing is written");
    await start(page).click();
    await page.locator(".jog-written").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("is practised further after a reload of the page", async () => {
    const { context, page, problems } = await open(chrome.browser, { path: "#jog" });
    await page.locator("[data-mask=hole_1]").click();
    await field(page, "zo").selectOption("G55");
    await page.locator(".jog-surprise").click();
    const hidden = page.locator(".jog-part p").first();
    await page.locator(".jog-reveal").waitFor();
    const told = await hidden.textContent();
    await page.reload();
    await page.locator(".jog-reveal").waitFor();
    assert.equal(await hidden.textContent(), told);
    await page.locator(".jog-title").getByText("1 hole").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("is set by keyboard alone, on a part that chance has put", async () => {
    const { context, page, problems } = await open(chrome.browser, { path: "#jog" });
    await page.locator("[data-mask=set_edge]").waitFor();
    await tabTo(page, ".jog-surprise");
    await page.keyboard.press("Enter");
    await page.locator(".jog-reveal").waitFor();
    await counts(page.locator(".jog-truth"), 0, "nobody has asked yet");
    await page.locator("#jog").focus();
    await tabTo(page, "[data-mask=set_edge]");
    await page.keyboard.press("Enter");
    await focused(page, field(page, "zo"));
    await page.keyboard.type("G54");
    await tabTo(page, ".jog-steps button:nth-child(5)");
    await page.keyboard.press("Enter");
    await tabTo(page, ".jog-setup select");
    for (let presses = 0; presses < 30; presses++) {
      await page.keyboard.press("Shift+Tab");
      if (await page.evaluate(() => document.activeElement?.matches(".jog-axis"))) break;
    }
    for (let presses = 0; presses < 4; presses++) await page.keyboard.press("PageDown");
    await position(page, "Z").getByText("\u221210.0000").waitFor();
    const ahead = kind => page.locator(`.jog-ahead [data-ahead="${kind}"]`);
    await counts(ahead("touch"), 0, "the part is hidden");
    assert.equal(await ahead("write").textContent(), "correct G54");
    await counts(page.locator(".jog-ahead .jog-quiet"), 1, "why no more is told");
    await page.keyboard.press("Control+Enter");
    await page.locator(".jog-activation").waitFor();
    await page.keyboard.press("Control+Enter");
    await page.locator(".jog-activation").waitFor({ state: "detached" });
    await page.locator(".jog-deviation").waitFor();
    await tabTo(page, ".jog-reveal");
    await page.keyboard.press("Enter");
    await page.locator(".jog-truth").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("the masks up to SW 6.2", () => {
  // oracle: manual A:3188-3200: each point is stored by its softkey, three are enough
  test("are chosen beside the axis keys, and a corner is stored point by point", async () => {
    const { context, page, problems } = await open(chrome.browser, { path: "#jog" });
    await page.locator("[data-mask=set_edge]").waitFor();
    await page.locator("#jog-version").selectOption("set PW-JOG = 1");
    await page.locator("[data-mask=old_corner]").click();
    await counts(page.locator("[data-mask]"), 0);
    await field(page, "zo").selectOption("G54");
    const places = ["X20 Y-20 Z-8", "X80", "Y-60 X-20 Y40"].map(axes => `move machine ${axes}`);
    const [saved] = await Promise.all([
      page.waitForEvent("download"),
      page.getByRole("button", { name: "Save script" }).click(),
    ]);
    let script = (await (await saved.createReadStream()).toArray()).join("");
    for (const [number, place] of places.entries()) {
      script += `${place}\nstart\n`;
      const buffer = Buffer.from(script);
      await page
        .locator(".jog > input[type=file]")
        .setInputFiles({ name: "practice.jog", mimeType: "text/plain", buffer });
      await page
        .locator('.jog-point[data-waits="true"]')
        .getByText(`Store P${number + 1}`)
        .click();
      await counts(page.locator('.jog-point[data-stored="true"]'), number + 1);
      script += `store P${number + 1}\n`;
    }
    assert.deepEqual([...(await faults(page)), ...(await small(page))], []);
    await page.locator(".jog-calculate").click();
    await page.locator('.jog-deviation[data-near="true"]').waitFor();
    await counts(page.locator(".jog-activation"), 0);
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("before NC start", () => {
  const ahead = (page, kind) => page.locator(`.jog-ahead [data-ahead="${kind}"]`);
  const figures = page => page.locator(".jog-position").allTextContents();

  // oracle: hand: the block is from X 0 Y 0 to X 100 Y 80 with its upper face at Z 0; E_MESS_D_M is 50 mm, the ball has
  // a radius of 3 mm
  test("the help is read, a face is clicked, and what would be written is written", async () => {
    const { context, page, problems } = await open(chrome.browser, { path: "#jog" });
    await page.locator("[data-mask=set_edge]").click();
    await page.locator(".jog-help summary").click();
    await page.locator(".jog-help li").getByText("in front of the edge").waitFor();
    await page.locator(".jog-help li").getByText("Measure workpiece > Edge > Set edge").waitFor();
    assert.deepEqual([...(await faults(page)), ...(await small(page))], []);
    await page.locator(".jog-help summary").click();
    await field(page, "zo").selectOption("G54");
    await field(page, "axis").selectOption("Y");
    await ahead(page, "wrong").getByText("61301").waitFor();
    // the front face, below the middle of the picture
    const stage = page.locator(".jog-stage .stage");
    const { width, height } = await stage.boundingBox();
    await page.locator(".jog-hint:not(:empty)").waitFor();
    const before = await figures(page);
    for (let down = 0.5; down < 0.9; down += 0.05) {
      await stage.click({ position: { x: width / 2, y: height * down } });
      if ((await position(page, "Y").textContent()) === "\u221228.0000") break;
    }
    assert.notDeepEqual(await figures(page), before);
    assert.equal(await position(page, "Y").textContent(), "\u221228.0000");
    assert.ok((await position(page, "Z").textContent()).startsWith("\u2212"), "beside the face, not above it");
    await ahead(page, "touch").getByText("Y \u22123.0000").waitFor();
    const promised = await ahead(page, "write").allTextContents();
    assert.equal(promised.length > 0, true);
    await counts(ahead(page, "activate"), 1);
    await start(page).click();
    await page.locator(".jog-activation").waitFor();
    const written = await page.locator(".jog-written tr").allTextContents();
    const plain = text =>
      text
        .replace(/^write /, "")
        .replace(/[\s:]+/g, " ")
        .trim();
    assert.deepEqual(promised.map(plain), written.map(plain));
    const [saved] = await Promise.all([
      page.waitForEvent("download"),
      page.getByRole("button", { name: "Save script" }).click(),
    ]);
    const script = (await (await saved.createReadStream()).toArray()).join("");
    assert.match(script, /\nmove machine (Z[\d.-]+ )?(X[\d.-]+ )?Y-28 Z-[\d.]+\n(move machine .*\n)*start\n/);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the front face is at Y 0, the probe stands 28 mm in front of it; X stays where it is dragged along Z)
  test("the probe is dragged along an axis, and onto a face", async () => {
    const { context, page, problems } = await open(chrome.browser, { path: "#jog" });
    await page.locator("[data-mask=set_edge]").click();
    const stage = page.locator(".jog-stage .stage");
    await page.locator(".jog-hint:not(:empty)").waitFor();
    const { x, y, width, height } = await stage.boundingBox();
    const held = () => stage.locator('[style*="grab"]').count();
    let ball = null;
    for (let place = 0; place < 900 && !ball; place++) {
      const at = [x + ((place % 30) + 0.5) * (width / 30), y + (Math.floor(place / 30) + 0.5) * (height / 30)];
      await page.mouse.move(...at);
      if (await held()) ball = at;
    }
    assert.ok(ball, "the probe is in sight");
    const first = await figures(page);
    await page.mouse.down();
    await page.mouse.move(ball[0], ball[1] + 30, { steps: 6 });
    await page.mouse.up();
    await drawn(page);
    const lower = await figures(page);
    assert.notDeepEqual(lower, first);
    assert.deepEqual(lower.slice(0, 2), first.slice(0, 2), "along Z alone");
    await page.locator(".jog-head").getByRole("button", { name: "Undo" }).click();
    await drawn(page);
    assert.deepEqual(await figures(page), first);
    for (let down = 0.6; down < 0.9; down += 0.05) {
      await page.mouse.move(...ball);
      await drawn(page);
      await page.mouse.down();
      await page.mouse.move(x + width / 2, y + height * down, { steps: 8 });
      await page.mouse.up();
      await drawn(page);
      if ((await position(page, "Y").textContent()) === "\u221228.0000") break;
      await page.locator(".jog-head").getByRole("button", { name: "Undo" }).click();
      await drawn(page);
    }
    assert.equal(await position(page, "Y").textContent(), "\u221228.0000");
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("every function", () => {
  // oracle: hand (18 functions, B:2602-4083)
  for (const [locale, width, height] of [
    ["en-GB", 1280, 800],
    ["de-DE", 768, 1024],
    ["zh-CN", 390, 844],
  ])
    test(`has its mask and its room, ${locale}, ${width} × ${height}`, async () => {
      const { context, page, problems } = await open(chrome.browser, {
        path: "#jog",
        locale,
        viewport: { width, height },
      });
      await page.locator("[data-mask]").first().waitFor();
      assert.deepEqual([...(await faults(page)), ...(await small(page))], [], "the functions");
      await page.locator(".jog-hint").waitFor();
      for (const window of [
        { width, height },
        { width: 320, height: 200 }, // a desktop at 400 %
      ]) {
        await page.setViewportSize(window);
        assert.deepEqual(await covered(page), [], `${window.width} × ${window.height}`);
      }
      await page.setViewportSize({ width, height });
      const names = await page.locator("[data-mask]").evaluateAll(all => all.map(one => one.dataset.mask));
      assert.equal(names.length, 21, "each softkey of the bars");
      for (const name of names) {
        await page.locator(`[data-mask="${name}"]`).click();
        await page.locator(".jog-title h3").waitFor();
        assert.ok(await page.locator(".jog-field").count(), name);
        assert.deepEqual([...(await faults(page)), ...(await small(page))], [], name);
        await page.locator(".jog-back").click();
      }
      assert.deepEqual(problems, []);
      await context.close();
    });
});

describe("a control without measuring in JOG", () => {
  // oracle: hand (NCT has no such chapter)
  test("offers no practice", async () => {
    const { context, page } = await open(chrome.browser, { path: "" });
    await page.locator(".start-practice").waitFor();
    await page.getByRole("button", { name: "NCT", exact: true }).click();
    await page.locator(".start-practice").waitFor({ state: "detached" });
    await context.close();
  });
});
