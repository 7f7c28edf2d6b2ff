// What a shop writes by hand around a measuring call, folded in the form: blocks with their fields. Of a call that is
// still to be written they go into the program with it; at one that is there a button writes them.

import { html, nothing, render } from "lit-html";
import type { Actions } from "../desk/actions";
import { aroundAt, type Derived } from "../desk/derive";
import { el, on, show } from "../dom";
import { guideButton } from "../guide";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { say, t } from "../texts";
import type { AroundBlock, AroundField, AroundView } from "../wire";

type Blocks = Record<string, Record<string, string>>;

/** The call with the blocks around it, as it is inserted. */
export function withBlocks({ view: { snippet }, around }: Derived): string {
  return around && snippet ? around.before + snippet + around.after : snippet;
}

/** The wanted blocks with what was typed, or as they are in the program. */
function wanted(blocks: readonly AroundBlock[]): Blocks {
  const values = (fields: readonly AroundField[]): Record<string, string> =>
    Object.fromEntries(fields.filter(field => field.value !== "").map(field => [field.name, field.value]));
  return Object.fromEntries(blocks.filter(block => block.wanted).map(block => [block.name, values(block.fields)]));
}

/** Each edit of a field or a choice of a block is the wanted blocks anew. */
interface Hands {
  choose(block: string, on: boolean): void;
  type(block: string, field: string, value: string): void;
}

const id = (block: string, field: string): string => `around-${block}-${field}`;

function entry(block: string, field: AroundField, hands: Hands) {
  const typed = (event: Event): void => hands.type(block, field.name, (event.target as HTMLInputElement).value);
  const preset = field.text ? t(field.preset) : field.preset;
  if (field.choices.length === 0)
    return html`<input
      type="text"
      id=${id(block, field.name)}
      autocomplete="off"
      spellcheck="false"
      .value=${field.value}
      placeholder=${preset}
      aria-invalid=${field.problem ? "true" : nothing}
      aria-describedby=${field.problem ? `${id(block, field.name)}-problem` : nothing}
      @change=${typed}
    />`;
  const now = field.value || field.preset;
  return html`<select
    id=${id(block, field.name)}
    aria-invalid=${field.problem ? "true" : nothing}
    aria-describedby=${field.problem ? `${id(block, field.name)}-problem` : nothing}
    @change=${typed}
  >
    ${now ? nothing : html`<option value="" selected>–</option>`}
    ${field.choices.map(
      ([value, key]) =>
        html`<option value=${value} ?selected=${value === now}>
          ${value.length > 1 ? `${value} ${t(key)}` : t(key)}
        </option>`,
    )}
  </select>`;
}

function fieldOf(block: string, field: AroundField, hands: Hands) {
  return html`<div class="around-field">
    <label for=${id(block, field.name)}>${t(field.key)}</label>
    ${entry(block, field, hands)}
    ${
      field.problem
        ? html`<span class="problem-text" id=${`${id(block, field.name)}-problem`}>${say(field.problem)}</span>`
        : nothing
    }
  </div>`;
}

function blockOf({ name, key, wanted: on, suits, fields }: AroundBlock, hands: Hands) {
  const chosen = (event: Event): void => hands.choose(name, (event.target as HTMLInputElement).checked);
  return html`<div class="around-block" role="group" aria-label=${t(key)}>
    <label><input type="checkbox" data-block=${name} .checked=${on} @change=${chosen} />${t(key)}</label>
    ${on ? html`<p>${suits ? t(`${key}-help`) : t("around-unsuited")}</p>` : nothing}
    ${on ? fields.map(field => fieldOf(name, field, hands)) : nothing}
  </div>`;
}

/** What this control cannot have around a call, and why. */
function absentOf(all: AroundView["absent"]) {
  if (!all.length) return nothing;
  return html`<p class="quiet-text">${t("around-absent")}</p>
    <ul class="quiet-text">
      ${all.map(({ key, why }) => html`<li>${t(key)}: ${t(why)}</li>`)}
    </ul>`;
}

export function createAround(
  store: Store,
  actions: Actions,
): { root: HTMLElement; draw(state: State, derived: Derived): void } {
  const head = el("summary", {}, t("around-open"));
  const list = el("div", {});
  const none = el("p", { class: "quiet-text" }, t("around-none"));
  const apply = el("button", { type: "button", class: "primary" }, t("around-apply"));
  const back = el("button", { type: "button" }, t("around-back"));
  const doing = el("div", { class: "actions" }, apply, back);
  const absent = el("div", {});
  const root = el("details", { class: "around" }, head, guideButton("around"), list, none, doing, absent);
  let now: { at: string; blocks: readonly AroundBlock[]; edits: Derived["around"] } | null = null;

  const want = (change: (blocks: Blocks) => Blocks): void => {
    if (now) store.update({ snippet: { around: { at: now.at, blocks: change(wanted(now.blocks)) } } });
  };
  const hands: Hands = {
    choose: (block, on) => want(({ [block]: before, ...rest }) => (on ? { ...rest, [block]: before ?? {} } : rest)),
    type: (block, field, value) => want(all => ({ ...all, [block]: { ...all[block], [field]: value } })),
  };
  // The browser tells an unfolding only later: what is drawn meanwhile would fold it again.
  on(head, "click", event => {
    event.preventDefault();
    store.update(state => ({
      snippet: { around: state.snippet.around ? null : { at: aroundAt(state), blocks: null } },
    }));
  });
  on(apply, "click", () => {
    if (!now?.edits) return;
    actions.editProgram(now.edits.edits);
    store.update({ snippet: { around: { at: now.at, blocks: null } } });
  });
  on(back, "click", () => now && store.update({ snippet: { around: { at: now.at, blocks: null } } }));

  return {
    root,
    draw(state, { around, simulates, opened }) {
      const unfolded = state.snippet.around !== null;
      show(root, simulates === "yes");
      if (root.open !== unfolded) root.open = unfolded;
      now = around && { at: aroundAt(state), blocks: around.blocks, edits: around };
      show(none, around?.blocks.length === 0);
      show(doing, !!opened && !!around && state.snippet.around?.blocks !== null);
      apply.disabled = !around?.edits.length;
      render(around ? around.blocks.map(block => blockOf(block, hands)) : nothing, list);
      render(around ? absentOf(around.absent) : nothing, absent);
    },
  };
}
