// How certain a measurement is, as a quiet line under what it came to: value and expanded uncertainty, chances of the
// part, and what makes most of it.

import { html, nothing, type TemplateResult } from "lit-html";
import { guidePart } from "../guide";
import { fixed } from "../numbers";
import { say, t } from "../texts";
import type { Certain, CertaintyView } from "../wire";
import { unitBehind } from "./amounts";

const LEAST = 0.0005; // of a share: what is less is not told as nothing

/** "95.2 %"; at the ends "< 0.1 %", "> 99.9 %". */
function percent(share: number): string {
  if (share < LEAST) return t("certain-less", { share: fixed(0.1, 1) });
  if (share > 1 - LEAST) return t("certain-more", { share: fixed(99.9, 1) });
  return t("certain-share", { share: fixed(100 * share, 1) });
}

function chances({ good, rework, scrap, beyond }: NonNullable<Certain["chances"]>): string {
  const others = Object.entries({ rework, scrap, beyond }).filter(([, share]) => share >= LEAST);
  const words = [["good", good] as const, ...others];
  return words.map(([name, share]) => t(`certain-${name}`, { share: percent(share) })).join(", ");
}

/** What a value proves, and the chances of its part. */
export const provenOf = ({ proof, chances: all }: Certain): string =>
  [proof ? t(`certain-proof-${proof}`) : "", all ? chances(all) : ""].filter(Boolean).join(" ");

/** The value with its expanded uncertainty. */
export const spokenOf = ({ value, expanded, decimals, unit, coverage, symbol }: Certain): string =>
  t("certain-value", {
    value: `${symbol} ${fixed(value, decimals)}`.trim(),
    expanded: `${fixed(expanded, decimals)}${unitBehind(unit)}`,
    coverage: fixed(coverage, 0),
  });

/** What makes most of it. */
export function largestOf({ budget: [largest] }: Certain): string {
  if (!largest) return "";
  const share = Math.round(1000 * largest.share) / 10;
  const told = t("certain-share", { share: fixed(share, share === 100 ? 0 : 1) }); // nothing else contributes
  return t("certain-largest", { source: say(largest.source), share: told });
}

/** The share of the runs that did not come to an end, and count no further; empty: all did. */
export const stoppedOf = (share: number): string =>
  share < LEAST ? "" : t("certain-stopped", { share: percent(share) });

/** The most important quantity; none where nothing spreads. */
export function certainty({ figures, stopped }: CertaintyView): TemplateResult | typeof nothing {
  const first = figures[0];
  if (!first)
    return stopped < LEAST ? nothing : html`<div class="answer-certain"><span>${stoppedOf(stopped)}</span></div>`;
  const { proof } = first;
  const parts = [
    proof ? t(`certain-proof-${proof}`) : "",
    first.chances ? chances(first.chances) : "",
    largestOf(first),
    stoppedOf(stopped),
  ];
  return html`<div class="answer-certain" data-proof=${proof ?? nothing}>
    <span>${spokenOf(first)}</span>${parts.filter(Boolean).map(part => html` <span>${part}</span>`)}
    ${guidePart("certainty")}
  </div>`;
}
