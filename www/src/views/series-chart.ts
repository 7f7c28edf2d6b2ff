// A chart over the parts of a series: lines of one unit, and values that are the same for all parts. The pointer, or
// the arrow keys, choose a part, whose figures are told below the chart; all of them stand in the table.

import { ticks } from "d3-array";
import { line } from "d3-shape";
import { html, nothing, svg, type TemplateResult } from "lit-html";
import { t } from "../texts";
import { amount, unitBehind } from "./amounts";

/** `kind`: how it is drawn, and marked in the legend. */
export interface Line {
  kind: "actual" | "set" | "limit" | "mean" | "empirical" | "correction";
  name: string;
  values: readonly (number | null)[] | number;
}

export const PAPER_WIDTH = 640;
const NARROWEST = 280;
const WIDEST = 1000;
const HEIGHT = 200;
const TICKS = 4; // about as many
const LEFT = 70; // figures of the axis
const TOP = 8;
const BOTTOM = 22;
const AIR = 0.08; // of the height, above and below
const LEAST = 0.002; // half of what a chart shows at least, mm or inch: a step of the axis has a figure of its own

/** From the smallest to the largest of all lines, with some air. */
function span(lines: readonly Line[]): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const { values } of lines)
    for (const value of typeof values === "number" ? [values] : values)
      if (value !== null) [low, high] = [Math.min(low, value), Math.max(high, value)];
  if (low > high) return [-1, 1];
  const air = Math.max((high - low) * AIR, LEAST - (high - low) / 2);
  return [low - air, high + air];
}

/** The path of a line, interrupted where there is no value. */
function path(values: readonly (number | null)[], x: (part: number) => number, y: (value: number) => number): string {
  const way = line<number | null>(
    (_, part) => x(part),
    value => y(value ?? 0),
  ).defined(value => value !== null);
  return way.digits(1)(values) ?? "";
}

/** The part that a key goes to from another; the same one: the key is none of the chart. */
function partBy(key: string, from: number, last: number): number {
  const page = Math.max(1, Math.round(last / 10));
  const by: Record<string, number> = { ArrowRight: 1, ArrowLeft: -1, ArrowUp: 1, ArrowDown: -1 };
  const to: Record<string, number> = { Home: 0, End: last, PageUp: from + page, PageDown: from - page };
  const asked = to[key] ?? from + (by[key] ?? 0);
  return Math.min(last, Math.max(0, asked));
}

/** What all lines have at a part, in words. */
function told(lines: readonly Line[], part: number, unit: string): string {
  const values = lines.flatMap(({ name, values }) => {
    const value = typeof values === "number" ? values : values[part];
    return value == null ? [] : [`${name} ${amount(value, unit)}${unitBehind(unit)}`];
  });
  return [t("runs-part-at", { part: part + 1 }), ...values].join(" · ");
}

/** `runs`: how many parts; `room`: what there is for it, px; `title`: what it shows, in words. */
export function chart(
  title: string,
  parts: string,
  lines: readonly Line[],
  runs: number,
  unit: string,
  room: number,
): TemplateResult {
  const width = Math.min(WIDEST, Math.max(NARROWEST, room));
  const [low, high] = span(lines);
  const x = (part: number): number => LEFT + ((part + 0.5) / Math.max(1, runs)) * (width - LEFT);
  const y = (value: number): number => TOP + ((high - value) / (high - low)) * (HEIGHT - TOP - BOTTOM);
  const drawn = ({ kind, values }: Line): TemplateResult => {
    if (typeof values === "number")
      return svg`<path class=${`series-line ${kind}`} d=${`M${LEFT} ${y(values)}H${width}`}></path>`;
    const dots = runs <= 60 && kind === "actual" ? values : [];
    return svg`<path class=${`series-line ${kind}`} d=${path(values, x, y)}></path>${dots.map((value, part) =>
      value === null ? nothing : svg`<circle class="series-dot" cx=${x(part)} cy=${y(value)} r="3"></circle>`,
    )}`;
  };
  const last = Math.max(0, runs - 1);
  const choose = (stage: Element, part: number): void => {
    const words = told(lines, part, unit);
    stage.setAttribute("aria-valuenow", String(part + 1));
    stage.setAttribute("aria-valuetext", words);
    stage.querySelector(".series-cursor")?.setAttribute("d", `M${x(part).toFixed(1)} 0V${HEIGHT - BOTTOM}`);
    const below = stage.parentElement?.querySelector(".series-told");
    if (below) below.textContent = words;
  };
  const pointed = (event: PointerEvent): void => {
    const stage = event.currentTarget as Element;
    const box = stage.getBoundingClientRect();
    const at = (((event.clientX - box.left) / box.width) * width - LEFT) / (width - LEFT);
    choose(stage, Math.min(last, Math.max(0, Math.floor(at * runs))));
  };
  const typed = (event: KeyboardEvent): void => {
    const stage = event.currentTarget as Element;
    const from = Number(stage.getAttribute("aria-valuenow")) - 1;
    const to = partBy(event.key, from, last);
    if (to === from) return;
    event.preventDefault();
    choose(stage, to);
  };
  return html`<figure class="series-chart">
    <figcaption>${title}${unitBehind(unit)}</figcaption>
    <svg class="series-stage" viewBox=${`0 0 ${width} ${HEIGHT}`} role="slider" tabindex="0" aria-label=${title}
      aria-valuemin="1" aria-valuemax=${last + 1} aria-valuenow="1" aria-valuetext=${told(lines, 0, unit)}
      @pointermove=${pointed} @pointerdown=${pointed} @keydown=${typed}>
      <path class="series-cursor"></path>
      ${ticks(low, high, TICKS).map(
        value => svg`<path class="series-grid" d=${`M${LEFT} ${y(value)}H${width}`}></path>
          <text class="series-tick" x=${LEFT - 6} y=${y(value) + 4} text-anchor="end">${amount(value, unit)}</text>`,
      )}
      ${lines.map(drawn)}
      <text class="series-tick" x=${x(0)} y=${HEIGHT - 4} text-anchor="middle">1</text>
      <text class="series-tick" x=${width - 4} y=${HEIGHT - 4} text-anchor="end">${runs} ${parts}</text>
    </svg>
    <p class="series-told" aria-hidden="true">&nbsp;</p>
    <ul class="series-legend">
      ${lines
        .filter(({ name }, at) => lines.findIndex(one => one.name === name) === at)
        .map(
          ({ kind, name }) => html`<li><svg viewBox="0 0 24 8" aria-hidden="true"
          ><path class=${`series-line ${kind}`} d="M0 4H24"></path></svg>${name}</li>`,
        )}
    </ul>
  </figure>`;
}
