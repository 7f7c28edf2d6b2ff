// The limits of the tolerances as bars over one scale: each is drawn wider or narrower by its ends, which writes its
// field. A drag is one step of the history; a value that is an expression is asked about once the drag is over. What
// was measured last stands above the bars, and goes through them as a line.

import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { el, keyed, on, setAttribute, setText, show } from "../dom";
import { MM_PER_INCH, parseNumber, plain } from "../numbers";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { say, t } from "../texts";
import type { Chain, ChainBar, ChainLimit, Gauge, Needle } from "../wire";
import { amount, unitBehind } from "./amounts";

/** A handle that is dragged: `side`: -1 on the left of a bar to both sides. */
interface Drag {
  limit: ChainLimit;
  bar: ChainBar;
  side: number;
  scale: Chain; // as it was in the beginning: it does not move under the pointer
  before: string; // what was typed
  late: boolean; // written when the drag is over
  value: number;
}

/** Share of half the scale, -1 to 1, at which a place lies. */
function shareOf({ end, bend }: Chain, place: number): number {
  return Math.asinh(place / bend) / Math.asinh(end / bend);
}

function placeOf({ end, bend }: Chain, share: number): number {
  return bend * Math.sinh(Math.max(-1, Math.min(1, share)) * Math.asinh(end / bend));
}

const within = ({ least, most = Infinity }: ChainLimit, value: number): number =>
  Math.min(most, Math.max(least, value));

/** The value in steps of this size, a round one. */
const stepped = (value: number, step: number): number => Number((Math.round(value / step) * step).toFixed(9));

/** The next round size of steps: of a hundredth of the value, but none below what matters. */
function fineness({ value, step }: ChainLimit): number {
  return Math.max(step, 10 ** (Math.floor(Math.log10(Math.abs(value) || step)) - 1));
}

/** To where a key leads. */
function keyTo(limit: ChainLimit, key: string): number | null {
  const step = fineness(limit);
  const by = (count: number): number => within(limit, stepped(limit.value + count * step, limit.step));
  switch (key) {
    case "ArrowRight":
    case "ArrowUp":
      return by(1);
    case "ArrowLeft":
    case "ArrowDown":
      return by(-1);
    case "PageUp":
      return by(10);
    case "PageDown":
      return by(-10);
    case "Home":
      return limit.least;
    case "End":
      return limit.most ?? null;
    default:
      return null;
  }
}

const textOf = ({ unit }: ChainLimit, value: number): string => `${plain(value)}${unitBehind(unit)}`.replace("-", "−");

/** "±1 mm"; below each other "−0.01 mm", "+0.03 mm". */
function figuresOf({ limits }: ChainBar): string {
  const [first] = limits;
  if (first && limits.length === 1) return `±${textOf(first, first.value)}`;
  return limits.map(one => `${one.value > 0 ? "+" : ""}${textOf(one, one.value)}`).join("\n");
}

const FIGURES = 2; // needles with a figure; of more the farthest has one

/** A deviation on the scale: it counts from the middle of the tolerances. */
interface Measured {
  needle: Needle;
  at: number;
}

function measuredOn({ bars }: Chain, gauge: Gauge | undefined): Measured[] {
  const middle = bars.find(bar => bar.limits.length === 1)?.zero ?? middleOf(bars[0]);
  const per = gauge?.unit === "inch" ? MM_PER_INCH : 1;
  return gauge?.needles.map(needle => ({ needle, at: middle + needle.value * per })) ?? [];
}

/** Between two limits. */
function middleOf(bar: ChainBar | undefined): number {
  const places = bar?.limits.map(limit => limit.value * limit.per) ?? [];
  return places.reduce((sum, place) => sum + place, 0) / (places.length || 1);
}

/** "+0.030 mm"; below each other "X +0.084 mm", "Y −0.046 mm". */
function measuredText({ needles, unit }: Gauge): string {
  const far = [...needles].sort((a, b) => Math.abs(b.value) - Math.abs(a.value));
  const told = needles.length > FIGURES ? far.slice(0, 1) : needles;
  return told.map(one => `${one.label} ${amount(one.value, unit, true)}${unitBehind(unit)}`.trim()).join("\n");
}

