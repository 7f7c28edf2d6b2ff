// Contours of parts in their own frame: what a wall looks like at a depth.
import type { Solid } from "../wire";

export type Vec2 = [number, number];
/** Closed contour, counter-clockwise, at a depth in mm below the upper face. `smooth`: one rounded surface.
 *  `around`: as many points on a rectangle around it, its corners among them. */
export interface Outline {
  at(depth: number): Vec2[];
  around(half: Vec2): Vec2[];
  smooth: boolean;
  half: Vec2;
}

export const CIRCLE_POINTS = 96; // a multiple of 8: the corners of the block around it lie on rays through points
const EDGE_POINTS = 8;

type Errors = Solid["errors"];

/** Circle: diameter with size error, taper and lobes on the radius. */
export function circle(diameter: number, errors: Errors): Outline {
  const [amplitude, lobes] = errors.outOfRound;
  const at = (depth: number) =>
    Array.from({ length: CIRCLE_POINTS }, (_, i): Vec2 => {
      const angle = (2 * Math.PI * i) / CIRCLE_POINTS;
      const radius = (diameter + errors.size + errors.taper * depth) / 2 + amplitude * Math.cos(lobes * angle);
      return [radius * Math.cos(angle), radius * Math.sin(angle)];
    });
  return { at, around: half => outward(at(0), half), smooth: true, half: [diameter / 2, diameter / 2] };
}

/** Rectangle: both lengths with size error and taper. */
export function rectangle(x: number, y: number, errors: Errors): Outline {
  const grown = (length: number, depth: number) => (length + errors.size + errors.taper * depth) / 2;
  return {
    at: depth => border([grown(x, depth), grown(y, depth)]),
    around: border,
    smooth: false,
    half: [x / 2, y / 2],
  };
}

/** Border of a rectangle with the given half lengths, every edge divided. */
export function border([hx, hy]: Vec2): Vec2[] {
  const corners: Vec2[] = [
    [hx, -hy],
    [hx, hy],
    [-hx, hy],
    [-hx, -hy],
  ];
  return corners.flatMap((from, i) => {
    const to = corners[(i + 1) % 4]!;
    return Array.from({ length: EDGE_POINTS }, (_, k): Vec2 => {
      const t = k / EDGE_POINTS;
      return [from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t];
    });
  });
}

/** Where the rays through the points of a contour leave the rectangle around it. */
function outward(points: Vec2[], half: Vec2): Vec2[] {
  return points.map(([x, y]) => {
    const s = Math.min(half[0] / Math.max(Math.abs(x), 1e-12), half[1] / Math.max(Math.abs(y), 1e-12));
    return [x * s, y * s];
  });
}

/**
 * Normals of a contour pointing away from its inside; for a contour with corners those of the edge after each point.
 */
export function normals(points: Vec2[], smooth: boolean): Vec2[] {
  return points.map((point, i) => {
    const before = smooth ? points[(i + points.length - 1) % points.length]! : point;
    const after = points[(i + 1) % points.length]!;
    const [dx, dy] = [after[0] - before[0], after[1] - before[1]];
    const length = Math.hypot(dx, dy) || 1;
    return [dy / length, -dx / length];
  });
}
