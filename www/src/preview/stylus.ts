// The probe: ball and stylus solid, the body above them seen through, the centre of the ball at 0 0 0. Or the tool that
// touches a tool probe.
import type { ToolOutline, Vec3 } from "../wire";
import type { Rgba } from "./colours";
import { band, type Mesh, type Paint } from "./mesh";
import { add, apply, fromZ, unit } from "./vec";

const AROUND = 24;
const BALL_LAYERS = 14;
const TURNS = Array.from({ length: AROUND }, (_, i) => (2 * Math.PI * i) / AROUND).map((angle): [number, number] => [Math.cos(angle), Math.sin(angle)]);

/** `radius` of the ball and `length` from it to the spindle in mm; `axis` from the ball to the spindle. */
export interface Ball { radius: number; length: number; axis?: Vec3 }

/** Behind what is there: ball and stylus, then its body; gives the number of corners without the body. */
export function addStylus(into: Mesh, ball: Ball, colours: { ball: Rgba; stylus: Rgba }, longest: number): number {
  const frame = fromZ(unit(ball.axis ?? [0, 0, 1]));
  const place = (p: Vec3) => apply(frame, p);
  const r = ball.radius;
  const reach = Math.min(ball.length, Math.max(10 * r, longest));
  const body = Math.min(reach + 6 * r, Math.max(ball.length, 4 * r));
  turned(into, sphere(r), place, { colour: colours.ball, moves: true });
  turned(into, [[0.45 * r, 0.8 * r], [0.45 * r, reach]], place, { colour: colours.stylus, moves: true });
  const solid = into.corners.length;
  const [red, green, blue] = colours.stylus;
  const end = Math.max(body, reach + 3 * r);
  const profile: [number, number][] = [[0.45 * r, reach], [2.2 * r, reach + 1.2 * r], [2.2 * r, end], [0, end]];
  turned(into, profile, place, { colour: [red, green, blue, 0.6], moves: true });
  return solid;
}

/** Behind what is there: the tool, solid; gives the number of corners. */
export function addTool(into: Mesh, { outline, axis, at }: ToolOutline, colour: Rgba): number {
  const frame = fromZ(unit(axis));
  const direction = (p: Vec3) => apply(frame, p);
  turned(into, outline, (p) => add(at, direction(p)), { colour, moves: true }, direction);
  return into.corners.length;
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
function turned(into: Mesh, profile: [number, number][], place: (p: Vec3) => Vec3, paint: Paint, direction = place): void {
  const round = profile.length === BALL_LAYERS + 1;
  const row = (r: number, z: number, put = place): Vec3[] => TURNS.map(([cosine, sine]) => put([r * cosine, r * sine, z]));
  for (let layer = 0; layer + 1 < profile.length; layer++) {
    const [[r0, z0], [r1, z1]] = [profile[layer]!, profile[layer + 1]!];
    const [lower, upper] = [row(r0, z0), row(r1, z1)];
    const slope = round ? [] : row(z1 - z0, r0 - r1, direction).map(unit);
    band(into, upper, lower, round ? { upper: upper.map(unit), lower: lower.map(unit) } : { upper: slope, lower: slope }, true, paint);
  }
}
