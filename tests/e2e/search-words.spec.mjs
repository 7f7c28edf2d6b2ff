// The search finds what people call a thing, in every language, whatever language the page speaks: plain functions, no
// browser.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { modules, program } from "./sources.mjs";

let sources, texts, search, core;
before(async () => {
  [sources, core] = await Promise.all([modules(), program()]);
  [texts, search] = await Promise.all(["texts", "search/index"].map(name => sources.load(`/src/${name}.ts`)));
  await Promise.all([texts.laterWords(), texts.everyLanguage()]);
});
after(() => sources.close());

// oracle: hand (what the word means at the machine): typed, and the entries of which one is among the first three
const MEANT = [
  ["hole", /^cycle977-hole/],
  ["bore", /^cycle977-hole/],
  ["dowel", /^cycle977-shaft/],
  ["slot", /^cycle977-groove/],
  ["datum", /-zero$|^cycle978/],
  ["work offset", /-zero$|^cycle978/],
  ["pick up a corner", /^cycle961/],
  ["edge finder", /^cycle(961|978|976)/],
  ["3D taster", /^cycle97[36]/],
  ["bohrung", /^cycle977-hole/],
  ["Bohrungsmitte", /^cycle977-hole/],
  ["Zapfen", /^cycle977-shaft/],
  ["Nullpunkt", /-zero$|^cycle978/],
  ["Nullpunkt setzen", /-zero$|^cycle978/],
  ["Bezugspunkt", /-zero$/],
  ["Ausrichten", /^cycle(998|119)/],
  ["Werkzeugvermessung", /^cycle9(71|72|82)/],
  ["Schutzzone", /-zone/],
  ["Innendurchmesser", /^cycle97[79]-hole/],
  ["Kantentaster", /^cycle978/],
  ["Mitte setzen", /^cycle977/],
  ["镗孔", /^cycle977-hole/],
  ["工件零点", /^cycle961/],
  ["分中", /^cycle97[79]/],
  ["对刀", /^cycle9(71|72|82)/],
  ["找正", /^cycle(998|119)/],
  ["碰边", /^cycle978/],
  ["寻边", /^cycle978/],
  ["四面分中", /^cycle977-(pocket|island)/],
  ["找中心", /^cycle97[79]/],
];

test("words of every language are found in every language", async () => {
  const languages = texts.languages();
  assert.deepEqual(languages, ["de", "en", "zh"]);
  for (const language of languages) {
    assert.equal(await texts.choose([language]), language);
    const find = search.createSearch(JSON.parse(core.catalogue()), JSON.parse(core.alarms()));
    for (const [typed, meant] of MEANT) {
      const hits = find(typed, "sinumerik").find(({ kind }) => kind === "measurement")?.hits ?? [];
      const keys = hits.slice(0, 3).map(({ entry: { variant, key } }) => variant?.key ?? key);
      assert.ok(
        keys.some(key => meant.test(key)),
        `${language}: ${typed} finds ${keys}`,
      );
    }
  }
});

// oracle: peer (published lists, data and remedies of newer controls, pages of the TNC), whatever the control in use is
test("what newer controls and other makers have leads to its explanation", async () => {
  for (const language of ["en", "de", "zh"]) {
    await texts.choose([language]);
    const all = [core.catalogue(), core.alarms(), core.elsewhere()].map(one => JSON.parse(one));
    const find = search.createSearch(...all);
    for (const [typed, kind, code] of [
      ["SD54600", "elsewhere", "SD54600"],
      ["54600", "elsewhere", "SD54600"],
      ["MD51740", "elsewhere", "MD51740"],
      ["51740", "elsewhere", "MD51740"],
      ["61444", "alarm", "61444"],
      ["61422", "alarm", "61422"],
      ["S_MD", "elsewhere", "S_MD"],
      ["S_TZL", "elsewhere", "S_TZL"],
      ["CYCLE996", "elsewhere", "CYCLE996"],
      ["995", "elsewhere", "CYCLE995"],
      ["CYCLE150", "elsewhere", "CYCLE150"],
      ["9960", "elsewhere", "CYCLE9960"],
      ["TCH PROBE 421", "elsewhere", "TCH PROBE 421"],
      ["Heidenhain", "elsewhere", "TCH PROBE 400"],
    ])
      for (const control of ["sinumerik", "nct"]) {
        const hits = find(typed, control).find(group => group.kind === kind)?.hits ?? [];
        const codes = hits.slice(0, 30).map(({ entry }) => entry.code);
        assert.ok(codes.includes(code), `${language}: ${typed} finds ${codes}`);
        if (typed !== "Heidenhain") assert.equal(codes[0], code, `${language}: ${typed}`);
      }
  }
});

// oracle: hand (the words of the help pages, which come later, are not asked for)
test("what is explained has its name before its help has come", async () => {
  const { explained } = JSON.parse(core.catalogue());
  assert.ok(explained.length > 100, `${explained.length} of them`);
  for (const language of ["en", "de", "zh"]) {
    await texts.choose([language]);
    const unnamed = explained.map(({ key }) => key).filter(key => texts.t(key) === key);
    assert.deepEqual(unnamed, [], language);
  }
});

// oracle: hand
test("the words of the help come once, however often they are asked for", async () => {
  const problems = [];
  const { error } = console;
  console.error = problem => problems.push(problem);
  await texts.choose(["de"]);
  await Promise.all([texts.helpWords(), texts.helpWords()]);
  await texts.helpWords();
  console.error = error;
  assert.deepEqual(problems, []);
  assert.equal(texts.hasHelp(), true);
});

// oracle: hand (German for a date; English for a zero point)
test("what a word means in the language of the page comes first", async () => {
  for (const [language, meant] of [
    ["de", /^cycle113/],
    ["en", /-zero$|^cycle978/],
  ]) {
    await texts.choose([language]);
    const find = search.createSearch(JSON.parse(core.catalogue()), JSON.parse(core.alarms()));
    const [{ entry }] = find("datum", "sinumerik").find(({ kind }) => kind === "measurement").hits;
    assert.match(entry.variant?.key ?? entry.key, meant, language);
  }
});
