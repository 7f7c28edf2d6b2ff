// The check of a machine by what its control exported: pasted, opened and dropped, told, saved, printed.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { counts, open, packages, shared } from "./browser.mjs";
import { openPageMenu } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");

const EXPORT = "CHANDATA(1)\nN18170 $MN_MM_NUM_MAX_FUNC_NAMES=40\nN28082 $MC_MM_SYSTEM_FRAME_MASK='H1'\n_CHBIT[24]=1\n";

/** The dialog, from that of the machine data. */
async function dialog(page) {
  await openPageMenu(page);
  const data = page.locator("#page-actions button:not([disabled])", { hasText: /^Machine data$/ });
  await data.waitFor();
  await data.click();
  await page.getByRole("dialog", { name: "Machine data" }).getByRole("button", { name: "Check a machine" }).click();
  return page.getByRole("dialog", { name: "Check a machine" });
}

describe("the check of a machine", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual A:14245, B:16186 (70 and 80), B:12976-12983, A:15840 (bit 5)
  test("what is pasted is told with limits and alarm, and mended by the lines that are saved", async () => {
    const { context, page, problems } = await open(chrome.browser, { bypassCSP: true });
    const shown = await dialog(page);
    await shown.getByLabel("Export of the control").fill(EXPORT);
    const errors = shown.locator(".exported-group.error li.exported-fault");
    await errors.nth(1).waitFor();
    const frame = await errors.filter({ hasText: "MD28082" }).textContent();
    assert.match(frame, /MM_SYSTEM_FRAME_MASK · Channel 1 · .*line 3/);
    assert.match(frame, /Alarm 61016: The system frame for cycles is missing/);
    const names = await errors.filter({ hasText: "MD18170" }).textContent();
    assert.match(names, /Required: 70 · .*Recommended: 80 · .*2004/s);
    const download = page.waitForEvent("download");
    await shown.getByRole("button", { name: "Save lines to change" }).click();
    const lines = await readFile(await (await download).path(), "utf8");
    assert.match(lines, /^N18170 \$MN_MM_NUM_MAX_FUNC_NAMES=80\nCHANDATA\(1\)\nN28082 .*='H21'\n$/);
    await shown.getByLabel("Export of the control").fill(lines);
    await shown.getByText("Nothing is missing in the data that were compared.").waitFor();
    await page.addScriptTag({ path: axe });
    const wrong = await page.evaluate(() => window.axe.run(".exported").then(({ violations }) => violations));
    assert.deepEqual(
      wrong.map(({ id }) => id),
      [],
    );
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("files are opened or dropped, JOG is left out, paper has the list, a text without data is refused", async () => {
    const { context, page, problems } = await open(chrome.browser);
    const shown = await dialog(page);
    const jog = Buffer.from("MD11602=0\nMD20110=0\n");
    await shown.locator('input[type="file"]').setInputFiles({ name: "JOG.TEA", mimeType: "text/plain", buffer: jog });
    await shown.getByText("JOG.TEA, line 2").waitFor();
    await page.evaluate(() => {
      window.print = () => {}; // the sheet stays until it is printed
    });
    await shown.getByRole("button", { name: "Print" }).click();
    await counts(page.locator(".paper .exported-fault"), 2);
    await page.evaluate(() => dispatchEvent(new Event("afterprint")));
    await counts(page.locator(".paper"), 0);
    await page.evaluate(() => dispatchEvent(new Event("beforeprint"))); // the browser's own command
    await counts(page.locator(".paper .exported-fault"), 2);
    await counts(page.locator(".sheet-program"), 0);
    await page.evaluate(() => dispatchEvent(new Event("afterprint")));
    await counts(page.locator(".paper"), 0);
    await shown.getByLabel("Measuring in JOG").uncheck();
    await shown.getByText("Nothing is missing in the data that were compared.").waitFor();
    const data = await page.evaluateHandle(() => {
      const data = new DataTransfer();
      data.items.add(new File(["hello"], "note.txt"));
      return data;
    });
    await shown.dispatchEvent("drop", { dataTransfer: data });
    // another file comes to the first, which is read on until it is removed
    const removing = shown.getByRole("button", { name: /^Remove / });
    await removing.nth(1).waitFor();
    await shown.getByText("Nothing is missing in the data that were compared.").waitFor();
    await shown.getByRole("button", { name: "Remove JOG.TEA" }).click();
    await counts(removing, 1);
    await shown.getByRole("alert").filter({ hasText: "Nothing in this text" }).waitFor();
    await counts(shown.locator(".exported-fault"), 0);
    await page.keyboard.press("Escape");
    await shown.waitFor({ state: "detached" });
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:1184-1196 (12.6 mm at 6 m/min), hand (2 mm allow 1372.4 mm/min)
  test("the braking path follows from the export or typed values, feeds beyond the deflection are told", async () => {
    const { context, page, problems } = await open(chrome.browser);
    const shown = await dialog(page);
    await shown.getByText("Braking path", { exact: true }).click();
    for (const [name, value] of [
      ["Time from signal", "0.016"],
      ["Lowest deceleration", "1"],
      ["Feed, mm/min", "6000"],
      ["Lowest servo gain", "1"],
    ])
      await shown.getByLabel(name).fill(value);
    await shown.getByText(/12\.6.mm: 1\.6.mm until the command to brake, 5.mm while braking, 6.mm/).waitFor();
    for (const name of ["Time from signal", "Lowest deceleration", "Lowest servo gain"])
      await shown.getByLabel(name).fill("");
    const axis = "MD10050=0.004\nMD10070=4\nMD32300[X1]=1\nMD32200[0,X1]=1\nE_MESS_F=2000\n";
    await shown.getByLabel("Export of the control").fill(axis);
    await shown.getByLabel("Permitted deflection").fill("2");
    await shown.getByText(/Largest feed for this deflection: 1,?372\.4/).waitFor();
    await shown.locator(".exported-group.warning", { hasText: "E_MESS_F" }).waitFor();
    for (const wrong of ["-2", "0", "two"]) {
      await shown.getByLabel("Permitted deflection").fill(wrong);
      await shown.getByText(`The deflection cannot be ${wrong}: enter a number above 0.`).waitFor();
      await shown.getByLabel("Permitted deflection").and(page.locator('[aria-invalid="true"]')).waitFor();
    }
    await shown.getByLabel("Export of the control").fill(axis.replace("[X1]=1", "[X1]=-1"));
    await shown.locator(".exported-group.warning", { hasText: "MD32300" }).waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});
