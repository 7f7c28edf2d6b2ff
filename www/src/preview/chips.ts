// The touches of the present call as chips: number, axis and value, each with a line to its point.
import type { Drawn } from "../draw";
import type { Frame } from "./backend";
import { projector } from "./camera";
import type { Colours } from "./colours";
import type { Label } from "./labels";
import { beside, type Spot, type Written } from "./places";

const HEIGHT = 22;
const BADGE = 18; // width of the number
const PAD = 6;
const LETTER = 7.3; // width of a letter of the fixed-width font
const CORNER = 4;

interface Chip {
  at: Spot;
  label: Label & { number: number };
  width: number;
  present: boolean; // the last one that was touched
}

const badgeOf = (number: number): number => Math.max(BADGE, 8 + LETTER * String(number).length);

/** Chips of the touches that are in sight, that of the last one first. */
export function chipsOf(labels: readonly Label[], { colours }: { colours: Colours }, frame: Frame): Written[] {
  const project = projector(frame.camera, frame.view);
  const { width, height } = frame.view;
  const shown = labels
    .filter((label): label is Chip["label"] => label.number !== undefined)
    .map(label => ({ label, at: project(label.at) }))
    .filter(({ at: { x, y } }) => x >= 0 && y >= 0 && x <= width && y <= height);
  const mean = (axis: "x" | "y"): number => shown.reduce((sum, { at }) => sum + at[axis], 0) / shown.length;
  const middle = { x: mean("x"), y: mean("y") };
  const last = Math.max(...shown.map(({ label }) => label.during?.[0] ?? 0));
  const chips = shown.map(({ label, at }): Chip => {
    const width = badgeOf(label.number) + 2 * PAD + LETTER * label.text.length;
    return { at, label, width, present: label.during?.[0] === last };
  });
  return chips
    .sort((a, b) => Number(b.present) - Number(a.present))
    .map(chip => ({
      width: chip.width,
      height: HEIGHT,
      spots: beside(chip.at, { x: chip.at.x - middle.x || 0.01, y: chip.at.y - middle.y || -1 }),
      reach: Infinity,
      draw: spot => drawChip(chip, spot, colours),
      line: spot => [lineTo(chip, spot, colours)],
    }));
}

const edgeOf = ({ present }: Chip, colours: Colours): string => (present ? colours.measuring : colours.chipEdge);

function lineTo(chip: Chip, { x, y }: Spot, colours: Colours): Drawn {
  const d = `M${chip.at.x} ${chip.at.y}L${x} ${y}`;
  const width = chip.present ? 1.5 : 1;
  return { tag: "path", attributes: { d, stroke: edgeOf(chip, colours), "stroke-width": width, fill: "none" } };
}

function drawChip(chip: Chip, { x, y }: Spot, colours: Colours): Drawn[] {
  const { label, width, present } = chip;
  const [left, top] = [Math.round(x - width / 2) + 0.5, Math.round(y - HEIGHT / 2) + 0.5];
  const badge = badgeOf(label.number);
  const words = { "dominant-baseline": "central", "font-size": 12, "font-weight": 600 };
  return [
    {
      tag: "rect",
      attributes: {
        x: left,
        y: top,
        width,
        height: HEIGHT,
        rx: CORNER + 2,
        fill: colours.chip,
        stroke: edgeOf(chip, colours),
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
