// What ball and stylus sweep on the way of the present step. In parallel projection that is a broad line and an area.
import type { Drawn } from "../draw";
import type { Trace, Vec3 } from "../wire";
import type { Frame } from "./backend";
import { projector } from "./camera";
import { along, type Motion, pieces } from "./route";
import type { Scene } from "./scene";
import { stylusAxis, stylusRadius } from "./stylus";
import { add, times } from "./vec";

const THROUGH = 0.24;

/** The motion of an entry, or the one that ended in its touch or crash; and how much of it is done. */
function wayOf({ entries }: Trace, time: number): { motion: Motion; part: number } | null {
  const index = Math.max(0, Math.ceil(time) - 1);
  const kind = entries[index]?.step;
  if (kind !== "motion" && kind !== "touch" && kind !== "crash") return null;
  let last = index;
  while (last > 0 && entries[last]?.step !== "motion") last--;
  const motion = entries[last];
  return motion?.step === "motion" ? { motion, part: kind === "motion" ? time - index : 1 } : null;
}

/** Places of the ball on its way, up to where it is. */
function places(motion: Motion, part: number): Vec3[] {
  return [0, ...pieces(motion).filter(one => one < part), part].map(one => along(motion, one));
}

type Point = { x: number; y: number };
const line = (points: Point[]): string => `M${points.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`;

/** A quadrilateral, always turning the same way, so that two that overlap fill no hole into each other. */
function area([a, b, c, d]: [Point, Point, Point, Point]): string {
  const turns = (c.x - a.x) * (d.y - b.y) - (c.y - a.y) * (d.x - b.x);
  return `${line(turns < 0 ? [a, d, c, b] : [a, b, c, d])}Z`;
}

export function swept({ trace, tool, reach, colours }: Scene, { camera, view, time }: Frame): Drawn[] {
  const way = wayOf(trace, time);
  const axis = stylusAxis(tool);
  if (!way || !axis) return [];
  const project = projector(camera, view);
  const balls = places(way.motion, way.part);
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
      "stroke-width": 2 * radius * camera.scale,
      "stroke-linecap": "round",
      "stroke-linejoin": "round",
    },
  });
  return [
    band(walls, colours.stylus, stylusRadius(trace.ball), colours.stylus),
    band(line(low), colours.ball, trace.ball.radius, "none"),
  ];
}
