// Where words stand, so that none lies on another: the first free one of the places that each would take, else a free
// place near the best of them. Where there is none, they are left out.
import type { Drawn } from "../draw";
import type { Viewport } from "./camera";

/** CSS pixels. */
export interface Rect {
  left: number;
  top: number;
  right: number;
  bottom: number;
}
export interface Spot {
  x: number;
  y: number;
}
/** Words of a size; `spots`: where their middle may be, the best first; `reach`: how far from it at most. */
export interface Words {
  width: number;
  height: number;
  spots: Spot[];
  reach: number;
}
/** Words and how they are drawn; `line`: below all of them, from them to their place. */
export interface Written extends Words {
  draw(spot: Spot): Drawn[];
  line?(spot: Spot): Drawn[];
}
/** What stays free: `always`, or `rather` while there is room elsewhere. */
export interface Kept {
  always: readonly Rect[];
  rather: readonly Rect[];
}

const AIR = 2; // around each
const EXACT = 1e-6; // what touches covers nothing

export const around = ({ x, y }: Spot, width: number, height: number): Rect => ({
  left: x - width / 2 - AIR,
  top: y - height / 2 - AIR,
  right: x + width / 2 + AIR,
  bottom: y + height / 2 + AIR,
});

/** Whether the one covers something of the other. */
export function covers(a: Rect, b: Rect): boolean {
  const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
  const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
  return across > EXACT && down > EXACT;
}

export const isInside = ({ left, top, right, bottom }: Rect, { width, height }: Viewport): boolean =>
  left > -EXACT && top > -EXACT && right < width + EXACT && bottom < height + EXACT;

/** What is taken, by squares of the view: of hundreds of touches few are where words would stand. */
type Taken = Map<number, Rect[]>;

const SQUARE = 32; // CSS pixels
const ROW = 4096; // squares of a row at most
const NONE: readonly Rect[] = [];
const NEAR = 120; // what is farther from its place than that may stand on a touch instead

/** Squares that have something of a rectangle and of the view: the first and the last, across and down. */
function squaresOf({ left, top, right, bottom }: Rect, room: Viewport): [number, number, number, number] {
  const square = (at: number, length: number): number => Math.floor(Math.min(Math.max(0, at), length) / SQUARE);
  return [square(left, room.width), square(top, room.height), square(right, room.width), square(bottom, room.height)];
}

function take(taken: Taken, rect: Rect, room: Viewport): void {
  const [left, top, right, bottom] = squaresOf(rect, room);
  for (let y = top; y <= bottom; y++)
    for (let x = left; x <= right; x++) {
      const there = taken.get(y * ROW + x);
      if (there) there.push(rect);
      else taken.set(y * ROW + x, [rect]);
    }
}

function takenBy(rects: readonly Rect[], room: Viewport): Taken {
  const taken: Taken = new Map();
  for (const rect of rects) take(taken, rect, room);
  return taken;
}

function isFree(box: Rect, taken: Taken, room: Viewport): boolean {
  const [left, top, right, bottom] = squaresOf(box, room);
  for (let y = top; y <= bottom; y++)
    for (let x = left; x <= right; x++)
      for (const other of taken.get(y * ROW + x) ?? NONE) if (covers(box, other)) return false;
  return true;
}

/** A spot for each, in turn; null where there is no room. */
export function placed(wanted: readonly Words[], room: Viewport, { always, rather }: Kept): (Spot | null)[] {
  const there = takenBy(always, room);
  const kept = takenBy(rather, room);
  const full: Words[] = []; // there was no room for these wherever: later there is none for what is as large
  const isFull = ({ width, height }: Words): boolean => full.some(one => one.width <= width && one.height <= height);
  return wanted.map(words => {
    const spot = isFull(words)
      ? null
      : (spotOf(words, room, [there, kept], NEAR) ?? spotOf(words, room, [there], Infinity));
    if (spot) take(there, around(spot, words.width, words.height), room);
    else if (words.reach === Infinity) full.push(words);
    return spot;
  });
}

function spotOf(words: Words, room: Viewport, there: readonly Taken[], most: number): Spot | null {
  const { width, height, spots, reach } = words;
  const free = (spot: Spot): boolean => {
    const box = around(spot, width, height);
    return isInside(box, room) && there.every(taken => isFree(box, taken, room));
  };
  return spots.find(free) ?? nearest({ ...words, reach: Math.min(reach, most) }, room, free);
}

const STEP = 4; // CSS pixels from one spot that is tried to the next

/** A free spot near the best one, on squares around it that grow: as many are tried as the view has at most. */
function nearest({ width, height, spots, reach }: Words, room: Viewport, free: (spot: Spot) => boolean): Spot | null {
  const inside = (at: number, half: number, length: number): number => Math.min(Math.max(at, half), length - half);
  const best = spots[0]!;
  const x = inside(best.x, width / 2 + AIR, room.width);
  const y = inside(best.y, height / 2 + AIR, room.height);
  const left = reach - Math.hypot(x - best.x, y - best.y);
  const farthest = Math.min(left, Math.max(room.width, room.height));
  for (let away = 0; away <= farthest; away += STEP)
    for (let along = 0; along <= away; along += STEP)
      for (const [across, down] of edges(along, away)) {
        const spot = { x: x + across, y: y + down };
        if (free(spot)) return spot;
      }
  return null;
}

/** Steps to the spots on the edges of a square of half the length `away` that are so far from the middle of an edge. */
function edges(along: number, away: number): readonly (readonly [number, number])[] {
  const up = [along, -away] as const;
  return away === 0
    ? [up]
    : [
        up,
        [along, away],
        [-along, -away],
        [-along, away],
        [away, along],
        [-away, along],
        [away, -along],
        [-away, -along],
      ];
}

/** Spots on rings around a place, those nearest to a direction first. */
export function beside({ x, y }: Spot, away: Spot): Spot[] {
  const towards = Math.atan2(away.y, away.x);
  const spots: Spot[] = [];
  for (const distance of [64, 92])
    for (const turn of [0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6]) {
      const angle = towards + (turn * Math.PI) / 6;
      spots.push({ x: x + distance * Math.cos(angle) * 1.25, y: y + distance * Math.sin(angle) });
    }
  return spots;
}

/** Where the way from the middle of the view to a place outside of it leaves the view, so far from its border. */
export function atBorder({ x, y }: Spot, { width, height }: Viewport, inset: number): Spot {
  const [dx, dy] = [x - width / 2, y - height / 2];
  const share = (off: number, length: number): number =>
    Math.max(0, length / 2 - inset) / Math.max(1e-6, Math.abs(off));
  const part = Math.min(share(dx, width), share(dy, height));
  return { x: width / 2 + part * dx, y: height / 2 + part * dy };
}
