// One field: name as in the manual, label, entry, unit, what is allowed and why, its problems.

import type { Actions } from "../desk/actions";
import { choicesIn, el, keyed, on, setAttribute, setText, show } from "../dom";
import { meantBy } from "../keys";
import { parseNumber, plain } from "../numbers";
import { allWords, say, t } from "../texts";
import type { Choice, Diagnostic, DigitGroup, Field, Range, Replaced } from "../wire";
import { columnsOf, createColumns } from "./columns";
import { reveal } from "./groups";
import { listProblems } from "./problem";
import { createReplaced } from "./replaced";

export interface FieldView {
  root: HTMLElement;
  /** `replaced`: the expression of the program whose place the typed value would take. */
  update(field: Field, typed: string, problems: Diagnostic[], replaced: Replaced | null): void;
}

const PAUSE = 700; // ms without a key after which a value counts as typed

export function fieldId(name: string): string {
  return `field-${name.replace(/[^A-Za-z0-9_]/g, "-")}`;
}

/** In the section that has it, which opens for that. */
export function focusField(name: string): void {
  const field = document.getElementById(fieldId(name));
  reveal(field);
  field?.focus();
}

/** What may be entered, in the manual's way of writing an interval. */
export function rangeText(range: Range): string {
  if (range.min === undefined && range.max === undefined) return "";
  const { min, max } = range;
  if (min !== undefined && max !== undefined)
    return `${plain(min)} ${range.minIncluded ? "≤" : "<"} … ${range.maxIncluded ? "≤" : "<"} ${plain(max)}`;
  if (min !== undefined) return `${range.minIncluded ? "≥" : ">"} ${plain(min)}`;
  return `${range.maxIncluded ? "≤" : "<"} ${plain(max ?? 0)}`;
}

const choicesOf = (field: Field): Choice[] => (field.kind === "choice" ? field.choices : []);

/** What may be entered and what counts when nothing is, in pieces; a choice shows both by itself. */
function limitsTexts({ kind, fallback, ...field }: Field): string[] {
  const range = "range" in field ? rangeText(field.range) : "";
  const without = kind === "choice" || kind === "digits" || fallback === undefined ? "" : plain(fallback);
  return [range, without && t("field-otherwise", { value: without })].filter(Boolean);
}

/** Whether the field has to be filled in, and why. */
export function needText(field: Field): string {
  return t(field.required ? "field-required" : "field-optional", { reason: say(field.reason) });
}

/** The number with one of its digit groups replaced. */
function withDigits(number: number, group: Pick<DigitGroup, "place" | "digits">, value: number): number {
  const size = 10 ** group.digits;
  const size_ = Math.trunc(Math.abs(number) / group.place) % size;
  return Math.abs(number) + (Math.trunc(value) - size_) * group.place;
}

