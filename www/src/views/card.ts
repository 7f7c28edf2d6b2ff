// A card about one thing that was looked up: what a result or an alarm means, what helps, which cycles have it.

import type { Actions } from "../desk/actions";
import { el, on, setText, show } from "../dom";
import type { Card, State } from "../state/state";
import { listed, optional, say, t } from "../texts";
import type { CycleInfo } from "../wire";

export interface CardView {
  dialog: HTMLDialogElement;
  draw(state: State): void;
}

/** A heading with a text below it; without a text neither is shown. */
function told(key: string): { parts: HTMLElement[]; set(text: string): void } {
  const text = el("p", {});
  const parts = [el("h3", {}, t(key)), text];
  return {
    parts,
    set: what => {
      setText(text, what);
      for (const part of parts) show(part, what !== "");
    },
  };
}

export function createCard(actions: Actions): CardView {
  const title = el("h2", { id: "card-title" });
  const meaning = el("p", { class: "card-meaning" });
  const cause = told("card-cause");
  const cure = told("card-cure");
  const lines = el("div", {});
  const partsTitle = el("h3", {}, t("card-parts"));
  const parts = el("ul", { class: "card-parts" });
  const cyclesTitle = el("h3", {});
  const cycles = el("ul", { class: "card-cycles" });
  const others = el("p", {});
  const close = el("button", { type: "button", class: "primary" }, t("card-close"));
  const dialog = el(
    "dialog",
    { class: "about card", "aria-labelledby": "card-title" },
    title,
    meaning,
    ...cause.parts,
    ...cure.parts,
    lines,
    partsTitle,
    parts,
    cyclesTitle,
    cycles,
    others,
    el("div", { class: "actions" }, close),
  );
  on(close, "click", () => dialog.close());
  on(dialog, "close", () => actions.card(null));
  let drawn: State["page"]["card"] = null;

  const entry = (cycle: CycleInfo): HTMLElement => {
    const open = el(
      "button",
      { type: "button", class: "quiet" },
      el("code", {}, cycle.cycle),
      ` ${t(`${cycle.key}-title`)}`,
    );
    on(open, "click", () => {
      dialog.close();
      actions.chooseCycle(cycle);
      actions.panel("form");
    });
    return el("li", {}, open);
  };
  const fill = (card: Card): void => {
    const { kind, code, key, told } = card;
    setText(title, t(`card-${kind}`, { code }));
    setText(meaning, t(key));
    cause.set(optional(`${key}.cause`));
    cure.set(optional(`${key}.cure`));
    const help = told ? optional(told.help) : "";
    lines.replaceChildren(...[help, ...(told?.lines ?? []).map(say)].filter(Boolean).map(line => el("p", {}, line)));
    show(partsTitle, !!told?.parts.length);
    parts.replaceChildren(
      ...(told?.parts ?? []).map(part => el("li", {}, el("code", {}, part.name), ` ${t(part.key)}`)),
    );
    show(cyclesTitle, card.cycles.length + card.others.length > 0);
    setText(cyclesTitle, t(`card-${kind}-cycles`));
    cycles.replaceChildren(...card.cycles.map(entry));
    setText(others, listed(card.others));
  };
  return {
    dialog,
    draw({ page: { card } }) {
      if (card === drawn) return;
      drawn = card;
      if (!card) return;
      fill(card);
      if (!dialog.open) dialog.showModal();
    },
  };
}
