// Values that were typed in the form and are not in the program yet.

import type { Changed, Dialect, TouchedLine } from "../wire";

// A value changed in the form and not yet in the program: of the call that begins at UTF-16 offset `at` there. asks: it
// would change these lines of that text outside of its call, and waits for a word; agreed: that was given.
export interface Pending {
  control: Dialect;
  at: number;
  name: string;
  value: string;
  asks?: { text: string; lines: TouchedLine[] };
  agreed?: boolean;
}

/** Whether a value waits for a word: in this text it would change lines outside of its call. */
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
export function hasToAsk({ agreed }: Pending, { elsewhere }: Changed): boolean {
  return elsewhere.length > 0 && !agreed;
}
