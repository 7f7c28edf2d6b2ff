// A problem with its mark, number, cause and cure, wherever it is shown.

import { html, nothing, render, type TemplateResult } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import { glossPart } from "../glossary";
import { say, sayHint, t } from "../texts";
import type { Diagnostic, Offer } from "../wire";

const MARKS = { error: "✕", warning: "!", note: "i" };

type Told = Pick<Diagnostic, "severity" | "code" | "message" | "hint">;

/** `more`: what stands in its row beside what is said. */
export function problem(
  { severity, code, message, hint }: Told,
  more: TemplateResult | typeof nothing = nothing,
): TemplateResult {
  return html`<li class="problem" data-severity=${severity}>
    <span class="mark" aria-hidden="true">${MARKS[severity]}</span>
    <span class="problem-text">${`${t(`severity-${severity}`)}: ${say(message)}`}</span>
    <code class="problem-code">${code}</code>
    <span class="hint" ?hidden=${!hint}>${hint ? glossPart(sayHint({ message, hint })) : ""}</span>${more}
  </li>`;
}

/** What the machine lacks: a click gives it. */
export function offersOf({ offers = [] }: Pick<Diagnostic, "offers">, give: (offer: Offer) => void): TemplateResult[] {
  return offers.map(
    one => html`<button type="button" class="cure" @click=${() => give(one)}>${say(one.label)}</button>`,
  );
}

/** A list shows these, what is said twice once. What stays keeps its element: it is not read out again. */
export function listProblems(
  list: HTMLElement,
  all: readonly (Told & Pick<Diagnostic, "offers">)[],
  give?: (offer: Offer) => void,
): void {
  const once = new Map(all.map(one => [`${one.code}/${JSON.stringify(one.message)}`, one]));
  render(
    repeat(
      once,
      ([key]) => key,
      ([, one]) =>
        problem(one, give && one.offers ? html`<span class="problem-actions">${offersOf(one, give)}</span>` : nothing),
    ),
    list,
  );
}
