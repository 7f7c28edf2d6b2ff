// Variants of a cycle, with the addresses that they have in a plane.

import { INCH } from "../state/state";
import { say, t } from "../texts";
import type { CycleInfo, FormView, OwnMachine } from "../wire";
import type { Derived } from "./derive";

export type Variant = CycleInfo["variants"][number];

/** The variant that the typed values choose. */
export function variantOf({ cycle, view }: Derived): Variant | undefined {
  return cycle.variants.find(one => one.mvar === view.mvar);
}

/** What a call is called: by its list, by its variant, by its cycle. */
export function titleOf(cycle: CycleInfo, { title, mvar }: Pick<FormView, "title" | "mvar">): string {
  if (title) return say(title);
  return t(cycle.variants.find(one => one.mvar === mvar)?.key ?? `${cycle.key}-title`);
}

type System = OwnMachine["own"];

/** A variant with the addresses that it has in this plane, its worked measurement in these units. */
export function inSystem(variant: Variant, { plane, units }: System): Variant {
  const turned = { ...variant, ...variant.planes[plane] };
  return INCH.includes(units) ? { ...turned, example: { ...turned.example, ...turned.inch } } : turned;
}

/** The worked measurement of the cycle, with the addresses of the plane, in these units. */
export function exampleOf(cycle: CycleInfo, system: System): Record<string, string> {
  const own = cycle.variants.find(({ example }) =>
    Object.entries(cycle.example).every(([name, value]) => example[name] === value),
  );
  return own ? inSystem(own, system).example : cycle.example;
}

/** Whether the worked measurement of a variant is still as it was: then another variant brings its own. */
export function isExample(cycle: CycleInfo, values: Record<string, string>, system: System): boolean {
  return cycle.variants.some(variant =>
    Object.entries(inSystem(variant, system).example).every(([name, value]) => (values[name] ?? "") === value),
  );
}
