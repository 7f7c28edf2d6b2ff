// What is written over the picture and where it stands: names, chips of the touches, the reading of a turning machine,
// the zeros that are out of sight, and the triad in the corner. None lies on another, nor on what covers the view.
import type { Drawn } from "../draw";
import type { Frame } from "./backend";
import { basis, type Projected, projector, type Viewport } from "./camera";
import { chipsOf } from "./chips";
import type { Colours } from "./colours";
import { type Label, readingText } from "./labels";
import { around, atBorder, placed, type Rect, type Spot, type Written } from "./places";
import type { Scene } from "./scene";
import { add, times } from "./vec";

/** Width of words, CSS pixels. */
export type Measure = (words: string) => number;

const HEIGHT = 14; // of a line of words
const BELOW = 18; // from an origin to its name
const BESIDE = 6; // from a place to the words that begin or end beside it
const READING = 26; // from the ring up to the reading, clear of a touched diameter
const REACH = 90; // words that would stand farther from their place are left out
const FAR = 34; // farther than that they have a line to it
const SMALLEST = 4; // radius of the ring around the ball

/** All that has room, with its spot; `taken`: what covers the view. */
export function arranged(
  scene: Scene,
  frame: Frame,
  taken: readonly Rect[],
  measure: Measure,
): { written: Written; spot: Spot }[] {
  const project = projector(frame.camera, frame.view);
  const there = scene.labels.filter(({ during }) => !during || (frame.time > during[0] && frame.time <= during[1]));
  const words = there
    .filter(({ number }) => number === undefined)
    .sort((a, b) => Number(b.lit ?? false) - Number(a.lit ?? false))
    .filter(({ origin }) => !origin || isSeen(project(origin), frame.view))
    .flatMap(label => nameOf(label, project(label.at), frame.view, scene.colours, measure) ?? []);
  const all = [
    triad(scene.colours, frame),
    ...reading(scene, frame, measure),
    ...words,
    ...chipsOf(there, scene, frame),
  ];
  const points = scene.touched.map(at => around(project(at), 6, 6));
  const spots = placed(all, frame.view, { always: taken, rather: [...heldBy(scene, frame), ...points] });
  return all.flatMap((written, i) => (spots[i] ? { written, spot: spots[i] } : []));
}

const isSeen = ({ x, y }: Spot, { width, height }: Viewport): boolean => x >= 0 && y >= 0 && x <= width && y <= height;

/** A name beside its place; of what is out of sight only a zero, at the border, and the dimension that stands out. */
function nameOf(label: Label, at: Projected, view: Viewport, colours: Colours, measure: Measure): Written | null {
  const { below, aside, beside, raised = 0, lit = false, zero, field } = label;
  const seen = isSeen(at, view);
  if (!seen && zero) return beyond(label, at, view, colours, measure);
  if (!seen && !lit) return null;
  const width = measure(label.text);
  const out = beside ? BESIDE + width / 2 : aside ? -BESIDE - width / 2 : 0;
  const best = { x: at.x + out, y: at.y + (below ? BELOW : -raised) };
  return {
    width,
    height: HEIGHT,
    spots: [best],
    reach: lit ? Infinity : REACH,
    draw: spot => [lettered(spot, label.text, label.colour, colours, field)],
    line: spot => (seen && Math.hypot(spot.x - best.x, spot.y - best.y) > FAR ? [leader(at, spot, label.colour)] : []),
  };
}

const leader = (from: Spot, to: Spot, colour: string): Drawn => ({
  tag: "path",
  attributes: { d: `M${from.x} ${from.y}L${to.x} ${to.y}`, stroke: colour, opacity: 0.5, fill: "none" },
});

const INSET = 24; // of the mark of a zero from the border
const ARROW = 14; // width of its arrow

/** A zero that is out of sight: an arrow towards it at the border, and its name. */
function beyond(label: Label, at: Projected, view: Viewport, colours: Colours, measure: Measure): Written {
  const width = ARROW + measure(label.text);
  const angle = (Math.atan2(at.y - view.height / 2, at.x - view.width / 2) * 180) / Math.PI;
  const best = atBorder(at, view, INSET);
  return {
    width,
    height: HEIGHT,
    spots: [best],
    reach: Infinity,
    draw({ x, y }) {
      const left = x - width / 2;
      return [
        {
          tag: "path",
          attributes: {
            d: "M-5 -4L5 0L-5 4Z",
            fill: label.colour,
            stroke: colours.background,
            "stroke-width": 2,
            "paint-order": "stroke",
            transform: `translate(${left + 5} ${y}) rotate(${angle})`,
          },
        },
        lettered({ x: left + ARROW + (width - ARROW) / 2, y }, label.text, label.colour, colours),
      ];
    },
  };
}

