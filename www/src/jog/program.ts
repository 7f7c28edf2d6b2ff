// The mask as a program: the call that does the same, what is different, and the way into the program.

import { html, nothing, type TemplateResult } from "lit-html";
import type { Practice } from "../desk/practice";
import { iconPart } from "../icons";
import { say, t } from "../texts";
import type { PracticeProgram } from "../wire";

export interface Insert {
  /** The call is written into the program, and is in the form. */
  insert(program: PracticeProgram): void;
}

/** Asked for only while it is unfolded. */
export function asProgram(program: PracticeProgram | null, practice: Practice, { insert }: Insert): TemplateResult {
  return html`
    <div class="jog-program">
      <button
        type="button"
        class="quiet jog-program-open"
        aria-expanded=${String(!!program)}
        @click=${() => practice.program(!program)}
      >
        ${iconPart("file")}<span>${t("practice-program")}</span>
      </button>
      ${
        program
          ? html`<div class="jog-program-shown" role="status">
              ${
                program.text
                  ? html`<pre tabindex="0" aria-label=${t("practice-program")}>${program.text}</pre>
                      <button type="button" class="jog-program-insert" @click=${() => insert(program)}>
                        ${t("practice-program-insert")}
                      </button>
                      ${program.told.length ? html`<h4>${t("practice-program-differs")}</h4>` : nothing}`
                  : nothing
              }
              <ul>${program.told.map(one => html`<li>${say(one)}</li>`)}</ul>
            </div>`
          : nothing
      }
    </div>
  `;
}
