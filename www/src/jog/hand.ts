// The machine under the hand: positions, axes, increments, what is in the spindle, plane and zero offset in use.

import { html, nothing, render, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";
import type { Practice } from "../desk/practice";
import { iconPart } from "../icons";
import { ariaKey, type Command } from "../keys";
import { fixed } from "../numbers";
import type { State } from "../state/state";
import { say, t } from "../texts";
import type { PracticeUse } from "../wire";

const AXES = ["X", "Y", "Z"] as const;
/** Increments as the keys of the machine have them; 0: as long as the key is held down. */
const STEPS = [1, 10, 100, 1000, 10_000, 0];
const TICK = 100; // ms between two pieces of a way
/** Pixels that the wheel turns for a step: less than a notch of any mouse, more than the last turn of a touchpad. */
const NOTCH = 50;
const LINE = 20; // pixels, where the wheel counts in lines

/** The axis of a key, and its direction. */
export function axisOf(meant: Exclude<Command<"jog">, "start">): { axis: string; sign: number } {
  const [axis = "", side] = meant.split("-");
  return { axis: axis.toUpperCase(), sign: side === "plus" ? 1 : -1 };
}

const FEED = 1000 / 600; // mm in a tenth of a second, at 1000 mm/min
const RAPID = 6; // times as fast

/** How far an axis goes at a press, mm. */
export function wayOf({ jog: { step, rapid } }: State): number {
  return step > 0 ? step / 1000 : FEED * (rapid ? RAPID : 1);
}

export function createHand(root: HTMLElement, practice: Practice, stop: AbortSignal): (state: State) => void {
  let now: State | null = null;
  let ticking = 0;
  const rest = (): void => {
    clearInterval(ticking);
    ticking = 0;
  };
  stop.addEventListener("abort", rest);
  const go = (axis: string, sign: number): void => {
    if (now) practice.jog(axis, sign * wayOf(now));
  };
  /** As long as it is held down, or until something is hit. */
  const hold = (axis: string, sign: number): void => {
    if (now?.jog.step !== 0) return;
    rest();
    go(axis, sign);
    ticking = window.setInterval(() => (now?.jog.seen?.raised ? rest() : go(axis, sign)), TICK);
  };
  /** A pointer has moved it already while it was held down. */
  const press = (event: MouseEvent, axis: string, sign: number): void => {
    if (now?.jog.step !== 0 || event.detail === 0) go(axis, sign);
  };
  let turned = 0;
  /** The wheel over the keys of an axis is its handwheel. */
  const turn = (event: WheelEvent, axis: string): void => {
    if (event.ctrlKey || event.deltaY === 0) return;
    event.preventDefault(); // the page stays
    turned += event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? LINE : 1);
    if (Math.abs(turned) < NOTCH) return;
    go(axis, turned < 0 ? 1 : -1);
    turned = 0;
  };
  const axisKey = (axis: string, sign: 1 | -1): TemplateResult => {
    const side = sign > 0 ? "plus" : "minus";
    return html`
      <button
        type="button"
        class="jog-axis"
        data-axis="${axis}${sign > 0 ? "+" : "-"}"
        aria-label=${t(`practice-axis-${side}`, { axis })}
        title=${t("practice-wheel")}
        aria-keyshortcuts=${ariaKey("jog", `${axis.toLowerCase()}-${side}` as Command<"jog">)}
        @pointerdown=${() => hold(axis, sign)}
        @pointerup=${rest}
        @pointerleave=${rest}
        @pointercancel=${rest}
        @click=${(event: MouseEvent) => press(event, axis, sign)}
        @wheel=${(event: WheelEvent) => turn(event, axis)}
      >
        ${sign > 0 ? `${axis}+` : `${axis}\u2212`}
      </button>
    `;
  };
  const travel = (event: Event): void => {
    event.preventDefault();
    const field = root.querySelector<HTMLInputElement>("#jog-move");
    if (field?.value.trim()) practice.press(`move ${field.value.trim()}`, "move");
  };

  const positions = ({ jog: { seen } }: State): TemplateResult | null =>
    seen &&
    html`
      <table class="jog-positions">
        <caption class="visually-hidden">${t("practice-positions")}</caption>
        <thead>
          <tr>
            <th></th>
            <th scope="col">${seen.machine.offsets.find(one => one.used)?.name}</th>
            <th scope="col">${t("frame-machine")}</th>
          </tr>
        </thead>
        <tbody>
          ${AXES.map(
            (axis, place) => html`
              <tr>
                <th scope="row">${axis}</th>
                <td class="jog-position" data-position=${axis}>${fixed(seen.machine.wcs[place] ?? 0)}</td>
                <td>${fixed(seen.machine.mcs[place] ?? 0)}</td>
              </tr>
            `,
          )}
        </tbody>
      </table>
    `;

  const used = (id: string, label: string, all: readonly PracticeUse[], fixed = false): TemplateResult => html`
    <label title=${fixed ? t("practice-offered") : ""}>
      <span>${label}</span>
      <select
        id=${id}
        ?disabled=${fixed}
        @change=${(event: Event) => practice.press((event.target as HTMLSelectElement).value)}
      >
        ${all.map(
          ({ name, line, used }) =>
            html`<option value=${line} .selected=${live(used)}>${name || t("practice-empty")}</option>`,
        )}
      </select>
    </label>
  `;
  const setUp = ({ jog: { seen } }: State): TemplateResult | null =>
    seen &&
    html`
      <div class="jog-setup">
        ${used("jog-tool", t("practice-spindle"), seen.machine.tools)}
        ${used("jog-version", t("practice-version"), seen.machine.versions)}
        ${used("jog-plane", t("fact-plane"), seen.machine.planes)}
        ${used("jog-offset", t("practice-offset"), seen.machine.offsets, seen.machine.offered)}
        ${
          seen.machine.offered
            ? html`<button
                type="button"
                ?disabled=${!seen.keys.mode}
                title=${t("practice-offered")}
                @click=${() => practice.press("mode")}
              >
                ${t("practice-mode")}
              </button>`
            : nothing
        }
      </div>
    `;

  return state => {
    now = state;
    const { step, rapid, refused } = state.jog;
    render(
      html`
        ${positions(state)}
        <div class="jog-pad" role="group" aria-label=${t("practice-axes")}>
          ${AXES.map(axis => html`${axisKey(axis, -1)}${axisKey(axis, 1)}`)}
        </div>
        <div class="jog-way">
          <div class="jog-steps" role="group" aria-label=${t("practice-increment")}>
            ${STEPS.map(
              one => html`<button
                type="button"
                aria-pressed=${String(one === step)}
                title=${one ? t("practice-step", { way: one / 1000 }) : t("practice-continuous-help")}
                @click=${() => practice.change({ step: one })}
              >
                ${one || t("practice-continuous")}
              </button>`,
            )}
            <button
              type="button"
              class="jog-rapid"
              aria-pressed=${String(rapid)}
              ?disabled=${step !== 0}
              @click=${() => practice.change({ rapid: !rapid })}
            >
              ${t("practice-rapid")}
            </button>
          </div>
          <form class="jog-go" @submit=${travel}>
            <label for="jog-move">${t("practice-move")}</label>
            <input
              id="jog-move"
              class="figure"
              type="text"
              autocomplete="off"
              autocapitalize="characters"
              placeholder="X-20 Z-5"
              aria-invalid=${refused?.field === "move" ? "true" : "false"}
              aria-describedby="jog-move-why"
            />
            <button type="submit" aria-label=${t("practice-go")} title=${t("practice-go")}>${iconPart("start")}</button>
          </form>
          <p id="jog-move-why" class="jog-why" role="status">
            ${refused?.field === "move" ? html`${iconPart("error")}${say(refused.message)}` : ""}
          </p>
        </div>
        ${setUp(state)}
      `,
      root,
    );
  };
}
