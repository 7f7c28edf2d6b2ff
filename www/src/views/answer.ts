// What a call came to, in one line that is always in sight: what was measured, what is corrected, where in its limits,
// and why.

import { html, nothing, render, type TemplateResult } from "lit-html";
import { guard } from "lit-html/directives/guard.js";
import type { Derived } from "../desk/derive";
import { el, setText } from "../dom";
import { type IconName, iconPart } from "../icons";
import type { State } from "../state/state";
import { listed, say, t } from "../texts";
import type { Answer, CertaintyView, Figure, RunView } from "../wire";
import { amount, correctedText, figureText, mainFigures, partsText, unitBehind } from "./amounts";
import { certainty } from "./certain";
import { gaugePicture } from "./gauge";

const REST = 500; // ms without a change, then it is spoken

/** Icon of each verdict; its colour is in the style sheet, its words beside it. */
export const VERDICT_ICONS: Record<Answer["verdict"], IconName> = {
  within: "good",
  beyond: "error",
  rework: "warning",
  scrap: "error",
  alarm: "alert",
  stopped: "alert",
  measured: "info",
};

/** The call of a run in which this step is, else the last one before it. */
export function answerAt({ answers }: RunView, step: number): RunView["answers"][number] | undefined {
  return answers.findLast(one => one.from <= step) ?? answers[0];
}

/** Of the form's call, or of the call at the present step while the whole program is shown. */
export function shownAnswer(state: State, derived: Derived): Answer | undefined {
  if (state.view.source !== "program") return derived.view.outcome?.answer;
  return derived.run ? answerAt(derived.run, derived.step) : undefined;
}

function figure(one: Figure): TemplateResult {
  const off = one.deviation === undefined ? "" : amount(one.deviation, one.unit, true);
  const behind = off ? html` <span class="off">${off}</span>` : nothing;
  return html`<b title=${say(one.label)}>${figureText(one)}</b>${behind}`;
}

function measured(answer: Answer): TemplateResult {
  const figures = mainFigures(answer);
  const first = figures[0];
  if (!first)
    return html`<div class="answer-part"><span class="answer-name">${say(answer.feature)}</span><b>–</b></div>`;
  const name = `${say(first.heading)}${first.unit === "deg" ? "" : `,${unitBehind(first.unit)}`}`;
  return html`<div class="answer-part"><span class="answer-name">${name}</span
    ><span class="answer-figures">${figures.map(one => html`<span>${figure(one)}</span> `)}</span></div>`;
}

function corrected(answer: Answer): TemplateResult {
  const none = answer.corrected.length === 0;
  const name = none
    ? t("bar-corrects")
    : t("bar-corrects-what", { what: listed(answer.corrected.map(one => say(one.target))) });
  const parts = answer.corrected.map(partsText).filter(Boolean).join("  ");
  return html`<div class="answer-part"><span class="answer-name">${name}</span
    ><b>${none ? t("bar-nothing") : parts || t("bar-new")}</b></div>`;
}

function body(answer: Answer, certain: CertaintyView | null): TemplateResult {
  const gauge = answer.gauge ? gaugePicture(answer.gauge) : nothing;
  return html`${measured(answer)}${corrected(answer)}
    <div class="answer-gauge" ?hidden=${!answer.gauge}>${gauge}</div>
    <div class="answer-why">
      <span class="verdict" data-verdict=${answer.verdict}
        >${iconPart(VERDICT_ICONS[answer.verdict])}${say(answer.verdict_words)}</span
      ><span class="why">${say(answer.why)}</span>
    </div>
    ${certain ? certainty(certain) : nothing}`;
}

/** In a sentence: for those who hear it. */
function spoken(answer: Answer): string {
  const figures = mainFigures(answer).map(one => {
    const off = one.deviation === undefined ? "" : ` (${amount(one.deviation, one.unit, true)})`;
    return `${figureText(one)}${off}`;
  });
  const changed = correctedText(answer) || `${t("bar-corrects")} ${t("bar-nothing")}`;
  return [figures.join(" "), changed, say(answer.verdict_words), say(answer.why)].filter(Boolean).join(" · ");
}

/** Calls at most once within the rest, with what was said last. */
function afterRest(speak: (text: string) => void): (text: string) => void {
  let timer = 0;
  let last = "";
  return text => {
    if (text === last) return;
    last = text;
    clearTimeout(timer);
    timer = window.setTimeout(() => speak(text), REST);
  };
}

export function createAnswer(): { root: HTMLElement; draw(state: State, derived: Derived): void } {
  const bar = el("div", { class: "answer-line" });
  const live = el("span", { class: "visually-hidden", role: "status", "aria-live": "polite" });
  const root = el("section", { class: "answer", "aria-label": t("bar-title") }, bar, live);
  const speak = afterRest(text => setText(live, text));
  return {
    root,
    draw(state, derived) {
      const answer = shownAnswer(state, derived);
      const certain = state.view.source === "program" ? null : derived.certain;
      const none = derived.simulates === "yes" ? t("bar-none") : "";
      render(
        answer ? guard([answer, certain], () => body(answer, certain)) : html`<span class="answer-none">${none}</span>`,
        bar,
      );
      speak(answer ? spoken(answer) : "");
    },
  };
}
