// The measuring calls of the program: line, cycle, variant, and what is said about them; among them those that have no
// form. Only the rows in sight exist, so that a thousand calls cost as much as ten.

import { html, nothing, render } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import type { Derived } from "../desk/derive";
import { el, on, setAttribute, show } from "../dom";
import { type Command, meantBy } from "../keys";
import type { State } from "../state/state";
import { say, t } from "../texts";
import type { CallView, Catalogue, OtherCall, ReadView, Severity } from "../wire";

const BEYOND = 4; // rows drawn above and below what is in sight
type Mark = Severity | "ok" | "explained"; // the last: it has no form
const MARKS: Record<Mark, string> = { ok: "✓", note: "✓", warning: "!", error: "✕", explained: "·" };

/** A call with its number, or one that has no form. */
type Item = { call: CallView; index: number } | { other: OtherCall };

interface Row {
  cycle: string;
  line: number;
  place: number; // among all rows
  index: number | null; // of the call
  state: Mark;
  says: string;
  open: boolean;
}

/** All rows in the order of the text. */
function itemsOf({ calls, others }: ReadView): Item[] {
  const all: Item[] = calls.map((call, index) => ({ call, index }));
  if (!others?.length) return all;
  const from = (one: Item): number => ("call" in one ? one.call.from : one.other.from);
  return [...all, ...others.map(other => ({ other }))].sort((one, other) => from(one) - from(other));
}

/** Names of the variants, looked up once. */
function variantNames({ cycles }: Catalogue): Map<string, string> {
  return new Map(
    cycles.flatMap(cycle =>
      cycle.variants.map(variant => [`${cycle.control}/${cycle.cycle}/${variant.mvar}`, variant.key]),
    ),
  );
}

function row({ cycle, line, place, index, state, says, open }: Row, count: number, current: boolean, tall: number) {
  return html`<div
    role="option"
    class=${current ? "call-row current" : "call-row"}
    id=${`call-${place}`}
    data-row=${place}
    data-call=${index ?? nothing}
    data-state=${state}
    aria-selected=${String(open)}
    aria-setsize=${count}
    aria-posinset=${place + 1}
    .style=${`top: ${place * tall}px`}
    ><span class="call-mark" aria-hidden="true">${MARKS[state]}</span
    ><code>${cycle}</code
    ><span class="call-line">${t("program-call-line", { line })}</span
    ><span class="call-variant">${says}</span
    ><span class="visually-hidden">${t(`call-state-${state}`)}</span
  ></div>`; // no gaps: so it is copied
}

/** `showPlace`: of a call that has no form. */
export function createOutline(
  openCall: (index: number) => void,
  showPlace: (offset: number) => void,
): {
  root: HTMLElement;
  draw(state: State, derived: Derived): void;
} {
  const space = el("div", { class: "outline-space" });
  const list = el(
    "div",
    { class: "outline", id: "outline", role: "listbox", tabindex: "0", "aria-label": t("program-calls") },
    space,
  );
  let names: Map<string, string> | null = null;
  let cycles: Catalogue["cycles"] | null = null; // that they are of
  let shown: { state: State; derived: Derived } | null = null;
  let items: { read: ReadView; all: Item[] } | null = null;
  let current = 0;
  let opened: number | null = null; // where the call begins that was scrolled to

  const height = (): number => parseFloat(getComputedStyle(list).getPropertyValue("--row")) || 38;
  const allOf = (read: ReadView): Item[] => {
    if (items?.read !== read) items = { read, all: itemsOf(read) };
    return items.all;
  };
  const all = (): Item[] => (shown ? allOf(shown.derived.read) : []);
  const rows = (from: number, to: number): Row[] => {
    if (!shown) return [];
    const { derived, state } = shown;
    return all()
      .slice(from, to)
      .map((item, offset): Row => {
        const place = from + offset;
        if ("other" in item) {
          const { cycle, line, title } = item.other;
          return { cycle, line, place, index: null, state: "explained", says: say(title), open: false };
        }
        const { call, index } = item;
        const key = names?.get(`${call.control}/${call.cycle}/${call.mvar}`);
        return {
          cycle: call.cycle,
          line: call.lastLine,
          place,
          index,
          state: derived.states[index] ?? "ok",
          says: call.title ? say(call.title) : key ? t(key) : t("call-variant-unknown"),
          open: state.form.open === call.from,
        };
      });
  };
  const draw = (): void => {
    const count = all().length;
    const tall = height();
    current = Math.max(0, Math.min(current, count - 1));
    const first = Math.max(0, Math.floor(list.scrollTop / tall) - BEYOND);
    const last = Math.min(count, Math.ceil((list.scrollTop + list.clientHeight) / tall) + BEYOND);
    space.style.height = `${count * tall}px`;
    render(
      repeat(
        rows(first, last),
        one => one.place,
        one => row(one, count, one.place === current, tall),
      ),
      space,
    );
    setAttribute(list, "aria-activedescendant", current >= first && current < last ? `call-${current}` : null);
  };
  const bring = (index: number): void => {
    const tall = height();
    const top = index * tall;
    if (top < list.scrollTop) list.scrollTop = top;
    else if (top + tall > list.scrollTop + list.clientHeight) list.scrollTop = top + tall - list.clientHeight;
  };
  const go = (index: number): void => {
    current = Math.max(0, Math.min(index, all().length - 1));
    bring(current);
    draw();
  };
  on(list, "scroll", draw);
  const choose = (): void => {
    const item = all()[current];
    if (!item) return;
    if ("call" in item) openCall(item.index);
    else showPlace(item.other.from);
  };
  on(list, "click", event => {
    const place = (event.target as Element).closest<HTMLElement>("[data-row]")?.dataset.row;
    if (place === undefined) return;
    go(Number(place));
    choose();
  });
  on(list, "keydown", event => {
    const page = Math.max(1, Math.floor(list.clientHeight / height()) - 1);
    const moves: Partial<Record<Command<"list">, () => void>> = {
      next: () => go(current + 1),
      previous: () => go(current - 1),
      "next-page": () => go(current + page),
      "previous-page": () => go(current - page),
      first: () => go(0),
      last: () => go(Infinity),
      choose,
    };
    const move = moves[meantBy(event, "list") ?? "leave"];
    if (!move) return;
    event.preventDefault();
    move();
  });
  new ResizeObserver(draw).observe(list);

  return {
    root: list,
    draw(state, derived) {
      const before = shown;
      const visible = state.panels.outline && allOf(derived.read).length > 0;
      show(list, visible);
      if (visible && derived.catalogue.cycles !== cycles) {
        names = variantNames(derived.catalogue);
        cycles = derived.catalogue.cycles;
      }
      const same =
        before?.derived.read === derived.read &&
        before.derived.states === derived.states &&
        before.state.form.open === state.form.open &&
        before.state.panels.outline === state.panels.outline;
      shown = { state, derived };
      if (!visible || same) return;
      const index = all().findIndex(one => "call" in one && one.call.from === state.form.open);
      if (index >= 0 && state.form.open !== opened) {
        current = index;
        bring(index);
      }
      opened = state.form.open;
      draw();
    },
  };
}
