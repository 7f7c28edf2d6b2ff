// Scenarios: programs held against what must come of them. One is made of the program that is open, files and folders
// of them are carried out, and the built-in ones prove the installation.

import "../styles/scenarios.css";
import { html, nothing, render, type TemplateResult } from "lit-html";
import type { ProgramCore } from "../core/program";
import { createProver } from "../core/proving";
import type { Derived } from "../desk/derive";
import { givenTo, machineTo } from "../desk/given";
import { el } from "../dom";
import { guidePart } from "../guide";
import { iconPart } from "../icons";
import { fileOf, saveFile } from "../state/files";
import type { State } from "../state/state";
import { isPlaced, say, sayProblem, t } from "../texts";
import type { CaseView, Message, NoteRequest, Scenario, ScenarioView } from "../wire";
import { type Found, type Kind, scenariosIn } from "./files";

const SHOWN = 100; // files that no scenario needs

/** What came of a scenario, or why nothing did. */
type Came = { name: string; kind?: Kind } & (ScenarioView | { why: string; placed: boolean });

/** What is carried out: `count` scenarios, since when, until when (ms). */
interface Series {
  count: number;
  since: number;
  until: number | null;
  came: Came[];
  unused: string[];
}

const casesOf = (came: Came): readonly CaseView[] => ("cases" in came ? came.cases : []);
const holds = ({ differences }: CaseView): boolean => differences.length === 0;
const good = (came: Came): boolean => "cases" in came && came.cases.every(holds);

export interface Scenarios {
  open(): void;
  /** Worked measurements of the manuals, their figures and closed loops in this browser. */
  check(): void;
}

export function createScenarios(
  core: ProgramCore,
  shown: () => { state: State; derived: Derived } | null,
  end: AbortSignal,
): Scenarios {
  const dialog = el("dialog", { class: "scenarios", "aria-labelledby": "scenarios-title" });
  const picker = el("input", { type: "file", multiple: true, hidden: true });
  const folder = el("input", { type: "file", webkitdirectory: true, hidden: true });
  const body = el("div", { class: "scenarios-body" });
  dialog.append(body, picker, folder);
  document.body.append(dialog);
  const prover = createProver(core.module);
  let series: Series | null = null;
  let problem = "";
  let pressed: HTMLElement | null = null; // by which they are carried out

  const stop = (): void => {
    prover.stop();
    if (series?.until === null) series.until = performance.now();
    draw();
  };
  const one = async ({ name, kind, text, beside }: Found): Promise<Came> => {
    const read = await text();
    const what = kind ? { name, kind } : { name };
    if (typeof read !== "string") return { ...what, why: t(read.key, read.args), placed: false };
    const proved = await prover.ask({ text: read, beside: await beside(read) });
    if ("problem" in proved) return { ...what, why: sayProblem(proved.problem), placed: isPlaced(proved.problem) };
    return { ...what, ...(JSON.parse(proved.json) as ScenarioView) };
  };
  const carryOut = async (found: readonly Found[], unused: () => string[] = () => []): Promise<void> => {
    stop();
    const own: Series = { count: found.length, since: performance.now(), until: null, came: [], unused: [] };
    series = own;
    problem = found.length ? "" : t("scenarios-none");
    draw();
    for (const next of found) {
      const came = await one(next);
      if (own.until !== null) return; // stopped
      own.came.push(came);
      draw();
    }
    own.until = performance.now();
    own.unused = unused();
    draw();
  };
  const check = async (): Promise<void> => carryOut((await import("./built-in")).builtIn());
  const note = async (): Promise<void> => {
    const now = shown();
    if (!now) return;
    stop();
    const { state, derived } = now;
    const { known: _, ...given } = givenTo(state);
    const { name } = fileOf(state);
    const setup = machineTo(state, derived.view);
    const run = { control: state.form.control, text: derived.program, ...(setup ? { setup } : {}), ...given };
    const proved = await prover.ask({ note: { run, name, case: name } satisfies NoteRequest });
    if ("problem" in proved) problem = sayProblem(proved.problem);
    else {
      const scenario = JSON.parse(proved.json) as Scenario;
      const text = JSON.stringify(scenario, null, 2);
      saveFile(`${text}\n`, `${name.replace(/\.[^.]*$/, "")}.scenario.json`, "application/json");
      const measures = scenario.cases?.some(({ expect }) => expect?.calls?.length);
      problem = measures ? "" : t("scenario-unmeasured");
    }
    draw();
  };
  const picked = (from: HTMLInputElement) => (): void => {
    const files = [...(from.files ?? [])];
    from.value = "";
    if (!files.length) return;
    const { found, unused } = scenariosIn(files, core);
    void carryOut(found, unused);
  };
  picker.addEventListener("change", picked(picker));
  folder.addEventListener("change", picked(folder));
  dialog.addEventListener("close", stop);
  end.addEventListener("abort", prover.stop);

  const button = (key: string, icon: Parameters<typeof iconPart>[0], run: () => void, off = false): TemplateResult => {
    const press = (event: Event): void => {
      pressed = event.currentTarget as HTMLElement;
      run();
    };
    const shown = html`${iconPart(icon)}<span>${t(key)}</span>`;
    return html`<button type="button" ?disabled=${off} @click=${press}>${shown}</button>`;
  };
  function draw(): void {
    const held = document.activeElement;
    const empty = !shown()?.derived.program.trim();
    render(
      html`<header><h2 id="scenarios-title">${t("scenarios-title")}</h2>${guidePart("scenarios")}</header>
        <p>${t("scenarios-what")}</p>
        <div class="scenarios-ways">
          ${button("scenarios-note", "save", () => void note(), empty)}
          ${button("scenarios-open-files", "open", () => picker.click())}
          ${button("scenarios-open-folder", "open", () => folder.click())}
          ${button("scenarios-check", "good", () => void check())} ${guidePart("installation")}
        </div>
        <p role="alert" ?hidden=${problem === ""}>${problem}</p>
        ${series ? outcome(series, stop) : nothing}
        <div class="actions">
          <button type="button" class="primary" @click=${() => dialog.close()}>${t("about-close")}</button>
        </div>`,
      body,
    );
    // the button that stops it is gone when it is over
    if (held && held !== document.body && !held.isConnected) (pressed ?? firstWay())?.focus();
  }
  const firstWay = (): HTMLElement | null => body.querySelector<HTMLElement>(".scenarios-ways button:enabled");
  const open = (): void => {
    draw();
    if (dialog.open) return;
    dialog.showModal();
    firstWay()?.focus(); // else the help beside the title has it
  };
  return {
    open,
    check() {
      open();
      void check();
    },
  };
}

