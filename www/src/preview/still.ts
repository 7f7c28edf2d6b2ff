// The 3D view as a picture that stays, for paper: drawn once in light colours, whatever the view on the screen does.

import type { SceneData } from "../core/scene";
import { el, svg } from "../dom";
import type { Vec3 } from "../wire";
import type { Cloud, Frame, GpuName } from "./backend";
import { type Camera, fit, initial, projector, turn, type Viewport } from "./camera";
import { type Colours, LIGHT } from "./colours";
import { openGpu } from "./gpu";
import type { Say } from "./labels";
import { probeAt, toolAt } from "./motion";
import { drawOverlay, overlay } from "./overlay";
import { buildScene, type Scene } from "./scene";
import { openSvg } from "./svg";

const FINE = 3; // pixels of a picture for a CSS pixel of the sheet
const PATIENCE = 10_000; // ms that a device has for it
const BALLOON = 9; // CSS pixels: half of a number in its circle

/** A number at a place of the machine. */
export interface Numbered {
  at: Vec3;
  text: string;
}

/** `step`: entry of the trace that is done last; `camera`: from where it is seen, else obliquely. */
export interface Still {
  data: SceneData;
  step: number;
  cloud: Cloud | null;
  drawing: boolean;
  camera: Camera | null;
  say: Say;
  marks?: readonly Numbered[]; // in the place of what else is written
}

function made({ data, step, drawing, camera, say }: Still, view: Viewport, ratio: number): [Scene, Frame] {
  const scene = buildScene(data, LIGHT, { index: step, drawing, say });
  const seen = camera ?? turn({ ...initial(), turning: data.view.turning }, "iso", toolAt(data, step)?.ball);
  return [scene, { camera: fit(seen, view, scene.box), view, ratio, time: step + 1, probe: probeAt(data, step, 1) }];
}

function letter(host: HTMLElement, scene: Scene, frame: Frame, marks: readonly Numbered[] = []): void {
  const letters = overlay(host);
  letters.setAttribute("viewBox", `0 0 ${frame.view.width} ${frame.view.height}`);
  if (marks.length) letters.append(...numbered(marks, frame));
  else drawOverlay(letters, scene, frame);
}

/** Numbers in circles; those that would lie upon each other stand beside each other. */
function numbered(marks: readonly Numbered[], { camera, view }: Frame): SVGElement[] {
  const project = projector(camera, view);
  const taken: { x: number; y: number }[] = [];
  return marks.map(({ at, text }) => {
    let { x, y } = project(at);
    while (taken.some(one => Math.hypot(one.x - x, one.y - y) < 2 * BALLOON)) x += 2 * BALLOON;
    taken.push({ x, y });
    const inside = { x, y: y + 3.5, "text-anchor": "middle", "font-size": 10, "font-weight": 600 };
    return svg(
      "g",
      { class: "numbered" },
      svg("circle", { cx: x, cy: y, r: BALLOON, fill: LIGHT.background, stroke: LIGHT.ball, "stroke-width": 1.5 }),
      svg("text", inside, text),
    );
  });
}

/** Draws into `host` as SVG, at once; the colours are those that were taken. */
export function drawStill(host: HTMLElement, still: Still, view: Viewport): Colours {
  const [scene, frame] = made(still, view, 1);
  const backend = openSvg(host, { thinned: () => undefined, trailed: () => undefined });
  backend.setScene(scene, 1);
  backend.setCloud(still.cloud);
  backend.draw(frame);
  letter(host, scene, frame, still.marks);
  return LIGHT;
}

/** The same as the stage draws it: by a device where the browser has one. `way`: that of the stage. */
export async function drawFine(host: HTMLElement, still: Still, view: Viewport, way: GpuName): Promise<void> {
  const [scene, frame] = made(still, view, FINE);
  let lost = (_: unknown): void => undefined;
  const failed = new Promise<never>((_, reject) => {
    lost = reject;
    setTimeout(reject, PATIENCE, new Error("no picture in time"));
  });
  const ignored = (): void => undefined;
  const unseen = el("div"); // holds its canvas
  const opening = openGpu(way, unseen, { lost, again: ignored, thinned: ignored, trailed: ignored, drawn: ignored });
  try {
    const backend = await Promise.race([opening, failed]);
    backend.setScene(scene, FINE);
    backend.setCloud(still.cloud);
    const blob = await Promise.race([backend.picture?.(frame), failed]);
    if (!blob) throw new Error("no picture");
    const image = el("img", { alt: "", src: URL.createObjectURL(blob) });
    await image.decode();
    URL.revokeObjectURL(image.src);
    host.append(image);
    letter(host, scene, frame);
  } finally {
    opening.then(
      backend => backend.destroy(),
      () => undefined,
    );
  }
}
