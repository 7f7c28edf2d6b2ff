// Values that do not fit another variant, as the core tells them. When a form that belongs to no program changes the
// variant they are taken out of their fields, and a note there says so; in a call of a program they go with the change,
// or here where its number was that of no variant for a while. What came back is left alone.

import type { FormCore } from "../core/core";
import { patched, type State, systemOf } from "../state/state";
import type { Derived } from "./derive";
import { resetsOf, typedIn, unseen } from "./typing";
import { isExample } from "./variants";

export interface Seen {
  state: State;
  derived: Derived;
}

/** The number of the call that the form edits; where it begins moves with each change. */
function callOf({ derived: { read, opened } }: Seen): number {
  return opened ? read.calls.indexOf(opened) : -1;
}

/** What was drawn last with a variant that counts: of one whose number is half typed nothing is known. */
export function lastKnown(before: Seen | null, now: Seen): Seen {
  const waits = now.derived.view.mvar === null || unseen(now.state).length > 0;
  return waits && before?.derived.cycle === now.derived.cycle ? before : now;
}

/** The state without the values of the variant before that do not fit the one that was chosen in the form. */
export function meant(before: Seen | null, { state, derived }: Seen, core: FormCore): State {
  if (!before || before.derived.cycle !== derived.cycle || callOf(before) !== callOf({ state, derived })) return state;
  if (before.state.form.edits === state.form.edits || unseen(state).length) return state;
  const [was, is] = [before.derived.view.mvar, derived.view.mvar];
  const { values } = state.form;
  if (was === null || is === null || was === is || isExample(derived.cycle, values, systemOf(state))) return state;
  const { control, cycle, setup } = derived.asked;
  const stale = core.unfit?.({ control, cycle, before: before.state.form.values, values, setup }) ?? [];
  if (!stale.length) return state;
  const next = typedIn(
    state,
    stale.map(({ name }) => [name, ""]),
  );
  return patched(next, { form: { resets: { ...next.form.resets, ...resetsOf(stale) } } });
}
