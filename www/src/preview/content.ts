// What is shown: a scene up to a step, in colours. A value; what is drawn is made of it.
import { NOTHING, type SceneData } from "../core/scene";
import type { Colours } from "./colours";
import type { Say } from "./labels";
import { blockOf, standingAt, toolIndexAt } from "./motion";
import { buildScene, type Scene } from "./scene";

export type { Say } from "./labels";

export interface Content {
  data: SceneData;
  colours: Colours;
  step: Step;
  drawing: boolean; // diameters of a turned part as on a drawing
  section: boolean; // the part is cut open
  focus: string | null; // parameter whose dimension stands out
}
/** Entry `index` of the trace is done to `fraction` (0 … 1). */
export interface Step {
  index: number;
  fraction: number;
}

export const EMPTY = NOTHING;

/** The last step: everything done. */
export function lastStep({ view: { entries } }: SceneData): Step {
  return { index: Math.max(0, entries - 1), fraction: 1 };
}

/** One scene shows both steps: the same block, the part stands as it did, with the same tool. */
export function sameScene(data: SceneData, a: Step, b: Step): boolean {
  return (
    blockOf(a.index) === blockOf(b.index) &&
    standingAt(data, a.index).place === standingAt(data, b.index).place &&
    toolIndexAt(data, a.index) === toolIndexAt(data, b.index)
  );
}

export function sceneOf({ data, colours, step, drawing, section, focus }: Content, say: Say | undefined): Scene {
  return buildScene(data, colours, { index: step.index, drawing, section, focus, ...(say && { say }) });
}
