// What is set once per machine: user and machine data by subject, with search. Which there are says the core.

import type { Actions } from "../actions";
import { el, keyed, on, setAttribute, setText, show } from "../dom";
import { plain } from "../numbers";
import type { ProgramCore } from "../program";
import { machine, type State } from "../state";
import type { Store } from "../store";
import { optional, say, t } from "../texts";
import type { BasicSystem, MachineField, MachineGroup, MachineRequest, MachineView } from "../wire";
import { copyText } from "./copy";
import { rangeText } from "./field";

/** A row of a group: the title of a field of data, or a datum. */
type Row = { title: string; datum: null } | { title: null; datum: MachineField };

export interface MachineData {
  open: HTMLButtonElement;
  draw(state: State): void;
}

const BASIC: BasicSystem[] = ["mm", "inch"];
const differs = (field: MachineField): boolean => field.value !== "";

/** Whether all words stand in what is shown of a datum. */
function found(field: MachineField, group: MachineGroup, words: string[]): boolean {
  const text = [
    field.name,
    t(field.key),
    optional(`${field.key}.help`),
    field.set ? say(field.set) : "",
    say(group.label),
  ]
    .join(" ")
    .toLowerCase();
  return words.every(word => text.includes(word));
}

function rows(fields: MachineField[]): Row[] {
  let last = "";
  return fields.flatMap((datum): Row[] => {
    const title = datum.set ? say(datum.set) : "";
    const own: Row[] = [{ title: null, datum }];
    const headed: Row[] = title && title !== last ? [{ title, datum: null }, ...own] : own;
    last = title;
    return headed;
  });
}

function unitText(unit: string): string {
  return unit ? t(`unit-${unit.replace("/", "-per-").replace("%", "percent").toLowerCase()}`) : "";
}

/** Range and delivered value. */
function limitsText({ kind, range, fallback }: MachineField): string {
  const allowed = kind === "real" || kind === "integer" ? rangeText(range) : "";
  return [allowed, kind === "choice" || fallback === "" ? "" : t("field-default", { value: fallback })]
    .filter(Boolean)
    .join(" · ");
}

const entryId = (name: string): string => `datum-${name.replace(/[^A-Za-z0-9_]/g, "-")}`;

/** Which datum it is, and where the manual has it; what it means stands at its entry. */
function citedText({ name, key, set, source }: MachineField): string {
  const words = [name, set ? say(set) : "", t(key)].filter(Boolean).join(" · ");
  return source ? `${words}. ${t("field-source", { source })}` : words;
}

const choiceText = (key: string, value: number): string => `${plain(value)} · ${optional(`${key}.v${value}`)}`;

