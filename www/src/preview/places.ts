// Where words stand, so that none lies on another: the first of the places that each would take that is free.

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
/** Words of a size; `spots`: where their middle may be, the best first. */
export interface Words {
  width: number;
  height: number;
  spots: Spot[];
}

const AIR = 2; // around each

export const around = ({ x, y }: Spot, width: number, height: number): Rect => ({
  left: x - width / 2 - AIR,
  top: y - height / 2 - AIR,
  right: x + width / 2 + AIR,
  bottom: y + height / 2 + AIR,
});

/** How much of the one the other covers, square CSS pixels. */
function common(a: Rect, b: Rect): number {
  const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
  const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
  return across > 0 && down > 0 ? across * down : 0;
}

/** A spot for each, in turn; where all are taken, that with the least in common with what is there. */
export function placed(wanted: readonly Words[], taken: readonly Rect[]): Spot[] {
  const there = [...taken];
  return wanted.map(({ width, height, spots }) => {
    let best = { spot: spots[0]!, worse: Infinity };
    for (const spot of spots) {
      const box = around(spot, width, height);
      const worse = there.reduce((sum, other) => sum + common(box, other), 0);
      if (worse < best.worse) best = { spot, worse };
      if (worse === 0) break;
    }
    there.push(around(best.spot, width, height));
    return best.spot;
  });
}

/** The spot, then others around it, ever farther. */
export function near({ x, y }: Spot, width: number, height: number): Spot[] {
  const spots = [{ x, y }];
  for (let n = 1; n <= 4; n++)
    for (const [across, down] of [
      [0, -1],
      [0, 1],
      [0.5, 0],
      [-0.5, 0],
      [0.5, -1],
      [-0.5, -1],
      [0.5, 1],
      [-0.5, 1],
    ] as const)
      spots.push({ x: x + across * n * (width + 2 * AIR), y: y + down * n * (height + 2 * AIR) });
  return spots;
}

/** Spots on rings around a place, those nearest to a direction first. */
export function beside({ x, y }: Spot, away: Spot, room: { width: number; height: number }, size: Rect): Spot[] {
  const towards = Math.atan2(away.y, away.x);
  const inside = (spot: Spot): boolean =>
    spot.x + size.left > 0 &&
    spot.x + size.right < room.width &&
    spot.y + size.top > 0 &&
    spot.y + size.bottom < room.height;
  const spots: Spot[] = [];
  for (const distance of [64, 92, 124, 160])
    for (const turn of [0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6]) {
      const angle = towards + (turn * Math.PI) / 6;
      spots.push({ x: x + distance * Math.cos(angle) * 1.25, y: y + distance * Math.sin(angle) });
    }
  const seen = spots.filter(inside);
  return seen.length ? seen : spots;
}
