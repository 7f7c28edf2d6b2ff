// The whole path of a run for a graphics device: in chunks with a box around each, and each chunk on several levels,
// one about half as fine as the one before. A chunk that is out of sight is left out, and while the view moves, the
// finest level is drawn that the device bears; the first level has every motion.

import type { Vec3 } from "../wire";

/** Motions of a chunk. */
export const CHUNK = 4096;
/** Levels of a chunk; the first one is the path as it is. */
export const LEVELS = 10;
/** Words of a corner (web/preview/src/layout.rs). */
export const WORDS = 4;
/** Among the indices: the strip ends. */
export const CUT = 0xffff;
/** Numbers of a span to draw: part, first corner of its chunk, first index, end of them (web/preview/src/path.rs). */
export const SPAN = 4;

const FINEST = 1 / 8192; // what the second level may be off, share of the size of the path; each further one twice that
const REACH = 16; // corners that a level leaves out between two, at most
const ENOUGH = 0.6; // of the motions of a level that the next one may have; else it leaves out every second one
const CHUNKS = 64; // of a part

/** A part of the path as it goes to the device, and where its chunks are. */
export interface PathPart {
  vertices: Uint32Array; // X Y Z from the origin of the path as single floats, 4 × entries done there + kind
  indices: Uint16Array; // strips of lines, from the first corner of the chunk on
  boxes: Float32Array; // 6 a chunk: least and greatest coordinates
  starts: Uint32Array; // first corner of each chunk, and the end
  firsts: Uint32Array; // LEVELS a chunk: first index of the level, and the end of the last
  counts: Uint32Array; // LEVELS a chunk: motions drawn
}

export interface Path {
  origin: Vec3; // mm
  low: Vec3; // box around it, from the origin
  high: Vec3;
  motions: number;
  parts: PathPart[];
}

/** Straight pieces of motions: 8 numbers each (`SceneData.ways`), with the entry of the trace and the kind of each. */
export interface Ways {
  ways: Float64Array;
  wayEntries: Uint32Array;
  wayKinds: Uint8Array;
}

const WAY = 8;

/** All pieces as a path; null where there is none. */
export function pathOf({ ways, wayEntries, wayKinds }: Ways): Path | null {
  const motions = wayEntries.length;
  if (!motions) return null;
  const { low, high } = boxAround(ways);
  const origin = low.map((least, i) => (least + high[i]!) / 2) as Vec3;
  const size = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  const parts: PathPart[] = [];
  for (let from = 0; from < motions; from += CHUNK * CHUNKS) {
    const to = Math.min(motions, from + CHUNK * CHUNKS);
    parts.push(partOf({ ways, wayEntries, wayKinds }, from, to, origin, size));
  }
  const from = (corner: Vec3): Vec3 => corner.map((at, i) => at - origin[i]!) as Vec3;
  return { origin, low: from(low), high: from(high), motions, parts };
}

function boxAround(ways: Float64Array): { low: Vec3; high: Vec3 } {
  const low: Vec3 = [Infinity, Infinity, Infinity];
  const high: Vec3 = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < ways.length; i += WAY)
    for (let n = 0; n < 6; n++) {
      const [axis, at] = [n % 3, ways[i + n]!];
      if (at < low[axis]!) low[axis] = at;
      if (at > high[axis]!) high[axis] = at;
    }
  return { low, high };
}

/** A chunk while it is made: its corners, and the strips of a level as indices. */
interface Corners {
  at: Float32Array;
  words: Uint32Array;
  count: number;
}

function partOf(from: Ways, first: number, end: number, origin: Vec3, size: number): PathPart {
  const chunks = Math.ceil((end - first) / CHUNK);
  const vertices = new Uint32Array(WORDS * 2 * (end - first));
  const at = new Float32Array(vertices.buffer);
  const starts = new Uint32Array(chunks + 1);
  const boxes = new Float32Array(6 * chunks);
  const firsts = new Uint32Array(chunks * LEVELS + 1);
  const counts = new Uint32Array(chunks * LEVELS);
  const levels: Uint16Array[] = [];
  let all = 0;
  for (let chunk = 0; chunk < chunks; chunk++) {
    const start = starts[chunk]!;
    const words = vertices.subarray(WORDS * start);
    const corners: Corners = { at: at.subarray(WORDS * start), words, count: 0 };
    const until = Math.min(end, first + (chunk + 1) * CHUNK);
    let level = strips(from, first + chunk * CHUNK, until, origin, corners);
    boxes.set(boxOf(corners), 6 * chunk);
    starts[chunk + 1] = start + corners.count;
    for (let n = 0; n < LEVELS; n++) {
      if (n > 0) level = coarser(level, corners, size * FINEST * 2 ** n);
      levels.push(level);
      counts[chunk * LEVELS + n] = motionsOf(level);
      all += level.length;
      firsts[chunk * LEVELS + n + 1] = all;
    }
  }
  const even = new Uint16Array(all + (all % 2)); // buffers of a device are whole words
  levels.forEach((level, n) => {
    even.set(level, firsts[n]!);
  });
  return { vertices: vertices.slice(0, WORDS * starts[chunks]!), indices: even, boxes, starts, firsts, counts };
}

