// What is written over the 3D view, of random calls in random views: nothing lies on anything else.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { random } from "./random.mjs";
import { modules, program } from "./sources.mjs";

let sources, camera, scene, colours, places, motion, takeScene, lettering, core;
before(async () => {
  sources = await modules();
  const load = name => sources.load(`/src/${name}.ts`);
  [camera, scene, colours, places, motion, { takeScene }, lettering] = await Promise.all(
    ["camera", "scene", "colours", "places", "motion", "../core/scene", "lettering"].map(name =>
      load(`preview/${name}`),
    ),
  );
  core = await program();
});
after(() => sources.close());

const SEED = Number(process.env.PROBEWRIGHT_SEED ?? 1);
const measure = words => 7 * words.length;

/** The worked measurement of every variant, with its scene. */
function* calls() {
  for (const cycle of JSON.parse(core.catalogue()).cycles)
    for (const variant of cycle.variants) {
      const plane = cycle.purpose?.plane ?? "G17";
      const values = (variant.planes?.[plane] ?? variant).example;
      const setup = { own: { plane, units: cycle.control === "nct" ? "G21" : "G71" } };
      const { control, cycle: name } = cycle;
      yield { name: `${name} ${variant.mvar}`, values, ask: { control, cycle: name, values, setup, predict: true } };
    }
}

function sceneOf(ask) {
  const answer = core.form_seen(JSON.stringify(ask));
  const source = JSON.parse(answer.view()).outcome && answer.scene(1);
  const data = source ? takeScene(source) : null;
  answer.free();
  return data;
}

/** The cards at the left and the cube with its tools, as the page has them in this view. */
function cards(draw, { width, height }) {
  const card = (left, top, wide, high) => ({ left, top, right: left + wide, bottom: top + high });
  const corner = card(width - 100, 12, 88, 88 + 36 * Math.floor(1 + 4 * draw()));
  return [card(8, 8, 176, 30 + draw() * Math.max(0, height - 60)), corner].filter(() => draw() < 0.8);
}

function drawn(draw, data) {
  const view = { width: 120 + 1500 * draw() ** 2, height: 90 + 900 * draw() ** 2 };
  const entries = data.view.entries;
  const step = draw() < 0.5 ? entries - 1 : Math.floor(draw() * entries);
  const fields = data.view.labels.flatMap(({ field }) => field ?? []);
  const focus = draw() < 0.5 ? null : (fields[Math.floor(draw() * fields.length)] ?? null);
  const built = scene.buildScene(data, colours.LIGHT, { index: step, focus, drawing: draw() < 0.5 });
  const first = { ...camera.initial(), turning: data.view.turning, central: draw() < 0.3 };
  const fitted = camera.fit(camera.orbit(first, 6.3 * draw(), 3 * draw() - 2), view, built.box);
  const looking = draw() < 0.6 ? fitted : camera.zoom(fitted, view, 0.3 * 20 ** draw(), view.width * draw(), 0);
  const frame = { camera: looking, view, ratio: 1, time: step + 1, probe: motion.probeAt(data, step, 1) };
  return { built, frame, focus, taken: cards(draw, view) };
}

const boxOf = ({ written: { width, height }, spot }) => places.around(spot, width, height);

// oracle: hand (no two rectangles have anything in common, and none sticks out of the view)
test("nothing that is written lies on anything else, whatever is looked at from wherever", () => {
  const draw = random(SEED);
  let [count, letters] = [0, 0];
  for (const { name, ask } of calls()) {
    const data = sceneOf(ask);
    if (!data) continue;
    for (let n = 0; n < 4; n++) {
      const { built, frame, taken } = drawn(draw, data);
      const all = lettering.arranged(built, frame, taken, measure).map(boxOf);
      const told = JSON.stringify([name, SEED, frame]);
      for (const [i, box] of all.entries()) {
        assert.ok(places.isInside(box, frame.view), `${told}: sticks out`);
        for (const other of [...taken, ...all.slice(0, i)]) assert.ok(!places.covers(box, other), told);
      }
      count += 1;
      letters += all.length;
    }
  }
  assert.ok(count > 400 && letters > 5 * count, `${count} views with ${letters} words`);
});

// oracle: hand (a stage as on a tablet: every touch has its chip, the cross is there, and the dimension of the field)
test("on a stage of common size nothing is left out that somebody looks for", () => {
  const taken = [
    { left: 8, top: 8, right: 184, bottom: 60 },
    { left: 360, top: 12, right: 448, bottom: 240 },
  ];
  const view = { width: 460, height: 420 };
  for (const { name, ask } of calls()) {
    const data = sceneOf(ask);
    if (!data) continue;
    const step = data.view.entries - 1;
    for (const focus of new Set([null, ...data.view.labels.flatMap(({ field }) => field ?? [])])) {
      const built = scene.buildScene(data, colours.LIGHT, { index: step, focus });
      const turned = { ...camera.initial(), turning: data.view.turning };
      const looking = camera.fit(camera.turn(turned, "iso", motion.toolAt(data, step)?.ball), view, built.box);
      const frame = { camera: looking, view, ratio: 1, time: step + 1, probe: motion.probeAt(data, step, 1) };
      const project = camera.projector(looking, view);
      const there = built.labels.filter(({ during }) => !during || (step + 1 > during[0] && step + 1 <= during[1]));
      const seen = there.filter(({ at }) => {
        const { x, y } = project(at);
        return x >= 0 && y >= 0 && x <= view.width && y <= view.height;
      });
      const wanted = [...seen.filter(({ number }) => number !== undefined), ...there.filter(({ lit }) => lit)];
      const texts = lettering
        .arranged(built, frame, taken, measure)
        .flatMap(({ written, spot }) => written.draw(spot).map(({ text }) => text));
      for (const { text } of wanted) assert.ok(texts.includes(text), `${name} ${focus}: ${text}`);
      for (const axis of "XYZ".slice(0, 1)) assert.ok(texts.includes(axis), `${name}: the cross`);
      assert.equal(focus === null || wanted.some(({ field }) => field === focus) || !built.labels.length, true);
    }
  }
});
