// The program in the state: whether what was said is about it as it is now, and how it is edited.

import { carried, type Splice, splice } from "../eol";
import { besideOf, patched, programMachine, programOf, type State } from "../state/state";
import type { Catalogue } from "../wire";

/** Place of what was typed in the form while the call that it belongs to is still sought. */
export const SOUGHT = -1;

export function isCurrent(about: { control: string; text: string } | null, state: State): boolean {
  return about?.control === state.form.control && about.text === programOf(state);
}

/** Whether it is about the present program with the files that lie beside it now. */
export function isOfNow(
  about: { control: string; text: string; with?: readonly unknown[] | undefined } | null,
  state: State,
): boolean {
  return isCurrent(about, state) && about?.with === besideOf(state).with;
}

/** Whether it is known what the program holds now, on the present machine. */
export function isRead(state: State): boolean {
  const { reading } = state.program;
  return isOfNow(reading, state) && reading?.setup === programMachine(state).setup;
}

/** The state once it is known which sort of machine the program is for: that of its first call that tells. */
export function suited(state: State, { cycles }: Catalogue): State {
  const { control } = state.form;
  const { reading, usual } = state.program;
  if (!reading || !isCurrent(reading, state)) return state;
  const planes = new Map(cycles.map(one => [one.control === control ? one.cycle : "", one.purpose.plane]));
  const telling = reading.view.calls.find(one => planes.get(one.cycle));
  const plane = (telling && planes.get(telling.cycle)) ?? undefined;
  return plane === usual[control] ? state : patched(state, { program: { usual: { ...usual, [control]: plane } } });
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
