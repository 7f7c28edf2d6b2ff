// The machine to practise on: functions and mask, the stage, the machine under the hand, how the part lies.

import { html, nothing, render, type TemplateResult } from "lit-html";
import { FILE, type Practice, scriptOf } from "../desk/practice";
import { el, on } from "../dom";
import { iconPart } from "../icons";
import { ariaKey, meantBy } from "../keys";
import { saveFile } from "../state/files";
import type { JogState, State } from "../state/state";
import { t } from "../texts";
import type { Stage } from "../views/stage";
import { axisOf, createHand, wayOf } from "./hand";
import { createMask, startLine } from "./mask";
import { createPart } from "./part";
import type { Insert } from "./program";
import { createJogStage } from "./stage";
import "../styles/jog.css";

export interface Leads extends Insert {
  toWork(): void;
}

/** What is being typed is entered. */
function enter(): void {
  const field = document.activeElement;
  if (!(field instanceof HTMLInputElement)) return;
  field.blur();
  field.focus();
}

/** `stop`: nobody wants it any more. */
export function createPlace(
  root: HTMLElement,
  practice: Practice,
  stage: Stage,
  leads: Leads,
  stop: AbortSignal,
): (state: State) => void {
  const [head, mask, hand, part] = ["head", "mask", "hand", "part"].map(name =>
    el("section", { class: `jog-${name}`, ...(name === "head" ? {} : { "aria-label": t(`practice-${name}`) }) }),
  ) as [HTMLElement, HTMLElement, HTMLElement, HTMLElement];
  const picture = el("section", { class: "jog-stage", "aria-label": t("view-title") });
  const file = el("input", {
    type: "file",
    accept: ".jog,text/plain",
    hidden: true,
    "aria-label": t("practice-open-script"),
  });
  on(file, "change", () => {
    const [picked] = file.files ?? [];
    file.value = "";
    if (picked) void practice.take(picked);
  });
  root.append(head, mask, picture, hand, part, file);
  const drawMask = createMask(mask, practice, leads);
  const drawHand = createHand(hand, practice, stop);
  const drawPart = createPart(part, practice);
  const drawStage = createJogStage(picture, stage, practice);
  let now: State | null = null;
  root.addEventListener(
    "keydown",
    event => {
      const meant = meantBy(event, "jog");
      const seen = now?.jog.seen;
      if (!meant || !now || !seen) return;
      if (meant === "start") {
        event.preventDefault();
        enter();
        return practice.press(startLine(seen), "start");
      }
      if (!(event.target as Element).closest(".jog-pad")) return;
      event.preventDefault();
      const { axis, sign } = axisOf(meant);
      practice.jog(axis, sign * wayOf(now));
    },
    { signal: stop },
  );

  const action = (
    name: string,
    icon: Parameters<typeof iconPart>[0],
    run: () => void,
    off = false,
  ): TemplateResult => html`
    <button type="button" class="quiet" ?disabled=${off} @click=${run}>
      ${iconPart(icon)}<span>${t(name)}</span>
    </button>
  `;
  const drawHead = ({ jog }: State): unknown =>
    render(
      html`
        <h2>${t("practice-title")}</h2>
        <div class="jog-actions">
          ${action("practice-undo", "undo", practice.undo, jog.lines.length === 0)}
          ${action("practice-restart", "first", practice.restart, jog.lines.length === 0)}
          ${action("practice-save", "save", () => saveFile(scriptOf(jog), FILE))}
          ${action("practice-open-script", "open", () => file.click())}
          ${
            jog.seen
              ? action("practice-save-machine", "download", () =>
                  saveFile(JSON.stringify(practice.setup(), null, 2), "practice.json", "application/json"),
                )
              : nothing
          }
          ${action("practice-to-work", "file", leads.toWork)}
        </div>
      `,
      head,
    );
  let pictured: JogState["seen"] = null;
  let coming = false; // the words of what is pictured
  /** What stands beside the picture. Within a mask the picture comes first, the words once it is on the screen. */
  const drawWords = (): void => {
    coming = false;
    if (now?.page.place !== "jog") return;
    drawHead(now);
    if (!now.jog.seen) return;
    drawMask(now);
    drawHand(now);
    drawPart(now);
  };
  root.setAttribute("aria-keyshortcuts", ariaKey("jog", "start"));
  return state => {
    if (state.page.place !== "jog") return drawStage(state);
    now = state;
    practice.begin();
    const { seen } = state.jog;
    const goesOn = !!seen?.mask && seen !== pictured && seen.mask.name === pictured?.mask?.name;
    pictured = seen;
    drawStage(state);
    if (!goesOn) return drawWords();
    if (!coming) setTimeout(drawWords); // behind the paint of this frame
    coming = true;
  };
}
