// Numbers that are codes mean something else in another variant (D1 of a tool, and the first settable zero offset):
// such a number is taken out of its field when the variant changes, and a note there says what it was.

import { parseNumber } from "../numbers";
import { patched, planeOf, type State } from "../state/state";
import { isExample } from "./actions";
import type { Derived } from "./derive";
import { typedIn } from "./typing";

export interface Seen {
  state: State;
  derived: Derived;
}

/** The number of the call that the form edits; where it begins moves with each change. */
function callOf({ derived: { read, opened } }: Seen): number {
  return opened ? read.calls.indexOf(opened) : -1;
}

/** The state without the values that were codes of something else in the variant before. */
export function meant(before: Seen | null, { state, derived }: Seen): State {
  if (!before || before.derived.cycle !== derived.cycle || callOf(before) !== callOf({ state, derived })) return state;
  const [was, is] = [before.derived.view, derived.view];
  if (
    was.mvar === null ||
    is.mvar === null ||
    was.mvar === is.mvar ||
    isExample(derived.cycle, state.form.values, planeOf(state))
  )
    return state;
  const stale = is.fields.flatMap(({ name, code, expression }) => {
    const old = was.fields.find(field => field.name === name);
    const value = state.form.values[name] ?? "";
    const kept = value === before.state.form.values[name] && (parseNumber(value) ?? 0) !== 0;
    return kept && !expression && old?.code && code && old.code !== code
      ? [{ name, value, before: old.label.key }]
      : [];
  });
  if (!stale.length) return state;
  const next = typedIn(
    state,
    stale.map(({ name }) => [name, ""]),
  );
  return patched(next, {
    form: { resets: { ...next.form.resets, ...Object.fromEntries(stale.map(({ name, ...reset }) => [name, reset])) } },
  });
}
