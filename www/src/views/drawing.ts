// The figures of a help picture as SVG, in plain data: from the ground up, each with what is written beside it.

import type { Drawn } from "../draw";
import type { PictureShape } from "../wire";
import { type Caption, type Obstacle, type Placed, type Point, type Size, spread, widthOf } from "./captions";

const MARGIN = { x: 30, y: 22 }; // CSS pixels around the figures, for captions
/** From the ground up: what is filled must not hide what is drawn in lines. */
const ORDER: PictureShape["kind"][] = [
  "material",
  "cut",
  "tolerance",
  "plane",
  "axis",
  "zone",
  "path",
  "edge",
  "probe",
  "touch",
  "dimension",
  "label",
];
type Place = (point: Point) => Point;

function extent(shapes: PictureShape[]): { low: Point; high: Point } {
  const all = shapes.flatMap((shape): Point[] =>
    shape.circle
      ? [
          [shape.circle.x - shape.circle.r, shape.circle.y - shape.circle.r],
          [shape.circle.x + shape.circle.r, shape.circle.y + shape.circle.r],
          ...shape.points,
        ]
      : shape.points,
  );
  if (all.length === 0) return { low: [-1, -1], high: [1, 1] };
  return {
    low: [Math.min(...all.map(p => p[0])), Math.min(...all.map(p => p[1]))],
    high: [Math.max(...all.map(p => p[0])), Math.max(...all.map(p => p[1]))],
  };
}

/** Millimetres to picture points, y up. */
function placing(shapes: PictureShape[], { width, height }: Size): { place: Place; scale: number } {
  const { low, high } = extent(shapes);
  const scale = Math.min(
    (width - 2 * MARGIN.x) / Math.max(high[0] - low[0], 1e-9),
    (height - 2 * MARGIN.y) / Math.max(high[1] - low[1], 1e-9),
  );
  const middle: Point = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
  return { scale, place: ([x, y]) => [width / 2 + (x - middle[0]) * scale, height / 2 - (y - middle[1]) * scale] };
}

const r = (value: number): string => value.toFixed(2);

function outline(points: Point[], closed: boolean): string {
  return points.map(([x, y], index) => `${index ? "L" : "M"}${r(x)} ${r(y)}`).join("") + (closed ? "Z" : "");
}

/**
 * A polygon that comes back to its first point before its end is an outline around another: both, without the line that
 * joins them.
 */
function rings(points: Point[]): Point[][] {
  const list: Point[][] = [];
  let start = 0;
  points.forEach((point, index) => {
    const first = points[start];
    if (index <= start || !first || point[0] !== first[0] || point[1] !== first[1]) return;
    list.push(points.slice(start, index));
    start = index + 1;
  });
  return list.length > 1 ? list : [points];
}

/** How much a caption upon a line of each kind takes from the reader; what is filled only is none. */
const WEIGHTS: Partial<Record<PictureShape["kind"], number>> = {
  edge: 2,
  cut: 2,
  probe: 1.2,
  dimension: 1.6,
  zone: 1,
  axis: 0.8,
  path: 0.4,
  touch: 4,
};
const CORNERS = 16; // of a circle, for captions that go around it

/** The lines of a shape that captions keep away from. */
function obstacles(shape: PictureShape, place: Place, scale: number): Obstacle[] {
  const weight = WEIGHTS[shape.kind];
  if (!weight) return [];
  const points = shape.points.map(place);
  const lines = rings(points).map((ring): Point[] => (shape.closed && ring[0] ? [...ring, ring[0]] : ring));
  const dots = shape.kind === "touch" && !shape.circle ? points.map(point => round(point, 4)) : [];
  const circles = [shape.circle, shape.opening].flatMap(circle =>
    circle ? [round(place([circle.x, circle.y]), Math.max(circle.r * scale, 4))] : [],
  );
  return [...lines, ...dots, ...circles].flatMap(line =>
    line.slice(1).map((to, index) => ({ from: line[index] ?? to, to, weight })),
  );
}

