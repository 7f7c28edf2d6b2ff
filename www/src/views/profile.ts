// Which control, and which machine: a switch, and the machine profiles with what is done with them.

import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { el, keyed, on, setAttribute, setText, show } from "../dom";
import { type IconName, icon } from "../icons";
import { saveFile } from "../state/files";
import { profile, type State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import type { Dialect, Setup } from "../wire";

const CONTROLS: Dialect[] = ["sinumerik", "nct"];

/** What a profile is called; one from an earlier page may have no name. */
export function profileName(setup: Setup | undefined): string {
  return setup ? setup.name || t("profile-new") : t("profile-own");
}

/** The other profiles of both controls, by name. */
function others({ machine: { parked } }: State): readonly Setup[] {
  return [...parked].sort((a, b) => profileName(a).localeCompare(profileName(b)));
}

function controlSwitch(actions: Actions): { root: HTMLElement; draw(state: State): void } {
  const buttons = CONTROLS.map(control => {
    const button = el("button", { type: "button", "data-control": control }, t(`control-${control}`));
    on(button, "click", () => actions.chooseControl(control));
    return { control, button };
  });
  const root = el(
    "div",
    { class: "control-switch", role: "group", "aria-label": t("fact-control") },
    ...buttons.map(one => one.button),
  );
  const draw = ({ form }: State): void => {
    for (const { control, button } of buttons) setAttribute(button, "aria-pressed", String(form.control === control));
  };
  return { root, draw };
}

/** `control`: the switch in the first line; `root`: the profiles and what is done with them, in a menu. */
export interface Profiles {
  control: HTMLElement;
  root: HTMLElement;
  draw(state: State, derived: Derived): void;
}

/** Picks a setup file; it is part of the menu. */
export function createSetupFile(open: (file: File) => void): HTMLInputElement {
  const file = el("input", {
    type: "file",
    accept: "application/json,.json",
    hidden: true,
    tabindex: "-1",
    "aria-label": t("profile-import"),
  });
  on(file, "change", () => {
    const chosen = file.files?.[0];
    if (chosen) open(chosen);
    file.value = "";
  });
  return file;
}

/** The profile in use as a file; without one `derived`, the machine of the form with what its call needs. */
export function exportSetup(store: Store, derived: Setup | undefined): void {
  const setup = profile(store.state) ?? derived;
  if (setup) saveFile(JSON.stringify(setup, null, 2), fileName(setup), "application/json");
  else store.update({ page: { notice: "notice-nothing-to-save" } });
}

export function createProfile(
  store: Store,
  actions: Actions,
  file: HTMLInputElement,
  equipment: () => { open(): void } | null,
): Profiles {
  // in the first line where it has room, else in the menu
  const controls = [controlSwitch(actions), controlSwitch(actions)] as const;
  const list = el("ul", { class: "profile-list", "aria-label": t("profile-list") });
  const act = (of: IconName, key: string, run: () => void): HTMLButtonElement => {
    const button = el("button", { type: "button", class: "quiet", id: key }, icon(of), el("span", {}, t(key)));
    on(button, "click", run);
    return button;
  };
  let latest: Setup | undefined; // of the form, with what its call needs
  const edit = act("tool", "profile-edit", () => equipment()?.open());
  const rename = el("input", { type: "text", id: "profile-rename", autocomplete: "off", spellcheck: "false" });
  const named = el(
    "div",
    { class: "profile-rename" },
    el("label", { for: "profile-rename" }, t("profile-name")),
    rename,
  );
  on(rename, "change", () => {
    const setup = profile(store.state);
    const wanted = rename.value.trim();
    if (setup && wanted)
      actions.equip({ ...setup, name: wanted }, { key: "step-profile-name", args: { name: wanted } });
  });
  const fresh = act("plus", "profile-create", () => {
    actions.newProfile();
    equipment()?.open();
  });
  const copy = act("copy", "profile-copy", () => actions.duplicateProfile());
  const remove = act("delete", "profile-delete", () => actions.deleteProfile());
  const save = act("download", "profile-export", () => exportSetup(store, latest));
  const open = act("open", "profile-import", () => file.click());
  const kept = [edit, named, fresh, copy, open, file, save, remove];
  const root = el("div", { class: "profile" }, controls[1].root, list, ...kept);
  const draw = (state: State, derived: Derived): void => {
    for (const control of controls) control.draw(state);
    const now = profile(state);
    latest = derived.view.setup ?? latest;
    for (const button of [copy, remove]) show(button, !!now);
    show(named, !!now);
    if (document.activeElement !== rename) rename.value = now?.name ?? "";
    drawList(list, state, actions);
  };
  return { control: controls[0].root, root, draw };
}

function fileName({ name = "" }: Setup): string {
  return `${name.replace(/[^\p{L}\p{N}_-]+/gu, "-").replace(/^-|-$/g, "") || "setup"}.json`;
}

/** The one in use first, behind it the core's own machine and the others. */
function drawList(list: HTMLElement, state: State, actions: Actions): void {
  const now = profile(state);
  const rows = [now, ...(now ? [undefined] : []), ...others(state)];
  keyed(
    list,
    rows.map((setup, index) => ({ setup, index })),
    one => String(one.index),
    () => el("li", {}, el("button", { type: "button", class: "quiet" }, el("span"), el("span"))),
    (node, { setup, index }) => {
      const [button] = node.children as unknown as [HTMLButtonElement];
      const [title, of] = button.children as unknown as [HTMLElement, HTMLElement];
      setText(title, profileName(setup));
      setText(of, t(`control-${setup?.control ?? state.form.control}`));
      setAttribute(button, "aria-current", index === 0 ? "true" : null);
      button.onclick = () => {
        if (index > 0) setup ? actions.chooseProfile(setup) : actions.openSetup(null);
      };
    },
  );
}
