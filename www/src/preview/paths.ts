// Motions, touches, coordinate systems and the grid as lines.
import type { FrameView, Step, ToolView, Trace, Vec3 } from "../wire";
import { type Colours, parse } from "./colours";
import type { Line, Style } from "./mesh";
import { along, type Motion, pieces } from "./route";
import { add, type Box, sub, times } from "./vec";

/** `below`: under its point on the screen, `aside`: to the left of it as well; both clear of others. `raised`: so many
 * CSS pixels above. `beside`: it
 *  begins there instead of standing over it. `during`: entries of the trace between which it is shown. */
export interface Label {
  at: Vec3;
  text: string;
  colour: string;
  below?: boolean;
  aside?: boolean;
  raised?: number;
  beside?: boolean;
  during?: readonly [number, number];
}

/** The name of a coordinate system in words. */
export type FrameWords = (frame: FrameView) => string;

const BEHIND = 0.42; // opacity of paths behind a part

function motionStyle(kind: Motion["kind"], colours: Colours): Style {
  switch (kind) {
    case "rapid":
      return { colour: parse(colours.rapid), width: 1.75, dash: 9, through: BEHIND };
    case "positioning":
      return { colour: parse(colours.positioning), width: 1.75, through: BEHIND };
    case "measuring":
      return { colour: parse(colours.measuring), width: 3.5, through: 0.6 };
    case "retract":
      return { colour: parse(colours.retract), width: 1.5, through: BEHIND };
  }
}

const point = (at: Vec3, style: Style): Line => ({ from: at, to: at, style });

/** Lines of one entry; `normal`: length of a normal in mm. */
function entryLines(step: Step, entry: number, colours: Colours, normal: number): Line[] {
  if (step.step === "motion") return motionLines(step, { ...motionStyle(step.kind, colours), entry });
  if (step.step === "touch") return touchLines(step, entry, colours, normal);
  if (step.step === "crash") {
    const later = { colour: parse(colours.crash), entry, unseenBefore: true, through: 1 };
    const tip = add(step.point, times(step.normal, normal));
    return [{ from: step.point, to: tip, style: { ...later, width: 3 } }, point(step.point, { ...later, width: 14 })];
  }
  return [];
}

function motionLines(motion: Motion, style: Style): Line[] {
  let [from, before] = [motion.from, 0];
  return pieces(motion).map(part => {
    const line = { from, to: along(motion, part), style: { ...style, during: [before, part] as const } };
    [from, before] = [line.to, part];
    return line;
  });
}

function touchLines(step: Extract<Step, { step: "touch" }>, entry: number, colours: Colours, normal: number): Line[] {
  const later = { entry, unseenBefore: true };
  const colour = parse(step.by ? colours.crash : colours.touch);
  const tip = add(step.point, times(step.normal, normal));
  return [
    { from: step.point, to: tip, style: { colour, width: 2, through: 0.6, ...later } },
    point(step.point, { colour: parse(colours.background), width: 10, through: 0.7, ...later }),
    point(step.point, { colour, width: 6.5, through: 0.8, ...later }),
  ];
}

const BLOCK = 300; // entries of a run

/** Of a long run the block of entries in which `index` lies, with one before it and one behind: the paths of the rest
 * would
 *  hide them, and take seconds to draw where there is no graphics card. Of a short run all. */
export function blockOf(index: number): number {
  return Math.floor(index / BLOCK);
}

/**
 * Paths around the entry `index`; every line knows its entry. What matters more lies over what matters less, points
 * over all.
 */
export function pathLines(trace: Trace, colours: Colours, normal: number, index = 0): Line[] {
  const first = Math.max(0, blockOf(index) - 1) * BLOCK;
  const shown = trace.entries.slice(first, first + 3 * BLOCK);
  const lines = shown.flatMap((step, place) => entryLines(step, first + place, colours, normal));
  const rank = ({ from, to, style }: Line) => (from === to ? Infinity : style.width);
  return lines.sort((a, b) => (rank(a) === rank(b) ? 0 : rank(a) - rank(b)));
}

/** What is in use at entry `index`. */
export function toolAt({ tools, inUse }: Trace, index: number): ToolView | undefined {
  const found = (inUse ?? []).findLast(([from], place) => place === 0 || from <= index);
  return found && tools?.[found[1]];
}

