// Guides: each is linked from what it tells about, found by the words that people have for it, and leads there.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { fileURLToPath } from "node:url";
import { counts, packages, shared } from "./browser.mjs";
import { modules, program } from "./sources.mjs";
import { find, startWithEditor as start } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");
const root = fileURLToPath(new URL("../../", import.meta.url));
const [, ...rows] = readFileSync(join(root, "core/src/manual/guides.tsv"), "utf8").trimEnd().split("\n");
const guides = rows.map(row => row.split("\t")).map(([id, , , , way]) => ({ id, way }));
/** Ways that lead to a panel; all others open a dialog. */
const PANELS = ["measurements", "panel-form", "run-program", "tab-log"];

// oracle: self: the list of guides itself tells about the dialog that shows them
test("each guide is linked from what it tells about, and each link has its guide", () => {
  const sources = readdirSync(join(root, "www/src"), { recursive: true }).filter(name => name.endsWith(".ts"));
  const texts = sources.map(name => readFileSync(join(root, "www/src", name), "utf8")).join("\n");
  const linked = [...texts.matchAll(/guide(?:Button|Part)\("([\w-]+)"\)/g)].map(([, id]) => id);
  const wanted = guides.filter(({ way }) => way !== "terms").map(({ id }) => id);
  assert.deepEqual([...new Set(linked)].sort(), wanted.sort());
});

// oracle: hand (what somebody types at the machine who wants to know)
const MEANT = [
  ["Cpk", "series"],
  ["capability", "series"],
  ["rework", "around"],
  ["guard band", "certainty"],
  ["JUnit", "scenarios"],
  ["screen", "screens"],
  ["repeatability", "repeat"],
  ["INITIAL.INI", "machine-check"],
  ["dry run", "run-modes"],
  ["CSV", "record"],
  ["self-test", "installation"],
  ["Messunsicherheit", "certainty"],
  ["Nacharbeit", "around"],
  ["Messergebnisbild", "screens"],
  ["Prozessfähigkeit", "series"],
  ["Satzsuchlauf", "run-modes"],
  ["Bremsweg", "braking"],
  ["einlesen", "measured"],
  ["Wichtungsfaktor", "limits"],
  ["不确定度", "certainty"],
  ["返修", "around"],
  ["过程能力", "series"],
  ["测量结果画面", "screens"],
  ["重复精度", "repeat"],
  ["程序段搜索", "run-modes"],
];

test("guides are found by the words of every language, whatever the page speaks", async () => {
  const [sources, core] = await Promise.all([modules(), program()]);
  const [texts, search] = await Promise.all(["texts", "search/index"].map(name => sources.load(`/src/${name}.ts`)));
  await Promise.all([texts.laterWords(), texts.everyLanguage()]);
  for (const language of texts.languages()) {
    await texts.choose([language]);
    const search_ = search.createSearch(JSON.parse(core.catalogue()), JSON.parse(core.alarms()));
    for (const [typed, meant] of MEANT) {
      const hits = search_(typed, "sinumerik").find(({ kind }) => kind === "guide")?.hits ?? [];
      const keys = hits.slice(0, 3).map(({ entry }) => entry.key);
      assert.ok(keys.includes(`guide-${meant}`), `${language}: ${typed} finds ${keys}`);
    }
  }
  await sources.close();
});

describe("guides in the page", () => {
  const chrome = shared("neither", { before, after });
  const opened = page => page.locator("details.term-page[open]");

  // oracle: hand
  test("a word leads to a guide, the guide to its dialog, and the dialog back to the guide", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await find(page, "Cpk");
    await page.getByRole("option", { name: "Series of parts" }).first().click();
    await opened(page).getByText("Cp compares", { exact: false }).waitFor();
    await page.addScriptTag({ path: axe });
    const wrong = await page.evaluate(() => window.axe.run("dialog[open]").then(({ violations }) => violations));
    assert.deepEqual(
      wrong.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`),
      [],
    );
    await opened(page).getByRole("button", { name: "Go there" }).click();
    const dialog = page.getByRole("dialog", { name: "Series of parts" });
    await dialog.locator('[data-guide="series"]').click();
    await opened(page).getByText("Cp compares", { exact: false }).waitFor();
    await counts(page.getByRole("button", { name: "Go there" }), 0); // it is behind this dialog
    await page.keyboard.press("Escape");
    await page.locator('dialog[open] [data-guide="series"]:focus').waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: self: what a guide leads to has the link back
  test("every dialog of a guide has its link", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    const dialogs = guides.filter(({ way }) => !PANELS.includes(way) && way !== "terms");
    assert.ok(dialogs.length > 8);
    for (const { id, way } of dialogs) {
      await find(page, "");
      await page.locator(`#palette-command-${way}`).click();
      await page.locator(`dialog[open] [data-guide="${id}"]`).waitFor({ state: "attached" });
      await page.locator("dialog[open]").evaluateAll(all => {
        for (const one of all) one.close();
      });
    }
    assert.deepEqual(problems, []);
    await context.close();
  });
});
