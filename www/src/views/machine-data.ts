// What is set once per machine: user and machine data by subject, with search. Which there are says the core.

import { html, nothing, render, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { repeat } from "lit-html/directives/repeat.js";
import type { ProgramCore } from "../core/program";
import type { Actions } from "../desk/actions";
import { el, on, setOff, setText } from "../dom";
import { glossPart } from "../glossary";
import { plain } from "../numbers";
import { machine } from "../state/state";
import type { Store } from "../state/store";
import { optional, say, sayHint, t } from "../texts";
import { unlessTyping } from "../unless-typing";
import type { BasicSystem, MachineField, MachineGroup, MachineRequest, MachineView } from "../wire";
import { copyText } from "./copy";
import { rangeText } from "./field";
import { createMachineValues } from "./machine-values";

/** A row of a group: the title of a field of data, or a datum. */
type Row = { title: string; datum: null } | { title: null; datum: MachineField };

export interface MachineData {
  /** Shows the dialog, with what these words find; `ofMachine`: the values that a program reads from the machine. */
  open(words?: string, ofMachine?: boolean): void;
}

const BASIC: BasicSystem[] = ["mm", "inch"];
const differs = (field: MachineField): boolean => field.value !== "";

/** Whether all words stand in what is shown of a datum. */
function found(field: MachineField, group: MachineGroup, words: string[]): boolean {
  const text = [
    field.name,
    field.also ?? "",
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
function citedText({ name, key, set, source, versions }: MachineField): string {
  const words = [name, set ? say(set) : "", t(key)];
  if (source) words.push(t("field-source", { source }));
  if (versions) words.push(t(versions.until ? "version-until" : "version-from", { ...versions }));
  return words.filter(Boolean).join(" · ");
}

const choiceText = (key: string, value: number): string => `${plain(value)} · ${optional(`${key}.v${value}`)}`;

/** Ways from here: `check` holds what a control exported against what measuring needs, `repeat` tests a probe,
 * `userPrograms` writes lines around the cycles, `definitions` those of the definition files,
 * `commissioning` lists its steps. */
export function createMachineData(
  store: Store,
  actions: Actions,
  core: () => ProgramCore | null,
  ways: { check(): void; repeat(): void; userPrograms(): void; definitions(): void; commissioning(): void },
): MachineData {
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
  const close = el("button", { type: "button", class: "primary" }, t("machine-data-close"));
  const assignments = el("button", { type: "button" }, t("machine-data-assignments"));
  const definitions = el("button", { type: "button" }, t("definitions-title"));
  const reset = el("button", { type: "button" }, t("machine-data-reset"));
  const checking = el("button", { type: "button" }, t("exported-title"));
  const repeating = el("button", { type: "button" }, t("repeat-title"));
  const steps = el("button", { type: "button" }, t("steps-title"));
  const writing = el("button", { type: "button" }, t("user-program-title"));
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
    el("div", { class: "actions" }, checking, repeating, writing, steps, assignments, definitions, reset, close),
  );
  document.body.append(dialog);

  let view: MachineView | null = null;
  let typed: Record<string, string> = {}; // what was not taken
  const opened = new Set<string>();

  const values = createMachineValues(store, actions, () => drawAll());
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
    if (opening) for (const group of shown) opened.add(group.label.key);
    const own = values.rows(words);
    const empty = html`<p class="empty">${t(all.length === 0 ? "machine-data-nothing" : "machine-data-none")}</p>`;
    const groups = repeat(shown, group => group.label.key, groupOf);
    render(html`${own}${shown.length ? groups : own === nothing ? empty : nothing}`, list);
    setOff(
      reset,
      all.every(field => !isChanged(field)),
      close,
    );
    assignments.disabled = view.assignments === "";
  }
  const isChanged = (field: MachineField): boolean => differs(field) || field.name in typed;

  function groupOf({ label, fields }: MachineGroup): TemplateResult {
    const unfolded = opened.has(label.key);
    const changed = fields.filter(differs).length;
    const toggle = ({ target }: Event): void => {
      const { open } = target as HTMLDetailsElement;
      if (open === opened.has(label.key)) return;
      if (open) opened.add(label.key);
      else opened.delete(label.key);
      drawAll();
    };
    return html`<details class="machine-group" .open=${unfolded} @toggle=${toggle}>
      <summary
        ><span>${say(label)}</span
        ><span class="count">${changed ? t("machine-data-group-changed", { changed }) : fields.length}</span></summary
      >
      <div>
        ${repeat(
          unfolded ? rows(fields) : [],
          one => one.title ?? one.datum.name,
          one => (one.datum ? datumOf(one.datum) : html`<h3 class="machine-set">${one.title}</h3>`),
        )}
      </div>
    </details>`;
  }

  function datumOf(datum: MachineField): TemplateResult {
    const wrong = view?.problems.find(one => one.name === datum.name);
    const value = typed[datum.name] ?? (datum.value || (datum.kind === "choice" ? datum.fallback : ""));
    return datumRow(datum, value, wrong ? `${say(wrong.message)} ${sayHint(wrong)}` : "", text =>
      edit(datum.name, text),
    );
  }

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
  on(checking, "click", () => {
    dialog.close();
    ways.check();
  });
  on(repeating, "click", () => {
    dialog.close();
    ways.repeat();
  });
  on(writing, "click", () => {
    dialog.close();
    ways.userPrograms();
  });
  on(steps, "click", () => {
    dialog.close();
    ways.commissioning();
  });
  on(assignments, "click", () => void copyText(view?.assignments ?? "", store, "notice-copied"));
  on(definitions, "click", () => {
    dialog.close();
    ways.definitions();
  });
  on(reset, "click", () => {
    const names = view?.groups.flatMap(group => group.fields.filter(differs).map(field => field.name)) ?? [];
    take(ask({ values: Object.fromEntries(names.map(name => [name, ""])) }));
  });
  return {
    open(words = "", ofMachine = false) {
      view = ask();
      if (!view) return; // the module is still on its way
      typed = {};
      if (words) search.value = words;
      if (ofMachine) search.value = "";
      values.begin();
      dialog.showModal();
      drawAll(true);
      if (ofMachine) list.querySelector<HTMLElement>(".machine-values input")?.focus();
    },
  };
}

/** `problem`: why `value` is not taken; empty where it is. */
function datumRow(datum: MachineField, value: string, problem: string, edit: (value: string) => void): TemplateResult {
  const id = entryId(datum.name);
  const taken = ({ target }: Event): void => edit((target as HTMLInputElement | HTMLSelectElement).value);
  const wrong = problem ? "true" : nothing;
  const about = `${id}-help ${id}-problem${datum.idle ? ` ${id}-idle` : ""}${datum.warned ? ` ${id}-warned` : ""}`;
  const entry =
    datum.kind === "choice"
      ? html`<select id=${id} class="choice" aria-describedby=${about} aria-invalid=${wrong} @change=${taken}>
          ${choices(datum, value)}
        </select>`
      : html`<input
          id=${id}
          class="figure"
          data-unit=${unitText(datum.unit) || nothing}
          type="text"
          autocomplete="off"
          spellcheck="false"
          inputmode=${datum.kind === "text" ? "text" : "decimal"}
          placeholder=${datum.fallback}
          aria-describedby=${about}
          aria-invalid=${wrong}
          .value=${unlessTyping(value)}
          @change=${taken}
        />`;
  return html`<div class=${`datum kind-${datum.kind}${differs(datum) ? " changed" : ""}`}>
    <div class="datum-head"><label for=${id}>${t(datum.key)}</label><code class="field-name">${datum.name}</code></div>
    <div class="entry-line">
      ${entry}<span class="unit">${unitText(datum.unit)}</span><span class="meta">${limitsText(datum)}</span>
    </div>
    <p class="datum-help" id=${`${id}-help`}>${glossPart(optional(`${datum.key}.help`))}</p>
    ${datum.idle ? html`<p class="datum-help datum-idle" id=${`${id}-idle`}>${t("machine-data-idle")}</p>` : nothing}
    ${
      datum.warned
        ? html`<p class="datum-help datum-warned" id=${`${id}-warned`}>
            ${say(datum.warned.message)} ${sayHint(datum.warned)}
          </p>`
        : nothing
    }
    <p class="datum-problem" id=${`${id}-problem`} role="alert" ?hidden=${!problem}>${problem}</p>
  </div>`;
}

function choices(datum: MachineField, value: string): TemplateResult[] {
  const known = (datum.kind === "choice" ? datum.choices : []).map(String);
  const now = datum.value || datum.fallback;
  const text = (value: string): string => {
    const shown = choiceText(datum.key, Number(value));
    return value === datum.fallback ? t("machine-data-delivered", { value: shown }) : shown;
  };
  return (known.includes(now) ? known : [...known, now]).map(
    one => html`<option value=${one} .selected=${live(one === value)}>${text(one)}</option>`,
  );
}
