// The probe under the pointer, and along which axis a drag moves it.
import type { Vec3 } from "../wire";
import { type Camera, projector, type Viewport } from "./camera";
import type { Content } from "./content";
import { probeAt, toolAt } from "./motion";
import { onSegment } from "./pick";
import { add, times } from "./vec";

interface Seen {
  camera: Camera;
  view: Viewport;
}

const WITHIN = 14; // CSS pixels, for a finger too
const SHORT = 0.15; // of the scale: an axis that is seen from its end cannot be pulled along
const DECIDED = 6; // CSS pixels after which the axis is chosen
const AXES: readonly Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** Centre of the ball of the probe that is under the pointer, or whose stylus is; null: it is not. */
export function heldAt({ data, step }: Content, { camera, view }: Seen, x: number, y: number): Vec3 | null {
  const ball = probeAt(data, step.index, step.fraction);
  const up = toolAt(data, step.index)?.ball;
  if (!ball || !up) return null;
  const project = projector(camera, view);
  const [end, top] = [project(ball), project(add(ball, times(up, data.view.probe.length)))];
  const reach = Math.max(WITHIN, data.view.probe.ball * end.scale);
  return onSegment(end, top, x, y) <= reach ? ball : null;
}

/**
 * A drag from there: which axis of the machine it moves along, how far since it began, mm, and how far beside that axis
 * the pointer is, CSS pixels.
 */
export function pulled(
  from: Vec3,
  { camera, view }: Seen,
  x: number,
  y: number,
): (x: number, y: number) => { axis: number; way: number; beside: number } | null {
  const project = projector(camera, view);
  const here = project(from);
  const along = AXES.map(axis => {
    const there = project(add(from, axis));
    return { dx: there.x - here.x, dy: there.y - here.y };
  });
  let axis: number | null = null;
  return (nowX, nowY) => {
    const [dx, dy] = [nowX - x, nowY - y];
    const ways = along.map(one => (one.dx * dx + one.dy * dy) / (one.dx ** 2 + one.dy ** 2));
    if (axis === null && Math.hypot(dx, dy) >= DECIDED) {
      const fits = along.map(one => {
        const length = Math.hypot(one.dx, one.dy);
        return length < SHORT * camera.scale ? 0 : Math.abs(one.dx * dx + one.dy * dy) / length;
      });
      axis = fits.indexOf(Math.max(...fits));
    }
    const line = axis === null ? undefined : along[axis];
    if (axis === null || !line) return null;
    const beside = Math.abs(line.dx * dy - line.dy * dx) / Math.hypot(line.dx, line.dy);
    return { axis, way: ways[axis] ?? 0, beside };
  };
}
