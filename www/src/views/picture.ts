// The help picture: plain figures from the core, drawn as SVG. What belongs to the focused field stands out.

import { setAttribute, show, svg } from "../dom";
import { t } from "../texts";
import type { Picture, PictureShape } from "../wire";

const WIDTH = 400, HEIGHT = 230, MARGIN = 34;
/** From the ground up: what is filled must not hide what is drawn in lines. */
const ORDER: PictureShape["kind"][] = ["material", "tolerance", "axis", "zone", "path", "edge", "probe", "touch", "dimension", "label"];
type Point = [number, number];
type Place = (point: Point) => Point;

function extent(shapes: PictureShape[]): { low: Point; high: Point } {
  const all = shapes.flatMap((shape): Point[] => shape.circle
    ? [[shape.circle.x - shape.circle.r, shape.circle.y - shape.circle.r], [shape.circle.x + shape.circle.r, shape.circle.y + shape.circle.r], ...shape.points]
    : shape.points);
  if (all.length === 0) return { low: [-1, -1], high: [1, 1] };
  return {
    low: [Math.min(...all.map((p) => p[0])), Math.min(...all.map((p) => p[1]))],
    high: [Math.max(...all.map((p) => p[0])), Math.max(...all.map((p) => p[1]))],
  };
}

/** Millimetres to picture points, y up. */
function placing(shapes: PictureShape[]): { place: Place; scale: number } {
  const { low, high } = extent(shapes);
  const scale = Math.min((WIDTH - 2 * MARGIN) / Math.max(high[0] - low[0], 1e-9), (HEIGHT - 2 * MARGIN) / Math.max(high[1] - low[1], 1e-9));
  const middle: Point = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
  return { scale, place: ([x, y]) => [WIDTH / 2 + (x - middle[0]) * scale, HEIGHT / 2 - (y - middle[1]) * scale] };
}

const r = (value: number): string => value.toFixed(2);

function outline(points: Point[], closed: boolean): string {
  return points.map(([x, y], index) => `${index ? "L" : "M"}${r(x)} ${r(y)}`).join("") + (closed ? "Z" : "");
}

function caption(text: string, at: Point, anchor: string): SVGElement {
  return svg("text", { x: r(at[0]), y: r(at[1]), "text-anchor": anchor, class: "caption" }, text);
}

function dimension(a: Point, b: Point, text: string | undefined): SVGElement[] {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
  const along: Point = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
  const head = (tip: Point, way: number): SVGElement => {
    const size = Math.min(7, length / 3);
    const back: Point = [tip[0] + along[0] * size * way, tip[1] + along[1] * size * way];
    const side: Point = [-along[1] * size * 0.35, along[0] * size * 0.35];
    return svg("path", { d: outline([tip, [back[0] + side[0], back[1] + side[1]], [back[0] - side[0], back[1] - side[1]]], true), class: "arrow" });
  };
  const middle: Point = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  const upright = Math.abs(along[1]) > 0.7;
  const parts: SVGElement[] = [svg("path", { d: outline([a, b], false) }), head(a, 1), head(b, -1)];
  if (text) parts.push(caption(text, [middle[0] + (upright ? 5 : 0), middle[1] - (upright ? -4 : 5)], upright ? "start" : "middle"));
  return parts;
}

function figures(shape: PictureShape, place: Place, scale: number): SVGElement[] {
  const points = shape.points.map(place);
  const [a, b] = points;
  if (shape.kind === "dimension" && a && b) return dimension(a, b, shape.text);
  const parts: SVGElement[] = [];
  if (shape.circle) {
    const [x, y] = place([shape.circle.x, shape.circle.y]);
    parts.push(svg("circle", { cx: r(x), cy: r(y), r: r(Math.max(shape.circle.r * scale, 1.5)) }));
  }
  if (shape.kind === "touch" && !shape.circle) for (const [x, y] of points) parts.push(svg("path", { d: `M${r(x - 4)} ${r(y)}h8M${r(x)} ${r(y - 4)}v8` }));
  else if (points.length > 1) parts.push(svg("path", { d: outline(points, !!shape.closed) }));
  if (shape.text && a) parts.push(caption(shape.text, shape.kind === "label" ? a : [a[0] + 5, a[1] - 5], shape.kind === "label" ? "middle" : "start"));
  return parts;
}

export function createPicture(root: HTMLElement, pick: (field: string) => void): (picture: Picture, focus: string | null) => void {
  const drawing = svg("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", class: "picture" });
  root.append(drawing);
  let drawn: Picture | null = null;
  drawing.addEventListener("click", (event) => {
    const field = (event.target as Element).closest("[data-field]")?.getAttribute("data-field");
    if (field) pick(field);
  });
  const draw = (picture: Picture): void => {
    drawn = picture;
    const { place, scale } = placing(picture.shapes);
    const shapes = [...picture.shapes].sort((a, b) => ORDER.indexOf(a.kind) - ORDER.indexOf(b.kind));
    drawing.replaceChildren(...shapes.map((shape) =>
      svg("g", { class: `shape ${shape.kind}`, "data-field": shape.field }, ...figures(shape, place, scale))));
  };
  return (picture, focus) => {
    if (picture !== drawn) draw(picture);
    show(root, picture.shapes.length > 0);
    setAttribute(drawing, "aria-label", t(`picture-${picture.view}`));
    let lit = false;
    for (const shape of drawing.children) {
      const match = focus !== null && shape.getAttribute("data-field") === focus;
      shape.classList.toggle("lit", match);
      lit ||= match;
    }
    drawing.classList.toggle("has-lit", lit);
  };
}
