// The editor outlives the view around it: when the language changes, its box moves into the new view with text, undo and cursor.

import { el } from "../dom";
import type { Editor, EditorHost } from "./editor";
import { editorWords } from "./words";

export interface EditorPlace {
  readonly box: HTMLElement;
  readonly editor: Editor | null;
  /** Fetches the editor unless it is there or on its way; it reports to the host of the view that stands now. */
  serve(host: EditorHost): void;
  fetch(): void;
}

export function createEditorPlace(ready: () => void): EditorPlace {
  const box = el("div", { class: "editor" });
  let editor: Editor | null = null;
  let fetching = false;
  let host: EditorHost | null = null;
  const through: EditorHost = { typed: (changes) => host?.typed(changes), moved: (offset, line) => host?.moved(offset, line) };
  const start = async (): Promise<void> => {
    const { createEditor } = await import("./editor");
    editor = createEditor(box, editorWords(), through);
    ready();
  };
  return {
    box,
    get editor() { return editor; },
    serve(next) {
      host = next;
      editor?.setWords(editorWords());
    },
    fetch() {
      if (fetching) return;
      fetching = true;
      void start();
    },
  };
}
