// The program editor. It lives in a shadow root: there CodeMirror puts its rules into adopted style sheets,
// so that the page's content policy needs no 'unsafe-inline' for styles.

import { defaultKeymap } from "@codemirror/commands";
import {
  closeLintPanel,
  lintGutter,
  lintKeymap,
  type Diagnostic as Mark,
  nextDiagnostic,
  openLintPanel,
  setDiagnostics,
} from "@codemirror/lint";
import { closeSearchPanel, highlightSelectionMatches, openSearchPanel, search, searchKeymap } from "@codemirror/search";
import {
  Compartment,
  EditorSelection,
  EditorState,
  type Extension,
  StateEffect,
  StateField,
  type Text,
  type Transaction,
} from "@codemirror/state";
import {
  type Command as CodeCommand,
  Decoration,
  type DecorationSet,
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  highlightSpecialChars,
  type KeyBinding,
  keymap,
  lineNumbers,
  tooltips,
  WidgetType,
} from "@codemirror/view";
import { difference } from "../difference";
import { el } from "../dom";
import { HELD_BYTE, heldByte } from "../encoding";
import { type Splice, toEditor } from "../eol";
import { type Command, KEYS, partsOf } from "../keys";
import { LONG } from "../pace";
import type { Dialect } from "../wire";
import { keepLines, linesOf } from "./document";
import { nct } from "./nct";
import { sinumerik } from "./sinumerik";
import { theme } from "./theme";
import { atCaret, type Pointed, tell, underPointer, untell } from "./told";

/** Lines from 1. */
export interface LineMarks {
  calls: { from: number; to: number; open: boolean }[];
  step: number | null;
  hints?: { line: number; text: string }[]; // behind a line, no part of the text; each line once, in their order
}
/** A value of the open call; places in the text. */
export interface CodeValue {
  field: string;
  from: number;
  to: number;
}
/** `typed` gives back the program as it is then. */
export interface EditorHost {
  typed(changes: { from: number; to: number; insert: string }[]): string;
  moved(offset: number, line: number): void;
  /** What is told of a place of a line where the pointer rests; null: nothing. */
  pointed: Pointed;
}
/** Its name, and what it says by itself: the editor's own English words with those to be shown. */
export interface EditorWords {
  label: string;
  phrases: Record<string, string>;
}
/** Places are those in the text as it is then. */
export interface Shown {
  text: string;
  marks?: LineMarks;
  problems?: Mark[];
  values?: { all: CodeValue[]; lit: string | null }; // of the open call, and which of them is in focus
}
export interface Editor {
  view: EditorView;
  setWords(words: EditorWords): void;
  /** Remembers what is in sight, and brings it there again. */
  keepPlace(): () => void;
  setDialect(dialect: Dialect): void;
  /**
   * false: the program is so long, and so much of it new, that its lines have to be put together first (document.ts).
   */
  takes(text: string): boolean;
  /** What is told and differs, in one step: each by itself lays out the page once more. */
  set(next: Shown): void;
  select(offset: number): void;
  selectLine(line: number): void;
}

interface Change {
  from: number;
  to: number;
  insert: string | Text;
}

const LANGUAGES: Record<Dialect, Extension> = { sinumerik, nct };
const MUCH = 20_000; // characters, some hundred lines
// as in small.css: long lines are wrapped
const small = matchMedia("(max-width: 560px), (max-width: 1199px) and (max-height: 500px)");
const marksEffect = StateEffect.define<LineMarks>();
const valuesEffect = StateEffect.define<NonNullable<Shown["values"]>>();

/** What a call came to, behind it. */
class Hint extends WidgetType {
  constructor(readonly text: string) {
    super();
  }
  override eq(other: Hint): boolean {
    return other.text === this.text;
  }
  toDOM(): HTMLElement {
    return el("span", { class: "cm-hint" }, this.text);
  }
  override ignoreEvent(): boolean {
    return false;
  }
}

