// The columns of a text of the log are put together by choosing.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { shared } from "./browser.mjs";
import { openFirstCall, programWhen, startWithEditor as start } from "./start.mjs";

describe("the columns of a value line", () => {
  const chrome = shared("neither", { before, after });
  const format = '_PROTFORM[4]=1 _PROTFORM[5]=12 _PROTSYM[0]=","';
  const text = `_PROTNAME[1]="LOG_1"\n${format}\n_PROTVAL[2]="R27, INCH "\nCYCLE100\nM30\n`;

  // oracle: hand (the text of the program), manual B:11513-11638 (the values of the sample), B:11437 (widths)
  test("are added and removed by name, and seen as the log prints them", async () => {
    const { context, page, problems } = await start(chrome);
    await openFirstCall(page, text);
    const field = page.locator('.field[data-field="_PROTVAL[2]"]');
    const chips = field.locator(".columns-chip > span");
    const printed = field.locator(".columns-printed");
    await chips.nth(1).waitFor();
    assert.deepEqual(await chips.allTextContents(), ["R parameter R27", "Text “INCH”"]);
    const choice = field.locator(".columns-tools select");
    const wanted = await choice.locator('option:text-matches("_OVR\\\\[4\\\\]$")').textContent();
    await choice.selectOption({ label: wanted });
    await field.getByRole("button", { name: "Add column" }).click();
    const added = await programWhen(page, now => now.includes("_OVR[4]"));
    assert.equal(added, text.replace(" INCH ", " INCH ,_OVR[4]"));
    await printed.filter({ hasText: "79.987" }).waitFor();
    assert.match(await printed.textContent(), /0\.000 {7}, INCH {7}, 79\.987$/);
    await field.getByRole("button", { name: "Remove column “R parameter R27”" }).click();
    const removed = await programWhen(page, now => !now.includes("R27"));
    assert.equal(removed, text.replace("R27, INCH ", " INCH ,_OVR[4]"));
    await page.locator('.field[data-field="_PROTFORM[5]"] .entry-line > .figure').fill("5");
    await field.locator(".columns-narrow li").waitFor();
    assert.match(await field.locator(".columns-narrow").textContent(), /2/);
    const entry = field.locator(".entry-line > .figure");
    const [box, whole] = [await entry.boundingBox(), await field.boundingBox()];
    assert.ok(box.width > whole.width * 0.8, `${box.width} of ${whole.width}`);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
