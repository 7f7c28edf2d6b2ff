// Parts of the trace as triangles and edges, errors included.
import type { Solid, Vec3 } from "../wire";
import type { Rgba } from "./colours";
import { append, band, fan, flat, type Line, type Mesh, mesh, quad, VERTEX_FLOATS } from "./mesh";
import { border, CIRCLE_POINTS, circle, normals, type Outline, rectangle, type Vec2 } from "./outline";
import type { Look, Part } from "./part";
import { surface } from "./surface";
import { add, apply, product, radians, rpy, times, unit } from "./vec";

/**
 * Enough for faces that are drawn one over the other in the order of their distance: long ones have no one distance.
 */
export const SORTED_PIECES = 6;
const BALL_ROWS = 24; // from pole to pole; even, so that one is the equator
const ZONE_OPACITY = 0.22;

/** A part in machine coordinates. */
export function part(solid: Solid, colour: Rgba, edge: Rgba, pieces: number): Part {
  const look: Look = { paint: { colour }, edge: { colour: edge, width: 1.25, through: 0.16 }, pieces };
  const own = solid.surface ? surface(solid.surface, look) : build(solid.shape, solid.size, solid.errors, look);
  return placed(own, placement(solid));
}

/** The walls of a protection zone, seen through, with their rims. */
export function zone(solid: Solid, colour: Rgba, pieces: number): Part {
  const [a = 10, b = 10, c = 10] = solid.size;
  const [outline, height] =
    solid.shape === "shaft"
      ? [circle(a, solid.errors), b]
      : solid.shape === "web"
        ? [rectangle(a, c, solid.errors), b]
        : [rectangle(a, b, solid.errors), c];
  const look: Look = {
    paint: { colour: [colour[0], colour[1], colour[2], ZONE_OPACITY] },
    edge: { colour, width: 1.5, dash: 7, through: 0.5 },
    pieces,
  };
  const own: Part = { mesh: mesh(), edges: rims(outline, height, look) };
  walls(own.mesh, outline, 0, height, 1, look);
  return placed(own, placement(solid));
}

function build(shape: Solid["shape"], size: number[], errors: Solid["errors"], look: Look): Part {
  const [a = 10, b = 10, c = 10, d = 10] = size;
  switch (shape) {
    case "hole":
      return sunk(circle(a, errors), b, look);
    case "pocket":
      return sunk(rectangle(a, b, errors), c, look);
    case "shaft":
      return standing(circle(a, errors), b, look);
    case "island":
      return standing(rectangle(a, b, errors), c, look);
    case "groove":
      return extruded(grooveProfile(a, b, errors), c, look);
    case "web":
      return extruded(webProfile(a, b, errors), c, look);
    case "block":
      return block([a + errors.size, b + errors.size], 0, -c, look);
    case "outerCorner":
      return cornered(a, [b, c], errors, (x, y, own) => block([x + own.size, y + own.size], 0, -d, look));
    case "innerCorner":
      return cornered(a, [b, c], errors, (x, y, own) => sunk(rectangle(x, y, own), d, look));
    case "turned":
      return turned(circle(a, errors), b, c > 0 ? circle(c, errors) : undefined, d, look);
    case "chuck":
      return chuck(circle(a, errors), b, c, look);
    case "sphere":
      return sphere((a + errors.size) / 2, look);
    case "surface":
      return { mesh: mesh(), edges: [] };
  }
}

// Placing

/**
 * Shape origin into the machine: rotation and position, then the tilt about the origin and the shift, both in machine
 * axes.
 */
function placement({ errors, rotation, at }: Solid): { point(p: Vec3): Vec3; direction(p: Vec3): Vec3 } {
  const turn = product(rpy(errors.tilt), rpy(rotation));
  const direction = (p: Vec3) => apply(turn, p);
  const origin = add(at, errors.shift);
  return { direction, point: p => add(origin, direction(p)) };
}

/** A rectangular body pushed askew, so that its first corner stands at the origin with this angle: the second edge
 * leans
 *  over, and what counts across a wall is longer along the other edge. */
