// Camera, parts and picking of the 3D view: plain functions, no browser.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { modules, program } from "./sources.mjs";

let sources, places, camera, scene, hole, colours, pick, hold, motion, vec, arrays, labels, points;
before(async () => {
  sources = await modules();
  const load = name => sources.load(`/src/${name}.ts`);
  let demo;
  [camera, scene, demo, colours, pick, hold, motion, vec, arrays, labels, points, places] = await Promise.all(
    [
      "preview/camera",
      "preview/scene",
      "preview/demo/scenes",
      "preview/colours",
      "preview/pick",
      "preview/hold",
      "preview/motion",
      "preview/vec",
      "core/scene",
      "preview/labels",
      "preview/points",
      "preview/places",
    ].map(load),
  );
  hole = demo.hole(await program());
});
after(() => sources.close());

const view = { width: 800, height: 600 };
const near = (actual, expected, tolerance = 1e-9) => {
  assert.equal(actual.length, expected.length);
  for (const [i, value] of actual.entries())
    assert.ok(Math.abs(value - expected[i]) <= tolerance, `${actual} is not ${expected}`);
};

// oracle: hand (X to the right and Z up seen from the front, Y up from the top, Y to the right from +X)
test("standard views look along the axes of the machine", () => {
  const seen = name => camera.basis(camera.turn(camera.initial(), name));
  near([...seen("front").right, ...seen("front").up], [1, 0, 0, 0, 0, 1]);
  near([...seen("top").right, ...seen("top").up], [1, 0, 0, 0, 1, 0]);
  near([...seen("right").right, ...seen("right").up], [0, 1, 0, 0, 0, 1]);
});

// oracle: hand (a view from the side from which the probe comes: the viewer is where its holder is)
test("an oblique view never looks at the back of the plane", () => {
  for (const held of [
    [0, 0, 1],
    [0, 1, 0],
    [1, 0, 0],
  ]) {
    const { back, up } = camera.basis(camera.turn(camera.initial(), "iso", held));
    assert.ok(vec.dot(back, held) > 0.3, `${held}: ${back}`);
    assert.ok(up[2] > 0.5, "Z stays upright");
  }
});

// oracle: hand (a turning machine: Z to the right and X up seen from the front, right-handed, so Y towards the viewer)
test("a turning machine stands as it does in the shop", () => {
  const { right, up, back } = camera.basis({ ...camera.turn(camera.initial(), "front"), turning: true });
  near([...right, ...up, ...back], [0, 0, 1, 1, 0, 0, 0, 1, 0]);
});

// oracle: hand (identities)
test("matrix and projection put a point at the same place", () => {
  const looking = camera.pan(camera.orbit(camera.initial(), 0.4, -0.2), 31, -17);
  const point = [12, -7, 5];
  const { x, y } = camera.projector(looking, view)(point);
  const m = camera.matrix(looking, view, 500);
  const clip = [0, 1].map(row => m[row] * point[0] + m[4 + row] * point[1] + m[8 + row] * point[2] + m[12 + row]);
  near(clip, [x / (view.width / 2) - 1, 1 - y / (view.height / 2)]);
});

// oracle: hand (identities)
test("zooming keeps what is under the pointer, panning follows the pointer", () => {
  const looking = camera.orbit(camera.initial(), 1, 0.1);
  const point = [30, 20, -10];
  const before = camera.projector(looking, view)(point);
  const zoomed = camera.projector(camera.zoom(looking, view, 3.7, before.x, before.y), view)(point);
  near([zoomed.x, zoomed.y], [before.x, before.y]);
  const panned = camera.projector(camera.pan(looking, 40, -25), view)(point);
  near([panned.x - before.x, panned.y - before.y], [40, -25]);
});

