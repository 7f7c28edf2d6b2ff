// The measurements of a whole program: a row each, by line or with the worst first. The row, its line in the program
// and its step in the 3D view are one selection. Only the rows in sight exist.

import { html, nothing, render, svg, type TemplateResult } from "lit-html";
import type { Actions } from "../desk/actions";
import { lineIn, shortLine } from "../desk/beside";
import type { Derived } from "../desk/derive";
import { el, on, setAttribute, setText, show } from "../dom";
import { guideButton } from "../guide";
import { type IconName, icon, iconPart } from "../icons";
import { type Command, meantBy } from "../keys";
import { fileOf, saveFile } from "../state/files";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { language, listed, say, t } from "../texts";
import type { Certain, RunRecord, RunView } from "../wire";
import { amount, correctedText, mainFigures } from "./amounts";
import { VERDICT_ICONS } from "./answer";
import { provenOf } from "./certain";
import { csv } from "./csv";
import { createProtocol, type ProtocolWays } from "./protocol";
import { type RecordShown, recordOf, recordText } from "./record";
import { createTitles } from "./record-titles";
import { type CertainWays, createWholeCertain, spreadOf, type WholeCertain } from "./whole-certain";

type Row = RunView["answers"][number];
const BEYOND = 6; // rows drawn above and below what is in sight
const WORST: Row["verdict"][] = ["alarm", "stopped", "scrap", "rework", "beyond", "measured", "within"];
/** What is counted under the title; `always`: also where there is none. */
const COUNTED: { key: string; verdicts: (Row["verdict"] | "missing")[]; always: boolean }[] = [
  { key: "whole-count-within", verdicts: ["within"], always: true },
  { key: "whole-count-beyond", verdicts: ["beyond", "rework", "scrap"], always: true },
  { key: "whole-count-measured", verdicts: ["measured"], always: false },
  { key: "whole-count-missing", verdicts: ["missing"], always: false },
  { key: "whole-count-stopped", verdicts: ["stopped"], always: false },
  { key: "whole-count-alarm", verdicts: ["alarm"], always: true },
];
const COLUMNS = [
  "number",
  "feature",
  "line",
  "nominal",
  "actual",
  "limits",
  "deviation",
  "verdict",
  "corrects",
  "probe",
] as const;
type Column = (typeof COLUMNS)[number];

/** As what a row counts: a call of which a protocol says nothing was not measured. */
const countedAs = ({ verdict, figures }: Row): Row["verdict"] | "missing" =>
  verdict === "measured" && figures.length === 0 ? "missing" : verdict;

/** The share of its limit that the deviation takes which decides; null: nothing limits it. */
function used({ figures }: Row): number | null {
  const shares = figures.flatMap(one => one.limits?.used ?? []);
  return shares.length ? Math.max(...shares) : null;
}

/** What is limited comes by its share, all else by its deviation, behind it. */
const share = (row: Row): number => used(row) ?? Math.abs(row.figures[0]?.deviation ?? 0) * 1e-9;

/** What a column is sorted by. */
const SORTED: Record<Column, (row: Row, index: number) => number | string> = {
  number: (_, index) => index,
  feature: row => say(row.feature),
  line: row => row.line ?? 0,
  nominal: row => row.figures[0]?.set ?? -Infinity,
  actual: row => row.figures[0]?.actual ?? -Infinity,
  limits: row => -share(row),
  deviation: row => -Math.abs(row.figures[0]?.deviation ?? 0),
  verdict: row => WORST.indexOf(row.verdict) - share(row) * 1e-3,
  corrects: row => correctedText(row),
  probe: ({ probe }) => Number(probe.tool) * 1e6 + probe.number + (probe.state === "differs" ? 0 : 0.5),
};

