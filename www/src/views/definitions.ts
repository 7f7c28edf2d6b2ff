// The definition files of the machine: the lines that differ from delivery, the program that assigns its values and the
// memory, each to be saved; and files of the control read back into the machine.

import "../styles/exported.css";
import "../styles/repeat.css";
import "../styles/definitions.css";
import { html, nothing, render, type TemplateResult } from "lit-html";
import type { ProgramCore } from "../core/program";
import { el, on, setAttribute } from "../dom";
import { guideButton } from "../guide";
import { readExported, saveFile } from "../state/files";
import { say, sayHint, sayProblem, t } from "../texts";
import type { DefinitionsText, DefinitionsView, Machine, MachineView, MemoryShare } from "../wire";
import { passingDialog, showPassing } from "./passing";

const CHANNELS = 10;
const LARGEST = 50 * 2 ** 20; // bytes

/** Where the machine is, and where it goes when files gave it values. */
export interface OfMachine {
  setup(): { setup?: Machine };
  take(machine: Pick<MachineView, "basic" | "data">, definitions: string[]): void;
}

function fileOf(file: DefinitionsText): TemplateResult {
  return html`<h3>${file.name}</h3>
    <pre>${file.text}</pre>
    <p
      ><button type="button" @click=${() => saveFile(file.text, file.saved)}
        >${t("definitions-save-file", { name: file.saved })}</button
      ></p
    >`;
}

function shareOf({ name, channel, bytes, delivered }: MemoryShare): TemplateResult {
  return html`<tr>
    <th scope="row"><code>${name}</code></th>
    <td>${t(channel ? "definitions-of-channel" : "definitions-of-control")}</td>
    <td>${bytes}</td>
    <td>${delivered}</td>
  </tr>`;
}

function outcome({ files, memory, needs, notes }: DefinitionsView): TemplateResult {
  const steps = notes.map(note => html`<li>${say(note)}</li>`);
  const least = needs.map(
    ({ number, value, source }) => html`<li>${t("definitions-need", { number, value, source })}</li>`,
  );
  return html`${steps.length ? html`<ol class="repeat-notes definitions-steps">${steps}</ol>` : nothing}
    ${files.length ? files.map(fileOf) : html`<p>${t("definitions-none")}</p>`}
    ${memory.length ? shares(memory, least) : nothing}`;
}

function shares(memory: MemoryShare[], least: TemplateResult[]): TemplateResult {
  const heads = ["definitions-array", "definitions-scope", "definitions-bytes", "definitions-delivered"];
  return html`<h3>${t("definitions-memory")}</h3>
    <table class="definitions-memory">
      <thead
        ><tr>${heads.map(key => html`<th scope="col">${t(key)}</th>`)}</tr></thead
      >
      <tbody>${memory.map(shareOf)}</tbody>
    </table>
    <ul class="repeat-notes">${least}</ul>`;
}

/** Opens the dialog; it goes when it is closed. */
export function openDefinitions(core: ProgramCore, machine: OfMachine, end: AbortSignal): void {
  const channels = el("input", {
    type: "number",
    id: "definitions-channels",
    min: "1",
    max: String(CHANNELS),
    value: "1",
  });
  const jog = el("input", { type: "checkbox", id: "definitions-jog", checked: true });
  const picker = el("input", {
    type: "file",
    multiple: true,
    hidden: true,
    tabindex: "-1",
    "aria-label": t("definitions-read-files"),
  });
  const reading = el("button", { type: "button" }, t("definitions-read-files"));
  const closing = el("button", { type: "button", class: "primary" }, t("exported-close"));
  const problem = el("p", { class: "exported-problem", role: "alert" });
  const read = el("p", { role: "status" });
  const told = el("div", { class: "repeat-outcome" });
  const dialog = passingDialog(
    "definitions-title",
    t("definitions-title"),
    [
      el("p", {}, t("definitions-intro")),
      el("label", { for: channels.id }, t("definitions-channels-label")),
      channels,
      el("label", { class: "check", for: jog.id }, jog, t("exported-jog")),
      problem,
      read,
      told,
    ],
    [reading, closing],
    guideButton("definitions"),
  );
  dialog.append(picker);
  setAttribute(dialog, "data-takes-files", "true");

  const draw = (): void => {
    const answer = core.definitions({
      ...machine.setup(),
      channels: Math.max(0, Math.trunc(channels.valueAsNumber || 0)),
      jog: jog.checked,
    });
    problem.textContent = "why" in answer ? sayProblem(answer.why) : "";
    render("why" in answer ? nothing : outcome(answer), told);
  };
  const take = async (files: File[]): Promise<void> => {
    read.textContent = "";
    if (files.reduce((sum, file) => sum + file.size, 0) > LARGEST) {
      problem.textContent = t("exported-too-large", { most: LARGEST / 2 ** 20 });
      return;
    }
    const texts = await Promise.all(files.map(file => readExported(file, core)));
    if (end.aborted || !dialog.open) return;
    const answer = core.readBack({ ...machine.setup(), files: texts });
    if ("why" in answer) {
      problem.textContent = sayProblem(answer.why);
      return;
    }
    machine.take(answer.machine, answer.definitions);
    draw();
    const refused = answer.machine.problems.map(one => `${one.name}: ${say(one.message)} ${sayHint(one)}`);
    const unread = answer.unread.map(one => {
      const place = one.place ? `${one.place.file}:${one.place.line}: ` : "";
      return `${place}${one.name}: ${say(one.message)}`;
    });
    const sizes = answer.sizes ? [say(answer.sizes)] : [];
    read.textContent = [say(answer.ending), ...sizes, ...unread, ...refused].join(" ");
  };
  on(channels, "input", draw);
  on(jog, "change", draw);
  on(reading, "click", () => picker.click());
  on(picker, "change", () => {
    void take([...(picker.files ?? [])]);
    picker.value = "";
  });
  on(dialog, "drop", event => {
    event.preventDefault();
    const files = [...((event as DragEvent).dataTransfer?.files ?? [])];
    if (files.length) void take(files);
  });
  draw();
  showPassing(dialog, closing, end, () => {});
}
