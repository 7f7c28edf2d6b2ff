// A card about one thing that was looked up: what a result or an alarm means, what helps, which cycles have it.

import type { Actions } from "../actions";
import { el, on, setText, show } from "../dom";
import { say, optional, t } from "../texts";
import type { State } from "../state";
import type { CycleInfo } from "../wire";
import type { Derived } from "../derive";

export interface CardView { dialog: HTMLDialogElement; draw(state: State, derived: Derived): void }

function has(cycle: CycleInfo, { kind, code, key }: NonNullable<State["card"]>): boolean {
  return kind === "alarm" ? cycle.alarms.some((one) => one.code === code && one.key === key) : cycle.results.some((one) => one.name === code && one.key === key);
}

export function createCard(actions: Actions): CardView {
  const title = el("h2", { id: "card-title" });
  const meaning = el("p", { class: "card-meaning" });
  const cureTitle = el("h3", {}, t("card-cure"));
  const cure = el("p", {});
  const cyclesTitle = el("h3", {});
  const cycles = el("ul", { class: "card-cycles" });
  const close = el("button", { type: "button", class: "primary" }, t("card-close"));
  const dialog = el("dialog", { class: "about card", "aria-labelledby": "card-title" },
    title, meaning, cureTitle, cure, cyclesTitle, cycles, el("div", { class: "actions" }, close));
  on(close, "click", () => dialog.close());
  on(dialog, "close", () => actions.card(null));
  let drawn: State["card"] = null;

  const entry = (cycle: CycleInfo): HTMLElement => {
    const open = el("button", { type: "button", class: "quiet" }, el("code", {}, cycle.cycle), ` ${t(`${cycle.key}-title`)}`);
    on(open, "click", () => { dialog.close(); actions.chooseCycle(cycle); actions.panel("form"); });
    return el("li", {}, open);
  };
  const fill = (card: NonNullable<State["card"]>, derived: Derived): void => {
    const { kind, code, key, control } = card;
    const found = derived.catalogue.cycles.filter((cycle) => cycle.control === control && has(cycle, card));
    const result = found.flatMap((cycle) => cycle.results).find((one) => one.name === code && one.key === key);
    const told = optional(`${key}.cure`);
    setText(title, t(`card-${kind}`, { code, control: t(`control-${control}`) }));
    setText(meaning, say({ key, args: {} }));
    for (const part of [cureTitle, cure]) show(part, told !== "");
    setText(cure, told);
    setText(cyclesTitle, t(`card-${kind}-cycles`));
    cycles.replaceChildren(...found.map(entry));
    if (result) setText(meaning, `${t(key)}. ${t("field-source", { source: result.source })}`);
  };
  return {
    dialog,
    draw({ card }, derived) {
      if (card === drawn) return;
      drawn = card;
      if (!card) return;
      fill(card, derived);
      if (!dialog.open) dialog.showModal();
    },
  };
}
