// One field that finds all there is: commands, fields of the form, calls, findings, measurements, parameters, results,
// alarms, help, machine data. What the other controls and languages call a thing leads to ours.

import type { ProgramCore } from "../core/program";
import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { el, on, setAttribute, setText, show } from "../dom";
import { lineAt } from "../eol";
import { isExplained, openGuide } from "../guide";
import { type Command, meantBy } from "../keys";
import type { Hit, Search, Tables } from "../search";
import { pieces, plainWord, words } from "../search/words";
import { machine, type State } from "../state/state";
import type { Store } from "../state/store";
import { everyLanguage, say, t } from "../texts";
import type { Catalogue, Dialect } from "../wire";
import { keyLabel } from "./keys";

const MOST = 8; // entries of a group
const RECENT = 5; // commands that were run last
const LISTED = 2000; // calls and problems that are looked through, the first ones

/** Something that the page can do; `key`: what does the same. */
export interface PageCommand {
  id: string;
  title: string;
  key?: string;
  run(): void;
}

interface Item {
  id: string;
  code: string;
  title: string;
  note?: string;
  key?: string;
  found: readonly string[]; // words of it that were looked for
  run(): void;
}
interface Section {
  name: string;
  items: Item[];
}

/** What the palette leads to. */
export interface Leads {
  catalogue: Catalogue;
  tables: Tables;
  core(): ProgramCore | null;
  commands(derived: Derived): PageCommand[];
  goTo(offset: number): void;
  goToLine(line: number): void;
  goToField(control: Dialect, name: string): void;
  machineData(search: string): void;
}

export interface Palette {
  dialog: HTMLDialogElement;
  open(): void;
}

/** Something with its words, as they are compared. */
interface Known extends Omit<Item, "found"> {
  words: readonly string[];
}

/** `more`: found too, not shown. */
function known(item: Omit<Item, "found">, more = ""): Known {
  const text = `${item.code} ${item.title} ${item.note ?? ""} ${more}`;
  return { ...item, words: words(text).flatMap(one => plainWord(one) ?? []) };
}

/** Whether every word that was typed begins one of these; then those words, to mark them. */
function begun(own: readonly string[], asked: readonly string[]): string[] | null {
  const found = asked.map(word => own.filter(one => one.startsWith(word)));
  return found.every(one => one.length) ? found.flat() : null;
}

/** Those of the items in whose text all words stand. */
function among(items: readonly Known[], asked: readonly string[]): Item[] {
  const all: Item[] = [];
  for (const item of items) {
    const found = begun(item.words, asked);
    if (found) all.push({ ...item, found });
    if (all.length === MOST) break;
  }
  return all;
}

