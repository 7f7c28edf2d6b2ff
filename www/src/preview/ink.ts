// Colours, widths and dashes of what is drawn.
import type { LineKind, Matter } from "../core/scene";
import { type Colours, parse, type Rgba } from "./colours";
import type { Style } from "./mesh";

const BEHIND = 0.42; // opacity of paths behind a part

/**
 * How light plays on a surface: the numbers of web/preview/src/layout.rs. Only what is of the part itself is cut open.
 */
export const Finish = { flat: 0, part: 1, metal: 2, satin: 3, ceramic: 4, ruby: 5, luminous: 6 };

/** When it hides nothing: `stands`, `moves`: it fades while it would hide what is measured; `clear`: seen through. */
export type Layer = "solid" | "stands" | "moves" | "clear";
export const LAYERS: Layer[] = ["solid", "stands", "moves", "clear"];

const LOOKS: Record<Matter, { ink: keyof Colours; finish: keyof typeof Finish; layer: Layer; through?: number }> = {
  part: { ink: "part", finish: "part", layer: "solid" },
  cut: { ink: "part", finish: "part", layer: "solid" },
  chuck: { ink: "chuck", finish: "metal", layer: "stands" },
  ball: { ink: "ball", finish: "ruby", layer: "solid" },
  stem: { ink: "stem", finish: "ceramic", layer: "solid" },
  stylus: { ink: "stylus", finish: "metal", layer: "solid" },
  body: { ink: "body", finish: "satin", layer: "moves" },
  ring: { ink: "ring", finish: "luminous", layer: "moves" },
  carrier: { ink: "stylus", finish: "metal", layer: "moves" },
  zone: { ink: "zone", finish: "flat", layer: "clear", through: 0.22 },
};

export function colourOf(matter: Matter, colours: Colours): Rgba {
  const { ink, through } = LOOKS[matter];
  const [red, green, blue, alpha] = parse(colours[ink]);
  return [red, green, blue, through ?? alpha];
}

export const finishOf = (matter: Matter): number => Finish[LOOKS[matter].finish];
export const layerOf = (matter: Matter): Layer => LOOKS[matter].layer;

const AXIS = { width: 2.5, through: 0.45 };
const BEFORE = { width: 1.75, dash: 5, through: 0.45 };
/** In the order in which they are drawn. */
const LINES: Record<LineKind, Omit<Style, "colour"> & { ink: keyof Colours }> = {
  grid: { ink: "grid", width: 1, onGround: true },
  edge: { ink: "edge", width: 1, cut: true },
  zone: { ink: "zone", width: 1.5, dash: 7, through: 0.5 },
  limit: { ink: "crash", width: 1.25, dash: 6, through: 0.7 },
  nominal: { ink: "nominal", width: 1.75, dash: 9, through: 0.55 },
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
    { colour: parse(colours.rapid), width: 2.25, dash: 9, through: BEHIND },
    { colour: parse(colours.positioning), width: 3, through: BEHIND, tube: true },
    { colour: parse(colours.measuring), width: 5, through: 0.6, tube: true },
    { colour: parse(colours.retract), width: 2.25, through: BEHIND, tube: true },
  ];
}

const PALE = 0.65; // of the whole path, so that the motions around the step stand out

/** Colours of the whole path, by kind of motion. */
export function trailColours(colours: Colours): Rgba[] {
  const ground = parse(colours.background);
  return wayStyles(colours).map(({ colour }) => mixed(ground, colour, PALE));
}

const mixed = (from: Rgba, to: Rgba, part: number): Rgba =>
  from.map((value, i) => value + part * (to[i]! - value)) as Rgba;

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
