// The check of a machine: what its control exported is pasted, dropped, opened or typed; the list of what is wrong is
// printed, and the lines to change are saved. Nothing of it is kept.

import "../styles/exported.css";
import { html, nothing, render, type TemplateResult } from "lit-html";
import type { ProgramCore } from "../core/program";
import { el, on, setAttribute } from "../dom";
import { guideButton } from "../guide";
import { iconPart } from "../icons";
import { readExported, saveFile } from "../state/files";
import { say, sayProblem, t } from "../texts";
import type { ExportedFile, MachineCheckView, MachineFault, Severity, Use } from "../wire";
import { createBraking } from "./braking";
import { type Printed, passingDialog, printsWith, showPassing } from "./passing";

const SEVERITIES: Severity[] = ["error", "warning", "note"];
const USES = ["jog", "log", "tool-probe"] as const satisfies Use[];
const SHOWN = 300; // of each severity
const LARGEST = 50 * 2 ** 20; // bytes
const PAUSE = 200; // ms, while one types

/** The alarm by its number and meaning. */
function alarmText({ alarm }: MachineFault): string {
  return alarm ? t("exported-alarm", { number: alarm.key.replace("alarm-", ""), text: say(alarm) }) : "";
}

function about(fault: MachineFault): string {
  const { channel, place, identifier } = fault;
  return [
    identifier,
    channel === undefined ? "" : t("exported-channel", { channel }),
    place ? t("exported-place", { ...place }) : "",
  ]
    .filter(Boolean)
    .join(" · ");
}

function faultOf(fault: MachineFault): TemplateResult {
  const alarm = alarmText(fault);
  const value = fault.delivered.join(" / ");
  const limits = fault.limits.map(
    ({ severity, value, source }) =>
      html`<li>${t(`exported-limit-${severity}`, { value })} · ${t("field-source", { source })}</li>`,
  );
  return html`<li class="exported-fault">
    <p><code>${fault.name}</code> <span class="meta">${about(fault)}</span></p>
    <p>${say(fault.message)} ${fault.effect ? say(fault.effect) : ""}</p>
    ${alarm ? html`<p>${alarm}</p>` : nothing}
    <ul class="exported-facts">
      ${limits.length ? limits : fault.source ? html`<li>${t("field-source", { source: fault.source })}</li>` : nothing}
      ${value ? html`<li>${t("exported-default", { value })}</li>` : nothing}
    </ul>
    ${fault.change ? html`<pre>${fault.change}</pre>` : nothing}
  </li>`;
}

/** All that is wrong, the worst first. */
function listOf({ faults, missing, ending, read }: MachineCheckView): TemplateResult {
  const group = (severity: Severity): TemplateResult | typeof nothing => {
    const of = faults.filter(fault => fault.severity === severity);
    if (!of.length) return nothing;
    const more = of.length - SHOWN;
    return html`<section class=${`exported-group ${severity}`}>
      <h3>${t(`exported-${severity}`, { count: of.length })}</h3>
      <ul>${of.slice(0, SHOWN).map(faultOf)}</ul>
      ${more > 0 ? html`<p>${t("exported-more", { count: more })}</p>` : nothing}
    </section>`;
  };
  return html`<p class="exported-ending">${say(ending)}</p>
    ${faults.length || read === 0 ? nothing : html`<p>${t("exported-clean")}</p>`}
    ${SEVERITIES.map(group)}
    ${
      missing.length
        ? html`<section class="exported-group missing">
            <h3>${t("exported-missing", { count: missing.length })}</h3>
            <p class="exported-missing">${missing.map(name => html`<code>${name}</code> `)}</p>
          </section>`
        : nothing
    }`;
}

function printedOf(view: MachineCheckView): Printed {
  const list = el("div");
  render(listOf(view), list);
  return { paper: "exported", title: t("exported-title"), parts: [list] };
}

/** A box that is checked where the machine has it. */
function box(id: string, checked: boolean, text: string): { input: HTMLInputElement; label: HTMLElement } {
  const input = el("input", { type: "checkbox", id, checked });
  return { input, label: el("label", { class: "check", for: id }, input, text) };
}

