// The ground below the part: its grid, and a map of how high the part stands over it. From the map the renderer tells
// how much light arrives anywhere, so that shadows cost next to nothing on any device.
import type { Standing } from "../core/scene";
import type { Vec3 } from "../wire";
import { type Mesh, MOVES, OPACITY, VERTEX_FLOATS } from "./mesh";
import type { Box } from "./vec";

const CELLS = 96; // a side of the map
const AROUND = 0.45; // what the map shows around the part, share of its size
const REACHES = [0.035, 0.14] as const; // of occlusion, shares of the size of the map
const FAR = 1.5; // radius of the ground, in sizes of the map
const LIGHT = [0.45, -0.3] as const; // how far a shadow falls aside, in heights of what throws it
const DARK = 0.34;

/** Lengths in mm; `u`, `v`: places on the ground, X and Y of the machine, of a turning machine Z and Y. */
export interface Ground {
  turning: boolean;
  height: number;
  spacing: number;
  middle: [u: number, v: number];
  size: number; // of the map, around the middle
  radius: number;
  reaches: [number, number];
  /** Of the map: heights blurred little and much, the shadow; made when it is first asked for. */
  cells(): Float32Array;
  columns: number;
}

/** Where on the ground a point is, and how high the axis that is upright has it. */
export const stands = ([x, y, z]: Vec3, turning: boolean): Vec3 => (turning ? [z, y, x] : [x, y, z]);

export function groundOf(mesh: Mesh, { whole, ground: [height, spacing] }: Standing, turning: boolean): Ground {
  const box: Box = boxOn(mesh, turning) ?? {
    min: stands(whole[0], turning),
    max: stands(whole[1], turning),
  };
  const wide = Math.max(box.max[0] - box.min[0], box.max[1] - box.min[1], 1e-3);
  const size = wide * (1 + 2 * AROUND);
  const middle: [number, number] = [(box.min[0] + box.max[0]) / 2, (box.min[1] + box.max[1]) / 2];
  let made: Float32Array | undefined;
  return {
    turning,
    height,
    spacing,
    middle,
    size,
    radius: size * FAR,
    reaches: [REACHES[0] * size, REACHES[1] * size],
    columns: CELLS,
    cells: () => (made ??= mapOf(mesh, { turning, height, middle, size })),
  };
}

type Frame = Pick<Ground, "turning" | "height" | "middle" | "size">;

/** Calls back with each triangle that stands still, on the ground. */
function eachFace(mesh: Mesh, turning: boolean, face: (a: Vec3, b: Vec3, c: Vec3) => void): void {
  const { vertices, corners } = mesh;
  const at = (corner: number): Vec3 => {
    const first = VERTEX_FLOATS * corner;
    return stands([vertices[first]!, vertices[first + 1]!, vertices[first + 2]!], turning);
  };
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = [corners[i]!, corners[i + 1]!, corners[i + 2]!];
    const clear = vertices[VERTEX_FLOATS * a + OPACITY]! < 1;
    if (vertices[VERTEX_FLOATS * a + MOVES] === 0 && !clear) face(at(a), at(b), at(c));
  }
}

/** Around all that stands still; every vertex is the corner of a triangle. */
function boxOn({ vertices }: Mesh, turning: boolean): Box | null {
  const [min, max]: [Vec3, Vec3] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  for (let first = 0; first < vertices.length; first += VERTEX_FLOATS) {
    if (vertices[first + MOVES] !== 0 || vertices[first + OPACITY]! < 1) continue;
    for (let axis = 0; axis < 3; axis++) {
      const at = vertices[first + axis]!;
      if (at < min[axis]!) min[axis] = at;
      if (at > max[axis]!) max[axis] = at;
    }
  }
  return min[0] <= max[0] ? { min: stands(min, turning), max: stands(max, turning) } : null;
}

