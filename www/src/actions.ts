// Everything that can happen. Views call these; only these change what is kept.

import type { Core } from "./core";
import { lineBreak, splice, type Splice } from "./eol";
import { findCycle, machine } from "./derive";
import { parseNumber } from "./numbers";
import { AT_END, type Panel, type State } from "./state";
import type { Store } from "./store";
import type { Catalogue, CycleInfo, Dialect, ErrorSliders } from "./wire";

export type Variant = CycleInfo["variants"][number];

export interface Actions {
  chooseCycle(cycle: CycleInfo, variant?: Variant): void;
  edit(name: string, value: string): void;
  touch(name: string): void;
  check(): void;
  example(): void;
  editProgram(text: string): void;
  cursor(offset: number): void;
  openCall(index: number): void;
  closeCall(): void;
  insert(snippet: string): void;
  error<G extends keyof ErrorSliders>(group: G, name: keyof ErrorSliders[G], value: number): void;
  panel(panel: Panel): void;
}

const LEFT: Panel[] = ["tasks", "form"];
const memoryKey = (control: Dialect, cycle: string): string => `${control}/${cycle}`;

function matches(variant: Variant, values: Record<string, string>): boolean {
  return Object.entries(variant.values).every(([name, value]) => {
    const typed = values[name] ?? "";
    const number = parseNumber(typed);
    return typed.trim() === value || (number !== null && number === parseNumber(value));
  });
}

/** The variant that the typed values choose: of those that match the one that asks for most. */
export function variantOf(cycle: CycleInfo, values: Record<string, string>): Variant | undefined {
  const asks = (variant: Variant): number => Object.keys(variant.values).length;
  return cycle.variants.filter((variant) => matches(variant, values)).sort((a, b) => asks(b) - asks(a))[0];
}

export function createActions(store: Store, core: Core, catalogue: Catalogue): Actions {
  const now = (): State => store.state;
  const program = (): string => now().programs[now().control] ?? "";
  const withProgram = (text: string): Partial<State> => ({ programs: { ...now().programs, [now().control]: text } });
  const calls = (text: string) => core.read({ control: now().control, text, ...machine(now().control, now().setup) }).calls;

  /** The program with one value of the opened call changed; the same text when there is nothing to change. */
  const changed = (text: string, call: number, name: string, value: string): string =>
    splice(text, core.change({ control: now().control, text, call, name, value }) as Splice[]);

  const opened = (index: number, text: string): Partial<State> => {
    const call = calls(text)[index];
    if (!call) return { open: null };
    return { open: index, cycle: call.cycle, values: call.values, checked: true, touched: {}, step: AT_END, source: "form" };
  };

  const remember = (): Partial<State> => ({ remembered: { ...now().remembered, [memoryKey(now().control, now().cycle)]: now().values } });

  const edits = (pairs: [string, string][]): void => {
    const state = now();
    const values = { ...state.values };
    let text = program();
    for (const [name, value] of pairs) {
      values[name] = value;
      if (state.open !== null) text = changed(text, state.open, name, value);
    }
    store.update({ values, step: AT_END, ...(text === program() ? {} : withProgram(text)) });
  };

  return {
    chooseCycle(cycle, variant) {
      const state = now();
      const same = cycle.control === state.control && cycle.cycle === state.cycle;
      if (same && variant) return edits(Object.entries(variant.values));
      const values = same ? state.values : state.remembered[memoryKey(cycle.control, cycle.cycle)] ?? cycle.example;
      store.update({ ...remember(), control: cycle.control, cycle: cycle.cycle, values: { ...values, ...variant?.values }, open: same ? state.open : null, step: AT_END, source: "form", touched: {}, checked: false });
    },
    edit: (name, value) => edits([[name, value]]),
    touch(name) {
      if (!now().touched[name]) store.update({ touched: { ...now().touched, [name]: true } });
    },
    check: () => store.update({ checked: true }),
    example() {
      const cycle = findCycle(catalogue, now().control, now().cycle);
      if (cycle) store.update({ values: cycle.example, open: null, step: AT_END, touched: {}, checked: false });
    },
    editProgram(text) {
      const open = now().open;
      store.update({ ...withProgram(text), ...(open === null ? {} : { ...opened(open, text), source: now().source }) });
    },
    cursor(offset) {
      const text = program();
      const before = text.slice(0, offset);
      const line = before.split(/\r\n|\r|\n/).length;
      const index = calls(text).findIndex((call) => call.line <= line && line <= call.lastLine);
      if (index >= 0 && index !== now().open) store.update({ ...remember(), ...opened(index, text), cursor: offset });
      else store.update({ cursor: offset });
    },
    openCall: (index) => store.update({ ...remember(), ...opened(index, program()) }),
    closeCall: () => store.update({ open: null }),
    insert(snippet) {
      const text = program();
      const place = insertion(text, now().cursor, snippet);
      const next = splice(text, [place]);
      const end = place.from + place.insert.length;
      const index = calls(next).findIndex((call) => call.from >= place.from && call.from < end);
      store.update({ ...withProgram(next), cursor: end, open: index >= 0 ? index : null, notice: "notice-inserted" });
    },
    error(group, name, value) {
      const errors = now().errors;
      store.update({ errors: { ...errors, [group]: { ...errors[group], [name]: value } }, step: AT_END });
    },
    panel(panel) {
      store.update({ panel, ...(LEFT.includes(panel) ? { left: panel } : { right: panel }) });
      store.flush(); // who shows a panel goes on in it, mostly with the focus
    },
  };
}

/** Whole lines before the line of the cursor, or after the last line when the cursor stands at its end. */
export function insertion(text: string, cursor: number, snippet: string): Splice {
  const eol = lineBreak(text);
  const body = snippet.replace(/\n+$/, "").replaceAll("\n", eol);
  const atEnd = cursor >= text.length && text.length > 0 && !text.endsWith("\n");
  if (atEnd) return { from: text.length, to: text.length, insert: eol + body + eol };
  const start = text.lastIndexOf("\n", cursor - 1) + 1;
  return { from: cursor === 0 ? 0 : start, to: cursor === 0 ? 0 : start, insert: body + eol };
}