/** Where the centre of the ball is while entry `index` is done to `fraction`; null: no motion at all. Another length in
 *  effect since the last motion is another position, as the axes stand still. */
export function probeAt(trace: Trace, index: number, fraction: number): Vec3 | null {
  const { entries } = trace;
  const current = entries[index];
  if (current?.step === "motion") return along(current, Math.min(1, Math.max(0, fraction)));
  const before = entries.findLastIndex((entry, i) => i < index && entry.step === "motion");
  const nearest = before < 0 ? entries.findIndex(entry => entry.step === "motion") : before;
  const motion = entries[nearest];
  if (motion?.step !== "motion") return null;
  const lengths = [toolAt(trace, nearest), toolAt(trace, index)].map(tool => tool?.length ?? ([0, 0, 0] as Vec3)) as [
    Vec3,
    Vec3,
  ];
  return add(before < 0 ? motion.from : motion.to, sub(...lengths));
}

/** Axes of the coordinate systems, `length` mm long, dashed where a correction has moved them since. Those at one place
 * share
 *  a name. */
export function frameLines(
  frames: Trace["frames"],
  colours: Colours,
  length: number,
  words: FrameWords,
): { lines: Line[]; labels: Label[] } {
  const axes = [
    ["X", colours.axisX],
    ["Y", colours.axisY],
    ["Z", colours.axisZ],
  ] as const;
  const lines = frames.flatMap(({ at, axes: directions, moved }) => {
    const style = moved === "before" ? { width: 1.75, dash: 5, through: 0.45 } : { width: 2.5, through: 0.45 };
    return axes.map(
      ([, colour], i): Line => ({
        from: at,
        to: add(at, times(directions[i]!, length)),
        style: { colour: parse(colour), ...style },
      }),
    );
  });
  const now = frames.filter(({ moved }) => moved !== "before");
  const letters = now.flatMap(({ at, axes: directions }) =>
    axes.map(([text, colour], i): Label => ({ at: add(at, times(directions[i]!, 1.14 * length)), text, colour })),
  );
  const names = new Map<string, Label>();
  for (const frame of frames) {
    const place = JSON.stringify([frame.at, frame.axes]);
    const text = [names.get(place)?.text, words(frame)].filter(Boolean).join(", ");
    names.set(place, { at: frame.at, text, colour: colours.text, below: true, aside: true });
  }
  return { lines, labels: [...letters, ...names.values()] };
}

/** Spacing of a grid for a length: 1, 2 or 5 times a power of ten. */
export function gridSpacing(length: number): number {
  const rough = Math.max(length, 1e-6) / 10;
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * (([1, 2, 5] as const).find(step => step * power >= rough) ?? 10);
}

/**
 * Grid below a box, in the X-Y plane of the machine, lines on round coordinates; of a turning machine in the Z-Y plane.
 */
export function gridLines(box: Box, colour: string, turning = false): Line[] {
  const [across, along, up] = turning ? ([2, 1, 0] as const) : ([0, 1, 2] as const);
  const size = Math.max(box.max[across] - box.min[across], box.max[along] - box.min[along]);
  const spacing = gridSpacing(size);
  const range = (axis: 0 | 1 | 2) => {
    const low = Math.floor(box.min[axis] / spacing) - 2;
    const high = Math.ceil(box.max[axis] / spacing) + 2;
    return { low: low * spacing, high: high * spacing, count: high - low };
  };
  const [x, y, z] = [range(across), range(along), box.min[up]];
  const at = (first: number, second: number): Vec3 => (turning ? [z, second, first] : [first, second, z]);
  const style: Style = { colour: parse(colour), width: 1 };
  const columns = Array.from(
    { length: x.count + 1 },
    (_, i): Line => ({ from: at(x.low + i * spacing, y.low), to: at(x.low + i * spacing, y.high), style }),
  );
  const rows = Array.from(
    { length: y.count + 1 },
    (_, i): Line => ({ from: at(x.low, y.low + i * spacing), to: at(x.high, y.low + i * spacing), style }),
  );
  return [...columns, ...rows];
}
