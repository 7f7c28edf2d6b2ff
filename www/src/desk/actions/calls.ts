// Calls of the program: opened, written, inserted.

import { lineBegin, lineBreak, lineEnd, type Splice } from "../../eol";
import { AT_END, patched, programOf, remember, type State } from "../../state/state";
import type { Style } from "../../wire";
import { opened } from "../calls";
import { aroundAt } from "../derive";
import { isRead, withEdits } from "../program";
import type { Acting } from "./acting";

export interface CallsActions {
  cursor(offset: number, line: number): void;
  openCall(index: number): void;
  /** Way of writing of the snippet; empty: as the machine has it. */
  style(style: State["snippet"]["style"]): void;
  /** The call in the form, in the program, in another way of writing; or all calls. It is shown before it is done. */
  convert(style: Style, all?: boolean): void;
  insert(snippet: string): void;
  /** A block around the call is wanted from now on, and the blocks are shown. */
  around(name: string): void;
  /** A call is inserted, with the lines before it, and comes into the form. */
  write(cycle: string, values: Record<string, string>, text: string): void;
}

export function createCallsActions({ store, now }: Acting): CallsActions {
  const actions: CallsActions = {
    cursor: (cursor, cursorLine) =>
      store.update(state => ({
        program: { cursor, line: cursorLine },
        desk: { follow: state.desk.follow ?? "cursor" },
      })),
    openCall(index) {
      const state = now();
      const call = isRead(state) ? state.program.reading?.view.calls[index] : undefined;
      store.update(call ? opened(state, call) : { desk: { sought: { call: index } } });
    },
    style: style => store.update({ snippet: { style } }),
    convert: (style, all = false) =>
      store.update(state => {
        const at = state.form.open ?? (all ? 0 : null);
        return at === null ? {} : { desk: { converting: { at, style, all } } };
      }),
    insert(snippet) {
      const state = now();
      const place = insertion(programOf(state), state.program.cursor, snippet);
      const to = place.from + place.insert.length;
      const next = withEdits(state, [place]);
      store.update(
        patched(next, {
          program: { cursor: to },
          form: { open: null },
          desk: { sought: { from: place.from, to }, pending: next.desk.pending.filter(one => !one.asks) },
          page: { notice: "notice-inserted", offer: false },
        }),
      );
      store.flush(); // the editor has to hold it before the next key
    },
    around(name) {
      const at = aroundAt(now());
      const { around } = now().snippet;
      const blocks = around?.at === at ? around.blocks : null;
      store.update({ snippet: { around: { at, blocks: { ...blocks, [name]: blocks?.[name] ?? {} } } } });
      store.flush(); // who wants it goes on in it
    },
    write(cycle, values, text) {
      const state = now();
      store.update(remember(state), {
        form: { cycle, values, open: null, around: null, resets: {}, touched: {}, checked: true },
        view: { step: AT_END, source: "form" },
        panels: { panel: "form", left: "form" },
      });
      actions.insert(text);
    },
  };
  return actions;
}

/** Lines with which a program begins, before its first block; between them comments may stand. */
const HEAD = /^\s*(?:%|O\d|;\s*\$PATH|(?:N\d+\s*)?(?:PROC|DEF|REDEF|DEFINE|EXTERN)\b)/i;
const BETWEEN = /^\s*(?:;.*|\(.*\)\s*)?$/;

/** Where the head of a program ends. */
function headEnd(text: string): number {
  let end = 0;
  let from = 0;
  while (from < text.length) {
    const next = lineEnd(text, from);
    const line = text.slice(from, next).replace(/[\r\n]+$/, "");
    if (HEAD.test(line)) end = next;
    else if (!BETWEEN.test(line)) break;
    from = next;
  }
  return end;
}

/** Whole lines before the line of the cursor, or after the last line when the cursor stands at its end. */
function insertion(text: string, cursor: number, snippet: string): Splice {
  const eol = lineBreak(text);
  const body = snippet.replace(/\n+$/, "").replaceAll("\n", eol);
  const head = headEnd(text);
  const open = text.length > 0 && !/[\r\n]$/.test(text); // the last line has no end
  if (open && (cursor >= text.length || head === text.length))
    return { from: text.length, to: text.length, insert: eol + body + eol };
  const start = Math.max(head, lineBegin(text, cursor));
  return { from: start, to: start, insert: body + eol };
}
