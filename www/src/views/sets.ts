// Named sets of values of the chosen cycle: save, load, rename, delete.

import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { el, keyed, on, setAttribute, setText, show, showElse } from "../dom";
import { type State, setsOf } from "../state/state";
import { t } from "../texts";

export interface Sets {
  dialog: HTMLDialogElement;
  draw(state: State, derived: Derived): void;
}

export function createSets(actions: Actions): Sets {
  const title = el("h2", { id: "sets-title" });
  const name = el("input", { type: "text", id: "sets-name", autocomplete: "off", required: true });
  const save = el("button", { type: "submit", class: "primary" }, t("sets-save"));
  const form = el(
    "form",
    { class: "sets-new", method: "dialog" },
    el("label", { for: "sets-name" }, t("sets-name")),
    name,
    save,
  );
  const none = el("p", { class: "empty" }, t("sets-none"));
  const list = el("ul", { class: "sets" });
  const said = el("span", { role: "status" });
  const undo = el("button", { type: "button" }, t("undo"));
  const close = el("button", { type: "button" }, t("about-close"));
  const dialog = el(
    "dialog",
    { "aria-labelledby": "sets-title", class: "about" },
    title,
    form,
    none,
    list,
    el("div", { class: "actions" }, said, undo, close),
  );

  on(form, "submit", event => {
    event.preventDefault();
    if (!name.value.trim()) return;
    actions.saveSet(name.value.trim());
    name.value = "";
  });
  on(undo, "click", () => actions.step(1));
  on(close, "click", () => dialog.close());

  let before = ""; // what was said when it opened: that was no step of this dialog

  const make = (known: string): HTMLLIElement => {
    const input = el("input", {
      type: "text",
      autocomplete: "off",
      "aria-label": t("sets-rename", { name: known }),
      value: known,
    });
    const load = el("button", { type: "button", "aria-label": t("sets-load-named", { name: known }) }, t("sets-load"));
    const remove = el(
      "button",
      { type: "button", "aria-label": t("sets-delete-named", { name: known }) },
      t("sets-delete"),
    );
    on(input, "input", () => input.setCustomValidity(""));
    on(input, "change", () => {
      if (actions.renameSet(known, input.value.trim())) return;
      input.setCustomValidity(t("sets-name-taken"));
      input.reportValidity();
    });
    on(load, "click", () => {
      actions.loadSet(known);
      dialog.close();
    });
    on(remove, "click", () => {
      actions.deleteSet(known);
      name.focus();
    });
    return el("li", {}, input, load, remove);
  };

  return {
    dialog,
    draw(state, { cycle }) {
      const names = Object.keys(setsOf(state));
      setText(title, t("sets-title", { cycle: cycle.cycle }));
      show(none, names.length === 0);
      keyed(
        list,
        names,
        one => `${cycle.control}/${cycle.cycle}/${one}`,
        make,
        () => undefined,
      );
      const { notice, offer } = state.page;
      if (!dialog.open || !notice) before = notice;
      const own = offer && notice !== before;
      setText(said, own ? t(notice) : "");
      showElse(undo, own, close);
      setAttribute(undo, "disabled", !own);
    },
  };
}
