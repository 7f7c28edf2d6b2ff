// The 3D view without a GPU: the same scene and camera as SVG. Faces from the farthest to the nearest, then the lines,
// which are fainter where they lie behind a face.

import { LEVELS, levelFor, motionsIn, type Path } from "../core/levels";
import { svg } from "../dom";
import { type Drawn, drawInto } from "../draw";
import type { Vec3 } from "../wire";
import { type Backend, type Cloud, COMING, dotSize, type Frame, type Hooks } from "./backend";
import { basis, type Projected, projector } from "./camera";
import { css, parse, type Rgba } from "./colours";
import { cover, type Depth, emptyDepth, hidden } from "./depth";
import { fadedFor } from "./fade";
import { Finish, trailColours } from "./ink";
import { shader } from "./light";
import { FINISH, type Line, type Mesh, MOVES, VERTEX_FLOATS } from "./mesh";
import type { Scene } from "./scene";
import { isCut, sectionOf } from "./section";
import { add, mix, times, unit } from "./vec";

const PIECE = 5; // CSS pixels between two looks at whether a line is hidden
const PIECES = 400; // at most so many looks a line
const SLACK = 0.004; // a line on a face is before it; share of the radius of the scene

export function openSvg(host: HTMLElement, { thinned, trailed }: Pick<Hooks, "thinned" | "trailed">): Backend {
  const element = svg("svg");
  host.prepend(element);
  let scene: Scene | null = null;
  let cloud: Cloud | null = null;
  return {
    name: "svg",
    element,
    busy: false,
    setScene(next) {
      scene = next;
      if (next.data.path) trailed(trailOf(next.data.path).motions);
    },
    setCloud(next) {
      cloud = next;
      if (next) thinned(drawnOf(next));
    },
    draw(frame) {
      if (scene) paint(element, scene, cloud, frame);
    },
    destroy() {
      element.remove();
    },
  };
}

function paint(element: SVGSVGElement, scene: Scene, cloud: Cloud | null, frame: Frame): void {
  const { width, height } = frame.view;
  const depth = emptyDepth(frame.view);
  const faded = fadedFor(scene, frame);
  const [end, stands, moves] = scene.ends as [number, number, number];
  const layer = (from: number, to: number, bit: number) => ({
    found: faces(scene, frame, from, to),
    fades: faded & bit,
  });
  const fading = [layer(end, stands, 1), layer(stands, moves, 2)];
  const solid = [faces(scene, frame, 0, end), ...fading.filter(({ fades }) => !fades).map(({ found }) => found)]
    .flat()
    .sort((a, b) => a.near - b.near);
  for (const { points } of solid) cover(depth, points);
  const through = fading.filter(({ fades }) => fades).flatMap(({ found }) => found.map(faint));
  const clear = [...through, ...faces(scene, frame, moves, scene.mesh.corners.length)];
  const lines = scene.lines.flatMap(line => strokes(line, scene, frame, depth));
  element.setAttribute("viewBox", `0 0 ${width} ${height}`);
  const ground: Drawn = { tag: "rect", attributes: { width, height, fill: scene.colours.background } };
  drawInto(element, [
    ground,
    ...solid.map(polygon),
    ...trail(scene, frame, depth),
    ...(cloud ? dots(cloud, scene, frame, depth) : []),
    ...lines,
    ...clear.map(polygon),
  ]);
}

const DOTS = 4096; // scanned points that are drawn at most

/** How many points of a cloud are drawn: its first ones. */
const drawnOf = ({ points }: Cloud): number => Math.min(DOTS, points.length / 4);

/** Scanned points that no face hides, coloured by their deviation. */
function dots(cloud: Cloud, scene: Scene, frame: Frame, depth: Depth): Drawn[] {
  const { points, origin, full } = cloud;
  const count = drawnOf(cloud);
  const r = dotSize(count) / 2;
  const project = projector(frame.camera, frame.view);
  const [outside, level, inside] = [
    parse(scene.colours.outside),
    parse(scene.colours.level),
    parse(scene.colours.inside),
  ];
  const found: Drawn[] = [];
  for (let i = 0; i < 4 * count; i += 4) {
    const at = project([origin[0] + points[i]!, origin[1] + points[i + 1]!, origin[2] + points[i + 2]!]);
    if (hidden(depth, at, SLACK * scene.radius)) continue;
    const share = Math.max(-1, Math.min(1, points[i + 3]! / full));
    const end = share < 0 ? inside : outside;
    const fill = css(level.map((value, part) => value + (end[part]! - value) * Math.abs(share)) as Rgba);
    found.push({ tag: "circle", attributes: { cx: round(at.x), cy: round(at.y), r, fill } });
  }
  return found;
}

