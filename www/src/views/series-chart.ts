// A chart over the parts of a series: lines of one unit, and values that are the same for all parts. What it shows
// stands in figures in the table below it.

import { html, nothing, svg, type TemplateResult } from "lit-html";
import { amount, unitBehind } from "./amounts";

/** `kind`: how it is drawn, and marked in the legend. */
export interface Line {
  kind: "actual" | "set" | "limit" | "mean" | "empirical" | "correction";
  name: string;
  values: readonly (number | null)[] | number;
}

const WIDTH = 640;
const HEIGHT = 200;
const LEFT = 70; // figures of the axis
const BOTTOM = 22;
const AIR = 0.08; // of the height, above and below

/** From the smallest to the largest of all lines, with some air. */
function span(lines: readonly Line[]): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (const { values } of lines)
    for (const value of typeof values === "number" ? [values] : values)
      if (value !== null) [low, high] = [Math.min(low, value), Math.max(high, value)];
  if (low > high) return [-1, 1];
  const air = (high - low) * AIR || 0.001;
  return [low - air, high + air];
}

/** The path of a line, interrupted where there is no value; a step a part where it counts from part to part. */
function path(values: readonly (number | null)[], x: (part: number) => number, y: (value: number) => number): string {
  let drawn = "";
  let down = false;
  values.forEach((value, part) => {
    if (value !== null) drawn += `${down ? "L" : "M"}${x(part).toFixed(1)} ${y(value).toFixed(1)}`;
    down = value !== null;
  });
  return drawn;
}

/** `runs`: how many parts; `title`: what it shows, also to those who do not see it. */
export function chart(
  title: string,
  parts: string,
  lines: readonly Line[],
  runs: number,
  unit: string,
): TemplateResult {
  const [low, high] = span(lines);
  const x = (part: number): number => LEFT + ((part + 0.5) / Math.max(1, runs)) * (WIDTH - LEFT);
  const y = (value: number): number => (1 - (value - low) / (high - low)) * (HEIGHT - BOTTOM);
  const drawn = ({ kind, values }: Line): TemplateResult => {
    if (typeof values === "number")
      return svg`<path class=${`series-line ${kind}`} d=${`M${LEFT} ${y(values)}H${WIDTH}`}></path>`;
    const dots = runs <= 60 && kind === "actual" ? values : [];
    return svg`<path class=${`series-line ${kind}`} d=${path(values, x, y)}></path>${dots.map((value, part) =>
      value === null ? nothing : svg`<circle class="series-dot" cx=${x(part)} cy=${y(value)} r="3"></circle>`,
    )}`;
  };
  const ticks = [0.08, 0.5, 0.92].map(share => low + (high - low) * share);
  return html`<figure class="series-chart">
    <figcaption>${title}${unitBehind(unit)}</figcaption>
    <svg viewBox=${`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label=${title}>
      ${ticks.map(
        value => svg`<path class="series-grid" d=${`M${LEFT} ${y(value)}H${WIDTH}`}></path>
          <text class="series-tick" x=${LEFT - 6} y=${y(value) + 4} text-anchor="end">${amount(value, unit)}</text>`,
      )}
      ${lines.map(drawn)}
      <text class="series-tick" x=${x(0)} y=${HEIGHT - 4} text-anchor="middle">1</text>
      <text class="series-tick" x=${WIDTH - 4} y=${HEIGHT - 4} text-anchor="end">${runs} ${parts}</text>
    </svg>
    <ul class="series-legend">
      ${lines.map(
        ({ kind, name }) => html`<li><svg viewBox="0 0 24 8" aria-hidden="true"
          ><path class=${`series-line ${kind}`} d="M0 4H24"></path></svg>${name}</li>`,
      )}
    </ul>
  </figure>`;
}
