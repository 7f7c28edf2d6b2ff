// The worked measurement with which a first visit begins. It is asked for while the page is built too (answers.ts), so
// that form and call stand before the core has come.

import { NO_ERRORS } from "../errors";
import type { Catalogue, CycleInfo, ErrorSliders, FormRequest } from "../wire";

/** The part of the first visit is a little too big, mm. */
export const FIRST_ERRORS: ErrorSliders = { ...NO_ERRORS, part: { ...NO_ERRORS.part, size: 0.03 } };

/** What shows most of what there is: the simulated measurement of a workpiece with the most variants. */
export function firstCycle({ cycles }: Pick<Catalogue, "cycles">): CycleInfo | undefined {
  const measured = cycles.filter(
    ({ simulated, purpose }) => simulated && purpose.probe === "workpiece" && !purpose.calibrates,
  );
  return measured.sort((a, b) => b.variants.length - a.variants.length)[0] ?? cycles[0];
}

export function firstQuestion({ control, cycle, example }: CycleInfo): FormRequest {
  return { control, cycle, values: example, errors: FIRST_ERRORS };
}