function cornered(
  degrees: number,
  [x, y]: Vec2,
  errors: Solid["errors"],
  body: (x: number, y: number, own: Solid["errors"]) => Part,
): Part {
  const [sine, cosine] = [Math.sin(radians(degrees)), Math.cos(radians(degrees))];
  const own = body(x, y, { ...errors, size: errors.size / sine, taper: errors.taper / sine });
  return placed(own, {
    point: ([u, v, z]) => [u + x / 2 + (v + y / 2) * cosine, (v + y / 2) * sine, z],
    direction: ([u, v, z]) => unit([u, (v - cosine * u) / sine, z]),
  });
}

/** Moves what was built in the part's own frame; neither a rotation nor a push askew turns a winding round. */
function placed(own: Part, { point, direction }: ReturnType<typeof placement>): Part {
  const { vertices, used } = own.mesh;
  const put = (first: number, [x, y, z]: Vec3): void => {
    vertices[first] = x;
    vertices[first + 1] = y;
    vertices[first + 2] = z;
  };
  const read = (first: number): Vec3 => [vertices[first]!, vertices[first + 1]!, vertices[first + 2]!];
  for (let i = 0; i < used; i += VERTEX_FLOATS) {
    put(i, point(read(i)));
    put(i + 3, direction(read(i + 3)));
  }
  return { mesh: own.mesh, edges: own.edges.map(line => ({ ...line, from: point(line.from), to: point(line.to) })) };
}

// Shapes in their own frame

const at = ([x, y]: Vec2, z: number): Vec3 => [x, y, z];
const around = (half: Vec2): number => Math.max(8, 0.45 * Math.max(...half));
const grown = (half: Vec2, by: number): Vec2 => [half[0] + by, half[1] + by];

/** A recess in a block that is open at the top. */
function sunk(outline: Outline, depth: number, look: Look): Part {
  const half = grown(outline.half, around(outline.half));
  const bottom = -depth - Math.max(4, 0.25 * depth);
  const own = block(half.map(h => 2 * h) as Vec2, 0, bottom, look, false);
  walls(own.mesh, outline, 0, depth, -1, look);
  strip(own.mesh, outline.at(0), outline.around(half), 0, true, look);
  disc(own.mesh, outline.at(depth), -depth, look);
  own.edges.push(...rims(outline, depth, look));
  return own;
}

/** A body standing on a plate. */
function standing(outline: Outline, height: number, look: Look): Part {
  const half = grown(outline.half, around(outline.half));
  const own = block(half.map(h => 2 * h) as Vec2, -height, -height - Math.max(3, 0.2 * height), look, false);
  walls(own.mesh, outline, 0, height, 1, look);
  disc(own.mesh, outline.at(0), 0, look);
  strip(own.mesh, outline.at(height), outline.around(half), -height, true, look);
  own.edges.push(...rims(outline, height, look));
  return own;
}

/** A cylinder about Z with its front face at the origin. One with a bore is drawn in half section, the half on the side
 *  of +Y taken away, so that the bore is seen. */
function turned(outline: Outline, length: number, bore: Outline | undefined, depth: number, look: Look): Part {
  if (bore) return halfTurned(outline, length, bore, depth, look);
  const own: Part = { mesh: mesh(), edges: rims(outline, length, look) };
  walls(own.mesh, outline, 0, length, 1, look);
  disc(own.mesh, outline.at(length), -length, look, [0, 0, -1]);
  disc(own.mesh, outline.at(0), 0, look);
  return own;
}

const JAWS = 3;
const JAW_WIDTH = 0.28; // of the diameter of the chuck

