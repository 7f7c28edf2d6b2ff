// The way of a motion: straight, or round an axis (core/src/geometry/arc.rs says the same to the simulation).
import type { Step, Vec3 } from "../wire";
import { add, cross, dot, length, mix, radians, sub, times } from "./vec";

export type Motion = Extract<Step, { step: "motion" }>;

const PIECE = 3; // degrees of an arc that are drawn as a straight line

/** The place after a part of the way, 0 to 1. */
export function along({ from, to, around }: Motion, part: number): Vec3 {
  if (!around) return mix(from, to, part);
  const { centre, axis, degrees } = around;
  const split = (point: Vec3): { out: Vec3; height: number } => {
    const away = sub(point, centre);
    const height = dot(away, axis);
    return { out: sub(away, times(axis, height)), height };
  };
  const [start, end] = [split(from), split(to)];
  const angle = radians(degrees * part);
  const turned = add(times(start.out, Math.cos(angle)), times(cross(axis, start.out), Math.sin(angle)));
  const size = 1 + part * (length(end.out) / length(start.out) - 1);
  return add(add(centre, times(turned, size)), times(axis, start.height + part * (end.height - start.height)));
}

/** Parts at which the straight pieces end that draw it, 1 the last. */
export function pieces({ around }: Motion): number[] {
  const count = around ? Math.max(1, Math.ceil(Math.abs(around.degrees) / PIECE)) : 1;
  return Array.from({ length: count }, (_, i) => (i + 1) / count);
}
