// The program: editor with the calls marked, its buttons, and where the form edits.

import type { Actions } from "../desk/actions";
import { lineIn, placeIn } from "../desk/beside";
import type { Derived } from "../desk/derive";
import { isCurrent } from "../desk/program";
import { el, on, setAttribute, setText, show } from "../dom";
import type { CodeValue, EditorHost, LineMarks, Shown } from "../editor/editor";
import type { EditorPlace } from "../editor/place";
import { type Encoding, encodeInPieces } from "../encoding";
import { lineBreak, toEditor, toProgram } from "../eol";
import { type IconName, icon } from "../icons";
import { ariaKey } from "../keys";
import { sliced } from "../pace";
import { fileOf, saveFile } from "../state/files";
import { markInPieces } from "../state/mark";
import { ENDINGS, pickPlaces, writeBack } from "../state/places";
import { isUnsaved } from "../state/saved";
import { inFocus, programOf, type State } from "../state/state";
import type { Store } from "../state/store";
import { say, sayHint, t } from "../texts";
import type { CallView } from "../wire";
import { hintText } from "./amounts";
import { createBeside } from "./beside";
import { copyText } from "./copy";
import { createOrigin } from "./origin";
import { createOutline } from "./outline";

/** A file from outside, and the bytes of the program in another encoding. */
export interface Opening {
  programs(files: File[]): void;
  beside(files: File[]): void;
  places(places: FileSystemFileHandle[]): void;
  again(encoding: Encoding): void;
}
export interface ProgramView {
  head: HTMLElement;
  draw(state: State, derived: Derived): void;
  goTo(offset: number): void;
  goToLine(line: number): void;
  /** As the buttons do. */
  open(): void;
  /** Files that are to lie beside the program. */
  pickFiles(): void;
  save(): void;
  copy(): void;
}

/** A button of the program's head: its words are its name and its tooltip. */
function tool(of: IconName, words: string, attributes: Record<string, string> = {}): HTMLButtonElement {
  const name = t(words);
  return el(
    "button",
    { type: "button", class: "quiet icon-button", "aria-label": name, title: name, ...attributes },
    icon(of),
  );
}

