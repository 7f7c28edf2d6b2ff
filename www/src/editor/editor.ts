// The program editor. It lives in a shadow root: there CodeMirror puts its rules into adopted style sheets,
// so that the page's content policy needs no 'unsafe-inline' for styles.

import { defaultKeymap, history, historyKeymap, isolateHistory } from "@codemirror/commands";
import { closeLintPanel, lintGutter, lintKeymap, setDiagnostics, type Diagnostic as Mark } from "@codemirror/lint";
import { closeSearchPanel, highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Compartment, EditorSelection, EditorState, RangeSetBuilder, StateEffect, StateField, Transaction, type Extension } from "@codemirror/state";
import { Decoration, drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, highlightSpecialChars, keymap, lineNumbers, type DecorationSet } from "@codemirror/view";
import type { Dialect } from "../wire";
import { nct } from "./nct";
import { sinumerik } from "./sinumerik";
import { theme } from "./theme";

/** Lines from 1. */
export interface LineMarks { calls: { from: number; to: number; open: boolean }[]; step: number | null }
export interface EditorHost { typed(changes: { from: number; to: number; insert: string }[]): void; moved(offset: number, line: number): void }
/** Its name, and what it says by itself: the editor's own English words with those to be shown. */
export interface EditorWords { label: string; phrases: Record<string, string> }
/** `apart`: a step of its own to undo, however soon it follows. Places are those in the text as it is then. */
export interface Shown { text?: string; apart?: boolean; marks?: LineMarks; problems?: Mark[] }
export interface Editor {
  view: EditorView;
  setWords(words: EditorWords): void;
  /** Remembers what is in sight, and brings it there again. */
  keepPlace(): () => void;
  setDialect(dialect: Dialect): void;
  /** What is told and differs, in one step: each by itself lays out the page once more. */
  set(next: Shown): void;
  select(offset: number): void;
  selectLine(line: number): void;
}

const LANGUAGES: Record<Dialect, Extension> = { sinumerik, nct };
const marksEffect = StateEffect.define<LineMarks>();

function decorate(state: EditorState, marks: LineMarks): DecorationSet {
  const classes = new Map<number, string>();
  for (const call of marks.calls)
    for (let line = call.from; line <= Math.min(call.to, state.doc.lines); line++) classes.set(line, call.open ? "cm-call-open" : "cm-call");
  if (marks.step !== null && marks.step >= 1 && marks.step <= state.doc.lines) classes.set(marks.step, `${classes.get(marks.step) ?? ""} cm-step`);
  const builder = new RangeSetBuilder<Decoration>();
  for (const [line, name] of [...classes].sort((a, b) => a[0] - b[0])) {
    const at = state.doc.line(line).from;
    builder.add(at, at, Decoration.line({ class: name.trim() }));
  }
  return builder.finish();
}

const marksField = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(marksEffect)) return decorate(transaction.state, effect.value);
    return value.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

/** The smallest replacement that turns `before` into `after`. */
export function difference(before: string, after: string): { from: number; to: number; insert: string } | null {
  if (before === after) return null;
  let start = 0;
  const shorter = Math.min(before.length, after.length);
  while (start < shorter && before.charCodeAt(start) === after.charCodeAt(start)) start++;
  let end = 0;
  while (end < shorter - start && before.charCodeAt(before.length - 1 - end) === after.charCodeAt(after.length - 1 - end)) end++;
  return { from: start, to: before.length - end, insert: after.slice(start, after.length - end) };
}

function speaking({ label, phrases }: EditorWords): Extension {
  return [EditorState.phrases.of(phrases), EditorView.contentAttributes.of({ "aria-label": label })];
}

export function createEditor(box: HTMLElement, words: EditorWords, host: EditorHost): Editor {
  const root = box.attachShadow({ mode: "open" });
  const language = new Compartment();
  const spoken = new Compartment();
  let ours = false; // a change made by the page, not by the user
  let dialect: Dialect = "sinumerik";

  const listen = EditorView.updateListener.of((update) => {
    if (ours) return;
    if (update.docChanged) {
      const changes: { from: number; to: number; insert: string }[] = [];
      update.changes.iterChanges((from, to, _a, _b, inserted) => changes.push({ from, to, insert: inserted.toString() }));
      host.typed(changes);
    }
    const { head } = update.state.selection.main;
    if (update.selectionSet || update.docChanged) host.moved(head, update.state.doc.lineAt(head).number);
  });
  const view = new EditorView({
    parent: root, root,
    state: EditorState.create({
      extensions: [
        lineNumbers(), lintGutter(), history(), drawSelection(), highlightSpecialChars(), highlightActiveLine(), highlightActiveLineGutter(),
        search({ top: true }), highlightSelectionMatches(), marksField, language.of(LANGUAGES[dialect]), theme, listen,
        keymap.of([...searchKeymap, ...lintKeymap, ...historyKeymap, ...defaultKeymap]),
        spoken.of(speaking(words)), EditorView.contentAttributes.of({ tabindex: "0", autocapitalize: "characters", spellcheck: "false" }),
      ],
    }),
  });
  const apply = (run: () => void): void => { ours = true; try { run(); } finally { ours = false; } };
  const select = (offset: number): void => {
    const at = Math.min(offset, view.state.doc.length);
    apply(() => view.dispatch({ selection: EditorSelection.cursor(at), scrollIntoView: true }));
  };

  return {
    view,
    setWords(next) {
      closeSearchPanel(view); // a panel that stands keeps its words
      closeLintPanel(view);
      apply(() => view.dispatch({ effects: spoken.reconfigure(speaking(next)) }));
    },
    keepPlace() {
      const place = view.scrollSnapshot();
      return () => apply(() => view.dispatch({ effects: place }));
    },
    set({ text, apart, marks, problems }) {
      const change = text === undefined ? null : difference(view.state.doc.toString(), text.replace(/\r\n?/g, "\n"));
      const told = problems ? [setDiagnostics(view.state, problems).effects ?? []].flat() : [];
      const effects = [...marks ? [marksEffect.of(marks)] : [], ...told];
      const step = change ? { changes: change, annotations: [Transaction.addToHistory.of(true), ...(apart ? [isolateHistory.of("full")] : [])] } : {};
      if (change || effects.length) apply(() => view.dispatch({ ...step, effects }));
    },
    setDialect(next) {
      if (next === dialect) return;
      dialect = next;
      apply(() => view.dispatch({ effects: language.reconfigure(LANGUAGES[next]) }));
    },
    select,
    selectLine: (line) => select(view.state.doc.line(Math.max(1, Math.min(line, view.state.doc.lines))).from),
  };
}