function decorate(state: EditorState, marks: LineMarks): DecorationSet {
  const classes = new Map<number, string>();
  for (const call of marks.calls)
    for (let line = call.from; line <= Math.min(call.to, state.doc.lines); line++)
      classes.set(line, call.open ? "cm-call-open" : "cm-call");
  if (marks.step !== null && marks.step >= 1 && marks.step <= state.doc.lines)
    classes.set(marks.step, `${classes.get(marks.step) ?? ""} cm-step`);
  const lines = [...classes].map(([line, name]) =>
    Decoration.line({ class: name.trim() }).range(state.doc.line(line).from),
  );
  const hints = (marks.hints ?? []).filter(({ line }) => line >= 1 && line <= state.doc.lines);
  const behind = hints.map(({ line, text }) =>
    Decoration.widget({ widget: new Hint(text), side: 1 }).range(state.doc.line(line).to),
  );
  return Decoration.set([...lines, ...behind], true);
}

const marksField = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(value, transaction) {
    for (const effect of transaction.effects)
      if (effect.is(marksEffect)) return decorate(transaction.state, effect.value);
    return value.map(transaction.changes);
  },
  provide: field => EditorView.decorations.from(field),
});

const valuesField = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(value, { state, effects, changes }) {
    for (const effect of effects) if (effect.is(valuesEffect)) return valued(state, effect.value);
    return value.map(changes);
  },
  provide: field => EditorView.decorations.from(field),
});

function valued(state: EditorState, { all, lit }: NonNullable<Shown["values"]>): DecorationSet {
  const inside = all.filter(({ from, to }) => from < to && to <= state.doc.length);
  const marks = inside.map(({ field, from, to }) => {
    const name = field === lit ? "cm-value cm-lit" : "cm-value";
    return Decoration.mark({ class: name, attributes: { "data-field": field } }).range(from, to);
  });
  return Decoration.set(marks, true);
}

/** The keys that the page's sheet names, in CodeMirror's way of writing. */
type Own = Exclude<Command<"editor">, "leave-editor">;
const commands = (host: EditorHost): Record<Own, CodeCommand> => ({
  find: openSearchPanel,
  "next-problem": nextDiagnostic,
  problems: openLintPanel,
  tell: tell((line, at) => host.pointed(line, at)),
  untell,
});
const own = (host: EditorHost): KeyBinding[] =>
  Object.entries(commands(host)).flatMap(([command, run]) =>
    KEYS.editor[command as Own].map((key: string) => {
      const [name = "", ...held] = partsOf(key).reverse();
      const parts = [
        ...held.reverse().map(one => one.replace("Ctrl", "Mod")),
        name.length === 1 ? name.toLowerCase() : name,
      ];
      return { key: parts.join("-"), run, preventDefault: name !== "Escape" };
    }),
  );

function speaking({ label, phrases }: EditorWords): Extension {
  return [EditorState.phrases.of(phrases), EditorView.contentAttributes.of({ "aria-label": label })];
}

/** A character without a picture of its own; of a held byte its figures. */
function special(code: number, description: string | null, placeholder: string): HTMLElement {
  const byte = heldByte(code);
  const name = byte ?? description ?? "";
  return el(
    "span",
    { class: byte ? "cm-specialChar cm-held" : "cm-specialChar", title: name, "aria-label": name },
    byte ?? placeholder,
  );
}

