// A touch flashes once when the probe comes to it.
import { svg } from "../dom";
import type { Spot } from "./places";

const LONG = 300; // ms
const RADIUS = 18;

export function flash(host: Element, { x, y }: Spot, colour: string): void {
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  const ring = svg("circle", { cx: x, cy: y, r: RADIUS, fill: "none", stroke: colour, "stroke-width": 4 });
  Object.assign(ring.style, { transformBox: "fill-box", transformOrigin: "center" });
  const layer = svg("svg", { "aria-hidden": "true" }, ring);
  Object.assign(layer.style, {
    position: "absolute",
    inset: "0",
    width: "100%",
    height: "100%",
    pointerEvents: "none",
  });
  host.append(layer);
  const ways = [
    { transform: "scale(0.3)", opacity: 1 },
    { transform: "scale(1.4)", opacity: 0 },
  ];
  ring.animate(ways, { duration: LONG, easing: "ease-out" }).finished.finally(() => layer.remove());
}
