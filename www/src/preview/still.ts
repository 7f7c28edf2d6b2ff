// The 3D view as a picture that stays, for paper: drawn once as SVG, in light colours, whatever the view on the screen
// does.
import type { SceneData } from "../core/scene";
import type { Cloud, Frame } from "./backend";
import { type Camera, fit, initial, turn, type Viewport } from "./camera";
import { type Colours, LIGHT } from "./colours";
import type { Say } from "./labels";
import { probeAt, toolAt } from "./motion";
import { drawOverlay, overlay } from "./overlay";
import { buildScene } from "./scene";
import { openSvg } from "./svg";

/** `step`: entry of the trace that is done last; `camera`: from where it is seen, else obliquely. */
export interface Still {
  data: SceneData;
  step: number;
  cloud: Cloud | null;
  drawing: boolean;
  camera: Camera | null;
  say: Say;
}

/** Draws into `host`; the colours are those that were taken. */
export function drawStill(
  host: HTMLElement,
  { data, step, cloud, drawing, camera, say }: Still,
  view: Viewport,
): Colours {
  const scene = buildScene(data, LIGHT, { index: step, drawing, say });
  const seen = camera ?? turn({ ...initial(), turning: data.view.turning }, "iso", toolAt(data, step)?.ball);
  const frame: Frame = {
    camera: fit(seen, view, scene.box),
    view,
    ratio: 1,
    time: step + 1,
    probe: probeAt(data, step, 1),
  };
  const backend = openSvg(host, { thinned: () => undefined });
  backend.setScene(scene, 1);
  backend.setCloud(cloud);
  backend.draw(frame);
  const letters = overlay(host);
  letters.setAttribute("viewBox", `0 0 ${view.width} ${view.height}`);
  drawOverlay(letters, scene, frame);
  return LIGHT;
}