// oracle: hand (the tighter direction fills its room exactly; what is covered at the left is no room)
for (const covered of [0, 150])
  test(`fitting shows the whole box, as large as it may be in the middle of what is right of ${covered}`, () => {
    const box = { min: [100, -20, 5], max: [180, 40, 25] };
    const fitted = camera.fit(camera.turn(camera.initial(), "iso"), view, box, covered);
    const corners = vec.boxCorners(box).map(camera.projector(fitted, view));
    const span = values => [Math.min(...values), Math.max(...values)];
    const [left, right] = span(corners.map(({ x }) => x));
    const [top, bottom] = span(corners.map(({ y }) => y));
    near([left + right, top + bottom], [view.width + covered, view.height], 1e-6);
    near([Math.max((right - left) / (view.width - covered), (bottom - top) / view.height)], [0.8], 1e-9);
  });

// A scene that holds this besides nothing.
const made = ({ view, ...filled }) => ({ ...arrays.NOTHING, ...filled, view: { ...arrays.NOTHING.view, ...view } });
// Straight motions, as the core puts them down: entry, from, to.
const moving = motions => ({
  ways: Float64Array.from(motions.flatMap(([, from, to]) => [...from, ...to, 0, 1])),
  wayEntries: Uint32Array.from(motions.map(([entry]) => entry)),
  wayKinds: Uint8Array.from(motions.map(() => 1)),
});

// oracle: hand
test("a part stands as the last rotary axis before left it", () => {
  const [before, turned] = [0, 1].map(entry => ({ entry, places: [], whole: [[], []], ground: [0, 10] }));
  const data = made({ view: { standings: [before, turned] } });
  assert.deepEqual(
    [-1, 0, 1, 2, 9].map(index => motion.standingAt(data, index).standing === turned),
    [false, false, true, true, true],
  );
});

// oracle: hand (identities: what is under the pointer is drawn there, and its face looks at the viewer)
test("a place of the part is found where it is drawn", () => {
  for (const central of [false, true]) {
    const looking = camera.fit(
      { ...camera.turn(camera.initial(), "iso"), central },
      view,
      scene.buildScene(hole, colours.LIGHT).box,
    );
    const project = camera.projector(looking, view);
    const eye = camera.eye(looking, view, 500);
    let found = 0;
    for (let x = 5; x < view.width; x += 30)
      for (let y = 5; y < view.height; y += 30) {
        const face = pick.faceAt(hole, 0, { camera: looking, view }, x, y);
        if (!face) continue;
        found++;
        const seen = project(face.at);
        near([seen.x, seen.y], [x, y], 1e-6);
        assert.ok(vec.dot(face.normal, vec.sub(eye, face.at)) > 0, `${face.normal} at ${face.at}`);
      }
    assert.ok(found > 20, `${found} of the part`);
    assert.equal(pick.faceAt(hole, 0, { camera: looking, view }, 1, 1), null);
  }
});

// oracle: hand (seen from the front X is to the right and Z up, and Y towards the viewer cannot be pulled along)
test("a drag moves along the axis that it follows on the screen", () => {
  const looking = camera.turn(camera.initial(), "front");
  const from = (dx, dy) => hold.pulled([3, 4, 5], { camera: looking, view }, 100, 100)(100 + dx, 100 + dy);
  assert.equal(from(3, 2), null);
  assert.equal(from(80, 10).axis, 0);
  near([from(80, 10).way], [80 / looking.scale]);
  assert.equal(from(-5, -60).axis, 2);
  near([from(-5, -60).way], [60 / looking.scale]);
  const pull = hold.pulled([3, 4, 5], { camera: looking, view }, 100, 100);
  assert.equal(pull(120, 100).axis, 0);
  assert.equal(pull(120, 300).axis, 0, "an axis that was chosen stays");
});

// oracle: hand (entries 3 to 6 of the fixed scene: measuring, touch, retract, back)
test("picking finds the entry under the pointer and nothing far from all paths", () => {
  const built = scene.buildScene(hole, colours.LIGHT);
  const looking = camera.fit(camera.turn(camera.initial(), "top"), view, built.box);
  const { x, y } = camera.projector(looking, view)(motion.probeAt(hole, 3, 0.5));
  const found = pick.pick(built.lines, looking, view, x, y);
  assert.ok([3, 5].includes(found), `${found}`); // measuring and retract lie on each other
  assert.equal(pick.pick(built.lines, looking, view, 5, 5), null);
});

