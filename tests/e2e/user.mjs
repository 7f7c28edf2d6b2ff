// Somebody at the page whose actions are counted. Nothing is scrolled for them: what they act on has to be in sight.
import assert from "node:assert/strict";

/** What of an element cannot be seen or reached as it lies now; empty: all of it can. */
function hidden(node) {
  const box = node.getBoundingClientRect();
  if (!node.checkVisibility() || box.width === 0) return "is not shown";
  const beyond = room => box.left < room.left - 1 || box.right > room.right + 1 || box.top < room.top - 1;
  const below = room => box.bottom > room.bottom + 1;
  const rooms = [{ left: 0, top: 0, right: innerWidth, bottom: innerHeight, name: "the window" }];
  for (let one = node.parentElement; one && one !== document.body; one = one.parentElement) {
    if (getComputedStyle(one).overflow === "visible") continue;
    const { left, top, right, bottom } = one.getBoundingClientRect();
    rooms.push({ left, top, right, bottom, name: one.className || one.id || one.tagName });
  }
  const room = rooms.find(one => beyond(one) || below(one));
  if (room) return `is outside ${room.name}`;
  const there = document.elementFromPoint((box.left + box.right) / 2, (box.top + box.bottom) / 2);
  return node.contains(there) || there?.contains(node) ? "" : `is covered by ${there?.outerHTML.slice(0, 80)}`;
}

/** Of an element in focus: what it lacks to be told from the others and seen. */
function unseen(node) {
  const label = node.matches("input[type=checkbox], input[type=radio]") ? node.closest("label") : null;
  const shown = [node, label, node.closest(".field")].filter(Boolean);
  const marked = shown.some(one => {
    const { outlineStyle, outlineWidth } = getComputedStyle(one);
    return outlineStyle !== "none" && parseFloat(outlineWidth) >= 2;
  });
  if (!marked) return "has no outline";
  const box = node.getBoundingClientRect();
  const [x, y] = [
    (box.left + box.right) / 2,
    Math.max(box.top + 1, Math.min((box.top + box.bottom) / 2, innerHeight - 2)),
  ];
  if (box.bottom <= 0 || box.top >= innerHeight || box.right <= 0 || box.left >= innerWidth) return "is out of sight";
  const there = document.elementFromPoint(x, y);
  return node.contains(there) || there?.contains(node) ? "" : `is covered by ${there?.outerHTML.slice(0, 80)}`;
}

/**
 * `did`: actions are clicks, turns of the wheel, files dropped and keys pressed that are no characters of a value;
 * values are those typed; keys are all keys, those of the values too.
 */
export function user(page) {
  const did = { actions: 0, values: 0, keys: 0 };
  const inSight = async target => {
    await target.waitFor();
    let why = "";
    // what has just been opened may still be on its way
    for (let tries = 0; tries < 20; tries++) {
      why = await target.evaluate(hidden);
      if (!why) return;
      await page.waitForTimeout(50);
    }
    assert.fail(`${target}: ${why}`);
  };
  return {
    did,
    inSight,
    async click(target) {
      await inSight(target);
      did.actions++;
      await target.click();
    },
    /** What lies further down is scrolled to. */
    async scroll(target) {
      did.actions++;
      await target.evaluate(node => node.scrollIntoView({ block: "center" }));
      await inSight(target);
    },
    /** Chooses in a list: it is opened, and an entry is clicked. */
    async choose(target, option) {
      await inSight(target);
      did.actions += 2;
      await target.selectOption(option);
    },
    /** A value instead of the one that stands in the field; who is not in it yet clicks there first. */
    async type(target, value) {
      await inSight(target);
      if (!(await target.evaluate(node => node === document.activeElement))) {
        did.actions++;
        await target.click();
      }
      await page.keyboard.press("Control+a");
      await page.keyboard.type(value);
      did.values++;
      did.keys += value.length;
    },
    /** A key, with the keyboard alone: what has the focus afterwards can be told and seen. */
    async press(key) {
      did.actions++;
      did.keys++;
      await page.keyboard.press(key);
      await page.evaluate(() => new Promise(requestAnimationFrame));
      const focus = page.locator(":focus");
      const why = (await focus.count()) ? await focus.evaluate(unseen) : "";
      assert.equal(why, "", `${key}: ${await focus.evaluateAll(all => all.map(one => one.outerHTML.slice(0, 120)))}`);
    },
    /** A file, dropped onto the page from outside. */
    async drop(target, name, text) {
      await inSight(target);
      did.actions++;
      const dataTransfer = await page.evaluateHandle(
        ([title, content]) => {
          const data = new DataTransfer();
          data.items.add(new File([content], title, { type: "text/plain" }));
          return data;
        },
        [name, text],
      );
      for (const type of ["dragenter", "dragover", "drop"]) await target.dispatchEvent(type, { dataTransfer });
    },
  };
}

/** Did no more than this. */
export function within({ did }, most, context) {
  context.diagnostic(JSON.stringify(did));
  for (const [what, count] of Object.entries(most)) assert.ok(did[what] <= count, `${did[what]} ${what} of ${count}`);
}

/** Neither the page as a whole nor anything sideways has to be scrolled. */
export const fits = page =>
  page.evaluate(
    () => document.documentElement.scrollHeight <= innerHeight && document.documentElement.scrollWidth <= innerWidth,
  );
