// The steps of what happened. Those of a run are columns: a million objects would hold the page for seconds, and a step
// is made of them when it is looked at.
import type { Steps as StepsSource } from "@pkg/core/core.js";
import type { MotionKind, Step, Trace, Vec3 } from "../wire";

/** What a step is (core/src/app/trace/columns.rs). The first four are the kinds of a motion. */
export const Sort = {
  rapid: 0,
  positioning: 1,
  measuring: 2,
  retract: 3,
  touch: 4,
  otherTouch: 5,
  crash: 6,
  call: 7,
  return: 8,
  other: 9,
} as const;

/** A step as it is shown: of a motion where it ends. */
export type Shown = (Exclude<Step, { step: "motion" }> | Motion) & { line?: number };
interface Motion {
  step: "motion";
  kind: MotionKind;
  to: Vec3;
  feed: number;
}

/** As the module hands them out (web/src/steps.rs). */
export interface Columns {
  sorts: Uint8Array;
  lines: Uint32Array;
  feeds: Float64Array;
  ends: Float64Array;
  others: Uint8Array;
  starts: Uint32Array;
}

export interface Steps {
  readonly length: number;
  readonly sorts: Uint8Array;
  at(step: number): Shown | undefined;
}

export const NO_STEPS: Steps = { length: 0, sorts: new Uint8Array(), at: () => undefined };

/** A trace with its steps. */
export interface Course extends Omit<Trace, "entries"> {
  steps: Steps;
}

/** Takes them out of the module. */
export function takeSteps(source: StepsSource): Columns {
  const columns: Columns = {
    sorts: source.sorts().slice(),
    lines: source.lines().slice(),
    feeds: source.feeds().slice(),
    ends: source.ends().slice(),
    others: source.others().slice(),
    starts: source.starts().slice(),
  };
  source.free();
  return columns;
}

const KINDS: MotionKind[] = ["rapid", "positioning", "measuring", "retract"];
const EACH = 256; // steps between two places at which the others are counted

/** Steps in columns. */
export function stepsOf({ sorts, lines, feeds, ends, others, starts }: Columns): Steps {
  const before = new Uint32Array(Math.ceil(sorts.length / EACH)); // others before each of these places
  let count = 0;
  for (let i = 0; i < sorts.length; i++) {
    if (i % EACH === 0) before[i / EACH] = count;
    if ((sorts[i] ?? 0) >= Sort.touch) count++;
  }
  const decoder = new TextDecoder();
  const other = (step: number): Shown => {
    const from = step - (step % EACH);
    let place = before[from / EACH] ?? 0;
    for (let i = from; i < step; i++) if ((sorts[i] ?? 0) >= Sort.touch) place++;
    return JSON.parse(decoder.decode(others.subarray(starts[place], starts[place + 1]))) as Shown;
  };
  return {
    length: sorts.length,
    sorts,
    at(step) {
      const sort = sorts[step];
      if (sort === undefined) return undefined;
      const kind = KINDS[sort];
      if (!kind) return other(step);
      const [x = 0, y = 0, z = 0] = ends.subarray(3 * step, 3 * step + 3);
      const line = lines[step];
      return { step: "motion", kind, to: [x, y, z], feed: feeds[step] ?? 0, ...(line && { line }) };
    },
  };
}

function sortOf(step: Step): number {
  if (step.step === "motion") return KINDS.indexOf(step.kind);
  if (step.step === "touch") return step.by === undefined ? Sort.touch : Sort.otherTouch;
  return step.step === "crash" || step.step === "call" || step.step === "return" ? Sort[step.step] : Sort.other;
}

const known = new WeakMap<Trace, Course>();

/** A trace that has its steps as objects; the same for the same one. */
export function courseOf(trace: Trace): Course {
  const found = known.get(trace);
  if (found) return found;
  const { entries, ...rest } = trace;
  const steps: Steps = {
    length: entries.length,
    sorts: Uint8Array.from(entries, sortOf),
    at: step => entries[step],
  };
  const course = { ...rest, steps };
  known.set(trace, course);
  return course;
}
