// What is to be seen, for all ways of drawing: triangles, lines and labels made from a trace.
import type { Solid, ToolView, Trace, Vec3 } from "../wire";
import { type Colours, parse } from "./colours";
import { dimensions } from "./drawing";
import { append, boxOf, type Line, type Mesh, mesh } from "./mesh";
import { type FrameWords, frameLines, gridLines, type Label, pathLines, probeAt, toolAt } from "./paths";
import { along, pieces } from "./route";
import { part, zone } from "./solids";
import { addInUse, stylusReach } from "./stylus";
import { add, type Box, boxCorners, centre, include, length, sub } from "./vec";

export interface Scene {
  trace: Trace;
  colours: Colours;
  mesh: Mesh; // solid parts first
  solidCorners: number;
  lines: Line[];
  labels: Label[];
  tool: ToolView | undefined; // in use at this step
  reach: number; // of the stylus as drawn, from the centre of the ball, mm
  drawing: boolean; // diameters are shown as on a drawing
  box: Box; // what `fit` shows
  origin: Vec3; // subtracted before anything becomes single precision
  radius: number; // everything lies within it around the origin, mm
}

interface Turned {
  entry: number;
  solids: Solid[];
}
const turns = new WeakMap<Trace, Turned[]>();

/** Where rotary axes turn the part: looked for once, as the part is asked for in each frame. */
function turnsOf(trace: Trace): Turned[] {
  const known =
    turns.get(trace) ??
    trace.entries.flatMap((step, entry) => (step.step === "table" ? [{ entry, solids: step.solids }] : []));
  turns.set(trace, known);
  return known;
}

/** The part as it stands when entry `index` is done: a rotary axis turns it. */
export function standing(trace: Trace, index: number): Solid[] {
  return turnsOf(trace).findLast(({ entry }) => entry <= index)?.solids ?? trace.solids;
}

/** `solids`: the part as it stands. `pieces`: of a long face, for a way of drawing that needs it. `index`: the entry
 * around
 *  which paths are drawn. `drawing`: with the diameters of a turned part. `words`: of a coordinate system. */
export interface Shown {
  solids?: Solid[];
  pieces?: number;
  index?: number;
  drawing?: boolean;
  words?: FrameWords;
}

export function buildScene(
  trace: Trace,
  colours: Colours,
  { solids = trace.solids, pieces = 1, index = 0, drawing = false, words = ({ name }) => name }: Shown = {},
): Scene {
  const parts = [...solids, ...(trace.toolProbes ?? [])].map(solid =>
    part(solid, parse(solid.shape === "chuck" ? colours.stylus : colours.part), parse(colours.edge), pieces),
  );
  const all = mesh();
  for (const { mesh: own } of parts) append(all, own);
  const solidBox = boxOf(all);
  const ways = around(trace, solidBox);
  const size = length(sub(ways.max, ways.min));
  const limits = (trace.limits ?? []).flatMap(
    solid => part(solid, parse(colours.part), parse(colours.crash), pieces).edges,
  );
  const zones = (trace.zones ?? []).map(solid => zone(solid, parse(colours.zone), pieces));
  const moves = trace.entries.some(entry => entry.step === "motion");
  const touches = { ball: parse(colours.ball), stylus: parse(colours.stylus) };
  const tool = toolAt(trace, index);
  const first = all.used;
  const reach = stylusReach(trace.ball, 0.3 * size);
  const { solid: solidCorners, own } = moves
    ? addInUse(all, trace.ball, tool, touches, reach)
    : { solid: all.corners.length, own: first };
  const box = withTool(ways, tool && !tool.ball ? boxOf(all, first, own) : null, probeAt(trace, 0, 0));
  for (const { mesh: own } of zones) append(all, own);
  const dimensioned =
    drawing && trace.drawing ? dimensions(trace, trace.drawing, colours, size) : { lines: [], labels: [] };
  const frames = frameLines(trace.frames, colours, 0.14 * size, words);
  const normal = Math.max(
    2.5 * trace.ball.radius,
    Math.min(0.07 * size, ...solids.map(({ size }) => 0.5 * Math.max(...size))),
  );
  const lines: Line[] = [
    ...gridLines(solidBox ?? box, colours.grid, trace.turning),
    ...[...parts, ...zones].flatMap(({ edges }) => edges),
    ...limits.map((line): Line => ({ ...line, style: { ...line.style, dash: 6, through: 0.7 } })),
    ...frames.lines,
    ...dimensioned.lines,
    ...pathLines(trace, colours, normal, index),
  ];
  const shown = dimensioned.lines.flatMap(({ from, to }) => [from, to]).reduce(include, box);
  return {
    trace,
    colours,
    mesh: all,
    solidCorners,
    lines,
    labels: [...frames.labels, ...dimensioned.labels],
    tool,
    reach,
    drawing,
    box: shown,
    origin: centre(shown),
    radius: farthest(shown, lines, trace),
  };
}

const ROOM = 0.4; // around parts, in which paths are shown whole; share of their size
const LEAST_ROOM = 50; // mm
const NEAR = 1.4; // distance of a coordinate system that is shown whole, share of the size of what is there
const ALONE = 20; // room around coordinate systems where there is nothing else, mm

/** Parts, the paths near them and the origins of coordinate systems near those; all of these where nothing else is
 * there. Of
 *  a way that comes from far above, the part would be small. */
function around(trace: Trace, solids: Box | null): Box {
  let box = solids;
  const r = trace.ball.radius;
  const room = solids ? Math.max(LEAST_ROOM, ROOM * length(sub(solids.max, solids.min))) : Infinity;
  const inside = (p: Vec3): Vec3 =>
    solids
      ? (p.map((value, axis) => Math.min(solids.max[axis]! + room, Math.max(solids.min[axis]! - room, value))) as Vec3)
      : p;
  for (const entry of trace.entries) {
    if (entry.step !== "motion") continue;
    for (const [x, y, z] of [entry.from, ...pieces(entry).map(part => along(entry, part))]) {
      box = include(include(box, inside([x - r, y - r, z - r])), inside([x + r, y + r, z + r]));
    }
  }
  if (!box)
    return (
      trace.frames
        .flatMap(({ at: [x, y, z] }): Vec3[] => [
          [x - ALONE, y - ALONE, z - ALONE],
          [x + ALONE, y + ALONE, z + ALONE],
        ])
        .reduce(include, null as Box | null) ?? { min: [-ALONE, -ALONE, -ALONE], max: [ALONE, ALONE, ALONE] }
    );
  for (const { at } of trace.frames) if (near(box, at)) box = include(box, at);
  return box;
}

/** With a tool where the motions begin. What carries it may be cut off, and so may a stylus: the part is looked at. */
function withTool(box: Box, tool: Box | null, begin: Vec3 | null): Box {
  return tool && begin
    ? boxCorners(tool)
        .map(corner => add(corner, begin))
        .reduce(include, box)
    : box;
}

/** Hardly farther away than the box is large. */
function near(box: Box, at: Vec3): boolean {
  return length(sub(at, centre(box))) < NEAR * length(sub(box.max, box.min));
}

function farthest(box: Box, lines: Line[], trace: Trace): number {
  const origin = centre(box);
  const last = lines.reduce(
    (most, { from, to }) => Math.max(most, length(sub(from, origin)), length(sub(to, origin))),
    0,
  );
  return Math.max(last, length(sub(box.max, origin))) + trace.ball.length + 20 * trace.ball.radius;
}