const TRAIL = 4096; // motions of the whole path that are drawn at most

/** The level of the whole path that is drawn, and how many motions it has. */
function trailOf(path: Path): { chunks: [number, number][]; level: number; motions: number } {
  const chunks = path.parts.flatMap(({ starts }, part) =>
    Array.from({ length: starts.length - 1 }, (_, chunk): [number, number] => [part, chunk]),
  );
  const level = levelFor(path, chunks, TRAIL);
  const motions = chunks.reduce((sum, [part, chunk]) => sum + path.parts[part]!.counts[chunk * LEVELS + level]!, 0);
  return { chunks, level, motions };
}

/** What no face hides of the whole path: a stroke for each kind of motion, travelled or still to come. */
function trail({ data: { path }, colours, radius }: Scene, frame: Frame, depth: Depth): Drawn[] {
  if (!path) return [];
  const project = projector(frame.camera, frame.view);
  const strokes = new Map<string, string[]>();
  const { chunks, level } = trailOf(path);
  for (const [from, to, { kind, done }] of motionsIn(path, chunks, level)) {
    const [a, b] = [project(add(path.origin, from)), project(add(path.origin, to))];
    const middle = { ...a, x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, near: (a.near + b.near) / 2 };
    if (hidden(depth, middle, SLACK * radius)) continue;
    const [red, green, blue] = trailColours(colours)[kind]!;
    const colour = css([red, green, blue, done <= frame.time ? 1 : COMING]);
    const found = strokes.get(colour) ?? [];
    found.push(`M${round(a.x)} ${round(a.y)}L${round(b.x)} ${round(b.y)}`);
    strokes.set(colour, found);
  }
  return [...strokes].map(([stroke, pieces]) => ({
    tag: "path",
    attributes: { d: pieces.join(""), stroke, "stroke-width": 1, fill: "none" },
  }));
}

const round = (value: number) => Math.round(value * 100) / 100;

// Faces

interface Face {
  near: number;
  points: [Projected, Projected, Projected];
  colour: Rgba;
}

/** Faces turned towards the viewer, the farthest first. */
function faces(scene: Scene, frame: Frame, from: number, to: number): Face[] {
  const project = projector(frame.camera, frame.view);
  const directions = basis(frame.camera);
  const lit = shader(directions);
  const plane = sectionOf(scene, frame.camera);
  const cut = parse(scene.colours.cut);
  const found: Face[] = [];
  for (let i = from; i < to; i += 3) {
    const corners = [...scene.mesh.corners.subarray(i, i + 3)];
    const at = corners.map(corner => position(scene.mesh, corner, frame.probe)) as [Vec3, Vec3, Vec3];
    const points = at.map(project) as [Projected, Projected, Projected];
    const [a, b, c] = points;
    const finish = scene.mesh.vertices[corners[0]! * VERTEX_FLOATS + FINISH];
    const opened = plane && finish === Finish.part;
    if (opened && isCut(plane, times(at.reduce(add), 1 / 3))) continue;
    const near = (a.near + b.near + c.near) / 3;
    if ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y) >= 0) {
      if (opened) found.push({ near, points, colour: cut });
      continue;
    }
    const normal = unit(corners.map(corner => read(scene.mesh, corner, 3)).reduce(add));
    found.push({ near, points, colour: lit(normal, paintOf(scene.mesh, corners[0]!), finish) });
  }
  return found.sort((a, b) => a.near - b.near);
}

const faint = (face: Face): Face => ({ ...face, colour: [face.colour[0], face.colour[1], face.colour[2], 0.3] });

/** A thin border of the same colour closes the seams between neighbours. */
function polygon({ points, colour }: Face): Drawn {
  const path = points.map(({ x, y }) => `${round(x)} ${round(y)}`).join("L");
  const fill = css(colour);
  const border =
    colour[3] === 1
      ? { stroke: fill, "stroke-width": 0.8, "stroke-linejoin": "round" }
      : { "shape-rendering": "crispEdges" };
  return { tag: "path", attributes: { d: `M${path}Z`, fill, ...border } };
}

