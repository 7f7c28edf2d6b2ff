// Over the picture: the way that ball and stylus sweep, the ring around the ball, and what is written.

import { svg } from "../dom";
import { type Drawn, drawInto } from "../draw";
import { type Arrow, arrowsIn } from "./arrows";
import type { Frame } from "./backend";
import { projector } from "./camera";
import { arranged, type Measure, ringRadius } from "./lettering";
import type { Rect } from "./places";
import type { Scene } from "./scene";
import { swept } from "./sweep";
import { add } from "./vec";

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

/** `taken`: what covers the view, where no words should stand; `arrows`: the longest first. */
export function drawOverlay(
  element: SVGSVGElement,
  scene: Scene,
  frame: Frame,
  taken: readonly Rect[] = [],
  arrows: readonly Arrow[] = [],
): void {
  const all = arranged(scene, frame, taken, measureIn(element));
  // In groups: what one gains leaves the others as they are.
  drawInto(element, [
    group(swept(scene, frame)),
    group(ring(scene, frame)),
    group(arrowsIn(arrows, scene, frame)),
    group(all.flatMap(({ written, spot }) => written.line?.(spot) ?? [])),
    ...all.map(({ written, spot }) => group(written.draw(spot))),
  ]);
}

const group = (children: Drawn[]): Drawn => ({ tag: "g", attributes: {}, children });

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

let brush: CanvasRenderingContext2D | null | undefined;
const widths = new Map<string, number>();

const measureIn =
  (host: Element): Measure =>
  words => {
    const known = widths.get(words);
    if (known !== undefined) return known;
    brush ??= document.createElement("canvas").getContext("2d");
    if (brush) brush.font = `600 12px ${getComputedStyle(host).fontFamily || "sans-serif"}`;
    const width = brush?.measureText(words).width ?? 7 * words.length;
    widths.set(words, width);
    return width;
  };
