// What a series came to: for each call its charts, shares with and without correction, capability, and the table of its
// parts; behind them the alarms.

import { html, nothing, type TemplateResult } from "lit-html";
import { fixed } from "../numbers";
import { say, t } from "../texts";
import type { SeriesCall, SeriesCorrection, SeriesFigure, SeriesShare, SeriesView } from "../wire";
import { amount, unitBehind } from "./amounts";
import { chart, type Line } from "./series-chart";

const SAME = 1e-9; // what does not vary needs no chart

/** How many parts of a series came to the end. */
export const endingOf = ({ runs, finished, seed }: SeriesView): string => t("runs-ending", { runs, finished, seed });

const whole = (value: number): string => fixed(value, 2);
const nameOf = ({ target, part }: SeriesCorrection): string => `${say(target)} ${part}`.trim();

/** What the tool has from its corrections after each part; where each part begins anew, what that part brings. */
function course({ course }: SeriesCorrection, adds: boolean): number[] {
  let sum = 0;
  return course.map(by => {
    sum = adds ? sum + by : by;
    return sum;
  });
}

/** The quantity with what limits it; the memories are drawn from the setpoint on. */
function linesOf({ course, set, limits }: SeriesFigure, { memories = [] }: SeriesCall, main: boolean): Line[] {
  const lines: Line[] = [{ kind: "actual", name: t("runs-actual"), values: course }];
  if (set === undefined) return lines;
  lines.push({ kind: "set", name: t("runs-set"), values: set });
  for (const limit of limits ?? []) lines.push({ kind: "limit", name: t("runs-limit"), values: set + limit });
  if (!main) return lines;
  for (const { name, mean, course: values } of memories)
    lines.push({
      kind: mean ? "mean" : "empirical",
      name: t(mean ? "runs-mean" : "runs-empirical", { name }),
      values: values.map(value => set + value),
    });
  return lines;
}

function shares(title: string, all: readonly SeriesShare[]): TemplateResult | typeof nothing {
  if (!all.length) return nothing;
  return html`<div class="series-shares">
    <h4>${title}</h4>
    <ul>${all.map(
      ({ verdict, words, told }) => html`<li data-verdict=${verdict}>${say(words)}: ${say(told)}</li>`,
    )}</ul>
  </div>`;
}

function figureOf(figure: SeriesFigure, call: SeriesCall, main: boolean, runs: number, width: number): TemplateResult {
  const { unit, mean, deviation, min, max, capability } = figure;
  const told = t("runs-spread", {
    mean: amount(mean, unit),
    deviation: amount(deviation, unit),
    min: amount(min, unit),
    max: `${amount(max, unit)}${unitBehind(unit)}`,
  });
  const [cp, cpk] = capability ? [capability.cpInterval, capability.cpkInterval] : [];
  const flat = !main && max - min < SAME;
  return html`${
    flat
      ? html`<h4>${say(figure.label)}</h4>`
      : chart(
          main ? weighted(say(figure.label), call) : say(figure.label),
          t("runs-parts"),
          linesOf(figure, call, main),
          runs,
          unit,
          width,
        )
  }
    <p>${told}</p>
    ${
      capability && cp && cpk
        ? html`<p>${t("runs-capability", {
            cp: whole(capability.cp),
            cpLow: whole(cp[0]),
            cpHigh: whole(cp[1]),
            cpk: whole(capability.cpk),
            cpkLow: whole(cpk[0]),
            cpkHigh: whole(cpk[1]),
          })}</p>`
        : nothing
    }`;
}

/** The first parts in figures, a row each. */
function tableOf({ measured, corrected, memories = [] }: SeriesCall, adds: boolean, title: string): TemplateResult {
  const columns = [
    ...measured.map(({ label, unit, course }) => ({ head: say(label), unit, values: course })),
    ...corrected.map(one => ({ head: nameOf(one), unit: one.unit, values: course(one, adds) })),
    ...memories.map(({ name, unit, course }) => ({ head: name, unit, values: course })),
  ];
  const rows = Math.max(0, ...columns.map(({ values }) => values.length));
  const cell = (value: number | null | undefined, unit: string): string => (value == null ? "–" : amount(value, unit));
  return html`<div class="series-table scroll" tabindex="0" role="region" aria-label=${title}>
    <table>
      <caption>${title}</caption>
      <thead><tr><th scope="col">${t("runs-part")}</th>
        ${columns.map(({ head, unit }) => html`<th scope="col">${head}${unitBehind(unit)}</th>`)}</tr></thead>
      <tbody>${Array.from(
        { length: rows },
        (_, part) => html`<tr><th scope="row" data-label=${t("runs-part")}>${part + 1}</th>
          ${columns.map(
            ({ head, unit, values }) =>
              html`<td data-label=${head + unitBehind(unit)}>${cell(values[part], unit)}</td>`,
          )}</tr>`,
      )}</tbody>
    </table>
  </div>`;
}

/** With the weight of the mean value, by which two charts of the same parts differ. */
const weighted = (named: string, { weight }: SeriesCall): string =>
  weight ? t("runs-weight", { named, name: weight.name, value: weight.value }) : named;

function callOf(call: SeriesCall, { runs, mode }: SeriesView, width: number): TemplateResult {
  const adds = mode === "production";
  const { line, cycle, feature, measured, corrected, verdicts, uncorrected = [] } = call;
  const shown = measured.slice(0, 1)[0]?.course.length ?? runs;
  const named = t("runs-call", { line: line ?? 0, cycle: cycle ?? "", feature: say(feature) });
  const title = weighted(named, call);
  return html`<section class="series-call">
    <h3>${title}</h3>
    ${shown < runs ? html`<p>${t("runs-first", { count: shown })}</p>` : nothing}
    ${measured.map((figure, at) => figureOf(figure, call, at === 0, shown, width))}
    ${corrected.map(one => {
      const name = t(adds ? "runs-correction-sum" : "runs-correction", { name: nameOf(one) });
      const line: Line = { kind: "correction", name: nameOf(one), values: course(one, adds) };
      return html`${chart(name, t("runs-parts"), [line], one.course.length, one.unit, width)}
        <p>${t("runs-corrected", { count: one.count })}</p>`;
    })}
    <div class="series-both">
      ${shares(t(uncorrected.length ? "runs-with" : "runs-shares"), verdicts)}
      ${shares(t("runs-without"), uncorrected)}
    </div>
    ${tableOf(call, adds, title)}
  </section>`;
}

/** All of it, in charts of this width, px. */
export function resultOf(view: SeriesView, width: number): TemplateResult {
  const { calls, alarms, more } = view;
  return html`${more ? html`<p>${say(more)}</p>` : nothing}
    ${calls.length ? calls.map(call => callOf(call, view, width)) : html`<p>${t("runs-no-call")}</p>`}
    ${
      alarms.length
        ? html`<section class="series-alarms"><h3>${t("runs-alarms")}</h3><ul>${alarms.map(
            ({ code, message, told }) => html`<li><b>${code}</b> ${say(message)} ${say(told)}</li>`,
          )}</ul></section>`
        : html`<p>${t("runs-no-alarm")}</p>`
    }`;
}
