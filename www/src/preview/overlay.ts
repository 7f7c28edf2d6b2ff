// Letters over the picture: names of axes and coordinate systems, and the small triad in the corner.

import { svg } from "../dom";
import { type Drawn, drawInto } from "../draw";
import type { Frame } from "./backend";
import { basis, projector } from "./camera";
import type { Colours } from "./colours";
import { readingText } from "./labels";
import type { Scene } from "./scene";
import { swept } from "./sweep";
import { add } from "./vec";

const CORNER = { x: 46, y: 44 }; // CSS pixels from the lower left corner
const ARM = 24;
const SMALLEST = 4; // radius of the ring around the ball
const BELOW = 18; // from an origin to its name
const LINE = 14; // from one name to the next
const BESIDE = 6; // from a place to the words that begin or end beside it
const READING = 26; // from the ring up to the reading, clear of a touched diameter
const NEAR = 80; // names that are closer than this side by side would touch

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

export function drawOverlay(element: SVGSVGElement, scene: Scene, frame: Frame): void {
  drawInto(element, [
    ...swept(scene, frame),
    ...ring(scene, frame),
    ...names(scene, frame),
    ...reading(scene, frame),
    ...triad(scene.colours, frame),
  ]);
}

/** Tells where the ball or the end of a tool is, behind a part too. */
function ring(scene: Scene, { camera, view, probe }: Frame): Drawn[] {
  if (!probe) return [];
  const { tool } = scene;
  const { x, y } = projector(camera, view)(tool ? add(probe, tool.tip) : probe);
  const r = ringRadius(scene, camera.scale);
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
  const { x, y } = projector(camera, view)(probe);
  return [text(x, y - ringRadius(scene, camera.scale) - READING, readingText(counts, probe), colours.text, colours)];
}

/** One below the other where several coordinate systems have their origins at one place. */
function names(scene: Scene, frame: Frame): Drawn[] {
  const project = projector(frame.camera, frame.view);
  const taken: { x: number; y: number }[] = [];
  const there = scene.labels.filter(({ during }) => !during || (frame.time > during[0] && frame.time <= during[1]));
  return there.map(({ at, text: words, colour, below, aside, beside, raised = 0, field }) => {
    const place = project(at);
    const spot = { x: place.x + (beside ? BESIDE : aside ? -BESIDE : 0), y: place.y + (below ? BELOW : -raised) };
    while (below && taken.some(({ x, y }) => Math.abs(x - spot.x) < NEAR && Math.abs(y - spot.y) < LINE))
      spot.y += LINE;
    if (below) taken.push(spot);
    const anchor = beside ? "start" : aside ? "end" : "middle";
    const { attributes, ...drawn } = text(spot.x, spot.y, words, colour, scene.colours, anchor);
    return { ...drawn, attributes: { ...attributes, ...(field && { "data-field": field }) } };
  });
}

function triad(colours: Colours, frame: Frame): Drawn[] {
  const { right, up, back } = basis(frame.camera);
  const [x0, y0] = [CORNER.x, frame.view.height - CORNER.y];
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
