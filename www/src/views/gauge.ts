// A scale with limits, and needles for what was measured; all figures are the core's.

import { html, svg, type TemplateResult } from "lit-html";
import { listed, t } from "../texts";
import type { Gauge, Needle } from "../wire";
import { amount, unitBehind } from "./amounts";

const LEFT = 10;
const WIDE = 220;
const NEAR = 26; // needles closer than this push their names apart

/** Where a value lies; beyond an end it stays there. */
function across({ low, high }: Gauge): (value: number) => number {
  return value => LEFT + (Math.min(1, Math.max(0, (value - low) / (high - low))) || 0) * WIDE;
}

/** Names of needles that would lie upon each other stand beside them; of more than two the farthest has one. */
function named(needles: Needle[], at: (value: number) => number): Map<Needle, string> {
  const worst = needles.reduce((a, b) => (Math.abs(b.value) > Math.abs(a.value) ? b : a));
  if (needles.length > 2) return new Map([[worst, "middle"]]);
  const [left, right] = [...needles].sort((a, b) => a.value - b.value);
  const close = left && right && at(right.value) - at(left.value) < NEAR;
  return new Map(needles.map(one => [one, !close ? "middle" : one === left ? "end" : "start"]));
}

/** "X +0.084 mm, Y −0.046 mm": what the needles show. */
export function needlesText({ needles, unit }: Gauge): string {
  return listed(needles.map(one => `${one.label} ${amount(one.value, unit, true)}${unitBehind(unit)}`.trim()));
}

/** Beside a text that says the same: the limits and how far the needles are. */
export function gaugePicture(gauge: Gauge): TemplateResult {
  const at = across(gauge);
  const { bands, marks, needles, unit } = gauge;
  const names = named(needles, at);
  const outer = [marks[0], marks[marks.length - 1]].filter(one => one !== undefined);
  const label = t("bar-gauge", {
    needles: needlesText(gauge),
    low: amount(outer[0]?.value ?? gauge.low, unit, true),
    high: amount(outer[1]?.value ?? gauge.high, unit, true),
  });
  const single = needles.length === 1;
  return html`<svg class="gauge leads" viewBox="0 0 240 50" role="img" aria-label=${label}>
    ${bands.map(
      ({ kind, from, to }) =>
        svg`<rect class=${`band band-${kind}`} x=${at(from)} width=${Math.max(0, at(to) - at(from))} y="20" height="8"
        ></rect>`,
    )}
    ${marks.map(
      ({ name, value }) =>
        svg`<line class="mark" data-field=${name} x1=${at(value)} x2=${at(value)} y1="18" y2="31"></line>`,
    )}
    <line class="mark zero" x1=${at(0)} x2=${at(0)} y1="20" y2="31"></line>
    ${outer.map(
      ({ name, value }) =>
        svg`<text class="limit" data-field=${name} x=${at(value)} y="43" text-anchor="middle"
        >${amount(value, unit, true)}</text>`,
    )}
    <text class="limit" x=${at(0)} y="43" text-anchor="middle">0</text>
    ${needles.map(one => {
      const x = at(one.value);
      const anchor = names.get(one);
      const shift = anchor === "end" ? -2 : anchor === "start" ? 2 : 0;
      const place = Math.min(215, Math.max(25, x + shift));
      const text = one.label || (single ? amount(one.value, unit, true) : "");
      return svg`<g class=${`needle needle-${one.kind}`}>
        <path d=${`M${x} 31V20M${x - 4} 14h8l-4 6z`}></path>
        ${anchor ? svg`<text x=${place} y="11" text-anchor=${anchor}>${text}</text>` : ""}
      </g>`;
    })}
  </svg>`;
}
