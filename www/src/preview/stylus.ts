// The probe: ball and stylus solid, the body above them seen through, the centre of the ball at 0 0 0. Or a tool, and
// on a turning machine what carries it, seen through.
import type { Ball, ToolPiece, ToolView, Vec3 } from "../wire";
import type { Rgba } from "./colours";
import { append, band, fan, flat, type Mesh, mesh, type Paint } from "./mesh";
import { add, apply, cross, dot, fromZ, sub, times, unit } from "./vec";

const AROUND = 24;
const BALL_LAYERS = 14;
const TURNS = Array.from({ length: AROUND }, (_, i) => (2 * Math.PI * i) / AROUND).map((angle): [number, number] => [
  Math.cos(angle),
  Math.sin(angle),
]);

const UPRIGHT: ToolView = { length: [0, 0, 0], ball: [0, 0, 1], pieces: [], carrier: [], tip: [0, 0, 0] };
const THROUGH = 0.4;
const BODY = 5; // radius of the body of a probe, where nothing is told of it, in radii of its ball
const USUAL = 0.45; // radius of a stylus in radii of its ball
const CARRIER_THROUGH = 0.35;

/** Of the stylus as it is drawn, mm. */
export const stylusRadius = (ball: Ball): number => ball.stylus || USUAL * ball.radius;

/**
 * From the centre of the ball to where the stylus is drawn to end, mm. `longest`: where nothing is told of the body.
 */
export function stylusReach(ball: Ball, longest: number): number {
  return ball.body ? ball.body.distance : Math.min(ball.length, Math.max(10 * ball.radius, longest));
}

/** Direction from the ball to what holds it; null: no probe is in use. */
export function stylusAxis(view: ToolView = UPRIGHT): Vec3 | null {
  return view.ball ? unit(view.ball) : null;
}

export interface ToolColours {
  ball: Rgba;
  stylus: Rgba;
}

/** Behind what is there: probe or tool, then what is seen through; gives the number of corners without that, and how
 * far
 *  the numbers of the vertices go without what carries it. */
export function addInUse(
  into: Mesh,
  ball: Ball,
  view: ToolView = UPRIGHT,
  colours: ToolColours,
  reach: number,
): { solid: number; own: number } {
  const [red, green, blue] = colours.stylus;
  for (const piece of view.pieces)
    addPiece(into, piece, { colour: piece.cuts ? colours.ball : colours.stylus, moves: true });
  const solid = view.ball ? addStylus(into, ball, view.ball, colours, reach) : into.corners.length;
  const own = into.used;
  for (const piece of view.carrier) addPiece(into, piece, { colour: [red, green, blue, CARRIER_THROUGH], moves: true });
  return { solid, own };
}

interface Stylus {
  mesh: Mesh;
  solid: number;
}
let last: { of: string; stylus: Stylus } | null = null; // mostly the same probe is in use after a keystroke

/** Ball and stylus, then its body; gives the number of corners of what is solid. A body of which nothing is known is
 * seen
 *  through, and nothing touches it. */
function addStylus(into: Mesh, ball: Ball, axis: Vec3, colours: ToolColours, reach: number): number {
  const of = JSON.stringify([ball, axis, colours, reach]);
  if (last?.of !== of) last = { of, stylus: makeStylus(ball, axis, colours, reach) };
  const before = into.corners.length;
  append(into, last.stylus.mesh);
  return before + last.stylus.solid;
}

function makeStylus(ball: Ball, axis: Vec3, colours: ToolColours, reach: number): Stylus {
  const into = mesh();
  const frame = fromZ(unit(axis));
  const place = (p: Vec3) => apply(frame, p);
  const r = ball.radius;
  const thin = stylusRadius(ball);
  turned(into, sphere(r), place, { colour: colours.ball, moves: true });
  if (ball.body) {
    const { radius, distance } = ball.body;
    const end = Math.max(ball.length, distance + radius);
    const profile: [number, number][] = [
      [thin, Math.min(0.8 * r, distance)],
      [thin, distance],
      [radius, distance],
      [radius, end],
      [0, end],
    ];
    turned(into, profile, place, { colour: colours.stylus, moves: true });
    return { mesh: into, solid: into.corners.length };
  }
  const body = Math.min(reach + 6 * r, Math.max(ball.length, 4 * r));
  turned(
    into,
    [
      [thin, 0.8 * r],
      [thin, reach],
    ],
    place,
    { colour: colours.stylus, moves: true },
  );
  const solid = into.corners.length;
  const [red, green, blue] = colours.stylus;
  const end = Math.max(body, reach + 9 * r);
  const profile: [number, number][] = [
    [thin, reach],
    [BODY * r, reach + 3 * r],
    [BODY * r, end],
    [0, end],
  ];
  turned(into, profile, place, { colour: [red, green, blue, THROUGH], moves: true });
  return { mesh: into, solid };
}

function addPiece(into: Mesh, piece: ToolPiece, paint: Paint): void {
  if ("corners" in piece) {
    plate(into, piece.corners, piece.thick, paint);
    return;
  }
  const frame = fromZ(unit(piece.axis));
  const direction = (p: Vec3) => apply(frame, p);
  turned(into, piece.outline, p => add(piece.at, direction(p)), paint, direction);
}

/** Both faces of a flat piece, and its border. */
function plate(into: Mesh, corners: Vec3[], thick: Vec3, paint: Paint): void {
  const middle = times(corners.reduce(add), 1 / corners.length);
  const faces = [
    { at: [0, 0, 0] as Vec3, normal: unit(times(thick, -1)) },
    { at: thick, normal: unit(thick) },
  ];
  for (const { at, normal } of faces)
    fan(
      into,
      add(middle, at),
      corners.map(corner => add(corner, at)),
      normal,
      true,
      paint,
    );
  corners.forEach((corner, i) => {
    const next = corners[(i + 1) % corners.length]!;
    const border = cross(sub(next, corner), thick);
    const outside = times(border, Math.sign(dot(border, sub(corner, middle))) || 1);
    if (dot(border, border) > 0) flat(into, [corner, next, add(next, thick), add(corner, thick)], outside, paint);
  });
}

/** Half circle from the lower to the upper pole: distance from the axis, height. */
function sphere(r: number): [number, number][] {
  return Array.from({ length: BALL_LAYERS + 1 }, (_, i): [number, number] => {
    const angle = -Math.PI / 2 + (Math.PI * i) / BALL_LAYERS;
    return [r * Math.cos(angle), r * Math.sin(angle)];
  });
}

/** A profile turned about Z; on a sphere the normals are radial, elsewhere they belong to each piece. `direction`: as
 *  `place`, of a direction. */
function turned(
  into: Mesh,
  profile: [number, number][],
  place: (p: Vec3) => Vec3,
  paint: Paint,
  direction = place,
): void {
  const round = profile.length === BALL_LAYERS + 1;
  const row = (r: number, z: number, put = place): Vec3[] =>
    TURNS.map(([cosine, sine]) => put([r * cosine, r * sine, z]));
  for (let layer = 0; layer + 1 < profile.length; layer++) {
    const [[r0, z0], [r1, z1]] = [profile[layer]!, profile[layer + 1]!];
    const [lower, upper] = [row(r0, z0), row(r1, z1)];
    const slope = round ? [] : row(z1 - z0, r0 - r1, direction).map(unit);
    band(
      into,
      upper,
      lower,
      round ? { upper: upper.map(unit), lower: lower.map(unit) } : { upper: slope, lower: slope },
      true,
      paint,
    );
  }
}
