// Whether the call in the form stands in the program just so, and where.

import { lineAt } from "../eol";
import { parseNumber, writtenAs } from "../numbers";
import { programOf, type State } from "../state/state";
import type { Derived } from "./derive";

/** Line of the last character before this place, from 1. */
function lineBefore(text: string, place: number): number {
  let end = place;
  while (end > 0 && text[end - 1]?.trim() === "") end--;
  return lineAt(text, end);
}

const bare = (value: string | undefined): string => (value ?? "").trim().replace(/^"(.*)"$/, "$1");

function same(one: string | undefined, other: string | undefined): boolean {
  const [a, b] = [bare(one), bare(other)];
  const number = parseNumber(a);
  return a === b || (number !== null && number === parseNumber(b));
}

/** Whether the form shows a value that the program does not hold and that is not asked about: it cannot be written. */
function isAhead(state: State, { opened, fresh, view }: Derived): boolean {
  const { control, open, values } = state.form;
  const mine = state.desk.pending.filter(one => one.control === control && one.at === open);
  if (!opened || !fresh) return false;
  const onTheWay = new Set(mine.map(one => one.name));
  return view.fields.some(
    ({ name }) =>
      !onTheWay.has(name) &&
      !same(values[name], opened.values[name]) &&
      !writtenAs(values[name] ?? "", opened.expressions[name] ?? opened.values[name] ?? ""),
  );
}

/** The line of the program, from 1, in which the call stands that the form edits, as the form has it; else null. */
export function placedIn(state: State, derived: Derived): number | null {
  const { open } = state.form;
  const { sought } = state.desk;
  const text = programOf(state);
  if (sought && "to" in sought) return lineBefore(text, sought.to); // just inserted, and not read yet
  const answered = derived.simulates === "yes" || derived.view.snippet !== "";
  if (open === null || !answered || isAhead(state, derived)) return null;
  return derived.opened?.lastLine ?? lineBefore(text, open + 1);
}
