// The npm package as a stranger meets it: packed, installed into an empty folder, used from Node.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { fileURLToPath } from "node:url";

const pkg = fileURLToPath(new URL("../../pkg/", import.meta.url));
const npm = process.platform === "win32" ? "npm.cmd" : "npm";

describe("the npm package", () => {
  let folder;

  before(() => {
    const packed = readdirSync(pkg).filter(name => /^probewright-.*\.tgz$/.test(name));
    assert.equal(packed.length, 1, `cargo xtask dist packs one file: ${packed}`);
    folder = mkdtempSync(join(tmpdir(), "probewright-"));
    writeFileSync(join(folder, "package.json"), JSON.stringify({ private: true, type: "module" }));
    execFileSync(npm, ["install", "--offline", "--no-audit", "--no-fund", join(pkg, packed[0])], { cwd: folder });
  });
  after(() => rmSync(folder, { recursive: true, force: true }));

  const inNode = script => {
    writeFileSync(join(folder, "used.mjs"), script);
    return JSON.parse(execFileSync(process.execPath, ["used.mjs"], { cwd: folder, maxBuffer: 1 << 26 }));
  };

  // oracle: manual B:5593-5700 (CYCLE977), hand: what is written is read back with the values that were typed
  test("writes, reads, changes, checks and runs a call", () => {
    const told = inNode(`
      import { apply, load, program } from "probewright";
      const probewright = await load();
      const values = { _MVAR: "1", _SETVAL: "132", _KNUM: "0", _FA: "2", _TSA: "3", _TMV: "0.7" };
      const control = "sinumerik";
      const form = probewright.form({ control, cycle: "CYCLE977", values, predict: true });
      const text = "G17\\n" + program(control, form.snippet);
      const { calls } = probewright.read({ control, text });
      const { steps } = probewright.change({ control, text, call: 0, name: "_SETVAL", value: "131.5" });
      const changed = apply(text, steps);
      const run = probewright.run({ control, text: changed, setup: form.setup });
      const wrong = probewright.form({ control, cycle: "CYCLE977", values: { ...values, _TSA: "-1" } });
      let refused = "";
      try { probewright.form({ control: "fanuc", cycle: "X", values: {} }); } catch (error) { refused = error.message; }
      console.log(JSON.stringify({ version: probewright.version, calls, text, changed, results: run.results.length,
        wrong: wrong.diagnostics.map(one => one.param), refused }));
    `);
    assert.equal(told.version, JSON.parse(readFileSync(join(pkg, "package.json"), "utf8")).version);
    assert.deepEqual(
      told.calls.map(call => [call.cycle, call.values._SETVAL]),
      [["CYCLE977", "132"]],
    );
    assert.equal(told.changed, told.text.replace("_SETVAL=132 ", "_SETVAL=131.5 "));
    assert.ok(told.results > 5, `${told.results} results`);
    assert.ok(told.wrong.includes("_TSA"));
    assert.match(told.refused, /fanuc/);
  });

  // oracle: peer (`probewright convert` gives this text); hand: assignments stand in a line before the call
  test("converts a call whose edits begin at one place", () => {
    const told = inNode(`
      import { apply, load } from "probewright";
      const probewright = await load();
      const text = "CYCLE977(101,1,,1,50,,,2,5)\\nM30\\n";
      const { edits } = probewright.convert({ control: "sinumerik", text, call: 0, style: "direct" });
      const direct = apply(text, [edits]);
      const { calls } = probewright.read({ control: "sinumerik", text: direct });
      const both = [{ from: 2, to: 2, insert: "1" }, { from: 2, to: 2, insert: "2" }, { from: 2, to: 3, insert: "X" }];
      console.log(JSON.stringify({ direct, calls: calls.map(one => [one.cycle, one.values._SETVAL]),
        same: Math.min(...edits.map(one => one.from)), ordered: apply("abcd", [both]) }));
    `);
    assert.match(told.direct, /^_MVAR=101 [^\n]*\n(?:_[^\n]*\n)*CYCLE977\nM30\n$/);
    assert.deepEqual(told.calls, [["CYCLE977", "50"]]);
    assert.equal(told.same, 0);
    assert.equal(told.ordered, "ab12Xd");
  });

  // oracle: self (README.md)
  test("does what its README shows", () => {
    const [, example] = /```js\n([\s\S]*?)```/.exec(
      readFileSync(join(folder, "node_modules/probewright/README.md"), "utf8"),
    );
    const quiet = example.replaceAll("console.log", "void ");
    const figures = "{ calls: calls.length, complete: form.complete, run: run.results.length }";
    const told = inNode(`${quiet}\nconsole.log(JSON.stringify(${figures}));`);
    assert.deepEqual([told.calls, told.complete], [1, true]);
    assert.ok(told.run > 5);
  });

  // oracle: hand: a program that uses wrong names does not compile
  test("brings its types, with documentation", () => {
    const types = readFileSync(join(folder, "node_modules/probewright/index.d.ts"), "utf8");
    assert.match(types, /\/\*\* The measuring calls of a part program/);
    writeFileSync(
      join(folder, "typed.mts"),
      [
        'import { load } from "probewright";',
        "const p = await load();",
        'const n: number = p.form({ control: "nct", cycle: "G101", values: {} }).fields.length;',
        "// @ts-expect-error",
        'p.form({ control: "fanuc" });',
        "export { n };\n",
      ].join("\n"),
    );
    const tsc = fileURLToPath(new URL("../../www/node_modules/typescript/bin/tsc", import.meta.url));
    const flags = [
      "--noEmit",
      "--strict",
      "--target",
      "ES2022",
      "--module",
      "NodeNext",
      "--moduleResolution",
      "NodeNext",
    ];
    execFileSync(process.execPath, [tsc, ...flags, "typed.mts"], { cwd: folder, stdio: "pipe" });
  });
});
