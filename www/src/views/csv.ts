// The record of a run as a file for spreadsheets: UTF-8 with a mark, so that they see it is; in languages with a
// decimal comma it stands there and fields are parted by semicolons. The core writes the same for the terminal
// (app/record/table.rs); docs/hole.record.csv holds the two together.

import { shortLine } from "../desk/beside";
import { sliced } from "../pace";
import { say, t } from "../texts";
import type { Correction, Figure, RunRecord } from "../wire";

type Call = RunRecord["calls"][number];
const MARK = "\ufeff";
const DECIMALS = 6;
const ON = 1e-6; // how far a deviation on a limit may be off by calculation
const COLUMNS = [
  ...["number", "line", "cycle", "feature", "quantity", "nominal", "low", "high", "actual", "deviation", "used"],
  ...["unit", "within", "verdict", "corrects", "probe", "calibration", "alarms", "why"],
];

const unit = (name: string): string => (name === "deg" ? "°" : name);

/** A figure without needless zeros. */
function figure(value: number | undefined | null, comma: boolean): string {
  if (value === undefined || value === null || !Number.isFinite(value)) return "";
  const text = value.toFixed(DECIMALS).replace(/\.?0+$/, "");
  const shown = text === "-0" ? "0" : text;
  return comma ? shown.replace(".", ",") : shown;
}

/** In quotes where it has to be; what a spreadsheet would take for a formula gets an apostrophe. */
function field(text: string, parted: string): string {
  const safe = /^[=@]/.test(text) ? `'${text}` : text;
  return safe.includes(parted) || /["\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}

function corrected(all: readonly Correction[], comma: boolean): string {
  const one = ({ target, parts }: Correction): string => {
    const by = parts.map(part => {
      const behind = part.unit === "deg" ? "°" : ` ${unit(part.unit)}`;
      return ` ${part.name} ${figure(part.by, comma)}${behind}`;
    });
    return say(target) + by.join("");
  };
  return all.map(one).join(", ");
}

/** Key of whether a quantity by itself is within its limits. */
function held(one: Figure | undefined): string {
  if (!one?.limits || one.deviation === undefined) return "record-unlimited";
  const { low, high } = one.limits;
  return one.deviation >= low - ON && one.deviation <= high + ON ? "record-within" : "record-beyond";
}

/** A line for each quantity of each call. */
function linesOf(call: Call, index: number, comma: boolean, files: RunRecord["files"]): string[][] {
  const line = call.line === undefined ? "" : shortLine(files, call.line);
  const row = (one: Figure | undefined): string[] => [
    ...[String(index + 1), line, call.cycle ?? "", say(call.feature), one ? say(one.label) : ""],
    ...[one?.set, one?.limits?.low, one?.limits?.high].map(value => figure(value, comma)),
    ...[one?.actual, one?.deviation, one?.limits?.used].map(value => figure(value, comma)),
    ...[one ? unit(one.unit) : "", t(held(one)), say(call.verdict_words), corrected(call.corrected, comma)],
    ...[say(call.probe.name), say(call.probe.calibration), call.alarms.join(" "), say(call.why)],
  ];
  return call.figures.length ? call.figures.map(row) : [row(undefined)];
}

/** The file in pieces; between them the page has its turn. */
export async function csv({ calls, files }: Pick<RunRecord, "calls" | "files">): Promise<string[]> {
  const comma = t("record-decimal-sign") === ",";
  const parted = comma ? ";" : ",";
  const line = (fields: string[]): string => `${fields.map(text => field(text, parted)).join(parted)}\r\n`;
  const pieces = [MARK, line(COLUMNS.map(one => t(`record-column-${one}`)))];
  const pace = sliced();
  for (const [index, call] of calls.entries()) {
    await pace.turn(0);
    pieces.push(linesOf(call, index, comma, files).map(line).join(""));
  }
  return pieces;
}
