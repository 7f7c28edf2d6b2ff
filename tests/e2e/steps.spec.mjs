// Steps in columns: the module and plain functions, no browser.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { written } from "./motions.mjs";
import { modules, program } from "./sources.mjs";

let sources, steps, scene, core;
before(async () => {
  sources = await modules();
  [steps, scene, core] = await Promise.all([
    sources.load("/src/core/steps.ts"),
    sources.load("/src/core/scene.ts"),
    program(),
  ]);
});
after(() => sources.close());

/** A run of a worked measurement, with what stands before and after it in a program. */
function begun() {
  const { cycles } = JSON.parse(core.catalogue());
  const { control, cycle, example } = cycles.find(one => one.cycle === "CYCLE977");
  const { setup, snippet } = JSON.parse(core.form(JSON.stringify({ control, cycle, values: example, predict: true })));
  const [x, y, z] = setup.position;
  const start = `MSG("begin")\nR1=2\nSUPA G0 X${x} Y${y}\nSUPA G0 Z${z}\n`;
  const text = `${start}${snippet}\nG1 F300 X=IC(1)\nG2 X=IC(2) CR=1\nM30\n`;
  const run = new core.Run(JSON.stringify({ control, text, setup }));
  while (!run.advance(1000));
  return run;
}

// oracle: self (the same run, whose steps are objects)
test("a run tells the same steps in columns as in objects", () => {
  const { entries } = JSON.parse(begun().view()).trace;
  const answer = begun().finish();
  assert.deepEqual(JSON.parse(answer.view()).trace.entries, []);
  const columns = steps.stepsOf(steps.takeSteps(answer.steps()));
  const objects = steps.courseOf({ entries }).steps;
  assert.ok(entries.length > 30 && entries.some(({ step }) => step === "touch"), `${entries.length} steps`);
  assert.equal(columns.length, entries.length);
  assert.deepEqual([...columns.sorts], [...objects.sorts]);
  entries.forEach((entry, i) => {
    const { from: _, around: __, ...shown } = entry.step === "motion" ? entry : { ...entry };
    if (entry.step !== "motion" && "from" in entry) shown.from = entry.from;
    assert.deepEqual(columns.at(i), shown, `step ${i}`);
  });
  assert.equal(columns.at(entries.length), undefined);
});

// oracle: hand (what is counted from place to place is what is there)
test("any of many steps is found", () => {
  const names = Array.from({ length: 2000 }, (_, i) =>
    i % 3 === 1 || i > 1500 ? { step: "log", text: `ü${i}` } : null,
  );
  const texts = names.filter(Boolean).map(one => new TextEncoder().encode(JSON.stringify(one)));
  const starts = [0];
  for (const { length } of texts) starts.push(starts.at(-1) + length);
  const found = steps.stepsOf({
    sorts: Uint8Array.from(names, one => (one ? 9 : 1)),
    lines: Uint32Array.from(names, (_, i) => i),
    feeds: Float64Array.from(names, () => 100),
    ends: Float64Array.from({ length: 6000 }, (_, i) => i),
    others: Uint8Array.from(texts.flatMap(text => [...text])),
    starts: Uint32Array.from(starts),
  });
  names.forEach((one, i) => {
    const motion = { step: "motion", kind: "positioning", to: [3 * i, 3 * i + 1, 3 * i + 2], feed: 100 };
    assert.deepEqual(found.at(i), one ?? { ...motion, ...(i > 0 && { line: i }) });
  });
});

// oracle: self (the motions of the run that came to its end)
test("a run that goes on shows its motions so far", () => {
  const run = new core.Run(JSON.stringify({ control: "sinumerik", text: written(3000) }));
  run.advance(1000);
  const some = scene.takeScene(run.motions());
  while (!run.advance(1000));
  const all = scene.takeScene(run.finish().scene(1));
  assert.ok(some.path.motions >= 900 && some.path.motions < 1100, `${some.path.motions}`);
  assert.deepEqual(some.ways, all.ways.subarray(0, some.ways.length));
  assert.equal(all.path.motions, 3000);
  const { path, view } = scene.onlyPath(some.path, some.view.entries);
  assert.ok(path.parts.every(({ vertices }) => vertices.length > 0) && view.standings.length === 1);
});