/** How many cases hold, and each scenario; what differs stands first. */
function outcome({ count, since, until, came, unused }: Series, stop: () => void): TemplateResult {
  const all = came.flatMap(casesOf);
  const refused = came.filter(one => "why" in one).length;
  const seconds = ((until ?? performance.now()) - since) / 1000;
  const told = { good: all.filter(holds).length, count: all.length + refused, scenarios: count, done: came.length };
  const ordered = [...came.filter(one => !good(one)), ...came.filter(good)];
  return html`<div class="scenarios-outcome" role="status">
      <strong>${t("scenarios-passed", told)}</strong>
      ${until === null ? t("scenarios-done", told) : t("scenarios-time", { seconds: Math.round(10 * seconds) / 10 })}
    </div>
    ${
      until === null
        ? html`<progress max=${count} value=${came.length} aria-label=${t("scenarios-done", told)}></progress>
          <button type="button" @click=${stop}>${t("scenarios-stop")}</button>`
        : nothing
    }
    <ul class="scenarios-list" tabindex="0" aria-label=${t("scenarios-title")}>${ordered.map(row)}</ul>
    ${unused.length ? unusedOf(unused) : nothing}`;
}

/** Files that were picked and that no scenario needs: none is dropped without a word. */
function unusedOf(unused: readonly string[]): TemplateResult {
  const more = unused.length - SHOWN;
  return html`<details class="scenarios-unused">
    <summary>${t("scenarios-unused", { count: unused.length })}</summary>
    <p>${t("scenarios-unused-why")}</p>
    <ul>
      ${unused.slice(0, SHOWN).map(name => html`<li>${name}</li>`)}
      ${more > 0 ? html`<li>${t("scenarios-unused-more", { count: more })}</li>` : nothing}
    </ul>
  </details>`;
}

/** Why a scenario was not carried out, and what helps. */
const refused = (why: string, placed: boolean): TemplateResult =>
  html`<p>${why}</p>
    ${placed ? html`<p>${t("scenario-cure")}</p>` : nothing}`;

function row(came: Came): TemplateResult {
  const fine = good(came);
  const cases = casesOf(came);
  const { length } = cases.filter(holds);
  return html`<li data-good=${fine}>
    ${iconPart(fine ? "good" : "error")}
    <span class="visually-hidden">${t(fine ? "scenarios-good" : "scenarios-bad")}</span>
    <span class="scenario-name">${came.name}</span>
    <span class="meta">${"why" in came ? nothing : `${length}/${cases.length}`}</span>
    <span class="meta scenario-source">${"source" in came ? from(came) : nothing}</span>
    ${"why" in came ? refused(came.why, came.placed) : cases.filter(one => toldOf(one).length > 0).map(differing)}
  </li>`;
}

/** Where its figures come from. */
const from = ({ kind, source }: { kind?: Kind; source: string }): string =>
  kind ? t(`scenarios-from-${kind}`, { source }) : source;

/** How a case differs, and what it does not prove. */
const toldOf = ({ differences, unproven }: CaseView): Message[] => [...differences, ...unproven];

const differing = (one: CaseView): TemplateResult =>
  html`<p><strong>${one.id}</strong></p>
    <ul>
      ${toldOf(one).map(message => html`<li>${say(message)}</li>`)}
    </ul>`;