export const ringRadius = ({ tool, data: { view } }: Scene, scale: number): number =>
  tool && !tool.ball ? SMALLEST : Math.max(SMALLEST, view.probe.ball * scale + 1);

/** Where the control says that it stands, X as it counts there: above it, clear of what is touched below. */
function reading(scene: Scene, { camera, view, probe }: Frame, measure: Measure): Written[] {
  const { data, colours, drawing: shown } = scene;
  const { reading: counts } = data.view;
  if (!shown || !counts || !probe) return [];
  const { x, y, scale } = projector(camera, view)(probe);
  const words = readingText(counts, probe);
  const spots = [{ x, y: y - ringRadius(scene, scale) - READING }];
  const draw = (spot: Spot): Drawn[] => [lettered(spot, words, colours.text, colours)];
  return isSeen({ x, y }, view) ? [{ width: measure(words), height: HEIGHT, spots, reach: Infinity, draw }] : [];
}

const ROOM = 28; // kept free around the ball, CSS pixels
const BODY = 5.3; // half of the width of a probe body that is kept free, in radii of the ball
const STEP = 4; // from one place of the body to the next
const TALL = 28; // height of the body

/** What the ball and the body of the probe cover. */
function heldBy({ tool, data }: Scene, { camera, view, probe }: Frame): Rect[] {
  if (!probe) return [];
  const project = projector(camera, view);
  const axis = tool?.ball;
  const { ball, reach } = data.view.probe;
  const body = (up: number): Rect => {
    const at = project(add(probe, times(axis!, reach + up * ball)));
    return around(at, 2 * BODY * ball * at.scale, 2 * BODY * ball * at.scale);
  };
  const heights = Array.from({ length: TALL / STEP }, (_, i) => STEP * (i + 1));
  return [around(project(probe), ROOM, ROOM), ...(axis ? heights.map(body) : [])];
}

const CORNER = { x: 46, y: 44 }; // of the triad from the lower left corner
const ARM = 24;
const TIP = 10; // from the end of an arm to its letter
const SIDE = 2 * (ARM + TIP + 6);

/** The directions of the machine. */
function triad(colours: Colours, { camera, view }: Frame): Written {
  const { right, up, back } = basis(camera);
  const axes = (["X", "Y", "Z"] as const).map((name, i) => ({
    name,
    dx: right[i]!,
    dy: -up[i]!,
    near: back[i]!,
    colour: [colours.axisX, colours.axisY, colours.axisZ][i]!,
  }));
  axes.sort((a, b) => a.near - b.near);
  const arm = ({ x, y }: Spot, { name, dx, dy, colour }: (typeof axes)[number]): Drawn[] => {
    const end = { x2: x + ARM * dx, y2: y + ARM * dy };
    const attributes = { x1: x, y1: y, ...end, stroke: colour, "stroke-width": 2, "stroke-linecap": "round" };
    const tip = { x: x + (ARM + TIP) * dx, y: y + (ARM + TIP) * dy };
    const towards = Math.hypot(dx, dy) < 0.2;
    return [{ tag: "line", attributes }, ...(towards ? [] : [lettered(tip, name, colour, colours)])];
  };
  return {
    width: SIDE,
    height: SIDE,
    spots: [{ x: CORNER.x, y: view.height - CORNER.y }],
    reach: Infinity,
    draw: spot => axes.flatMap(axis => arm(spot, axis)),
  };
}

/** Words with their middle at a spot. */
function lettered({ x, y }: Spot, words: string, colour: string, colours: Colours, field?: string): Drawn {
  const attributes = {
    x,
    y,
    fill: colour,
    stroke: colours.background,
    "stroke-width": 3,
    "paint-order": "stroke",
    "stroke-linejoin": "round",
    "text-anchor": "middle",
    "dominant-baseline": "central",
    "font-size": 12,
    "font-weight": 600,
    ...(field && { "data-field": field }),
  };
  return { tag: "text", attributes, text: words };
}
