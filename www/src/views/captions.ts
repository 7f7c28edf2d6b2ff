// Where the captions of a drawing stand: each as near to its figure as it can without lying upon a touch point or,
// where there is a way around, upon a line; and never upon another caption. What stands far from its figure has a
// leader line. All in CSS pixels, y down.

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
  /** What it says where the text has no room. */
  short?: string | undefined;
  at: Point;
  other?: Point;
  anchor: "start" | "middle";
}
/** A caption where it stands, with the ends of its leader line. */
export interface Placed extends Caption {
  leader?: [Point, Point];
}
interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

const CHARACTER = 6.6; // width of a character of a caption
const WIDE = 11; // of one as wide as it is high
const ABOVE = 9; // of the base line
const BELOW = 3;
const BESIDE = 9; // between two captions in a row: more than a space, or a number reads on into the next one
const GRID = 6; // between places all over the drawing
const NEAR = 22; // a caption so near to its figure needs no leader line
const MOST = 0.5; // of the width of the drawing, for one caption
const STEPS = {
  x: [0, 8, -8, 16, -16, 26, -26, 38, -38, 52, -52],
  y: [0, 6, -6, 12, -12, 18, -18, 24, -24, 32, -32, 42, -42],
};
const MOVES: Point[] = STEPS.y
  .flatMap(y => STEPS.x.map((x): Point => [x, y]))
  .sort((a, b) => Math.hypot(...a) - Math.hypot(...b));

export function widthOf(text: string): number {
  let sum = 0;
  for (const character of text) sum += character < "\u2e80" ? CHARACTER : WIDE;
  return sum;
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

/** Whether two captions lie upon each other, or nearly in one line. */
function collide(a: Box, b: Box): boolean {
  const across = Math.min(a.right, b.right) - Math.max(a.left, b.left) + BESIDE;
  const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
  return across > 0 && down > 0;
}

/** How bad a place is; no further than `enough`. */
function cost(box: Box, obstacles: readonly Obstacle[], moved: number, enough: number): number {
  let sum = moved;
  for (const obstacle of obstacles) {
    if (sum >= enough) return sum;
    sum += obstacle.weight * inside(obstacle, box);
  }
  return sum;
}

/** The room that a caption takes up with its base line at a point. */
export function room({ text, anchor }: Caption, [x, y]: Point): Box {
  const long = widthOf(text);
  const left = anchor === "middle" ? x - long / 2 : x;
  return { left, right: left + long, top: y - ABOVE, bottom: y + BELOW };
}

/** What is asked at each caption: what has its place already, the lines, and how large the drawing is. */
interface Around {
  taken: readonly Box[];
  obstacles: readonly Obstacle[];
  size: Size;
}

export const within = ({ left, right, top, bottom }: Box, { width, height }: Size): boolean =>
  left >= 0 && right <= width && top >= 0 && bottom <= height;

/** The best place of those offered, the nearest first; none where all of them collide or stick out. */
function best(caption: Caption, places: Iterable<[Point, number]>, around: Around): Point | null {
  const { taken, obstacles, size } = around;
  let found: { at: Point; cost: number } | null = null;
  for (const [at, moved] of places) {
    const enough = found?.cost ?? Infinity;
    if (moved >= enough) break; // the others are further still
    const box = room(caption, at);
    if (!within(box, size) || taken.some(other => collide(box, other))) continue;
    const here = cost(box, obstacles, moved, enough);
    if (here < enough) found = { at, cost: here };
  }
  return found?.at ?? null;
}

/** Places beside where a caption would like to stand. */
function* beside({ at, other }: Caption): Generator<[Point, number]> {
  for (const move of MOVES)
    for (const base of other ? [at, other] : [at]) yield [[base[0] + move[0], base[1] + move[1]], farness(move)];
}

/** Places all over the drawing. */
function anywhere({ at }: Caption, { width, height }: Size): [Point, number][] {
  const places: [Point, number][] = [];
  for (let y = ABOVE; y <= height - BELOW; y += GRID)
    for (let x = 0; x <= width; x += GRID) places.push([[x, y], farness([x - at[0], y - at[1]])]);
  return places.sort((a, b) => a[1] - b[1]);
}

/** From the edge of its room to what it explains, where that is not near. */
function leader(caption: Caption, { left, right, top, bottom }: Box): Pick<Placed, "leader"> {
  const [x, y] = caption.at;
  const edge: Point = [Math.min(Math.max(x, left), right), Math.min(Math.max(y, top), bottom)];
  return Math.hypot(edge[0] - x, edge[1] - y) > NEAR ? { leader: [edge, caption.at] } : {};
}

function placed(caption: Caption, around: Around): Placed | null {
  const at = best(caption, beside(caption), around) ?? best(caption, anywhere(caption, around.size), around);
  return at && { ...caption, at, ...leader(caption, room(caption, at)) };
}

/**
 * Captions at better places, one after the other: those that explain a figure too long for the drawing by their short
 * text, and none where there is no room at all. In the order given.
 */
export function spread(captions: readonly Caption[], obstacles: readonly Obstacle[], size: Size): (Placed | null)[] {
  const taken: Box[] = [];
  return captions.map(caption => {
    const around = { taken, obstacles, size };
    const { short } = caption;
    const brief = short === undefined ? null : { ...caption, text: short };
    const long = brief !== null && widthOf(caption.text) > size.width * MOST;
    const stands = (long ? null : placed(caption, around)) ?? (brief && placed(brief, around));
    if (stands) taken.push(room(stands, stands.at));
    return stands;
  });
}