export function createPalette(store: Store, actions: Actions, leads: Leads, now: () => Derived | null): Palette {
  const input = el("input", {
    type: "text", // Escape closes at once
    id: "palette-search",
    enterkeyhint: "go",
    role: "combobox",
    "aria-expanded": "true",
    "aria-controls": "palette-list",
    "aria-autocomplete": "list",
    "aria-label": t("palette"),
    placeholder: t("palette-hint"),
    autocomplete: "off",
    spellcheck: "false",
  });
  const list = el("div", { id: "palette-list", role: "listbox", "aria-label": t("palette-results") });
  const none = el("p", { class: "empty", role: "status" });
  const dialog = el("dialog", { class: "palette", "aria-label": t("palette") }, input, list, none);
  let search: Search | null = null;
  let coming = false;
  let held: ReturnType<typeof here> | null = null; // since it was opened
  let shown: Item[] = [];
  let at = 0;

  const load = (): void => {
    if (coming) return;
    coming = true;
    const named = everyLanguage().catch(console.warn); // without them it finds what the page's own words say
    void Promise.all([import("../search"), leads.tables.alarms, leads.tables.elsewhere, named]).then(
      ([{ createSearch }, known, elsewhere]) => {
        search = createSearch(leads.catalogue, known, elsewhere);
        if (dialog.open) draw();
      },
    );
  };

  const command = (one: PageCommand): Omit<Item, "found"> => ({
    ...one,
    id: `command-${one.id}`,
    code: "",
    run: () => {
      const recent = [one.id, ...store.state.page.recent.filter(id => id !== one.id)].slice(0, RECENT);
      store.update({ page: { recent } });
      one.run();
    },
  });

  const ofHit = ({ entry, words: found }: Hit): Item => {
    const { kind, code, key, title, cycles, others, control, variant, id, told } = entry;
    const [cycle] = cycles;
    const note = control && kind !== "measurement" ? t(`control-${control}`) : undefined;
    const run = (): void => {
      if (isExplained(kind)) openGuide(key);
      else if (kind === "around") {
        actions.panel("form");
        actions.around(code);
      } else if (kind === "result" || kind === "alarm" || kind === "elsewhere")
        actions.card({ kind, code, key, cycles, others, ...(told ? { told } : {}) });
      else if (kind === "measurement" && cycle) {
        actions.chooseCycle(cycle, variant);
        actions.panel("form");
        document.getElementById("panel-form")?.focus();
      } else if (cycle) leads.goToField(cycle.control, code);
    };
    return { id: `hit-${id}`, code, title, found, run, ...(note ? { note } : {}) };
  };

  /** The help pages of the measurements that were found. */
  const ofHelp = (hits: readonly Hit[]): Item[] =>
    hits.slice(0, MOST / 2).map(hit => {
      const item = ofHit(hit);
      const run = (): void => {
        item.run();
        if (store.state.panels.right !== "help") actions.help();
      };
      return { ...item, id: `help-${item.id}`, run };
    });

  /** What the page holds now: fields, calls, problems, data. */
  const here = (
    state: State,
    { view, read, problems }: Derived,
  ): Record<"field" | "call" | "finding" | "datum", Known[]> => {
    const { control } = state.form;
    const at = (line: number): string => t("asks-line", { line });
    return {
      field: view.fields.map(({ name, label }) => {
        const run = (): void => leads.goToField(control, name);
        return known({ id: `field-${name}`, code: name, title: say(label), run });
      }),
      call: read.calls.slice(0, LISTED).map(({ cycle, key, lastLine, from }, index) => {
        const run = (): void => {
          actions.openCall(index);
          leads.goTo(from);
        };
        return known({ id: `call-${index}`, code: cycle, title: t(`${key}-title`), note: at(lastLine), run });
      }),
      finding: problems.slice(0, LISTED).map(({ code, message, line, from, hint, cure }, index) => {
        const run = (): void => leads.goTo(from ?? 0);
        const more = [hint, cure?.label].map(one => (one ? say(one) : "")).join(" ");
        return known({ id: `finding-${index}`, code, title: say(message), note: at(line ?? 0), run }, more);
      }),
      datum: data(state),
    };
  };

  /** The line that is named by its number alone. */
  const lineOf = (text: string, program: string): Item[] => {
    const number = /^:?\s*(\d+)$/.exec(text)?.[1];
    const line = Number(number);
    if (!number || line < 1 || line > lineAt(program, program.length)) return [];
    const title = t("palette-line", { line });
    return [{ id: "line", code: number, title, found: [], run: () => leads.goToLine(line) }];
  };

  const sections = (state: State, derived: Derived, text: string): Section[] => {
    const asked = words(text).flatMap(one => plainWord(one) ?? []);
    const commands = leads.commands(derived);
    if (!asked.length) {
      const recent = state.page.recent.flatMap(id => commands.find(one => one.id === id) ?? []);
      const rest = commands.filter(one => !recent.includes(one));
      const plain = (one: PageCommand): Item => ({ ...command(one), found: [] });
      return [
        { name: "recent", items: recent.map(plain) },
        { name: "command", items: rest.map(plain) },
      ];
    }
    held ??= here(state, derived);
    const found = search?.(text, state.form.control) ?? [];
    const measured = found.find(({ kind }) => kind === "measurement")?.hits ?? [];
    return [
      { name: "line", items: lineOf(text, derived.program) },
      {
        name: "command",
        items: among(
          commands.map(one => known(command(one))),
          asked,
        ),
      },
      { name: "field", items: among(held.field, asked) },
      { name: "call", items: among(held.call, asked) },
      ...found.map(({ kind, hits }) => ({ name: kind, items: hits.slice(0, MOST).map(ofHit) })),
      { name: "finding", items: among(held.finding, asked) },
      { name: "help", items: ofHelp(measured.filter(({ complete }) => complete)) },
      { name: "datum", items: among(held.datum, asked) },
    ];
  };

  /** User and machine data. */
  const data = (state: State): Known[] => {
    const { control } = state.form;
    const fields = leads
      .core()
      ?.machine({ control, ...machine(state), values: {} })
      .groups.flatMap(one => one.fields);
    return (fields ?? []).map(({ name, key, set }) => {
      const run = (): void => leads.machineData(name);
      return known({ id: `datum-${name}`, code: name, title: t(key), run, ...(set ? { note: say(set) } : {}) });
    });
  };

  const option = (item: Item): HTMLElement => {
    const marks = (text: string): Node[] =>
      pieces(text, item.found).map(one => (one.found ? el("mark", {}, one.text) : document.createTextNode(one.text)));
    const node = el(
      "div",
      {
        role: "option",
        id: `palette-${item.id.replace(/[^\w-]/g, "_")}`,
        class: "palette-item",
        "aria-selected": "false",
      },
      item.code ? el("code", {}, ...marks(item.code)) : null,
      el("span", { class: "palette-title" }, ...marks(item.title)),
      item.note ? el("span", { class: "palette-note" }, ...marks(item.note)) : null,
      item.key ? el("span", { class: "palette-key" }, keyLabel(item.key)) : null,
    );
    on(node, "click", () => choose(item));
    return node;
  };
  const choose = (item: Item | undefined): void => {
    if (!item) return;
    dialog.close();
    item.run();
  };
  const options = (): HTMLElement[] => [...list.querySelectorAll<HTMLElement>(".palette-item")];
  const move = (to: number): void => {
    const all = options();
    if (!all.length) {
      setAttribute(input, "aria-activedescendant", null);
      return;
    }
    setAttribute(all[at] ?? list, "aria-selected", "false");
    at = (to + all.length) % all.length;
    const here = all[at] as HTMLElement;
    setAttribute(here, "aria-selected", "true");
    setAttribute(input, "aria-activedescendant", here.id);
    here.scrollIntoView({ block: "nearest" });
  };
  const draw = (): void => {
    const derived = now();
    if (!derived) return;
    const text = input.value.trim();
    const all = sections(store.state, derived, text).filter(({ items }) => items.length > 0);
    shown = all.flatMap(({ items }) => items);
    list.replaceChildren(
      ...all.map(({ name, items }) => {
        const title = el("h3", { id: `palette-group-${name}` }, t(`palette-${name}`));
        return el("div", { role: "group", "aria-labelledby": title.id }, title, ...items.map(option));
      }),
    );
    setAttribute(list, "data-search", text);
    setAttribute(list, "data-complete", search !== null);
    list.scrollTop = 0;
    at = 0;
    move(0);
    show(none, shown.length === 0);
    setText(none, shown.length || !search ? "" : t("tasks-none", { search: text }));
  };
  on(input, "input", draw);
  on(input, "keydown", event => {
    const does: Partial<Record<Command<"list">, () => void>> = {
      next: () => move(at + 1),
      previous: () => move(at - 1),
      "next-page": () => move(Math.min(at + MOST, shown.length - 1)),
      "previous-page": () => move(Math.max(at - MOST, 0)),
    };
    const meant = event.key === "Enter" ? "choose" : meantBy(event, "list");
    const run = meant === "choose" && event.key === "Enter" ? () => choose(shown[at]) : meant && does[meant];
    if (!run || event.isComposing) return;
    event.preventDefault();
    run();
  });
  on(dialog, "keydown", event => {
    if (meantBy(event, "page") !== "palette") return;
    event.preventDefault();
    dialog.close();
  });
  on(dialog, "click", event => {
    if (event.target === dialog) dialog.close(); // beside it
  });
  return {
    dialog,
    open() {
      if (dialog.open) {
        dialog.close();
        return;
      }
      load();
      held = null;
      input.value = "";
      dialog.showModal();
      draw();
      input.focus();
    },
  };
}
