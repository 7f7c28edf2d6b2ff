// What must not touch and did: crashes, touches of the stylus, and the touch that an alarm follows.
import type { Touching, Trace, Vec3 } from "../wire";
import type { Colours } from "./colours";
import type { Label } from "./paths";

/**
 * `alarm`: its code, where the probe was watched; `crash`: nobody watched, or no signal came. Else a measurement went
 * on.
 */
export interface Collision {
  entry: number;
  at: Vec3;
  by: Touching;
  crash: boolean;
  alarm?: string;
}

const known = new WeakMap<Trace, Collision[]>();

export function collisions(trace: Trace): Collision[] {
  const found = known.get(trace) ?? look(trace);
  known.set(trace, found);
  return found;
}

function look({ entries }: Trace): Collision[] {
  return entries.flatMap((step, entry): Collision[] => {
    if (step.step === "crash") return [{ entry, at: step.point, by: step.by ?? "ball", crash: true }];
    if (step.step !== "touch") return [];
    const alarm = raised(entries, entry);
    if (!step.by && !alarm) return [];
    return [{ entry, at: step.point, by: step.by ?? "ball", crash: false, ...(alarm ? { alarm } : {}) }];
  });
}

/** Code of the alarm that follows before anything moves again. */
function raised(entries: Trace["entries"], touch: number): string | undefined {
  for (let i = touch + 1; i < entries.length; i++) {
    const next = entries[i]!;
    if (next.step === "alarm") return next.code;
    if (next.step === "motion" || next.step === "call") return undefined;
  }
  return undefined;
}

/** Words beside the places, from the entry on in which it happens. */
export function collisionLabels(trace: Trace, colours: Colours, words: (collision: Collision) => string): Label[] {
  return collisions(trace).map(
    (found): Label => ({
      at: found.at,
      text: words(found),
      colour: colours.crash,
      below: true,
      during: [found.entry, Infinity],
    }),
  );
}
