// The light of shader.wgsl for the drawing without a GPU: its studio, without what stands around.
import type { Vec3 } from "../wire";
import type { Basis } from "./camera";
import type { Rgba } from "./colours";
import { Finish } from "./ink";
import { dot, times, unit } from "./vec";

const KEY = unit([-0.45, 0.6, 0.66]);
const FLAT = unit([-0.38, 0.63, 0.67]);

function smoothstep(low: number, high: number, value: number): number {
  const t = Math.min(1, Math.max(0, (value - low) / (high - low)));
  return t * t * (3 - 2 * t);
}

/** How much light comes from a direction, seen by the viewer: right, up, towards the viewer. */
function studio([x, y]: Vec3): number {
  const room = 0.38 + 0.27 * smoothstep(-0.8, 0.8, y) - 0.14 * x;
  const key = smoothstep(-0.95, -0.45, x) * (1 - smoothstep(-0.3, 0.15, x)) * smoothstep(-0.35, 0.25, y);
  const rim = smoothstep(0.55, 0.75, x) * (1 - smoothstep(0.85, 0.98, x)) * smoothstep(-0.6, 0, y);
  return room + 0.42 * key + 0.2 * rim;
}

export function shader({ right, up, back }: Basis): (normal: Vec3, colour: Rgba, finish?: number) => Rgba {
  return (normal, [r, g, b, a], finish = Finish.part) => {
    const n = dot(normal, back) < 0 ? times(normal, -1) : normal;
    const seen: Vec3 = [dot(n, right), dot(n, up), dot(n, back)];
    const way: Vec3 = [2 * seen[2] * seen[0], 2 * seen[2] * seen[1], 2 * seen[2] ** 2 - 1];
    const soft = 0.72 + 0.3 * seen[1] - 0.12 * seen[0];
    const shine = Math.max(dot(way, KEY), 0) ** 40;
    const [share, more] = reflected(finish, seen, way, soft, shine);
    return [...([r, g, b].map(value => Math.min(1, value * share + more)) as Vec3), a];
  };
}

/** Share of its own colour that a surface shows, and what of the light besides. */
function reflected(finish: number, seen: Vec3, way: Vec3, soft: number, shine: number): [number, number] {
  switch (finish) {
    case Finish.flat:
      return [0.6 + 0.4 * Math.max(dot(seen, FLAT), 0), 0];
    case Finish.satin:
      return [0.7 * soft + 0.25, 0.1 * studio(way) * shine + 0.05 * studio(way)];
    case Finish.ceramic:
      return [0.78 + 0.22 * soft, 0.25 * shine];
    case Finish.ruby:
      return [0.5 + 0.55 * soft, 0.9 * shine + 0.12 * (1 - seen[2])];
    case Finish.luminous:
      return [0.85 + 0.2 * soft, 0];
    default:
      return [0.45 * soft + 0.85 * studio(way), 0.1 * shine];
  }
}
