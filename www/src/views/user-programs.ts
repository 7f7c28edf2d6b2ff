// CYCLE198 and CYCLE199: lines of the user before and after the measuring cycles that are chosen, written and saved.
// Nothing of it is kept.

import "../styles/exported.css";
import "../styles/repeat.css";
import { html, nothing, render, type TemplateResult } from "lit-html";
import type { ProgramCore } from "../core/program";
import { el, on } from "../dom";
import { guideButton } from "../guide";
import { saveFile } from "../state/files";
import { say, sayProblem, t } from "../texts";
import type { UserProgramsRequest, UserProgramsView } from "../wire";
import { passingDialog, showPassing } from "./passing";

const SIDES = ["before", "behind"] as const;
type Side = (typeof SIDES)[number];
const FILES = { before: "CYCLE198.SPF", behind: "CYCLE199.SPF" };
const COMMENTS = ["user-program-before-line", "user-program-behind-line"];
const PLACE = "CYCLE"; // the core puts the name of each cycle there
const PAUSE = 200; // ms, while one types

function program(view: UserProgramsView, side: Side): TemplateResult | typeof nothing {
  if (!view[side]) return nothing;
  const source = view.sources[SIDES.indexOf(side)] ?? "";
  return html`<h3>${FILES[side]} <span class="meta">${t("field-source", { source })}</span></h3>
    <pre>${view[side]}</pre>`;
}

function outcome(view: UserProgramsView): TemplateResult {
  const notes = view.notes.map(note => html`<li>${say(note)}</li>`);
  return html`${notes.length ? html`<ul class="repeat-notes">${notes}</ul>` : nothing}
    ${SIDES.map(side => program(view, side))}`;
}

/** Opens the dialog; it goes when it is closed. */
export function openUserPrograms(core: ProgramCore, end: AbortSignal): void {
  const first = core.userPrograms({ branches: [] });
  const labels = "why" in first ? [] : first.labels;
  const boxes = labels.map(({ cycle, key }) => {
    const field = el("input", { type: "checkbox", id: `user-program-${cycle}` });
    return {
      cycle,
      field,
      label: el("label", { class: "check", for: field.id }, field, `${cycle} ${t(`${key}-title`)}`),
    };
  });
  const texts = Object.fromEntries(
    SIDES.map(side => [side, el("textarea", { id: `user-program-${side}`, rows: 3, spellcheck: "false" })]),
  ) as Record<Side, HTMLTextAreaElement>;
  const variable = el("input", { type: "text", id: "user-program-variable", spellcheck: "false" });
  const problem = el("p", { class: "exported-problem", role: "alert" });
  const told = el("div", { class: "repeat-outcome", "aria-live": "polite" });
  const saving = SIDES.map(side => ({
    side,
    button: el("button", { type: "button", disabled: true }, t("user-program-save", { name: FILES[side] })),
  }));
  const closing = el("button", { type: "button", class: "primary" }, t("exported-close"));
  const dialog = passingDialog(
    "user-program-title",
    t("user-program-title"),
    [
      el("p", {}, t("user-program-intro")),
      el(
        "fieldset",
        { class: "exported-uses" },
        el("legend", {}, t("user-program-cycles")),
        ...boxes.map(({ label }) => label),
      ),
      ...SIDES.flatMap(side => [el("label", { for: texts[side].id }, t(`user-program-lines-${side}`)), texts[side]]),
      el("label", { for: variable.id }, t("user-program-case")),
      variable,
      problem,
      told,
    ],
    [...saving.map(({ button }) => button), closing],
    guideButton("user-programs"),
  );
  let view: UserProgramsView | null = null;
  let waiting = 0;

  const draw = (): void => {
    const chosen = boxes.filter(({ field }) => field.checked);
    const asked: UserProgramsRequest = {
      branches: chosen.map(({ cycle }) => ({ cycle, before: texts.before.value, behind: texts.behind.value })),
      words: Object.fromEntries(COMMENTS.map(key => [key, t(key, { cycle: PLACE })])),
    };
    if (variable.value.trim()) asked.variable = variable.value;
    const answer = core.userPrograms(asked);
    view = "why" in answer ? null : answer;
    problem.textContent = "why" in answer ? sayProblem(answer.why) : "";
    for (const { side, button } of saving) button.disabled = !view?.[side];
    render(view ? outcome(view) : nothing, told);
  };
  for (const field of [...Object.values(texts), variable, ...boxes.map(box => box.field)])
    on(field, "input", () => {
      clearTimeout(waiting);
      waiting = window.setTimeout(draw, PAUSE);
    });
  for (const { side, button } of saving) on(button, "click", () => view && saveFile(view[side], FILES[side]));
  showPassing(dialog, closing, end, () => clearTimeout(waiting));
}
