// The way to a field from anywhere: the present form where it has the field, else the first cycle and variant that do.

import type { Actions } from "../desk/actions";
import { findCycle } from "../desk/derive";
import { inSystem, type Variant } from "../desk/variants";
import { type State, systemOf } from "../state/state";
import type { Store } from "../state/store";
import { focusField } from "../views/field";
import type { Catalogue, CycleInfo, Dialect } from "../wire";

/** Whether a form with these values has this field. */
export type Shows = (cycle: CycleInfo, values: Record<string, string>, name: string) => boolean | undefined;
interface Place {
  cycle: CycleInfo;
  variant: Variant;
}

/** null: the present form has it, or none does. */
function place(catalogue: Catalogue, shows: Shows, state: State, control: Dialect, name: string): Place | null {
  const present = findCycle(catalogue, state.form.control, state.form.cycle);
  const here = present?.control === control ? present : undefined;
  if (here && shows(here, state.form.values, name)) return null;
  const having = catalogue.cycles.filter(
    cycle => cycle.control === control && cycle.parameters.some(one => one.name === name),
  );
  for (const cycle of having.sort((a, b) => Number(b === here) - Number(a === here))) {
    const given = cycle === here ? state.form.values : {};
    const system = systemOf(state);
    const variant = cycle.variants.find(one => {
      const { example, values } = inSystem(one, system);
      return shows(cycle, { ...example, ...given, ...values }, name);
    });
    if (variant) return { cycle, variant };
  }
  return null;
}

export function createGoToField(
  catalogue: Catalogue,
  shows: Shows,
  store: Store,
  actions: Actions,
): (control: Dialect, name: string) => void {
  return (control, name) => {
    const found = place(catalogue, shows, store.state, control, name);
    if (found) actions.chooseCycle(found.cycle, found.variant);
    actions.panel("form");
    focusField(name);
  };
}
