// Which of what may hide a part does, seen from here: a chuck, the body of a probe, a turret.
import type { Vec3 } from "../wire";
import type { Frame } from "./backend";
import { projector } from "./camera";
import { MOVES, VERTEX_FLOATS } from "./mesh";
import type { Scene } from "./scene";
import { add } from "./vec";

const EDGE = 4; // CSS pixels around what hides
const EACH = 7; // not every vertex has to be looked at

/** 1 if what stands and may fade hides a place that is measured, 2 more if what moves does. */
export function fadedFor(scene: Scene, frame: Frame): number {
  const [solid, stands, moves] = scene.ends as [number, number, number];
  return (hides(scene, frame, solid, stands) ? 1 : 0) + (hides(scene, frame, stands, moves) ? 2 : 0);
}

/** Whether anything of these corners is before the ball or a touch of this scene. */
function hides(scene: Scene, frame: Frame, from: number, to: number): boolean {
  if (from === to || !frame.probe) return false;
  const project = projector(frame.camera, frame.view);
  const { corners, vertices } = scene.mesh;
  let [left, right, top, bottom, near] = [Infinity, -Infinity, Infinity, -Infinity, -Infinity];
  for (let i = from; i < to; i += EACH) {
    const first = corners[i]! * VERTEX_FLOATS;
    const at: Vec3 = [vertices[first]!, vertices[first + 1]!, vertices[first + 2]!];
    const place = project(vertices[first + MOVES] === 1 ? add(at, frame.probe) : at);
    [left, right] = [Math.min(left, place.x), Math.max(right, place.x)];
    [top, bottom] = [Math.min(top, place.y), Math.max(bottom, place.y)];
    near = Math.max(near, place.near);
  }
  const before = (place: Vec3): boolean => {
    const { x, y, near: own } = project(place);
    return own < near && x > left - EDGE && x < right + EDGE && y > top - EDGE && y < bottom + EDGE;
  };
  return before(frame.probe) || scene.touched.some(before);
}
