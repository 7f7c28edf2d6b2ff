// Where everything stands at a step: the probe on its way, the part on its table, the tool in use.

import { firstFrom, type SceneData, type Standing, type Tool, vec } from "../core/scene";
import type { Vec3 } from "../wire";
import { mix } from "./vec";

const WAY = 8; // numbers a straight piece

/** How the part stands when entry `index` is done: a rotary axis turns it. */
export function standingAt({ view: { standings } }: SceneData, index: number): { standing: Standing; place: number } {
  const place = Math.max(
    0,
    standings.findLastIndex(({ entry }) => entry <= index),
  );
  return { standing: standings[place]!, place };
}

/** Which tool is in use at entry `index`. */
export function toolIndexAt({ view: { inUse } }: SceneData, index: number): number | undefined {
  return inUse.findLast(([from], place) => place === 0 || from <= index)?.[1];
}

export function toolAt(data: SceneData, index: number): Tool | undefined {
  const found = toolIndexAt(data, index);
  return found === undefined ? undefined : data.view.tools[found];
}

/** Ends of the straight pieces of entry `index`, by number; equal where it is no motion. */
export function piecesOf({ wayEntries }: SceneData, index: number): [from: number, to: number] {
  return [firstFrom(wayEntries, index), firstFrom(wayEntries, index + 1)];
}

/** The place on piece number `piece` after a part of its motion. */
export function onPiece({ ways }: SceneData, piece: number, part: number): Vec3 {
  const first = WAY * piece;
  const [begin, end] = [ways[first + 6]!, ways[first + 7]!];
  const share = Math.min(1, Math.max(0, (part - begin) / (end - begin)));
  return mix(vec(ways, first), vec(ways, first + 3), share);
}

/** Where the centre of the ball is while entry `index` is done to `fraction`; null: nothing moves. */
export function probeAt(data: SceneData, index: number, fraction: number): Vec3 | null {
  const { ways, stands } = data;
  const [from, to] = piecesOf(data, index);
  for (let piece = from; piece < to; piece++)
    if (piece === to - 1 || ways[WAY * piece + 7]! >= fraction) return onPiece(data, piece, fraction);
  const last = stands.length / 3 - 1;
  return last < 0 ? null : vec(stands, 3 * Math.min(Math.max(0, index), last));
}

const BLOCK = 300; // entries of a run

/**
 * Of a long run the block of entries in which `index` lies, with one before it and one behind: the paths of the rest
 * would hide them, and take seconds to draw where there is no graphics card. Of a short run all.
 */
export function blockOf(index: number): number {
  return Math.floor(index / BLOCK);
}

/** The entries whose paths are drawn around entry `index`, the last excluded. */
export function drawnAround(index: number): [from: number, to: number] {
  const first = Math.max(0, blockOf(index) - 1) * BLOCK;
  return [first, first + 3 * BLOCK];
}
