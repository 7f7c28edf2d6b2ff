// Values that do not fit another variant: numbers that are codes of something else there (D1 of a tool, and the first
// settable zero offset), and those that it does not take. When the form changes the variant they are taken out of their
// fields, and a note there says so. What was changed in the text of the program, or came back, is left alone.

import { parseNumber } from "../numbers";
import { patched, planeOf, type Reset, type State } from "../state/state";
import type { Field } from "../wire";
import type { Derived } from "./derive";
import { typedIn, unseen } from "./typing";
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

/** Whether a field takes a number by itself, whatever the others hold. */
function takes(field: Field, value: number): boolean {
  if (field.kind === "choice") return field.choices.some(one => one.value === value);
  if (field.kind !== "real" && field.kind !== "integer") return true;
  const { min, max, minIncluded, maxIncluded } = field.range;
  const above = min === undefined || value > min || (minIncluded && value === min);
  return above && (max === undefined || value < max || (maxIncluded && value === max));
}

/** Why a value goes that the field held in the variant before; null: it stays. */
function reset(old: Field, now: Field, value: string): Reset | null {
  const number = parseNumber(value) ?? 0;
  if (number === 0 || now.expression) return null;
  if (old.code && now.code && old.code !== now.code) return { value, before: old.label.key };
  return takes(old, number) && !takes(now, number) ? { value } : null;
}

/** The state without the values of the variant before that do not fit the one that was chosen in the form. */
export function meant(before: Seen | null, { state, derived }: Seen): State {
  if (!before || before.derived.cycle !== derived.cycle || callOf(before) !== callOf({ state, derived })) return state;
  if (before.state.form.edits === state.form.edits || unseen(state).length) return state;
  const [was, is] = [before.derived.view, derived.view];
  if (
    was.mvar === null ||
    is.mvar === null ||
    was.mvar === is.mvar ||
    isExample(derived.cycle, state.form.values, planeOf(state))
  )
    return state;
  const stale = is.fields.flatMap((field): [string, Reset][] => {
    const { name } = field;
    const old = was.fields.find(one => one.name === name);
    const value = state.form.values[name] ?? "";
    const why = old && value === before.state.form.values[name] ? reset(old, field, value) : null;
    return why ? [[name, why]] : [];
  });
  if (!stale.length) return state;
  const next = typedIn(
    state,
    stale.map(([name]) => [name, ""]),
  );
  return patched(next, { form: { resets: { ...next.form.resets, ...Object.fromEntries(stale) } } });
}
