// Levels of the whole path, and what of it is in sight: plain functions, no browser.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { random } from "./random.mjs";
import { modules } from "./sources.mjs";

let sources, levels, camera;
before(async () => {
  sources = await modules();
  levels = await sources.load("/src/core/levels.ts");
  camera = await sources.load("/src/preview/camera.ts");
});
after(() => sources.close());

/** Motions from place to place; `kind` of each; now and then one begins elsewhere. */
function ways(count, place, kind = () => 1, jumps = () => false) {
  const made = {
    ways: new Float64Array(8 * count),
    wayEntries: new Uint32Array(count),
    wayKinds: new Uint8Array(count),
  };
  for (let i = 0; i < count; i++) {
    made.ways.set([...place(jumps(i) ? i + 0.5 : i), ...place(i + 1), 0, 1], 8 * i);
    made.wayEntries[i] = i;
    made.wayKinds[i] = kind(i);
  }
  return made;
}

/** A pocket in rings, a wave in lines, and places anywhere. */
const programs = () => {
  const next = random(7);
  const anywhere = Array.from({ length: 30_001 }, () => [next() * 200, next() * 100, next() * 50]);
  return {
    "rings that go deeper": ways(20_000, i => [
      50 * Math.cos(i / 400) * (1 + i / 20_000),
      50 * Math.sin(i / 400),
      -i / 2000,
    ]),
    "lines with a rapid motion between them": ways(
      20_000,
      i => [i % 200, Math.floor(i / 200), Math.sin(i / 9)],
      i => (i % 200 === 199 ? 0 : 1),
    ),
    "places anywhere, with jumps and all kinds": ways(
      30_000,
      i => anywhere[Math.floor(i)].map(at => at + (i % 1)),
      i => (i * 7) % 4,
      i => i % 501 === 500,
    ),
    "a single motion": ways(1, i => [i, 0, 0]),
  };
};

const everyChunk = ({ parts }) =>
  parts.flatMap(({ starts }, part) => Array.from({ length: starts.length - 1 }, (_, chunk) => [part, chunk]));
const drawn = (path, level) =>
  [...levels.motionsIn(path, everyChunk(path), level)].filter(([from, to]) => from.some((at, i) => at !== to[i]));

// oracle: hand (the motions before)
test("the first level is every motion, in its place, of its kind, in order", () => {
  for (const [name, { ways, wayEntries, wayKinds }] of Object.entries(programs())) {
    const path = levels.pathOf({ ways, wayEntries, wayKinds });
    const found = drawn(path, 0);
    assert.equal(found.length, wayKinds.length, name);
    found.forEach(([from, to, { kind, done }], i) => {
      assert.deepEqual({ kind, done }, { kind: wayKinds[i], done: wayEntries[i] + 1 }, name);
      [...from, ...to].forEach((at, axis) => {
        const off = at + path.origin[axis % 3] - ways[8 * i + axis];
        assert.ok(Math.abs(off) < 1e-4, `${name}, motion ${i}: ${off} mm`);
      });
    });
  }
});

// oracle: hand (what the head of the levels says)
test("each further level has fewer motions, and what it leaves out of a smooth path lies near it", () => {
  for (const [name, program] of Object.entries(programs())) {
    const path = levels.pathOf(program);
    const counts = Array.from({ length: levels.LEVELS }, (_, level) => drawn(path, level).length);
    for (const [level, count] of counts.entries())
      if (level > 0) assert.ok(count <= 0.6 * counts[level - 1] + everyChunk(path).length, `${name}: ${counts}`);
  }
  const path = levels.pathOf(programs()["rings that go deeper"]);
  const size = Math.hypot(...path.high.map((at, i) => at - path.low[i]));
  const corners = drawn(path, 0).map(([from]) => from);
  const coarse = drawn(path, 2);
  const off = (2 + 4) * (size / 8192); // of the second and the third level
  let place = 0; // both are in order
  for (const corner of corners) {
    const near = ([from, to]) => distance(corner, from, to) <= off * 1.01;
    while (place < coarse.length - 1 && !near(coarse[place])) place++;
    assert.ok(near(coarse[place]), `${corner}`);
  }
});

function distance(at, from, to) {
  const way = to.map((end, i) => end - from[i]);
  const square = way.reduce((sum, one) => sum + one * one, 0);
  const part = way.reduce((sum, one, i) => sum + one * (at[i] - from[i]), 0) / square;
  const share = Math.min(1, Math.max(0, part));
  return Math.hypot(...at.map((one, i) => one - from[i] - share * way[i]));
}

describe("what is in sight", () => {
  const view = { width: 800, height: 600 };
  const REACH = 1000; // mm

  // oracle: hand (each point of a motion is put on the screen)
  test("is never left out, from wherever it is seen", () => {
    const next = random(11);
    for (const [name, program] of Object.entries(programs())) {
      const path = levels.pathOf(program);
      const motions = new Map(everyChunk(path).map(one => [one.join(), [...levels.motionsIn(path, [one], 0)]]));
      let out = 0;
      for (let look = 0; look < 60; look++) {
        const seen = {
          ...camera.initial(),
          yaw: 7 * next(),
          pitch: 3 * next() - 1.5,
          target: path.low.map((low, i) => low + next() * (path.high[i] - low)),
          scale: 2 ** (8 * next()),
          central: look % 2 === 1,
          turning: look % 3 === 0,
        };
        const matrix = camera.matrix(seen, view, REACH);
        const shown = new Set(levels.inSight(path, { matrix, shift: [0, 0, 0] }).map(one => one.join()));
        for (const [chunk, all] of motions) {
          if (shown.has(chunk)) continue;
          out += 1;
          for (const [from, to] of all)
            for (const part of [0, 0.5, 1]) {
              const at = from.map((one, i) => one + part * (to[i] - one));
              assert.ok(!isSeen(matrix, at), `${name}: chunk ${chunk} at ${at} is seen and left out`);
            }
        }
      }
      if (name.startsWith("lines")) assert.ok(out > 20, `${name}: ${out} chunks are left out`);
    }
  });

  function isSeen(matrix, [x, y, z]) {
    const [cx, cy, , cw] = [0, 1, 2, 3].map(
      row => matrix[row] * x + matrix[4 + row] * y + matrix[8 + row] * z + matrix[12 + row],
    );
    return cw > 0 && Math.abs(cx) <= cw && Math.abs(cy) <= cw;
  }

  // oracle: hand (the counts that the path tells)
  test("is drawn as fine as so many motions allow, and whole where all are", () => {
    const path = levels.pathOf(programs()["places anywhere, with jumps and all kinds"]);
    const chunks = everyChunk(path);
    assert.equal(levels.levelFor(path, chunks, 60_000), 0);
    for (const most of [20_000, 5_000, 1_000]) {
      const level = levels.levelFor(path, chunks, most);
      assert.ok(drawn(path, level).length <= most && drawn(path, level - 1).length > most - 0.5 * most, `${most}`);
    }
    const spans = levels.spansOf(path, chunks, 0);
    assert.equal(spans.length, levels.SPAN * chunks.length);
  });
});

// oracle: hand (a corner of 16 bytes a motion and indices of two bytes, of which the further levels have as many again)
test("a million motions have their path in bounded room", () => {
  const count = 1_000_000;
  const program = ways(count, i => [i % 1000, Math.floor(i / 1000), Math.sin(i)]);
  const path = levels.pathOf(program);
  const bytes = path.parts.reduce((sum, { vertices, indices }) => sum + vertices.byteLength + indices.byteLength, 0);
  assert.equal(path.motions, count);
  assert.ok(bytes < 24 * count, `${bytes} bytes`);
});
