// Every component in every state (www/components.html), in each theme and in forced colours: text and borders can be
// told from their ground, targets are large enough, the focus is seen, and each state differs from the others.
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import { packages, shared } from "./browser.mjs";
import { faults } from "./room.mjs";
import { serve } from "./sources.mjs";

const { PNG } = packages("pngjs");
const LOOKS = [
  { theme: "light" },
  { theme: "dark" },
  { theme: "contrast" },
  { theme: "light", forcedColors: "active" },
];

/** Relative luminance (WCAG 2.2) and contrast of two of them. */
const LUMINANCE = `
  const luminance = rgb => {
    const [red, green, blue] = rgb.slice(0, 3).map(part => part / 255)
      .map(part => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  };
  const contrast = (one, other) => {
    const [light, dark] = [luminance(one), luminance(other)].sort((a, b) => b - a);
    return (light + 0.05) / (dark + 0.05);
  };`;
const contrast = new Function(`${LUMINANCE} return contrast;`)();

/** In the page: texts below 4.5:1 and borders of controls below 3:1; what is disabled and what is drawn is left out. */
const LOW = `(() => {
  ${LUMINANCE}
  const pen = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d", {
    willReadFrequently: true,
  });
  const rgba = colour => {
    pen.clearRect(0, 0, 1, 1);
    pen.fillStyle = colour;
    pen.fillRect(0, 0, 1, 1);
    return [...pen.getImageData(0, 0, 1, 1).data];
  };
  const ground = node => {
    const above = [];
    for (let at = node; at; at = at.parentElement) {
      const colour = rgba(getComputedStyle(at).backgroundColor);
      if (colour[3] > 0) above.unshift(colour);
      if (colour[3] > 250) break;
    }
    const over = (below, [red, green, blue, alpha]) =>
      [red, green, blue].map((part, at) => (part * alpha + below[at] * (255 - alpha)) / 255);
    return above.reduce(over, [255, 255, 255]);
  };
  const found = [];
  const say = (what, node, is) => found.push(what + " " + is.toFixed(2) + " " + node.outerHTML.slice(0, 90));
  for (const node of document.querySelectorAll("figure *")) {
    if (!node.checkVisibility() || node.closest("svg, :disabled, .visually-hidden, option")) continue;
    const style = getComputedStyle(node);
    if ([...node.childNodes].some(one => one.nodeType === 3 && one.data.trim())) {
      const is = contrast(rgba(style.color), ground(node));
      if (is < 4.5) say("text", node, is);
    }
    const bordered = "button:not(.quiet, .primary, [aria-pressed], [role=tab], nav *)";
    if (!node.matches("input:not([type=range]), select, " + bordered)) continue;
    const outside = ground(node.parentElement);
    const is = Math.max(contrast(rgba(style.borderTopColor), outside), contrast(ground(node), outside));
    if (is < 3) say("border", node, is);
  }
  return found;
})()`;

/** In the page: what is too small to be hit, or not on the grid of 4. */
const SMALL = `(() => {
  const found = [];
  for (const node of document.querySelectorAll("figure :is(button, select, input, [role=slider], [role=tab])")) {
    const { width, height } = node.getBoundingClientRect();
    if (node.checkVisibility({ visibilityProperty: true }) && (width < 24 || height < 24))
      found.push(width + " × " + height + " " + node.outerHTML.slice(0, 90));
  }
  const rows = document.querySelectorAll("[data-component=button] button, [data-component=field] :is(.figure, select)");
  for (const node of rows)
    if (node.checkVisibility() && node.offsetHeight !== 32) found.push("height " + node.outerHTML);
  return found;
})()`;

const pixels = async node => PNG.sync.read(await node.screenshot({ animations: "disabled", caret: "hide" }));

/** How many pixels of two pictures differ, and how many by 3:1. */
function difference(one, other) {
  if (one.width !== other.width || one.height !== other.height) return { some: Infinity, clear: Infinity };
  let [some, clear] = [0, 0];
  for (let at = 0; at < one.data.length; at += 4) {
    const [a, b] = [one, other].map(({ data }) => [data[at], data[at + 1], data[at + 2]]);
    if (Math.max(...a.map((part, i) => Math.abs(part - b[i]))) < 12) continue; // another rasteriser
    some++;
    if (contrast(a, b) >= 3) clear++;
  }
  return { some, clear };
}

describe("the components", () => {
  const chrome = shared("neither", { before, after });
  let site;
  before(async () => {
    site = await serve();
  });
  after(() => site.close());

  async function show({ theme, forcedColors }, width = 1280) {
    const context = await chrome.browser.newContext({ viewport: { width, height: 900 }, forcedColors });
    const page = await context.newPage();
    await page.goto(`${site.url}components.html?theme=${theme}`);
    await page.locator("html[data-ready]").waitFor();
    return { context, page };
  }

  for (const look of LOOKS) {
    const name = look.forcedColors ? "forced colours" : look.theme;

    // oracle: peer (WCAG 2.2, 1.4.3, 1.4.11 and 2.5.8)
    test(`can be read and hit, ${name}`, async () => {
      for (const width of [1280, 390]) {
        const { context, page } = await show(look, width);
        assert.ok((await page.locator("figure").count()) > 50, "all are there");
        assert.deepEqual(await page.evaluate(LOW), []);
        assert.deepEqual(await page.evaluate(SMALL), []);
        assert.deepEqual(await faults(page), []);
        await context.close();
      }
    });

    // oracle: peer (WCAG 2.2, 2.4.7 and 2.4.13: as many pixels as a line around it has, at 3:1)
    test(`show the focus, and each state is another picture, ${name}`, async () => {
      const { context, page } = await show(look);
      for (const component of await page.locator("[data-component]").all()) {
        const pictures = [];
        for (const figure of await component.locator("figure").all()) {
          const picture = await pixels(figure);
          const state = await figure.evaluate(
            node => `${node.closest("section").dataset.component}: ${node.dataset.state}`,
          );
          for (const other of pictures)
            assert.ok(difference(picture, other.picture).some > 8, `${state} looks like ${other.state}`);
          pictures.push({ state, picture });
          if (process.env.PROBEWRIGHT_SHOTS) {
            mkdirSync(process.env.PROBEWRIGHT_SHOTS, { recursive: true });
            const file = `${name} ${state}`.replaceAll(/[^a-z0-9]+/gi, "-");
            writeFileSync(`${process.env.PROBEWRIGHT_SHOTS}/${file}.png`, PNG.sync.write(picture));
          }
          const target = figure.locator("button, input, select, [tabindex='0']").and(page.locator(":enabled")).first();
          if (!(await target.count()) || !(await target.isVisible())) continue;
          const { width, height } = await target.boundingBox();
          await page.keyboard.press("Shift"); // the keyboard is in use
          await target.focus();
          const { clear } = difference(await pixels(figure), picture);
          assert.ok(clear > width + height, `${state}: ${clear} pixels show the focus of ${width} × ${height}`);
          await target.blur();
        }
      }
      await context.close();
    });
  }
});
