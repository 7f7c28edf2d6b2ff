// Values that were typed in the form and are not in the program yet.

import type { Changed, ComparedValue, Dialect, Edit, Replaced, TouchedLine } from "../wire";

/** What is waited with: edits of that text which reach further than the value, or the expression that it replaces. */
export interface Asks {
  text: string;
  steps: Edit[][];
  lines: TouchedLine[]; // outside of the call
  values: ComparedValue[];
  replaced?: Replaced;
}

// A value changed in the form and not yet in the program: of the call that begins at UTF-16 offset `at` there. asks: it
// waits for a word; agreed: that was given.
export interface Pending {
  control: Dialect;
  at: number;
  name: string;
  value: string;
  asks?: Asks;
  agreed?: boolean | "here"; // here: in place of the expression
}

/** Whether a value waits for a word about this text. */
export function isWaiting({ asks }: Pending, text: string): boolean {
  return asks?.text === text;
}

/** Those of one call whose changes can be worked out now. */
export function asked(
  pending: readonly Pending[],
  { control, text, at }: { control: Dialect; text: string; at: number },
): Pending[] {
  return pending.filter(one => one.control === control && one.at === at && !isWaiting(one, text));
}

/** Whether a value would take the place of an expression, and it is not known yet whether it may. */
export function hasToReplace({ agreed }: Pending, { elsewhere, replaced }: Changed): boolean {
  return !!replaced && !elsewhere.length && !agreed; // where it lands in other lines, these tell what it replaces
}

/** Whether a change of the program needs a word first. */
export function hasToAsk(one: Pending, changed: Changed): boolean {
  return hasToReplace(one, changed) || (changed.reaches && one.agreed !== true);
}
