// The measuring calls of the program: line, cycle, variant, and what is said about them. Only the rows in sight exist,
// so that a thousand calls cost as much as ten.

import { html, render } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import type { Derived } from "../desk/derive";
import { el, on, setAttribute, show } from "../dom";
import { type Command, meantBy } from "../keys";
import type { State } from "../state/state";
import { t } from "../texts";
import type { CallView, Catalogue, Severity } from "../wire";

const BEYOND = 4; // rows drawn above and below what is in sight
const MARKS: Record<Severity | "ok", string> = { ok: "✓", note: "✓", warning: "!", error: "✕" };

interface Row {
  call: CallView;
  index: number;
  state: Severity | "ok";
  variant: string;
  open: boolean;
}

/** Names of the variants, looked up once. */
function variantNames({ cycles }: Catalogue): Map<string, string> {
  return new Map(
    cycles.flatMap(cycle =>
      cycle.variants.map(variant => [`${cycle.control}/${cycle.cycle}/${variant.mvar}`, variant.key]),
    ),
  );
}

function row({ call, index, state, variant, open }: Row, count: number, current: boolean, tall: number) {
  return html`<div
    role="option"
    class=${current ? "call-row current" : "call-row"}
    id=${`call-${index}`}
    data-call=${index}
    data-state=${state}
    aria-selected=${String(open)}
    aria-setsize=${count}
    aria-posinset=${index + 1}
    .style=${`top: ${index * tall}px`}
    ><span class="call-mark" aria-hidden="true">${MARKS[state]}</span
    ><code>${call.cycle}</code
    ><span class="call-line">${t("program-call-line", { line: call.lastLine })}</span
    ><span class="call-variant">${variant}</span
    ><span class="visually-hidden">${t(`call-state-${state}`)}</span
  ></div>`; // no gaps: so it is copied
}

export function createOutline(openCall: (index: number) => void): {
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
  let current = 0;
  let opened: number | null = null; // where the call begins that was scrolled to

  const height = (): number => parseFloat(getComputedStyle(list).getPropertyValue("--row")) || 38;
  const rows = (from: number, to: number): Row[] => {
    if (!shown) return [];
    const { derived, state } = shown;
    return derived.read.calls.slice(from, to).map((call, offset): Row => {
      const key = names?.get(`${call.control}/${call.cycle}/${call.mvar}`);
      const said = derived.states[from + offset];
      return {
        call,
        index: from + offset,
        state: said ?? "ok",
        variant: key ? t(key) : t("call-variant-unknown"),
        open: state.form.open === call.from,
      };
    });
  };
  const draw = (): void => {
    const count = shown?.derived.read.calls.length ?? 0;
    const tall = height();
    current = Math.max(0, Math.min(current, count - 1));
    const first = Math.max(0, Math.floor(list.scrollTop / tall) - BEYOND);
    const last = Math.min(count, Math.ceil((list.scrollTop + list.clientHeight) / tall) + BEYOND);
    space.style.height = `${count * tall}px`;
    render(
      repeat(
        rows(first, last),
        one => one.index,
        one => row(one, count, one.index === current, tall),
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
    current = Math.max(0, Math.min(index, (shown?.derived.read.calls.length ?? 1) - 1));
    bring(current);
    draw();
  };
  on(list, "scroll", draw);
  on(list, "click", event => {
    const index = (event.target as Element).closest<HTMLElement>("[data-call]")?.dataset.call;
    if (index === undefined) return;
    go(Number(index));
    openCall(Number(index));
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
      choose: () => openCall(current),
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
      const visible = state.panels.outline && derived.read.calls.length > 0;
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
      const index = derived.read.calls.findIndex(call => call.from === state.form.open);
      if (index >= 0 && state.form.open !== opened) {
        current = index;
        bring(index);
      }
      opened = state.form.open;
      draw();
    },
  };
}