/** Four numbers a cell, as web/preview/src/layout.rs says. */
function mapOf(mesh: Mesh, frame: Frame): Float32Array {
  const heights = heightsOf(mesh, frame);
  const reach = (share: number): number => Math.max(1, Math.round(share * CELLS));
  const [near, far] = [blurred(heights, reach(REACHES[0])), blurred(heights, reach(REACHES[1]))];
  const shadow = blurred(shadowOf(heights, frame.size / CELLS), 4);
  const cells = new Float32Array(4 * CELLS * CELLS);
  for (let i = 0; i < heights.length; i++) {
    cells[4 * i] = near[i]!;
    cells[4 * i + 1] = far[i]!;
    cells[4 * i + 2] = DARK * shadow[i]!;
  }
  return cells;
}

/** How high the part stands over the middle of each cell, mm. */
function heightsOf(mesh: Mesh, { turning, height, middle: [u0, v0], size }: Frame): Float32Array {
  const heights = new Float32Array(CELLS * CELLS);
  const cell = size / CELLS;
  const [left, low] = [u0 - size / 2, v0 - size / 2];
  const first = (...at: number[]): number => Math.max(0, Math.ceil(Math.min(...at) / cell - 0.5));
  const last = (...at: number[]): number => Math.min(CELLS - 1, Math.floor(Math.max(...at) / cell - 0.5));
  eachFace(mesh, turning, (a, b, c) => {
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    if (Math.abs(area) < 1e-9) return;
    const rows = [first(a[1] - low, b[1] - low, c[1] - low), last(a[1] - low, b[1] - low, c[1] - low)] as const;
    const columns = [
      first(a[0] - left, b[0] - left, c[0] - left),
      last(a[0] - left, b[0] - left, c[0] - left),
    ] as const;
    for (let row = rows[0]; row <= rows[1]; row++) {
      const y = low + (row + 0.5) * cell;
      for (let column = columns[0]; column <= columns[1]; column++) {
        const x = left + (column + 0.5) * cell;
        const s = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area;
        const t = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area;
        if (s < 0 || t < 0 || s + t > 1) continue;
        const up = a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2]) - height;
        heights[row * CELLS + column] = Math.max(heights[row * CELLS + column]!, up);
      }
    }
  });
  return heights;
}

/** Where something stands between a place on the ground and the light, 0 to 1. */
function shadowOf(heights: Float32Array, cell: number): Float32Array {
  const shadow = new Float32Array(heights.length);
  const aside = Math.hypot(...LIGHT);
  // cells are whole numbers: how far a step leads aside is the same from each
  const leads = (one: number): number[] =>
    Array.from({ length: Math.ceil(0.3 * CELLS) }, (_, step) => Math.round((-step * one) / aside));
  const [right, down] = [leads(LIGHT[0]), leads(LIGHT[1])];
  for (let row = 0; row < CELLS; row++)
    for (let column = 0; column < CELLS; column++) {
      let found = heights[row * CELLS + column]! > 0 ? 1 : 0;
      for (let step = 1; !found && step < right.length; step++) {
        const [x, y] = [column + right[step]!, row + down[step]!];
        const up = x >= 0 && x < CELLS && y >= 0 && y < CELLS ? heights[y * CELLS + x]! : 0;
        if (up * aside > step * cell) found = 1;
      }
      shadow[row * CELLS + column] = found;
    }
  return shadow;
}

/** Two boxes of that radius one after the other, along rows and columns. */
function blurred(map: Float32Array, radius: number): Float32Array {
  let from = map;
  for (const [along, across] of [
    [1, CELLS],
    [CELLS, 1],
    [1, CELLS],
    [CELLS, 1],
  ] as const) {
    const to = new Float32Array(map.length);
    for (let line = 0; line < CELLS; line++) {
      const at = (i: number): number => from[line * across + Math.min(CELLS - 1, Math.max(0, i)) * along]!;
      let sum = 0;
      for (let i = -radius; i <= radius; i++) sum += at(i);
      for (let i = 0; i < CELLS; i++) {
        to[line * across + i * along] = sum / (2 * radius + 1);
        sum += at(i + radius + 1) - at(i - radius);
      }
    }
    from = to;
  }
  return from;
}
