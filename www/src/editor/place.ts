// The editor outlives the view around it: when the language changes, its box moves into the new view with text, undo
// and cursor.

import { el } from "../dom";
import { learn } from "../eol";
import { type Job, LONG, type Pace, within } from "../pace";
import type { Editor, EditorHost } from "./editor";
import { editorWords } from "./words";

export interface EditorPlace {
  readonly box: HTMLElement;
  readonly editor: Editor | null;
  /** It reports to the host of the view that stands now. */
  serve(host: EditorHost): void;
  /** Fetches the editor unless it is there or on its way. */
  fetch(): void;
  /** Whether the editor is there and can show this program at once. */
  takes(text: string): boolean;
  /** Makes everything ready for this program to be shown at once. */
  prepare(text: string, pace: Pace): Promise<void>;
  /** The same beside the page, unless it is under way. */
  lay(text: string): void;
}

/**
 * `laying`: the work on a program that the page already has; `calm`: the editor is not fetched before; `ready` is
 * called when it is there.
 */
export function createEditorPlace(laying: Job, calm: Promise<void>, ready: () => void): EditorPlace {
  const box = el("div", { class: "editor" });
  let editor: Editor | null = null;
  let fetching = false;
  let host: EditorHost | null = null;
  let laid: string | null = null; // what is or was last made ready
  const through: EditorHost = {
    typed: changes => host?.typed(changes) ?? "",
    moved: (offset, line) => host?.moved(offset, line),
    pointed: (line, at) => host?.pointed(line, at) ?? null,
  };
  const start = async (): Promise<void> => {
    const { createEditor } = await import("./editor");
    editor = createEditor(box, editorWords(), through);
    ready();
  };
  const prepare = async (text: string, pace: Pace): Promise<void> => {
    if (text.length <= LONG) return;
    const { putTogether } = await import("./document");
    await learn(text, within(pace, 0, 0.2));
    await putTogether(text, within(pace, 0.2, 1));
  };
  return {
    box,
    prepare,
    get editor() {
      return editor;
    },
    serve(next) {
      host = next;
      editor?.setWords(editorWords());
    },
    fetch() {
      if (fetching) return;
      fetching = true;
      void calm.then(start);
    },
    takes: text => editor?.takes(text) ?? false,
    lay(text) {
      if (laying.busy() && laid === text) return;
      laid = text;
      void laying.start(text.length, pace => prepare(text, pace));
    },
  };
}
