// A hole of 40 mm, measured in four directions with a ball of 6 mm, as a trace; and one part of every shape.
import type { MotionKind, Solid, Step, Trace, Vec3 } from "../../wire";

const CENTRE: Vec3 = [120, 80, -40];
const RADIUS = 20;
const BALL = 3;
const DEPTH = 8;
const APPROACH = 8; // from the centre to where measuring starts

const point = (x: number, y: number, z: number): Vec3 => [CENTRE[0] + x, CENTRE[1] + y, CENTRE[2] + z];
const motion = (kind: MotionKind, from: Vec3, to: Vec3, feed: number): Step => ({
  step: "motion",
  kind,
  from,
  to,
  feed,
});

function direction(x: number, y: number): Step[] {
  const near = point(x * APPROACH, y * APPROACH, -DEPTH);
  const ball = point(x * (RADIUS - BALL), y * (RADIUS - BALL), -DEPTH);
  const touched = point(x * RADIUS, y * RADIUS, -DEPTH);
  return [
    motion("positioning", point(0, 0, -DEPTH), near, 1000),
    motion("measuring", near, ball, 300),
    { step: "touch", latched: ball, ball, point: touched, normal: [-x, -y, 0] },
    motion("retract", ball, near, 1000),
    motion("positioning", near, point(0, 0, -DEPTH), 1000),
  ];
}

const entries: Step[] = [
  motion("rapid", point(-45, -35, 40), point(0, 0, 40), 0),
  motion("positioning", point(0, 0, 40), point(0, 0, -DEPTH), 1000),
  ...direction(1, 0),
  ...direction(-1, 0),
  ...direction(0, 1),
  ...direction(0, -1),
  motion("rapid", point(0, 0, -DEPTH), point(0, 0, 40), 0),
];

const exact: Solid["errors"] = { shift: [0, 0, 0], size: 0, tilt: [0, 0, 0], taper: 0, outOfRound: [0, 0] };
const axes: [Vec3, Vec3, Vec3] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

export const hole: Trace = {
  entries,
  ball: { radius: BALL, length: 120 },
  solids: [{ shape: "hole", size: [2 * RADIUS, 25], at: CENTRE, rotation: [0, 0, 0], errors: exact }],
  frames: [{ name: "G54", at: point(-29, -29, 0), axes }],
};

const place = (i: number): Vec3 => [(i % 4) * 75, Math.floor(i / 4) * -75, 0];
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
export const shapes: Trace = {
  entries: [],
  ball: { radius: BALL, length: 120 },
  solids: sizes.map(
    ([shape, size], i): Solid => ({
      shape,
      size,
      at: place(i),
      rotation: [0, 0, 0],
      errors:
        i < sizes.length - 1 ? exact : { shift: [0, 0, 0], size: 0, tilt: [6, 0, 0], taper: 0.3, outOfRound: [2, 3] },
    }),
  ),
  frames: [],
};