// oracle: self (what is kept from the scene before is what would be made anew) and hand
test("solids are made anew when one of them is another, and only then", () => {
  const copy = () => ({ ...hole, vertices: hole.vertices.slice(), corners: hole.corners.slice() });
  const first = scene.buildScene(hole, colours.LIGHT);
  const lines = scene.buildScene({ ...copy(), ways: new Float64Array(), wayEntries: new Uint32Array() }, colours.LIGHT);
  assert.equal(lines.mesh, first.mesh);
  assert.equal(lines.ground, first.ground);
  assert.ok(lines.lines.length < first.lines.length);
  const moved = copy();
  moved.vertices[0] += 0.001;
  const other = scene.buildScene(moved, colours.LIGHT);
  assert.notEqual(other.mesh, first.mesh);
  assert.notDeepEqual(other.mesh.vertices, first.mesh.vertices);
  assert.notDeepEqual(scene.buildScene(copy(), colours.DARK).mesh.vertices, first.mesh.vertices);
  const again = scene.buildScene(copy(), colours.LIGHT);
  assert.deepEqual([again.mesh, again.ends, again.box], [first.mesh, first.ends, first.box]);
});

// oracle: hand
test("the probe is on its motion and stays where the last motion ended", () => {
  const motions = [
    [0, [0, 0, 0], [10, 0, 0]],
    [2, [10, 0, 0], [10, 8, 0]],
  ];
  const data = made({ ...moving(motions), stands: Float64Array.of(10, 0, 0, 10, 0, 0, 10, 8, 0) });
  const at = (index, fraction) => motion.probeAt(data, index, fraction);
  near(at(0, 0.25), [2.5, 0, 0]);
  near(at(1, 0.5), [10, 0, 0]);
  near(at(2, 0.5), [10, 4, 0]);
  near(at(9, 0), [10, 8, 0]);
  assert.equal(motion.probeAt(arrays.NOTHING, 0, 0), null);
});

// oracle: hand (a quarter of a circle of 10 mm in three pieces)
test("an arc is travelled on its pieces", () => {
  const on = part => [10 * Math.cos((part * Math.PI) / 2), 10 * Math.sin((part * Math.PI) / 2), 0];
  const pieces = [0, 1, 2].map(i => [...on(i / 3), ...on((i + 1) / 3), i / 3, (i + 1) / 3]);
  const data = made({
    ways: Float64Array.from(pieces.flat()),
    wayEntries: Uint32Array.of(4, 4, 4),
    wayKinds: new Uint8Array(3),
  });
  for (const part of [0, 1 / 3, 2 / 3, 1]) near(motion.probeAt(data, 4, part), on(part), 1e-9);
  near(motion.probeAt(data, 4, 1 / 6), vec.mix(on(0), on(1 / 3), 0.5), 1e-9);
  const lines = scene.paths(data, 4, colours.LIGHT);
  near(
    lines.map(({ style: { entry, during } }) => entry + during[1] - during[0]),
    [4 + 1 / 3, 4 + 1 / 3, 4 + 1 / 3],
    1e-9,
  );
});

// oracle: hand (CSS colour notations)
test("colours are read in the notations of CSS", () => {
  near(colours.parse("#f80"), [1, 0x88 / 255, 0, 1]);
  near(colours.parse("#33669980"), [0.2, 0.4, 0.6, 128 / 255]);
  near(colours.parse("rgb(51 102 153 / 0.5)"), [0.2, 0.4, 0.6, 0.5]);
});

