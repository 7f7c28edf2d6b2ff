// What the page can do, as a list: each with its name, and the key that does the same.

import type { Actions } from "../desk/actions";
import { type Derived, findCycle } from "../desk/derive";
import { practises } from "../desk/practice";
import { variantOf } from "../desk/variants";
import { handbook } from "../handbook";
import { KEYS } from "../keys";
import { nameOf } from "../language";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { language, languages, t } from "../texts";
import { THEMES } from "../theme";
import { copyText } from "../views/copy";
import { copyLink } from "../views/header";
import type { PageCommand } from "../views/palette";
import type { Paper } from "../views/paper";
import type { Style } from "../wire";

/** What is done elsewhere on the page. */
export interface Does {
  save(): void;
  open(): void;
  keys(): void;
  machine(): void;
  machineData(): void;
  machineCheck(): void;
  repeat(): void;
  userPrograms(): void;
  definitions(): void;
  terms(): void;
  commissioning(): void;
  series(): void;
  importSetup(): void;
  exportSetup(): void;
  paper(which: Paper): void;
  practise(): void;
  scenarios(): void;
  check(): void;
}

const STYLES: Style[] = ["direct", "indirect", "operate"];
const PANELS = ["tasks", "form", "program", "view", "results"] as const;
const TABS = ["problems", "motions", "log"] as const; // the first one is what the panel shows

function ofWork(actions: Actions, does: Does, { history }: State): PageCommand[] {
  const [undo] = KEYS.page.undo;
  const [redo] = KEYS.page.redo;
  const steps = [
    history.past.length > 0 && { id: "undo", title: t("undo"), key: undo, run: () => actions.step(1) },
    history.future.length > 0 && { id: "redo", title: t("redo"), key: redo, run: () => actions.step(-1) },
  ];
  return [
    { id: "open", title: t("keys-page-open"), key: KEYS.page.open[0], run: does.open },
    { id: "save", title: t("keys-page-save"), key: KEYS.page.save[0], run: does.save },
    ...steps.filter(one => one !== false),
  ];
}

/** The call in the form and the program. */
function ofCall(store: Store, actions: Actions, state: State, derived: Derived): PageCommand[] {
  const { view, opened, read, program, cycle, catalogue } = derived;
  const { control } = state.form;
  const all: PageCommand[] = [];
  if (view.snippet) {
    const copy = (): void => void copyText(view.snippet, store, "notice-copied");
    all.push({ id: "copy-call", title: t("command-copy-call"), run: copy });
    if (!opened) all.push({ id: "insert", title: t("form-insert"), run: () => actions.insert(view.snippet) });
  }
  if (opened) all.push({ id: "detach", title: t("form-detach"), run: actions.closeCall });
  all.push({ id: "example", title: t("form-example"), run: () => actions.example(variantOf(derived)) });
  if (program) {
    const copy = (): void => void copyText(program, store, "notice-copied");
    all.push({ id: "copy-program", title: t("command-copy-program"), run: copy });
  }
  for (const style of STYLES) {
    const way = t(`way-${style}`);
    const others = read.calls.filter(
      one => one.style !== style && findCycle(catalogue, control, one.cycle)?.styles.includes(style),
    );
    const convert = { title: t("command-convert", { way }), run: () => actions.convert(style) };
    if (opened && opened.style !== style && cycle.styles.includes(style))
      all.push({ id: `convert-${style}`, ...convert });
    const title = t("command-convert-all", { way, count: others.length });
    if (others.length) all.push({ id: `convert-all-${style}`, title, run: () => actions.convert(style, true) });
  }
  return all;
}

function ofView(
  store: Store,
  actions: Actions,
  does: Does,
  { view, page, snippet }: State,
  { run }: Derived,
): PageCommand[] {
  const themes = THEMES.filter(one => one !== page.theme).map(theme => ({
    id: `theme-${theme}`,
    title: t(`theme-${theme}`),
    run: () => store.update({ page: { theme } }),
  }));
  const book = handbook();
  const spoken = languages().filter(one => one !== language());
  return [
    ...PANELS.map(panel => ({
      id: `panel-${panel}`,
      title: t("command-panel", { panel: t(`panel-${panel}`) }),
      run: () => {
        actions.panel(panel);
        document.getElementById(`panel-${panel}`)?.focus();
      },
    })),
    ...TABS.map(tab => ({
      id: `tab-${tab}`,
      title: t("command-panel", { panel: t(`tab-${tab}`) }),
      run: () => {
        store.update({ panels: { tab } });
        actions.panel("results");
      },
    })),
    ...(["form", "program"] as const)
      .filter(source => source !== view.source)
      .map(source => ({
        id: `run-${source}`,
        title: t(`command-run-${source}`),
        run: () => {
          store.update({ view: { source } });
          actions.panel("view");
        },
      })),
    {
      id: "measurements",
      title: t("command-measurements"),
      run: () => {
        store.update({ view: { source: "program" }, panels: { tab: "outcome" } });
        actions.panel("results");
      },
    },
    { id: "help", title: t("help-open"), run: actions.help },
    ...(book ? [{ id: "handbook", title: t("handbook-open"), run: () => void open(book, "_blank", "noopener") }] : []),
    { id: "terms", title: t("terms-title"), run: () => does.terms() },
    { id: "machine", title: t("profile-edit"), run: does.machine },
    { id: "setup-import", title: t("profile-import"), run: does.importSetup },
    { id: "setup-export", title: t("profile-export"), run: does.exportSetup },
    { id: "machine-data", title: t("machine-data-title"), run: does.machineData },
    { id: "machine-check", title: t("exported-title"), run: does.machineCheck },
    { id: "repeat", title: t("repeat-title"), run: does.repeat },
    { id: "commissioning", title: t("steps-title"), run: () => does.commissioning() },
    { id: "user-programs", title: t("user-program-title"), run: does.userPrograms },
    { id: "definitions", title: t("definitions-title"), run: does.definitions },
    { id: "series", title: t("runs-title"), run: does.series },
    { id: "twin", title: t("twin-open"), run: () => store.update({ snippet: { twin: !snippet.twin } }) },
    { id: "link", title: t("link-copy"), run: () => void copyLink(store, actions) },
    { id: "scenarios", title: t("scenarios-open"), run: does.scenarios },
    { id: "check", title: t("scenarios-check"), run: does.check },
    { id: "print-sheet", title: t("print-sheet"), run: () => does.paper("sheet") },
    { id: "print-report", title: t("print-report"), run: () => does.paper("report") },
    ...(run?.answers.length ? [{ id: "print-record", title: t("whole-print"), run: () => does.paper("record") }] : []),
    { id: "print", title: t("command-print"), key: "Ctrl+P", run: () => print() },
    ...themes,
    ...spoken.map(one => ({
      id: `language-${one}`,
      title: `${t("language")}: ${nameOf(one)}`,
      run: () => actions.speak(one),
    })),
    { id: "keys", title: t("keys-title"), key: KEYS.page.keys[0], run: does.keys },
  ];
}

/** All that can be done now. */
export function commandsOf(store: Store, actions: Actions, does: Does): (derived: Derived) => PageCommand[] {
  return derived => [
    ...ofWork(actions, does, store.state),
    ...ofCall(store, actions, store.state, derived),
    ...ofView(store, actions, does, store.state, derived),
    ...(practises(store.state, derived.catalogue)
      ? [{ id: "practise", title: t("practice-title"), run: does.practise }]
      : []),
  ];
}
