// Where words stand, so that none lies on another: the first free one of the places that each would take, else the
// nearest free place. Where there is none, they are left out.
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

/** A spot for each, in turn; null where there is no room. */
export function placed(wanted: readonly Words[], room: Viewport, { always, rather }: Kept): (Spot | null)[] {
  const there = [...always];
  return wanted.map(words => {
    const spot = spotOf(words, room, [...there, ...rather]) ?? spotOf(words, room, there);
    if (spot) there.push(around(spot, words.width, words.height));
    return spot;
  });
}

function spotOf(words: Words, room: Viewport, there: readonly Rect[]): Spot | null {
  const { width, height, spots } = words;
  const free = (spot: Spot): boolean => {
    const box = around(spot, width, height);
    return isInside(box, room) && !there.some(other => covers(box, other));
  };
  return spots.find(free) ?? nearest(words, room, there, free);
}

/** The free spot nearest to the best one: its coordinates are those of that one, or of edges of what is there. */
function nearest(
  { width, height, spots, reach }: Words,
  room: Viewport,
  there: readonly Rect[],
  free: (spot: Spot) => boolean,
): Spot | null {
  const best = spots[0]!;
  const [w, h] = [width / 2 + AIR, height / 2 + AIR];
  const along = (at: number, half: number, length: number, edges: number[]): number[] =>
    [Math.min(Math.max(at, half), length - half), ...edges]
      .filter(one => one >= half && one <= length - half && Math.abs(one - at) <= reach)
      .sort((one, other) => Math.abs(one - at) - Math.abs(other - at));
  const xs = along(
    best.x,
    w,
    room.width,
    there.flatMap(({ left, right }) => [left - w, right + w]),
  );
  const ys = along(
    best.y,
    h,
    room.height,
    there.flatMap(({ top, bottom }) => [top - h, bottom + h]),
  );
  let found: Spot | null = null;
  let least = reach;
  for (const x of xs) {
    for (const y of ys) {
      const away = Math.sqrt((x - best.x) ** 2 + (y - best.y) ** 2);
      if (away > least || (found && away === least)) break; // the others are farther
      if (free({ x, y })) [found, least] = [{ x, y }, away];
    }
  }
  return found;
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