function round([x, y]: Point, radius: number): Point[] {
  return Array.from({ length: CORNERS + 1 }, (_, index): Point => {
    const angle = (index / CORNERS) * 2 * Math.PI;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}

/** A whole circle as a path. */
function circled({ x, y, r: radius }: NonNullable<PictureShape["circle"]>, place: Place, scale: number): string {
  const [cx, cy] = place([x, y]);
  const long = r(radius * scale);
  const half = (to: number): string => `A${long} ${long} 0 0 0 ${r(to)} ${r(cy)}`;
  return `M${r(cx - radius * scale)} ${r(cy)}${half(cx + radius * scale)}${half(cx - radius * scale)}Z`;
}

/** What is written beside a figure: the name of a parameter, with what was typed for it. */
interface Words {
  text: string;
  short?: string | undefined;
}

/** A caption that stays inside the picture. */
function caption(words: Words, at: Point, anchor: Caption["anchor"], { width, height }: Size): Caption {
  const long = widthOf(words.text);
  const before = anchor === "middle" ? long / 2 : 0;
  const x = Math.min(Math.max(at[0], before + 3), width - long + before - 3);
  return { ...words, anchor, at: [x, Math.min(Math.max(at[1], 11), height - 4)] };
}

/** Of one shape: its lines, and what is written beside them. */
interface Figure {
  lines: Drawn[];
  captions: Caption[];
}

const path = (d: string, more: Drawn["attributes"] = {}): Drawn => ({ tag: "path", attributes: { d, ...more } });

function dimension(a: Point, b: Point, words: Words | undefined, size: Size): Figure {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
  const along: Point = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
  const short = length < 22; // no room for two heads inside: they point from outside
  const head = (tip: Point, way: number): Drawn => {
    const back: Point = [tip[0] + along[0] * 8 * way, tip[1] + along[1] * 8 * way];
    const side: Point = [-along[1] * 2.6, along[0] * 2.6];
    return path(outline([tip, [back[0] + side[0], back[1] + side[1]], [back[0] - side[0], back[1] - side[1]]], true), {
      class: "arrow",
    });
  };
  const tick = (at: Point): string =>
    `M${r(at[0] - along[1] * 5)} ${r(at[1] + along[0] * 5)}L${r(at[0] + along[1] * 5)} ${r(at[1] - along[0] * 5)}`;
  const out = short ? 14 : 0;
  const ends: Point[] = [
    [a[0] - along[0] * out, a[1] - along[1] * out],
    [b[0] + along[0] * out, b[1] + along[1] * out],
  ];
  const lines = [path(outline(ends, false) + tick(a) + tick(b)), head(a, short ? -1 : 1), head(b, short ? 1 : -1)];
  const upright = Math.abs(along[1]) > 0.7;
  const share = upright && !short ? 0.72 : 0.5; // upright ones clear of what is written at the middle
  const at: Point = [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share];
  return { lines, captions: words ? [beside(words, at, upright, size)] : [] };
}

/** A caption to the right or left of an upright dimension, above or below another one. */
function beside(words: Words, [x, y]: Point, upright: boolean, size: Size): Caption {
  const anchor = upright ? "start" : "middle";
  const [at, other]: [Point, Point] = upright
    ? [
        [x + 6, y + 4],
        [x - 6 - widthOf(words.text), y + 4],
      ]
    : [
        [x, y - 7],
        [x, y + 13],
      ];
  return { ...caption(words, at, anchor, size), other };
}

/** What is drawn for one shape; `value`: what was typed for the parameter that a dimension shows. */
function figure(shape: PictureShape, place: Place, scale: number, size: Size, value: string): Figure {
  const points = shape.points.map(place);
  const [a, b] = points;
  const { text: short } = shape;
  const words: Words | undefined =
    short && value ? { text: `${short} ${value}`, short } : short ? { text: short } : undefined;
  if (shape.kind === "dimension" && a && b) return dimension(a, b, words, size);
  const lines: Drawn[] = [];
  const circle = shape.circle && {
    at: place([shape.circle.x, shape.circle.y]),
    r: Math.max(shape.circle.r * scale, 2.5),
  };
  const opening = shape.opening ? circled(shape.opening, place, scale) : "";
  const open = opening ? { "fill-rule": "evenodd" } : {};
  if (shape.circle && opening) lines.push(path(circled(shape.circle, place, scale) + opening, open));
  else if (circle)
    lines.push({ tag: "circle", attributes: { cx: r(circle.at[0]), cy: r(circle.at[1]), r: r(circle.r) } });
  if (shape.kind === "touch" && !shape.circle)
    for (const [x, y] of points) lines.push(path(`M${r(x - 4)} ${r(y)}h8M${r(x)} ${r(y - 4)}v8`));
  else if (points.length > 1)
    lines.push(
      path(
        shape.closed
          ? rings(points)
              .map(ring => outline(ring, true))
              .join("") + opening
          : outline(points, false),
        open,
      ),
    );
  const below = shape.kind === "touch";
  const at: Point | undefined = circle
    ? [circle.at[0] + (below ? 5 : circle.r + 3), circle.at[1] + (below ? 14 : -circle.r)]
    : a && (shape.kind === "label" ? a : [a[0] + 5, a[1] - 5]);
  return {
    lines,
    captions: words && at ? [caption(words, at, shape.kind === "label" ? "middle" : "start", size)] : [],
  };
}

function written(stands: Placed | null): Drawn[] {
  if (!stands) return [];
  const { text, at, anchor, leader } = stands;
  const attributes = { x: r(at[0]), y: r(at[1]), "text-anchor": anchor, class: "caption" };
  const line = leader ? [path(outline(leader, false), { class: "leader" })] : [];
  return [...line, { tag: "text", attributes, text }];
}

/** The shapes in a drawing of this size; `values`: what was typed, by parameter. */
export function drawing(shapes: PictureShape[], values: Record<string, string>, size: Size): Drawn[] {
  const { place, scale } = placing(shapes, size);
  const sorted = [...shapes].sort((a, b) => ORDER.indexOf(a.kind) - ORDER.indexOf(b.kind));
  const figures = sorted.map(shape => {
    const shown = shape.kind === "dimension" && shape.field === shape.text;
    return { shape, ...figure(shape, place, scale, size, shown ? (values[shape.field ?? ""] ?? "").trim() : "") };
  });
  const stand = spread(
    figures.flatMap(({ captions }) => captions),
    sorted.flatMap(shape => obstacles(shape, place, scale)),
    size,
  );
  let count = 0;
  return figures.map(({ shape: { kind, field, also }, lines, captions }) => ({
    tag: "g",
    attributes: { class: `shape ${kind}`, "data-field": field, "data-also": also?.join(" ") },
    children: [...lines, ...captions.flatMap(() => written(stand[count++] ?? null))],
  }));
}