/** Jaws over the first third, the body behind them. */
function chuck(outline: Outline, length: number, grip: number, look: Look): Part {
  const high = length / 3;
  const own: Part = {
    mesh: mesh(),
    edges: [...loop(outline.at(0), -high, look), ...loop(outline.at(length), -length, look)],
  };
  walls(own.mesh, outline, high, length, 1, look);
  disc(own.mesh, outline.at(length), -length, look, [0, 0, -1]);
  disc(own.mesh, outline.at(high), -high, look);
  const [radius] = outline.half;
  const size: Vec2 = [0.94 * radius - grip / 2, 2 * JAW_WIDTH * radius];
  for (let jaw = 0; jaw < JAWS && size[0] > 0; jaw++) {
    const [sine, cosine] = [Math.sin((2 * Math.PI * jaw) / JAWS), Math.cos((2 * Math.PI * jaw) / JAWS)];
    const turn = ([x, y, z]: Vec3): Vec3 => [cosine * x - sine * y, sine * x + cosine * y, z];
    const one = placed(block(size, 0, -high, look), {
      direction: turn,
      point: ([x, y, z]) => turn([x + grip / 2 + size[0] / 2, y, z]),
    });
    append(own.mesh, one.mesh);
    own.edges.push(...one.edges);
  }
  return own;
}

function halfTurned(outline: Outline, length: number, bore: Outline, depth: number, look: Look): Part {
  const own: Part = { mesh: mesh(), edges: [] };
  walls(own.mesh, outline, 0, length, 1, look, true);
  walls(own.mesh, bore, 0, depth, -1, look, true);
  const halves = (contour: Outline, at: number): Vec2[] => half(contour.at(at));
  disc(own.mesh, halves(outline, length), -length, look, [0, 0, -1], false);
  disc(own.mesh, halves(bore, depth), -depth, look, UP, false);
  strip(own.mesh, halves(bore, 0), halves(outline, 0), 0, false, look);
  for (const end of [0, HALF_POINTS]) own.edges.push(...cutFace(own.mesh, outline, length, bore, depth, end, look));
  for (const [contour, at] of [
    [outline, 0],
    [outline, length],
    [bore, 0],
    [bore, depth],
  ] as const)
    own.edges.push(...chain(halves(contour, at), -at, look));
  return own;
}

const HALF_POINTS = CIRCLE_POINTS / 2;

/** The points of a circle's contour on the side of −Y, those on the X axis included. */
const half = (points: Vec2[]): Vec2[] =>
  Array.from({ length: HALF_POINTS + 1 }, (_, i) => points[(HALF_POINTS + i) % CIRCLE_POINTS]!);

/** One of the two faces of a half section: from the axis, or the bore, to the outside. Gives its edges. */
function cutFace(
  into: Mesh,
  outline: Outline,
  length: number,
  bore: Outline,
  depth: number,
  end: number,
  look: Look,
): Line[] {
  const outside = (z: number): Vec3 => at(outline.at(z)[end]!, -z);
  const inside = (z: number): Vec3 => at(bore.at(z)[end]!, -z);
  const cut: Vec3 = [0, 1, 0];
  for (let piece = 0; piece < look.pieces; piece++) {
    const [a, b] = [piece, piece + 1].map(k => (depth * k) / look.pieces) as [number, number];
    flat(into, [inside(a), outside(a), outside(b), inside(b)], cut, look.paint);
    const [c, d] = [piece, piece + 1].map(k => depth + ((length - depth) * k) / look.pieces) as [number, number];
    flat(into, [[0, 0, -c], outside(c), outside(d), [0, 0, -d]], cut, look.paint);
  }
  const corners = [
    outside(0),
    outside(length),
    [0, 0, -length] as Vec3,
    [0, 0, -depth] as Vec3,
    inside(depth),
    inside(0),
  ];
  return corners.flatMap((from, i): Line[] =>
    i === 2 ? [] : [{ from, to: corners[(i + 1) % corners.length]!, style: look.edge }],
  );
}

/**
 * Walls between two depths; `side` +1: solid inside the contour, −1: outside; of a circle perhaps the half on the side
 * of −Y.
 */
