// The program: editor with the calls marked, its buttons, and where the form edits.

import type { Actions } from "../actions";
import type { Derived } from "../derive";
import { el, keyed, on, setAttribute, setText, show } from "../dom";
import type { Editor } from "../editor/editor";
import { lineBreak, splice, toEditor, toProgram } from "../eol";
import type { State } from "../state";
import type { Store } from "../store";
import { say, t } from "../texts";
import { copyText } from "./form";

export interface ProgramView { draw(state: State, derived: Derived): void; goTo(offset: number): void; focus(): void }

export function createProgram(root: HTMLElement, store: Store, actions: Actions): ProgramView {
  const name = el("span", { class: "count" });
  const copy = el("button", { type: "button", class: "quiet" }, t("program-copy"));
  const open = el("button", { type: "button", class: "quiet" }, t("program-open"));
  const file = el("input", { type: "file", accept: ".mpf,.spf,.nc,.txt,.arc,.prg,text/plain", hidden: true, tabindex: "-1", "aria-label": t("program-open") });
  const download = el("button", { type: "button", class: "quiet" }, t("program-save"));
  const calls = el("ul", { class: "calls", "aria-label": t("program-calls") });
  const box = el("div", { class: "editor" });
  const waiting = el("p", { class: "empty" }, t("program-loading"));
  root.append(el("header", { class: "panel-head" }, el("h2", { id: "program-title" }, t("program-title")), name, calls, el("div", { class: "head-actions" }, open, file, download, copy)), waiting, box);

  let editor: Editor | null = null;
  let loading = false;
  let text = "";
  let last: Derived | null = null;
  let target: number | null = null;
  let inEditor: string | null = null; // the text that the editor holds
  let marked = "";

  on(copy, "click", () => void copyText(text, store, "notice-copied"));
  on(open, "click", () => file.click());
  on(file, "change", () => void (async () => {
    const chosen = file.files?.[0];
    if (chosen) store.update({ open: null });
    if (chosen) actions.editProgram(await readText(chosen));
    file.value = "";
  })());
  on(download, "click", () => saveFile(text, t(`program-file-${store.state.control}`)));

  const host = {
    typed(changes: { from: number; to: number; insert: string }[]): void {
      const eol = lineBreak(text);
      const edits = changes.map((one) => ({ from: toProgram(text, one.from), to: toProgram(text, one.to), insert: one.insert.replaceAll("\n", eol) }));
      text = splice(text, edits);
      inEditor = text;
      actions.editProgram(text);
    },
    moved: (offset: number): void => actions.cursor(toProgram(text, offset)),
  };
  const start = async (): Promise<void> => {
    loading = true;
    const { createEditor } = await import("../editor/editor");
    editor = createEditor(box, t("program-editor"), host);
    waiting.remove();
    last = null;
    store.update({});
  };
  const select = (offset: number): void => {
    target = null;
    editor?.select(toEditor(text, offset));
  };

  const drawCalls = (state: State, derived: Derived): void => {
    show(calls, derived.read.calls.length > 0);
    setText(name, derived.read.calls.length > 0 ? "" : t("program-no-call"));
    keyed(calls, derived.read.calls, (_, index) => String(index), () => {
      const item = el("li", {}, el("button", { type: "button", class: "call-chip" }));
      on(item, "click", () => { const index = Number(item.dataset.call); actions.openCall(index); const call = last?.read.calls[index]; if (call) select(call.from); });
      return item;
    }, (item, call, index) => {
      item.dataset.call = String(index);
      const button = item.firstElementChild;
      if (!button) return;
      setText(button, t("program-call", { cycle: call.cycle, line: call.lastLine }));
      setAttribute(button, "aria-pressed", String(state.open === index));
    });
  };

  return {
    draw(state, derived) {
      text = derived.program;
      if (!editor) {
        if (!loading) void start();
        last = derived;
        return drawCalls(state, derived);
      }
      editor.setDialect(state.control);
      if (text !== inEditor) editor.setText(text);
      inEditor = text;
      const step = state.source === "program" ? derived.trace?.entries[derived.step]?.line ?? null : null;
      const next = { step, calls: derived.read.calls.map((call, index) => ({ from: call.line, to: call.lastLine, open: index === state.open })) };
      if (marked !== JSON.stringify(next)) editor.setMarks(next);
      marked = JSON.stringify(next);
      if (last?.problems !== derived.problems || last.program !== text) editor.setProblems(marks(derived));
      if (target !== null) select(target);
      drawCalls(state, derived);
      last = derived;
    },
    goTo(offset) {
      actions.panel("program");
      target = offset;
      store.update({});
    },
    focus: () => editor?.view.focus(),
  };
}

function marks(derived: Derived) {
  const text = derived.program;
  const length = toEditor(text, text.length);
  return derived.problems.filter((one) => one.from !== undefined).map((one) => {
    const from = Math.min(toEditor(text, one.from ?? 0), length);
    const to = Math.min(Math.max(from, toEditor(text, one.to ?? one.from ?? 0)), length);
    const severity = one.severity === "note" ? "info" as const : one.severity;
    return { from, to, severity, message: `${one.code}  ${say(one.message)}${one.hint ? `\n${say(one.hint)}` : ""}` };
  });
}

/** UTF-8 where it is that, else Latin-1, in which every byte is a character. */
async function readText(file: File): Promise<string> {
  const bytes = await file.arrayBuffer();
  try {
    return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return Array.from(new Uint8Array(bytes), (byte) => String.fromCharCode(byte)).join("");
  }
}

export function saveFile(text: string, name: string, type = "text/plain"): void {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const link = el("a", { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
