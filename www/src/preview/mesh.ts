// Triangles and lines in the layout that web/preview/src/layout.rs describes.
import type { Vec3 } from "../wire";
import type { Rgba } from "./colours";

export const VERTEX_FLOATS = 12;
export const OPACITY = 9; // place of the last of the four numbers of its colour
export const MOVES = 10; // place of the number that tells whether a vertex moves with the probe
export const FINISH = 11; // place of its finish
const LINE_FLOATS = 16;

/** Vertices with their colours, in machine coordinates unless they move with the probe; three corners a triangle. */
export interface Mesh {
  vertices: Float64Array;
  corners: Uint32Array;
}

/** How a line looks and when it is there. */
export interface Style {
  colour: Rgba;
  width: number; // CSS pixels
  dash?: number; // period in CSS pixels
  entry?: number; // place in the trace; absent: always there
  field?: string; // parameter that it explains
  during?: readonly [number, number]; // between which parts of its entry it is travelled; absent: the whole of it
  unseenBefore?: boolean; // else faint
  tube?: boolean; // drawn as one
  cut?: boolean; // cut away with the part
  onGround?: boolean; // of the grid, which a device draws with the ground
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
      tube = false,
      cut = false,
      through = 0,
    } = style;
    const at = i * LINE_FLOATS;
    for (let axis = 0; axis < 3; axis++) {
      packed[at + axis] = from[axis]! - origin[axis]!;
      packed[at + 3 + axis] = to[axis]! - origin[axis]!;
    }
    packed.set(colour, at + 6);
    packed[at + 10] = width * ratio;
    packed[at + 11] = dash * ratio;
    packed[at + 12] = entry + begin;
    packed[at + 13] = (unseenBefore ? 1 : 0) + (tube ? 2 : 0) + (cut ? 4 : 0);
    packed[at + 14] = through;
    packed[at + 15] = end - begin;
  });
  return packed;
}

/** Vertices relative to `origin`; those that move with the probe are relative to it already. */
export function packVertices({ vertices }: Mesh, [x, y, z]: Vec3): Float32Array {
  const packed = new Float32Array(vertices);
  for (let i = 0; i < packed.length; i += VERTEX_FLOATS) {
    if (vertices[i + MOVES] === 1) continue;
    packed[i] = vertices[i]! - x;
    packed[i + 1] = vertices[i + 1]! - y;
    packed[i + 2] = vertices[i + 2]! - z;
  }
  return packed;
}