function walls(
  into: Mesh,
  outline: Outline,
  from: number,
  to: number,
  side: number,
  { paint, pieces }: Look,
  halved = false,
): void {
  for (let piece = 0; piece < pieces; piece++) {
    const [d0, d1] = [0, 1].map(end => from + ((to - from) * (piece + end)) / pieces) as [number, number];
    const [above, below] = [outline.at(d0), outline.at(d1)];
    const facing = normals(above, outline.smooth).map(([x, y]): Vec2 => [x * side, y * side]);
    if (outline.smooth) {
      const chosen = (points: Vec2[], z: number): Vec3[] => (halved ? half(points) : points).map(point => at(point, z));
      const outside = chosen(facing, 0);
      band(into, chosen(above, -d0), chosen(below, -d1), { upper: outside, lower: outside }, !halved, paint);
      continue;
    }
    facing.forEach((direction, i) => {
      const next = (i + 1) % above.length;
      const normal = at(direction, 0);
      quad(
        into,
        [at(above[i]!, -d0), at(above[next]!, -d0), at(below[next]!, -d1), at(below[i]!, -d1)],
        [normal, normal, normal, normal],
        paint,
      );
    });
  }
}

const UP: Vec3 = [0, 0, 1];

/** Flat face between two rows of as many points, facing up. */
function strip(into: Mesh, inner: Vec2[], outer: Vec2[], z: number, closed: boolean, { paint }: Look): void {
  const up = inner.map(() => UP);
  band(
    into,
    inner.map(point => at(point, z)),
    outer.map(point => at(point, z)),
    { upper: up, lower: up },
    closed,
    paint,
  );
}

/** Edges from point to point. */
const chain = (points: Vec2[], z: number, { edge }: Look): Line[] =>
  points.slice(1).map((to, i): Line => ({ from: at(points[i]!, z), to: at(to, z), style: edge }));

/** Flat face inside a contour, or half of one, facing up or as told. */
function disc(into: Mesh, points: Vec2[], z: number, { paint }: Look, facing: Vec3 = UP, closed = true): void {
  fan(
    into,
    [0, 0, z],
    points.map(point => at(point, z)),
    facing,
    closed,
    paint,
  );
}

/** A rectangular body between two heights, with or without its upper face. */
function block([x, y]: Vec2, top: number, bottom: number, look: Look, closed = true): Part {
  const into = mesh();
  const corners: Vec2[] = [
    [-x / 2, -y / 2],
    [x / 2, -y / 2],
    [x / 2, y / 2],
    [-x / 2, y / 2],
  ];
  corners.forEach((corner, i) => {
    const next = corners[(i + 1) % 4]!;
    const outside: Vec3 = [corner[0] + next[0], corner[1] + next[1], 0];
    flat(into, [at(corner, top), at(next, top), at(next, bottom), at(corner, bottom)], outside, look.paint);
  });
  const face = (z: number, outside: Vec3) =>
    flat(into, corners.map(corner => at(corner, z)) as [Vec3, Vec3, Vec3, Vec3], outside, look.paint);
  face(bottom, [0, 0, -1]);
  if (closed) strip(into, border([x / 8, y / 8]), border([x / 2, y / 2]), top, true, look);
  if (closed) disc(into, border([x / 8, y / 8]), top, look);
  const uprights = corners.map((corner): Line => ({ from: at(corner, top), to: at(corner, bottom), style: look.edge }));
  return { mesh: into, edges: [...loop(corners, top, look), ...loop(corners, bottom, look), ...uprights] };
}

/** A ball about the origin, with its equator as edge. */
function sphere(radius: number, look: Look): Part {
  const into = mesh();
  const point = (row: number, column: number): Vec3 => {
    const [down, turn] = [(row * Math.PI) / BALL_ROWS, (column * Math.PI) / BALL_ROWS];
    return [Math.sin(down) * Math.cos(turn), Math.sin(down) * Math.sin(turn), Math.cos(down)];
  };
  const rows = Array.from({ length: BALL_ROWS + 1 }, (_, row) =>
    Array.from({ length: 2 * BALL_ROWS }, (_, column) => point(row, column)),
  );
  rows.slice(1).forEach((lower, above) => {
    const upper = rows[above]!;
    const grown = (row: Vec3[]): Vec3[] => row.map(direction => times(direction, radius));
    band(into, grown(upper), grown(lower), { upper, lower }, true, look.paint);
  });
  const equator = Array.from({ length: 2 * BALL_ROWS }, (_, column): Vec2 => {
    const [x, y] = point(BALL_ROWS / 2, column);
    return [x * radius, y * radius];
  });
  return { mesh: into, edges: loop(equator, 0, look) };
}

