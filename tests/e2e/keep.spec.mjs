// What is typed is kept in the browser before anything can happen to the page.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { shared } from "./browser.mjs";
import { drawn, lengthField, startWithEditor } from "./start.mjs";

/** Types one key, and ends the page in the middle of what it does: it hears nothing of that. Then it is opened anew. */
async function typeAndDie(page, key) {
  const [context, address] = [page.context(), page.url()];
  const session = await context.newCDPSession(page);
  const crashed = page.waitForEvent("crash");
  await page.keyboard.press(key);
  session.send("Page.crash").catch(() => {});
  await crashed;
  const next = await context.newPage();
  await next.goto(address);
  await next.locator(".cm-content").waitFor();
  await next.locator(".field").first().waitFor();
  return next;
}

const LINE = "N10 G1 X10.5 Y20.25 F500 ; line\n";
const program = size => ({
  name: "part.mpf",
  mimeType: "text/plain",
  buffer: Buffer.from(LINE.repeat(Math.ceil(size / LINE.length))),
});

/** Puts the caret at the end of the first line of the program. */
async function toFirstLine(page) {
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+Home");
  await page.keyboard.press("End");
  await drawn(page);
}

describe("a page that dies right after a key", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("has kept what was typed in the form", async () => {
    const { context, page } = await startWithEditor(chrome);
    await lengthField(page).fill("31.2");
    await page.waitForTimeout(500);
    await lengthField(page).press("End");
    const next = await typeAndDie(page, "5");
    assert.equal(await lengthField(next).inputValue(), "31.25");
    await next.locator('.snippet:has-text("31.25")').waitFor();
    await context.close();
  });

  // oracle: hand
  for (const [how, size] of [
    ["a short", 2_000],
    ["a long", 150_000],
    ["a very long", 400_000],
  ])
    test(`has kept what was typed in ${how} program, each time`, async () => {
      const { context, page } = await startWithEditor(chrome);
      await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
      await page.locator(".panel-program input[type=file]").setInputFiles(program(size));
      await page.locator('.file-name:text-is("part.mpf")').waitFor();
      await page.waitForTimeout(500);
      await toFirstLine(page);
      const second = await typeAndDie(page, "7");
      await second.locator('.cm-line:has-text("; line7")').first().waitFor();
      await toFirstLine(second);
      await second.waitForTimeout(500); // what was kept is laid down anew
      const third = await typeAndDie(second, "8");
      await third.locator('.cm-line:has-text("; line78")').first().waitFor();
      await context.close();
    });
});
