// Letters over the picture: names of axes and coordinate systems, and the small triad in the corner.
import { basis, projector } from "./camera";
import type { Frame } from "./backend";
import type { Colours } from "./colours";
import type { Scene } from "./scene";

const SVG = "http://www.w3.org/2000/svg";
const CORNER = { x: 46, y: 76 }; // CSS pixels from the lower left corner, above the line of the step
const ARM = 24;

export function overlay(host: HTMLElement): SVGSVGElement {
  const element = document.createElementNS(SVG, "svg");
  element.setAttribute("aria-hidden", "true");
  Object.assign(element.style, { position: "absolute", inset: "0", width: "100%", height: "100%", pointerEvents: "none" });
  host.append(element);
  return element;
}

export function drawOverlay(element: SVGSVGElement, scene: Scene, frame: Frame): void {
  const project = projector(frame.camera, frame.view);
  const names = scene.labels.map(({ at, text: words, colour }) => {
    const { x, y } = project(at);
    return text(x, y, words, colour, scene.colours);
  });
  element.replaceChildren(...names, ...triad(scene.colours, frame));
}

function triad(colours: Colours, frame: Frame): SVGElement[] {
  const { right, up, back } = basis(frame.camera);
  const [x0, y0] = [CORNER.x, frame.view.height - CORNER.y];
  const axes = (["X", "Y", "Z"] as const).map((name, i) => ({ name, dx: right[i]!, dy: -up[i]!, near: back[i]!, colour: [colours.axisX, colours.axisY, colours.axisZ][i]! }));
  return axes.sort((a, b) => a.near - b.near).flatMap(({ name, dx, dy, colour }) => {
    const line = make("line", { x1: x0, y1: y0, x2: x0 + ARM * dx, y2: y0 + ARM * dy, stroke: colour, "stroke-width": 2, "stroke-linecap": "round" });
    const towards = Math.hypot(dx, dy) < 0.2;
    return towards ? [line] : [line, text(x0 + (ARM + 10) * dx, y0 + (ARM + 10) * dy, name, colour, colours)];
  });
}

function text(x: number, y: number, words: string, colour: string, colours: Colours): SVGElement {
  const element = make("text", {
    x, y, fill: colour, stroke: colours.background, "stroke-width": 3, "paint-order": "stroke", "stroke-linejoin": "round",
    "text-anchor": "middle", "dominant-baseline": "central", "font-size": 12, "font-weight": 600,
  });
  element.style.fontFamily = "inherit";
  element.textContent = words;
  return element;
}

function make(name: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  return element;
}
