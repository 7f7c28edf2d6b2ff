// The program in the state: whether what was said is about it as it is now, and how it is edited.

import { carried, type Splice, splice } from "../eol";
import { machine, patched, programOf, type State } from "../state/state";

/** Place of what was typed in the form while the call that it belongs to is still sought. */
export const SOUGHT = -1;

export function isCurrent(about: { control: string; text: string } | null, state: State): boolean {
  return about?.control === state.form.control && about.text === programOf(state);
}

/** Whether it is known what the program holds now, on the present machine. */
export function isRead(state: State): boolean {
  const { reading } = state.program;
  return isCurrent(reading, state) && reading?.setup === machine(state).setup;
}

/** The program with these edits; whatever points into it moves along. */
export function withEdits(state: State, edits: readonly Splice[]): State {
  const { control, open } = state.form;
  const move = (at: number): number => carried(at, edits);
  const pending = state.desk.pending.map(one =>
    one.control === control && one.at !== SOUGHT ? { ...one, at: move(one.at) } : one,
  );
  return patched(state, {
    program: {
      texts: { ...state.program.texts, [control]: splice(programOf(state), edits) },
      cursor: move(state.program.cursor),
    },
    form: { open: open === null ? null : move(open) },
    desk: { pending },
  });
}
