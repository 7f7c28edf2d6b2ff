// The measurements of a program as a file for spreadsheets: UTF-8 with a mark, so that they see it is. Where people
// write a decimal comma, as in German, it stands there and fields are parted by semicolons; else a point and commas.

import { shortLine } from "../desk/beside";
import { language, say, t } from "../texts";
import type { RunView } from "../wire";
import { correctedText } from "./amounts";

type Row = RunView["answers"][number];
type Files = RunView["files"];
const MARK = "\ufeff";
const DECIMALS = 6;

/** Whether numbers of the language that is shown have a decimal comma. */
function hasComma(): boolean {
  return new Intl.NumberFormat(language()).format(0.5).includes(",");
}

/** A figure without needless zeros. */
function figure(value: number | undefined, comma: boolean): string {
  if (value === undefined || !Number.isFinite(value)) return "";
  const text = String(Number(value.toFixed(DECIMALS)));
  return comma ? text.replace(".", ",") : text;
}

/** In quotes where it has to be; what a spreadsheet would take for a formula gets an apostrophe. */
function field(text: string, parted: string): string {
  const safe = /^[=@]/.test(text) ? `'${text}` : text;
  return safe.includes(parted) || /["\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}

/** A line for each quantity of each call. */
function linesOf(row: Row, index: number, comma: boolean, files: Files): string[][] {
  const limits = row.gauge?.bands.filter(one => one.kind !== "bad") ?? [];
  const line = row.line === undefined ? "" : shortLine(files, row.line);
  const call = [String(index + 1), line, row.cycle ?? "", say(row.feature)];
  const end = [say(row.verdict_words), correctedText(row), row.alarm ?? "", say(row.why)];
  const figures = row.figures.length ? row.figures : [undefined];
  return figures.map(one => [
    ...call,
    one ? say(one.label) : "",
    figure(one?.set, comma),
    figure(one?.actual, comma),
    figure(one?.deviation, comma),
    one?.unit ? t(`unit-${one.unit}`) : "",
    figure(limits[0]?.from, comma),
    figure(limits[limits.length - 1]?.to, comma),
    ...end,
  ]);
}

/** `files`: where those beside the program begin, by its lines. */
export function csv(rows: Row[], files: Files): string {
  const comma = hasComma();
  const parted = comma ? ";" : ",";
  const heads = ["number", "line", "cycle", "feature", "quantity", "nominal", "actual", "deviation", "unit"];
  const more = ["low", "high", "verdict", "corrects", "alarm", "why"];
  const all = [
    [...heads, ...more].map(one => t(`whole-${one}-name`)),
    ...rows.flatMap((row, index) => linesOf(row, index, comma, files)),
  ];
  return `${MARK}${all.map(line => line.map(text => field(text, parted)).join(parted)).join("\r\n")}\r\n`;
}
