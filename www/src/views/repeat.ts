// The test programs of a probe: does it switch, and how far do touches of one place spread. The second is run on the
// machine in use, or values of a real machine are pasted; both programs are saved. Nothing of it is kept.

import "../styles/exported.css";
import "../styles/repeat.css";
import { html, nothing, render, svg, type TemplateResult } from "lit-html";
import type { ProgramCore } from "../core/program";
import { el, on } from "../dom";
import { guideButton } from "../guide";
import { parseNumber, plain } from "../numbers";
import { saveFile } from "../state/files";
import { refusal, say, sayProblem, t } from "../texts";
import type { Message, OwnMachine, RepeatRequest, RepeatView, Setup } from "../wire";
import { passingDialog, showPassing } from "./passing";

const NUMBERS = ["from", "to", "feed", "count", "parameters"] as const;
const HINTED = ["from", "to", "feed", "count"] as const;
const AXES = ["X", "Y", "Z"];
const INPUTS = ["", "1", "2"]; // the first: as the machine has it
const PAUSE = 200; // ms, while one types
const [WIDTH, HEIGHT] = [300, 80]; // of the histogram

/** How many values lie in each interval; where all are the same there is nothing to see. */
function histogram({ found, unit }: RepeatView): TemplateResult | typeof nothing {
  if (found.largest === found.smallest) return nothing;
  const most = Math.max(...found.intervals, 1);
  const step = WIDTH / found.intervals.length;
  const bars = found.intervals.map((count, at) => {
    const high = (count / most) * HEIGHT;
    return svg`<rect x=${at * step + 1} y=${HEIGHT - high} width=${step - 2} height=${high}></rect>`;
  });
  const ends = { from: plain(found.smallest, 5), to: plain(found.largest, 5), unit };
  return html`<figure class="repeat-figure">
    <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label=${t("repeat-histogram", ends)}>${bars}</svg>
    <figcaption><span>${ends.from}</span><span>${ends.to} ${unit}</span></figcaption>
  </figure>`;
}

const listed = (lines: Message[], kind: string): TemplateResult | typeof nothing =>
  lines.length ? html`<ul class=${kind}>${lines.map(line => html`<li>${say(line)}</li>`)}</ul>` : nothing;

function outcome(view: RepeatView): TemplateResult {
  return html`${listed(view.told, "repeat-told")} ${listed(view.notes, "repeat-notes")}
    ${histogram(view)}
    <details>
      <summary>${t("repeat-values-shown", { count: view.found.values.length })}</summary>
      <p class="repeat-values">${view.found.values.map(value => plain(value, 5)).join(" ")}</p>
    </details>
    <details>
      <summary>${t("repeat-program")}</summary>
      <pre>${view.program}</pre>
    </details>
    <details>
      <summary>${t("repeat-function")}</summary>
      <pre>${view.function}</pre>
    </details>`;
}

function choice(id: string, values: string[], text: (value: string) => string): HTMLSelectElement {
  return el("select", { id }, ...values.map(value => el("option", { value }, text(value))));
}

function labelled(input: HTMLInputElement | HTMLSelectElement, text: string): HTMLElement {
  return el("p", {}, el("label", { for: input.id }, text), input);
}

