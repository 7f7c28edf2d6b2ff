// Vectors and rotations, millimetres and degrees.
import type { Vec3 } from "../wire";

export type Matrix3 = [Vec3, Vec3, Vec3]; // rows

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** A plain root: the library's own, safe against overflow, takes several times as long. */
export const length = (a: Vec3): number => Math.sqrt(dot(a, a));
export const mix = (a: Vec3, b: Vec3, t: number): Vec3 => add(a, times(sub(b, a), t));
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

export function unit(a: Vec3): Vec3 {
  const long = length(a);
  return long > 0 ? times(a, 1 / long) : [0, 0, 1];
}

export const radians = (degree: number): number => (degree * Math.PI) / 180;

/** Rotation about X, Y, Z by RPY angles in degree: the one about Z is applied last. */
export function rpy([x, y, z]: Vec3): Matrix3 {
  const [cx, sx] = [Math.cos(radians(x)), Math.sin(radians(x))];
  const [cy, sy] = [Math.cos(radians(y)), Math.sin(radians(y))];
  const [cz, sz] = [Math.cos(radians(z)), Math.sin(radians(z))];
  return [
    [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
    [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
    [-sy, cy * sx, cy * cx],
  ];
}

export const apply = (m: Matrix3, p: Vec3): Vec3 => [dot(m[0], p), dot(m[1], p), dot(m[2], p)];

/** The matrix that applies `b`, then `a`. */
export function product(a: Matrix3, b: Matrix3): Matrix3 {
  const row = (r: Vec3): Vec3 => add(add(times(b[0], r[0]), times(b[1], r[1])), times(b[2], r[2]));
  return [row(a[0]), row(a[1]), row(a[2])];
}

/** The rotation that takes +Z to `axis`, a unit vector. */
export function fromZ(axis: Vec3): Matrix3 {
  const side = Math.abs(axis[0]) < 0.9 ? unit(cross([1, 0, 0], axis)) : unit(cross([0, 1, 0], axis));
  const other = cross(side, axis);
  return [
    [other[0], side[0], axis[0]],
    [other[1], side[1], axis[1]],
    [other[2], side[2], axis[2]],
  ];
}

/** Smallest box around points; null: no point yet. */
export interface Box {
  min: Vec3;
  max: Vec3;
}

export function include(box: Box | null, p: Vec3): Box {
  if (!box) return { min: [...p], max: [...p] };
  return {
    min: [Math.min(box.min[0], p[0]), Math.min(box.min[1], p[1]), Math.min(box.min[2], p[2])],
    max: [Math.max(box.max[0], p[0]), Math.max(box.max[1], p[1]), Math.max(box.max[2], p[2])],
  };
}

export const centre = (box: Box): Vec3 => mix(box.min, box.max, 0.5);

export function boxCorners(box: Box): Vec3[] {
  const ends = [box.min, box.max];
  return [0, 1, 2, 3, 4, 5, 6, 7].map((i): Vec3 => [ends[i & 1]![0], ends[(i >> 1) & 1]![1], ends[i >> 2]![2]]);
}