export function createProgram(
  root: HTMLElement,
  store: Store,
  actions: Actions,
  opening: Opening,
  place: EditorPlace,
  define: (name: string) => void,
  pointed: EditorHost["pointed"],
): ProgramView {
  const name = el("span", { class: "count" });
  const copy = tool("copy", "program-copy");
  const open = tool("open", "program-open", { id: "program-open", "aria-keyshortcuts": ariaKey("page", "open") });
  const file = el("input", {
    type: "file",
    multiple: true,
    accept: [...ENDINGS, "text/plain"].join(),
    hidden: true,
    tabindex: "-1",
    "aria-label": t("program-open"),
  });
  const download = tool("save", "program-save", { "aria-keyshortcuts": ariaKey("page", "save") });
  const calls = el("button", { type: "button", class: "quiet", "aria-controls": "outline" });
  const waiting = el("p", { class: "empty" }, t("program-loading"));
  let saving = Promise.resolve(); // one after the other, in the order in which they were asked for
  const save = (): void => {
    const kept = actions.settle(); // what was typed last, too
    const { name, encoding, opened } = fileOf(store.state);
    const { control } = store.state.form;
    const program = programOf(store.state);
    saving = saving.then(async () => {
      const content = await encodeInPieces(program, encoding, sliced());
      if (!content) return origin.refuse();
      const mark = await markInPieces(program, encoding, sliced());
      const written = await writeBack(opened, content);
      if (written !== "written") saveFile(content, name);
      const told = kept && written === "written"; // what was not taken is said
      if (written !== "nowhere" && !told) store.update({ page: { notice: `notice-${written}`, offer: false } });
      actions.saved(control, opened, mark);
    });
  };
  const pick = async (): Promise<void> => {
    const places = await pickPlaces(t("program-editor"));
    if (places) opening.places(places);
    else if (places === undefined) file.click();
  };
  const beside = createBeside(actions, opening.beside, define, offset => select({ offset }));
  const origin = createOrigin(actions, opening.again, offset => select({ offset }), save);
  const head = el(
    "header",
    { class: "panel-head" },
    el("h2", { id: "program-title" }, t("program-title")),
    origin.root,
    name,
    calls,
    el("div", { class: "head-actions" }, open, file, beside.button, download, copy),
  );
  const outline = createOutline(
    index => {
      actions.openCall(index);
      const call = last?.read.calls[index];
      if (call) select({ offset: call.from });
    },
    offset => select({ offset }),
  );
  root.append(head, origin.told, beside.root, el("div", { class: "program-body" }, outline.root, waiting, place.box));

  let text = "";
  let last: Derived | null = null;
  // to be shown as soon as the editor shows the program
  let target: { offset: number } | { line: number } | null = null;
  let laid = false; // the editor shows `text`
  let lines = "";
  let lit = "";
  let told: Derived["problems"] | null = null;

  const copyAll = (): void => {
    const kept = actions.settle();
    void copyText(programOf(store.state), store, kept ? "notice-kept" : "notice-copied");
  };
  on(copy, "click", copyAll);
  on(open, "click", () => void pick());
  on(calls, "click", () => store.update(state => ({ panels: { outline: !state.panels.outline } })));
  on(file, "change", () => {
    const chosen = [...(file.files ?? [])];
    if (chosen.length) opening.programs(chosen);
    file.value = "";
  });
  on(download, "click", save);

  const host: EditorHost = {
    typed(changes) {
      const eol = lineBreak(text);
      const edits = changes.map(one => ({
        from: toProgram(text, one.from),
        to: toProgram(text, one.to),
        insert: one.insert.replaceAll("\n", eol),
      }));
      actions.editProgram(edits);
      text = programOf(store.state);
      return text;
    },
    moved(offset, line) {
      const place = toProgram(text, offset);
      actions.cursor(place, line);
      const pointed = last?.fresh ? valueAt(last.opened, place) : null;
      if (pointed !== store.state.form.pointed) store.update({ form: { pointed } });
    },
    pointed,
  };
  place.serve(host);
  const select = (wanted: { offset: number } | { line: number }): void => {
    target = laid ? null : wanted;
    if (!laid) return;
    if ("line" in wanted) place.editor?.selectLine(wanted.line);
    else place.editor?.select(toEditor(text, wanted.offset));
  };
  /** What lies in a file beside the program is shown there. */
  const inFile = (wanted: { offset: number } | { line: number }): typeof wanted => {
    const files = last?.files;
    if ("offset" in wanted) {
      const there = placeIn(files, wanted.offset);
      if (there) actions.showFile(there.file);
      return there ? { offset: there.from } : wanted;
    }
    const { file, line } = lineIn(files, wanted.line);
    if (file !== undefined) actions.showFile(file);
    return { line };
  };
  const goTo = (wanted: { offset: number } | { line: number }): void => {
    target = inFile(wanted);
    store.update({});
    actions.panel("program");
  };

  const drawCalls = (state: State, derived: Derived): void => {
    const count = derived.read.calls.length + (derived.read.others?.length ?? 0);
    show(calls, count > 0);
    setText(calls, t("program-call-count", { count }));
    setAttribute(calls, "aria-expanded", String(state.panels.outline));
    setText(name, count > 0 || !derived.fresh ? "" : t("program-no-call"));
    outline.draw(state, derived);
  };

  /** Calls, step and problems. Until the program is read again the editor moves the old ones along by itself. */
  const marked = (state: State, derived: Derived): Pick<Shown, "marks" | "problems" | "values"> => {
    if (!derived.fresh) return {};
    const step =
      state.view.source === "program" ? ofProgram(derived, derived.trace?.steps.at(derived.step)?.line) : null;
    const next: LineMarks = {
      step,
      hints: hints(state, derived),
      calls: derived.read.calls.map(call => ({
        from: call.line,
        to: call.lastLine,
        open: call.from === state.form.open,
      })),
    };
    const values = { all: valuesOf(derived), lit: inFocus(state) };
    const [before, known, had] = [lines, told, lit];
    lines = JSON.stringify(next);
    lit = JSON.stringify(values);
    told = derived.problems;
    return {
      ...(lines !== before && { marks: next }),
      ...(lit !== had && { values }),
      ...(told !== known && { problems: marks(derived, actions.cure) }),
    };
  };

  const edit = (state: State, derived: Derived): void => {
    place.editor?.setDialect(state.form.control);
    place.editor?.set({
      text,
      ...marked(state, derived),
    });
  };

  return {
    head,
    draw(state, derived) {
      text = derived.program;
      last = derived;
      laid = place.takes(text);
      if (laid) edit(state, derived);
      else if (!place.editor) place.fetch();
      else if (!isCurrent(state.program.stoppedLaying, state)) place.lay(text);
      show(waiting, !place.editor);
      show(place.box, laid || !place.editor);
      if (laid && target !== null) select(target);
      drawCalls(state, derived);
      beside.draw(state, derived);
      origin.draw(fileOf(state), text, isUnsaved(state));
    },
    goTo: offset => goTo({ offset }),
    goToLine: line => goTo({ line }),
    open: () => void pick(),
    pickFiles: beside.pick,
    save,
    copy: copyAll,
  };
}

