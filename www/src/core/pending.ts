// Values that were typed in the form and are not in the program yet.

import type { Changed, Dialect, Replaced, TouchedLine } from "../wire";

// A value changed in the form and not yet in the program: of the call that begins at UTF-16 offset `at` there. asks: it
// would change these lines of that text outside of its call, or take the place of an expression in it, and waits for a
// word; agreed: that was given.
export interface Pending {
  control: Dialect;
  at: number;
  name: string;
  value: string;
  asks?: { text: string; lines: TouchedLine[]; replaced?: Replaced };
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

/** Whether a change of the program needs a word first. */
export function hasToAsk({ agreed }: Pending, { elsewhere, replaced }: Changed): boolean {
  return (elsewhere.length > 0 || !!replaced) && !agreed;
}
