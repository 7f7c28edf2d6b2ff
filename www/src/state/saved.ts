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

/** The mark of what the file of the program that is shown holds; null: it is not known. */
export function markOf(state: State): string | null {
  return state.program.saved[nameOf(state.form.control, fileOf(state).opened)] ?? null;
}

/** Whether the program that is shown has anything that its file lacks. */
export function isUnsaved(state: State): boolean {
  const text = programOf(state);
  const mark = markOf(state);
  return mark === null ? text !== "" : !isMarkOf(mark, text, fileOf(state).encoding);
}
