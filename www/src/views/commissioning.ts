// Commissioning and upgrade of measuring cycles as lists of steps: which are done is kept, and a list is printed.

import "../styles/exported.css";
import "../styles/terms.css";
import { html, nothing, render, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";
import type { ProgramCore } from "../core/program";
import { el, on } from "../dom";
import { guideButton } from "../guide";
import type { Store } from "../state/store";
import { helpWords, say, t } from "../texts";
import type { CommissioningPath, CommissioningStep, ConnectionView } from "../wire";
import { passingDialog, printBelow, showPassing } from "./passing";

const CONNECTIONS = "connections";
type Turn = (id: string, done: boolean) => void;

function line(key: string, text: string, code: boolean): TemplateResult | typeof nothing {
  return text ? html`<p><small>${t(key)}</small> ${code ? html`<code>${text}</code>` : text}</p>` : nothing;
}

function item(step: CommissioningStep, done: boolean, turn: Turn): TemplateResult {
  const { id, number, title, action, condition, check, softkeys, files, versions, source } = step;
  const turned = (event: Event): void => turn(id, (event.target as HTMLInputElement).checked);
  const name = `${number} ${say(title)}`.trim();
  return html`<li class="term">
    <label class="check"
      ><input type="checkbox" .checked=${live(done)} @change=${turned} /> <b>${name}</b></label
    >
    ${condition ? line("steps-if", say(condition), false) : nothing}
    <p>${say(action)}</p>
    ${check ? line("steps-check", say(check), false) : nothing} ${line("steps-softkeys", softkeys, true)}
    ${line("steps-files", files, true)} ${line("steps-versions", versions, false)}
    <small>${t("field-source", { source })}</small>
  </li>`;
}

function list({ steps }: CommissioningPath, done: Record<string, boolean>, turn: Turn): TemplateResult {
  const count = steps.filter(({ id }) => done[id]).length;
  return html`<p role="status">${t("steps-done", { done: count, all: steps.length })}</p>
    <ul class="commission-steps">
      ${steps.map(step => item(step, done[step.id] ?? false, turn))}
    </ul>`;
}

function cards(connections: ConnectionView[]): TemplateResult {
  const card = ({ signal, title, meaning, source }: ConnectionView): TemplateResult =>
    html`<div class="term">
      <dt>${say(title)} <code>${signal}</code></dt>
      <dd>
        <p>${say(meaning)}</p>
        <small>${t("field-source", { source })}</small>
      </dd>
    </div>`;
  return html`<dl>${connections.map(card)}</dl>`;
}

/** Opens the dialog. */
export async function openCommissioning(core: ProgramCore, store: Store, end: AbortSignal): Promise<void> {
  await helpWords();
  const { paths, connections } = core.commissioning();
  const ways = paths.map(({ id, title }) => el("option", { value: id }, say(title)));
  const way = el("select", { id: "steps-path" }, ...ways, el("option", { value: CONNECTIONS }, t("steps-connections")));
  const told = el("div", {});
  const printing = el("button", { type: "button" }, t("steps-print"));
  const again = el("button", { type: "button" }, t("steps-reset"));
  const closing = el("button", { type: "button", class: "primary" }, t("exported-close"));
  const body = [el("label", { for: way.id }, t("steps-path")), way, told];
  const dialog = passingDialog(
    "steps-title",
    t("steps-title"),
    body,
    [printing, again, closing],
    guideButton("commissioning"),
  );
  const shown = (): CommissioningPath | undefined => paths.find(({ id }) => id === way.value);
  const content = (): TemplateResult => {
    const path = shown();
    return path ? list(path, store.state.machine.steps, turn) : cards(connections);
  };
  const draw = (): void => {
    render(content(), told);
    again.disabled = !shown()?.steps.some(({ id }) => store.state.machine.steps[id]);
  };
  function turn(id: string, done: boolean): void {
    store.update({ machine: { steps: { ...store.state.machine.steps, [id]: done } } });
    draw();
  }
  on(way, "change", draw);
  on(printing, "click", () => {
    const body = el("div");
    render(content(), body);
    printBelow("exported", way.selectedOptions[0]?.textContent ?? "", body);
  });
  on(again, "click", () => {
    const own = new Set(shown()?.steps.map(({ id }) => id));
    const left = Object.entries(store.state.machine.steps).filter(([id]) => !own.has(id));
    store.update({ machine: { steps: Object.fromEntries(left) } });
    draw();
  });
  draw();
  showPassing(dialog, closing, end, () => {});
}
