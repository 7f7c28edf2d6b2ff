// The line above everything: what is measured on which machine, and the page's own actions.

import type { ProgramCore } from "../core/program";
import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { el, keyed, on, setAttribute, setText, show } from "../dom";
import { icon } from "../icons";
import { ariaKey, meantBy } from "../keys";
import { nameOf } from "../language";
import { pack } from "../link";
import { plain } from "../numbers";
import { saveFile } from "../state/files";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { shared } from "../state/stored";
import { language, languages, t } from "../texts";
import { drawTheme, THEMES } from "../theme";
import type { FormView } from "../wire";
import { createAbout } from "./about";
import { copyText } from "./copy";
import { createHistory } from "./history";
import { createMachine } from "./machine";
import type { MachineData } from "./machine-data";

const MM_PER_INCH = 25.4;

/** The machine of a form, and whether its control has the right calibration data of its probe. */
type Machine = Pick<FormView, "setup" | "calibrated">;

/** Control, tool and probe as they count now. */
export function facts(control: string, { setup, calibrated }: Machine): { name: string; text: string }[] {
  const name = t(`control-${control}`);
  const inch = setup?.units === "inch";
  const list = [
    { name: t("fact-control"), text: inch ? t("fact-built", { control: name, unit: t("unit-inch") }) : name },
  ];
  if (!setup) return list;
  const inUse = setup.active?.tool ?? 0;
  const [number, tool] = setup.tools[inUse] ? [inUse, setup.tools[inUse]] : (Object.entries(setup.tools)[0] ?? []);
  return [
    ...list,
    ...(tool ? [{ name: t("fact-tool"), text: `T${number}${tool.name ? ` ${tool.name}` : ""}` }] : []),
    {
      name: t("fact-probe"),
      text: t("fact-ball", {
        diameter: plain((setup.probe.radius * 2) / (inch ? MM_PER_INCH : 1), 4),
        unit: t(inch ? "unit-inch" : "unit-mm"),
      }),
    },
    { name: t("fact-calibration"), text: t(calibrated ? "fact-true" : "fact-deviates") },
  ];
}

const LONGEST_LINK = 200_000; // characters that every browser takes

async function copyLink(store: Store): Promise<void> {
  const packed = await pack(shared(store.state));
  if (packed.length > LONGEST_LINK) return store.update({ page: { notice: "notice-link-long" } });
  const address = `${location.href.split("#")[0]}#s=${packed}`;
  history.replaceState(null, "", address);
  await copyText(address, store, "notice-link");
}

/** Each language in its own words. */
function languageChoice(actions: Actions): HTMLSelectElement {
  const choice = el(
    "select",
    { id: "language", "aria-label": t("language") },
    ...languages().map(one => el("option", { value: one, lang: one }, nameOf(one))),
  );
  choice.value = language();
  on(choice, "change", () => actions.speak(choice.value));
  return choice;
}

/** Where there is no room for the page's actions side by side, this opens and closes them. */
function menuFor(list: HTMLElement): HTMLButtonElement {
  const open = el(
    "button",
    { type: "button", class: "quiet menu-open", "aria-controls": list.id, "aria-expanded": "false" },
    t("menu"),
  );
  const elsewhere = (event: PointerEvent): void => {
    if (leaves(event.target)) set(false);
  };
  const set = (shown: boolean): void => {
    setAttribute(open, "aria-expanded", String(shown));
    setAttribute(list, "data-open", shown);
    if (shown) addEventListener("pointerdown", elsewhere);
    else removeEventListener("pointerdown", elsewhere);
  };
  const isOpen = (): boolean => list.hasAttribute("data-open");
  const leaves = (to: EventTarget | null): boolean => !(to instanceof Node && (list.contains(to) || open.contains(to)));
  on(open, "click", () => set(!isOpen()));
  on(list, "click", event => {
    if (event.target instanceof Element && event.target.closest("button:not(#theme)")) set(false);
  });
  for (const part of [open, list]) {
    on(part, "focusout", event => {
      if (event.relatedTarget && leaves(event.relatedTarget)) set(false);
    });
    on(part, "keydown", event => {
      if (meantBy(event, "page") !== "close" || !isOpen()) return;
      set(false);
      open.focus();
    });
  }
  return open;
}

