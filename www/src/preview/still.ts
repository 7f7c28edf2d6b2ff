// The 3D view as a picture that stays, for paper: drawn once in light colours, whatever the view on the screen does.

import type { SceneData } from "../core/scene";
import { el } from "../dom";
import type { Cloud, Frame, GpuName } from "./backend";
import { type Camera, fit, initial, turn, type Viewport } from "./camera";
import { type Colours, LIGHT } from "./colours";
import { openGpu } from "./gpu";
import type { Say } from "./labels";
import { probeAt, toolAt } from "./motion";
import { drawOverlay, overlay } from "./overlay";
import { buildScene, type Scene } from "./scene";
import { openSvg } from "./svg";

const FINE = 3; // pixels of a picture for a CSS pixel of the sheet
const PATIENCE = 10_000; // ms that a device has for it

/** `step`: entry of the trace that is done last; `camera`: from where it is seen, else obliquely. */
export interface Still {
  data: SceneData;
  step: number;
  cloud: Cloud | null;
  drawing: boolean;
  camera: Camera | null;
  say: Say;
}

function made({ data, step, drawing, camera, say }: Still, view: Viewport, ratio: number): [Scene, Frame] {
  const scene = buildScene(data, LIGHT, { index: step, drawing, say });
  const seen = camera ?? turn({ ...initial(), turning: data.view.turning }, "iso", toolAt(data, step)?.ball);
  return [scene, { camera: fit(seen, view, scene.box), view, ratio, time: step + 1, probe: probeAt(data, step, 1) }];
}

function letter(host: HTMLElement, scene: Scene, frame: Frame): void {
  const letters = overlay(host);
  letters.setAttribute("viewBox", `0 0 ${frame.view.width} ${frame.view.height}`);
  drawOverlay(letters, scene, frame);
}

/** Draws into `host` as SVG, at once; the colours are those that were taken. */
export function drawStill(host: HTMLElement, still: Still, view: Viewport): Colours {
  const [scene, frame] = made(still, view, 1);
  const backend = openSvg(host, { thinned: () => undefined, trailed: () => undefined });
  backend.setScene(scene, 1);
  backend.setCloud(still.cloud);
  backend.draw(frame);
  letter(host, scene, frame);
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
