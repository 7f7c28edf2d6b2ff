// The record of a run on paper, one for a part: what was measured where and with what, each quantity within its limits,
// and the features with their numbers. What only people know has an empty line to write on.

import { shortLine } from "../desk/beside";
import type { Derived } from "../desk/derive";
import { el, svg } from "../dom";
import { plain } from "../numbers";
import type { Still } from "../preview/still";
import { fileOf } from "../state/files";
import type { State } from "../state/state";
import { say, t } from "../texts";
import type { Figure, RunView } from "../wire";
import { amount, correctedText, unitBehind } from "./amounts";
import type { RecordShown, TITLES } from "./record";
import { now } from "./sheet";

type Call = RunView["answers"][number];
type Draw = typeof import("../preview/still");
const VIEW = { width: 680, height: 330 }; // CSS pixels
const MOST_NUMBERS = 80; // in the picture
const ONE_SHEET = 24; // lines of a table with which all of it may have room on a sheet
const ON = 1 + 1e-6; // share of a limit that is not beyond it
const WIDE = 60; // of a bar, its units

const word = (key: string): string => t(`record-sheet-${key}`);

/** What a title has: as filled in, the machine else as its profile calls it. */
const filled = (state: State, about: RecordShown["about"], key: (typeof TITLES)[number]): string =>
  state.view.titles[key]?.trim() || (key === "machine" ? about.machine : "");

/** Name and value. */
function titles(state: State, { about }: RecordShown): HTMLElement {
  const all: [string, string][] = [
    ["part", filled(state, about, "part")],
    ["program", fileOf(state).name],
    ["order", filled(state, about, "order")],
    ["machine", filled(state, about, "machine")],
    ["clock", about.clock.replace("T", " ")],
    ["control", t(`control-${about.control}`)],
    ["printed", now()],
    ["probe", t("record-sheet-ball", { diameter: plain(about.ball, 4) })],
  ];
  return el(
    "dl",
    { class: "record-titles" },
    ...all.map(([key, value]) => el("div", {}, el("dt", {}, word(key)), el("dd", {}, value))),
  );
}

/** A deviation from the middle within its limits; beyond them it ends at the edge. */
function bar({ limits, deviation }: Figure): SVGElement | null {
  if (!limits || deviation === undefined) return null;
  const [low, high] = [1.4 * limits.low, 1.4 * limits.high];
  const at = (value: number): number => 2 + Math.min(1, Math.max(0, (value - low) / (high - low))) * (WIDE - 4);
  const [from, to, zero, end] = [limits.low, limits.high, 0, deviation].map(at) as [number, number, number, number];
  return svg(
    "svg",
    { class: "record-bar", viewBox: `0 0 ${WIDE} 10`, "aria-hidden": "true" },
    svg("rect", { class: "room", x: from, y: 2, width: to - from, height: 6 }),
    svg("path", { class: "zero", d: `M${zero} 0V10` }),
    svg("path", { class: "needle", d: `M${zero} 5H${end}` }),
    svg("circle", { class: "needle", cx: end, cy: 5, r: 2.2 }),
  );
}

function tolerance({ limits, unit }: Figure): string {
  if (!limits) return "–";
  if (limits.low === -limits.high) return `±${amount(limits.high, unit)}`;
  return `${amount(limits.low, unit, true)} ${amount(limits.high, unit, true)}`;
}

const size = (value: number | undefined, unit: string): string =>
  value === undefined ? "–" : `${amount(value, unit)}${unitBehind(unit)}`;

/** A line for each quantity; what is of the whole call stands in the first of them. */
function rowsOf(call: Call, index: number, files: RunView["files"]): HTMLElement[] {
  const figures: (Figure | null)[] = call.figures.length ? call.figures : [null];
  const alarms = call.alarms.filter(code => !say(call.verdict_words).includes(code)).join(" ");
  return figures.map((one, at) => {
    const first = at === 0;
    const used = one?.limits?.used;
    const share = used === undefined || used === null ? "" : t("whole-used", { share: Math.round(used * 100) });
    const cells: (string | Node | null)[] = [
      first ? String(index + 1) : "",
      first ? say(call.feature) : "",
      first && call.line !== undefined ? shortLine(files, call.line) : "",
      one ? `${say(one.heading)} ${one.symbol}`.trim() : "",
      size(one?.set, one?.unit ?? ""),
      one ? tolerance(one) : "–",
      size(one?.actual, one?.unit ?? ""),
      one?.deviation === undefined ? "–" : amount(one.deviation, one.unit, true),
      one ? bar(one) : null,
      share,
      first ? [say(call.verdict_words), alarms].filter(Boolean).join(" · ") : "",
      first ? correctedText(call) : "",
      first ? `${call.probe.number}: ${say(call.probe.calibration)}` : "",
    ];
    const sort = [first && "record-call", (used ?? 0) > ON && "record-beyond"].filter(Boolean).join(" ");
    const row = el("tr", { class: sort });
    row.append(...cells.map(cell => el("td", {}, cell)));
    row.dataset.verdict = call.verdict;
    return row;
  });
}

function table({ answers, files }: RecordShown): HTMLElement {
  const heads = [
    ...["number", "feature", "line", "quantity", "nominal"].map(one => t(`record-column-${one}`)),
    word("tolerance"),
    ...["actual", "deviation"].map(one => t(`record-column-${one}`)),
    "",
    word("used"),
    ...["verdict", "corrects", "probe"].map(one => t(`record-column-${one}`)),
  ];
  heads[0] = t("whole-number");
  return el(
    "table",
    { class: "record-table" },
    el("thead", {}, el("tr", {}, ...heads.map(one => el("th", { scope: "col" }, one)))),
    el("tbody", {}, ...answers.flatMap((call, index) => rowsOf(call, index, files))),
  );
}

/** The part with the number of each call at what it touched. */
function picture(
  state: State,
  { trace, scene, step }: Derived,
  { answers }: RecordShown,
  { drawStill }: Draw,
): HTMLElement | null {
  if (!trace || !scene || state.view.source !== "program") return null;
  const marks = answers.slice(0, MOST_NUMBERS).flatMap(({ place }, index) => {
    return place ? [{ at: place, text: String(index + 1) }] : [];
  });
  const still: Still = { data: scene(1), step, cloud: null, drawing: false, camera: null, say, marks };
  const box = el("div", { class: "record-picture" });
  drawStill(box, still, VIEW);
  return el("section", {}, el("h3", {}, word("picture")), box);
}

export function recordSheet(state: State, derived: Derived, shown: RecordShown, draw: Draw): HTMLElement {
  const signed: [string, string][] = [
    ["inspector", filled(state, shown.about, "inspector")],
    ["signature", ""],
  ];
  const sign = signed.map(([key, value]) => el("div", {}, el("dt", {}, word(key)), el("dd", {}, value)));
  const lines = shown.answers.reduce((sum, { figures }) => sum + Math.max(1, figures.length), 0);
  return el(
    "section",
    { class: lines > ONE_SHEET ? "record-sheet" : "record-sheet one" },
    el("h2", {}, word("title")),
    titles(state, shown),
    table(shown),
    el("p", {}, say(shown.ending)),
    picture(state, derived, shown, draw),
    ...shown.about.worth.map(one => el("p", { class: "record-worth" }, say(one))),
    el("dl", { class: "record-titles" }, ...sign),
  );
}
