// The definition files of a machine: what differs is saved, and read back into the machine.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, describe, test } from "node:test";
import { counts, open, packages, shared } from "./browser.mjs";
import { openPageMenu } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");
const NAME = "Definition files, value assignments";

/** The dialog, from that of the machine data. */
async function dialog(page) {
  await openPageMenu(page);
  const data = page.locator("#page-actions button:not([disabled])", { hasText: /^Machine data$/ });
  await data.waitFor();
  await data.click();
  await page.getByRole("dialog", { name: "Machine data" }).getByRole("button", { name: NAME }).click();
  return page.getByRole("dialog", { name: NAME });
}

describe("definition files", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual B:13276-13288 (lines of the example), B:12971-12974 (16 KB for two channels with JOG), self (what is
  // saved is read back)
  test("files are read back, what differs is saved, memory follows the channels", async () => {
    const { context, page, problems } = await open(chrome.browser, { bypassCSP: true });
    const shown = await dialog(page);
    await shown.getByText("Nothing differs from delivery.").waitFor();
    // a number is entered in a field of the page, not in one of the browser
    const looks = node => [getComputedStyle(node).backgroundColor, getComputedStyle(node).borderRadius];
    const text = await page.locator('input[type="text"]').first().evaluate(looks);
    assert.deepEqual(await shown.getByLabel("Channels that measure").evaluate(looks), text);
    await shown.getByLabel("Channels that measure").fill("2");
    await shown.getByText(/MD18150 at least 16 /).waitFor();
    const read = (name, text) =>
      shown.locator('input[type="file"]').setInputFiles({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
    await read("GUD6.DEF", "N10 DEF NCK INT _CVAL[4]=(2,2,0,0)\nN40 DEF CHAN INT _EVMVNUM[2]=(10,10)\n_CBIT[14]=1\n");
    await shown.getByText(/7 values read, 7 changed, 0 not accepted/).waitFor();
    const lines = /DEF CHAN REAL _EV\[10\].*;N13 DEF NCK REAL _KB.*N12 DEF NCK REAL _WP\[2,11\]/s;
    assert.match(await shown.textContent(), lines);
    const download = page.waitForEvent("download");
    await shown.getByRole("button", { name: "Save PW_MEAS_VALUES.MPF" }).click();
    const program = await readFile(await (await download).path(), "utf8");
    assert.match(program, /^%_N_PW_MEAS_VALUES_MPF\n;\$PATH=\/_N_MPF_DIR\n.*N\d+ _CBIT\[14\]=1\nN\d+ M2\n$/s);
    await page.addScriptTag({ path: axe });
    const wrong = await page.evaluate(() => window.axe.run(".exported").then(({ violations }) => violations));
    assert.deepEqual(
      wrong.map(({ id }) => id),
      [],
    );
    // sizes of arrays stay with the machine, over a reload too
    await read("GUD6.DEF", "DEF NCK BOOL _CBIT[17]\n");
    await shown.getByText(/Sizes kept with the machine: _CBIT\[17\]/).waitFor();
    assert.match(await shown.textContent(), /DEF NCK BOOL _CBIT\[17\]/);
    await read("x.txt", "G0 X1\n");
    await shown.getByRole("alert").filter({ hasText: /./ }).waitFor();
    // what a newer control exported makes the machine one of those, and has lines of its own
    await read("A.TEA", "N54600 $SNS_MEA_WP_BALL_DIAM[0]=5.9\nCHANDATA(1)\nN55634 $SCS_MEA_FEED_PLANE_VALUE=700\n");
    await shown.getByText(/2 values read.*generation 3/).waitFor();
    assert.match(await shown.textContent(), /N54600 \$SNS_MEA_WP_BALL_DIAM\[0\]=5\.9\n/);
    await counts(shown.getByText("Memory of user data"), 0);
    assert.deepEqual(problems, []);
    await context.close();
  });
});
