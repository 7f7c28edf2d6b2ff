// The open program many times, with what varies: how often, from which seed, which values spread how. It runs in a
// worker of its own, which is stopped with the dialog. Nothing of it is kept.

import "../styles/series.css";
import { html, nothing, render } from "lit-html";
import { createAside } from "../core/aside";
import type { ProgramCore, SeriesQuestion } from "../core/program";
import { el, on, show } from "../dom";
import { parseNumber, plain } from "../numbers";
import { say, sayProblem, t } from "../texts";
import type { Mode, Per, Series, SeriesView, Shape, Vary } from "../wire";
import { resultOf } from "./series-result";

const SHAPES: Shape[] = ["normal", "uniform", "triangular", "arcsine"];
const MODES: Mode[] = ["production", "independent"];
const PERS: Per[] = ["part", "series"];
const MOST = 10_000; // runs that a page waits for
const LOOK = 250; // ms between two looks at how far it is

/** A variation as typed. */
interface Row {
  what: string;
  as: Shape;
  spread: string; // deviation of the normal distribution, half width of the others
  mean: string;
  drift: string;
  per: Per;
  follows: string; // `name=factor`, separated by commas
  values: number[];
}

const rowOf = (vary: Vary): Row => ({
  what: vary.what,
  as: vary.as ?? "normal",
  spread: plain((vary.as ?? "normal") === "normal" ? (vary.sigma ?? 0) : (vary.half ?? 0)),
  mean: plain(vary.mean ?? 0),
  drift: plain(vary.drift ?? 0),
  per: vary.per ?? "part",
  follows: Object.entries(vary.follows ?? {})
    .map(([name, factor]) => `${name}=${factor}`)
    .join("; "),
  values: vary.values ?? [],
});

const number = (text: string): number => {
  const value = text.trim() ? parseNumber(text) : 0;
  if (value === null) throw new Error(t("runs-no-number", { text }));
  return value;
};

/** Names with their factors. */
function followed(text: string): Record<string, number> {
  const pairs = text.split(";").filter(one => one.trim());
  return Object.fromEntries(
    pairs.map(pair => {
      const at = pair.lastIndexOf("=");
      return [pair.slice(0, Math.max(0, at)).trim(), number(pair.slice(at + 1))];
    }),
  );
}

const varyOf = ({ what, as, spread, mean, drift, per, follows, values }: Row): Vary => ({
  what: what.trim(),
  as,
  ...(as === "normal" ? { sigma: number(spread) } : { half: number(spread) }),
  mean: number(mean),
  drift: number(drift),
  per,
  follows: followed(follows),
  ...(values.length ? { values } : {}),
});

/** Prints what is shown (`paper.ts` clears it). */
function printResult(view: SeriesView): void {
  const body = el("div");
  render(resultOf(view), body);
  document.body.append(el("div", { class: "paper series-paper" }, el("h2", {}, t("runs-title")), body));
  document.documentElement.dataset.paper = "series";
  print();
}

