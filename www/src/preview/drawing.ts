// A turned part as on a drawing: its diameters before its front, those where it was touched, and the reading of the
// control.
import { fixed, signed } from "../numbers";
import type { Drawing, Trace, Vec3 } from "../wire";
import { type Colours, parse } from "./colours";
import type { Line, Style } from "./mesh";
import type { Label } from "./paths";
import { add, dot, sub, times, unit } from "./vec";

const FIRST = 0.14; // from the front to the first dimension line, from one to the next; share of the size of the scene
const NEXT = 0.12;
const OVER = 0.02; // what the lines at its ends stand out beyond it, and the length of an arrow
const ARROW = 0.3; // half of the width of an arrow, share of its length
const UP = [10, -4] as const; // CSS pixels from the upper end of a dimension line up to both lines of its text
const DOWN = [4, -10] as const; // and from the lower end
const ABOVE = 14; // from a touched point to its diameter
const EXACT = 5e-4; // mm; a smaller deviation is none

const text = (diameter: number): string => `Ø${fixed(diameter, 3)}`;

/** Dimension lines with the diameter as it is, below it the set one and the deviation; small ones next to the part. */
export function dimensions(
  trace: Trace,
  { diameters, touched }: Drawing,
  colours: Colours,
  size: number,
): { lines: Line[]; labels: Label[] } {
  const front = Math.max(...diameters.flatMap(({ ends, out }) => ends.map(end => dot(end, out))));
  const lines: Line[] = [];
  const labels: Label[] = touchLabels(trace, touched, colours);
  [...diameters]
    .sort((a, b) => a.real - b.real)
    .forEach(({ ends, out, set, real }, i) => {
      const place = front + (FIRST + i * NEXT) * size;
      const [low, high] = ends.map(end => add(end, times(out, place - dot(end, out)))) as [Vec3, Vec3];
      lines.push(...dimension(ends, [low, high], out, colours, OVER * size));
      const up = i % 2 === 0; // neighbours have their words at different ends
      const words = { at: up ? high : low, colour: colours.text, beside: true };
      labels.push({ ...words, text: text(real), raised: up ? UP[0] : DOWN[0] });
      const deviation = real - set;
      const exact = Math.abs(deviation) < EXACT;
      labels.push({
        ...words,
        text: exact ? `= ${text(set)}` : `${text(set)} ${signed(deviation, 3)}`,
        raised: up ? UP[1] : DOWN[1],
      });
    });
  return { lines, labels };
}

/** From both ends of a diameter to its dimension line, and this with its arrows. */
function dimension(ends: [Vec3, Vec3], [low, high]: [Vec3, Vec3], out: Vec3, colours: Colours, over: number): Line[] {
  const style: Style = { colour: parse(colours.text), width: 1.25, through: 0.5 };
  const line = (from: Vec3, to: Vec3): Line => ({ from, to, style });
  const along = unit(sub(high, low));
  const arrow = (tip: Vec3, back: Vec3): Line[] =>
    [ARROW, -ARROW].map(aside => line(tip, add(tip, add(times(back, over), times(out, aside * over)))));
  return [
    line(ends[0], add(low, times(out, over))),
    line(ends[1], add(high, times(out, over))),
    line(low, high),
    ...arrow(high, times(along, -1)),
    ...arrow(low, along),
  ];
}

/** The diameter at each touched point, until that point is touched again. */
function touchLabels({ entries }: Trace, touched: Drawing["touched"], colours: Colours): Label[] {
  const place = (entry: number): Vec3 | null => {
    const step = entries[entry];
    return step?.step === "touch" ? step.point : null;
  };
  const near = (a: Vec3 | null, b: Vec3 | null): boolean => !!a && !!b && Math.hypot(...sub(a, b)) < 1;
  return touched.flatMap(({ entry, diameter }, i): Label[] => {
    const at = place(entry);
    const again = touched.slice(i + 1).find(later => near(at, place(later.entry)));
    return at
      ? [{ at, text: text(diameter), colour: colours.touch, raised: ABOVE, during: [entry, again?.entry ?? Infinity] }]
      : [];
  });
}

/** X and Z of a position as the control shows them, X as a diameter where it counts so. */
export function readingText({ at, axes, diameter }: Drawing["reading"], position: Vec3): string {
  const [x, , z] = axes.map(axis => dot(sub(position, at), axis)) as Vec3;
  return `X ${diameter ? text(2 * x) : fixed(x, 3)}  Z ${fixed(z, 3)}`;
}
