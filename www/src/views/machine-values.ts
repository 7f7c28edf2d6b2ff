// Values that only the machine has and that a program reads: assumed, or typed once and used from then on.

import { html, nothing, type TemplateResult } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import type { Actions } from "../desk/actions";
import { parseNumber } from "../numbers";
import { ownMachine, profile, type State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import { unlessTyping } from "../unless-typing";
import type { MachineValue } from "../wire";
import { lineText } from "./given";

/** `typed`: what the machine has; else it is assumed. */
interface Row {
  name: string;
  typed?: number | string;
  assumed?: number | string;
  where?: string;
}

const isOfMachine = (name: string): boolean => name.startsWith("$");

const valueId = (name: string): string => `machine-value-${name.replace(/[^A-Za-z0-9_]/g, "-")}`;

export interface MachineValues {
  /** The dialog opens: where values were read is looked up anew. */
  begin(): void;
  /** The table; `words`: that must stand in the name. */
  rows(words: readonly string[]): TemplateResult | typeof nothing;
}

function typedIn(state: State): Record<string, number | string> {
  return (profile(state)?.data ?? ownMachine(state).data ?? {}) as Record<string, number | string>;
}

export function createMachineValues(store: Store, actions: Actions, redraw: () => void): MachineValues {
  const read = new Map<string, { value: MachineValue["value"]; where: string }>(); // since the dialog was opened
  const note = (): void => {
    const { done } = store.state.run;
    for (const { name, value, line } of done?.view.machineValues ?? [])
      read.set(name, { value, where: lineText(done?.view.files, line) });
  };
  const all = (): Row[] => {
    note();
    const typed = typedIn(store.state);
    const names = new Set([...Object.keys(typed).filter(isOfMachine), ...read.keys()]);
    return [...names].sort().map((name): Row => {
      const known = read.get(name);
      return {
        name,
        ...(typed[name] !== undefined ? { typed: typed[name] } : {}),
        ...(known ? { assumed: known.value, where: known.where } : {}),
      };
    });
  };
  const taken = (row: Row, { target }: Event): void => {
    const text = (target as HTMLInputElement).value.trim();
    const number = parseNumber(text);
    const isText = typeof (row.assumed ?? row.typed) === "string";
    actions.machineValue(row.name, text === "" ? null : isText ? text : (number ?? text));
    redraw();
  };
  const rowOf = (row: Row): TemplateResult => {
    const id = valueId(row.name);
    const state = row.typed !== undefined ? t("machine-values-typed") : t("machine-values-assumed");
    return html`<tr data-value=${row.name} data-typed=${row.typed !== undefined}>
      <th scope="row"><label for=${id}><code>${row.name}</code></label></th>
      <td>
        <input
          id=${id}
          type="text"
          autocomplete="off"
          spellcheck="false"
          placeholder=${String(row.assumed ?? "")}
          .value=${unlessTyping(String(row.typed ?? ""))}
          @change=${(event: Event) => taken(row, event)}
        />
      </td>
      <td>${state}</td>
      <td>${row.where ?? "–"}</td>
    </tr>`;
  };
  return {
    begin() {
      read.clear();
    },
    rows(words) {
      const rows = all().filter(({ name }) => words.every(word => name.toLowerCase().includes(word)));
      if (!rows.length) return nothing;
      return html`<section class="machine-values" aria-labelledby="machine-values-title">
        <h3 id="machine-values-title">${t("machine-values-title")}</h3>
        <p class="meta">${t("machine-values-help")}</p>
        <table>
          <thead>
            <tr>
              <th scope="col">${t("column-name")}</th>
              <th scope="col">${t("column-value")}</th>
              <th scope="col">${t("machine-values-state")}</th>
              <th scope="col">${t("machine-values-where")}</th>
            </tr>
          </thead>
          <tbody>
            ${repeat(rows, row => row.name, rowOf)}
          </tbody>
        </table>
      </section>`;
    },
  };
}
