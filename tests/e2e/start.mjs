// What several tests begin with: the page as far as they need it, and what is kept of its work.
import assert from "node:assert/strict";
import { open } from "./browser.mjs";

/** Where the work of the browser is kept. */
export const STORE = "probewright-1";

/** All sections of the form stand open, as who knows the cycle has them; `folded: true` leaves them as they come. */
export async function unfold(page) {
  await page.locator(".field").first().waitFor({ state: "attached" });
  await page.locator('.fields-all[aria-pressed="false"]').evaluateAll(buttons => {
    for (const button of buttons) button.click();
  });
  await drawn(page); // a field that is folded takes no focus
}

/** The page with its first form drawn. */
export async function start(chrome, { folded = false, ...options } = {}) {
  const opened = await open(chrome.browser, options);
  await opened.page.locator(".field").first().waitFor();
  if (!folded) await unfold(opened.page);
  return opened;
}

/** The page with its editor and its first form drawn. */
export async function startWithEditor(chrome, options) {
  const opened = await open(chrome.browser, options);
  await opened.page.locator(".cm-content").waitFor();
  await opened.page.locator(".field").first().waitFor();
  await unfold(opened.page);
  return opened;
}

/** The page with all cycles known. */
export async function startWithCycles(chrome, options) {
  const opened = await open(chrome.browser, options);
  await opened.page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
  await unfold(opened.page);
  return opened;
}

/** After the redraw that follows what was done last. */
export const drawn = page =>
  page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Once the focus is there: it may come with the redraw. */
export async function focused(page, target) {
  const wanted = typeof target === "string" ? page.locator(target) : target;
  await wanted.and(page.locator(":focus")).waitFor();
}

/** The work as it is kept now. */
export const stored = page => page.evaluate(name => JSON.parse(localStorage.getItem(name) ?? "{}"), STORE);

/** What is kept, once it holds what is waited for. */
export async function keptWhen(page, wanted) {
  for (let tries = 0; tries < 100; tries++) {
    const state = await stored(page);
    if (wanted(state)) return state;
    await page.waitForTimeout(50);
  }
  assert.fail(`never kept: ${wanted}`);
}

/** The first field that has to be filled and counts in mm. */
export const lengthField = page =>
  page.locator('.field:has(.unit:text-is("mm")):has([aria-required="true"]) .entry-line > .figure').first();

/** The menu of the page, by the button that it has here. */
export async function openPageMenu(page) {
  if (!(await page.locator("#page-actions").isVisible()))
    await page.locator('[popovertarget="page-actions"]:visible').click();
  await page.locator("#page-actions").waitFor();
}

/** The tree of tasks, where it is not to be seen already; a phone has it in its menu. */
export async function openTasks(page) {
  const tab = page.locator('.panel-bar [aria-controls="panel-tasks"]');
  await tab.waitFor({ state: "attached" }); // before it, a page that is loading looks like a phone's
  await page.locator("#task-search").waitFor({ state: "attached" });
  if (await page.locator("#task-search").isVisible()) return;
  if (await tab.isVisible()) await tab.click();
  else {
    await openPageMenu(page);
    await page.locator("#page-actions .on-phone").first().click();
  }
  await page.locator("#task-search").waitFor();
}

/** Words in the search over everything. */
export async function searchTasks(page, words) {
  await openTasks(page);
  await page.locator("#task-search").fill(words);
}

/** The panel of simulated errors, where it is not to be seen already. */
export async function openErrors(page) {
  if (!(await page.locator(".sliders").isVisible())) await page.locator(".errors-open").click();
  await page.locator(".sliders").waitFor();
}

/** A further action of the form, from its menu. */
export async function fromFormMenu(page, name) {
  await page.locator("#form-menu-open").click();
  await page.locator("#form-menu").getByRole("button", { name }).click();
}

/** An action of the page, from its menu. */
export async function fromPageMenu(page, name) {
  await openPageMenu(page);
  await page.locator("#page-actions").getByRole("button", { name, exact: true }).click();
}

/** What the machine begins with, where it is not to be seen already. */
export async function openMachine(page) {
  if (!(await page.locator("#machine-menu").isVisible())) await page.locator("#machine-menu-open").click();
}

/** Something done with the machine profiles, from the machine's menu. */
export async function fromMachineMenu(page, name) {
  await openMachine(page);
  await page.locator("#machine-menu").getByRole("button", { name }).click();
}

/** The change that is shown before it is made. */
export const shownChange = page => page.locator("dialog.difference[open]");

/** Converts the open call to this style, and applies what is shown. */
export async function convert(page, style) {
  await page.locator(`.call-ways [data-style="${style}"]`).click();
  await shownChange(page).getByRole("button", { name: "Apply" }).click();
  await shownChange(page).waitFor({ state: "hidden" });
}

/** Opens this program as a file. */
export async function openProgram(page, text, name = "part.mpf") {
  await page
    .locator(".panel-program input[type=file]")
    .setInputFiles({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
  await page.locator('.notice:has-text("Program opened.")').waitFor();
}

/** Opens this program as a file, and its first call as a form. */
export async function openFirstCall(page, text, name) {
  await openProgram(page, text, name);
  await page.locator(".call-row").first().click();
  await page.locator(".opened").waitFor();
}

/** The program, once it is kept and is what is waited for. */
export async function programWhen(page, wanted) {
  const program = ({ control, programs }) => programs?.[control] ?? "";
  return program(await keptWhen(page, state => wanted(program(state))));
}

/** The program is still this one, a while after what was done last. */
export async function still(page, text) {
  await page.waitForTimeout(400);
  assert.equal(await programWhen(page, now => now === text), text);
}

/** The page with its editor, its first form and all cycles known. */
export async function startWithAll(chrome, options) {
  const opened = await startWithEditor(chrome, options);
  await opened.page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
  return opened;
}

/** Opens the palette by its key, once it has come, and types into it, until all that is searched has come. */
export async function find(page, text) {
  const palette = page.locator("dialog.palette[open]");
  for (let tries = 0; tries < 150 && !(await palette.count()); tries++) {
    await page.keyboard.press("Control+k");
    await page.waitForTimeout(100);
  }
  await page.locator("#palette-search").fill(text);
  await page.locator(`#palette-list[data-search="${text}"][data-complete]`).waitFor();
}
