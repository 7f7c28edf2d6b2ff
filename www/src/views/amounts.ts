// Figures of an answer as they are shown: three decimals for mm and degree, four for inch.

import { fixed, signed } from "../numbers";
import { say, t } from "../texts";
import type { Answer, Correction, Figure } from "../wire";

const decimals = (unit: string): number => (unit === "inch" ? 4 : 3);

/** A figure in its unit, with its sign where it is a difference. */
export function amount(value: number, unit: string, sign = false): string {
  return sign ? signed(value, decimals(unit)) : fixed(value, decimals(unit));
}

/** The unit behind a figure. */
export function unitBehind(unit: string): string {
  if (!unit) return "";
  return unit === "deg" ? "°" : `\u00a0${t(`unit-${unit.replace("/", "-per-")}`)}`;
}

/** "Ø 50.030", "X 12.004". */
export function figureText({ symbol, actual, unit }: Figure): string {
  return `${symbol} ${amount(actual, unit)}${unit === "deg" ? "°" : ""}`.trim();
}

/** "X +0.084  Y −0.046"; with its unit where nothing was measured in it: a correction counts in that of the machine. */
function partsText({ parts }: Correction, measured: ReadonlySet<string>): string {
  const unit = (one: string): string => (one === "deg" || !measured.has(one) ? unitBehind(one) : "");
  return parts.map(one => `${one.name}\u00a0${amount(one.by, one.unit, true)}${unit(one.unit)}`).join("  ");
}

const unitsOf = ({ figures }: Answer): ReadonlySet<string> => new Set(figures.map(one => one.unit));

/** What each correction changes, in the order of the answer; empty: its data are new. */
export function allParts(answer: Answer): string[] {
  const measured = unitsOf(answer);
  return answer.corrected.map(one => partsText(one, measured));
}

/** "G54, fine X +0.084"; empty where nothing is corrected. */
export function correctedText(answer: Answer): string {
  const parts = allParts(answer);
  return answer.corrected.map((one, at) => `${say(one.target)} ${parts[at]}`.trim()).join("; ");
}

/** Of what was measured what matters first: the sizes of the same kind, at most two. */
export function mainFigures({ figures }: Answer): Figure[] {
  const first = figures[0];
  return first ? figures.filter(one => one.heading.key === first.heading.key).slice(0, 2) : [];
}

/** The answer in a few characters, behind the call in the program. */
export function hintText(answer: Answer): string {
  const measured = mainFigures(answer).map(figureText).join(" ");
  const changed = allParts(answer).filter(Boolean).join(" ");
  const bad = answer.verdict === "within" || answer.verdict === "measured" ? "" : say(answer.verdict_words);
  return [measured, changed, bad].filter(Boolean).join(" · ");
}