function sorted(rows: Row[], column: Column, down: boolean): number[] {
  const keys = rows.map((row, index) => SORTED[column](row, index));
  const order = [...rows.keys()].sort((a, b) => {
    const [one, other] = [keys[a] ?? 0, keys[b] ?? 0];
    const by = typeof one === "string" ? one.localeCompare(String(other), language()) : one - Number(other);
    return by || a - b;
  });
  return down ? order.reverse() : order;
}

/** A deviation from the middle within its limits, and how certain it is; the table says both in figures beside it. */
function bar({ gauge }: Row, certain: Certain | undefined): TemplateResult | string {
  if (!gauge) return "";
  const at = (value: number): number => {
    const part = (value - gauge.low) / (gauge.high - gauge.low);
    return 2 + Math.min(1, Math.max(0, part)) * 92;
  };
  const good = gauge.bands.filter(one => one.kind !== "bad");
  const [from, to] = [at(good[0]?.from ?? gauge.low), at(good[good.length - 1]?.to ?? gauge.high)];
  const band = (value: number, by: number): string => `M${at(value - by)} 8H${at(value + by)}`;
  return html`<svg class="gauge deviation-bar" viewBox="0 0 96 16" aria-hidden="true">
    <rect class="band band-good" x=${from} y="4" width=${to - from} height="8"></rect>
    <line class="mark" x1=${at(0)} x2=${at(0)} y1="2" y2="14"></line>
    ${gauge.needles.map(
      one => svg`<g class=${`needle needle-${one.kind}`}>
        ${certain ? svg`<path class="needle-certain" d=${band(one.value, certain.expanded)}></path>` : nothing}
        <path d=${`M${at(0)} 8H${at(one.value)}`}></path><circle cx=${at(one.value)} cy="8" r="3"></circle>
      </g>`,
    )}
  </svg>`;
}

/** The bar with its limits and the share of them below it. */
function limited(row: Row, certain: Certain | undefined): TemplateResult | string {
  const limits = row.figures.find(one => one.limits)?.limits;
  const unit = row.gauge?.unit ?? "";
  if (!limits) return "";
  const [low, high] = [limits.low, limits.high].map(one => amount(one, unit, true));
  const part = used(row);
  const told = part === null ? "" : t("whole-used", { share: Math.round(part * 100) });
  const between = t("whole-between", { low: low ?? "", high: high ?? "" });
  return html`${bar(row, certain)}<span class="limits-text" title=${between}
      >${limits.low === -limits.high ? `±${amount(limits.high, unit)}` : `${low} ${high}`}<b>${told}</b></span
    >`;
}

/** Whence the calibration of a probe. */
const CALIBRATED: Record<Row["probe"]["state"], IconName> = {
  calibrates: "gauge",
  run: "check",
  stored: "history",
  differs: "warning",
};

const lines = (texts: string[]): TemplateResult[] => texts.map(text => html`<span>${text}</span>`);

/** `certain`: of what was simulated; only of that it is known what was corrected. */
function cells(
  row: Row,
  index: number,
  files: RunView["files"],
  certain: WholeCertain | null,
): Record<Column, unknown> {
  const main = mainFigures(row);
  const proof = certain?.proof(index);
  const why = [say(row.why), proof ? provenOf(proof) : ""].filter(Boolean).join(" ");
  const off = main.map(one => (one.deviation === undefined ? "–" : amount(one.deviation, one.unit, true)));
  const size = (value: number | undefined, unit: string): string =>
    value === undefined ? "–" : `${amount(value, unit)}${unit === "deg" ? "°" : ""}`;
  return {
    number: index + 1,
    feature: say(row.feature),
    line: row.line === undefined ? "–" : shortLine(files, row.line),
    nominal: lines(main.map(one => size(one.set, one.unit))),
    actual: lines(
      main.length
        ? main.map(one => `${one.symbol} ${size(one.actual, one.unit)}${spreadOf(certain?.of(index, one.name))}`.trim())
        : ["–"],
    ),
    limits: limited(row, proof),
    deviation: lines(off.length ? off : ["–"]),
    verdict: html`<span class="verdict" data-verdict=${row.verdict} data-proof=${proof?.proof ?? nothing} title=${why}
      >${iconPart(proof?.proof === "undecided" ? "help" : VERDICT_ICONS[row.verdict])}${say(row.verdict_words)}</span
    >`,
    corrects: certain ? correctedText(row) || t("bar-nothing") : "–",
    probe: html`<span class="probe" data-state=${row.probe.state} title=${say(row.probe.name)}
      >${row.probe.number}${iconPart(CALIBRATED[row.probe.state])}<span class="visually-hidden"
        >${say(row.probe.calibration)}</span
      ></span>`,
  };
}

