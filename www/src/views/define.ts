// What a definition file adds to the machine, before it is added.

import type { ProgramCore } from "../core/program";
import type { Actions } from "../desk/actions";
import { sameName } from "../desk/beside";
import { el, on, setText } from "../dom";
import { besideOf, profile, programMachine } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import { profileName } from "./profile";

export function createDefine(
  store: Store,
  actions: Actions,
  core: () => ProgramCore | null,
): { dialog: HTMLDialogElement; open(name: string): void } {
  const title = el("h2", { id: "define-title" });
  const what = el("p");
  const lines = el("pre", { class: "define-lines", tabindex: "0", "aria-labelledby": "define-title" });
  const apply = el("button", { type: "button", class: "primary" }, t("define-apply"));
  const cancel = el("button", { type: "button" }, t("define-cancel"));
  const dialog = el(
    "dialog",
    { class: "define", "aria-labelledby": "define-title" },
    title,
    what,
    lines,
    el("div", { class: "actions" }, cancel, apply),
  );
  let name = "";
  on(cancel, "click", () => dialog.close());
  on(apply, "click", () => {
    dialog.close();
    actions.define(name);
  });
  return {
    dialog,
    open(wanted) {
      const { state } = store;
      const { control } = state.form;
      const file = besideOf(state).with?.find(one => sameName(one.name, wanted));
      const asked = { control, ...programMachine(state) };
      const before = core()?.equip(asked).setup.definitions ?? [];
      const after = file && core()?.equip({ ...asked, change: { define: file.text } }).setup.definitions;
      if (!file) return;
      name = file.name;
      const added = (after ?? []).slice(before.length);
      setText(title, t("define-title", { name, machine: profileName(profile(state)) }));
      setText(what, t(added.length ? "define-what" : "define-nothing", { count: added.length }));
      setText(lines, added.join("\n"));
      lines.hidden = added.length === 0;
      apply.disabled = added.length === 0;
      dialog.showModal();
    },
  };
}
