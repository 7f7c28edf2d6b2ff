// The open program many times, with what varies: how often, from which seed, which values spread how. It runs in a
// worker of its own, which is stopped with the dialog. Nothing of it is kept.

import "../styles/series.css";
import { nothing, render } from "lit-html";
import { createAside } from "../core/aside";
import type { ProgramCore, SeriesQuestion } from "../core/program";
import { el, on, show } from "../dom";
import { guideButton } from "../guide";
import { say, sayProblem, t } from "../texts";
import type { Series, SeriesStart, SeriesView } from "../wire";
import { type Printed, printsWith, showPassing } from "./passing";
import { PAPER_WIDTH } from "./series-chart";
import { fieldsOf, type Offered, seriesOf, seriesProblem, type Typed, typedOf } from "./series-fields";
import { endingOf, resultOf } from "./series-result";

const LOOK = 250; // ms between two looks at how far it is
const NOTHING: Series = { runs: 100, seed: 1, mode: "production", vary: [] };

function printedOf(view: SeriesView): Printed {
  const body = el("div");
  render(resultOf(view, PAPER_WIDTH), body);
  return { paper: "series", title: t("runs-title"), parts: [el("p", {}, endingOf(view)), body] };
}

/** What the dialog shows, and its buttons. */
function build(start: SeriesStart | { why: string }) {
  const help = el("details", { class: "series-help", open: true }, el("summary", {}, t("runs-choose")));
  if (!("why" in start)) help.append(...start.help.map(one => el("p", {}, say(one))), guideButton("limits"));
  const parts = {
    fields: el("div", { class: "series-fields" }),
    problem: el("p", { class: "series-problem", role: "alert" }, "why" in start ? sayProblem(start.why) : ""),
    result: el("div", { class: "series-result" }),
    way: el("progress", { max: "1", value: "0", "aria-label": t("runs-progress"), hidden: true }),
    status: el("p", { class: "series-status", role: "status" }),
    running: el("button", { type: "button", class: "primary" }, t("runs-run")),
    stopping: el("button", { type: "button", hidden: true }, t("runs-stop")),
    example: el("button", { type: "button", title: t("runs-example-hint") }, t("runs-example")),
    printing: el("button", { type: "button", disabled: true }, t("runs-print")),
    closing: el("button", { type: "button" }, t("runs-close")),
    text: el("details", { class: "series-program", hidden: true }),
    help,
  };
  const { fields, problem, result, way, status, running, stopping, example, printing, closing, text } = parts;
  const asked = el(
    "div",
    { class: "series-asked scroll", tabindex: "0", role: "region", "aria-label": t("runs-asked") },
    el("p", {}, t("runs-intro")),
    fields,
    text,
  );
  const answered = el(
    "div",
    { class: "series-answered scroll", tabindex: "0", role: "region", "aria-label": t("runs-answered") },
    problem,
    way,
    status,
    result,
    help,
  );
  const dialog = el(
    "dialog",
    { class: "series", "aria-labelledby": "series-title" },
    el("header", {}, el("h2", { id: "series-title" }, t("runs-title")), guideButton("series")),
    el("div", { class: "series-body" }, asked, answered),
    el("div", { class: "actions" }, running, stopping, example, printing, closing),
  );
  return { ...parts, dialog };
}

/** Opens the dialog; `asked`: the program on the machine in use, as a question. It goes when it is closed. */
export function openSeries(core: ProgramCore, asked: SeriesQuestion, end: AbortSignal): void {
  const start = core.seriesStart(asked);
  const offered: Offered = "why" in start ? { names: [], follows: [], presets: [] } : start;
  const { names } = offered;
  const shown = build(start);
  const { dialog, fields, problem, result, way, status, running, stopping, text, help, printing } = shown;
  let about = asked;
  let typed: Typed = typedOf("why" in start ? NOTHING : start.series, names);
  let view: SeriesView | null = null;
  let looking = 0;
  let pressed = running; // by which it runs

  const draw = (): void => void render(fieldsOf(typed, offered, draw), fields);
  const drawResult = (): void => void render(view ? resultOf(view, result.clientWidth) : nothing, result);
  const aside = createAside(() => core.module, take);
  /** What was running is over. */
  const over = (): void => {
    clearInterval(looking);
    const held = stopping.matches(":focus");
    show(way, false);
    show(stopping, false);
    show(running, true);
    if (held) pressed.focus(); // the button that had the focus is gone
  };
  function take(): void {
    const answered = aside.take();
    if (!answered) return;
    const first = !view;
    over();
    view = answered.json === undefined ? null : (JSON.parse(answered.json) as SeriesView);
    problem.textContent = answered.problem === undefined ? "" : seriesProblem(answered.problem, typed, names);
    status.textContent = view ? endingOf(view) : "";
    printing.disabled = !view;
    if (first && view) help.open = false;
    drawResult();
  }
  const run = (by: HTMLButtonElement): void => {
    problem.textContent = "";
    let series: Series;
    try {
      series = seriesOf(typed);
    } catch (wrong) {
      problem.textContent = wrong instanceof Error ? wrong.message : String(wrong);
      return;
    }
    pressed = by;
    show(way, true);
    show(stopping, true);
    show(running, false);
    stopping.focus();
    way.value = 0;
    status.textContent = t("runs-running");
    aside.want({ ask: "series", ...about, series });
    clearInterval(looking);
    looking = window.setInterval(() => {
      way.value = aside.busy()?.share ?? 0;
    }, LOOK);
  };
  on(running, "click", () => run(running));
  on(stopping, "click", () => {
    aside.stop();
    over();
    status.textContent = t("runs-stopped");
  });
  on(shown.example, "click", () => {
    if ("why" in start) return;
    const { control, text: program, series } = start.example;
    about = { control, text: program, example: true };
    typed = typedOf(series, names);
    running.disabled = false;
    show(text, true);
    text.replaceChildren(el("summary", {}, t("runs-program")), el("pre", {}, program));
    draw();
    run(shown.example);
  });
  printsWith(dialog, printing, () => view && printedOf(view));
  const wider = new ResizeObserver(drawResult);
  running.disabled = !asked.text.trim() || "why" in start;
  if (!asked.text.trim()) status.textContent = t("runs-no-program");
  draw();
  showPassing(dialog, shown.closing, end, () => {
    aside.stop();
    wider.disconnect();
    clearInterval(looking);
  });
  wider.observe(result);
}
