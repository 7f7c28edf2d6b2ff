// The line above everything: what is measured on which machine, and the page's own actions.

import type { ProgramCore } from "../core/program";
import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { practises } from "../desk/practice";
import { el, keyed, on, setAttribute, setText, show } from "../dom";
import { handbook, keepHandbook } from "../handbook";
import { type IconName, icon } from "../icons";
import { ariaKey } from "../keys";
import { nameOf } from "../language";
import { pack } from "../link";
import { MM_PER_INCH, plain } from "../numbers";
import type { Scenarios } from "../scenarios/scenarios";
import { beginning, INCH, type Panel, profile, type State } from "../state/state";
import type { Store } from "../state/store";
import { shared } from "../state/stored";
import { language, languages, t } from "../texts";
import { drawTheme, THEMES } from "../theme";
import type { FormView } from "../wire";
import { createAbout } from "./about";
import { copyText } from "./copy";
import type { Equipment } from "./equipment";
import { createFileMenu, type FileActions } from "./file-menu";
import { createHistory } from "./history";
import { createMachine } from "./machine";
import type { MachineData } from "./machine-data";
import { createMenu } from "./menu";
import { createProfile, profileName } from "./profile";

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

/** An address that holds the work. */
export async function copyLink(store: Store, actions: Pick<Actions, "settle">): Promise<void> {
  const kept = actions.settle(); // a link has what the program has
  const packed = await pack(shared(store.state));
  if (packed.length > LONGEST_LINK) return store.update({ page: { notice: "notice-link-long" } });
  const address = `${location.href.split("#")[0]}#s=${packed}`;
  history.replaceState(null, "", address);
  await copyText(address, store, kept ? "notice-kept" : "notice-link");
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

/** An action of the page in a menu: an icon and its words. */
function entry(of: IconName, words: string, run: () => void, sort = ""): HTMLButtonElement {
  const node = el("button", { type: "button", class: `quiet ${sort}`.trim() }, icon(of), el("span", {}, t(words)));
  on(node, "click", run);
  return node;
}

/** The handbook, beside the work. */
function handbookLink(): HTMLAnchorElement | null {
  const href = handbook();
  if (href === null) return null;
  const node = el("a", { href, target: "_blank", rel: "noopener" }, icon("book"), el("span", {}, t("handbook-open")));
  on(node, "click", () => void keepHandbook());
  return node;
}

/** What stands in the menu of a phone alone: it has no tab, or no room in the first line. */
const PHONE = "on-phone";

function goTo(actions: Actions, panel: Panel): void {
  actions.panel(panel);
  document.getElementById(`panel-${panel}`)?.focus();
}

/** Where the first line has room for theme, language and keys. */
const ROOMY = matchMedia("(min-width: 1200px)");

export function createHeader(
  root: HTMLElement,
  store: Store,
  actions: Actions,
  setupFile: HTMLInputElement,
  core: () => ProgramCore | null,
  later: () => {
    machineData: MachineData;
    equipment: Equipment;
    openPalette(): void;
    paper(which: "sheet" | "report"): Promise<void>;
  } | null,
  keys: HTMLDialogElement,
  files: FileActions,
  ways: { practise(): void; scenarios: Scenarios },
  end: AbortSignal,
): (state: State, derived: Derived) => void {
  const about = createAbout(ways.scenarios.check);
  const machine = createMachine(actions);
  const profiles = createProfile(store, actions, setupFile, () => later()?.equipment ?? null);
  const history = createHistory(actions);
  const data = entry("table", "machine-data-title", () => undefined);
  setAttribute(data, "aria-haspopup", "dialog");
  on(data, "click", () => later()?.machineData.open());
  const list = el("dl", { class: "facts", "aria-label": t("facts") });
  let shown: Machine = {}; // the last that was used: it stays in sight while the form is incomplete
  const theme = entry("system", "theme-system", () => {
    const next = THEMES[(THEMES.indexOf(store.state.page.theme) + 1) % THEMES.length] ?? "system";
    store.update({ page: { theme: next } });
  });
  theme.id = "theme";
  setAttribute(theme, "data-stays", true);
  const themeName = el("span", {}, "");
  const keysOpen = entry("keys", "keys-title", () => keys.showModal());
  setAttribute(keysOpen, "title", t("keys-title"));
  setAttribute(keysOpen, "aria-keyshortcuts", ariaKey("page", "keys"));
  const practice = entry("hand", "practice-title", ways.practise);
  const openMachine = (): void => {
    menu.list.hidePopover(); // first: its button has the focus back when the machine's closes
    chip.list.showPopover();
  };
  const menu = createMenu(
    "page-actions",
    t("menu"),
    [
      entry("calls", "panel-tasks", () => goTo(actions, "tasks"), PHONE),
      entry("help", "panel-help", () => goTo(actions, "help"), PHONE),
      entry("machine", "facts", openMachine, PHONE),
      data,
      practice,
      entry("copy", "link-copy", () => void copyLink(store, actions)),
      entry("print", "print-sheet", () => void later()?.paper("sheet")),
      entry("print", "print-report", () => void later()?.paper("report")),
      entry("good", "scenarios-open", ways.scenarios.open),
      handbookLink(),
      entry("info", "about-open", () => about.showModal()),
    ],
    [icon("menu")],
    { class: "quiet menu-open" },
  );
  const bar = el("div", { class: "top-actions" });
  const own = [theme, languageChoice(actions), keysOpen];
  /** Where the line has no room for them they stand in the menu. */
  const place = (): void => {
    if (ROOMY.matches) bar.append(...own);
    else menu.list.lastElementChild?.before(...own);
  };
  ROOMY.addEventListener("change", place, { signal: end });
  place();
  const machineName = el("strong", {});
  const machineText = el("span", { class: "machine-text" });
  const chip = createMenu(
    "machine-menu",
    t("facts"),
    [profiles.root, machine.root, list],
    [icon("machine"), machineName, " ", machineText, icon("down")],
    { class: "machine-open" },
  );
  const search = el(
    "button",
    { type: "button", id: "search-open", class: "search-open", title: t("tasks-search") },
    icon("search"),
    el("span", {}, t("search-open")),
  );
  setAttribute(search, "aria-keyshortcuts", ariaKey("page", "palette"));
  on(search, "click", () => later()?.openPalette());
  const program = createFileMenu(files);
  root.append(
    el(
      "div",
      { class: "brand" },
      el("span", { class: "brand-mark", "aria-hidden": "true" }),
      el("h1", {}, t("app-name")),
    ),
    program.root,
    history.root,
    search,
    profiles.control,
    chip.button,
    chip.list,
    bar,
    menu.button,
    menu.list,
  );
  document.body.append(about);
  return (state, derived) => {
    profiles.draw(state, derived);
    machine.draw(state);
    history.draw(state);
    program.draw(state);
    show(practice, practises(state, derived.catalogue));
    setAttribute(data, "disabled", core() === null || !later());
    const { control } = derived.cycle;
    if (derived.view.setup || shown.setup?.control !== control) shown = derived.view;
    const known = facts(control, shown);
    keyed(
      list,
      known,
      one => one.name,
      () => el("div", {}, el("dt", {}), el("dd", {})),
      (node, one) => {
        const [name, text] = node.children as unknown as [HTMLElement, HTMLElement];
        setText(name, one.name);
        setText(text, one.text);
      },
    );
    const { plane, units } = state.form.around ?? beginning(state);
    const used = profile(state);
    setText(machineName, used ? profileName(used) : t(`control-${control}`));
    const tool = known.find(one => one.name === t("fact-tool"))?.text;
    setText(machineText, [plane, t(INCH.includes(units) ? "unit-inch" : "unit-mm"), tool].filter(Boolean).join(" · "));
    setAttribute(chip.button, "aria-label", `${machineName.textContent} ${machineText.textContent}`);
    if (theme.dataset.shown !== state.page.theme) {
      theme.dataset.shown = state.page.theme;
      theme.replaceChildren(icon(state.page.theme), themeName);
    }
    setText(themeName, t(`theme-${state.page.theme}`));
    setAttribute(theme, "title", themeName.textContent);
    drawTheme(state.page.theme);
  };
}
