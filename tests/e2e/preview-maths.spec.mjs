// Camera, parts and picking of the 3D view: plain functions, no browser.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { modules } from "./sources.mjs";

let sources, camera, scene, demo, colours, pick, paths, vec, outline, mesh, drawing, points;
before(async () => {
  sources = await modules();
  const load = name => sources.load(`/src/preview/${name}.ts`);
  [camera, scene, demo, colours, pick, paths, vec, outline, mesh, drawing, points] = await Promise.all(
    ["camera", "scene", "demo/trace", "colours", "pick", "paths", "vec", "outline", "mesh", "drawing", "points"].map(
      load,
    ),
  );
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

// oracle: hand (a closed surface has no net area in any direction; the divergence theorem gives its volume)
test("every part is closed, faces outwards and has its volume", () => {
  const circle = r => (96 / 2) * r * r * Math.sin((2 * Math.PI) / 96);
  // 24 slices of a ball, each a frustum over a polygon of 48 sides
  const ball = r =>
    Array.from({ length: 24 }, (_, i) => {
      const [a, b] = [i, i + 1].map(row => r * Math.sin((row * Math.PI) / 24));
      const height = r * (Math.cos((i * Math.PI) / 24) - Math.cos(((i + 1) * Math.PI) / 24));
      return 24 * Math.sin((2 * Math.PI) / 48) * (height / 3) * (a * a + a * b + b * b);
    }).reduce((sum, slice) => sum + slice);
  // Blocks are larger than the element by max(8 mm, 0.45 × half its larger length) on every side.
  const expected = {
    hole: 46 ** 2 * (18 + 4.5) - circle(15) * 18,
    shaft: circle(15) * 18 + 46 ** 2 * 3.6,
    groove: 46 * (36 * (14 + 4) - 20 * 14),
    web: 46 * (16 * 14 + 32 * 3),
    pocket: (34 + 16) * (24 + 16) * (12 + 4) - 34 * 24 * 12,
    island: 34 * 24 * 12 + (34 + 16) * (24 + 16) * 3,
    block: 46 * 46 * 16,
    turned: (circle(20) * 50 - circle(10) * 30) / 2, // half section
    chuck: circle(30) * 16 + 3 * (0.94 * 30 - 15) * (0.56 * 30) * 8, // body, and three jaws over the first third
    sphere: ball(15),
    // askew by the sine of the angle between the edges
    outerCorner: 30 * 24 * 16 * Math.sin(Math.PI / 3),
    innerCorner: ((34 + 16) * (24 + 16) * (12 + 4) - 34 * 24 * 12) * Math.sin((110 * Math.PI) / 180),
  };
  for (const solid of demo.shapes.solids.slice(0, -1)) {
    const { mesh } = scene.buildScene({ ...demo.shapes, solids: [solid] }, colours.LIGHT);
    const { area, volume } = measured(mesh);
    near(area, [0, 0, 0], 1e-6);
    near([volume], [expected[solid.shape]], 1e-6 * volume);
  }
});

function measured({ vertices, corners }) {
  const at = corner => vertices.slice(11 * corner, 11 * corner + 3);
  let [area, volume] = [[0, 0, 0], 0];
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = corners.slice(i, i + 3).map(at);
    const face = vec.cross(vec.sub(b, a), vec.sub(c, a));
    area = vec.add(area, vec.times(face, 0.5));
    volume += vec.dot(a, face) / 6;
  }
  return { area, volume };
}

// oracle: hand
test("a part stands as the last rotary axis before left it", () => {
  const turned = [{ ...demo.shapes.solids[0], at: [1, 2, 3] }];
  const entries = [
    { step: "orient", angle: 0 },
    { step: "table", axis: "C", from: 0, to: 9, solids: turned },
    { step: "return" },
  ];
  const trace = { ...demo.shapes, entries };
  assert.deepEqual(
    [-1, 0, 1, 2, 9].map(index => scene.standing(trace, index) === turned),
    [false, false, true, true, true],
  );
});

// oracle: hand (nothing is touched and nothing moves: both origins with 20 mm around them)
test("coordinate systems alone are seen whole", () => {
  const axes = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const frames = [
    { name: "MCS", at: [0, 0, 0], axes },
    { name: "G54", at: [300, -40, 5], axes },
  ];
  const { box } = scene.buildScene({ ...demo.shapes, solids: [], frames }, colours.LIGHT);
  near(box.min, [-20, -60, -20]);
  near(box.max, [320, 20, 25]);
  near(scene.buildScene({ ...demo.shapes, solids: [], frames: [] }, colours.LIGHT).box.max, [20, 20, 20]);
});

// oracle: hand (diameter 40 + 0.2 + 0.01 × depth 10 = 40.3; lobe amplitude 0.5 at the angle 0)
test("errors of a part are where they belong", () => {
  const errors = { shift: [0, 0, 0], size: 0.2, tilt: [0, 0, 0], taper: 0.01, outOfRound: [0.5, 3] };
  near(outline.circle(40, errors).at(10)[0], [20.15 + 0.5, 0]);
  near(outline.rectangle(40, 20, errors).at(0)[0], [20.1, -10.1]);
});

// oracle: hand (entries 3 to 6 of the fixed trace: measuring, touch, retract, back)
test("picking finds the entry under the pointer and nothing far from all paths", () => {
  const built = scene.buildScene(demo.hole, colours.LIGHT);
  const looking = camera.fit(camera.turn(camera.initial(), "top"), view, built.box);
  const { from, to } = demo.hole.entries[3];
  const { x, y } = camera.projector(looking, view)(vec.mix(from, to, 0.5));
  const found = pick.pick(built.lines, looking, view, x, y);
  assert.ok([3, 5].includes(found), `${found}`); // measuring and retract lie on each other
  assert.equal(pick.pick(built.lines, looking, view, 5, 5), null);
});

// oracle: hand
test("the probe is on its motion and stays where the last motion ended", () => {
  const entries = [
    { step: "motion", kind: "rapid", from: [0, 0, 0], to: [10, 0, 0], feed: 0 },
    { step: "message", text: "" },
    { step: "motion", kind: "measuring", from: [10, 0, 0], to: [10, 8, 0], feed: 300 },
  ];
  const at = (index, fraction) => paths.probeAt({ entries }, index, fraction);
  near(at(0, 0.25), [2.5, 0, 0]);
  near(at(1, 0.5), [10, 0, 0]);
  near(at(2, 0.5), [10, 4, 0]);
  assert.equal(paths.probeAt({ entries: [] }, 0, 0), null);
});

// oracle: hand (a half turn and up by 4 about the axis X10, then a turn about an axis along X)
test("an arc is drawn and travelled round its axis", () => {
  const half = {
    step: "motion",
    kind: "positioning",
    from: [0, 0, 0],
    to: [20, 0, 4],
    feed: 900,
    around: { centre: [10, 0, 0], axis: [0, 0, 1], degrees: -180 },
  };
  const turn = {
    step: "motion",
    kind: "positioning",
    from: [20, 0, 4],
    to: [20, 0, 4],
    feed: 900,
    around: { centre: [20, 0, 0], axis: [1, 0, 0], degrees: 360 },
  };
  const entries = [half, turn];
  near(paths.probeAt({ entries }, 0, 0.5), [10, 10, 2], 1e-9);
  near(paths.probeAt({ entries }, 1, 0.25), [20, -4, 0], 1e-9);
  near(paths.probeAt({ entries }, 1, 1), [20, 0, 4], 1e-9);
  const lines = paths.pathLines(
    { entries: [half], ball: { radius: 3, length: 50 }, solids: [], frames: [] },
    colours.LIGHT,
    1,
  );
  assert.equal(lines.length, 60);
  for (const {
    to: [x, y],
    style: {
      entry,
      during: [begin, end],
    },
  } of lines) {
    near([Math.hypot(x - 10, y), entry, end - begin], [10, 0, 1 / 60], 1e-9);
  }
  near(lines.at(-1).to, [20, 0, 4], 1e-9);
});

// oracle: hand
test("grid lines are 1, 2 or 5 times a power of ten apart, about ten of them", () => {
  near([0.9, 18, 58, 430, 1000].map(paths.gridSpacing), [0.1, 2, 10, 50, 100], 1e-12);
});

// oracle: hand (CSS colour notations)
test("colours are read in the notations of CSS", () => {
  near(colours.parse("#f80"), [1, 0x88 / 255, 0, 1]);
  near(colours.parse("#33669980"), [0.2, 0.4, 0.6, 128 / 255]);
  near(colours.parse("rgb(51 102 153 / 0.5)"), [0.2, 0.4, 0.6, 0.5]);
});

// oracle: hand (in G18 the spindle stands along Y: above the ball there is nothing of the probe but along +Y)
test("the stylus stands along the axis of the tool", () => {
  const motion = { step: "motion", kind: "positioning", from: [0, 0, 0], to: [1, 0, 0], feed: 100 };
  for (const [axis, along] of [
    [[0, 0, 1], 2],
    [[0, 1, 0], 1],
    [[1, 0, 0], 0],
  ]) {
    const probe = { length: [0, 0, 0], ball: axis, pieces: [], carrier: [], tip: [0, 0, 0] };
    const trace = {
      entries: [motion],
      ball: { radius: 3, length: 50 },
      tools: [probe],
      inUse: [[0, 0]],
      solids: [],
      frames: [],
    };
    const box = mesh.boxOf(scene.buildScene(trace, colours.LIGHT).mesh);
    for (const other of [0, 1, 2]) {
      assert.ok(Math.abs(box.min[other]) < 16, `${axis}: ${box.min}`);
      assert.equal(box.max[other] > 20, other === along, `${axis}: ${box.max}`);
    }
  }
});

const INSERT = {
  corners: [
    [0, 0, 0],
    [10, 0, 0],
    [10, 0, 10],
    [0, 0, 10],
  ],
  thick: [0, -4, 0],
};
const MILL = {
  outline: [
    [0, 0],
    [5, 0],
    [5, 50],
    [0, 50],
  ],
  axis: [0, 0, 1],
  at: [0, 0, 0],
};
const inUse = pieces => ({ length: [0, 0, 0], pieces, carrier: [], tip: [0, 0, 0] });

// oracle: hand (a plate of 10 × 10 × 4 mm, and a cylinder of 24 sides)
test("an insert and a mill are closed and face outwards", () => {
  const motion = { step: "motion", kind: "positioning", from: [0, 0, 0], to: [1, 0, 0], feed: 100 };
  for (const [piece, volume] of [
    [INSERT, 400],
    [MILL, 12 * 25 * Math.sin(Math.PI / 12) * 50],
  ]) {
    const trace = {
      entries: [motion],
      ball: { radius: 3, length: 50 },
      tools: [inUse([piece])],
      inUse: [[0, 0]],
      solids: [],
      frames: [],
    };
    const found = measured(scene.buildScene(trace, colours.LIGHT).mesh);
    near(found.area, [0, 0, 0], 1e-9);
    near([found.volume], [volume], 1e-6 * volume);
  }
});

// oracle: hand (the probe until T3 is called at entry 1, then the mill, then the probe again)
test("what is in use follows the tool changes, and the fit has room for it", () => {
  const motion = (from, to) => ({ step: "motion", kind: "positioning", from, to, feed: 100 });
  const entries = [
    motion([0, 0, 0], [1, 0, 0]),
    { step: "tool", tool: 3, edge: 1 },
    motion([1, 0, 0], [0, 0, 0]),
    { step: "tool", tool: 9, edge: 1 },
  ];
  const tools = [{ ...inUse([]), ball: [0, 0, 1] }, inUse([MILL])];
  const trace = {
    entries,
    ball: { radius: 3, length: 50 },
    tools,
    inUse: [
      [0, 0],
      [1, 1],
      [3, 0],
    ],
    solids: [],
    frames: [],
  };
  assert.deepEqual(
    [0, 1, 2, 3].map(index => tools.indexOf(paths.toolAt(trace, index))),
    [0, 1, 1, 0],
  );
  assert.equal(paths.toolAt({ ...trace, tools: undefined, inUse: undefined }, 2), undefined);
  const box = inUse => scene.buildScene({ ...trace, inUse }, colours.LIGHT).box;
  near([box([[0, 1]]).max[2]], [50]);
  near([box([[0, 1]]).max[0]], [5]);
});

// oracle: hand (the axes stand still: a tool that is 10 mm longer in Z ends 10 mm lower, where the last motion led)
test("another length in effect is another position", () => {
  const entries = [
    { step: "motion", kind: "positioning", from: [0, 0, 0], to: [1, 0, 50], feed: 100 },
    { step: "tool", tool: 3, edge: 1 },
    { step: "return" },
  ];
  const tools = [inUse([]), { ...inUse([]), length: [0, 0, 10] }];
  const trace = {
    entries,
    tools,
    inUse: [
      [0, 0],
      [1, 1],
    ],
  };
  near(paths.probeAt(trace, 0, 1), [1, 0, 50]);
  near(paths.probeAt(trace, 1, 0), [1, 0, 40]);
  near(paths.probeAt(trace, 2, 1), [1, 0, 40]);
});

// oracle: hand (a step of 40 mm that is 0.1 mm larger, its front at Z 10; X −20 from a zero at Z 4, as a diameter)
test("a drawing has its diameters before the front, and the reading counts as on the control", () => {
  const ends = [
    [-20.05, 0, 10],
    [20.05, 0, 10],
  ];
  const axes = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const reading = { at: [0, 0, 4], axes, diameter: true };
  const touch = { step: "touch", latched: [23, 0, 0], ball: [23, 0, 0], point: [20, 0, 0], normal: [1, 0, 0] };
  const made = {
    diameters: [{ ends, out: [0, 0, 1], set: 40, real: 40.1 }],
    touched: [
      { entry: 0, diameter: 40 },
      { entry: 1, diameter: 40.1 },
    ],
    reading,
  };
  const { lines, labels } = drawing.dimensions({ entries: [touch, touch] }, made, colours.LIGHT, 100);
  assert.deepEqual(
    labels.map(({ text }) => text),
    ["Ø40.000", "Ø40.100", "Ø40.100", "Ø40.000 +0.100"],
  );
  assert.deepEqual(
    labels.map(({ during }) => during),
    [[0, 1], [1, Infinity], undefined, undefined],
  );
  near(lines[2].from, [-20.05, 0, 24]);
  near(lines[2].to, [20.05, 0, 24]);
  assert.equal(drawing.readingText(reading, [-20, 0, 14]), "X Ø−40.000  Z 10.000");
  assert.equal(drawing.readingText({ ...reading, diameter: false }, [-20, 0, 14]), "X −20.000  Z 10.000");
});

// oracle: hand (a zone is seen through and is not part of what hides lines)
test("a protection zone is drawn through", () => {
  const errors = { shift: [0, 0, 0], size: 0, tilt: [0, 0, 0], taper: 0, outOfRound: [0, 0] };
  const solid = { shape: "shaft", size: [40, 20], at: [0, 0, 0], rotation: [0, 0, 0], errors };
  const built = scene.buildScene(
    { entries: [], ball: { radius: 3, length: 50 }, solids: [], zones: [solid], frames: [] },
    colours.LIGHT,
  );
  assert.equal(built.solidCorners, 0);
  assert.ok(built.mesh.corners.length > 0);
  const box = mesh.boxOf(built.mesh);
  near(box.min, [-20, -20, -20], 1e-9);
  near(box.max, [20, 20, 0], 1e-9);
});

// oracle: hand: a touch of the ball in a measurement is none; a crash, a touch of the stylus and one that ends in an
// alarm are
test("what must not touch and did has its words from then on", async () => {
  const { collisions, collisionLabels } = await sources.load("/src/preview/collisions.ts");
  const touch = { step: "touch", latched: [0, 0, 0], ball: [0, 0, 0], point: [1, 2, 3], normal: [0, 0, 1] };
  const move = { step: "motion", kind: "retract", from: [0, 0, 0], to: [0, 0, 1], feed: 0 };
  const told = { step: "decision", message: { key: "run-stylus" } };
  const alarm = { step: "alarm", code: "61302", message: { key: "alarm-61302" }, stops: true };
  const trace = {
    entries: [
      touch,
      move,
      { ...touch, by: "stylus" },
      told,
      move,
      touch,
      told,
      alarm,
      { step: "crash", point: [4, 5, 6], normal: [1, 0, 0], by: "body" },
    ],
  };
  assert.deepEqual(collisions(trace), [
    { entry: 2, at: [1, 2, 3], by: "stylus", crash: false },
    { entry: 5, at: [1, 2, 3], by: "ball", crash: false, alarm: "61302" },
    { entry: 8, at: [4, 5, 6], by: "body", crash: true },
  ]);
  const labels = collisionLabels(trace, colours.LIGHT, ({ by }) => by);
  assert.deepEqual(
    labels.map(({ text, during }) => [text, during[0]]),
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
