// What is to be seen at a step, for all ways of drawing: the core's figures where they stand, in colours.

import {
  firstFrom,
  type LineGroup,
  type Piece,
  type Place,
  type SceneData,
  type Standing,
  type Tool,
  vec,
} from "../core/scene";
import type { Vec3 } from "../wire";
import type { Colours } from "./colours";
import { type Ground, groundOf } from "./ground";
import { colourOf, finishOf, LAYERS, layerOf, lineStyle, rankOf, touchStyles, wayStyles } from "./ink";
import { isWanted, type Label, labelsOf, type Say, type Wanted } from "./labels";
import { type Line, type Mesh, type Style, VERTEX_FLOATS } from "./mesh";
import { drawnAround, probeAt, standingAt, toolIndexAt } from "./motion";
import { add, type Box, boxCorners, centre, include, length, sub, times } from "./vec";

export interface Scene {
  data: SceneData;
  colours: Colours;
  mesh: Mesh; // layer by layer
  ends: number[]; // of the corners of each layer but the last
  lines: Line[];
  ground: Ground;
  section: boolean; // the part is cut open
  touched: Vec3[]; // places of touches around the step
  labels: Label[];
  tool: Tool | undefined; // in use at this step
  drawing: boolean; // diameters are shown as on a drawing
  box: Box; // what `fit` shows
  origin: Vec3; // subtracted before anything becomes single precision
  radius: number; // everything lies within it around the origin, mm
}

/** `index`: the entry around which paths are drawn. */
export interface Shown extends Partial<Wanted> {
  index?: number;
  section?: boolean;
  say?: Say;
}

export function buildScene(
  data: SceneData,
  colours: Colours,
  { index = 0, drawing = false, section = false, focus = null, say = ({ key }) => key }: Shown = {},
): Scene {
  const { view } = data;
  const wanted: Wanted = { drawing, focus };
  const { standing, place } = standingAt(data, index);
  const inUse = toolIndexAt(data, index);
  const tool = inUse === undefined ? undefined : view.tools[inUse];
  const pieces = view.pieces.filter(piece => piece.tool === undefined || piece.tool === inUse);
  const layers = LAYERS.map(layer => pieces.filter(({ matter }) => layerOf(matter) === layer));
  const groups = view.groups
    .filter(one => (one.standing ?? place) === place && isWanted(one, wanted))
    .sort((a, b) => rankOf(a.kind) - rankOf(b.kind));
  const inked = ({ kind, field }: LineGroup): Style => ({
    ...lineStyle(kind, colours, field !== undefined && field === focus),
    ...(field !== undefined && { field }),
  });
  const lines = [
    ...groups.flatMap(group => linesOf(data, group, standing, inked(group))),
    ...paths(data, index, colours),
  ];
  const box = boxOf(data, standing, tool, drawing);
  const counts = layers.map(layer => layer.reduce((sum, { corners: [from, to] }) => sum + to - from, 0));
  const { mesh, ground } = solids({
    vertices: data.vertices,
    corners: data.corners,
    pieces: layers.flat(),
    standing,
    turning: view.turning,
    colours,
  });
  return {
    data,
    colours,
    mesh,
    ends: counts.slice(0, -1).map((_, i) => counts.slice(0, i + 1).reduce((sum, count) => sum + count, 0)),
    ground,
    lines,
    touched: lines.filter(({ from, to, style }) => from === to && style.unseenBefore).map(({ from }) => from),
    labels: labelsOf(view, colours, say, wanted, drawnAround(index)),
    section,
    tool,
    drawing,
    box,
    origin: centre(box),
    radius: farthest(box, lines, data),
  };
}

/** A point or direction in the frame of a place. */
export const turned = ({ axes: [x, y, z] }: Place, [a, b, c]: Vec3): Vec3 =>
  add(add(times(x, a), times(y, b)), times(z, c));
/** A point of a piece in the machine. */
export const placed = (place: Place | undefined, point: Vec3): Vec3 =>
  place ? add(place.at, turned(place, point)) : point;

/** What stays where it is said to be. */
const FIXED: Place = {
  at: [0, 0, 0],
  axes: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
};

interface Solids extends Pick<SceneData, "vertices" | "corners"> {
  pieces: Piece[];
  standing: Standing;
  turning: boolean;
  colours: Colours;
}

/** Bit by bit: one sort of array is compared several times as fast as two. */
function equal(one: Float32Array | Uint32Array, other: Float32Array | Uint32Array): boolean {
  const [a, b] = [one, other].map(({ buffer, byteOffset, length }) => new Uint32Array(buffer, byteOffset, length));
  if (a!.length !== b!.length) return false;
  for (let index = 0; index < a!.length; index++) if (a![index] !== b![index]) return false;
  return true;
}

const sameSolids = (a: Solids, b: Solids): boolean =>
  a.colours === b.colours &&
  a.turning === b.turning &&
  JSON.stringify([a.pieces, a.standing]) === JSON.stringify([b.pieces, b.standing]) &&
  equal(a.vertices, b.vertices) &&
  equal(a.corners, b.corners);

let before: { of: Solids; mesh: Mesh; ground: Ground } | null = null;

/** The same objects as before where nothing of it is another: most keys, and each step in JOG, change lines only. */
function solids(of: Solids): { mesh: Mesh; ground: Ground } {
  if (before && sameSolids(before.of, of)) return before;
  const mesh = assemble(of);
  before = { of, mesh, ground: groundOf(mesh, of.standing, of.turning) };
  return before;
}

