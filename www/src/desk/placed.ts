// Whether the call in the form stands in the program just so, and where.

import { parseNumber, writtenAs } from "../numbers";
import { programOf, type State } from "../state/state";
import type { Derived } from "./derive";

let last = { text: "", place: 0, line: 1 };

/** Line of the last character before this place, from 1. A long program is counted once, however often it is drawn. */
function lineBefore(text: string, place: number): number {
  if (last.place !== place || last.text !== text) last = { text, place, line: counted(text, place) };
  return last.line;
}

function counted(text: string, place: number): number {
  const { length } = text.slice(0, place).trimEnd();
  let line = 1;
  for (let at = text.indexOf("\n"); at >= 0 && at < length; at = text.indexOf("\n", at + 1)) line++;
  for (let at = text.indexOf("\r"); at >= 0 && at < length; at = text.indexOf("\r", at + 1))
    if (text.charCodeAt(at + 1) !== 10) line++; // a CR alone
  return line;
}

const bare = (value: string | undefined): string => (value ?? "").trim().replace(/^"(.*)"$/, "$1");

function same(one: string | undefined, other: string | undefined): boolean {
  const [a, b] = [bare(one), bare(other)];
  const number = parseNumber(a);
  return a === b || (number !== null && number === parseNumber(b));
}

/** Whether the form shows a value that the program does not hold: it cannot be written, or waits for a word. */
function isAhead(state: State, { opened, fresh, view }: Derived): boolean {
  const { control, open, values } = state.form;
  const mine = state.desk.pending.filter(one => one.control === control && one.at === open);
  if (mine.some(one => one.asks)) return true;
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
  if (open === null || isAhead(state, derived)) return null;
  return derived.opened?.lastLine ?? lineBefore(text, open + 1);
}
