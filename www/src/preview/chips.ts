// The touches of the present call as chips: number, axis and value, each with a line to its point.
import type { Drawn } from "../draw";
import type { Frame } from "./backend";
import { projector } from "./camera";
import type { Colours } from "./colours";
import type { Label } from "./labels";
import { beside, type Spot, type Words } from "./places";

const HEIGHT = 22;
const BADGE = 18; // width of the number
const PAD = 6;
const LETTER = 7.3; // width of a letter of the fixed-width font
const CORNER = 4;

export interface Chip extends Words {
  at: Spot;
  label: Label & { number: number };
  present: boolean; // the last one that was touched
}

const badgeOf = (number: number): number => Math.max(BADGE, 8 + LETTER * String(number).length);

/** Chips that are there now, those farthest out first. */
export function chipsOf(labels: readonly Label[], frame: Frame): Chip[] {
  const project = projector(frame.camera, frame.view);
  const shown = labels.filter((label): label is Chip["label"] => label.number !== undefined);
  const places = shown.map(({ at }) => project(at));
  const middle = (axis: "x" | "y"): number => places.reduce((sum, place) => sum + place[axis], 0) / places.length;
  const last = Math.max(...shown.map(({ during }) => during?.[0] ?? 0));
  return shown.map((label, i) => {
    const at = places[i]!;
    const width = badgeOf(label.number) + 2 * PAD + LETTER * label.text.length;
    const away = { x: at.x - middle("x") || 0.01, y: at.y - middle("y") || -1 };
    const size = { left: -width / 2 - 4, right: width / 2 + 4, top: -HEIGHT / 2 - 4, bottom: HEIGHT / 2 + 4 };
    return {
      at,
      label,
      width,
      height: HEIGHT,
      present: label.during?.[0] === last,
      spots: beside(at, away, frame.view, size),
    };
  });
}

export function drawChip({ at, label, width, present }: Chip, { x, y }: Spot, colours: Colours): Drawn[] {
  const [left, top] = [Math.round(x - width / 2) + 0.5, Math.round(y - HEIGHT / 2) + 0.5];
  const badge = badgeOf(label.number);
  const edge = present ? colours.measuring : colours.chipEdge;
  const words = { "dominant-baseline": "central", "font-size": 12, "font-weight": 600 };
  return [
    {
      tag: "path",
      attributes: { d: `M${at.x} ${at.y}L${x} ${y}`, stroke: edge, "stroke-width": present ? 1.5 : 1, fill: "none" },
    },
    {
      tag: "rect",
      attributes: {
        x: left,
        y: top,
        width,
        height: HEIGHT,
        rx: CORNER + 2,
        fill: colours.chip,
        stroke: edge,
        "stroke-width": present ? 2 : 1,
      },
    },
    {
      tag: "rect",
      attributes: {
        x: left + 2,
        y: top + 2,
        width: badge,
        height: HEIGHT - 4,
        rx: CORNER,
        fill: present ? colours.measuring : colours.chipNumber,
      },
    },
    {
      tag: "text",
      attributes: {
        ...words,
        x: left + 2 + badge / 2,
        y: top + HEIGHT / 2,
        fill: present ? colours.chipPresent : colours.chipInk,
        "text-anchor": "middle",
      },
      text: String(label.number),
    },
    {
      tag: "text",
      attributes: {
        ...words,
        class: "chip-value",
        x: left + badge + PAD + 2,
        y: top + HEIGHT / 2,
        fill: colours.text,
      },
      text: label.text,
    },
  ];
}
