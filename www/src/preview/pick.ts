// Which motion or touch is under the pointer, and which dimension.
import { type Camera, type Projected, projector, type Viewport } from "./camera";
import type { Line } from "./mesh";

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

function nearest(a: Projected, b: Projected, x: number, y: number): { distance: number; near: number } {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const square = dx * dx + dy * dy;
  const t = square > 0 ? Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / square)) : 0;
  return { distance: Math.hypot(a.x + t * dx - x, a.y + t * dy - y), near: a.near + t * (b.near - a.near) };
}
