// The drawing of every variant of every cycle: its captions can be read, and each field stands out in it.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { open, shared } from "./browser.mjs";
import { unfold } from "./start.mjs";

/** In the page: goes through all variants; gives the captions that run into another or stick out of the drawing. */
async function unreadable() {
  const drawn = () =>
    new Promise(resolve => {
      requestAnimationFrame(() => requestAnimationFrame(resolve));
    });
  const closed = () => document.querySelector('.tree-item[aria-expanded="false"]');
  while (closed()) {
    closed().click();
    await drawn();
  }
  const found = [];
  const variants = [...document.querySelectorAll(".tree-item.level-3")];
  for (const variant of variants) {
    variant.click();
    await drawn();
    const frame = document.querySelector(".picture").getBoundingClientRect();
    const boxes = [...document.querySelectorAll(".picture .caption")].map(node => ({
      text: node.textContent,
      box: node.getBoundingClientRect(),
    }));
    const told = what =>
      found.push(`${document.querySelector("#form-title").textContent} ${variant.textContent}: ${what}`);
    for (const [index, { text, box }] of boxes.entries()) {
      if (
        box.left < frame.left - 1 ||
        box.right > frame.right + 1 ||
        box.top < frame.top - 1 ||
        box.bottom > frame.bottom + 1
      )
        told(`${text} sticks out`);
      for (const other of boxes.slice(0, index)) {
        const across = Math.min(box.right, other.box.right) - Math.max(box.left, other.box.left);
        const down = Math.min(box.bottom, other.box.bottom) - Math.max(box.top, other.box.top);
        // a line has some air above and below its letters; side by side, less than a space makes one word of two
        if (across > -5 && down > 4) told(`${text} runs into ${other.text}`);
      }
    }
  }
  return { found, count: variants.length };
}

/** In the page: the first variant of each cycle; gives the fields for which nothing in the drawing stands out. */
async function unfollowed() {
  const drawn = () =>
    new Promise(resolve => {
      requestAnimationFrame(() => requestAnimationFrame(resolve));
    });
  const found = [];
  let fields = 0;
  const litFor = name =>
    [...document.querySelectorAll(".picture .shape.lit")].some(
      ({ dataset: { field, also } }) => field === name || also?.split(" ").includes(name),
    );
  for (const variant of document.querySelectorAll(".tree-item.level-2 + .tree-item.level-3")) {
    variant.click();
    await drawn();
    for (const field of document.querySelectorAll(".panel-form .fields .field")) {
      fields++;
      field.querySelector("input").focus();
      // the picture follows the form by a frame or more
      for (let frames = 0; frames < 60 && !litFor(field.dataset.field); frames++) await drawn();
      if (!litFor(field.dataset.field))
        found.push(`${document.querySelector("#form-title").textContent}: ${field.dataset.field}`);
    }
  }
  return { found, fields };
}

describe("the drawings", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("have captions that can be read, and follow the focus", async () => {
    const { context, page, problems } = await open(chrome.browser);
    await page.locator(".picture .caption").first().waitFor();
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
    const { found, count } = await page.evaluate(unreadable);
    assert.ok(count > 100, `${count} variants`);
    assert.deepEqual(found, []);
    await unfold(page);
    const followed = await page.evaluate(unfollowed);
    assert.ok(followed.fields > 200, `${followed.fields} fields`);
    assert.deepEqual(followed.found, []);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