/** Opens the dialog; `asked`: the program on the machine in use, as a question. It goes when it is closed. */
export function openSeries(core: ProgramCore, asked: SeriesQuestion, end: AbortSignal): void {
  const start = core.seriesStart(asked);
  let about = asked;
  let rows: Row[] = "why" in start ? [] : start.series.vary.map(rowOf);
  let view: SeriesView | null = null;
  let looking = 0;

  const fields = el("div", { class: "series-fields" });
  const problem = el("p", { class: "series-problem", role: "alert" }, "why" in start ? sayProblem(start.why) : "");
  const result = el("div", { class: "series-result" });
  const way = el("progress", { max: "1", value: "0", "aria-label": t("runs-progress"), hidden: true });
  const status = el("p", { class: "series-status", role: "status" });
  const running = el("button", { type: "button", class: "primary" }, t("runs-run"));
  const stopping = el("button", { type: "button", hidden: true }, t("runs-stop"));
  const example = el("button", { type: "button", title: t("runs-example-hint") }, t("runs-example"));
  const printing = el("button", { type: "button", disabled: true }, t("runs-print"));
  const closing = el("button", { type: "button" }, t("runs-close"));
  const help = el("details", { class: "series-help" });
  const text = el("details", { class: "series-program", hidden: true });
  const dialog = el(
    "dialog",
    { class: "series", "aria-labelledby": "series-title" },
    el("header", {}, el("h2", { id: "series-title" }, t("runs-title"))),
    el(
      "div",
      { class: "series-body scroll", tabindex: "0", role: "region", "aria-labelledby": "series-title" },
      el("p", {}, t("runs-intro")),
      fields,
      help,
      text,
      problem,
      way,
      status,
      result,
    ),
    el("div", { class: "actions" }, running, stopping, example, printing, closing),
  );
  const series = "why" in start ? null : start.series;
  const given = { runs: String(series?.runs ?? 100), seed: String(series?.seed ?? 1), mode: series?.mode ?? MODES[0] };

  const input = (id: string, value: string, take: (value: string) => void, list = false) =>
    html`<input id=${id} .value=${value} autocomplete="off" list=${list ? "series-names" : nothing}
      @input=${(event: Event) => take((event.target as HTMLInputElement).value)} />`;
  const choice = <T extends string>(id: string, all: readonly T[], value: T | undefined, take: (value: T) => void) =>
    html`<select id=${id} @change=${(event: Event) => take((event.target as HTMLSelectElement).value as T)}>
      ${all.map(one => html`<option value=${one} .selected=${one === value}>${t(`runs-${one}`)}</option>`)}
    </select>`;
  const field = (id: string, label: string, control: unknown) =>
    html`<div class="series-field"><label for=${id}>${label}</label>${control}</div>`;

  const rowShown = (row: Row, at: number) => {
    const id = (name: string): string => `series-${name}-${at}`;
    const put = (name: "what" | "spread" | "mean" | "drift" | "follows") => (value: string) => {
      row[name] = value;
    };
    const listed = row.values.map(one => plain(one)).join(" ");
    return html`<fieldset class="series-vary">
      <legend>${t("runs-vary", { number: at + 1 })}</legend>
      ${field(id("what"), t("runs-what"), input(id("what"), row.what, put("what"), true))}
      ${field(
        id("as"),
        t("runs-as"),
        choice(id("as"), SHAPES, row.as, value => {
          row.as = value;
          draw();
        }),
      )}
      ${field(
        id("spread"),
        t(row.as === "normal" ? "runs-sigma" : "runs-half"),
        input(id("spread"), row.spread, put("spread")),
      )}
      ${field(id("mean"), t("runs-offset"), input(id("mean"), row.mean, put("mean")))}
      ${field(id("drift"), t("runs-drift"), input(id("drift"), row.drift, put("drift")))}
      ${field(
        id("per"),
        t("runs-per"),
        choice(id("per"), PERS, row.per, value => {
          row.per = value;
        }),
      )}
      ${field(id("follows"), t("runs-follows"), input(id("follows"), row.follows, put("follows")))}
      ${listed ? html`<p>${t("runs-values", { values: listed })}</p>` : nothing}
      <button type="button" @click=${() => change(() => rows.splice(at, 1))}>${t("runs-remove")}</button>
    </fieldset>`;
  };
  const change = (by: () => void): void => {
    by();
    draw();
  };
  function draw(): void {
    const names = "why" in start ? [] : start.names;
    render(
      html`<div class="series-row">
          ${field(
            "series-runs",
            t("runs-count"),
            input("series-runs", given.runs, value => (given.runs = value)),
          )}
          ${field(
            "series-seed",
            t("runs-seed"),
            input("series-seed", given.seed, value => (given.seed = value)),
          )}
          ${field(
            "series-mode",
            t("runs-mode"),
            choice("series-mode", MODES, given.mode, value => (given.mode = value)),
          )}
        </div>
        <datalist id="series-names">${names.map(name => html`<option value=${name}></option>`)}</datalist>
        ${rows.map(rowShown)}
        <button type="button" @click=${() => change(() => rows.push(rowOf({ what: names[0] ?? "" })))}
          >${t("runs-add")}</button>`,
      fields,
    );
  }

  const aside = createAside(() => core.module, take);
  /** Another question or none: what was running is over. */
  const over = (): void => {
    clearInterval(looking);
    show(way, false);
    show(stopping, false);
    show(running, true);
  };
  function take(): void {
    const answered = aside.take();
    if (!answered) return;
    over();
    status.textContent = "";
    view = answered.json === undefined ? null : (JSON.parse(answered.json) as SeriesView);
    problem.textContent = answered.problem === undefined ? "" : sayProblem(answered.problem);
    printing.disabled = !view;
    render(view ? resultOf(view) : nothing, result);
    if (view) status.textContent = t("runs-done", { runs: view.runs });
  }
  const asks = (): Series => {
    const runs = number(given.runs);
    if (!(runs >= 1 && runs <= MOST)) throw new Error(t("runs-range", { most: MOST }));
    const seed = Math.max(0, Math.trunc(number(given.seed)));
    return { runs: Math.trunc(runs), seed, mode: given.mode ?? "production", vary: rows.map(varyOf) };
  };
  const run = (): void => {
    problem.textContent = "";
    let series: Series;
    try {
      series = asks();
    } catch (wrong) {
      problem.textContent = wrong instanceof Error ? wrong.message : String(wrong);
      return;
    }
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
  on(running, "click", run);
  on(stopping, "click", () => {
    aside.stop();
    over();
    status.textContent = t("runs-stopped");
    running.focus();
  });
  on(example, "click", () => {
    if ("why" in start) return;
    const { control, text: program, series } = start.example;
    about = { control, text: program, example: true };
    rows = series.vary.map(rowOf);
    [given.runs, given.seed, given.mode] = [String(series.runs), String(series.seed), series.mode];
    show(text, true);
    text.replaceChildren(el("summary", {}, t("runs-program")), el("pre", {}, program));
    draw();
    run();
  });
  on(printing, "click", () => view && printResult(view));
  on(closing, "click", () => dialog.close());
  on(dialog, "close", () => {
    aside.stop();
    clearInterval(looking);
    dialog.remove();
  });
  end.addEventListener("abort", () => {
    aside.stop();
    dialog.remove();
  });
  const paragraphs = "why" in start ? [] : start.help.map(one => el("p", {}, say(one)));
  help.append(el("summary", {}, t("runs-choose")), ...paragraphs);
  running.disabled = !asked.text.trim() || "why" in start;
  if (!asked.text.trim()) status.textContent = t("runs-no-program");
  on(example, "click", () => {
    running.disabled = false;
  });
  draw();
  document.body.append(dialog);
  dialog.showModal();
}
