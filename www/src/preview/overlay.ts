// Letters over the picture: names of axes and coordinate systems, and the small triad in the corner.

import { svg } from "../dom";
import { type Drawn, drawInto } from "../draw";
import type { Frame } from "./backend";
import { basis, projector } from "./camera";
import { chipsOf, drawChip } from "./chips";
import type { Colours } from "./colours";
import { type Label, readingText } from "./labels";
import { around, near, placed, type Rect, type Spot, type Words } from "./places";
import type { Scene } from "./scene";
import { swept } from "./sweep";
import { add, times } from "./vec";

const CORNER = { x: 46, y: 44 }; // CSS pixels from the lower left corner
const ARM = 24;
const SMALLEST = 4; // radius of the ring around the ball
const BELOW = 18; // from an origin to its name
const BESIDE = 6; // from a place to the words that begin or end beside it
const READING = 26; // from the ring up to the reading, clear of a touched diameter

export function overlay(host: HTMLElement): SVGSVGElement {
  const element = svg("svg", { "aria-hidden": "true" });
  Object.assign(element.style, {
    position: "absolute",
    inset: "0",
    width: "100%",
    height: "100%",
    pointerEvents: "none",
  });
  host.append(element);
  return element;
}

/** `taken`: what covers the view, where no words should stand. */
export function drawOverlay(element: SVGSVGElement, scene: Scene, frame: Frame, taken: readonly Rect[] = []): void {
  drawInto(element, [
    ...swept(scene, frame),
    ...ring(scene, frame),
    ...names(element, scene, frame, taken),
    ...reading(scene, frame),
    ...triad(scene.colours, frame, taken),
  ]);
}

/** Tells where the ball or the end of a tool is, behind a part too. */
function ring(scene: Scene, { camera, view, probe }: Frame): Drawn[] {
  if (!probe) return [];
  const { tool } = scene;
  const { x, y, scale } = projector(camera, view)(tool ? add(probe, tool.tip) : probe);
  const r = ringRadius(scene, scale);
  const circle = (stroke: string, width: number): Drawn => ({
    tag: "circle",
    attributes: { cx: x, cy: y, r, fill: "none", stroke, "stroke-width": width },
  });
  return [circle(scene.colours.background, 3.5), circle(scene.colours.ball, 2)];
}

const ringRadius = ({ tool, data: { view } }: Scene, scale: number): number =>
  tool && !tool.ball ? SMALLEST : Math.max(SMALLEST, view.probe.ball * scale + 1);

/** Where the control says that it stands, X as it counts there: above it, clear of what is touched below. */
function reading(scene: Scene, { camera, view, probe }: Frame): Drawn[] {
  const { data, colours, drawing: shown } = scene;
  const { reading: counts } = data.view;
  if (!shown || !counts || !probe) return [];
  const { x, y, scale } = projector(camera, view)(probe);
  return [text(x, y - ringRadius(scene, scale) - READING, readingText(counts, probe), colours.text, colours)];
}

const HEIGHT = 14; // of a line of words
let brush: CanvasRenderingContext2D | null | undefined;
const widths = new Map<string, number>();

function widthOf(words: string, host: Element): number {
  const known = widths.get(words);
  if (known !== undefined) return known;
  brush ??= document.createElement("canvas").getContext("2d");
  if (brush) brush.font = `600 12px ${getComputedStyle(host).fontFamily || "sans-serif"}`;
  const width = brush?.measureText(words).width ?? 7 * words.length;
  widths.set(words, width);
  return width;
}

/** Names, and chips of the touches: none lies on another, on the ball, or on what covers the view. */
function names(host: Element, scene: Scene, frame: Frame, taken: readonly Rect[]): Drawn[] {
  const project = projector(frame.camera, frame.view);
  const there = scene.labels.filter(({ during }) => !during || (frame.time > during[0] && frame.time <= during[1]));
  const words = there.filter(({ number }) => number === undefined).map(label => named(label, project(label.at), host));
  const chips = chipsOf(there, frame);
  const held = heldBy(scene, frame);
  const points = scene.touched.map(at => around(project(at), 6, 6));
  const spots = placed([...words, ...chips], [...taken, ...held, ...points]);
  return [
    ...words.map(({ label }, i) => {
      const { attributes, ...drawn } = text(spots[i]!.x, spots[i]!.y, label.text, label.colour, scene.colours);
      return { ...drawn, attributes: { ...attributes, ...(label.field && { "data-field": label.field }) } };
    }),
    ...chips.flatMap((chip, i) => drawChip(chip, spots[words.length + i]!, scene.colours)),
  ];
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

/** A name with the places where it may stand. */
function named(label: Label, at: Spot, host: Element): Words & { label: Label } {
  const { below, aside, beside, raised = 0 } = label;
  const width = widthOf(label.text, host);
  const out = beside ? BESIDE + width / 2 : aside ? -BESIDE - width / 2 : 0;
  const spot = { x: at.x + out, y: at.y + (below ? BELOW : -raised) };
  return { label, width, height: HEIGHT, spots: near(spot, width, HEIGHT) };
}

function triad(colours: Colours, frame: Frame, taken: readonly Rect[]): Drawn[] {
  const { right, up, back } = basis(frame.camera);
  const y0 = frame.view.height - CORNER.y;
  const beside = taken.filter(({ left, bottom }) => left < 2 * CORNER.x && bottom > y0 - CORNER.y);
  const x0 = Math.max(0, ...beside.map(({ right }) => right)) + CORNER.x;
  const axes = (["X", "Y", "Z"] as const).map((name, i) => ({
    name,
    dx: right[i]!,
    dy: -up[i]!,
    near: back[i]!,
    colour: [colours.axisX, colours.axisY, colours.axisZ][i]!,
  }));
  return axes
    .sort((a, b) => a.near - b.near)
    .flatMap(({ name, dx, dy, colour }): Drawn[] => {
      const line: Drawn = {
        tag: "line",
        attributes: {
          x1: x0,
          y1: y0,
          x2: x0 + ARM * dx,
          y2: y0 + ARM * dy,
          stroke: colour,
          "stroke-width": 2,
          "stroke-linecap": "round",
        },
      };
      const towards = Math.hypot(dx, dy) < 0.2;
      return towards ? [line] : [line, text(x0 + (ARM + 10) * dx, y0 + (ARM + 10) * dy, name, colour, colours)];
    });
}

function text(x: number, y: number, words: string, colour: string, colours: Colours, anchor = "middle"): Drawn {
  const attributes = {
    x,
    y,
    fill: colour,
    stroke: colours.background,
    "stroke-width": 3,
    "paint-order": "stroke",
    "stroke-linejoin": "round",
    "text-anchor": anchor,
    "dominant-baseline": "central",
    "font-size": 12,
    "font-weight": 600,
  };
  return { tag: "text", attributes, text: words };
}
