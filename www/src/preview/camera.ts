// The camera of all ways of drawing, in parallel or in central projection. Z of the machine is always upright; of a
// turning machine X is, with Z to the right.
import type { Vec3 } from "../wire";
import { add, type Box, boxCorners, cross, dot, mix, radians, sub, times } from "./vec";

/**
 * `yaw`, `pitch` in radians; yaw 0, pitch 0: seen from −Y, a turning machine from +Y. `scale`: CSS pixels a millimetre.
 */
export interface Camera {
  yaw: number;
  pitch: number;
  target: Vec3;
  scale: number;
  turning: boolean;
  central?: boolean; // projection; `scale` counts at the target
}
/** CSS pixels. */
export interface Viewport {
  width: number;
  height: number;
}
export type ViewName = "top" | "front" | "right" | "iso" | "bottom" | "back" | "left";
/** Directions in the machine: to the right and up on the screen, and towards the viewer. */
export interface Basis {
  right: Vec3;
  up: Vec3;
  back: Vec3;
}
/**
 * CSS pixels from the top left corner; `near` in mm, larger is nearer to the viewer; `scale`: CSS pixels a millimetre
 * there.
 */
export interface Projected {
  x: number;
  y: number;
  near: number;
  scale: number;
}

const QUARTER = Math.PI / 2;
const VIEWS: Record<ViewName, [yaw: number, pitch: number]> = {
  top: [0, QUARTER],
  front: [0, 0],
  right: [QUARTER, 0],
  iso: [radians(33), radians(36)],
  bottom: [0, -QUARTER],
  back: [Math.PI, 0],
  left: [-QUARTER, 0],
};
const MARGIN = 0.1; // around what is fitted, share of the viewport
const AWAY = 2; // of the eye from the target in heights of the viewport, in central projection
const CLOSEST = 0.02; // to the eye, share of its distance
const PARALLEL = 1000; // distance of an eye that sees everything from one side, in reaches
const MIN_SCALE = 1e-3;
const MAX_SCALE = 1e6;

export function initial(): Camera {
  return { yaw: VIEWS.iso[0], pitch: VIEWS.iso[1], target: [0, 0, 0], scale: 4, turning: false };
}

export function basis({ yaw, pitch, turning }: Camera): Basis {
  const lies = ([x, y, z]: Vec3): Vec3 => (turning ? [z, -y, x] : [x, y, z]);
  const right = lies([Math.cos(yaw), Math.sin(yaw), 0]);
  const back = lies([Math.sin(yaw) * Math.cos(pitch), -Math.cos(yaw) * Math.cos(pitch), Math.sin(pitch)]);
  return { right, back, up: cross(back, right) };
}

/** From the eye to the target, mm; in parallel projection it is beyond everything. */
const distance = ({ central, scale }: Camera, { height }: Viewport): number =>
  central ? (AWAY * height) / scale : Infinity;

/** Where the eye is; in parallel projection far out on its side, in lengths of `reach`. */
export function eye(camera: Camera, view: Viewport, reach: number): Vec3 {
  const away = Math.min(distance(camera, view), PARALLEL * reach);
  return add(camera.target, times(basis(camera).back, away));
}

export function projector(camera: Camera, view: Viewport): (p: Vec3) => Projected {
  const { right, up, back } = basis(camera);
  const away = distance(camera, view);
  return p => {
    const d = sub(p, camera.target);
    const near = dot(d, back);
    const scale = camera.scale / Math.max(CLOSEST, 1 - near / away);
    return { x: view.width / 2 + dot(d, right) * scale, y: view.height / 2 - dot(d, up) * scale, near, scale };
  };
}

/** Clip matrix, columns first; depth 0 … 1 holds everything within `reach` mm of the target and before the eye. */
export function matrix(camera: Camera, view: Viewport, reach: number): number[] {
  const { right, up, back } = basis(camera);
  const away = distance(camera, view);
  const nearest = Math.min(reach, (1 - CLOSEST) * away);
  const deep = (1 + reach / away) / (nearest + reach);
  const rows: [Vec3, number][] = [
    [times(right, (2 * camera.scale) / view.width), 0],
    [times(up, (2 * camera.scale) / view.height), 0],
    [times(back, -deep), deep * nearest],
    [times(back, -1 / away), 1],
  ];
  const shifted = rows.map(([axis, offset]) => offset - dot(axis, camera.target));
  const columns = [0, 1, 2].map(i => rows.map(([axis]) => axis[i]!));
  return [...columns.flat(), ...shifted];
}

