// What a call came to, in one line that is always in sight: what was measured, what is corrected, where in its limits,
// and why.

import { html, nothing, render, type TemplateResult } from "lit-html";
import { guard } from "lit-html/directives/guard.js";
import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { el, setText } from "../dom";
import { type IconName, iconPart } from "../icons";
import type { State } from "../state/state";
import { listed, say, t } from "../texts";
import type { Answer, CertaintyView, Figure, Raised, RunView, WholeCertainty } from "../wire";
import { allParts, amount, correctedText, figureText, mainFigures, unitBehind } from "./amounts";
import { certainty } from "./certain";
import { gaugePicture } from "./gauge";
import { missing } from "./missing";
import { offersOf } from "./problem";

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
export function answerAt({ answers }: Pick<RunView, "answers">, step: number): RunView["answers"][number] | undefined {
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

/** What the machine measured: which file tells, since nobody knows what it corrected. */
const told = (file: string): TemplateResult =>
  html`<div class="answer-part"><span class="answer-name">${t("protocol-title")}</span><b>${file}</b></div>`;

function corrected(answer: Answer): TemplateResult {
  const none = answer.corrected.length === 0;
  const name = none
    ? t("bar-corrects")
    : t("bar-corrects-what", { what: listed(answer.corrected.map(one => say(one.target))) });
  const parts = allParts(answer).filter(Boolean).join("  ");
  return html`<div class="answer-part"><span class="answer-name">${name}</span
    ><b>${none ? t("bar-nothing") : parts || t("bar-new")}</b></div>`;
}

function body(answer: Answer, file: string, certain: CertaintyView | null): TemplateResult {
  const gauge = answer.gauge ? gaugePicture(answer.gauge) : nothing;
  return html`${measured(answer)}${file ? told(file) : corrected(answer)}
    <div class="answer-gauge" ?hidden=${!answer.gauge}>${gauge}</div>
    <div class="answer-why">
      <span class="verdict" data-verdict=${answer.verdict}
        >${iconPart(VERDICT_ICONS[answer.verdict])}${say(answer.verdict_words)}</span
      ><span class="why">${say(answer.why)}</span>
    </div>
    ${certain ? certainty(certain) : nothing}`;
}

/** What ended a call that measured nothing, or a program before its first measurement. */
const endedBy = (state: State, { run, view }: Derived): Raised | undefined =>
  state.view.source === "program" ? run?.alarms.findLast(({ stops }) => stops) : view.outcome?.alarms.at(-1);

const raisedText = ({ code, message }: Raised): string => [code, say(message)].filter(Boolean).join(" ");

/** Why there is no answer: what the form lacks, or the call measures nothing; then how it ended. */
function why(state: State, derived: Derived): string {
  if (state.view.source === "program") return derived.simulates === "yes" ? t("bar-none") : "";
  return derived.view.outcome ? t("bar-unmeasured") : missing(derived);
}

/** What ended it instead of an answer, with what the machine lacks. */
const ended = (raised: Raised, give: Actions["give"]): TemplateResult =>
  html`<span class="answer-none" data-stopped
    >${iconPart(VERDICT_ICONS.stopped)}<span>${raisedText(raised)}</span>${offersOf(raised, give)}</span
  >`;

/** In a sentence: for those who hear it. */
function spoken(answer: Answer, file: string): string {
  const figures = mainFigures(answer).map(one => {
    const off = one.deviation === undefined ? "" : ` (${amount(one.deviation, one.unit, true)})`;
    return `${figureText(one)}${off}`;
  });
  const simulated = correctedText(answer) || `${t("bar-corrects")} ${t("bar-nothing")}`;
  const changed = file ? t("protocol-of", { name: file }) : simulated;
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

/** What a protocol of the real machine tells of each call, and its name. */
export interface Real {
  answers: RunView["answers"];
  file: string;
}

/** How certain the measurements of a run are. */
export interface CertainRun {
  known: WholeCertainty;
  /** Those of the run that was asked about. */
  answers: RunView["answers"];
}

export interface AnswerLine {
  root: HTMLElement;
  /** With the whole program this stands under what its call came to; null: nothing is known. */
  setCertain(next: CertainRun | null): void;
  /** With the whole program this counts, not what was simulated; null: there is no protocol. */
  setReal(next: Real | null): void;
  draw(state: State, derived: Derived): void;
}

/** `give`: adds what the machine lacks. */
export function createAnswer(give: Actions["give"]): AnswerLine {
  const bar = el("div", { class: "answer-line" });
  const live = el("span", { class: "visually-hidden", role: "status", "aria-live": "polite" });
  const root = el("section", { class: "answer", "aria-label": t("bar-title") }, bar, live);
  const speak = afterRest(text => setText(live, text));
  let real: Real | null = null;
  let whole: CertainRun | null = null;
  let told: CertaintyView | null = null;
  /** Of the call of the whole program that is shown, where its run was asked about; the same for the same call. */
  const certainOf = (answer: Answer | undefined, { run }: Derived): CertaintyView | null => {
    const answers: readonly Answer[] = run && whole?.answers === run.answers ? run.answers : [];
    const figures = answer && whole?.known.calls[answers.indexOf(answer)]?.figures;
    if (!whole || !figures) return null;
    if (told?.figures !== figures) told = { runs: whole.known.runs, stopped: whole.known.stopped, figures };
    return told;
  };
  return {
    root,
    setCertain(next) {
      whole = next;
    },
    setReal(next) {
      real = next;
    },
    draw(state, derived) {
      const program = state.view.source === "program";
      const measured = program ? real : null;
      const answer = measured ? answerAt(measured, derived.step) : shownAnswer(state, derived);
      const file = measured?.file ?? "";
      const certain = program ? (measured ? null : certainOf(answer, derived)) : derived.certain;
      const line = (found: Answer): TemplateResult =>
        html`${guard([found, file, certain], () => body(found, file, certain))}`;
      if (answer) {
        render(line(answer), bar);
        return speak(spoken(answer, file));
      }
      const raised = endedBy(state, derived);
      render(raised ? ended(raised, give) : html`<span class="answer-none">${why(state, derived)}</span>`, bar);
      speak(raised ? raisedText(raised) : "");
    },
  };
}
