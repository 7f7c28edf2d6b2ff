// How the part lies: as it should, as somebody says, or as chance has it, which nobody knows until he asks.

import { html, nothing, render, type TemplateResult } from "lit-html";
import type { Practice } from "../desk/practice";
import { iconPart } from "../icons";
import { parseNumber, plain } from "../numbers";
import type { JogState, State } from "../state/state";
import { t } from "../texts";
import { unlessTyping } from "../unless-typing";
import type { PracticeView } from "../wire";
import { figureText } from "./figures";
import { createRecord } from "./record";

type Slid = keyof JogState["part"];
/** How far each can be set, its step and unit. */
const SLIDERS: readonly { name: Slid; reach: number; step: number; unit: "mm" | "deg" }[] = [
  { name: "dx", reach: 5, step: 0.01, unit: "mm" },
  { name: "dy", reach: 5, step: 0.01, unit: "mm" },
  { name: "dz", reach: 2, step: 0.01, unit: "mm" },
  { name: "tilt", reach: 5, step: 0.01, unit: "deg" },
  { name: "leanAbscissa", reach: 5, step: 0.01, unit: "deg" },
  { name: "leanOrdinate", reach: 5, step: 0.01, unit: "deg" },
  { name: "size", reach: 0.5, step: 0.01, unit: "mm" },
];
const SEEDS = 1_000_000;

/** About an axis of the plane it leans. */
function labelOf(name: Slid, { seen }: JogState): string {
  const [abscissa = "X", ordinate = "Y"] = seen?.machine.axes ?? [];
  if (name === "leanAbscissa") return t("practice-lean", { axis: abscissa });
  if (name === "leanOrdinate") return t("practice-lean", { axis: ordinate });
  return t(`error-part-${name}`);
}

export function createPart(root: HTMLElement, practice: Practice): (state: State) => void {
  const record = createRecord(practice);
  const slider = (jog: JogState, { name, reach, step, unit }: (typeof SLIDERS)[number]): TemplateResult => {
    const value = jog.seed === null ? jog.part[name] : 0;
    const id = `jog-part-${name}`;
    const words = labelOf(name, jog);
    const lay = (event: Event): void => {
      const wanted = parseNumber((event.target as HTMLInputElement).value);
      if (wanted !== null) practice.lay({ ...jog.part, [name]: Math.max(-reach, Math.min(reach, wanted)) });
    };
    return html`
      <div class="jog-slider">
        <label for=${id}>${words}</label>
        <input
          id=${id}
          type="range"
          min=${-reach}
          max=${reach}
          step=${step}
          .value=${unlessTyping(String(value))}
          @change=${lay}
        />
        <input
          type="text"
          inputmode="decimal"
          class="figure"
          aria-label=${`${words} (${t(`unit-${unit}`)})`}
          .value=${unlessTyping(plain(value, 3))}
          @change=${lay}
        />
        <span class="unit">${t(`unit-${unit}`)}</span>
      </div>
    `;
  };
  const truth = ({ truth: { shift, tilt, size } }: PracticeView): TemplateResult => {
    const three = (label: string, values: readonly number[], unit: "mm" | "deg"): TemplateResult => html`
      <div>
        <dt>${t(label)}</dt>
        <dd>
          ${values.map(
            (value, place) =>
              html`<span class="figure">${figureText({ axis: "XYZ".charAt(place), value, unit }, true)}</span>`,
          )}
        </dd>
      </div>
    `;
    return html`<dl class="jog-results jog-truth">
      ${three("practice-shift", shift, "mm")} ${three("practice-tilt", tilt, "deg")}
      <div>
        <dt>${t("error-part-size")}</dt>
        <dd><span class="figure">${figureText({ axis: "", value: size, unit: "mm" }, true)}</span></dd>
      </div>
    </dl>`;
  };
  return ({ jog }) => {
    if (!jog.seen) return;
    render(
      html`
        <h3>${t("practice-part")}</h3>
        ${jog.setup && jog.seen.piece ? html`<p class="jog-quiet">${t("practice-stand-in")}</p>` : nothing}
        <button
          type="button"
          class="jog-surprise"
          @click=${() => practice.lay(1 + Math.floor(Math.random() * SEEDS))}
        >
          ${iconPart("dice")}${t("practice-surprise")}
        </button>
        ${
          jog.seed === null
            ? SLIDERS.map(one => slider(jog, one))
            : html`
                <p>${t("practice-hidden", { seed: jog.seed })}</p>
                <div class="jog-part-keys">
                  <button
                    type="button"
                    aria-pressed=${String(jog.revealed)}
                    class="jog-reveal"
                    @click=${() => practice.reveal(!jog.revealed)}
                  >
                    ${t("practice-reveal")}
                  </button>
                  <button type="button" @click=${() => practice.lay(jog.part)}>${t("practice-as-set-up")}</button>
                </div>
                ${jog.revealed ? truth(jog.seen) : nothing}
              `
        }
        <p class="jog-quiet">${t("practice-part-help")}</p>
        ${record(jog)}
      `,
      root,
    );
  };
}
