// Whether all that a page shows has the room that it needs, and can be reached.
import assert from "node:assert/strict";
import { drawn, openTasks } from "./start.mjs";

export const PANELS = ["tasks", "form", "program", "view", "results", "help"];

/** What is wrong with what can be seen now, as short texts. */
export const faults = page =>
  page.evaluate(() => {
    const width = document.documentElement.clientWidth;
    const found = [];
    const say = (what, node) => found.push(`${what}: ${node.outerHTML.slice(0, 100)}`);
    if (document.documentElement.scrollWidth > width)
      found.push(`the page is ${document.documentElement.scrollWidth} wide`);
    const shown = [...document.body.querySelectorAll("*")].filter(
      node => node.checkVisibility({ visibilityProperty: true }) && !node.closest(".skip, .visually-hidden, svg"),
    );
    for (const node of shown) {
      const style = getComputedStyle(node);
      const wide = node.scrollWidth > node.clientWidth + 1 && node.clientWidth > 0;
      if (wide && ["auto", "scroll"].includes(style.overflowX)) say("scrolls sideways", node);
      if (
        wide &&
        ["hidden", "clip"].includes(style.overflowX) &&
        style.textOverflow !== "ellipsis" &&
        style.clipPath === "none"
      )
        say("is cut", node);
      if (!node.matches("button, select, input, [role=tab], [role=treeitem], a")) continue;
      const { left, right } = node.getBoundingClientRect();
      if (left < -0.5 || right > width + 0.5) say("sticks out", node);
      if (node.matches("button") && node.scrollWidth > node.clientWidth + 1) say("is cut", node);
    }
    return found;
  });

/** In the page: the elements whose middle, once it is scrolled to, is not in the window or lies under another. */
const coveredIn = elements =>
  elements
    .filter(element => element.checkVisibility({ visibilityProperty: true }))
    .filter(element => {
      element.scrollIntoView({ block: "center", behavior: "instant" });
      const { left, top, width, height } = element.getBoundingClientRect();
      const hit = document.elementFromPoint(left + width / 2, top + height / 2);
      return !element.contains(hit) && !(hit?.contains(element) === true && hit.matches("label, button"));
    })
    .map(element => element.outerHTML.slice(0, 100));

/**
 * What of the visible elements cannot be reached, when what is still being drawn has found its place. All of them in
 * one question: asked one by one, the buttons of a panel take longer than everything else of a test.
 */
export async function unreachable(locator) {
  let found = await locator.evaluateAll(coveredIn);
  for (let tries = 1; found.length > 0 && tries < 10; tries++) {
    await locator.page().waitForTimeout(100);
    found = await locator.evaluateAll(coveredIn);
  }
  return found;
}

/** By the button of the form, where help has no tab. */
async function openHelp(page) {
  await choosePanel(page, "form");
  assert.deepEqual(await unreachable(page.locator(".help-open")), [], "the way to the help");
  await page.locator(".help-open").click();
  await page.locator("#panel-help").waitFor();
  await drawn(page);
}

/** Closes the help, which lies over what is always in sight. */
async function uncover(page) {
  if (!(await page.locator("#panel-help").isVisible())) return;
  await page.locator('.panel-bar [aria-controls="panel-help"]').click();
  await page.locator("#panel-help").waitFor({ state: "hidden" });
}

/** Shows a panel where only one is to be seen. */
export async function choosePanel(page, name) {
  const tab = page.locator(`.panel-bar [aria-controls="panel-${name}"]`);
  await tab.waitFor({ state: "attached" });
  if (name === "help" && !(await tab.isVisible())) return openHelp(page);
  if (name === "tasks" && !(await tab.isVisible())) {
    assert.deepEqual(await unreachable(page.locator(".rail-more")), [], "the tab of the menu");
    await openTasks(page);
    return drawn(page);
  }
  if (!(await tab.isVisible())) return uncover(page);
  assert.deepEqual(await unreachable(tab), [], `the tab of ${name}`);
  await tab.click();
  await page.locator(`#panel-${name}`).waitFor();
  await drawn(page);
}
