// The plane at which a part is cut open: through what was touched, across the axis of the machine that points to the
// viewer most.
import type { Vec3 } from "../wire";
import { basis, type Camera } from "./camera";
import type { Scene } from "./scene";
import { add, dot, times } from "./vec";

/** What lies beyond it along the normal is cut away. */
export interface Plane {
  normal: Vec3;
  distance: number; // mm
}

export function sectionOf(scene: Scene, camera: Camera): Plane | null {
  if (!scene.section) return null;
  const { back } = basis(camera);
  const axis = [0, 1, 2].reduce((most, axis) => (Math.abs(back[axis]!) > Math.abs(back[most]!) ? axis : most), 0);
  const normal = [0, 1, 2].map(other => (other === axis ? Math.sign(back[axis]!) : 0)) as Vec3;
  return { normal, distance: dot(normal, through(scene)) };
}

/** The middle of the touches, without any that of all there is. */
function through({ touched, ground, origin }: Scene): Vec3 {
  if (touched.length) return times(touched.reduce(add), 1 / touched.length);
  const [u, v] = ground.middle;
  return ground.turning ? [origin[0], v, u] : [u, v, origin[2]];
}

export const isCut = (plane: Plane | null, at: Vec3): boolean => !!plane && dot(plane.normal, at) > plane.distance;
