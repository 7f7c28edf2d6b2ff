// What the core says is to be seen: flat arrays, and what they hold (core/src/scene). Copied out of the module's
// memory, which the next call into it may move; so they can also cross from a worker.
import type { Scene as SceneSource } from "@pkg/core/core.js";
import type { SceneView, Vec3 } from "../wire";
import { type Path, pathOf } from "./levels";

export type {
  LineGroup,
  LineKind,
  Matter,
  Place,
  Reading,
  SceneLabel,
  ScenePiece as Piece,
  SceneTool as Tool,
  SceneView,
  Standing,
} from "../wire";

/**
 * vertices: 6 numbers each, place in the frame of the piece and normal; lines: 6; ways: 8, with the parts of the motion
 * between which they are travelled; touches: 6, point and normal; stands: 3 an entry, where it leaves the probe;
 * begins: 1 an entry and one for the end, s.
 * Written by hand, as these are no JSON: the module hands each out by a method of its own (web/src/scene.rs), of which
 * its declaration tells the type.
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
  begins: Float64Array;
  path: Path | null; // of a long run, all of its motions for a device
}

const SHORT = 600; // entries, all of which are drawn around a step

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
    begins: source.begins().slice(),
    path: null,
  };
  source.free();
  if (data.view.entries > SHORT) data.path = pathOf(data);
  return data;
}

/** What of it can be handed over to another thread without a copy. */
export function buffersOf({ view: _, path, ...arrays }: SceneData): ArrayBuffer[] {
  const own = Object.values(arrays).filter(array => !Object.values(NOTHING).includes(array));
  const all = [...own, ...(path?.parts ?? []).flatMap(part => Object.values(part) as Uint32Array[])];
  return all.map(({ buffer }) => buffer as ArrayBuffer);
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
        ground: [-20, 5],
      },
    ],
    tools: [],
    inUse: [],
    probe: { ball: 1, length: 1, stylus: 1, reach: 1 },
    size: 70,
    normal: 5,
    axis: 10,
    frames: [],
    labels: [],
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
  begins: new Float64Array(1),
  path: null,
};

/** A path and nothing else. */
export function onlyPath(path: Path, entries: number): SceneData {
  const whole = [path.low, path.high].map(corner => corner.map((at, i) => at + path.origin[i]!)) as [Vec3, Vec3];
  const standings = NOTHING.view.standings.map(standing => ({ ...standing, whole }));
  return { ...NOTHING, view: { ...NOTHING.view, entries, standings }, path };
}

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
