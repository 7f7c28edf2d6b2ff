// The 3D view without a GPU: the same scene and camera, drawn as SVG from the farthest piece to the nearest.
import type { Vec3 } from "../wire";
import { COMING, type Backend, type Frame } from "./backend";
import { basis, projector, type Projected } from "./camera";
import { css, type Rgba } from "./colours";
import { shader } from "./light";
import { VERTEX_FLOATS, type Line, type Mesh } from "./mesh";
import type { Scene } from "./scene";
import { add, cross, dot, mix, sub } from "./vec";

const SVG = "http://www.w3.org/2000/svg";
const PIECE = 14;      // CSS pixels: lines are cut into pieces so that each finds its place among the triangles
const NEARER = 0.002;  // lines on a face are in front of it, the wider the more; share of the radius a pixel of width

interface Shape { near: number; svg: string }

export function openSvg(host: HTMLElement): Backend {
  const element = document.createElementNS(SVG, "svg");
  host.prepend(element);
  let scene: Scene | null = null;
  return {
    name: "svg",
    element,
    setScene(next) { scene = next; },
    draw(frame) { if (scene) paint(element, scene, frame); },
    destroy() { element.remove(); },
  };
}

function paint(element: SVGSVGElement, scene: Scene, frame: Frame): void {
  const { width, height } = frame.view;
  element.setAttribute("viewBox", `0 0 ${width} ${height}`);
  const solid = faces(scene, frame, 0, scene.solidCorners);
  const clear = faces(scene, frame, scene.solidCorners, scene.mesh.corners.length);
  const lines = scene.lines.slice(scene.gridLines).flatMap((line) => strokes(line, scene, frame));
  const grid = scene.lines.slice(0, scene.gridLines).flatMap((line) => strokes(line, scene, frame, Infinity)).map((shape) => shape.svg).join("");
  const below = frame.camera.pitch >= 0;
  const order = (shapes: Shape[]) => shapes.sort((a, b) => a.near - b.near).map((shape) => shape.svg).join("");
  const behind = scene.lines.map((line) => seenThrough(line, frame)).join("");
  const ground = `<rect width="${width}" height="${height}" fill="${scene.colours.background}"/>`;
  element.innerHTML = ground + (below ? grid : "") + order([...solid, ...lines]) + behind + order(clear) + (below ? "" : grid);
}

const round = (value: number) => Math.round(value * 100) / 100;

function faces(scene: Scene, frame: Frame, from: number, to: number): Shape[] {
  const project = projector(frame.camera, frame.view);
  const directions = basis(frame.camera);
  const lit = shader(directions);
  const shapes: Shape[] = [];
  for (let i = from; i < to; i += 3) {
    const corners = scene.mesh.corners.slice(i, i + 3);
    const points = corners.map((corner) => position(scene.mesh, corner, frame.probe)) as [Vec3, Vec3, Vec3];
    const outside = cross(sub(points[1], points[0]), sub(points[2], points[0]));
    if (dot(outside, directions.back) <= 0) continue;
    const normal = corners.reduce((sum, corner) => add(sum, read(scene.mesh, corner, 3)), [0, 0, 0] as Vec3);
    const length = Math.hypot(...normal) || 1;
    const colour = lit([normal[0] / length, normal[1] / length, normal[2] / length], paintOf(scene.mesh, corners[0]!));
    const seen = points.map(project);
    shapes.push({ near: (seen[0]!.near + seen[1]!.near + seen[2]!.near) / 3, svg: polygon(seen, colour) });
  }
  return shapes;
}

/** A thin border of the same colour closes the seams between neighbours. */
function polygon(points: Projected[], colour: Rgba): string {
  const path = points.map(({ x, y }) => `${round(x)} ${round(y)}`).join("L");
  const seam = colour[3] === 1 ? ` stroke="${css(colour)}" stroke-width=".7" stroke-linejoin="round"` : "";
  return `<path d="M${path}Z" fill="${css(colour)}"${seam}/>`;
}

function read({ vertices }: Mesh, corner: number, offset: number): Vec3 {
  const first = corner * VERTEX_FLOATS + offset;
  return [vertices[first]!, vertices[first + 1]!, vertices[first + 2]!];
}

function position(mesh: Mesh, corner: number, probe: Vec3 | null): Vec3 {
  const at = read(mesh, corner, 0);
  const moves = mesh.vertices[corner * VERTEX_FLOATS + 10] === 1;
  return moves && probe ? add(at, probe) : at;
}

const paintOf = ({ vertices }: Mesh, corner: number) =>
  vertices.slice(corner * VERTEX_FLOATS + 6, corner * VERTEX_FLOATS + 10) as Rgba;

/** The part of a line that is there at a time, each with its opacity: travelled, still to come. */
function spans({ from, to, style }: Line, time: number): { from: Vec3; to: Vec3; opacity: number }[] {
  const { entry = -1, unseenBefore } = style;
  const done = entry < 0 ? 1 : Math.min(1, Math.max(0, time - entry));
  const middle = mix(from, to, done);
  const later = unseenBefore ? 0 : COMING;
  const all = [{ from, to: middle, opacity: done > 0 ? 1 : 0 }, { from: middle, to, opacity: done < 1 ? later : 0 }];
  return all.filter((span) => span.opacity > 0);
}

function strokes(line: Line, scene: Scene, frame: Frame, piece = PIECE): Shape[] {
  const project = projector(frame.camera, frame.view);
  return spans(line, frame.time).flatMap(({ from, to, opacity }) => {
    const [a, b] = [project(from), project(to)];
    const length = Math.hypot(b.x - a.x, b.y - a.y);
    const count = Math.max(1, Math.min(200, Math.ceil(length / piece)));
    return Array.from({ length: count }, (_, i): Shape => {
      const [p, q] = [project(mix(from, to, i / count)), project(mix(from, to, (i + 1) / count))];
      const near = (p.near + q.near) / 2 + NEARER * line.style.width * scene.radius;
      return { near, svg: stroke(p, q, line, opacity, (length * i) / count) };
    });
  });
}

/** What shows through parts: the whole line once more, faint; over what is in sight it changes nothing. */
function seenThrough(line: Line, frame: Frame): string {
  const { through = 0 } = line.style;
  if (through === 0) return "";
  const project = projector(frame.camera, frame.view);
  return spans(line, frame.time).map(({ from, to, opacity }) => stroke(project(from), project(to), line, opacity * through, 0)).join("");
}

function stroke(a: Projected, b: Projected, { style }: Line, opacity: number, along: number): string {
  const [r, g, bl, alpha] = style.colour;
  const colour = css([r, g, bl, alpha * opacity]);
  const point = Math.hypot(b.x - a.x, b.y - a.y) < 0.01;
  if (point) return `<circle cx="${round(a.x)}" cy="${round(a.y)}" r="${style.width / 2}" fill="${colour}"/>`;
  const dash = style.dash ? ` stroke-dasharray="${0.6 * style.dash} ${0.4 * style.dash}" stroke-dashoffset="${round(along)}"` : "";
  const cap = style.dash || opacity < 1 ? "butt" : "round";
  return `<path d="M${round(a.x)} ${round(a.y)}L${round(b.x)} ${round(b.y)}" stroke="${colour}" stroke-width="${style.width}" stroke-linecap="${cap}"${dash} fill="none"/>`;
}
