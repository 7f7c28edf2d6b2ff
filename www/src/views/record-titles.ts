// What only people know of a printed record: part, order, machine, inspector. It is filled in once and kept.

import { html, nothing, render, type TemplateResult } from "lit-html";
import { el } from "../dom";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import { TITLES } from "./record";

const LONGEST = 80; // characters of a title

/** `machine`: as its profile calls it, where nothing is filled in. */
export function createTitles(store: Store): { root: HTMLElement; draw(state: State, machine: string): void } {
  const root = el("div", {});
  const typed = (key: string, event: Event): void => {
    const { value } = event.target as HTMLInputElement;
    store.update(state => ({ view: { titles: { ...state.view.titles, [key]: value } } }));
  };
  const field = (key: string, value: string, preset: string): TemplateResult => html`<label
    ><span>${t(`record-sheet-${key}`)}</span
    ><input type="text" maxlength=${LONGEST} autocomplete="off" data-title=${key} .value=${value}
      placeholder=${preset || nothing} @change=${(event: Event) => typed(key, event)}
  /></label>`;
  return {
    root,
    draw({ view: { titles } }, machine) {
      const fields = TITLES.map(key => field(key, titles[key] ?? "", key === "machine" ? machine : ""));
      render(
        html`<details class="record-fill">
          <summary>${t("record-fill")}</summary>
          <div>${fields}</div>
        </details>`,
        root,
      );
    },
  };
}
