// One parameter is in focus: what is pointed at or has the keyboard's focus is lit at its field, in the picture, on the
// stage and in the code, wherever it was met.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { open, shared } from "./browser.mjs";
import { openProgram, unfold } from "./start.mjs";

const PROGRAM = "; Ø 50\nR2=50.02\nT1 D1\nM6\n_MVAR=1 _SETVAL=R2 _KNUM=2001\n_TNUM=1 _FA=1 _TSA=0.5\nCYCLE977\nM30\n";
const field = name => `.field[data-field="${name}"]`;
const drawn = name => `.picture .shape[data-field="${name}"]`;
const onStage = name => `.stage svg[aria-hidden] text[data-field="${name}"]`;

/** The page with a program, its call in the form, and everything drawn. */
async function begun(chrome, options) {
  const opened = await open(chrome.browser, options);
  const { page } = opened;
  await page.locator(".cm-content").waitFor();
  await openProgram(page, PROGRAM);
  await page.locator(".call-row").first().click();
  await page.locator(".opened").waitFor({ state: "attached" });
  await unfold(page);
  await page.locator("[data-backend]").first().waitFor({ state: "attached" });
  await page.locator(onStage("_SETVAL")).waitFor({ state: "attached" });
  await page.mouse.move(2, 2);
  return opened;
}

/** Where this parameter is lit; the names of the places. */
const lit = (page, name) =>
  page.evaluate(name => {
    const editor = document.querySelector(".editor").shadowRoot;
    const places = {
      field: document.querySelector(`.field[data-field="${name}"].lit`),
      picture: document.querySelector(`.picture .shape.lit[data-field="${name}"]`),
      call: document.querySelector(`.foot-call .lit[data-field="${name}"]`),
      snippet: document.querySelector(`.snippet .lit[data-field="${name}"]`),
      program: editor.querySelector(`.cm-lit[data-field="${name}"]`),
    };
    const others = [...document.querySelectorAll(".lit"), ...editor.querySelectorAll(".cm-lit")].filter(
      one => one.dataset.field !== name && !one.dataset.also?.split(" ").includes(name),
    );
    return [...Object.keys(places).filter(place => places[place]), ...others.map(one => `also ${one.dataset.field}`)];
  }, name);

const EVERYWHERE = ["field", "picture", "call", "snippet", "program"];

async function litEverywhere(page, name, places = EVERYWHERE) {
  for (let tries = 0; tries < 60; tries++) {
    if (String(await lit(page, name)) === String(places)) return;
    await page.waitForTimeout(50);
  }
  assert.deepEqual(await lit(page, name), places);
}

/** Where it is, once it is drawn: for a moment there is none while the stage draws its names anew. */
async function place(locator) {
  for (let tries = 0; tries < 60; tries++) {
    const box = await locator.boundingBox();
    if (box) return box;
    await locator.page().waitForTimeout(50);
  }
  assert.fail("it has no place");
}

const ink = (page, name) => page.locator(onStage(name)).getAttribute("fill");

describe("the parameter in focus", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("is lit everywhere when its field is pointed at or has the focus", async () => {
    const { context, page, problems } = await begun(chrome);
    const plain = await ink(page, "_SETVAL");
    await page.locator(field("_SETVAL")).hover();
    await litEverywhere(page, "_SETVAL");
    assert.notEqual(await ink(page, "_SETVAL"), plain);
    await page.mouse.move(2, 2);
    await litEverywhere(page, "_SETVAL", []);
    assert.equal(await ink(page, "_SETVAL"), plain);
    await page.locator(`${field("_FA")} .entry-line > .figure`).focus();
    await litEverywhere(page, "_FA");
    await page.locator(onStage("_FA")).waitFor({ state: "attached" });
    await page.locator(field("_SETVAL")).hover(); // the pointer goes before, and what had the focus comes back
    await litEverywhere(page, "_SETVAL");
    await page.mouse.move(2, 2);
    await litEverywhere(page, "_FA");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("is met in picture, call, program and stage, and a click leads to its field", async () => {
    const { context, page, problems } = await begun(chrome);
    const focused = name =>
      page.waitForFunction(name => document.activeElement?.closest(".field")?.dataset.field === name, name);
    await page
      .locator(`${drawn("_SETVAL")} .caption`)
      .first()
      .hover();
    await litEverywhere(page, "_SETVAL");
    await page.locator('.foot-call [data-field="_MVAR"]').hover();
    await litEverywhere(page, "_MVAR", ["field", "call", "snippet", "program"]);
    await page.locator('.foot-call [data-field="_SETVAL"]').click();
    await focused("_SETVAL");
    await page.locator('.cm-value[data-field="_TNUM"]').hover();
    await litEverywhere(page, "_TNUM", ["field", "call", "snippet", "program"]);
    assert.equal(await page.locator('.cm-value[data-field="_SETVAL"]').textContent(), "_SETVAL=R2");
    await page.mouse.move(2, 2);
    await litEverywhere(page, "_SETVAL");
    await page.locator(`${field("_FA")} .entry-line > .figure`).focus();
    const name = await place(page.locator(onStage("_SETVAL")));
    await page.mouse.move(name.x + name.width / 2, name.y + name.height / 2, { steps: 3 });
    await litEverywhere(page, "_SETVAL");
    await page.mouse.down();
    await page.mouse.up();
    await focused("_SETVAL");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("is the one at the cursor of the program, and is no step of the history", async () => {
    const { context, page, problems } = await begun(chrome);
    const undo = page.locator('[aria-keyshortcuts="Control+Z"]').first();
    const before = await undo.getAttribute("title");
    await page.locator('.cm-value[data-field="_KNUM"]').click();
    await page.mouse.move(2, 2);
    await litEverywhere(page, "_KNUM", ["field", "call", "snippet", "program"]);
    await page.keyboard.press("Home");
    await litEverywhere(page, "_MVAR", ["field", "call", "snippet", "program"]);
    assert.equal(await undo.getAttribute("title"), before);
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the system's colours only: lines tell it)
  test("is outlined where the system forces its colours", async () => {
    const { context, page } = await begun(chrome, { forcedColors: "active", reducedMotion: "reduce" });
    await page.locator(field("_SETVAL")).hover();
    await litEverywhere(page, "_SETVAL");
    const outline = selector =>
      page
        .locator(selector)
        .evaluate(one => `${getComputedStyle(one).outlineStyle} ${getComputedStyle(one).outlineWidth}`);
    assert.equal(await outline('.foot-call [data-field="_SETVAL"]'), "solid 2px");
    assert.equal(await outline('.cm-value[data-field="_SETVAL"]'), "solid 2px");
    await context.close();
  });
});