/** Opens the dialog; it goes when it is closed. */
export function openRepeat(core: ProgramCore, setup: Setup | OwnMachine | undefined, end: AbortSignal): void {
  const axis = choice("repeat-axis", AXES, value => value);
  const input = choice("repeat-input", INPUTS, value => value || t("repeat-input-machine"));
  const numbers = Object.fromEntries(
    NUMBERS.map(name => [name, el("input", { type: "text", id: `repeat-${name}`, inputmode: "decimal" })]),
  ) as Record<(typeof NUMBERS)[number], HTMLInputElement>;
  const boxes = (["machine", "changes"] as const).map(name => {
    const field = el("input", { type: "checkbox", id: `repeat-${name}` });
    return { name, field, label: el("label", { class: "check", for: field.id }, field, t(`repeat-${name}`)) };
  });
  const values = el("textarea", { id: "repeat-real", rows: 3, spellcheck: "false" });
  const problem = el("p", { class: "exported-problem", role: "alert" });
  const told = el("div", { class: "repeat-outcome", "aria-live": "polite" });
  const saving = (["function", "program"] as const).map(name => ({
    name,
    button: el("button", { type: "button", disabled: true }, t(`repeat-save-${name}`)),
  }));
  const closing = el("button", { type: "button", class: "primary" }, t("exported-close"));
  const dialog = passingDialog(
    "repeat-title",
    t("repeat-title"),
    [
      el("p", {}, t("repeat-intro")),
      el(
        "div",
        { class: "braking-fields" },
        labelled(axis, t("repeat-axis")),
        ...NUMBERS.map(name => labelled(numbers[name], t(`repeat-${name}`))),
        labelled(input, t("repeat-input")),
      ),
      el("div", { class: "exported-uses" }, ...boxes.map(({ label }) => label)),
      el("label", { for: "repeat-real" }, t("repeat-real")),
      values,
      problem,
      told,
    ],
    [...saving.map(({ button }) => button), closing],
    guideButton("repeat"),
  );
  let view: RepeatView | null = null;
  let waiting = 0;

  const asked = (): RepeatRequest => {
    const request: RepeatRequest = { axis: axis.value };
    for (const name of NUMBERS) {
      const number = parseNumber(numbers[name].value);
      if (number !== null) request[name] = number;
    }
    for (const { name, field } of boxes) request[name] = field.checked;
    if (input.value) request.input = Number(input.value);
    if (values.value.trim()) request.values = values.value;
    if (setup) request.setup = setup;
    return request;
  };
  const fields = { ...numbers, axis, input, values };
  /** Marks the field that is refused. */
  const mark = (wrong: unknown): void => {
    for (const [name, field] of Object.entries(fields)) field.setAttribute("aria-invalid", String(name === wrong));
  };
  const unread = (): (typeof NUMBERS)[number] | undefined =>
    NUMBERS.find(name => numbers[name].value.trim() && parseNumber(numbers[name].value) === null);
  /** Shows what is taken where nothing is typed. */
  const hint = ({ usual, unit }: RepeatView): void => {
    const length = `\u{a0}${unit}`;
    const units = { from: length, to: length, feed: `${length}/min`, count: "" };
    for (const name of HINTED) numbers[name].placeholder = `${plain(usual[name])}${units[name]}`;
  };
  const draw = (): void => {
    const wrong = unread();
    const request = asked();
    const first = wrong ? null : core.repeat(request);
    // the words of the programs are known when the core has told which they are
    const words = first && !("why" in first) ? Object.fromEntries(first.says.map(key => [key, t(key)])) : null;
    const answer = words ? core.repeat({ ...request, words }) : first;
    view = answer && !("why" in answer) ? answer : null;
    if (view) hint(view);
    const why = answer && "why" in answer ? answer.why : "";
    problem.textContent = wrong ? t("repeat-not-a-number", { value: numbers[wrong].value.trim() }) : sayProblem(why);
    mark(wrong ?? refusal(why)?.args.path);
    for (const { button } of saving) button.disabled = !view;
    render(view ? outcome(view) : nothing, told);
  };
  for (const field of [axis, input, values, ...Object.values(numbers), ...boxes.map(box => box.field)])
    on(field, "input", () => {
      clearTimeout(waiting);
      waiting = window.setTimeout(draw, PAUSE);
    });
  for (const { name, button } of saving)
    on(
      button,
      "click",
      () => view && saveFile(view[name], name === "program" ? "PW_REPEAT.MPF" : "PW_PROBE_CHECK.MPF"),
    );
  showPassing(dialog, closing, end, () => clearTimeout(waiting));
  draw();
}
