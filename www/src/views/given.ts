// What a run is given: which program of the text, values of its own parameters, and whether it stops at what is not
// there. Behind what came out: what was assumed and what was passed over, each with the way to give it.

import { html, nothing, render, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { repeat } from "lit-html/directives/repeat.js";
import type { Actions } from "../desk/actions";
import { lineIn } from "../desk/beside";
import type { Derived } from "../desk/derive";
import { chosenIn, parametersIn } from "../desk/given";
import { guidePart } from "../guide";
import type { State } from "../state/state";
import { listed, t } from "../texts";
import { unlessTyping } from "../unless-typing";
import type { FileStart, MachineValue, ProgramPlace, RunMode } from "../wire";

/** The ways from what a run lacks to where it is given. */
export interface Lacks {
  /** Lets the user pick files that lie beside the program. */
  pickFiles(): void;
  /** Shows the values of the machine. */
  machineValues(): void;
  /** Shows the parameters of the program. */
  parameter(name: string): void;
}

const ASSUMED = 20; // values that are named
const MODES: RunMode[] = ["automatic", "dry-run", "program-test", "block-search", "simulation", "jobshop"];

export const parameterId = (name: string): string => `given-${name.replace(/\W/g, "-")}`;

/** `L105.SPF, line 3`. */
export function lineText(files: readonly FileStart[] | undefined, of: number): string {
  const { file, line } = lineIn(files, of);
  return file === undefined ? t("motions-line", { line }) : t("beside-line", { file, line });
}

export function createGiven(
  before: HTMLElement,
  behind: HTMLElement,
  actions: Actions,
  lacks: Lacks,
): (state: State, derived: Derived) => void {
  const field = (state: State, { name, kind, optional }: { name: string; kind: string; optional: boolean }) => {
    const id = parameterId(name);
    const typed = state.program.given[state.form.control]?.[name] ?? "";
    const taken = ({ target }: Event): void => actions.argument(name, (target as HTMLInputElement).value);
    return html`<div class="given-field">
      <label for=${id}><code>${name}</code> <span class="meta">${kind}</span></label
      ><input
        id=${id}
        type="text"
        autocomplete="off"
        spellcheck="false"
        placeholder=${optional ? t("choice-default") : ""}
        .value=${unlessTyping(typed)}
        @change=${taken}
      />
    </div>`;
  };
  const choice = (programs: readonly ProgramPlace[], chosen: string): TemplateResult => {
    const taken = ({ target }: Event): void => actions.main((target as HTMLSelectElement).value);
    const option = (name: string, label: string): TemplateResult =>
      html`<option value=${name} ?selected=${name === chosen}>${label}</option>`;
    return html`<div class="given-field">
      <label for="run-program">${t("given-program")}</label
      ><select id="run-program" class="choice" .value=${live(chosen)} @change=${taken}>
        ${option("", t("given-program-first"))}${programs.map(({ name }) => option(name, name))}
      </select>
    </div>`;
  };
  const modeOf = ({ run: { mode, target } }: State): TemplateResult => {
    const chosen = ({ target: from }: Event): void =>
      actions.mode((from as HTMLSelectElement).value as RunMode, target);
    const line = ({ target: from }: Event): void =>
      actions.mode(mode, Math.max(0, Math.trunc((from as HTMLInputElement).valueAsNumber || 0)));
    const option = (one: RunMode): TemplateResult =>
      html`<option value=${one} ?selected=${one === mode}>${t(`given-mode-${one}`)}</option>`;
    return html`<div class="given-field">
        <label for="run-mode">${t("given-mode")}</label
        ><select id="run-mode" class="choice" .value=${live(mode)} @change=${chosen}>${MODES.map(option)}</select>
      </div>
      ${
        mode === "block-search"
          ? html`<div class="given-field">
              <label for="run-target">${t("given-target")}</label
              ><input
                id="run-target"
                type="number"
                min="1"
                aria-invalid=${target > 0 ? nothing : "true"}
                .value=${live(target > 0 ? String(target) : "")}
                @change=${line}
              />
            </div>`
          : nothing
      }
      ${
        mode === "automatic"
          ? nothing
          : html`<p class="given-mode">${t(`given-mode-${mode}-told`)} ${guidePart("run-modes")}</p>`
      }`;
  };
  const assumed = (all: readonly MachineValue[], files: readonly FileStart[] | undefined): TemplateResult => {
    const named = all
      .slice(0, ASSUMED)
      .map(({ name, value, line }) => `${name} = ${value === "" ? '""' : value} (${lineText(files, line)})`);
    const rest = all.length - named.length;
    const values = listed(rest > 0 ? [...named, "…"] : named);
    return html`<div class="lack" data-lack="values">
      <p>${t("given-assumed", { count: all.length, values })}</p>
      <button type="button" @click=${lacks.machineValues}>${t("given-enter-values")}</button>
    </div>`;
  };
  const wanted = (names: readonly string[]): TemplateResult => html`<div class="lack" data-lack="files">
    <p>${t("given-missing", { names: listed([...names]) })}</p>
    <button type="button" @click=${lacks.pickFiles}>${t("given-open-files")}</button>
  </div>`;
  return (state, derived) => {
    const whole = state.view.source === "program";
    const programs = derived.read.programs ?? [];
    const parameters = parametersIn(derived.read, state) ?? [];
    const chosen = chosenIn(derived.read, state)?.name ?? "";
    const strict = ({ target }: Event): void => actions.strict((target as HTMLInputElement).checked);
    render(
      whole
        ? html`<fieldset class="given">
            <legend class="visually-hidden">${t("given-title")}</legend>
            ${programs.length ? choice(programs, chosen) : nothing}
            ${repeat(
              parameters,
              one => one.name,
              one => field(state, one),
            )}
            ${state.form.control === "sinumerik" ? modeOf(state) : nothing}
            <label class="check" for="run-strict"
              ><input id="run-strict" type="checkbox" .checked=${live(state.run.strict)} @change=${strict} />${t(
                "given-strict",
              )}</label
            >
          </fieldset>`
        : nothing,
      before,
    );
    const { run } = derived;
    const values = run?.machineValues ?? [];
    const names = run ? [...new Set(derived.read.diagnostics.flatMap(one => one.wants ?? []))] : [];
    render(
      html`${values.length ? assumed(values, run?.files) : nothing}${names.length ? wanted(names) : nothing}`,
      behind,
    );
  };
}
