// Commissioning and upgrade of measuring cycles as lists of steps: which are done is kept, and a list is printed.

import "../styles/exported.css";
import "../styles/terms.css";
import { html, nothing, render, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";
import type { ProgramCore } from "../core/program";
import { el, on, setOff } from "../dom";
import { guideButton } from "../guide";
import type { Store } from "../state/store";
import { helpWords, say, sayProblem, t } from "../texts";
import type {
  CommissioningPath,
  CommissioningStep,
  CompatibilityRow,
  CompatibilityView,
  ConnectionView,
  Machine,
} from "../wire";
import { passingDialog, printsWith, showPassing } from "./passing";

const CONNECTIONS = "connections";
const VERSIONS = "versions";
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
    html`<div class="term" id=${title.key} tabindex="-1">
      <dt>${say(title)} ${signal ? html`<code>${signal}</code>` : nothing}</dt>
      <dd>
        <p>${say(meaning)}</p>
        <small>${t("field-source", { source })}</small>
      </dd>
    </div>`;
  return html`<dl>${connections.map(card)}</dl>`;
}

/** Which versions work together; the rows of the machine are marked. */
function versions(view: CompatibilityView | { why: string }): TemplateResult {
  if ("why" in view) return html`<p>${sayProblem(view.why)}</p>`;
  const heads = [t("compatibility-component"), t("compatibility-version"), ...view.functions.map(say)];
  const row = ({ component, version, works, here }: CompatibilityRow): TemplateResult =>
    html`<tr class=${here ? "here" : ""} aria-current=${here ? "true" : nothing}>
      <th scope="row">${component}</th>
      <td>${version}</td>
      ${works.map(one => html`<td>${say(one)}</td>`)}
    </tr>`;
  return html`<p>${say(view.told)}</p>
    <div class="versions" tabindex="0" role="region" aria-label=${t("steps-versions-title")}>
      <table>
        <thead>
          <tr>
            ${heads.map(head => html`<th scope="col">${head}</th>`)}
          </tr>
        </thead>
        <tbody>
          ${view.rows.map(row)}
        </tbody>
      </table>
    </div>
    <small>${t("field-source", { source: view.rows[0]?.source ?? "" })}</small>`;
}

/** Opens the dialog; `setup`: the machine; none: that of the core; `connection`: the one that is shown at first. */
export async function openCommissioning(
  core: ProgramCore,
  store: Store,
  setup: Machine | undefined,
  end: AbortSignal,
  connection?: string,
): Promise<void> {
  await helpWords();
  const { paths, connections } = core.commissioning();
  const ways = paths.map(({ id, title }) => el("option", { value: id }, say(title)));
  const others = [
    el("option", { value: CONNECTIONS }, t("steps-connections")),
    el("option", { value: VERSIONS }, t("steps-versions-title")),
  ];
  const way = el("select", { id: "steps-path" }, ...ways, ...others);
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
    if (way.value === VERSIONS) return versions(core.compatibility(setup ? { setup } : {}));
    return path ? list(path, store.state.machine.steps, turn) : cards(connections);
  };
  const draw = (): void => {
    render(content(), told);
    setOff(again, !shown()?.steps.some(({ id }) => store.state.machine.steps[id]), way);
  };
  function turn(id: string, done: boolean): void {
    store.update({ machine: { steps: { ...store.state.machine.steps, [id]: done } } });
    draw();
  }
  on(way, "change", draw);
  printsWith(dialog, printing, () => {
    const body = el("div");
    render(content(), body);
    return { paper: "exported", title: way.selectedOptions[0]?.textContent ?? "", parts: [body] };
  });
  on(again, "click", () => {
    const own = new Set(shown()?.steps.map(({ id }) => id));
    const left = Object.entries(store.state.machine.steps).filter(([id]) => !own.has(id));
    store.update({ machine: { steps: Object.fromEntries(left) } });
    draw();
  });
  if (connection) way.value = CONNECTIONS;
  draw();
  showPassing(dialog, closing, end, () => {});
  const first = connection ? told.querySelector<HTMLElement>(`#${connection}`) : null;
  first?.scrollIntoView({ block: "start" });
  first?.focus();
}
