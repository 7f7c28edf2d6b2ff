// Which motion or touch is under the pointer, which dimension, and where on the part.
import { type SceneData, vec } from "../core/scene";
import type { Vec3 } from "../wire";
import { type Camera, type Projected, projector, type Viewport } from "./camera";
import type { Line } from "./mesh";
import { standingAt } from "./motion";
import { placed, turned } from "./scene";
import { add, times, unit } from "./vec";

/** A point of the part, and the direction out of it there, in the machine. */
export interface Face {
  at: Vec3;
  normal: Vec3;
}

const WITHIN = 9; // CSS pixels
const BESIDE = 5; // from the line of a dimension

/** Parameter of the dimension whose words or line are there; null: none. */
export function fieldAt(
  stage: HTMLElement,
  lines: readonly Line[],
  { camera, view }: { camera: Camera; view: Viewport },
  x: number,
  y: number,
): string | null {
  const { left, top } = stage.getBoundingClientRect();
  for (const words of stage.querySelectorAll<SVGElement>("text[data-field]")) {
    const box = words.getBoundingClientRect();
    const inside = x + left >= box.left && x + left <= box.right && y + top >= box.top && y + top <= box.bottom;
    if (inside) return words.dataset.field ?? null;
  }
  const project = projector(camera, view);
  const away = ({ from, to }: Line): number => nearest(project(from), project(to), x, y).distance;
  const near = lines.filter(line => line.style.field !== undefined && away(line) <= BESIDE);
  return near.sort((a, b) => away(a) - away(b))[0]?.style.field ?? null;
}

/** Entry of the nearest path on the screen, the nearer to the viewer where several are equally close; null: none. */
export function pick(lines: Line[], camera: Camera, view: Viewport, x: number, y: number): number | null {
  const project = projector(camera, view);
  let best: { distance: number; near: number; entry: number } | null = null;
  for (const { from, to, style } of lines) {
    if (style.entry === undefined) continue;
    const { distance, near } = nearest(project(from), project(to), x, y);
    const reached = distance - style.width / 2;
    if (reached > WITHIN) continue;
    const closer = !best || reached < best.distance - 0.5 || (reached < best.distance + 0.5 && near > best.near);
    if (closer) best = { distance: reached, near, entry: style.entry };
  }
  return best?.entry ?? null;
}

/** The place of the part under the pointer that is nearest to the viewer, as it stands at an entry; null: none. */
export function faceAt(
  data: SceneData,
  index: number,
  { camera, view }: { camera: Camera; view: Viewport },
  x: number,
  y: number,
): Face | null {
  const project = projector(camera, view);
  const { standing } = standingAt(data, index);
  let best: { near: number; face: Face } | null = null;
  for (const { matter, corners, place: number } of data.view.pieces) {
    if (matter !== "part") continue;
    const place = number === undefined ? undefined : standing.places[number];
    for (let first = corners[0]; first < corners[1]; first += 3) {
      const vertices = [0, 1, 2].map(corner => 6 * data.corners[first + corner]!);
      const points = vertices.map(vertex => placed(place, vec(data.vertices, vertex)));
      const seen = points.map(project);
      const shares = sharesOf(seen, x, y);
      if (!shares) continue;
      const mean = (all: Vec3[]): Vec3 => all.map((one, i) => times(one, shares[i]!)).reduce(add);
      const near = seen.reduce((sum, one, i) => sum + one.near * shares[i]!, 0);
      if (best && near <= best.near) continue;
      const normals = vertices.map(vertex => vec(data.vertices, vertex + 3));
      const normal = unit(mean(normals.map(one => (place ? turned(place, one) : one))));
      best = { near, face: { at: mean(points), normal } };
    }
  }
  return best?.face ?? null;
}

/** By which shares of its corners a place of a triangle is under the pointer; null: the pointer is beside it. */
function sharesOf(seen: Projected[], x: number, y: number): number[] | null {
  const area = (p: { x: number; y: number }, q: { x: number; y: number }): number =>
    (p.x - x) * (q.y - y) - (p.y - y) * (q.x - x);
  const [a, b, c] = [seen[0]!, seen[1]!, seen[2]!];
  const parts = [area(b, c), area(c, a), area(a, b)];
  const whole = parts.reduce((sum, part) => sum + part, 0);
  if (whole === 0 || parts.some(part => part * whole < 0)) return null;
  const weights = parts.map((part, i) => part * seen[i]!.scale); // what is farther away is drawn smaller
  const sum = weights.reduce((all, one) => all + one, 0);
  return weights.map(one => one / sum);
}

/** How far a point is from a line between two others, CSS pixels. */
export const onSegment = (a: Projected, b: Projected, x: number, y: number): number => nearest(a, b, x, y).distance;

function nearest(a: Projected, b: Projected, x: number, y: number): { distance: number; near: number } {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const square = dx * dx + dy * dy;
  const t = square > 0 ? Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / square)) : 0;
  return { distance: Math.hypot(a.x + t * dx - x, a.y + t * dy - y), near: a.near + t * (b.near - a.near) };
}
