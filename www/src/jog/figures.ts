// Figures of a mask: three places for mm, four for degrees, as the control shows them.

import { signed } from "../numbers";
import { t } from "../texts";
import type { PracticeFigure } from "../wire";

const DIGITS: Record<string, number> = { mm: 3, deg: 3 };

export function figureText({ axis, value, unit }: PracticeFigure, sign = false): string {
  const digits = DIGITS[unit] ?? 3;
  const number = sign ? signed(value, digits) : signed(value, digits).replace(/^\+/, "");
  return `${axis ? `${axis} ` : ""}${number} ${t(`unit-${unit}`)}`;
}