/** Opens the dialog; it goes when it is closed. */
export function openMachineCheck(core: () => ProgramCore | null, end: AbortSignal): void {
  const picker = el("input", {
    type: "file",
    multiple: true,
    hidden: true,
    tabindex: "-1",
    "aria-label": t("exported-open"),
  });
  const text = el("textarea", {
    id: "exported-text",
    rows: 8,
    spellcheck: "false",
    "aria-describedby": "exported-intro",
  });
  const uses = USES.map(use => ({ use, ...box(`exported-${use}`, true, t(`exported-${use}`)) }));
  const large = box("exported-large", false, t("exported-large"));
  const names = el("ul", { class: "exported-files" });
  const problem = el("p", { class: "exported-problem", role: "alert" });
  const list = el("div", { class: "exported-list", "aria-live": "polite" });
  const opening = el("button", { type: "button" }, t("exported-open"));
  const saving = el("button", { type: "button", disabled: true }, t("exported-save"));
  const printing = el("button", { type: "button", disabled: true }, t("exported-print"));
  const closing = el("button", { type: "button", class: "primary" }, t("exported-close"));
  const braking = createBraking(core, () => later());
  const dialog = passingDialog(
    "exported-title",
    t("exported-title"),
    [
      el("p", { id: "exported-intro" }, t("exported-intro")),
      el("label", { for: "exported-text" }, t("exported-text")),
      text,
      names,
      el(
        "fieldset",
        { class: "exported-uses" },
        el("legend", {}, t("exported-has")),
        ...uses.map(({ label }) => label),
        large.label,
      ),
      braking.root,
      problem,
      list,
    ],
    [opening, saving, printing, closing],
    guideButton("machine-check"),
  );
  dialog.append(picker);
  setAttribute(dialog, "data-takes-files", "true");
  let files: ExportedFile[] = [];
  let view: MachineCheckView | null = null;
  let waiting = 0;

  const check = (): void => {
    const typed = text.value.trim() ? [{ name: t("exported-text"), text: text.value }] : [];
    const deflection = braking.deflection();
    const asked = {
      files: [...files, ...typed],
      without: uses.filter(one => !one.input.checked).map(one => one.use),
      large: large.input.checked,
      ...(deflection === null ? {} : { deflection }),
    };
    [view, problem.textContent] = [null, ""];
    const answer = asked.files.length ? core()?.machineCheck(asked) : null;
    if (answer && "why" in answer) problem.textContent = sayProblem(answer.why);
    else view = answer ?? null;
    braking.take(view?.axis ?? null);
    render(files.map(fileOf), names);
    saving.disabled = !view?.changes;
    printing.disabled = !view;
    render(view ? listOf(view) : nothing, list);
  };
  const fileOf = (file: ExportedFile): TemplateResult => {
    const label = t("exported-remove", { name: file.name });
    const remove = (): void => {
      files = files.filter(one => one !== file);
      check();
      opening.focus(); // this button goes
    };
    return html`<li>
      ${file.name}
      <button type="button" class="quiet" title=${label} aria-label=${label} @click=${remove}
        >${iconPart("close")}</button
      >
    </li>`;
  };
  function later(): void {
    clearTimeout(waiting);
    waiting = window.setTimeout(check, PAUSE);
  }
  const take = async (chosen: readonly File[]): Promise<void> => {
    // files come together: machine data and definitions are several; the newer of two with one name counts
    const kept = files.filter(({ name }) => chosen.every(file => file.name !== name));
    const size = chosen.reduce(
      (sum, file) => sum + file.size,
      kept.reduce((sum, { text }) => sum + text.length, 0),
    );
    if (size > LARGEST) {
      problem.textContent = t("exported-too-large", { most: LARGEST / 2 ** 20 });
      return;
    }
    const reader = core();
    if (!reader) return;
    files = [...kept, ...(await Promise.all(chosen.map(file => readExported(file, reader))))];
    check();
  };
  on(text, "input", later);
  for (const { input } of [...uses, large]) on(input, "change", check);
  on(opening, "click", () => picker.click());
  on(picker, "change", () => {
    void take([...(picker.files ?? [])]);
    picker.value = ""; // the same file may be opened again
  });
  on(dialog, "drop", event => {
    event.preventDefault();
    void take([...((event as DragEvent).dataTransfer?.files ?? [])]);
  });
  on(saving, "click", () => saveFile(view?.changes ?? "", "changes.tea"));
  printsWith(dialog, printing, () => view && printedOf(view));
  showPassing(dialog, closing, end, () => clearTimeout(waiting));
}