export function createField(
  first: Field,
  actions: Actions,
  focused: (name: string | null) => void,
  goToLine: (line: number) => void,
): FieldView {
  const name = first.name;
  const id = fieldId(name);
  let field = first;
  let timer = 0;
  let typing: string | null = null; // and not taken yet
  let drawn = "";

  const label = el("label", { for: id, class: "field-label" });
  const required = el("span", { class: "required", "aria-hidden": "true" }, "•");
  const code = el("code", { class: "field-name" }, name);
  const input = el("input", {
    id,
    class: "figure",
    type: "text",
    autocomplete: "off",
    spellcheck: "false",
    "data-kind": first.kind,
    inputmode: first.kind === "text" ? "text" : "decimal",
    "aria-describedby": `${id}-worth ${id}-meta ${id}-problems`,
  });
  const mark = el("span", { class: "fx", "aria-hidden": "true" }, "fx");
  const worth = el("span", { class: "worth", id: `${id}-worth` }); // of an expression
  const unit = el("span", { class: "unit" });
  const select = el("select", { class: "choice" });
  const groups = el("div", { class: "digits" });
  const limits = el("span", {});
  const why = el("span", { class: "visually-hidden" }); // in sight beside the drawing while the field has the focus
  const meta = el("p", { class: "meta", id: `${id}-meta` }, limits, why);
  const columns = createColumns(id, (text, caret) => {
    typing = null;
    actions.edit(name, text);
    actions.touch(name);
    if (caret === undefined) return;
    input.value = text;
    input.focus();
    input.setSelectionRange(caret, caret);
  });
  const list = el("ul", { class: "field-problems", id: `${id}-problems`, "aria-live": "polite" });
  const replacedNote = createReplaced(name, actions, goToLine, () => input.focus());
  const root = el(
    "div",
    { class: `field kind-${first.kind}`, "data-field": name },
    el("div", { class: "field-head" }, el("span", { class: "field-title" }, label, required), code),
    el("div", { class: "entry-line" }, mark, input, unit, worth, first.kind === "choice" ? select : null, meta),
    first.kind === "digits" ? groups : null,
    first.kind === "text" ? columns.root : null,
    replacedNote.root,
    list,
  );

  const take = (): void => {
    clearTimeout(timer);
    if (typing !== null) actions.edit(name, typing);
    typing = null;
    actions.touch(name);
  };
  on(input, "input", () => {
    if (field.chooses)
      typing = input.value; // half a number may be another variant, which would not know the values of this one
    else actions.edit(name, input.value);
    clearTimeout(timer);
    timer = window.setTimeout(take, PAUSE);
  });
  on(input, "change", take);
  on(select, "change", () => {
    actions.edit(name, select.value);
    actions.touch(name);
  });
  on(input, "keydown", event => {
    const command = replacedNote.waits() ? meantBy(event, "form") : null;
    if (command === "ask") replacedNote.focus();
    else if (command === "refuse") actions.keep(name);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  root.addEventListener("focusin", () => focused(name));

  const editGroup = (group: DigitGroup, value: number): void => {
    const base = parseNumber(field.expression === undefined ? input.value : field.value) ?? field.fallback ?? 0;
    const lead = group.leads?.[group.choices.findIndex(one => one.value === value)];
    actions.edit(name, String(lead ?? withDigits(base, group, value)));
    actions.touch(name);
  };

  return {
    root,
    update(next, typed, problems, replaced) {
      field = next;
      const written = next.expression ?? next.value; // settings of the machine may give part of it
      const text = typing ?? (document.activeElement === input && typed !== next.value ? typed : written);
      if (input.value !== text) input.value = text;
      // Most fields say the same after a keystroke. Entries are put right all the same: what was typed may be gone
      // again before it was ever drawn.
      const now = JSON.stringify([next, typed, problems, replaced, allWords()]);
      if (now === drawn && field.kind !== "digits" && field.kind !== "choice") return;
      drawn = now;
      setText(label, say(field.label));
      show(required, field.required);
      setText(worth, field.expression === undefined ? "" : `= ${field.value}`);
      root.classList.toggle("reckoned", field.expression !== undefined);
      show(mark, field.expression !== undefined);
      replacedNote.draw(replaced, typed.trim() === "");
      setText(unit, field.unit ? t(`unit-${field.unit.replace("/", "-per-")}`) : "");
      setAttribute(input, "data-unit", field.unit || null);
      setAttribute(input, "placeholder", field.fallback === undefined ? null : plain(field.fallback));
      setAttribute(input, "aria-required", String(field.required));
      if (field.kind === "choice") updateChoice(select, field, field.expression === undefined ? text : field.value);
      if (field.kind === "digits")
        keyed(
          groups,
          field.digits,
          group => `${group.label.key}/${group.place}/${group.choices.map(one => one.value).join(",")}`,
          group => createGroup(() => field, group.place, editGroup),
          (node, group, index) => updateGroup(node, group, `${id}-digit-${index}`),
        );
      columns.update(field);
      root.classList.toggle("listed", columnsOf(field) !== undefined);
      root.classList.toggle("needed", field.required);
      limits.replaceChildren(...limitsTexts(field).flatMap((text, at) => [at ? " · " : "", el("span", {}, text)]));
      setText(why, ` ${needText(field)}`);
      listProblems(list, problems, actions.give);
      const wrong = problems.some(one => one.severity === "error");
      setAttribute(input, "aria-invalid", wrong ? "true" : null);
      root.classList.toggle("wrong", wrong);
      root.classList.toggle("doubtful", !wrong && problems.length > 0);
    },
  };
}

function options(select: HTMLSelectElement, choices: { value: number; text: string }[], empty: string | null): void {
  const list = choices.map(one => ({ value: String(one.value), text: one.text }));
  choicesIn(select, empty === null ? list : [{ value: "", text: empty }, ...list]);
}

function updateChoice(select: HTMLSelectElement, field: Field, typed: string): void {
  const number = parseNumber(typed);
  const known = choicesOf(field).some(one => one.value === number);
  const empty =
    typed.trim() === "" || known
      ? t(field.fallback === undefined ? "choice-none" : "choice-default")
      : t("choice-other");
  options(
    select,
    choicesOf(field).map(one => ({ value: one.value, text: `${one.value} · ${say(one.label)}` })),
    empty,
  );
  const value = known ? String(number) : "";
  if (select.value !== value) select.value = value;
  setAttribute(select, "aria-label", t("choice-label", { name: say(field.label) }));
}

function createGroup(field: () => Field, place: number, edit: (group: DigitGroup, value: number) => void): HTMLElement {
  const current = (): DigitGroup | undefined => {
    const now = field();
    return now.kind === "digits" ? now.digits.find(group => group.place === place) : undefined;
  };
  const select = el("select", { class: "choice" });
  const number = el("input", { class: "figure", type: "text", inputmode: "numeric", autocomplete: "off" });
  const commit = (text: string): void => {
    const group = current();
    const value = parseNumber(text);
    if (group && value !== null && value >= 0 && value < 10 ** group.digits) edit(group, value);
  };
  on(select, "change", () => commit(select.value));
  on(number, "change", () => commit(number.value));
  return el("div", { class: "digit" }, el("label", {}), select, number);
}

function updateGroup(node: HTMLElement, group: DigitGroup, id: string): void {
  const [label, select, number] = node.children as unknown as [HTMLLabelElement, HTMLSelectElement, HTMLInputElement];
  const named = group.choices.length > 0;
  setText(label, say(group.label));
  setAttribute(label, "for", named ? `${id}-choice` : id);
  setAttribute(select, "id", `${id}-choice`);
  setAttribute(number, "id", id);
  show(select, named);
  show(number, !named);
  const known = group.choices.some(one => one.value === group.value);
  if (named)
    options(
      select,
      group.choices.map(one => ({ value: one.value, text: `${one.value} · ${say(one.label)}` })),
      known ? null : t("choice-other"),
    );
  const value = String(group.value);
  if (named && select.value !== (known ? value : "")) select.value = known ? value : "";
  if (!named && number.value !== value && document.activeElement !== number) number.value = value;
}
