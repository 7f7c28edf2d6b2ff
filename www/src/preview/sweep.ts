// What ball and stylus sweep on the way of the present step. In parallel projection that is a broad line and an area.

import { firstFrom, type SceneData, vec } from "../core/scene";
import type { Drawn } from "../draw";
import type { Vec3 } from "../wire";
import type { Frame } from "./backend";
import { projector } from "./camera";
import { onPiece, piecesOf } from "./motion";
import type { Scene } from "./scene";
import { add, times } from "./vec";

const THROUGH = 0.24;

/**
 * Places of the ball on the motion of the present entry up to where it is, or on all of the one that ended in its touch
 * or crash.
 */
function wayOf(data: SceneData, time: number): Vec3[] {
  const { ways, wayEntries, touchEntries } = data;
  const index = Math.max(0, Math.ceil(time) - 1);
  let [from, to] = piecesOf(data, index);
  let part = time - index;
  if (from === to) {
    const touched = touchEntries[firstFrom(touchEntries, index)] === index;
    if (!touched || from === 0) return [];
    [from, to] = piecesOf(data, wayEntries[from - 1]!);
    part = 1;
  }
  const places = [vec(ways, 8 * from)];
  for (let piece = from; piece < to; piece++) {
    places.push(onPiece(data, piece, part));
    if (ways[8 * piece + 7]! >= part) break;
  }
  return places;
}

type Point = { x: number; y: number };
const line = (points: Point[]): string => `M${points.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`;

/** A quadrilateral, always turning the same way, so that two that overlap fill no hole into each other. */
function area([a, b, c, d]: [Point, Point, Point, Point]): string {
  const turns = (c.x - a.x) * (d.y - b.y) - (c.y - a.y) * (d.x - b.x);
  return `${line(turns < 0 ? [a, d, c, b] : [a, b, c, d])}Z`;
}

export function swept({ data, tool, colours }: Scene, { camera, view, time }: Frame): Drawn[] {
  const balls = wayOf(data, time);
  const axis = tool?.ball;
  if (!balls.length || !axis) return [];
  const { ball, stylus, reach } = data.view.probe;
  const project = projector(camera, view);
  const [low, high] = [balls.map(project), balls.map(place => project(add(place, times(axis, reach))))];
  const walls = low
    .slice(1)
    .map((end, i) => area([low[i]!, end, high[i + 1]!, high[i]!]))
    .join("");
  const band = (d: string, colour: string, radius: number, fill: string): Drawn => ({
    tag: "path",
    attributes: {
      d,
      fill,
      stroke: colour,
      opacity: THROUGH,
      "stroke-width": 2 * radius * low[0]!.scale,
      "stroke-linecap": "round",
      "stroke-linejoin": "round",
    },
  });
  return [band(walls, colours.stylus, stylus, colours.stylus), band(line(low), colours.ball, ball, "none")];
}