export function createMachineData(store: Store, actions: Actions, core: () => ProgramCore | null): MachineData {
  const open = el("button", { type: "button", class: "quiet", "aria-haspopup": "dialog" }, t("machine-data-open"));
  const search = el("input", {
    type: "search",
    id: "machine-data-search",
    placeholder: t("machine-data-search-hint"),
    "aria-label": t("machine-data-search"),
  });
  const changedOnly = el("input", { type: "checkbox", id: "machine-data-changed" });
  const basic = el(
    "select",
    { id: "machine-data-basic", "aria-describedby": "machine-data-basic-help" },
    ...BASIC.map(system => el("option", { value: system }, t(`unit-${system}`))),
  );
  const count = el("p", { class: "machine-data-count", role: "status" });
  const list = el("div", { class: "machine-data-list scroll" });
  const cited = el("p", { class: "datum-cited", id: "machine-data-cited", "aria-live": "polite" });
  const none = el("p", { class: "empty" });
  const close = el("button", { type: "button", class: "primary" }, t("machine-data-close"));
  const assignments = el("button", { type: "button" }, t("machine-data-assignments"));
  const definitions = el("button", { type: "button" }, t("machine-data-definitions"));
  const reset = el("button", { type: "button" }, t("machine-data-reset"));
  const dialog = el(
    "dialog",
    { class: "machine-data", "aria-labelledby": "machine-data-title" },
    el("header", {}, el("h2", { id: "machine-data-title" }, t("machine-data-title")), count),
    el(
      "div",
      { class: "machine-data-basic" },
      el("label", { for: "machine-data-basic" }, t("machine-data-basic")),
      basic,
      el("p", { id: "machine-data-basic-help" }, t("machine-data-basic-help")),
    ),
    el(
      "div",
      { class: "machine-data-tools" },
      search,
      el("label", { class: "check", for: "machine-data-changed" }, changedOnly, t("machine-data-changed")),
    ),
    list,
    cited,
    el("div", { class: "actions" }, assignments, definitions, reset, close),
  );
  document.body.append(dialog);

  let view: MachineView | null = null;
  let typed: Record<string, string> = {}; // what was not taken
  const opened = new Set<string>();

  const ask = (change: Partial<MachineRequest> = {}): MachineView | null => {
    const { state } = store;
    return core()?.machine({ control: state.form.control, ...machine(state), values: {}, ...change }) ?? null;
  };
  const edit = (name: string, value: string): void => {
    const answer = ask({ values: { [name]: value } });
    if (!answer) return;
    const { [name]: _, ...others } = typed;
    typed = answer.problems.length ? { ...others, [name]: value } : others;
    if (!answer.problems.length) actions.data(answer);
    view = answer;
    drawAll();
  };
  const take = (answer: MachineView | null): void => {
    if (!answer) return;
    typed = {};
    actions.data(answer);
    view = answer;
    drawAll();
  };
  const row = createRow(
    () => view,
    name => typed[name],
    edit,
  );

  /** `unfold`: what was looked for is shown at once, whatever was folded. */
  function drawAll(unfold = false): void {
    if (!view || !dialog.open) return;
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const opening = unfold && (words.length > 0 || changedOnly.checked);
    const all = view.groups.flatMap(group => group.fields);
    const shown = view.groups
      .map(group => ({
        ...group,
        fields: group.fields.filter(field => (!changedOnly.checked || isChanged(field)) && found(field, group, words)),
      }))
      .filter(group => group.fields.length > 0);
    if (basic.value !== view.basic) basic.value = view.basic;
    setText(count, t("machine-data-count", { changed: all.filter(differs).length, all: all.length }));
    setText(none, t(all.length === 0 ? "machine-data-nothing" : "machine-data-none"));
    keyed(
      list,
      shown,
      group => group.label.key,
      createGroup,
      (node, group) => updateGroup(node, group, opening),
    );
    if (shown.length === 0) list.append(none);
    else none.remove();
    reset.disabled = all.every(field => !isChanged(field));
    assignments.disabled = view.assignments === "";
    definitions.disabled = view.definitions === "";
  }
  const isChanged = (field: MachineField): boolean => differs(field) || field.name in typed;

  function createGroup(group: MachineGroup): HTMLDetailsElement {
    const node = el(
      "details",
      { class: "machine-group" },
      el("summary", {}, el("span", {}), el("span", { class: "count" })),
      el("div", {}),
    );
    on(node, "toggle", () => {
      if (node.open) opened.add(group.label.key);
      else opened.delete(group.label.key);
      drawAll();
    });
    return node;
  }

  function updateGroup(node: HTMLDetailsElement, group: MachineGroup, opening: boolean): void {
    const [summary, body] = node.children as unknown as [HTMLElement, HTMLElement];
    const [title, note] = summary.children as unknown as [HTMLElement, HTMLElement];
    setText(title, say(group.label));
    const changed = group.fields.filter(differs).length;
    setText(note, changed ? t("machine-data-group-changed", { changed }) : String(group.fields.length));
    if (opening) node.open = true;
    keyed(body, node.open ? rows(group.fields) : [], one => one.title ?? one.datum?.name ?? "", row.create, row.update);
  }

  on(open, "click", () => {
    view = ask();
    if (!view) return; // the module is still on its way
    typed = {};
    dialog.showModal();
    drawAll(true);
  });
  list.addEventListener("focusin", ({ target }) => {
    const datum = view?.groups
      .flatMap(group => group.fields)
      .find(field => entryId(field.name) === (target as HTMLElement).id);
    setText(cited, datum ? citedText(datum) : "");
  });
  on(basic, "change", () => take(ask({ basic: basic.value as BasicSystem })));
  on(search, "input", () => drawAll(true));
  on(changedOnly, "change", () => drawAll(true));
  on(close, "click", () => dialog.close());
  on(assignments, "click", () => void copyText(view?.assignments ?? "", store, "notice-copied"));
  on(definitions, "click", () => void copyText(view?.definitions ?? "", store, "notice-copied"));
  on(reset, "click", () => {
    const names = view?.groups.flatMap(group => group.fields.filter(differs).map(field => field.name)) ?? [];
    take(ask({ values: Object.fromEntries(names.map(name => [name, ""])) }));
  });
  return {
    open,
    draw: () => setAttribute(open, "disabled", core() === null),
  };
}