export function orbit(camera: Camera, yaw: number, pitch: number): Camera {
  const turned = Math.min(QUARTER, Math.max(-QUARTER, camera.pitch + pitch));
  return { ...camera, yaw: camera.yaw + yaw, pitch: turned };
}

/** The scene follows the pointer by `dx`, `dy` CSS pixels. */
export function pan(camera: Camera, dx: number, dy: number): Camera {
  const { right, up } = basis(camera);
  const moved = add(times(right, -dx / camera.scale), times(up, dy / camera.scale));
  return { ...camera, target: add(camera.target, moved) };
}

/** What is under the pointer at `x`, `y` stays there. */
export function zoom(camera: Camera, view: Viewport, factor: number, x = view.width / 2, y = view.height / 2): Camera {
  const scale = Math.min(MAX_SCALE, Math.max(MIN_SCALE, camera.scale * factor));
  const [dx, dy] = [x - view.width / 2, y - view.height / 2];
  const { right, up } = basis(camera);
  const share = 1 / camera.scale - 1 / scale;
  const moved = add(times(right, dx * share), times(up, -dy * share));
  return { ...camera, scale, target: add(camera.target, moved) };
}

/**
 * `held`: the direction from the ball to what holds it. A probe that comes along Y (G18) is looked at obliquely from
 * its own side; from the front the part would hide it.
 */
export function turn(camera: Camera, name: ViewName, held?: Vec3): Camera {
  const [yaw, pitch] = VIEWS[name];
  const behind = name === "iso" && !camera.turning && held !== undefined && held[1] > 0.5;
  return { ...camera, yaw: behind ? Math.PI - yaw : yaw, pitch };
}

/** The whole box, in the middle of what is right of `covered` (CSS pixels), with a margin around it. */
export function fit(camera: Camera, view: Viewport, box: Box, covered = 0): Camera {
  const { right, up } = basis(camera);
  const corners = boxCorners(box);
  const span = (axis: Vec3) => {
    const along = corners.map(corner => dot(corner, axis));
    return { low: Math.min(...along), high: Math.max(...along) };
  };
  const [h, v] = [span(right), span(up)];
  const middle = times(add(box.min, box.max), 0.5);
  const offset = add(
    times(right, (h.low + h.high) / 2 - dot(middle, right)),
    times(up, (v.low + v.high) / 2 - dot(middle, up)),
  );
  const scale = fitting(view, covered, h.high - h.low, v.high - v.low);
  const fitted = { ...camera, target: add(middle, offset), scale };
  return pan(camera.central ? closer(fitted, view, box, covered) : fitted, covered / 2, 0);
}

/** CSS pixels a millimetre at which this width and height fill their room. */
function fitting(view: Viewport, covered: number, width: number, height: number): number {
  const room = 1 - 2 * MARGIN;
  const scale = Math.min(
    ((view.width - covered) * room) / Math.max(width, 1e-6),
    (view.height * room) / Math.max(height, 1e-6),
  );
  return Math.min(MAX_SCALE, Math.max(MIN_SCALE, scale));
}

const TRIES = 4; // in central projection what is nearer is larger: a few looks bring the box to its place

function closer(camera: Camera, view: Viewport, box: Box, covered: number): Camera {
  let found = camera;
  for (let n = 0; n < TRIES; n++) {
    const seen = boxCorners(box).map(projector(found, view));
    const [xs, ys] = [seen.map(({ x }) => x), seen.map(({ y }) => y)];
    const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const centred = pan(found, view.width / 2 - (left + right) / 2, view.height / 2 - (top + bottom) / 2);
    const scale = fitting(view, covered, (right - left) / found.scale, (bottom - top) / found.scale);
    found = { ...centred, scale };
  }
  return found;
}

/** On the way from one to another by the shorter turn, 0 to 1. */
export function between(from: Camera, to: Camera, part: number): Camera {
  const turns = Math.round((to.yaw - from.yaw) / (2 * Math.PI));
  const mixed = (a: number, b: number): number => a + part * (b - a);
  return {
    ...to,
    yaw: mixed(from.yaw, to.yaw - turns * 2 * Math.PI),
    pitch: mixed(from.pitch, to.pitch),
    target: mix(from.target, to.target, part),
    scale: from.scale * (to.scale / from.scale) ** part,
  };
}
