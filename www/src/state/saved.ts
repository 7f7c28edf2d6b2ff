// Whether a program is saved: by the mark of what its file holds. It belongs to the file and not to the work, so that
// undoing a step undoes no save.

import type { Dialect } from "../wire";
import { fileOf } from "./files";
import { isMarkOf } from "./mark";
import { type Patch, programOf, type State } from "./state";

const MOST = 100; // files whose marks are kept, the last ones

const nameOf = (control: Dialect, opened: number | undefined): string => `${control} ${opened ?? ""}`;

/** The file that was opened then holds what has this mark; null: it is not known what. */
export function withMark(state: State, control: Dialect, opened: number | undefined, mark: string | null): Patch {
  const name = nameOf(control, opened);
  const { [name]: _, ...others } = state.program.saved;
  const kept = Object.entries(others).slice(-MOST);
  return { program: { saved: Object.fromEntries(mark === null ? kept : [...kept, [name, mark]]) } };
}

/** Whether the program that is shown has anything that its file lacks. */
export function isUnsaved(state: State): boolean {
  const { encoding, opened } = fileOf(state);
  const text = programOf(state);
  const mark = state.program.saved[nameOf(state.form.control, opened)];
  return mark === undefined ? text !== "" : !isMarkOf(mark, text, encoding);
}