function createRow(
  view: () => MachineView | null,
  typed: (name: string) => string | undefined,
  edit: (name: string, value: string) => void,
) {
  const create = ({ title, datum }: Row): HTMLElement => {
    if (!datum) return el("h3", { class: "machine-set" }, title);
    const id = entryId(datum.name);
    const entry =
      datum.kind === "choice"
        ? el("select", { id, class: "choice", "aria-describedby": `${id}-help ${id}-problem` })
        : el("input", {
            id,
            class: "figure",
            type: "text",
            autocomplete: "off",
            spellcheck: "false",
            inputmode: datum.kind === "text" ? "text" : "decimal",
            "aria-describedby": `${id}-help ${id}-problem`,
          });
    on(entry, "change", () => edit(datum.name, entry.value));
    return el(
      "div",
      { class: `datum kind-${datum.kind}` },
      el("div", { class: "datum-head" }, el("label", { for: id }), el("code", { class: "field-name" }, datum.name)),
      el("div", { class: "entry-line" }, entry, el("span", { class: "unit" }), el("span", { class: "meta" })),
      el("p", { class: "datum-help", id: `${id}-help` }),
      el("p", { class: "datum-problem", id: `${id}-problem`, role: "alert" }),
    );
  };
  const update = (node: HTMLElement, { title, datum }: Row): void => {
    if (!datum) {
      setText(node, title);
      return;
    }
    const [head, line, help, problem] = node.children as unknown as [
      HTMLElement,
      HTMLElement,
      HTMLElement,
      HTMLElement,
    ];
    const [entry, unit, meta] = line.children as unknown as [
      HTMLInputElement | HTMLSelectElement,
      HTMLElement,
      HTMLElement,
    ];
    setText(head.firstElementChild ?? head, t(datum.key));
    setText(help, optional(`${datum.key}.help`));
    setText(unit, unitText(datum.unit));
    setText(meta, limitsText(datum));
    if (entry instanceof HTMLSelectElement) updateChoices(entry, datum);
    const value = typed(datum.name) ?? (datum.value || (datum.kind === "choice" ? datum.fallback : ""));
    if (entry.value !== value) entry.value = value;
    if (entry instanceof HTMLInputElement) setAttribute(entry, "placeholder", datum.fallback);
    const wrong = view()?.problems.find(one => one.name === datum.name);
    setText(problem, wrong ? `${say(wrong.message)} ${say(wrong.hint)}` : "");
    show(problem, !!wrong);
    setAttribute(entry, "aria-invalid", wrong ? "true" : null);
    node.classList.toggle("changed", differs(datum));
  };
  return { create, update };
}

function updateChoices(select: HTMLSelectElement, datum: MachineField): void {
  const known = datum.choices ?? [];
  const now = datum.value || datum.fallback;
  const values = known.map(String).includes(now) ? known.map(String) : [...known.map(String), now];
  const text = (value: string): string => {
    const shown = choiceText(datum.key, Number(value));
    return value === datum.fallback ? t("machine-data-delivered", { value: shown }) : shown;
  };
  keyed(
    select,
    values,
    value => value,
    value => el("option", { value }),
    (node, value) => setText(node, text(value)),
  );
}
