// The 3D view as a picture that stays, for paper: drawn once as SVG, in light colours, whatever the view on the screen
// does.
import type { Trace } from "../wire";
import type { Cloud, Frame } from "./backend";
import { type Camera, fit, initial, turn, type Viewport } from "./camera";
import { type Collision, collisionLabels } from "./collisions";
import { type Colours, LIGHT } from "./colours";
import { drawOverlay, overlay } from "./overlay";
import { type FrameWords, probeAt, toolAt } from "./paths";
import { buildScene, standing } from "./scene";
import { SORTED_PIECES } from "./solids";
import { openSvg } from "./svg";

/** `step`: entry of the trace that is done last; `camera`: from where it is seen, else obliquely. */
export interface Still {
  trace: Trace;
  step: number;
  cloud: Cloud | null;
  drawing: boolean;
  camera: Camera | null;
  words: { collision(found: Collision): string; frame: FrameWords };
}

/** Draws into `host`; the colours are those that were taken. */
export function drawStill(
  host: HTMLElement,
  { trace, step, cloud, drawing, camera, words }: Still,
  view: Viewport,
): Colours {
  const built = buildScene(trace, LIGHT, {
    solids: standing(trace, step),
    pieces: SORTED_PIECES,
    index: step,
    drawing,
    words: words.frame,
  });
  const scene = { ...built, labels: [...built.labels, ...collisionLabels(trace, LIGHT, words.collision)] };
  const seen = camera ?? turn({ ...initial(), turning: trace.turning ?? false }, "iso", toolAt(trace, step)?.ball);
  const frame: Frame = {
    camera: fit(seen, view, scene.box),
    view,
    ratio: 1,
    time: step + 1,
    probe: probeAt(trace, step, 1),
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
