// The program's file in the first line of the page: its name, whether it is saved, and what is done with it.

import { el, on, setAttribute, setText, show } from "../dom";
import { type IconName, icon } from "../icons";
import { KEYS } from "../keys";
import { fileOf } from "../state/files";
import { isUnsaved } from "../state/saved";
import type { State } from "../state/state";
import { t } from "../texts";
import { createMenu } from "./menu";

/** What is done with the program as a whole. */
export interface FileActions {
  open(): void;
  save(): void;
  copy(): void;
}

function entry(of: IconName, words: string, run: () => void, key = ""): HTMLButtonElement {
  const shortcut = key && el("kbd", { "aria-hidden": "true" }, key);
  const node = el("button", { type: "button" }, icon(of), el("span", {}, t(words)), shortcut || null);
  on(node, "click", run);
  return node;
}

export function createFileMenu(files: FileActions): { root: HTMLElement; draw(state: State): void } {
  const mark = el("span", { class: "top-unsaved", role: "img", "aria-label": t("program-unsaved") });
  const name = el("span", { class: "top-file" });
  const encoding = el("p", { class: "menu-note" });
  const menu = createMenu(
    "file-menu",
    t("program-file"),
    [
      entry("open", "program-open", files.open, KEYS.page.open[0]),
      entry("save", "program-save", files.save, KEYS.page.save[0]),
      entry("copy", "program-copy-all", files.copy),
      encoding,
    ],
    [name, mark, icon("down")],
    { class: "quiet file-open" },
  );
  return {
    root: el("div", { class: "file" }, menu.button, menu.list),
    draw(state) {
      const file = fileOf(state);
      const unsaved = isUnsaved(state);
      setText(name, file.name);
      show(mark, unsaved);
      const said = `${file.name}${unsaved ? ` · ${t("program-unsaved")}` : ""}`;
      setAttribute(menu.button, "title", said);
      setAttribute(menu.button, "aria-label", said);
      setText(encoding, `${t("encoding")}: ${t(`encoding-${file.encoding}`)}`);
    },
  };
}