function read({ vertices }: Mesh, corner: number, offset: number): Vec3 {
  const first = corner * VERTEX_FLOATS + offset;
  return [vertices[first]!, vertices[first + 1]!, vertices[first + 2]!];
}

function position(mesh: Mesh, corner: number, probe: Vec3 | null): Vec3 {
  const at = read(mesh, corner, 0);
  const moves = mesh.vertices[corner * VERTEX_FLOATS + MOVES] === 1;
  return moves && probe ? add(at, probe) : at;
}

const paintOf = ({ vertices }: Mesh, corner: number) =>
  [...vertices.subarray(corner * VERTEX_FLOATS + 6, corner * VERTEX_FLOATS + 10)] as Rgba;

// Lines

/** The part of a line that is there at a time, each with its opacity: travelled, still to come. */
function spans({ from, to, style }: Line, time: number): { from: Vec3; to: Vec3; opacity: number }[] {
  const { entry = -1, during: [begin, end] = [0, 1], unseenBefore } = style;
  const done = entry < 0 ? 1 : Math.min(1, Math.max(0, (time - entry - begin) / (end - begin)));
  const middle = mix(from, to, done);
  const later = unseenBefore ? 0 : COMING;
  const all = [
    { from, to: middle, opacity: done > 0 ? 1 : 0 },
    { from: middle, to, opacity: done < 1 ? later : 0 },
  ];
  return all.filter(span => span.opacity > 0);
}

function strokes(line: Line, scene: Scene, frame: Frame, depth: Depth): Drawn[] {
  const project = projector(frame.camera, frame.view);
  const slack = SLACK * scene.radius;
  const plane = line.style.cut ? sectionOf(scene, frame.camera) : null;
  if (isCut(plane, mix(line.from, line.to, 0.5))) return [];
  return spans(line, frame.time).flatMap(({ from, to, opacity }) => {
    const [a, b] = [project(from), project(to)];
    const length = Math.hypot(b.x - a.x, b.y - a.y);
    const between = (t: number): Projected => ({
      ...a,
      x: a.x + t * (b.x - a.x),
      y: a.y + t * (b.y - a.y),
      near: a.near + t * (b.near - a.near),
    });
    return runs(length, t => hidden(depth, between(t), slack)).flatMap(run =>
      stroke(
        between(run.from),
        between(run.to),
        line,
        opacity * (run.hidden ? (line.style.through ?? 0) : 1),
        run.from * length,
      ),
    );
  });
}

/** Neighbouring pieces (shares of the line, 0 … 1) that are all hidden or all seen. */
function runs(length: number, isHidden: (t: number) => boolean): { from: number; to: number; hidden: boolean }[] {
  const count = Math.max(1, Math.min(PIECES, Math.ceil(length / PIECE)));
  const found: { from: number; to: number; hidden: boolean }[] = [];
  for (let i = 0; i < count; i++) {
    const now = isHidden((i + 0.5) / count);
    const last = found.at(-1);
    if (last?.hidden === now) last.to = (i + 1) / count;
    else found.push({ from: i / count, to: (i + 1) / count, hidden: now });
  }
  return found;
}

function stroke(a: Projected, b: Projected, { style }: Line, opacity: number, along: number): Drawn[] {
  if (opacity === 0) return [];
  const [red, green, blue, alpha] = style.colour;
  const colour = css([red, green, blue, alpha * opacity]);
  const point = Math.hypot(b.x - a.x, b.y - a.y) < 0.01;
  if (point)
    return [{ tag: "circle", attributes: { cx: round(a.x), cy: round(a.y), r: style.width / 2, fill: colour } }];
  const dash = style.dash
    ? { "stroke-dasharray": `${0.6 * style.dash} ${0.4 * style.dash}`, "stroke-dashoffset": round(along) }
    : {};
  const cap = style.dash || opacity < 1 ? "butt" : "round";
  const d = `M${round(a.x)} ${round(a.y)}L${round(b.x)} ${round(b.y)}`;
  return [
    {
      tag: "path",
      attributes: { d, stroke: colour, "stroke-width": style.width, "stroke-linecap": cap, ...dash, fill: "none" },
    },
  ];
}
