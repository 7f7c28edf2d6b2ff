// What the editor says by itself, in the page's language: its own English words with the keys of ours.

import { t } from "../texts";
import type { EditorWords } from "./editor";

const KEYS: Record<string, string> = {
  Find: "editor-find",
  Replace: "editor-replace-with",
  next: "editor-next",
  previous: "editor-previous",
  all: "editor-all",
  "match case": "editor-match-case",
  regexp: "editor-regexp",
  "by word": "editor-by-word",
  replace: "editor-replace",
  "replace all": "editor-replace-all",
  close: "editor-close",
  "current match": "editor-current-match",
  "on line": "editor-on-line",
  "replaced match on line $": "editor-replaced",
  "replaced $ matches": "editor-replaced-all",
  "Go to line": "editor-go-to-line",
  go: "editor-go",
  Diagnostics: "editor-problems",
  "No diagnostics": "editor-no-problems",
  "Selection deleted": "editor-deleted",
  "Control character": "editor-control-character",
};

export function editorWords(): EditorWords {
  return {
    label: t("program-editor"),
    phrases: Object.fromEntries(Object.entries(KEYS).map(([own, key]) => [own, t(key)])),
  };
}
