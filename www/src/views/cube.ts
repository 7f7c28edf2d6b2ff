// The cube that shows from where the part is seen: its faces are the standard views, a drag turns the part with it.

import { el, on } from "../dom";
import type { Camera, ViewName } from "../preview/view";
import { t } from "../texts";

const FACES: ViewName[] = ["top", "front", "right", "back", "left", "bottom"];
const HALF = 24; // CSS pixels

type Axis = readonly [number, number, number];
/** What of the preview the cube needs. */
export interface Turned {
  setView(name: ViewName): void;
  turn(dx: number, dy: number): void;
  /** Directions of a standard view, and of what is seen now: to the right and up, and towards the viewer. */
  basisOf(name: ViewName | null): { right: Axis; up: Axis; back: Axis };
}

const dot = (a: Axis, b: Axis): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export function createCube(preview: Turned): { root: HTMLElement; draw(camera: Camera): void } {
  const root = el("div", { class: "view-cube", role: "group", "aria-label": t("view-cube") });
  const faces = FACES.map(name => {
    const words = t(`view-${name}`);
    const button = el("button", { type: "button", class: "cube-face", title: words }, words);
    on(button, "click", () => preview.setView(name));
    root.append(button);
    return { name, button };
  });
  drag(root, preview);
  return {
    root,
    draw() {
      const { right, up, back } = preview.basisOf(null);
      const seen = (way: Axis): Axis => [dot(way, right), -dot(way, up), dot(way, back)];
      for (const { name, button } of faces) {
        const own = preview.basisOf(name);
        const [x, y, z] = [seen(own.right), seen(own.up), seen(own.back)];
        const shown = z[2] > 0.06;
        const shift = z.map(part => part * HALF);
        const numbers = [...x, 0, ...y.map(part => -part), 0, ...z, 0, ...shift, 1];
        button.style.transform = `matrix3d(${numbers.map(number => number.toFixed(4)).join(",")})`;
        // what has the focus keeps it, so that the keyboard is not lost while the cube turns
        button.style.visibility = shown || button === document.activeElement ? "visible" : "hidden";
        button.style.opacity = shown ? "1" : "0";
        button.dataset.lit = z[2] > 0.9 ? "yes" : "no";
      }
    },
  };
}

const CLICK = 4; // CSS pixels that a click may wander

function drag(root: HTMLElement, preview: Turned): void {
  let last: { x: number; y: number } | null = null;
  let wandered = 0;
  root.addEventListener("pointerdown", event => {
    last = { x: event.clientX, y: event.clientY };
    wandered = 0;
  });
  root.addEventListener("pointermove", event => {
    if (!last || event.buttons === 0) return;
    const [dx, dy] = [event.clientX - last.x, event.clientY - last.y];
    wandered += Math.abs(dx) + Math.abs(dy);
    if (wandered < CLICK) return;
    root.setPointerCapture(event.pointerId);
    last = { x: event.clientX, y: event.clientY };
    preview.turn(dx, dy);
  });
  root.addEventListener("pointerup", () => {
    last = null;
  });
  root.addEventListener(
    "click",
    event => {
      if (wandered >= CLICK) event.stopPropagation();
    },
    true,
  );
}