export function createChain(
  root: HTMLElement,
  store: Store,
  actions: Actions,
): (state: State, derived: Derived) => void {
  const bars = el("div", { class: "chain-bars", role: "group", "aria-label": t("chain-title") });
  const tips = el("div", { class: "chain-scale" });
  const found = el("span", { class: "chain-figures" });
  const measured = el("div", { class: "chain-bar measured" }, el("span", {}, t("chain-measured")), tips, found);
  let chain: Chain | null = null;
  let drag: Drag | null = null;
  let expressions: ReadonlySet<string> = new Set();

  const write = (name: string, value: number): void => actions.edit(name, plain(value, 9));
  const begin = (event: PointerEvent, name: string, side: number): void => {
    const bar = chain?.bars.find(one => one.limits.some(limit => limit.name === name));
    const limit = bar?.limits.find(one => one.name === name);
    if (!chain || !bar || !limit || event.button !== 0) return;
    const before = store.state.form.values[name] ?? "";
    drag = { limit, bar, side, scale: chain, before, late: expressions.has(name), value: limit.value };
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    store.update({ desk: { held: true } });
  };
  const move = (event: PointerEvent): void => {
    if (!drag) return;
    const { limit, bar, side, scale } = drag;
    const box = (event.currentTarget as Element).closest(".chain-scale")?.getBoundingClientRect();
    if (!box?.width) return;
    const zero = bar.limits.length > 1 ? 0 : bar.zero;
    const at = (x: number): number =>
      (side * (placeOf(scale, (2 * (x - box.left)) / box.width - 1) - zero)) / limit.per;
    const pixel = Math.abs(at(event.clientX + 1) - at(event.clientX - 1)) / 2;
    const grid = limit.step * 10 ** Math.max(0, Math.floor(Math.log10(pixel / limit.step)));
    const value = within(limit, stepped(at(event.clientX), grid));
    if (value === drag.value) return;
    drag = { ...drag, value };
    if (!drag.late) write(limit.name, value);
    store.update({});
  };
  const end = (kept: boolean): void => {
    if (!drag) return;
    const { limit, before, late, value } = drag;
    drag = null;
    if (!kept && !late) actions.edit(limit.name, before);
    if (kept && late && value !== limit.value) write(limit.name, value);
    store.update({ desk: { held: false } });
    actions.touch(limit.name);
  };

  const makeHandle = (name: string, side: number): HTMLElement => {
    const slider = { role: "slider", tabindex: 0, "aria-orientation": "horizontal" };
    const node = el("div", {
      class: "chain-handle",
      "data-field": name,
      ...(side > 0 ? slider : { "aria-hidden": "true" }),
    });
    on(node, "pointerdown", event => begin(event, name, side));
    on(node, "pointermove", move);
    on(node, "pointerup", () => end(true));
    on(node, "pointercancel", () => end(false));
    on(node, "keydown", event => {
      const drawn = chain?.bars.flatMap(bar => bar.limits).find(one => one.name === name);
      // keys may come faster than the bars are drawn
      const limit = drawn && { ...drawn, value: parseNumber(store.state.form.values[name] ?? "") ?? drawn.value };
      const value = limit ? keyTo(limit, event.key) : null;
      if (event.key === "Escape" && drag) end(false);
      else if (value === null) return;
      else if (value !== limit?.value) write(name, value);
      event.preventDefault();
      event.stopPropagation();
    });
    on(node, "focus", () => store.update({ form: { focus: name } }));
    return node;
  };

  const makeBar = ({ limits }: ChainBar): HTMLElement => {
    const handles = limits.map(({ name }) => makeHandle(name, 1));
    const mirrored = limits.length === 1 ? limits.map(({ name }) => makeHandle(name, -1)) : [];
    const names = limits.map(({ name }) => el("span", { class: "chain-name", "data-field": name }, name));
    return el(
      "div",
      { class: limits.length > 1 ? "chain-bar two" : "chain-bar" },
      el("div", { class: "chain-names leads" }, ...names),
      el(
        "div",
        { class: "chain-scale" },
        el("div", { class: "chain-fill" }),
        el("div", { class: "chain-zero" }),
        ...handles,
        ...mirrored,
        el("div", { class: "chain-needles", "aria-hidden": "true" }),
      ),
      el("span", { class: "chain-figures" }),
    );
  };

  const place = (node: HTMLElement, scale: Chain, at: number): void => {
    const share = Math.max(-1, Math.min(1, shareOf(scale, at))); // beyond an end it stays there
    node.style.left = `${(50 * (1 + share)).toFixed(3)}%`;
  };
  const drawHandle = (node: HTMLElement, limit: ChainLimit, typed: boolean, at: number, scale: Chain): void => {
    place(node, scale, at);
    node.classList.toggle("delivered", !typed);
    if (!node.hasAttribute("role")) return;
    setAttribute(node, "aria-label", say(limit.label));
    setAttribute(node, "aria-valuemin", limit.least);
    setAttribute(node, "aria-valuemax", limit.most ?? Math.max(limit.value, scale.end / limit.per));
    setAttribute(node, "aria-valuenow", limit.value);
    setAttribute(node, "aria-valuetext", textOf(limit, limit.value));
    setAttribute(node, "title", `${say(limit.label)}: ${textOf(limit, limit.value)}`);
  };
  const drawNeedles = (box: HTMLElement, all: Measured[], scale: Chain): void =>
    keyed(
      box,
      all,
      (_, index) => String(index),
      () => el("div", {}),
      (node, { needle, at }) => {
        place(node, scale, at);
        setAttribute(node, "class", `chain-needle needle-${needle.kind}`);
      },
    );
  const drawMeasured = (all: Measured[], gauge: Gauge | undefined, scale: Chain): void => {
    show(measured, all.length > 0);
    drawNeedles(tips, all, scale);
    setText(found, gauge && all.length ? measuredText(gauge) : "");
  };
  const drawBar = (node: HTMLElement, bar: ChainBar, all: Measured[], scale: Chain, state: State): void => {
    const [, body, figures] = node.children as unknown as [HTMLElement, HTMLElement, HTMLElement];
    const [fill, zero, ...others] = body.children as unknown as [HTMLElement, HTMLElement, ...HTMLElement[]];
    const handles = others.slice(0, -1);
    const needles = others.at(-1);
    if (needles) drawNeedles(needles, all, scale);
    const { limits } = bar;
    const places = limits.map(limit => limit.value * limit.per);
    const ends = limits.length > 1 ? places : [bar.zero + (places[0] ?? 0), bar.zero - (places[0] ?? 0)];
    handles.forEach((handle, index) => {
      const limit = limits[index] ?? limits[0];
      const typed = limit && (state.form.values[limit.name] ?? "").trim() !== "";
      if (limit) drawHandle(handle, limit, !!typed, ends[index] ?? 0, scale);
    });
    const [from, to] = [Math.min(...ends), Math.max(...ends)].map(at => 50 * (1 + shareOf(scale, at))) as [
      number,
      number,
    ];
    fill.style.left = `${from.toFixed(3)}%`;
    fill.style.width = `${(to - from).toFixed(3)}%`;
    place(zero, scale, 0);
    setText(figures, figuresOf(bar));
  };

  return (state, { view }) => {
    chain = view.chain ?? null;
    if (!chain) {
      root.replaceChildren();
      return;
    }
    if (!bars.isConnected) root.replaceChildren(measured, bars);
    expressions = new Set(view.fields.filter(one => one.expression !== undefined).map(one => one.name));
    const scale = drag?.scale ?? chain;
    const gauge = view.outcome?.answer?.gauge;
    const all = measuredOn(chain, gauge);
    drawMeasured(all, gauge, scale);
    keyed(
      bars,
      chain.bars.map(bar => (drag ? dragged(bar, drag) : bar)),
      bar => bar.limits.map(limit => limit.name).join(),
      makeBar,
      (node, bar) => drawBar(node, bar, all, scale, state),
    );
  };
}

/** The bar with the value to which it is being dragged. */
function dragged(bar: ChainBar, { limit, value }: Drag): ChainBar {
  return { ...bar, limits: bar.limits.map(one => (one.name === limit.name ? { ...one, value } : one)) };
}