export function createHeader(
  root: HTMLElement,
  store: Store,
  actions: Actions,
  openSetup: (file: File) => void,
  core: () => ProgramCore | null,
  machineData: () => MachineData | null,
  keys: HTMLDialogElement,
): (state: State, derived: Derived) => void {
  const about = createAbout();
  const machine = createMachine(actions);
  const history = createHistory(actions);
  const data = el("button", { type: "button", class: "quiet", "aria-haspopup": "dialog" }, t("machine-data-open"));
  on(data, "click", () => machineData()?.open());
  const list = el("dl", { class: "facts", "aria-label": t("facts") });
  const quiet = (key: string, run: () => void): HTMLButtonElement => {
    const node = el("button", { type: "button", class: "quiet" }, t(key));
    on(node, "click", run);
    return node;
  };
  let shown: Machine = {}; // the last that was used: it stays in sight while the form is incomplete
  const file = el("input", {
    type: "file",
    accept: "application/json,.json",
    hidden: true,
    tabindex: "-1",
    "aria-label": t("setup-import"),
  });
  on(file, "change", () => {
    const chosen = file.files?.[0];
    if (chosen) openSetup(chosen);
    file.value = "";
  });
  const theme = quiet("theme-system", () => {
    const next = THEMES[(THEMES.indexOf(store.state.page.theme) + 1) % THEMES.length] ?? "system";
    store.update({ page: { theme: next } });
  });
  theme.id = "theme";
  const themeName = el("span", {}, "");
  const own = quiet("setup-own", () => actions.openSetup(null));
  const save = (): void => {
    const saved = shown.setup ?? store.state.machine.setup;
    if (saved) saveFile(JSON.stringify(saved, null, 2), "setup.json", "application/json");
    else store.update({ page: { notice: "notice-nothing-to-save" } });
  };
  const keysOpen = quiet("keys-title", () => keys.showModal());
  keysOpen.replaceChildren(el("span", {}, t("keys-title")), el("kbd", { "aria-hidden": "true" }, "?"));
  setAttribute(keysOpen, "class", "quiet keys-open");
  setAttribute(keysOpen, "title", t("keys-title"));
  setAttribute(keysOpen, "aria-keyshortcuts", ariaKey("page", "keys"));
  const actionsBox = el(
    "div",
    { class: "head-actions", id: "page-actions" },
    data,
    quiet("setup-import", () => file.click()),
    file,
    quiet("setup-export", save),
    own,
    quiet("link-copy", () => void copyLink(store)),
    theme,
    languageChoice(actions),
    keysOpen,
    quiet("about-open", () => about.showModal()),
  );
  root.append(
    el(
      "div",
      { class: "brand" },
      el("span", { class: "brand-mark", "aria-hidden": "true" }),
      el("h1", {}, t("app-name")),
    ),
    machine.root,
    history.root,
    list,
    menuFor(actionsBox),
    actionsBox,
  );
  document.body.append(about);
  return (state, derived) => {
    machine.draw(state);
    history.draw(state);
    setAttribute(data, "disabled", core() === null || !machineData());
    const { control } = derived.cycle;
    if (derived.view.setup || shown.setup?.control !== control) shown = derived.view;
    keyed(
      list,
      facts(control, shown),
      one => one.name,
      () => el("div", {}, el("dt", {}), el("dd", {})),
      (node, one) => {
        const [name, text] = node.children as unknown as [HTMLElement, HTMLElement];
        setText(name, one.name);
        setText(text, one.text);
      },
    );
    show(own, !!state.machine.setup);
    if (theme.dataset.shown !== state.page.theme) {
      theme.dataset.shown = state.page.theme;
      theme.replaceChildren(icon(state.page.theme), themeName);
    }
    setText(themeName, t(`theme-${state.page.theme}`));
    setAttribute(theme, "title", themeName.textContent);
    drawTheme(state.page.theme);
  };
}
