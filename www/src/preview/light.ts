// The light of shader.wgsl for the drawing without a GPU.
import type { Vec3 } from "../wire";
import type { Basis } from "./camera";
import type { Rgba } from "./colours";
import { add, dot, times, unit } from "./vec";

export function shader({ right, up, back }: Basis): (normal: Vec3, colour: Rgba) => Rgba {
  const key = unit(add(add(times(right, -0.45), times(up, 0.75)), times(back, 0.8)));
  const fill = unit(add(add(times(right, 0.8), times(up, -0.3)), times(back, 0.5)));
  return (normal, [r, g, b, a]) => {
    const n = dot(normal, back) < 0 ? times(normal, -1) : normal;
    const light = 0.6 + 0.4 * Math.max(dot(n, key), 0) + 0.1 * Math.max(dot(n, fill), 0);
    return [Math.min(1, r * light), Math.min(1, g * light), Math.min(1, b * light), a];
  };
}
