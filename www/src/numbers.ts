// Numbers as people type them and as the page shows them.

export const MM_PER_INCH = 25.4;

/** Decimal comma or point; null when it is no number. */
export function parseNumber(text: string): number | null {
  const plain = text.trim().replace(",", ".").replace("\u2212", "-");
  if (!/^[+-]?(\d+\.?\d*|\.\d+)$/.test(plain)) return null;
  return Number(plain);
}

/** At most `digits` decimals, no trailing zeros, never "-0". */
export function plain(value: number, digits = 6): string {
  if (!Number.isFinite(value)) return "–";
  const text = value.toFixed(digits).replace(/\.0+$|(?<=\.\d+)0+$/, "");
  return text === "-0" ? "0" : text;
}

/** With all decimals that it has: below 1e21 `parseNumber` makes the same number of it. */
export function exact(value: number): string {
  const [, sign, digit, decimals = "", zeros] = /^(-?)(\d)\.?(\d*)e-(\d+)$/.exec(String(value)) ?? [];
  return zeros === undefined ? String(value) : `${sign}0.${"0".repeat(Number(zeros) - 1)}${digit}${decimals}`;
}

/** For columns of figures: always `digits` decimals. */
export function fixed(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "–";
  const text = value.toFixed(digits);
  return Number(text) === 0 ? (0).toFixed(digits) : text.replace("-", "\u2212");
}

/** With its sign, for differences. */
export function signed(value: number, digits = 4): string {
  const text = fixed(value, digits);
  return Number(value.toFixed(digits)) > 0 ? `+${text}` : text;
}

/** Whether a program writes what was typed so: with decimal points, without blanks, where it calculates in brackets. */
export function writtenAs(typed: string, written: string): boolean {
  const bare = (text: string): string => text.replace(/\s+/g, "").replace(/(?<=\d),(?=\d)/g, ".");
  return [bare(typed), `[${bare(typed)}]`].includes(bare(written));
}
