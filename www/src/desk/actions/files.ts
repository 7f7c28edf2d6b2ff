// The program and the files beside it, and what a run of them is given.

import type { Encoding } from "../../encoding";
import type { Splice } from "../../eol";
import { type BesideFile, fileOf, type ProgramFile } from "../../state/files";
import { markOf, withMark } from "../../state/saved";
import { type Patch, patched, programMachine, programOf, type State } from "../../state/state";
import type { Dialect, RunMode } from "../../wire";
import { sameName } from "../beside";
import { withEdits } from "../program";
import type { Acting } from "./acting";
import type { MachineActions } from "./machine";

/** A file that was read; `mark`: of what it holds, null: that is not known. */
export interface Opened {
  text: string;
  file: ProgramFile;
  mark: string | null;
}

export interface FilesActions {
  editProgram(edits: Splice[]): void;
  /** `mark`: of what the file holds; null: that is not known. */
  openProgram(text: string, file: ProgramFile, mark: string | null, beside?: readonly Opened[]): void;
  /** The program that is shown, under another control; under this one it can be had back. */
  openUnder(control: Dialect): void;
  /** Files that lie beside the program from now on; one of the same name takes the place of that one. */
  putBeside(files: readonly Opened[]): void;
  /** A file beside the program is shown and run; what was shown lies beside it. */
  showFile(name: string): void;
  removeFile(name: string): void;
  /** The definitions of a file beside the program become part of the machine. */
  define(name: string): void;
  /** The program is saved in another encoding from now on. */
  encoding(encoding: Encoding): void;
  /** The file that was opened then holds what has this mark. */
  saved(control: Dialect, opened: number | undefined, mark: string): void;
  /** A value for a parameter of the program's own PROC, as typed. */
  argument(name: string, value: string): void;
  /** Whether what is not there stops the run. */
  strict(on: boolean): void;
  /** `target`: line up to which a block search goes. */
  mode(mode: RunMode, target: number): void;
  /** Which program of a text that holds several is run; empty: the first. */
  main(name: string): void;
}

export function createFilesActions({ store, core, now, replace }: Acting, machine: MachineActions): FilesActions {
  const actions: FilesActions = {
    editProgram: edits =>
      store.update(state => patched(withEdits(state, edits), { desk: { follow: "text" }, page: { offer: false } })),
    openProgram(text, file, mark, more = []) {
      const { control } = now().form;
      const { texts: programs, files, beside } = now().program;
      const { pending } = now().desk;
      const others = withFiles(beside[control], more).filter(one => !sameName(one.name, file.name));
      const marks = [...more, { file, mark }];
      const marked = marks.reduce(
        (state, one) => patched(state, withMark(state, control, one.file.opened, one.mark)),
        now(),
      );
      replace(
        text ? "notice-opened" : "notice-opened-empty",
        { program: { saved: marked.program.saved } },
        {
          program: {
            texts: { ...programs, [control]: text },
            files: { ...files, [control]: file },
            beside: { ...beside, [control]: others },
            stoppedReading: null,
            reading: null,
            cursor: 0,
            line: 1,
          },
          desk: { pending: pending.filter(one => one.control !== control), sought: null },
          form: { open: null },
          run: { done: null, stopped: null },
          page: { refused: null },
        },
      );
    },
    openUnder(control) {
      store.flush(); // what was typed last belongs to the program
      const state = now();
      const [text, file, mark] = [programOf(state), fileOf(state), markOf(state)];
      machine.chooseControl(control);
      actions.openProgram(text, file, mark);
    },
    putBeside(more) {
      const { control } = now().form;
      const { beside } = now().program;
      const marked = more.reduce(
        (state, { file, mark }) => patched(state, withMark(state, control, file.opened, mark)),
        now(),
      );
      replace(
        "notice-beside",
        { program: { saved: marked.program.saved } },
        besideAnew({
          ...beside,
          [control]: withFiles(beside[control], more),
        }),
      );
    },
    showFile(name) {
      store.flush(); // what was typed last belongs to the file that is left
      const state = now();
      const { control } = state.form;
      const { texts, files, beside } = state.program;
      const all = beside[control] ?? [];
      const wanted = all.find(one => sameName(one.name, name));
      if (!wanted) return;
      const { text, ...file } = wanted;
      const left = programOf(state);
      const others = all.flatMap(one => (one !== wanted ? [one] : left ? [{ ...fileOf(state), text: left }] : []));
      store.update(besideAnew({ ...beside, [control]: others }), {
        program: {
          texts: { ...texts, [control]: text },
          files: { ...files, [control]: file },
          reading: null,
          cursor: 0,
          line: 1,
        },
        desk: { pending: state.desk.pending.filter(one => one.control !== control), sought: null },
        form: { open: null },
        run: { done: null, stopped: null },
        page: { offer: false },
      });
      store.flush(); // the editor has to hold it before the next key
    },
    removeFile(name) {
      const { control } = now().form;
      const { beside } = now().program;
      const left = (beside[control] ?? []).filter(one => !sameName(one.name, name));
      replace("notice-beside-removed", besideAnew({ ...beside, [control]: left }));
    },
    define(name) {
      const state = now();
      const { control } = state.form;
      const file = state.program.beside[control]?.find(one => sameName(one.name, name));
      const request = { control, ...programMachine(state), change: { define: file?.text ?? "" } };
      const view = file && core()?.equip(request);
      if (!view) return; // the module is still on its way
      machine.equip(view.setup, { key: "step-define", args: { file: name } });
      const left = (state.program.beside[control] ?? []).filter(one => one !== file);
      replace("notice-defined", besideAnew({ ...state.program.beside, [control]: left }));
    },
    encoding: encoding =>
      store.update(state => ({
        program: { files: { ...state.program.files, [state.form.control]: { ...fileOf(state), encoding } } },
        page: { offer: false },
      })),
    saved: (control, opened, mark) => store.update(state => withMark(state, control, opened, mark)),
    argument(name, value) {
      const { control } = now().form;
      const { given } = now().program;
      const { [name]: _, ...others } = given[control] ?? {};
      const values = value.trim() ? { ...others, [name]: value } : others;
      store.update({
        program: { given: { ...given, [control]: values } },
        run: { stopped: null },
        page: { offer: false },
      });
    },
    strict: strict => store.update({ run: { strict, stopped: null } }),
    mode: (mode, target) => store.update({ run: { mode, target, stopped: null } }),
    main: main => store.update({ run: { main, stopped: null } }),
  };
  return actions;
}

/** The files beside the program with these. */
function withFiles(before: readonly BesideFile[] = [], more: readonly Opened[]): BesideFile[] {
  const added = more.map(({ text, file }) => ({ ...file, text }));
  const isNew = ({ name }: BesideFile): boolean => !added.some(one => sameName(one.name, name));
  return [...before.filter(isNew), ...added].sort((a, b) => a.name.localeCompare(b.name));
}

/** With other files beside the program: what was stopped may go on. */
function besideAnew(beside: State["program"]["beside"]): Patch {
  return { program: { beside, stoppedReading: null }, run: { stopped: null } };
}
