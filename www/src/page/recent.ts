// Notes what was worked on lately, as the state tells it: a file that is opened or saved, a form that is left.

import type { Derived } from "../desk/derive";
import { isRead } from "../desk/program";
import { lineCount } from "../eol";
import { placeAt } from "../state/places";
import { LONGEST, putRecent } from "../state/recent";
import { memoryKey, programOf, type State } from "../state/state";

/** To be called with each state that is drawn. */
export function createNoting(): (state: State, derived: Derived) => void {
  let last: { state: State; mvar: number | null | undefined } | null = null;
  let typed = 0; // edits of the form when it came
  let due = false; // the program is noted as soon as it is read
  return (state, { view }) => {
    const before = last;
    last = { state, mvar: view.mvar };
    if (!before) {
      typed = state.form.edits;
      return;
    }
    const file = state.program.files[state.form.control];
    const opened = before.state.program.files[state.form.control]?.opened !== file?.opened;
    due ||= !!file?.opened && (opened || before.state.program.saved !== state.program.saved);
    if (due && file && isRead(state)) {
      due = false;
      noteProgram(state);
    }
    const other = memoryKey(before.state.form) !== memoryKey(state.form) || before.mvar !== view.mvar;
    const left = state.page.place === "start" && before.state.page.place === "work";
    if ((other || left) && before.state.form.edits > typed && before.state.form.open === null)
      noteForm(before.state, before.mvar);
    if (other || left) typed = state.form.edits;
  };
}

function noteProgram(state: State): void {
  const { control } = state.form;
  const file = state.program.files[control];
  if (!file) return;
  const text = programOf(state);
  if (text.length > LONGEST) return;
  void putRecent({
    id: `program ${control} ${file.name}`,
    at: Date.now(),
    control,
    name: file.name,
    encoding: file.encoding,
    calls: state.program.reading?.view.calls.length ?? 0,
    lines: lineCount(text),
    text,
    place: placeAt(file.opened),
  });
}

function noteForm({ form: { control, cycle, values } }: State, mvar: number | null | undefined): void {
  if (typeof mvar !== "number") return;
  void putRecent({ id: `form ${control} ${cycle} ${mvar}`, at: Date.now(), control, cycle, mvar, values });
}
