// Collects triangles and lines in the layout that web/preview/src/layout.rs describes.
import type { Vec3 } from "../wire";
import type { Rgba } from "./colours";
import { type Box, cross, dot, sub, unit } from "./vec";

export const VERTEX_FLOATS = 11;
const LINE_FLOATS = 16;

/** Triangles; both windings are allowed when adding, kept is the one whose outside is where the normals point. */
export interface Mesh {
  vertices: Float64Array; // with room for more behind the first `used` numbers
  used: number;
  corners: number[];
}
export const mesh = (): Mesh => ({ vertices: new Float64Array(512 * VERTEX_FLOATS), used: 0, corners: [] });

export interface Paint {
  colour: Rgba;
  moves?: boolean;
}

function makeRoom(into: Mesh, numbers: number): void {
  if (into.used + numbers <= into.vertices.length) return;
  const larger = new Float64Array(2 * (into.used + numbers));
  larger.set(into.vertices.subarray(0, into.used));
  into.vertices = larger;
}

function vertex(into: Mesh, at: Vec3, normal: Vec3, { colour, moves }: Paint): number {
  makeRoom(into, VERTEX_FLOATS);
  const { vertices, used } = into;
  for (let i = 0; i < 3; i++) {
    vertices[used + i] = at[i]!;
    vertices[used + 3 + i] = normal[i]!;
  }
  for (let i = 0; i < 4; i++) vertices[used + 6 + i] = colour[i]!;
  vertices[used + 10] = moves ? 1 : 0;
  into.used += VERTEX_FLOATS;
  return used / VERTEX_FLOATS;
}

/**
 * Joins three corners that are there, in the order in which their normals point outside; three in a line are nothing.
 */
function face(
  into: Mesh,
  corners: [number, number, number],
  [a, b, c]: [Vec3, Vec3, Vec3],
  facing: [Vec3, Vec3, Vec3],
): void {
  const across = cross(sub(b, a), sub(c, a));
  if (dot(across, across) === 0) return;
  const outside = dot(across, facing[0]) + dot(across, facing[1]) + dot(across, facing[2]) >= 0;
  into.corners.push(corners[0], corners[outside ? 1 : 2], corners[outside ? 2 : 1]);
}

/** A triangle with a normal at each corner. */
export function triangle(into: Mesh, points: [Vec3, Vec3, Vec3], normals: [Vec3, Vec3, Vec3], paint: Paint): void {
  const corner = (i: 0 | 1 | 2): number => vertex(into, points[i], normals[i], paint);
  face(into, [corner(0), corner(1), corner(2)], points, normals);
}

/** A quadrilateral `a b c d` (in turn) with a normal at each corner. */
export function quad(
  into: Mesh,
  points: [Vec3, Vec3, Vec3, Vec3],
  normals: [Vec3, Vec3, Vec3, Vec3],
  paint: Paint,
): void {
  const [a, b, c, d] = points;
  const [k, l, m, n] = normals;
  const [i, j, o, p] = [
    vertex(into, a, k, paint),
    vertex(into, b, l, paint),
    vertex(into, c, m, paint),
    vertex(into, d, n, paint),
  ];
  face(into, [i, j, o], [a, b, c], [k, l, m]);
  face(into, [i, o, p], [a, c, d], [k, m, n]);
}

/** Flat triangles from a point to a row of points around it, all with one normal. */
export function fan(into: Mesh, middle: Vec3, rim: Vec3[], normal: Vec3, closed: boolean, paint: Paint): void {
  const centre = vertex(into, middle, normal, paint);
  const ends = rim.map(point => vertex(into, point, normal, paint));
  for (let i = 0; i < rim.length - (closed ? 0 : 1); i++) {
    const k = (i + 1) % rim.length;
    face(into, [centre, ends[i]!, ends[k]!], [middle, rim[i]!, rim[k]!], [normal, normal, normal]);
  }
}