/** The motions as they are. A corner at which the kind changes is there twice, so that no motion has two colours. */
function strips(
  { ways, wayEntries, wayKinds }: Ways,
  from: number,
  to: number,
  origin: Vec3,
  into: Corners,
): Uint16Array {
  const level = new Uint16Array(3 * (to - from));
  let length = 0;
  const corner = (place: number, done: number, kind: number): void => {
    const word = WORDS * into.count;
    for (let axis = 0; axis < 3; axis++) into.at[word + axis] = ways[place + axis]! - origin[axis]!;
    into.words[word + 3] = 4 * done + kind;
    level[length++] = into.count++;
  };
  for (let i = from; i < to; i++) {
    const place = WAY * i;
    const [entry, kind] = [wayEntries[i]!, wayKinds[i]!];
    const goesOn = i > from && [0, 1, 2].every(axis => ways[place + axis] === ways[place - WAY + 3 + axis]);
    if (!goesOn || kind !== wayKinds[i - 1]) {
      if (i > from && !goesOn) level[length++] = CUT;
      corner(place, entry, kind);
    }
    corner(place + 3, entry + 1, kind);
  }
  return level.slice(0, length);
}

function boxOf({ at, count }: Corners): number[] {
  const box = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
  for (let i = 0; i < WORDS * count; i += WORDS)
    for (let axis = 0; axis < 3; axis++) {
      box[axis] = Math.min(box[axis]!, at[i + axis]!);
      box[axis + 3] = Math.max(box[axis + 3]!, at[i + axis]!);
    }
  return box;
}

/** How many lines strips have, those without length that only change the colour among them. */
export function motionsOf(level: Uint16Array): number {
  let count = 0;
  for (let i = 1; i < level.length; i++) if (level[i] !== CUT && level[i - 1] !== CUT) count++;
  return count;
}

/** The next level: no corner that it leaves out is farther than `off` mm from it, unless that leaves too many. */
function coarser(level: Uint16Array, corners: Corners, off: number): Uint16Array {
  const next = new Uint16Array(level.length);
  let length = 0;
  for (let from = 0; from < level.length; ) {
    const cut = level.indexOf(CUT, from);
    const to = cut < 0 ? level.length : cut;
    if (from > 0) next[length++] = CUT;
    length = straightened(level, from, to, corners, off, next, length);
    from = to + 1;
  }
  const made = next.slice(0, length);
  return motionsOf(made) <= ENOUGH * motionsOf(level) ? made : everySecond(made);
}

/** One strip with fewer corners; the end of what is written. */
function straightened(
  level: Uint16Array,
  from: number,
  to: number,
  corners: Corners,
  off: number,
  next: Uint16Array,
  written: number,
): number {
  let length = written;
  let anchor = from;
  next[length++] = level[anchor]!;
  while (anchor < to - 1) {
    let last = anchor + 1;
    const farthest = Math.min(to - 1, anchor + REACH);
    while (last < farthest && !hasToStay(level, last, corners, off) && isNear(level, anchor, last + 1, corners, off))
      last++;
    anchor = last;
    next[length++] = level[anchor]!;
  }
  return length;
}

/** A change of colour is seen at a motion that is long enough. */
function hasToStay(level: Uint16Array, place: number, { at, words }: Corners, off: number): boolean {
  const [before, here, after] = [level[place - 1]!, level[place]!, level[place + 1]!].map(index => WORDS * index);
  const kind = (word: number | undefined): number => words[word! + 3]! & 3;
  if (kind(before) === kind(here) && kind(here) === kind(after)) return false;
  return distance(at, before!, here!) > off || distance(at, here!, after!) > off;
}

const distance = (at: Float32Array, a: number, b: number): number =>
  Math.hypot(at[b]! - at[a]!, at[b + 1]! - at[a + 1]!, at[b + 2]! - at[a + 2]!);