// oracle: hand (the probe until T3 is called at entry 1, then the mill, then the probe again)
test("what is in use follows the tool changes, and the fit has room for it", () => {
  const motions = [
    [0, [0, 0, 0], [1, 0, 0]],
    [2, [1, 0, 0], [0, 0, 0]],
  ];
  const extent = [
    [-5, -5, 0],
    [5, 5, 50],
  ];
  const tools = [
    { ball: [0, 0, 1], tip: [0, 0, 0], carried: false },
    { tip: [0, 0, 0], extent, carried: false },
  ];
  const whole = [
    [-3, -3, -3],
    [4, 3, 3],
  ];
  const standings = [{ entry: 0, places: [], whole, ground: [0, 10] }];
  const using = inUse => made({ ...moving(motions), stands: new Float64Array(12), view: { tools, inUse, standings } });
  const data = using([
    [0, 0],
    [1, 1],
    [3, 0],
  ]);
  assert.deepEqual(
    [0, 1, 2, 3].map(index => tools.indexOf(motion.toolAt(data, index))),
    [0, 1, 1, 0],
  );
  assert.equal(motion.toolAt(using([]), 2), undefined);
  const { max } = scene.buildScene(using([[0, 1]]), colours.LIGHT).box;
  near(max, [5, 5, 50]);
});

// oracle: hand (a step of 40 mm that is 0.1 mm larger; X −20 from a zero at Z 4, as a diameter)
test("a drawing has its diameters in words, and the reading counts as on the control", () => {
  const axes = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const reading = { at: [0, 0, 4], axes, diameter: true };
  const said = (kind, diameter, more) => ({ kind, at: [20, 0, 0], text: [{ key: "Ø", args: { diameter } }], ...more });
  const view = {
    ...arrays.NOTHING.view,
    labels: [
      said("touched", "40.000", { from: 0, to: 1 }),
      said("touched", "40.100", { from: 1 }),
      said("diameter", "40.100", { upper: true, field: "_SETVAL" }),
      said("nominal", "40.000 +0.100", { upper: true, field: "_SETVAL" }),
    ],
  };
  const say = ({ key, args }) => `${key}${args.diameter}`;
  const found = labels.labelsOf(view, colours.LIGHT, say, { drawing: true, focus: null });
  assert.deepEqual(
    found.map(({ text }) => text),
    ["Ø40.000", "Ø40.100", "Ø40.100", "Ø40.000 +0.100"],
  );
  assert.deepEqual(
    found.map(({ during }) => during),
    [[0, 1], [1, Infinity], undefined, undefined],
  );
  assert.deepEqual(
    found.map(({ field }) => field),
    [undefined, undefined, "_SETVAL", "_SETVAL"],
  );
  assert.deepEqual(labels.labelsOf(view, colours.LIGHT, say, { drawing: false, focus: null }), []);
  assert.equal(labels.readingText(reading, [-20, 0, 14]), "X Ø−40.000  Z 10.000");
  assert.equal(labels.readingText({ ...reading, diameter: false }, [-20, 0, 14]), "X −20.000  Z 10.000");
  assert.equal(labels.readingText({ ...reading, inch: true }, [-25.4, 0, 29.4]), "X Ø−2.0000  Z 1.0000");
});

// oracle: hand (a corrected zero offset lies 0.1 mm beside the machine's zero; another one is elsewhere)
test("systems that nearly lie in one another have their letters once", () => {
  const axes = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const frame = (x, moved) => ({ at: [x, 0, 0], axes, name: "", moved });
  const lettersOf = frames => {
    const view = { ...arrays.NOTHING.view, frames, axis: 20, labels: [] };
    return labels.labelsOf(view, colours.LIGHT, String, { drawing: false, focus: null }).map(({ text }) => text);
  };
  assert.deepEqual(lettersOf([frame(0), frame(0), frame(0.1, "after")]), ["X", "Y", "Z"]);
  assert.deepEqual(lettersOf([frame(0), frame(100)]), ["X", "Y", "Z", "X", "Y", "Z"]);
});