/** A smooth band between two rows of as many points: a corner and its normal serve all faces around them. */
export function band(
  into: Mesh,
  upper: Vec3[],
  lower: Vec3[],
  normals: { upper: Vec3[]; lower: Vec3[] },
  closed: boolean,
  paint: Paint,
): void {
  const above = upper.map((point, i) => vertex(into, point, normals.upper[i]!, paint));
  const below = lower.map((point, i) => vertex(into, point, normals.lower[i]!, paint));
  for (let i = 0; i < upper.length - (closed ? 0 : 1); i++) {
    const k = (i + 1) % upper.length;
    face(
      into,
      [above[i]!, above[k]!, below[k]!],
      [upper[i]!, upper[k]!, lower[k]!],
      [normals.upper[i]!, normals.upper[k]!, normals.lower[k]!],
    );
    face(
      into,
      [above[i]!, below[k]!, below[i]!],
      [upper[i]!, lower[k]!, lower[i]!],
      [normals.upper[i]!, normals.lower[k]!, normals.lower[i]!],
    );
  }
}

/** A flat quadrilateral; `outside` says roughly where its outside is. */
export function flat(into: Mesh, points: [Vec3, Vec3, Vec3, Vec3], outside: Vec3, paint: Paint): void {
  const [a, b, c, d] = points;
  const face = unit(cross(sub(c, a), sub(d, b)));
  const normal: Vec3 = dot(face, outside) < 0 ? [-face[0], -face[1], -face[2]] : face;
  quad(into, points, [normal, normal, normal, normal], paint);
}

/** Takes `other` in behind what is there. */
export function append(into: Mesh, other: Mesh): void {
  const first = into.used / VERTEX_FLOATS;
  makeRoom(into, other.used);
  into.vertices.set(other.vertices.subarray(0, other.used), into.used);
  into.used += other.used;
  for (const corner of other.corners) into.corners.push(first + corner);
}

/** Smallest box around all corners, or those in a part of the numbers; null: there are none. */
export function boxOf({ vertices, used }: Mesh, from = 0, to = used): Box | null {
  if (to <= from) return null;
  const box: Box = { min: [Infinity, Infinity, Infinity], max: [-Infinity, -Infinity, -Infinity] };
  for (let i = from; i < to; i += VERTEX_FLOATS) {
    for (let axis = 0; axis < 3; axis++) {
      const value = vertices[i + axis]!;
      if (value < box.min[axis]!) box.min[axis] = value;
      if (value > box.max[axis]!) box.max[axis] = value;
    }
  }
  return box;
}

/** How a line looks and when it is there. */
export interface Style {
  colour: Rgba;
  width: number; // CSS pixels
  dash?: number; // period in CSS pixels
  entry?: number; // place in the trace; absent: always there
  during?: readonly [number, number]; // between which parts of its entry it is travelled; absent: the whole of it
  unseenBefore?: boolean; // else faint
  through?: number; // opacity behind a part
}
export interface Line {
  from: Vec3;
  to: Vec3;
  style: Style;
}

/** Lines as the renderer wants them: lengths on the screen in device pixels, positions relative to `origin`. */
export function packLines(lines: Line[], origin: Vec3, ratio: number): Float32Array {
  const packed = new Float32Array(lines.length * LINE_FLOATS);
  lines.forEach(({ from, to, style }, i) => {
    const {
      colour,
      width,
      dash = 0,
      entry = -1,
      during: [begin, end] = [0, 1],
      unseenBefore = false,
      through = 0,
    } = style;
    const numbers = [
      ...sub(from, origin),
      ...sub(to, origin),
      ...colour,
      width * ratio,
      dash * ratio,
      entry + begin,
      unseenBefore ? 1 : 0,
      through,
      end - begin,
    ];
    packed.set(numbers, i * LINE_FLOATS);
  });
  return packed;
}

/** Vertices relative to `origin`; those that move with the probe are relative to it already. */
export function packVertices({ vertices, used }: Mesh, origin: Vec3): Float32Array {
  const packed = new Float32Array(vertices.subarray(0, used));
  for (let i = 0; i < packed.length; i += VERTEX_FLOATS) {
    if (vertices[i + VERTEX_FLOATS - 1] === 1) continue;
    for (let axis = 0; axis < 3; axis++) packed[i + axis] = vertices[i + axis]! - origin[axis]!;
  }
  return packed;
}