export function createEditor(box: HTMLElement, words: EditorWords, host: EditorHost): Editor {
  const root = box.attachShadow({ mode: "open" });
  const language = new Compartment();
  const spoken = new Compartment();
  const wrapping = new Compartment();
  const wrapped = (): Extension => (small.matches ? EditorView.lineWrapping : []);
  let held = ""; // the program that is shown, with its own line breaks
  let looked: { held: string; text: string; edit: Splice | null } | null = null; // the last two that were compared
  let ours = false; // a change made by the page, not by the user
  let dialect: Dialect = "sinumerik";

  const listen = EditorView.updateListener.of(update => {
    if (ours) return;
    if (update.docChanged) {
      const changes: { from: number; to: number; insert: string }[] = [];
      update.changes.iterChanges((from, to, _a, _b, inserted) =>
        changes.push({ from, to, insert: inserted.toString() }),
      );
      held = host.typed(changes);
    }
    const { head } = update.state.selection.main;
    if (update.selectionSet || update.docChanged) host.moved(head, update.state.doc.lineAt(head).number);
  });
  const view = new EditorView({
    parent: root,
    root,
    state: EditorState.create({
      extensions: [
        lineNumbers(),
        lintGutter(),
        wrapping.of(wrapped()),
        drawSelection(),
        highlightSpecialChars({ addSpecialChars: HELD_BYTE, render: special }),
        highlightActiveLine(),
        highlightActiveLineGutter(),
        search({ top: true }),
        highlightSelectionMatches(),
        marksField,
        valuesField,
        language.of(LANGUAGES[dialect]),
        theme,
        underPointer((line, at) => host.pointed(line, at)),
        atCaret,
        tooltips({ tooltipSpace: ({ dom }) => dom.getBoundingClientRect() }), // it is cut off beyond
        listen,
        keymap.of([...own(host), ...searchKeymap, ...lintKeymap, ...defaultKeymap]),
        spoken.of(speaking(words)),
        EditorView.contentAttributes.of({ tabindex: "0", autocapitalize: "characters", spellcheck: "false" }),
      ],
    }),
  });
  /** What makes the shown program this one; null: it is that; undefined: its lines are not put together yet. */
  const changeTo = (text: string): Change | null | undefined => {
    if (looked?.held !== held || looked.text !== text) looked = { held, text, edit: difference(held, text) };
    const { edit } = looked;
    if (!edit) return null;
    const { doc } = view.state;
    if (edit.insert.length > LONG) {
      const lines = linesOf(text);
      return lines && { from: 0, to: doc.length, insert: lines };
    }
    const after = toEditor(text, text.length) - toEditor(text, edit.from + edit.insert.length);
    return { from: toEditor(text, edit.from), to: doc.length - after, insert: edit.insert };
  };
  small.addEventListener("change", () => view.dispatch({ effects: wrapping.reconfigure(wrapped()) }));
  const apply = (run: () => void): void => {
    ours = true;
    try {
      run();
    } finally {
      ours = false;
    }
  };
  /**
   * A view that is hidden or out of sight takes all that is new for what is seen, and would lay out every line: of a
   * state that is set it lays out a piece only.
   */
  const show = (step: Transaction, change: Change | null | undefined): void => {
    if (change && change.insert.length > MUCH) view.setState(step.state);
    else view.dispatch(step);
  };
  const select = (offset: number): void => {
    const at = Math.min(offset, view.state.doc.length);
    const { from } = view.state.doc.lineAt(at);
    // With the start of its line where both fit: scrolled to the right, shorter lines look empty.
    const room = view.scrollDOM.clientWidth - view.contentDOM.offsetLeft;
    const fits = (at - from) * view.defaultCharacterWidth < room;
    const seen = EditorView.scrollIntoView(fits ? from : at);
    apply(() => view.dispatch({ selection: EditorSelection.cursor(at), effects: seen }));
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
    takes: text => changeTo(text) !== undefined,
    set({ text, marks, problems, values }) {
      const change = changeTo(text);
      if (change && change.to - change.from > LONG) keepLines(held, view.state.doc);
      held = text;
      const told = problems ? [setDiagnostics(view.state, problems).effects ?? []].flat() : [];
      const effects = [
        ...(marks ? [marksEffect.of(marks)] : []),
        ...(values ? [valuesEffect.of(values)] : []),
        ...told,
      ];
      const step = change ? { changes: change } : {};
      if (change || effects.length) apply(() => show(view.state.update({ ...step, effects }), change));
      if (change && view.hasFocus) select(change.from + change.insert.length);
    },
    setDialect(next) {
      if (next === dialect) return;
      dialect = next;
      apply(() => view.dispatch({ effects: language.reconfigure(LANGUAGES[next]) }));
    },
    select,
    selectLine: line => select(view.state.doc.line(Math.max(1, Math.min(line, view.state.doc.lines))).from),
  };
}
