// Collects triangles and lines in the layout that web/preview/src/layout.rs describes.
import type { Vec3 } from "../wire";
import type { Rgba } from "./colours";
import { cross, dot, sub, unit, type Box } from "./vec";

export const VERTEX_FLOATS = 11;
export const LINE_FLOATS = 15;

/** Triangles; both windings are allowed when adding, kept is the one whose outside is where the normals point. */
export interface Mesh { vertices: number[]; corners: number[] }
export const mesh = (): Mesh => ({ vertices: [], corners: [] });

export interface Paint { colour: Rgba; moves?: boolean }

function vertex({ vertices }: Mesh, at: Vec3, normal: Vec3, { colour, moves }: Paint): number {
  vertices.push(at[0], at[1], at[2], normal[0], normal[1], normal[2], colour[0], colour[1], colour[2], colour[3], moves ? 1 : 0);
  return vertices.length / VERTEX_FLOATS - 1;
}

/** A triangle with a normal at each corner. */
export function triangle(into: Mesh, points: [Vec3, Vec3, Vec3], normals: [Vec3, Vec3, Vec3], paint: Paint): void {
  const [a, b, c] = points;
  const face = cross(sub(b, a), sub(c, a));
  if (dot(face, face) === 0) return;
  const outside = dot(face, normals[0]) + dot(face, normals[1]) + dot(face, normals[2]) >= 0;
  const [i, j, k] = [vertex(into, a, normals[0], paint), vertex(into, b, normals[1], paint), vertex(into, c, normals[2], paint)];
  into.corners.push(i, outside ? j : k, outside ? k : j);
}

/** A quadrilateral `a b c d` (in turn) with a normal at each corner. */
export function quad(into: Mesh, points: [Vec3, Vec3, Vec3, Vec3], normals: [Vec3, Vec3, Vec3, Vec3], paint: Paint): void {
  const [a, b, c, d] = points;
  const [k, l, m, n] = normals;
  triangle(into, [a, b, c], [k, l, m], paint);
  triangle(into, [a, c, d], [k, m, n], paint);
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
  const first = into.vertices.length / VERTEX_FLOATS;
  for (const value of other.vertices) into.vertices.push(value);
  for (const corner of other.corners) into.corners.push(first + corner);
}

/** Smallest box around all corners; null: there are none. */
export function boxOf({ vertices }: Mesh): Box | null {
  if (vertices.length === 0) return null;
  const box: Box = { min: [Infinity, Infinity, Infinity], max: [-Infinity, -Infinity, -Infinity] };
  for (let i = 0; i < vertices.length; i += VERTEX_FLOATS) {
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
  width: number;          // CSS pixels
  dash?: number;          // period in CSS pixels
  entry?: number;         // place in the trace; absent: always there
  unseenBefore?: boolean; // else faint
  through?: number;       // opacity behind a part
}
export interface Line { from: Vec3; to: Vec3; style: Style }

/** Lines as the renderer wants them: lengths on the screen in device pixels, positions relative to `origin`. */
export function packLines(lines: Line[], origin: Vec3, ratio: number): Float32Array {
  const packed = new Float32Array(lines.length * LINE_FLOATS);
  lines.forEach(({ from, to, style }, i) => {
    const { colour, width, dash = 0, entry = -1, unseenBefore = false, through = 0 } = style;
    const numbers = [...sub(from, origin), ...sub(to, origin), ...colour, width * ratio, dash * ratio, entry, unseenBefore ? 1 : 0, through];
    packed.set(numbers, i * LINE_FLOATS);
  });
  return packed;
}

/** Vertices relative to `origin`; those that move with the probe are relative to it already. */
export function packVertices({ vertices }: Mesh, origin: Vec3): Float32Array {
  const packed = Float32Array.from(vertices);
  for (let i = 0; i < packed.length; i += VERTEX_FLOATS) {
    if (vertices[i + VERTEX_FLOATS - 1] === 1) continue;
    for (let axis = 0; axis < 3; axis++) packed[i + axis] = vertices[i + axis]! - origin[axis]!;
  }
  return packed;
}
