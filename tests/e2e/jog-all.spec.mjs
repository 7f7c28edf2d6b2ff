// Every function of measuring in JOG, from the menu to what is written: by mouse, by keyboard alone, by touch. What is
// done is tests/data/jog_practice.json, which the core's tests carry out too. Each function is done in one of these
// ways, each way in another language; PROBEWRIGHT_JOG=all does all functions in all ways and languages, which takes
// nine times as long.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import { open, shared } from "./browser.mjs";

const chrome = shared("neither", { before, after });
const WORK = JSON.parse(readFileSync(new URL("../data/jog_practice.json", import.meta.url), "utf8"));
const STEP = 10; // mm, the largest increment of the keys

const at = {
  function: name => `[data-mask="${name}"]`,
  field: name => `#jog-${name}`,
  axis: (axis, sign) => `.jog-axis[data-axis="${axis}${sign}"]`,
  step: `.jog-steps button[aria-pressed]:nth-child(5)`,
  restart: ".jog-actions button:nth-child(2)",
  start: ".jog-start",
  calculate: ".jog-calculate",
  tool: "#jog-tool",
};

/** With a pointer: `press` is a click or a tap, `again` the same at a place where nothing moves meanwhile. */
const pointer = (press, again) => page => ({
  press: selector => page.locator(selector)[press](),
  async times(selector, count) {
    await page.locator(selector)[press]();
    const { x, y, width, height } = await page.locator(selector).boundingBox();
    for (let presses = 1; presses < count; presses++) await again(page, x + width / 2, y + height / 2);
  },
  choose: (selector, value) => page.locator(selector).selectOption(value),
  async type(selector, text) {
    await page.locator(selector)[press]();
    await page.locator(selector).fill(text);
    await page.locator(selector).blur();
  },
  start: () => page.locator(at.start)[press](),
});

/** The key that moves an axis while the focus is in the pad. */
const AXIS_KEYS = {
  "X+": "ArrowRight",
  "X-": "ArrowLeft",
  "Y+": "ArrowUp",
  "Y-": "ArrowDown",
  "Z+": "PageUp",
  "Z-": "PageDown",
};

/** With keys alone: the focus goes where it is wanted by Tab. */
const keys = page => {
  const go = async selector => {
    await page.locator(selector).waitFor({ state: "attached" }); // Calculate comes with the last point
    const way = await page.evaluate(wanted => {
      const [node, now] = [document.querySelector(wanted), document.activeElement];
      if (node === now) return "";
      const precedes = now && now !== document.body && now.compareDocumentPosition(node) & 2; // PRECEDING
      return precedes ? "Shift+Tab" : "Tab";
    }, selector);
    for (let presses = 0; way && presses < 120; presses++) {
      await page.keyboard.press(way);
      if (await page.evaluate(wanted => document.activeElement?.matches(wanted), selector)) return;
    }
    assert.equal(way, "", `no way to ${selector}`);
  };
  return {
    async press(selector) {
      await go(selector);
      await page.keyboard.press("Enter");
    },
    async times(selector, count) {
      await go(selector);
      const key = AXIS_KEYS[await page.locator(selector).getAttribute("data-axis")];
      for (let presses = 0; presses < count; presses++) await page.keyboard.press(key);
    },
    async choose(selector, value) {
      await go(selector);
      const by = await page.locator(selector).evaluate((node, wanted) => {
        const values = [...node.options].map(option => option.value);
        return values.indexOf(wanted) - node.selectedIndex;
      }, value);
      for (let presses = 0; presses < Math.abs(by); presses++)
        await page.keyboard.press(by > 0 ? "ArrowDown" : "ArrowUp");
    },
    async type(selector, text) {
      await go(selector);
      await page.keyboard.type(text);
      await page.keyboard.press("Tab");
    },
    start: () => page.keyboard.press("Control+Enter"),
  };
};

/** One line of what is done. */
async function carryOut(page, hands, line) {
  const [, axis, way] = /^jog ([XYZ])(-?\d+)$/.exec(line) ?? [];
  const [, name, value] = /^(\w+) = (.+)$/.exec(line) ?? [];
  if (axis) return hands.times(at.axis(axis, Number(way) > 0 ? "+" : "-"), Math.abs(Number(way)) / STEP);
  if (line.startsWith("tool ")) return hands.choose(at.tool, line);
  if (line === "start") return hands.start();
  if (line === "calculate") return hands.press(at.calculate);
  if (line === "activate") {
    await page.locator(".jog-activation").waitFor();
    await hands.start();
    return page.locator(".jog-activation").waitFor({ state: "detached" });
  }
  assert.ok(name, line);
  const field = at.field(name);
  const chooses = await page.locator(field).evaluate(node => node instanceof HTMLSelectElement);
  return chooses ? hands.choose(field, value) : hands.type(field, value);
}

const ALL = process.env.PROBEWRIGHT_JOG === "all";

/** The functions in the order of the menu: all of them, or those whose turn it is. */
async function everything(page, hands, { keyboard, turn, turns }) {
  const first = page.locator("[data-mask]").first();
  await first.waitFor();
  const names = await page.locator("[data-mask]").evaluateAll(all => all.map(one => one.dataset.mask));
  assert.deepEqual(names, Object.keys(WORK));
  await hands.press(at.step);
  for (const name of names.filter((_, index) => ALL || index % turns === turn)) {
    if (keyboard) await page.locator("#jog").focus();
    await hands.press(at.function(name));
    await page.locator(".jog-title h3").waitFor();
    for (const line of WORK[name]) await carryOut(page, hands, line);
    assert.equal(
      await page
        .locator(".jog-raised, .jog-refused")
        .allTextContents()
        .then(all => all.join()),
      "",
      name,
    );
    const corrects = WORK[name].some(line => line.startsWith("zo = "));
    await page
      .locator(corrects ? '.jog-deviation[data-near="true"]' : ".jog-written")
      .first()
      .waitFor();
    if (corrects) assert.equal(await page.locator("thead th").nth(1).textContent(), "G54", name);
    await hands.press(at.restart);
    await first.waitFor();
  }
}

