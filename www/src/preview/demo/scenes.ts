// Scenes for tests, made by the core: a hole of 40 mm that a program measures in four directions with a ball of 6 mm,
// and one part of every shape.
import type * as Program from "@pkg/core/core.js";
import { type SceneData, takeScene } from "../../core/scene";
import type { Solid, Vec3 } from "../../wire";

const CENTRE: Vec3 = [320, 280, -40];
const ZERO: Vec3 = [291, 251, -40]; // of G54
const RADIUS = 20;
const DEPTH = 8;
const APPROACH = 8; // from the centre to where measuring starts

const point = (x: number, y: number, z: number): Vec3 => [CENTRE[0] + x, CENTRE[1] + y, CENTRE[2] + z];
const words = (at: Vec3): string => `X${at[0] - ZERO[0]} Y${at[1] - ZERO[1]} Z${at[2] - ZERO[2]}`;

/** To the wall, beyond which the block would end 5 mm later, and back. */
function direction(x: number, y: number): string[] {
  const near = words(point(x * APPROACH, y * APPROACH, -DEPTH));
  return [
    `G1 F1000 ${near}`,
    `MEAS=1 G1 F300 ${words(point(x * (RADIUS + 5), y * (RADIUS + 5), -DEPTH))}`,
    `G1 F1000 ${near}`,
    `G1 F1000 ${words(point(0, 0, -DEPTH))}`,
  ];
}

const MEASURING = [
  `G0 ${words(point(0, 0, 40))}`,
  `G1 F1000 ${words(point(0, 0, -DEPTH))}`,
  ...direction(1, 0),
  ...direction(-1, 0),
  ...direction(0, 1),
  ...direction(0, -1),
  `G0 ${words(point(0, 0, 40))}`,
  "M30",
];

const exact: Solid["errors"] = { shift: [0, 0, 0], size: 0, tilt: [0, 0, 0], taper: 0, outOfRound: [0, 0] };
const HOLE: Solid = { shape: "hole", size: [2 * RADIUS, 25], at: CENTRE, rotation: [0, 0, 0], errors: exact };

const place = (i: number): Vec3 => [(i % 4) * 125, Math.floor(i / 4) * -125, 0];
const sizes: [Solid["shape"], number[]][] = [
  ["hole", [30, 18]],
  ["shaft", [30, 18]],
  ["groove", [20, 14, 46]],
  ["web", [16, 14, 46]],
  ["pocket", [34, 24, 12]],
  ["island", [34, 24, 12]],
  ["block", [46, 46, 16]],
  ["sphere", [30]],
  ["outerCorner", [60, 30, 24, 16]],
  ["innerCorner", [110, 34, 24, 12]],
  ["turned", [40, 50, 20, 30]],
  ["chuck", [60, 24, 30]],
  ["shaft", [30, 18]],
];
/** Every shape; the last one with errors that are there to be seen. */
const SHAPES = sizes.map(
  ([shape, size], i): Solid => ({
    shape,
    size,
    at: place(i),
    rotation: [0, 0, 0],
    errors:
      i < sizes.length - 1 ? exact : { shift: [0, 0, 0], size: 0, tilt: [6, 0, 0], taper: 0.3, outOfRound: [2, 3] },
  }),
);

function run({ Run }: typeof Program, text: string, workpiece: Solid[]): SceneData {
  const setup = {
    control: "sinumerik",
    units: "mm",
    plane: "G17",
    active: { tool: 9, edge: 1, frame: "G54" },
    tools: { 9: { edges: { 1: { type: 710, length: [50, 0, 0], radius: 3 } } } },
    frames: { G54: { coarse: ZERO } },
    data: {},
    probe: { radius: 3, length: 50 },
    workpiece,
    position: point(-60, -50, 40),
  };
  const run = new Run(JSON.stringify({ control: "sinumerik", text, setup }));
  while (!run.advance(1000));
  const scene = run.finish().scene(1);
  if (!scene) throw new Error("nothing to be seen");
  return takeScene(scene);
}

export const hole = (program: typeof Program): SceneData => run(program, `${MEASURING.join("\n")}\n`, [HOLE]);
export const shapes = (program: typeof Program): SceneData => run(program, "M30\n", SHAPES);
