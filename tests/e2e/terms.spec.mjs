// Concepts and terms of the manuals, and commissioning as a list of steps.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { counts, packages, shared } from "./browser.mjs";
import { find, keptWhen, startWithEditor as start } from "./start.mjs";

const axe = packages.resolve("axe-core/axe.min.js");

async function command(page, name) {
  await find(page, name);
  await page.getByRole("option", { name }).first().waitFor();
  await page.keyboard.press("Enter");
}

async function accessible(page, root) {
  await page.addScriptTag({ path: axe });
  const wrong = await page.evaluate(where => window.axe.run(where).then(({ violations }) => violations), root);
  assert.deepEqual(
    wrong.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`),
    [],
  );
}

describe("concepts, terms and commissioning", () => {
  const chrome = shared("neither", { before, after });

  // oracle: hand
  test("a term is found by a word, and a field leads to its concept", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await command(page, "Concepts and terms");
    const dialog = page.getByRole("dialog", { name: "Concepts and terms" });
    await dialog.getByText("Trigger point", { exact: true }).first().waitFor();
    await dialog.getByRole("searchbox").fill("additive offset _DLNUM");
    await dialog.getByText("Additive offset (DL)", { exact: true }).waitFor();
    assert.ok((await dialog.locator(".term:visible").count()) < 6);
    await dialog.getByRole("searchbox").fill("nobody says this");
    await dialog.getByText("No guide, concept or term has these words.").waitFor();
    await accessible(page, "dialog[open]");
    await page.keyboard.press("Escape");
    await page.keyboard.press("Escape");
    await counts(page.locator("dialog[open]"), 0);
    await page.locator(".fields input[id$='_FA']").first().focus();
    await page.getByRole("button", { name: "Concept", exact: true }).click();
    await page.locator("details.term-page[open]").getByText(/_FA/).first().waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:1265-1284 (with the weighting factor 2 three parts are corrected); hand (with 10 none)
  test("the picture of a concept follows what is dragged", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await command(page, "Concepts and terms");
    const mean = page.locator("#concept-mean-value");
    await mean.locator("summary").click();
    await mean.getByText("3 of the ten parts").waitFor();
    const shapes = mean.locator(".term-picture svg");
    const before = await shapes.innerHTML();
    await mean.getByRole("slider", { name: /Weighting factor/ }).press("End");
    await mean.getByText("none of the ten parts").waitFor();
    assert.notEqual(await shapes.innerHTML(), before);
    const path = page.locator("#concept-measuring-path");
    await path.locator("summary").click();
    await path.locator(".term-picture .shape.touch").first().waitFor();
    await path.getByRole("slider").press("Home");
    assert.equal(await path.getByRole("textbox").inputValue(), "1");
    await accessible(page, "dialog[open]");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:1265-1284 (with the weighting factor 2 three parts are corrected), hand
  test("a value of the picture is typed, with the reason where it cannot be", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await command(page, "Concepts and terms");
    const mean = page.locator("#concept-mean-value");
    await mean.locator("summary").click();
    const field = mean.getByRole("textbox", { name: /Weighting factor/ });
    const slider = mean.getByRole("slider");
    await field.fill("10");
    await mean.getByText("none of the ten parts").waitFor();
    assert.equal(await slider.inputValue(), "10");
    const drawn = await mean.locator(".term-picture svg").innerHTML();
    for (const [text, why] of [
      ["11", "Enter 1 to 10."],
      ["2.5", "Enter a whole number from 1 to 10."],
      ["x", "Enter a number."],
    ]) {
      await field.fill(text);
      await mean.getByRole("alert").getByText(why).waitFor();
      assert.equal(await field.getAttribute("aria-invalid"), "true");
    }
    await accessible(page, "dialog[open]");
    assert.equal(await mean.locator(".term-picture svg").innerHTML(), drawn);
    await field.fill("2");
    await mean.getByText("3 of the ten parts").waitFor();
    assert.equal(await field.getAttribute("aria-invalid"), null);
    await field.press("ArrowUp");
    assert.equal(await field.inputValue(), "3");
    assert.equal(await slider.inputValue(), "3");
    await mean.getByText("2 of the ten parts").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:764-836 (the axis of each length by plane)
  test("tool lengths follow the plane, and the page is printed as it is shown", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await page.evaluate(() => {
      window.print = () => {
        document.documentElement.dataset.printed = "yes";
      };
    });
    await command(page, "Concepts and terms");
    const lengths = page.locator("#concept-tool-lengths");
    await lengths.locator("summary").click();
    for (const [plane, axes] of [
      ["17", "L1 in Z, L2 in Y, L3 in X"],
      ["18", "L1 in Y, L2 in X, L3 in Z"],
      ["19", "L1 in X, L2 in Z, L3 in Y"],
    ]) {
      await lengths.getByRole("textbox").fill(plane);
      await lengths.getByText(axes).waitFor();
      const captions = await lengths.locator(".term-picture .caption").allTextContents();
      for (const name of ["F", "L1", "L2", "L3", `G${plane}`])
        assert.ok(captions.includes(name), `${name}: ${captions}`);
    }
    await lengths.getByRole("button", { name: "Print page" }).click();
    await page.locator("html[data-printed]").waitFor();
    await page.emulateMedia({ media: "print" });
    const paper = page.locator(".concept-paper");
    await paper.getByText("L1 in X, L2 in Z, L3 in Y").waitFor();
    assert.ok((await paper.locator("svg .shape").count()) > 10);
    const { height } = await paper.boundingBox();
    assert.ok(height < 980, `${height}`); // A4 between its margins, CSS pixels
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand (the words are those of the glossary)
  test("a term within a text is explained under the pointer and at the focus", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await command(page, "Concepts and terms");
    const concept = page.locator("#concept-mean-value");
    await concept.locator("summary").click();
    const term = concept.locator(".gloss").first();
    const tip = page.getByRole("tooltip");
    await term.hover();
    await tip.waitFor();
    const named = await tip.locator("strong").textContent();
    assert.ok((await tip.locator("span").textContent()).length > 40, named);
    await accessible(page, "dialog[open]");
    await page.keyboard.press("Escape");
    await tip.waitFor({ state: "hidden" });
    await page.locator("dialog[open]").waitFor(); // the dialog stays
    await page.mouse.move(0, 0);
    await term.focus();
    await tip.getByText(named, { exact: true }).waitFor();
    assert.equal(await term.getAttribute("aria-describedby"), await tip.getAttribute("id"));
    await page.keyboard.press("Tab");
    assert.notEqual(await term.getAttribute("aria-describedby"), "gloss-tip");
    await page.locator("#terms-search").focus();
    await page.keyboard.press("Escape");
    await page.keyboard.press("Escape");
    await counts(page.locator("dialog[open]"), 0);
    // beside a field, in its strip
    await page.locator(".fields input[id$='_NMSP']").first().focus();
    await page.locator(".explain .gloss").first().hover();
    await tip.waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual B:12816-12823
  test("a connection and a term are found by the search and shown", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await find(page, "DBX107");
    await page.getByRole("option", { name: /DBX107\.1/ }).click();
    await page.waitForFunction(() => document.activeElement?.id === "connection-plc-2");
    await page.keyboard.press("Escape");
    await counts(page.locator("dialog[open]"), 0);
    await find(page, "mono probe");
    await page.getByRole("option", { name: "Mono probe", exact: true }).first().click();
    await page.waitForFunction(() => document.activeElement?.closest("[id$=mono-probe]"));
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: manual A:13964-13968
  test("versions that work together stand in a table", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await command(page, "Commissioning and upgrade");
    await page.locator("#steps-path").selectOption({ label: "Versions that work together" });
    const row = page.getByRole("row", { name: /^NCU 6.2/ });
    assert.deepEqual(await row.getByRole("cell").allTextContents(), ["6.2", "yes", "no", "yes", "no", "any"]);
    await accessible(page, "dialog[open]");
    assert.deepEqual(problems, []);
    await context.close();
  });

  // oracle: hand
  test("a step that is done is done when the page comes back", async () => {
    const { context, page, problems } = await start(chrome, { bypassCSP: true });
    await command(page, "Commissioning and upgrade");
    const way = page.locator("#steps-path");
    await way.selectOption("adv-new");
    await page.getByText("0 of 13 done").waitFor();
    await page.locator(".commission-steps input").nth(1).check();
    await page.getByText("1 of 13 done").waitFor();
    await accessible(page, "dialog[open]");
    await way.selectOption({ label: "Connections of probes" });
    await page.getByText("X121.1", { exact: false }).first().waitFor();
    await page.keyboard.press("Escape");
    await keptWhen(page, kept => Object.values(kept.steps ?? {}).includes(true));
    await page.reload();
    await page.locator(".fields").first().waitFor();
    await command(page, "Commissioning and upgrade");
    await page.locator("#steps-path").selectOption("adv-new");
    await page.getByText("1 of 13 done").waitFor();
    assert.deepEqual(problems, []);
    await context.close();
  });
});
