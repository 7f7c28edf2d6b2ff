// What is shown: a trace up to a step, in colours. A value; the scene is made of it.
import type { Trace } from "../wire";
import type { BackendName } from "./backend";
import { type Collision, collisionLabels } from "./collisions";
import type { Colours } from "./colours";
import { blockOf, type FrameWords, toolAt } from "./paths";
import { buildScene, type Scene, standing } from "./scene";
import { SORTED_PIECES } from "./solids";

export interface Content {
  trace: Trace;
  colours: Colours;
  step: Step;
  drawing: boolean; // diameters of a turned part as on a drawing
}
/** Entry `index` of the trace is done to `fraction` (0 … 1). */
export interface Step {
  index: number;
  fraction: number;
}
/** Words beside what is drawn. */
export interface Words {
  collision?(found: Collision): string; // beside what must not touch and did
  frame?: FrameWords; // beside a coordinate system
}

export const EMPTY: Trace = { entries: [], ball: { radius: 3, length: 100 }, solids: [], frames: [] };

/** The last step of a trace: everything done. */
export function lastStep({ entries }: Trace): Step {
  return { index: Math.max(0, entries.length - 1), fraction: 1 };
}

/** One scene shows both steps: the same block, the part stands as it did, with the same tool. */
export function sameScene(trace: Trace, a: Step, b: Step): boolean {
  return (
    blockOf(a.index) === blockOf(b.index) &&
    standing(trace, a.index) === standing(trace, b.index) &&
    toolAt(trace, a.index) === toolAt(trace, b.index)
  );
}

export function sceneOf({ trace, colours, step, drawing }: Content, words: Words, way: BackendName): Scene {
  const scene = buildScene(trace, colours, {
    solids: standing(trace, step.index),
    pieces: way === "svg" ? SORTED_PIECES : 1,
    index: step.index,
    drawing,
    ...(words.frame && { words: words.frame }),
  });
  const labels = collisionLabels(trace, colours, words.collision ?? (() => ""));
  return { ...scene, labels: [...scene.labels, ...labels] };
}
