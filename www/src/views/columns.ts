// The columns of a text, put together by choosing: each with its name and a way to take it out, a list of what can be
// added, and the lines as they are printed. The text itself stays in its entry, where it can be typed too.

import { choicesIn, el, keyed, on, setAttribute, setText, show } from "../dom";
import { icon } from "../icons";
import { say, t } from "../texts";
import type { Columns, Field } from "../wire";

export interface ColumnsView {
  root: HTMLElement;
  update(field: Field): void;
}

/** What the field says of its columns; none where its text lists no columns. */
export function columnsOf(field: Field): Columns | undefined {
  return field.kind === "text" ? field.columns : undefined;
}

/** `put`: the whole text, as typed; with `caret`, typing goes on there. */
export function createColumns(id: string, put: (text: string, caret?: number) => void): ColumnsView {
  let now: Columns | undefined;
  const list = el("ul", { class: "columns-list" });
  const choice = el("select", { class: "choice", id: `${id}-columns` });
  const button = el("button", { type: "button", class: "columns-add" });
  const note = el("span", { class: "columns-note" });
  const lines = el("pre", { class: "columns-printed", tabindex: "0" });
  const marked = el("pre", { class: "columns-marked" });
  const beyond = el("div", {}, el("span", { class: "columns-note" }, t("columns-marked")), marked);
  const narrow = el("ul", { class: "columns-narrow" });
  const root = el(
    "div",
    { class: "columns" },
    list,
    el("div", { class: "columns-tools" }, choice, button, note),
    lines,
    beyond,
    narrow,
  );

  on(button, "click", () => {
    const offer = now?.offers[Number(choice.value)];
    if (now && offer) put(now.before + offer.text + now.after, offer.text === "" ? now.before.length : undefined);
  });

  const createChip = (): HTMLElement => {
    const remove = el("button", { type: "button", class: "columns-remove" }, icon("close"));
    return el("li", { class: "columns-chip" }, el("span", {}), remove);
  };

  return {
    root,
    update(field) {
      now = columnsOf(field);
      show(root, now !== undefined);
      if (!now) return;
      const count = now.list.length;
      setAttribute(list, "aria-label", t("columns-list", { name: say(field.label) }));
      keyed(
        list,
        now.list.map((column, index) => ({ column, index })),
        ({ index }) => String(index),
        createChip,
        (node, { column, index }) => {
          const [name, remove] = node.children as unknown as [HTMLElement, HTMLButtonElement];
          setText(name, say(column.label));
          setAttribute(remove, "aria-label", t("columns-remove", { name: say(column.label) }));
          remove.onclick = () => {
            if (index === count - 1) button.focus(); // this button goes
            put(column.without);
          };
        },
      );
      show(list, count > 0);
      const offers = now.offers.map((offer, index) => ({
        value: String(index),
        text: offer.text ? `${say(offer.label)} · ${offer.text}` : say(offer.label),
      }));
      choicesIn(choice, offers);
      show(choice, now.offers.length > 1);
      setText(button, t("columns-add"));
      setAttribute(choice, "aria-label", t("columns-choice", { name: say(field.label) }));
      setText(note, now.offers.length > 1 ? t("columns-note") : "");
      setText(lines, now.printed.join("\n"));
      setAttribute(lines, "aria-label", t("columns-printed", { name: say(field.label) }));
      show(lines, now.printed.length > 0);
      setText(marked, now.marked);
      show(beyond, now.marked !== "");
      keyed(
        narrow,
        now.narrow.map((message, index) => ({ message, index })),
        ({ index }) => String(index),
        () => el("li", {}),
        (node, { message }) => setText(node, say(message)),
      );
      show(narrow, now.narrow.length > 0);
    },
  };
}
