// Colours, widths and dashes of what is drawn.
import type { LineKind, Matter } from "../core/scene";
import { type Colours, parse, type Rgba } from "./colours";
import type { Style } from "./mesh";

const BEHIND = 0.42; // opacity of paths behind a part
const THROUGH: Partial<Record<Matter, number>> = { zone: 0.22, body: 0.4, carrier: 0.35 }; // else nothing shows through

const INK: Record<Matter, keyof Colours> = {
  part: "part",
  cut: "part",
  chuck: "stylus",
  ball: "ball",
  stylus: "stylus",
  body: "stylus",
  carrier: "stylus",
  zone: "zone",
};

export function colourOf(matter: Matter, colours: Colours): Rgba {
  const [red, green, blue, alpha] = parse(colours[INK[matter]]);
  return [red, green, blue, THROUGH[matter] ?? alpha];
}

export const isClear = (matter: Matter): boolean => THROUGH[matter] !== undefined;

const AXIS = { width: 2.5, through: 0.45 };
const BEFORE = { width: 1.75, dash: 5, through: 0.45 };
/** In the order in which they are drawn. */
const LINES: Record<LineKind, Omit<Style, "colour"> & { ink: keyof Colours }> = {
  grid: { ink: "grid", width: 1 },
  edge: { ink: "edge", width: 1.25, through: 0.16 },
  zone: { ink: "zone", width: 1.5, dash: 7, through: 0.5 },
  limit: { ink: "crash", width: 1.25, dash: 6, through: 0.7 },
  axisX: { ink: "axisX", ...AXIS },
  axisY: { ink: "axisY", ...AXIS },
  axisZ: { ink: "axisZ", ...AXIS },
  beforeX: { ink: "axisX", ...BEFORE },
  beforeY: { ink: "axisY", ...BEFORE },
  beforeZ: { ink: "axisZ", ...BEFORE },
  dimension: { ink: "text", width: 1.25, through: 0.5 },
  size: { ink: "text", width: 1.25, through: 0.5 },
  anchor: { ink: "text", width: 1.25, through: 0.5 },
};
const ORDER = Object.keys(LINES);

export const rankOf = (kind: LineKind): number => ORDER.indexOf(kind);

/** `lit`: it belongs to the focused field. */
export function lineStyle(kind: LineKind, colours: Colours, lit: boolean): Style {
  const { ink, ...style } = LINES[kind];
  return lit ? { colour: parse(colours.lit), width: 2.5, through: 0.8 } : { colour: parse(colours[ink]), ...style };
}

/** By the number that the core gives a kind of motion. */
export function wayStyles(colours: Colours): Style[] {
  return [
    { colour: parse(colours.rapid), width: 1.75, dash: 9, through: BEHIND },
    { colour: parse(colours.positioning), width: 1.75, through: BEHIND },
    { colour: parse(colours.measuring), width: 3.5, through: 0.6 },
    { colour: parse(colours.retract), width: 1.5, through: BEHIND },
  ];
}

/** Styles of a touch by its sort: of its normal, and of the points drawn there, one over the other. */
export function touchStyles(colours: Colours): { normal: Style; points: Style[] }[] {
  const later = { unseenBefore: true };
  const ground = parse(colours.background);
  const touch = (ink: string) => ({
    normal: { colour: parse(ink), width: 2, through: 0.6, ...later },
    points: [
      { colour: ground, width: 10, through: 0.7, ...later },
      { colour: parse(ink), width: 6.5, through: 0.8, ...later },
    ],
  });
  const crash = { colour: parse(colours.crash), through: 1, ...later };
  return [
    touch(colours.touch),
    touch(colours.crash),
    { normal: { ...crash, width: 3 }, points: [{ ...crash, width: 14 }] },
  ];
}
