// The file that the program comes from: its name, its encoding to be chosen, and what stands in the way of saving it
// so.

import type { Actions } from "../desk/actions";
import { difference } from "../difference";
import { el, on, setAttribute, setText, show } from "../dom";
import { ENCODINGS, type Encoding, hasAll, lacking } from "../encoding";
import { lineAt } from "../eol";
import type { ProgramFile } from "../state/files";
import { t } from "../texts";

export interface Origin {
  root: HTMLElement;
  /** A character that the encoding lacks. */
  told: HTMLElement;
  draw(file: ProgramFile, text: string, unsaved: boolean): void;
  /** The program was to be saved and cannot be. */
  refuse(): void;
}

const UNSAVED = "●";
/** A longer program is not searched in every encoding: only those that have all characters are offered. */
const SEARCHED = 2 ** 20;

const isMarked = (encoding: Encoding): boolean => encoding.endsWith("-marked");
const nameOf = (encoding: Encoding): string => t(`encoding-${encoding}`);

/** Where the first character stands that the encoding lacks. While there is none only what is new is looked at. */
function createSearch(): (text: string, encoding: Encoding) => number {
  let known = { text: "", encoding: "utf-8" as Encoding, at: -1 };
  const found = (text: string, encoding: Encoding): number => {
    if (hasAll(encoding)) return -1;
    if (known.encoding !== encoding || known.at >= 0) return lacking(text, encoding);
    const edit = difference(known.text, text);
    return edit ? lacking(text, encoding, edit.from, edit.from + edit.insert.length) : -1;
  };
  return (text, encoding) => {
    if (known.text !== text || known.encoding !== encoding) known = { text, encoding, at: found(text, encoding) };
    return known.at;
  };
}

/** The other encodings that have all characters of a program. */
function holding(text: string, now: Encoding): Encoding[] {
  const holds = (one: Encoding): boolean => hasAll(one) || (text.length <= SEARCHED && lacking(text, one) < 0);
  return ENCODINGS.filter(one => one !== now && holds(one));
}

/** A button that saves in an encoding which has all characters, UTF-8 at first, and the choice of another one. */
function createSaveAs(save: (encoding: Encoding) => void): {
  button: HTMLButtonElement;
  choice: HTMLSelectElement;
  draw(text: string, now: Encoding): void;
} {
  const button = el("button", { type: "button" });
  const choice = el("select", { "aria-label": t("encoding-save") });
  const name = (): void => setText(button, t("encoding-save-as", { encoding: nameOf(choice.value as Encoding) }));
  on(choice, "change", name);
  on(button, "click", () => save(choice.value as Encoding));
  let drawn: { text: string; now: Encoding } | null = null;
  return {
    button,
    choice,
    draw(text, now) {
      if (drawn?.text === text && drawn.now === now) return;
      drawn = { text, now };
      const wanted = choice.value;
      const offered = holding(text, now);
      choice.replaceChildren(...offered.map(one => el("option", { value: one }, nameOf(one))));
      if (offered.some(one => one === wanted)) choice.value = wanted;
      name();
    },
  };
}

/** `again`: the bytes are read in another encoding. */
export function createOrigin(
  actions: Actions,
  again: (encoding: Encoding) => void,
  goTo: (offset: number) => void,
  save: () => void,
): Origin {
  const name = el("span", { class: "file-name" });
  const mark = el(
    "span",
    { class: "unsaved", role: "img", "aria-label": t("program-unsaved"), title: t("program-unsaved") },
    UNSAVED,
  );
  const option =
    (how: string) =>
    (encoding: Encoding): HTMLOptionElement =>
      el("option", { value: `${how} ${encoding}` }, nameOf(encoding));
  const read = ENCODINGS.map(option("read"));
  const choice = el(
    "select",
    { class: "encoding", "aria-label": t("encoding") },
    el("optgroup", { label: t("encoding-read") }, ...read),
    el("optgroup", { label: t("encoding-save") }, ...ENCODINGS.map(option("save"))),
  );
  const text = el("p", { class: "problem", "data-severity": "warning", role: "status" });
  const saveAs = createSaveAs(encoding => {
    actions.encoding(encoding);
    save();
  });
  const where = el("button", { type: "button", class: "quiet" }, t("encoding-show"));
  const told = el("div", { class: "lacking", hidden: true }, text, saveAs.button, saveAs.choice, where);
  const search = createSearch();
  let at = -1;
  let now: Encoding = "utf-8";

  on(choice, "change", () => {
    const [how, wanted] = choice.value.split(" ") as [string, Encoding];
    choice.value = `read ${now}`;
    if (how === "save") actions.encoding(wanted);
    else again(wanted);
  });
  on(where, "click", () => goTo(at));

  return {
    root: el("div", { class: "origin" }, mark, name, choice),
    told,
    refuse: () => saveAs.button.focus(),
    draw(file, program, unsaved) {
      now = file.encoding;
      at = search(program, now);
      show(mark, unsaved);
      document.title = `${unsaved ? `${UNSAVED} ` : ""}${file.name} — ${t("app-name")}`;
      setText(name, file.name);
      setAttribute(name, "title", file.name);
      ENCODINGS.forEach((one, index) => {
        const node = read[index];
        if (node) show(node, one === now || !isMarked(one));
      }); // the bytes tell whether there is a mark
      choice.value = `read ${now}`;
      show(told, at >= 0);
      if (at < 0) return;
      saveAs.draw(program, now);
      const line = lineAt(program, at);
      setText(
        text,
        t("encoding-lacking", {
          line,
          character: String.fromCodePoint(program.codePointAt(at) ?? 0),
          encoding: nameOf(now),
        }),
      );
    },
  };
}