function loop(points: Vec2[], z: number, { edge }: Look): Line[] {
  return points.map((point, i) => ({ from: at(point, z), to: at(points[(i + 1) % points.length]!, z), style: edge }));
}

/** Edges of a contour: both rims, and the uprights at its corners. */
function rims(outline: Outline, depth: number, look: Look): Line[] {
  const [upper, lower] = [outline.at(0), outline.at(depth)];
  const corners = outline.smooth ? [] : [0, 1, 2, 3].map(i => (i * upper.length) / 4);
  const uprights = corners.map((i): Line => ({ from: at(upper[i]!, 0), to: at(lower[i]!, -depth), style: look.edge }));
  return [...loop(upper, 0, look), ...loop(lower, -depth, look), ...uprights];
}

// Grooves and webs: one profile in X and Z, the same along Y

/** Closed profile, and convex pieces that fill it. */
interface Profile {
  outline: Vec2[];
  pieces: [Vec2, Vec2, Vec2, Vec2][];
}

function grooveProfile(width: number, depth: number, errors: Solid["errors"]): Profile {
  const [u, v] = [(width + errors.size) / 2, (width + errors.size + errors.taper * depth) / 2];
  const half = width / 2 + around([width / 2, width / 2]);
  const bottom = -depth - Math.max(4, 0.25 * depth);
  return {
    outline: [
      [-half, bottom],
      [half, bottom],
      [half, 0],
      [u, 0],
      [v, -depth],
      [-v, -depth],
      [-u, 0],
      [-half, 0],
    ],
    pieces: [
      [
        [u, 0],
        [half, 0],
        [half, -depth],
        [v, -depth],
      ],
      [
        [-u, 0],
        [-half, 0],
        [-half, -depth],
        [-v, -depth],
      ],
      [
        [-half, -depth],
        [half, -depth],
        [half, bottom],
        [-half, bottom],
      ],
    ],
  };
}

function webProfile(width: number, height: number, errors: Solid["errors"]): Profile {
  const [u, v] = [(width + errors.size) / 2, (width + errors.size + errors.taper * height) / 2];
  const half = width / 2 + around([width / 2, width / 2]);
  const bottom = -height - Math.max(3, 0.2 * height);
  return {
    outline: [
      [-half, bottom],
      [half, bottom],
      [half, -height],
      [v, -height],
      [u, 0],
      [-u, 0],
      [-v, -height],
      [-half, -height],
    ],
    pieces: [
      [
        [-u, 0],
        [u, 0],
        [v, -height],
        [-v, -height],
      ],
      [
        [-half, -height],
        [half, -height],
        [half, bottom],
        [-half, bottom],
      ],
    ],
  };
}

function extruded({ outline, pieces }: Profile, length: number, look: Look): Part {
  const own: Part = { mesh: mesh(), edges: [] };
  const h = length / 2;
  const point = ([x, z]: Vec2, y: number): Vec3 => [x, y, z];
  outline.forEach((from, i) => {
    const to = outline[(i + 1) % outline.length]!;
    const outside: Vec3 = [to[1] - from[1], 0, from[0] - to[0]];
    for (let k = 0; k < look.pieces; k++) {
      const [y0, y1] = [-h + (length * k) / look.pieces, -h + (length * (k + 1)) / look.pieces];
      flat(own.mesh, [point(from, y0), point(to, y0), point(to, y1), point(from, y1)], outside, look.paint);
    }
    own.edges.push({ from: point(from, -h), to: point(from, h), style: look.edge });
    for (const y of [-h, h]) own.edges.push({ from: point(from, y), to: point(to, y), style: look.edge });
  });
  for (const piece of pieces) {
    for (const y of [-h, h])
      flat(own.mesh, piece.map(p => point(p, y)) as [Vec3, Vec3, Vec3, Vec3], [0, y, 0], look.paint);
  }
  return own;
}