// oracle: hand (a size of the part is always there, a way with its field alone; what is focused stands out)
test("the dimension of the focused field stands out, others than the part's own come with it", () => {
  const line = field => ({ kind: field === "_SETVAL" ? "size" : "anchor", lines: [0, 1], field });
  const name = field => ({ kind: line(field).kind, at: [0, 0, 0], text: [], field });
  const fields = ["_SETVAL", "_FA"];
  const { view } = arrays.NOTHING;
  const data = {
    ...arrays.NOTHING,
    view: { ...view, groups: fields.map(line), labels: fields.map(name) },
    lines: new Float64Array([0, 0, 0, 40, 0, 0]),
  };
  const lit = colours.LIGHT.lit;
  const shown = focus => {
    const { labels: words, lines } = scene.buildScene(data, colours.LIGHT, { focus });
    const inks = lines.map(({ style }) => (style.colour.join() === colours.parse(lit).join() ? "lit" : "plain"));
    return [words.map(({ text, colour }) => (colour === lit ? `${text}!` : text)), inks];
  };
  assert.deepEqual(shown(null), [["_SETVAL"], ["plain"]]);
  assert.deepEqual(shown("_SETVAL"), [["_SETVAL!"], ["lit"]]);
  assert.deepEqual(shown("_FA"), [
    ["_SETVAL", "_FA!"],
    ["plain", "lit"],
  ]);
});

// oracle: hand (a zone is seen through and is not part of what hides lines; what moves is left where the probe is)
test("a protection zone is drawn through, and each piece where it stands", () => {
  const place = {
    at: [10, 20, 30],
    axes: [
      [0, 1, 0],
      [-1, 0, 0],
      [0, 0, 1],
    ],
  };
  const standings = [
    {
      entry: 0,
      places: [place],
      whole: [
        [0, 0, 0],
        [1, 1, 1],
      ],
      ground: [0, 10],
    },
  ];
  const piece = (matter, at) => ({ matter, corners: [3 * at, 3 * at + 3], vertices: [3 * at, 3 * at + 3] });
  const corners = Uint32Array.of(0, 1, 2, 3, 4, 5);
  const vertices = Float32Array.from([0, 1].flatMap(() => [0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1]));
  const pieces = [{ ...piece("zone", 0), place: 0 }, piece("ball", 1)];
  const built = scene.buildScene(made({ corners, vertices, view: { pieces, standings } }), colours.LIGHT);
  assert.deepEqual(built.ends, [3, 3, 3]);
  const vertex = i => [...built.mesh.vertices.slice(12 * i, 12 * i + 3), built.mesh.vertices[12 * i + 10]];
  near([0, 1, 2].flatMap(vertex), [0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1]); // the ball comes first, and moves
  near([3, 4, 5].flatMap(vertex), [10, 20, 30, 0, 10, 21, 30, 0, 9, 20, 30, 0]);
  assert.deepEqual([...built.mesh.corners], [0, 1, 2, 3, 4, 5]);
});

// oracle: hand
test("what must not touch and did has its words from then on", () => {
  const told = (from, what) => ({ kind: "collision", at: [1, 2, 3], text: [{ key: "first", args: { what } }], from });
  const found = [told(2, "stylus"), told(5, "ball"), told(8, "body")];
  const view = { ...arrays.NOTHING.view, labels: found };
  const words = labels.labelsOf(view, colours.LIGHT, ({ args }) => args.what, false);
  assert.deepEqual(
    words.map(({ text, during }) => [text, during[0]]),
    [
      ["stylus", 2],
      ["ball", 5],
      ["body", 8],
    ],
  );
});