/** A line of the program itself; null: of a file beside it. */
function ofProgram({ files }: Derived, line: number | undefined): number | null {
  return line === undefined || lineIn(files, line).file !== undefined ? null : line;
}

/** The values of the open call, where the editor has them. */
function valuesOf({ opened, program }: Derived): CodeValue[] {
  const at = (place: number): number => toEditor(program, place);
  return Object.entries(opened?.places ?? {}).map(([field, [from, to]]) => ({ field, from: at(from), to: at(to) }));
}

/** The parameter of a call whose value is at this place. */
function valueAt(call: CallView | null, place: number): string | null {
  const found = Object.entries(call?.places ?? {}).find(([, [from, to]]) => from <= place && place <= to);
  return found?.[0] ?? null;
}

/** What the open call came to, or each call of the run that is shown; of a call that ran often the last. */
function hints({ view }: State, { run, opened, view: { outcome } }: Derived): { line: number; text: string }[] {
  if (view.source === "program") {
    const last = new Map(
      (run?.answers ?? []).flatMap(one =>
        one.line === undefined || lineIn(run?.files, one.line).file !== undefined ? [] : [[one.line, one] as const],
      ),
    );
    return [...last].map(([line, answer]) => ({ line, text: hintText(answer) }));
  }
  return opened && outcome?.answer ? [{ line: opened.lastLine, text: hintText(outcome.answer) }] : [];
}

const MARKED = 2000; // problems that the editor marks, the first ones: with each change it goes through them all

function marks(derived: Derived, cure: Actions["cure"]) {
  const text = derived.program;
  const length = toEditor(text, text.length);
  return derived.problems
    .filter(one => one.from !== undefined && !placeIn(derived.files, one.from))
    .slice(0, MARKED)
    .map(one => {
      const from = Math.min(toEditor(text, one.from ?? 0), length);
      const to = Math.min(Math.max(from, toEditor(text, one.to ?? one.from ?? 0)), length);
      const severity = one.severity === "note" ? ("info" as const) : one.severity;
      const actions = one.cure
        ? [{ name: say(one.cure.label), apply: () => cure(one.cure?.edits ?? [], one.elsewhere) }]
        : [];
      return {
        from,
        to,
        severity,
        actions,
        message: `${one.code}  ${say(one.message)}${one.hint ? `\n${sayHint(one)}` : ""}`,
      };
    });
}
