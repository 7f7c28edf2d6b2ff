// Figures of a mask with the decimals of the control: four for mm and degrees, five for inches.

import { fixed, plain, signed } from "../numbers";
import { t } from "../texts";
import type { PracticeFigure } from "../wire";

const DIGITS: Record<string, number> = { mm: 4, deg: 4, inch: 5 };

const unitText = (unit: string): string => (unit ? ` ${t(`unit-${unit}`)}` : "");

/** With a sign where it is a difference; what has no unit is the number that it is. */
function numberText(value: number, unit: string, sign = false): string {
  const digits = DIGITS[unit];
  if (digits === undefined) return plain(value);
  return sign ? signed(value, digits) : fixed(value, digits);
}

export function figureText({ axis, value, unit }: PracticeFigure, sign = false): string {
  return `${axis ? `${axis} ` : ""}${numberText(value, unit, sign)}${unitText(unit)}`;
}

/** A value before and after it was written; its unit once. */
export function writtenText(before: number, after: number, unit: string): { before: string; after: string } {
  return { before: numberText(before, unit), after: numberText(after, unit) + unitText(unit) };
}

/** A place, mm. */
export function placeText(at: readonly number[]): string {
  return `${at.map((value, axis) => `${"XYZ".charAt(axis)} ${numberText(value, "mm")}`).join(", ")}${unitText("mm")}`;
}
