// Arrows from where a face should be to where it was measured on the real part, enlarged until they are seen.

import type { Drawn } from "../draw";
import type { Vec3 } from "../wire";
import type { Frame } from "./backend";
import { projector } from "./camera";
import type { Scene } from "./scene";
import { add, length, times } from "./vec";

/** `by`: mm; `bad`: beyond a limit. */
export interface Arrow {
  at: Vec3;
  by: Vec3;
  bad: boolean;
}

const LONGEST = 0.12; // of the scene
const MOST = 2000; // that are drawn: the longest come first
const NUMBERED = 40; // so many have their length beside them
const HEAD = 7; // CSS pixels

/** The longest arrows, the longest one first. */
export function longest(all: readonly Arrow[]): readonly Arrow[] {
  return [...all].sort((a, b) => length(b.by) - length(a.by)).slice(0, MOST);
}

/** `all`: the longest first. */
export function arrowsIn(all: readonly Arrow[], scene: Scene, { camera, view }: Frame): Drawn[] {
  const [first] = all;
  if (!first) return [];
  const enlarged = (LONGEST * 2 * scene.radius) / length(first.by);
  const project = projector(camera, view);
  return all.flatMap(({ at, by, bad }, index) => {
    const [from, to] = [project(at), project(add(at, times(by, enlarged)))];
    const colour = bad ? scene.colours.crash : scene.colours.inside;
    const [dx, dy] = [to.x - from.x, to.y - from.y];
    const long = Math.hypot(dx, dy);
    const head = Math.min(HEAD, long / 2);
    const [ux, uy] = long > 0 ? [dx / long, dy / long] : [0, 0];
    const [bx, wx, wy] = [to.x - ux * head, (-uy * head) / 2, (ux * head) / 2];
    const byY = to.y - uy * head;
    const path = `M${from.x} ${from.y}L${bx} ${byY}M${to.x} ${to.y}L${bx + wx} ${byY + wy}L${bx - wx} ${byY - wy}Z`;
    const line = { d: path, stroke: colour, fill: colour, "stroke-width": 2, class: "arrow" };
    const word: Drawn = {
      tag: "text",
      attributes: {
        x: to.x + ux * 4,
        y: to.y + uy * 4 + 4,
        "text-anchor": dx < 0 ? "end" : "start",
        fill: colour,
        stroke: scene.colours.background,
        "stroke-width": 3,
        "paint-order": "stroke",
        "font-size": 11,
      },
      text: length(by).toFixed(3),
    };
    return [{ tag: "path", attributes: line }, ...(index < NUMBERED ? [word] : [])];
  });
}