/** Of one selection: the call in which the step is. */
function indexAt(rows: Row[], step: number): number {
  return rows.findLastIndex(one => one.from <= step);
}

/** The word on a button, which a narrow panel leaves to the icon; a long one sooner. */
const label = (text: string, long = ""): HTMLElement => el("span", { class: `whole-label ${long}` }, text);

/** What the table needs of the page. */
export interface WholeWays extends ProtocolWays, CertainWays {
  paper(which: "record", shown: RecordShown): void;
  series(): void;
}

export function createWhole(
  store: Store,
  actions: Pick<Actions, "cursor">,
  goToLine: (line: number) => void,
  ways: WholeWays,
): { root: HTMLElement; draw(state: State, derived: Derived): void } {
  const counts = el("p", { class: "whole-counts" });
  const worst = el("button", { type: "button" }, t("whole-worst"));
  const saving = (way: "csv" | "json"): HTMLButtonElement =>
    el("button", { type: "button", title: t(`whole-${way}-hint`) }, icon("download"), t(`whole-${way}`));
  const [asTable, asDocument] = [saving("csv"), saving("json")];
  const onPaper = el(
    "button",
    { type: "button", title: t("whole-print-hint") },
    icon("print"),
    label(t("whole-print"), "long"),
  );
  const head = el("div", { class: "whole-head", role: "row" });
  const space = el("div", { class: "whole-space", role: "rowgroup" });
  const table = el(
    "div",
    { class: "whole-table", role: "grid", tabindex: "0", "aria-label": t("whole-title") },
    el("div", { role: "rowgroup", class: "whole-heads" }, head),
    space,
  );
  const error = el("p", { class: "whole-error", role: "note" });
  const real = el(
    "button",
    { type: "button", title: t("protocol-open-hint") },
    icon("open"),
    label(t("protocol-open"), "long"),
  );
  const series = el("button", { type: "button", title: t("runs-open-hint") }, icon("dice"), label(t("runs-open")));
  const certain = createWholeCertain(
    ways,
    () => rows(),
    () => {
      drawRows();
      store.update({}); // the line of the answer tells it too
    },
  );
  const buttons = [worst, asTable, asDocument, certain.button, series, onPaper, real, guideButton("record")];
  const top = el("div", { class: "whole-top" }, el("h3", {}, t("whole-title")), counts, ...buttons);
  const root = el("section", { class: "whole" }, top);

  let run: RunView | null = null;
  let calls: Derived["read"]["calls"] = [];
  let order: number[] = [];
  let column: Column = "number";
  let down = false;
  let current = 0; // place in the order
  let step = -1;
  let line = -1;
  let spoken = "";
  let file = "";
  const name = (): string => (file || "program").replace(/\.[^.]*$/, "");

  const protocol = createProtocol(ways, () => {
    arrange();
    store.update({});
  });
  const titles = createTitles(store);
  root.append(protocol.root, error, certain.status, table, titles.root);
  /** What was measured on the real machine, else what was simulated. */
  const shown = (): RecordShown | null => run && (protocol.view ? { ...protocol.view, files: run.files } : run);
  const rows = (): Row[] => shown()?.answers ?? [];
  const height = (): number => parseFloat(getComputedStyle(table).getPropertyValue("--row")) || 36;
  const above = (): number => head.offsetHeight;
  const chosen = (): number => indexAt(rows(), step);

  const drawHead = (): void => {
    render(
      COLUMNS.map(
        one => html`<span role="columnheader" class=${`cell cell-${one}`}
          aria-sort=${one === column ? (down ? "descending" : "ascending") : "none"}
          ><button type="button" tabindex="-1" data-column=${one} aria-label=${t(`whole-${one}-name`)}
            >${t(`whole-${one}`)}${one === column ? iconPart(down ? "up" : "down") : ""}</button
          ></span>`,
      ),
      head,
    );
  };

  function drawRows(): void {
    root.toggleAttribute("data-certain", certain.known()); // rows may be taller then
    const all = rows();
    const tall = height();
    const selected = chosen();
    const first = Math.max(0, Math.floor((table.scrollTop - above()) / tall) - BEYOND);
    const last = Math.min(all.length, Math.ceil((table.scrollTop + table.clientHeight) / tall) + BEYOND);
    space.style.height = `${all.length * tall}px`;
    setAttribute(table, "aria-rowcount", all.length + 1);
    const shown = order.slice(first, last).map((index, offset) => ({ index, place: first + offset }));
    render(
      shown.map(({ index, place }) => {
        const row = all[index];
        if (!row) return "";
        const of = cells(row, index, run?.files, protocol.view ? null : certain);
        return html`<div role="row" class=${place === current ? "whole-row current" : "whole-row"}
          id=${`whole-${index}`} data-place=${place} data-verdict=${row.verdict}
          aria-rowindex=${place + 2} aria-selected=${String(index === selected)}
          .style=${`top: ${place * tall}px`}
          >${COLUMNS.map(
            one =>
              html`<span role="gridcell" class=${`cell cell-${one}`} title=${one === "line" ? of[one] : nothing}
                >${of[one]}</span
              >`,
          )}</div>`;
      }),
      space,
    );
    certain.about(selected);
    const there = order[current];
    setAttribute(table, "aria-activedescendant", current >= first && current < last ? `whole-${there}` : null);
  }

  const bring = (place: number): void => {
    const tall = height();
    const top = place * tall;
    if (top < table.scrollTop) table.scrollTop = top;
    const bottom = top + tall + above();
    if (bottom > table.scrollTop + table.clientHeight) table.scrollTop = bottom - table.clientHeight;
  };
  const go = (place: number): void => {
    current = Math.max(0, Math.min(place, order.length - 1));
    bring(current);
    drawRows();
  };
  /** Its last step in the 3D view, its call in the form, and its line in the program where that stands beside. */
  const choose = (place: number): void => {
    const row = rows()[order[place] ?? -1];
    if (!row) return;
    store.update({ view: { step: row.to, playing: false } });
    const at = row.line;
    if (at === undefined || lineIn(run?.files, at).file !== undefined) return;
    line = at; // it comes back from the editor
    const call = calls.find(one => one.line <= at && at <= one.lastLine);
    if (call) actions.cursor(call.from, at);
    if (matchMedia("(min-width: 1200px)").matches) goToLine(at);
  };
  const sortBy = (next: Column, downwards: boolean): void => {
    const kept = order[current] ?? 0;
    [column, down] = [next, downwards];
    order = sorted(rows(), column, down);
    current = Math.max(0, next === "verdict" && !downwards ? 0 : order.indexOf(kept));
    drawHead();
    go(current);
  };

  on(worst, "click", () => sortBy("verdict", false));
  const record = (): RunRecord | null => {
    const made = shown();
    return made && recordOf(made, file);
  };
  const saves = (pieces: (made: RunRecord) => Promise<string[]>, ending: string, type: string) => (): void => {
    const made = record();
    if (made) void pieces(made).then(all => saveFile(new Blob(all), `${name()}.${ending}`, type));
  };
  const tableOf = async (made: RunRecord): Promise<string[]> => {
    const core = ways.core();
    return core ? csv(made, core) : [];
  };
  on(asTable, "click", saves(tableOf, "csv", "text/csv;charset=utf-8"));
  on(asDocument, "click", saves(recordText, "json", "application/json"));
  on(onPaper, "click", () => {
    const made = shown();
    if (made) ways.paper("record", made);
  });
  on(series, "click", ways.series);
  on(real, "click", protocol.pick);
  on(head, "click", event => {
    const next = (event.target as Element).closest<HTMLElement>("[data-column]")?.dataset.column as Column | undefined;
    if (next) sortBy(next, next === column && !down);
  });
  on(table, "scroll", drawRows);
  on(space, "click", event => {
    const place = (event.target as Element).closest<HTMLElement>("[data-place]")?.dataset.place;
    if (place === undefined) return;
    go(Number(place));
    choose(Number(place));
  });
  on(table, "keydown", event => {
    if (event.target !== table) return;
    const page = Math.max(1, Math.floor(table.clientHeight / height()) - 2);
    const moves: Partial<Record<Command<"list">, () => void>> = {
      next: () => go(current + 1),
      previous: () => go(current - 1),
      "next-page": () => go(current + page),
      "previous-page": () => go(current - page),
      first: () => go(0),
      last: () => go(Infinity),
      choose: () => choose(current),
    };
    const move = moves[meantBy(event, "list") ?? "leave"];
    if (!move) return;
    event.preventDefault();
    move();
  });
  new ResizeObserver(drawRows).observe(table);

  const count = (): string => {
    const parts = COUNTED.flatMap(({ key, verdicts, always }) => {
      const count = rows().filter(one => verdicts.includes(countedAs(one))).length;
      return count > 0 || always ? [t(key, { count })] : [];
    });
    return t("whole-counts", { all: rows().length, parts: listed(parts) });
  };
  const stopped = (): string => {
    const last = rows()[rows().length - 1];
    if (!run || run.finished || !last || (last.verdict !== "alarm" && last.verdict !== "stopped")) return "";
    const { cycle = "", line: at = 0 } = last;
    const { file, line } = lineIn(run.files, at);
    const told = { cycle, line, feature: say(last.feature), why: say(last.why) };
    return file === undefined ? t("whole-error", told) : t("whole-error-in-file", { ...told, file });
  };

  /** Other rows are shown. */
  function arrange(): void {
    // a run that comes anew while somebody moves through the same rows leaves them where they are
    const kept = document.activeElement === table && order.length === rows().length ? order[current] : undefined;
    order = sorted(rows(), column, down);
    current = Math.max(0, order.indexOf(kept ?? chosen()));
    setText(counts, count());
    setText(error, stopped());
    show(error, stopped() !== "");
    drawHead();
    bring(current);
    drawRows();
  }

  /** The selection follows the step; the step follows the cursor where that comes to a call. */
  const follow = (state: State, derived: Derived): void => {
    if (state.program.line !== line) {
      line = state.program.line;
      const found = rows().findLast(one => one.line === line);
      const inside = found && derived.step >= found.from && derived.step <= found.to;
      if (found && !inside && !state.view.playing)
        queueMicrotask(() => store.update({ view: { step: found.to, playing: false } }));
    }
    if (derived.step === step) return;
    const before = chosen();
    step = derived.step;
    if (chosen() === before) return;
    current = Math.max(0, order.indexOf(chosen()));
    bring(current);
    drawRows();
  };

  return {
    root,
    draw(state, derived) {
      const visible = state.view.source === "program" && (derived.run?.answers.length ?? 0) > 0;
      show(root, visible);
      if (!visible) return;
      calls = derived.read.calls;
      file = fileOf(state).name;
      const shownIn = language();
      protocol.draw(state, derived);
      titles.draw(state, derived.run?.about.machine ?? "");
      if (run !== derived.run || spoken !== shownIn) {
        if (run !== derived.run) certain.forget();
        run = derived.run;
        spoken = shownIn;
        step = derived.step;
        line = state.program.line;
        arrange();
      }
      follow(state, derived);
    },
  };
}
