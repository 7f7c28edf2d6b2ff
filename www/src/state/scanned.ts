// What is kept of a scan, and which of its points are shown.

import type { SceneData } from "../core/scene";
import type { ScanRequest, ScanView } from "../wire";

/** Which points: those that are sent, or those of the surface under the ball. */
export type Shown = "sent" | "surface";
/** `shown`: which points are chosen; drawn are those of `of`, as soon as they are there. */
export interface Scanned {
  request: ScanRequest;
  view: ScanView;
  scene: SceneData;
  clouds: Partial<Record<Shown, Float32Array>>;
  of: Shown;
  shown: Shown;
}
