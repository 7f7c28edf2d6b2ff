// Variants of a cycle, with the addresses that they have in a plane.

import { say, t } from "../texts";
import type { CycleInfo, FormView, Plane } from "../wire";
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

/** A variant with the addresses that it has in this plane. */
export function inPlane(variant: Variant, plane: Plane): Variant {
  return { ...variant, ...variant.planes[plane] };
}

/** The worked measurement of the cycle, with the addresses of the plane. */
export function exampleOf(cycle: CycleInfo, plane: Plane): Record<string, string> {
  const own = cycle.variants.find(({ example }) =>
    Object.entries(cycle.example).every(([name, value]) => example[name] === value),
  );
  return own ? inPlane(own, plane).example : cycle.example;
}

/** Whether the worked measurement of a variant is still as it was: then another variant brings its own. */
export function isExample(cycle: CycleInfo, values: Record<string, string>, plane: Plane): boolean {
  return cycle.variants.some(variant =>
    Object.entries(inPlane(variant, plane).example).every(([name, value]) => (values[name] ?? "") === value),
  );
}
