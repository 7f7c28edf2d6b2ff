// The macros of NCT in the browser: each brings its worked measurement in every plane, which is carried out and drawn.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { open, shared } from "./browser.mjs";
import { openMachine, searchTasks } from "./start.mjs";

const MACROS = [
  "G101",
  "G102",
  "G103",
  "G104",
  "G105",
  "G106",
  "G107",
  "G108",
  "G109",
  "G110",
  "G65 P9920",
  "G65 P9969",
];

async function choose(page, name) {
  await searchTasks(page, name);
  await page.locator(`.hits[data-search="${name}"] .hit`).first().click();
  await page.waitForFunction(text => document.querySelector(".snippet")?.textContent.includes(text), name);
}

describe("NCT macros", () => {
  const chrome = shared("neither", { before, after });

  // oracle: manual C:472 (the axes follow the plane); a worked measurement that nobody changed turns with the plane and
  // stops at no alarm
  test("measure in all planes", async () => {
    const { context, page, problems } = await open(chrome.browser);
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" }); // all cycles are known
    for (const name of MACROS) {
      await choose(page, name);
      for (const plane of ["G18", "G19", "G17"]) {
        await openMachine(page);
        await page.locator("#machine-plane").selectOption(plane);
        const axis = { G17: "Z", G18: "Y", G19: "X" }[plane];
        await page.waitForFunction(
          ([wanted, axial, digitizing]) =>
            document.querySelector("#machine-plane").value === wanted &&
            (!digitizing || new RegExp(`${axial}-`).test(document.querySelector(".snippet").textContent)),
          [plane, axis, name === "G65 P9969"],
        );
        await page.locator("#page-outcome .outcome").waitFor();
        await page.waitForFunction(() => document.querySelector("#page-outcome .empty").hidden);
        assert.deepEqual(
          await page.locator("#page-outcome .alarms li[data-severity=error]").allTextContents(),
          [],
          `${name} ${plane}`,
        );
        assert.ok((await page.locator(".picture *").count()) > 3, `${name} ${plane}`);
        assert.doesNotMatch(await page.locator(".answer-line").textContent(), /when the call can be simulated/);
      }
    }
    assert.deepEqual(problems, []);
    await context.close();
  });
});