// oracle: hand (devices that need so long for a frame and for each point; none may hold the page for more than 0.3 s)
test("of a cloud as many points are drawn as the device bears", () => {
  const settled = (all, frame, point) => {
    const took = drawn => frame + drawn * point;
    let drawn = Math.min(all, 16_384);
    for (let frames = 0; frames < 40; frames++) {
      const next = points.howMany(drawn, all, took(drawn));
      if (next === drawn) return drawn;
      assert.ok(took(next) < Math.max(300, took(16_384)), `${next} points in ${took(next)} ms`);
      drawn = next;
    }
    throw new Error("never settles");
  };
  assert.equal(settled(2_000_000, 16, 1e-5), 2_000_000); // a graphics card
  assert.equal(settled(1000, 400, 1), 1000); // few, however slow
  assert.equal(settled(2_000_000, 400, 1), 16_384);
  for (const point of [1e-4, 5e-4, 1e-3, 5e-3]) {
    const drawn = settled(2_000_000, 20, point);
    assert.ok(drawn * point > 15 && drawn < 2_000_000, `${drawn} points at ${point} ms each`);
  }
});

// oracle: hand (identities; half of the eased way is no farther from one end than from the other)
test("in central projection matrix and projection agree, and what is fitted is seen whole", () => {
  const box = { min: [100, -20, 5], max: [180, 40, 25] };
  const looking = camera.fit({ ...camera.turn(camera.initial(), "iso"), central: true }, view, box);
  const m = camera.matrix(looking, view, 500);
  for (const point of vec.boxCorners(box)) {
    const { x, y } = camera.projector(looking, view)(point);
    const row = i => m[i] * point[0] + m[4 + i] * point[1] + m[8 + i] * point[2] + m[12 + i];
    near([row(0) / row(3), row(1) / row(3)], [x / (view.width / 2) - 1, 1 - y / (view.height / 2)], 1e-9);
    assert.ok(row(2) / row(3) > 0 && row(2) / row(3) < 1, "between the nearest and the farthest");
    assert.ok(x > 0 && x < view.width && y > 0 && y < view.height);
  }
  const [from, to] = [0.1, 2 * Math.PI - 0.1].map(yaw => ({ ...looking, yaw }));
  near([Math.cos(camera.between(from, to, 0.5).yaw)], [1], 1e-9);
});

// oracle: hand (three words at one place, beside a box that is taken; in a view that is too small none has room)
test("words lie neither on each other nor on what is taken", () => {
  const taken = [{ left: 80, top: 80, right: 160, bottom: 120 }];
  const words = [0, 1, 2].map(() => ({ width: 60, height: 14, spots: [{ x: 120, y: 100 }], reach: 90 }));
  const placed = room => places.placed(words, room, { always: taken, rather: [] });
  const boxes = [...taken, ...placed(view).map(spot => places.around(spot, 60, 14))];
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(0, i)) assert.ok(!places.covers(a, b), JSON.stringify([a, b]));
  assert.deepEqual(placed({ width: 60, height: 100 }), [null, null, null]);
});

// oracle: hand (out of the way if there is a way, else on it, never on what is always kept)
test("what is rather kept free gives way to what is always kept free", () => {
  const [all, half] = [
    { left: 0, top: 0, right: 200, bottom: 100 },
    { left: 0, top: 0, right: 100, bottom: 100 },
  ];
  const word = { width: 40, height: 14, spots: [{ x: 50, y: 50 }], reach: 90 };
  const placed = (always, rather) => places.placed([word], { width: 200, height: 100 }, { always, rather });
  assert.deepEqual(placed([], []), [{ x: 50, y: 50 }]);
  assert.deepEqual(placed([], [all]), [{ x: 50, y: 50 }]);
  assert.deepEqual(placed([half], [all]), [{ x: 122, y: 50 }]);
  assert.deepEqual(placed([all], []), [null]);
});

// oracle: hand (measured in four directions: the half of the hole towards the viewer is cut away)
test("a section goes through what was touched, across the axis that points to the viewer", async () => {
  const section = await sources.load("/src/preview/section.ts");
  const cut = (name, open) =>
    section.sectionOf(scene.buildScene(hole, colours.LIGHT, { section: open }), camera.turn(camera.initial(), name));
  assert.equal(cut("front", false), null);
  const { normal, distance } = cut("front", true);
  near([...normal, distance], [0, -1, 0, -280], 1e-6);
  near(cut("top", true).normal, [0, 0, 1]);
});
