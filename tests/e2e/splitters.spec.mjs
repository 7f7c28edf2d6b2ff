// What is dragged between two areas: with the pointer, with keys and a double click, within limits, and kept.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { shared } from "./browser.mjs";
import { drawn, keptWhen, startWithEditor as start } from "./start.mjs";

const SIZE = { viewport: { width: 1440, height: 900 } };
/** Each with the panel that it sizes, and the way of the arrow that makes it larger. */
const SPLITTERS = [
  { name: "form", panel: ".panel-form", side: "width", larger: "ArrowRight", pull: [60, 0] },
  { name: "dock", panel: ".panel-program", side: "height", larger: "ArrowUp", pull: [0, -60] },
  { name: "program", panel: ".panel-program", side: "width", larger: "ArrowRight", pull: [60, 0] },
];

const splitter = (page, { name }) => page.locator(`.splitter-${name}`);
const size = async (page, { panel, side }) => (await page.locator(panel).boundingBox())[side];
const near = (found, wanted, what) => assert.ok(Math.abs(found - wanted) <= 2, `${what}: ${found}, not ${wanted}`);

describe("a splitter", () => {
  const chrome = shared("neither", { before, after });

  for (const one of SPLITTERS) {
    // oracle: hand (WAI-ARIA, window splitter)
    test(`of the ${one.name} follows the pointer, and is kept`, async () => {
      const { context, page, problems } = await start(chrome, SIZE);
      const before = await size(page, one);
      const { x, y, width, height } = await splitter(page, one).boundingBox();
      const [from, to] = [x + width / 2, y + height / 2];
      await page.mouse.move(from, to);
      await page.mouse.down();
      await page.mouse.move(from + one.pull[0] / 2, to + one.pull[1] / 2);
      await page.mouse.move(from + one.pull[0], to + one.pull[1]);
      near(await size(page, one), before + 60, "while it is dragged");
      await page.mouse.up();
      const { sizes } = await keptWhen(page, ({ sizes }) => sizes?.[one.name] > 0);
      near(sizes[one.name], before + 60, "kept");
      await page.reload();
      await splitter(page, one).waitFor();
      await page.locator(".cm-content").waitFor();
      near(await size(page, one), before + 60, "after a reload");
      assert.deepEqual(problems, []);
      await context.close();
    });

    // oracle: hand
    test(`of the ${one.name} obeys keys within its limits, and tells them`, async () => {
      const { context, page, problems } = await start(chrome, SIZE);
      const before = await size(page, one);
      const value = async name => Number(await splitter(page, one).getAttribute(`aria-value${name}`));
      const press = async key => {
        await splitter(page, one).press(key);
        await drawn(page);
      };
      await press(one.larger);
      near(await size(page, one), before + 24, "a step");
      for (const [key, limit] of [
        ["Home", "min"],
        ["End", "max"],
      ]) {
        await press(key);
        near(await size(page, one), await value(limit), key);
        near(await value("now"), await value(limit), `${key}, told`);
      }
      await press(one.larger);
      near(await size(page, one), await value("max"), "not beyond");
      await page.mouse.move(0, 0);
      const box = async panel => (await page.locator(panel).boundingBox()) ?? { width: 0, height: 0 };
      assert.ok((await box(".panel-view")).height > 100 || one.name === "program", "what is beside it stays");
      assert.deepEqual(problems, []);
      await context.close();
    });

    // oracle: hand
    test(`of the ${one.name} gives all on a double click or Enter, and takes it back`, async () => {
      const { context, page, problems } = await start(chrome, SIZE);
      const before = await size(page, one);
      const max = async () => Number(await splitter(page, one).getAttribute("aria-valuemax"));
      for (const act of [() => splitter(page, one).dblclick(), () => splitter(page, one).press("Enter")]) {
        await act();
        await drawn(page);
        near(await size(page, one), await max(), "all");
        await act();
        await drawn(page);
        near(await size(page, one), before, "back");
      }
      assert.deepEqual(problems, []);
      await context.close();
    });
  }

  // oracle: hand (a window that became smaller leaves the stage its room)
  test("leaves its neighbours room in a smaller window", async () => {
    const { context, page, problems } = await start(chrome, SIZE);
    await splitter(page, SPLITTERS[0]).press("End");
    await drawn(page);
    await page.setViewportSize({ width: 1280, height: 800 });
    await drawn(page);
    assert.ok((await page.locator(".panel-view").boundingBox()).width >= 300);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