/** Whether all corners between two are near the straight line from one to the other. */
function isNear(level: Uint16Array, from: number, to: number, { at }: Corners, off: number): boolean {
  const [a, b] = [WORDS * level[from]!, WORDS * level[to]!];
  const [dx, dy, dz] = [at[b]! - at[a]!, at[b + 1]! - at[a + 1]!, at[b + 2]! - at[a + 2]!];
  const square = dx * dx + dy * dy + dz * dz;
  for (let i = from + 1; i < to; i++) {
    const c = WORDS * level[i]!;
    const [x, y, z] = [at[c]! - at[a]!, at[c + 1]! - at[a + 1]!, at[c + 2]! - at[a + 2]!];
    const part = square > 0 ? Math.min(1, Math.max(0, (x * dx + y * dy + z * dz) / square)) : 0;
    const [ox, oy, oz] = [x - part * dx, y - part * dy, z - part * dz];
    if (ox * ox + oy * oy + oz * oz > off * off) return false;
  }
  return true;
}

function everySecond(level: Uint16Array): Uint16Array {
  const next = new Uint16Array(2 * level.length);
  let length = 0;
  let number = 0;
  for (let i = 1; i < level.length; i++) {
    if (level[i] === CUT || level[i - 1] === CUT || number++ % 2) continue;
    if (length) next[length++] = CUT;
    next[length++] = level[i - 1]!;
    next[length++] = level[i]!;
  }
  return next.slice(0, length);
}

/** A view of the path: a clip matrix, columns first, and where its origin is in that. */
export interface Looked {
  matrix: ArrayLike<number>;
  shift: readonly [number, number, number] | readonly number[];
}

/** The chunks that may be in sight, by part and number. */
export function inSight({ parts }: Path, looked: Looked): [part: number, chunk: number][] {
  return parts.flatMap(({ boxes }, part) =>
    Array.from({ length: boxes.length / 6 }, (_, chunk) => chunk)
      .filter(chunk => isInSight(boxes.subarray(6 * chunk, 6 * chunk + 6), looked))
      .map((chunk): [number, number] => [part, chunk]),
  );
}

/** Whether no plane of the view has the whole box behind it. A margin of one pixel in a thousand keeps its rim. */
function isInSight(box: Float32Array, { matrix, shift }: Looked): boolean {
  const outside = [0, 0, 0, 0, 0];
  for (let corner = 0; corner < 8; corner++) {
    const [x, y, z] = [0, 1, 2].map(axis => box[axis + 3 * ((corner >> axis) & 1)]! + shift[axis]!);
    const [cx, cy, , cw] = [0, 1, 2, 3].map(
      row => matrix[row]! * x! + matrix[4 + row]! * y! + matrix[8 + row]! * z! + matrix[12 + row]!,
    );
    const reach = 1.002 * cw!;
    [cx! < -reach, cx! > reach, cy! < -reach, cy! > reach, cw! <= 0].forEach((out, plane) => {
      outside[plane]! += Number(out);
    });
  }
  return outside.every(count => count < 8);
}

/** The finest level of which no more than so many motions are seen. */
export function levelFor({ parts }: Path, seen: readonly [number, number][], most: number): number {
  for (let level = 0; level < LEVELS - 1; level++) {
    let count = 0;
    for (const [part, chunk] of seen) count += parts[part]!.counts[chunk * LEVELS + level]!;
    if (count <= most) return level;
  }
  return LEVELS - 1;
}

/** Spans to draw of one level. */
export function spansOf({ parts }: Path, seen: readonly (readonly [number, number])[], level: number): Uint32Array {
  const spans = new Uint32Array(SPAN * seen.length);
  seen.forEach(([part, chunk], n) => {
    const { starts, firsts } = parts[part]!;
    const place = chunk * LEVELS + level;
    spans.set([part, starts[chunk]!, firsts[place]!, firsts[place + 1]!], SPAN * n);
  });
  return spans;
}

/** The motions of chunks on a level: from, to, and what the device is told of the end. */
export function* motionsIn(
  { parts }: Path,
  chunks: readonly (readonly [number, number])[],
  level: number,
): Generator<[Vec3, Vec3, { kind: number; done: number }]> {
  for (const [part, chunk] of chunks) {
    const { vertices, indices, starts, firsts } = parts[part]!;
    const at = new Float32Array(vertices.buffer, vertices.byteOffset, vertices.length);
    const place = chunk * LEVELS + level;
    const corner = (index: number): number => WORDS * (starts[chunk]! + index);
    const vec = (word: number): Vec3 => [at[word]!, at[word + 1]!, at[word + 2]!];
    for (let i = firsts[place]! + 1; i < firsts[place + 1]!; i++) {
      if (indices[i] === CUT || indices[i - 1] === CUT) continue;
      const [from, to] = [corner(indices[i - 1]!), corner(indices[i]!)];
      yield [vec(from), vec(to), { kind: vertices[to + 3]! & 3, done: vertices[to + 3]! >>> 2 }];
    }
  }
}