describe("every function of measuring in JOG, from the menu to what is written", () => {
  // oracle: hand (the part lies as it is set up: what is written is where it lies)
  const ways = [
    ["by mouse", pointer("click", (page, x, y) => page.mouse.click(x, y)), {}],
    ["by keyboard alone", keys, {}],
    [
      "by touch on a tablet",
      pointer("tap", (page, x, y) => page.touchscreen.tap(x, y)),
      { hasTouch: true, viewport: { width: 768, height: 1024 } },
    ],
  ];
  const languages = ["en-GB", "de-DE", "zh-CN"];
  const runs = ways.flatMap(([how, hands, options], turn) =>
    (ALL ? languages : [languages[turn]]).map(locale => [`${how}, ${locale}`, turn, hands, { ...options, locale }]),
  );
  for (const [how, turn, hands, options] of runs)
    test(how, async () => {
      const asked = { path: "#jog", ...options };
      const { context, page, problems } = await open(chrome.browser, asked);
      await page.locator(`html[lang="${options.locale.slice(0, 2)}"]`).waitFor({ state: "attached" });
      await everything(page, hands(page), { keyboard: hands === keys, turn, turns: ways.length });
      assert.deepEqual(problems, []);
      await context.close();
    });
});

/** A machine whose table swivels about A and B, and a block on it that leans by two degrees about X. */
const SWIVELS = {
  name: "Mill",
  control: "sinumerik",
  plane: "G17",
  active: { tool: 9, edge: 1 },
  tools: { 9: { name: "PROBE", edges: { 1: { type: 710, length: [50, 0, 0], radius: 3 } } } },
  data: { "MD20080[4]": "A", "MD20080[5]": "B", "MD30300[4]": 1, "MD30300[5]": 1 },
  machine: { rotaryCentre: [0, 0, -80] },
  probe: { radius: 3, length: 50 },
  workpiece: [{ shape: "block", size: [200, 160, 40], at: [0, 0, 10], errors: { tilt: [2, 0, 0] } }],
  position: [-20, -20, 60],
};

describe("align plane on a machine with a swivel table", () => {
  // oracle: manual (B:3880-3906: fields of the activation screen) and hand (the part leans 2 degrees about X)
  test("sets the probe perpendicular to the plane", async () => {
    const { context, page, problems } = await open(chrome.browser, { path: "#jog" });
    await page.locator("[data-mask]").first().waitFor();
    const buffer = Buffer.from(JSON.stringify(SWIVELS));
    await page
      .locator(".top input[type=file]")
      .setInputFiles({ name: "Mill.json", mimeType: "application/json", buffer });
    await page.locator("#machine-menu-open", { hasText: "Mill" }).waitFor();
    const hands = pointer("click", (one, x, y) => one.mouse.click(x, y))(page);
    await hands.press(at.step);
    await hands.press(at.function("align_plane"));
    for (const line of WORK.align_plane.slice(0, -1)) await carryOut(page, hands, line);
    const screen = page.locator(".jog-activation");
    await screen.waitFor();
    const fields = () => screen.locator(".jog-field").evaluateAll(all => all.map(one => one.dataset.field));
    assert.deepEqual(await fields(), ["activate", "orient", "retract"]);
    await hands.choose(at.field("orient"), "no");
    await page.locator(at.field("retract")).waitFor({ state: "detached" });
    await hands.choose(at.field("orient"), "yes");
    await page.locator(at.field("retract")).waitFor();
    await screen.getByText("swivels when you press NC start").waitFor();
    const height = async () =>
      Number(await page.locator(".jog-positions tbody tr").last().locator("td").last().textContent());
    const before = await height();
    await hands.start();
    await screen.waitFor({ state: "detached" });
    assert.ok((await height()) > before, "the probe was retracted");
    await page.locator('.jog-deviation[data-near="true"]').waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});

describe("a measurement in JOG and a program", () => {
  // oracle: hand (the mask has X0 = 5 for the left face of the block; the call corrects G54, code 1)
  test("a mask becomes a call, and a call its mask", async () => {
    const { context, page, problems } = await open(chrome.browser, { path: "#jog" });
    const hands = pointer("click", (one, x, y) => one.mouse.click(x, y))(page);
    await hands.press(at.step);
    await hands.press(at.function("set_edge"));
    await page.locator(".jog-program-open").click();
    for (const line of WORK.set_edge) await carryOut(page, hands, line);
    const shown = page.locator(".jog-program-shown");
    const text = await shown.locator("pre").textContent();
    assert.match(text, /^G17 G54\nG0 X-\d.*_SETVAL=5 _MA=1 _KNUM=1 /s);
    assert.ok((await shown.locator("li").count()) > 1, "what differs");
    await page.locator(".jog-program-insert").click();
    const field = name => page.locator(`[data-field="${name}"] :is(input, select)`).first();
    await page.locator(".practise-call").waitFor();
    await page.locator("#panel-form .opened").waitFor(); // the form edits the call
    assert.ok((await page.locator(".cm-content").textContent()).includes("_SETVAL=5"));
    await page.locator(".practise-call").click();
    await page.locator(".jog-title h3").getByText("Set edge").waitFor();
    assert.equal(await field("x0").inputValue(), "5");
    assert.equal(await field("zo").inputValue(), "G54");
    assert.ok(await page.locator(".jog-note").count(), "what has no place in the mask");
    assert.deepEqual(problems, []);
    await context.close();
  });
});
