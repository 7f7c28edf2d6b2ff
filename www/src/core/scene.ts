// What the core says is to be seen: flat arrays, and what they hold (core/src/scene). Copied out of the module's
// memory, which the next call into it may move; so they can also cross from a worker.
import type { Vec3 } from "../wire";

/** Pieces of the triangles: what they are. */
export type Matter = "part" | "cut" | "chuck" | "ball" | "stylus" | "body" | "carrier" | "zone";
export type LineKind =
  | "grid"
  | "edge"
  | "zone"
  | "limit"
  | "axisX"
  | "axisY"
  | "axisZ"
  | "beforeX"
  | "beforeY"
  | "beforeZ"
  | "dimension";
type Span = [from: number, to: number]; // `to` excluded

/**
 * `place`: where it stands, by index in a standing's places; absent: from the position of the machine on. `tool`: with
 * which tool it is there; absent: always.
 */
export interface Piece {
  matter: Matter;
  corners: Span;
  vertices: Span;
  place?: number;
  tool?: number;
}
/** `place` absent: machine coordinates; `standing`: in which it is there, absent: in all. */
export interface LineGroup {
  kind: LineKind;
  lines: Span;
  place?: number;
  standing?: number;
}
export interface Place {
  at: Vec3;
  axes: [Vec3, Vec3, Vec3];
}
/** How everything stands once `entry` is done; `whole`: what is to be seen whole without the tool. */
export interface Standing {
  entry: number;
  places: Place[];
  whole: [Vec3, Vec3];
}
/**
 * `ball`: direction from it to what holds it, absent: no probe; `tip`, `extent`: from the position of the machine on.
 */
export interface Tool {
  ball?: Vec3;
  tip: Vec3;
  extent?: [Vec3, Vec3];
  carried: boolean;
}
/** A coordinate system, by the name of its zero offset; `moved`: by a correction. */
export interface Frame {
  name: string;
  at: Vec3;
  axes: [Vec3, Vec3, Vec3];
  moved?: "before" | "after";
}
/**
 * `alarm`: its code, where the probe was watched; `crash`: nobody watched, or no signal came. Else a measurement went
 * on.
 */
export interface Collision {
  entry: number;
  at: Vec3;
  by: "ball" | "stylus" | "body";
  crash: boolean;
  alarm?: string;
}
/** Where positions count from, and whether X is a diameter. */
export interface Reading {
  at: Vec3;
  axes: [Vec3, Vec3, Vec3];
  diameter: boolean;
}
export interface Drawing {
  dimensions: { at: Vec3; upper: boolean; set: number; real: number }[];
  touched: { at: Vec3; diameter: number; from: number; to?: number }[];
  reading: Reading;
}
export interface SceneView {
  pieces: Piece[]; // what hides, then what is seen through
  groups: LineGroup[];
  standings: Standing[];
  tools: Tool[];
  inUse: [from: number, tool: number][];
  probe: { ball: number; length: number; stylus: number; reach: number };
  size: number; // diagonal of what is to be seen, mm
  normal: number; // length of a normal, mm
  axis: number; // length of the axes of a coordinate system, mm
  frames: Frame[];
  collisions: Collision[];
  drawing?: Drawing;
  turning: boolean;
  entries: number;
}

/**
 * vertices: 6 numbers each, place in the frame of the piece and normal; lines: 6; ways: 8, with the parts of the motion
 * between which they are travelled; touches: 6, point and normal; stands: 3 an entry, where it leaves the probe.
 */
export interface SceneData {
  view: SceneView;
  vertices: Float32Array;
  corners: Uint32Array;
  lines: Float64Array;
  ways: Float64Array;
  wayEntries: Uint32Array;
  wayKinds: Uint8Array;
  touches: Float64Array;
  touchEntries: Uint32Array;
  touchSorts: Uint8Array;
  stands: Float64Array;
}

/** A scene in the module: `Scene` of @pkg/program. */
export interface SceneSource {
  view(): string;
  vertices(): Float32Array;
  corners(): Uint32Array;
  lines(): Float64Array;
  ways(): Float64Array;
  way_entries(): Uint32Array;
  way_kinds(): Uint8Array;
  touches(): Float64Array;
  touch_entries(): Uint32Array;
  touch_sorts(): Uint8Array;
  stands(): Float64Array;
  free(): void;
}

/** Takes it out of the module. */
export function takeScene(source: SceneSource): SceneData {
  const data: SceneData = {
    view: JSON.parse(source.view()) as SceneView,
    vertices: source.vertices().slice(),
    corners: source.corners().slice(),
    lines: source.lines().slice(),
    ways: source.ways().slice(),
    wayEntries: source.way_entries().slice(),
    wayKinds: source.way_kinds().slice(),
    touches: source.touches().slice(),
    touchEntries: source.touch_entries().slice(),
    touchSorts: source.touch_sorts().slice(),
    stands: source.stands().slice(),
  };
  source.free();
  return data;
}

/** What of it can be handed over to another thread without a copy. */
export function buffersOf({ view: _, ...arrays }: SceneData): ArrayBuffer[] {
  return Object.values(arrays).map(array => array.buffer as ArrayBuffer);
}

export const NOTHING: SceneData = {
  view: {
    pieces: [],
    groups: [],
    standings: [
      {
        entry: 0,
        places: [],
        whole: [
          [-20, -20, -20],
          [20, 20, 20],
        ],
      },
    ],
    tools: [],
    inUse: [],
    probe: { ball: 1, length: 1, stylus: 1, reach: 1 },
    size: 70,
    normal: 5,
    axis: 10,
    frames: [],
    collisions: [],
    turning: false,
    entries: 0,
  },
  vertices: new Float32Array(),
  corners: new Uint32Array(),
  lines: new Float64Array(),
  ways: new Float64Array(),
  wayEntries: new Uint32Array(),
  wayKinds: new Uint8Array(),
  touches: new Float64Array(),
  touchEntries: new Uint32Array(),
  touchSorts: new Uint8Array(),
  stands: new Float64Array(),
};

/** Three numbers of an array. */
export const vec = (array: Float64Array | Float32Array, first: number): Vec3 => [
  array[first]!,
  array[first + 1]!,
  array[first + 2]!,
];

/** Place of the first number in a rising array that is not less. */
export function firstFrom(rising: Uint32Array, least: number): number {
  let [low, high] = [0, rising.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (rising[middle]! < least) low = middle + 1;
    else high = middle;
  }
  return low;
}
