// Where the captions of a drawing stand: each as near to its figure as it can without lying upon another caption, a
// touch point or, where there is a way around, upon a line. All in CSS pixels, y down.

export type Point = [number, number];
export interface Size {
  width: number;
  height: number;
}
/** A line that a caption had better not lie upon, and how much it weighs against a pixel of distance. */
export interface Obstacle {
  from: Point;
  to: Point;
  weight: number;
}
/** A text that begins or has its middle at a point on its base line, or as well at the other one. */
export interface Caption {
  text: string;
  at: Point;
  other?: Point;
  anchor: "start" | "middle";
}
interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

const CHARACTER = 6.6; // width of a character of a caption
const ABOVE = 9; // of the base line
const BELOW = 3;
const BESIDE = 9; // between two captions in a row: more than a space, or a number reads on into the next one
const COLLISION = 40; // weight of a pixel of height shared with another caption
const STEPS = {
  x: [0, 8, -8, 16, -16, 26, -26, 38, -38, 52, -52],
  y: [0, 6, -6, 12, -12, 18, -18, 24, -24, 32, -32, 42, -42],
};
const MOVES: Point[] = STEPS.y
  .flatMap(y => STEPS.x.map((x): Point => [x, y]))
  .sort((a, b) => Math.hypot(...a) - Math.hypot(...b));

export function widthOf(text: string): number {
  return text.length * CHARACTER;
}

/** Length of the part of a line that lies in a box. */
function inside({ from, to }: Obstacle, box: Box): number {
  // most lines are elsewhere
  if (Math.max(from[0], to[0]) <= box.left || Math.min(from[0], to[0]) >= box.right) return 0;
  if (Math.max(from[1], to[1]) <= box.top || Math.min(from[1], to[1]) >= box.bottom) return 0;
  const way: Point = [to[0] - from[0], to[1] - from[1]];
  let [enter, leave] = [0, 1];
  for (const [axis, low, high] of [
    [0, box.left, box.right],
    [1, box.top, box.bottom],
  ] as const) {
    if (way[axis] === 0) continue; // within the box all along, as was seen above
    const [one, other] = [(low - from[axis]) / way[axis], (high - from[axis]) / way[axis]];
    enter = Math.max(enter, Math.min(one, other));
    leave = Math.min(leave, Math.max(one, other));
  }
  return Math.max(0, leave - enter) * Math.hypot(...way);
}

/** Far off, a caption is no longer taken for that of its figure. */
function farness(move: Point): number {
  const far = Math.hypot(...move);
  return far + (far * far) / 30;
}

function shared(a: Box, b: Box): number {
  const across = Math.min(a.right, b.right) - Math.max(a.left, b.left) + BESIDE;
  const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
  return across > 0 && down > 0 ? down : 0;
}

/** How bad a place is; no further than `enough`. */
function cost(box: Box, taken: readonly Box[], obstacles: readonly Obstacle[], moved: number, enough: number): number {
  let sum = moved;
  for (const other of taken) sum += COLLISION * shared(box, other);
  for (const obstacle of obstacles) {
    if (sum >= enough) return sum;
    sum += obstacle.weight * inside(obstacle, box);
  }
  return sum;
}

/** Moves captions to better places, one after the other. */
export function spread(captions: readonly Caption[], obstacles: readonly Obstacle[], { width, height }: Size): void {
  const taken: Box[] = [];
  for (const caption of captions) {
    const { at, other } = caption;
    const long = widthOf(caption.text);
    const before = caption.anchor === "middle" ? long / 2 : 0;
    const box = ([x, y]: Point): Box => ({
      left: x - before,
      right: x - before + long,
      top: y - ABOVE,
      bottom: y + BELOW,
    });
    let best = { at, cost: Infinity };
    for (const move of MOVES) {
      const moved = farness(move);
      if (moved >= best.cost) break; // the others are further still
      for (const base of other ? [at, other] : [at]) {
        const place: Point = [base[0] + move[0], base[1] + move[1]];
        const { left, right, top, bottom } = box(place);
        if ((left < 0 || right > width || top < 0 || bottom > height) && best.cost < Infinity) continue;
        const found = cost(box(place), taken, obstacles, moved, best.cost);
        if (found < best.cost) best = { at: place, cost: found };
      }
    }
    caption.at = best.at;
    taken.push(box(best.at));
  }
}
