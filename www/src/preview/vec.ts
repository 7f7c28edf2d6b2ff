// Vectors and boxes, millimetres.
import type { Vec3 } from "../wire";

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