/** The pieces one behind the other, each where it stands and in its colour. */
function assemble({ vertices, corners, pieces, standing, colours }: Solids): Mesh {
  const count = (span: "vertices" | "corners"): number =>
    pieces.reduce((sum, { [span]: [from, to] }) => sum + to - from, 0);
  const mesh: Mesh = {
    vertices: new Float64Array(VERTEX_FLOATS * count("vertices")),
    corners: new Uint32Array(count("corners")),
  };
  let [vertex, corner] = [0, 0];
  for (const piece of pieces) {
    const [from, to] = piece.vertices;
    const [first, end] = piece.corners;
    for (let i = first; i < end; i++) mesh.corners[corner++] = corners[i]! - from + vertex;
    const place = piece.place === undefined ? undefined : standing.places[piece.place];
    // From the colour on, in the order of mesh.ts: whether it moves with the probe, and the finish behind it.
    const painted = [...colourOf(piece.matter, colours), place ? 0 : 1, finishOf(piece.matter)];
    placeVertices(mesh.vertices, vertex, vertices.subarray(6 * from, 6 * to), place ?? FIXED, painted);
    vertex += to - from;
  }
  return mesh;
}

/** Places and normals of a piece, turned and moved as its place is; number by number, since a part has thousands. */
function placeVertices(into: Float64Array, vertex: number, from: Float32Array, place: Place, painted: number[]): void {
  const [atX, atY, atZ] = place.at;
  const [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = place.axes;
  for (let i = 0, to = VERTEX_FLOATS * vertex; i < from.length; i += 6, to += VERTEX_FLOATS) {
    const [x, y, z] = [from[i]!, from[i + 1]!, from[i + 2]!];
    const [a, b, c] = [from[i + 3]!, from[i + 4]!, from[i + 5]!];
    into[to] = atX + (xx * x + yx * y + zx * z);
    into[to + 1] = atY + (xy * x + yy * y + zy * z);
    into[to + 2] = atZ + (xz * x + yz * y + zz * z);
    into[to + 3] = xx * a + yx * b + zx * c;
    into[to + 4] = xy * a + yy * b + zy * c;
    into[to + 5] = xz * a + yz * b + zz * c;
    for (let n = 0; n < painted.length; n++) into[to + 6 + n] = painted[n]!;
  }
}

function linesOf(
  { lines }: SceneData,
  { lines: [from, to], place: index }: LineGroup,
  standing: Standing,
  style: Style,
): Line[] {
  const place = index === undefined ? undefined : standing.places[index];
  return Array.from({ length: to - from }, (_, i) => {
    const [begin, end] = [vec(lines, 6 * (from + i)), vec(lines, 6 * (from + i) + 3)];
    return { from: placed(place, begin), to: placed(place, end), style };
  });
}

/**
 * Motions and touches around an entry; every line knows its entry. What matters more lies over what matters less,
 * points over all.
 */
export function paths(data: SceneData, index: number, colours: Colours): Line[] {
  const { ways, wayEntries, wayKinds, touches, touchEntries, touchSorts, view } = data;
  const [styles, marks] = [wayStyles(colours), touchStyles(colours)];
  const [first, last] = drawnAround(index);
  const lines: Line[] = [];
  for (let i = firstFrom(wayEntries, first); i < wayEntries.length && wayEntries[i]! < last; i++) {
    const during = [ways[8 * i + 6]!, ways[8 * i + 7]!] as const;
    const style: Style = { ...styles[wayKinds[i]!]!, entry: wayEntries[i]!, during };
    lines.push({ from: vec(ways, 8 * i), to: vec(ways, 8 * i + 3), style });
  }
  for (let i = firstFrom(touchEntries, first); i < touchEntries.length && touchEntries[i]! < last; i++) {
    const { normal, points } = marks[touchSorts[i]!]!;
    const [at, entry] = [vec(touches, 6 * i), touchEntries[i]!];
    const tip = add(at, times(vec(touches, 6 * i + 3), view.normal));
    lines.push({ from: at, to: tip, style: { ...normal, entry } });
    for (const point of points) lines.push({ from: at, to: at, style: { ...point, entry } });
  }
  const rank = ({ from, to, style }: Line): number => (from === to ? Infinity : style.width);
  return lines.sort((a, b) => (rank(a) === rank(b) ? 0 : rank(a) - rank(b)));
}

/**
 * With a tool where the motions begin, and with the dimensions that no field must be focused for. What carries a tool
 * may be cut off, and so may a stylus: the part is looked at.
 */
function boxOf(data: SceneData, { whole: [min, max] }: Standing, tool: Tool | undefined, drawing: boolean): Box {
  const begin = probeAt(data, 0, 0);
  const corners = tool?.extent && begin ? boxCorners({ min: tool.extent[0], max: tool.extent[1] }) : [];
  const groups = data.view.groups.filter(({ kind }) => kind === "size" || (drawing && kind === "dimension"));
  const dimensions = groups.flatMap(({ lines: [from, to] }) =>
    Array.from({ length: 2 * (to - from) }, (_, i) => vec(data.lines, 6 * from + 3 * i)),
  );
  const points = [...corners.map(corner => add(corner, begin ?? [0, 0, 0])), ...dimensions];
  return points.reduce<Box>(include, { min, max });
}

/** Of the box around the whole path. */
function pathCorners({ path }: SceneData): Vec3[] {
  return path ? boxCorners({ min: add(path.origin, path.low), max: add(path.origin, path.high) }) : [];
}

function farthest(box: Box, lines: Line[], data: SceneData): number {
  const origin = centre(box);
  const last = lines.reduce(
    (most, { from, to }) => Math.max(most, length(sub(from, origin)), length(sub(to, origin))),
    0,
  );
  const path = pathCorners(data).reduce((most, corner) => Math.max(most, length(sub(corner, origin))), last);
  return Math.max(path, length(sub(box.max, origin))) + data.view.probe.length + 20 * data.view.probe.ball;
}
