// The screen of the control: its functions, the mask with fields, softkeys and results, the activation screen, alarms.

import { html, nothing, render, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";
import type { Practice } from "../desk/practice";
import { glossPart } from "../glossary";
import { iconPart } from "../icons";
import { plain } from "../numbers";
import type { JogState, State } from "../state/state";
import { hasHelp, helpWords, say, sayHint, t } from "../texts";
import { unlessTyping } from "../unless-typing";
import type {
  Message,
  PracticeArea,
  PracticeField,
  PracticeMask,
  PracticePoint,
  PracticeShow,
  PracticeView,
  Raised,
} from "../wire";
import { figureText, placeText, writtenText } from "./figures";
import { asProgram, type Insert } from "./program";

/** What NC start is in a script. */
export const startLine = ({ state }: PracticeView): string => (state === "activate" ? "activate" : "start");

export function createMask(root: HTMLElement, practice: Practice, leads: Insert): (state: State) => void {
  let open = "";
  let told: PracticeView["raised"];
  return ({ jog }) => {
    if (!jog.seen) return;
    const focused = root.contains(document.activeElement);
    render(screen(jog, jog.seen, practice, leads), root);
    const now = jog.seen.mask?.name ?? "";
    if (now !== open) root.scrollTop = 0;
    if (focused && now !== open) first(root, jog.seen, open)?.focus();
    else if (focused && !root.contains(document.activeElement)) root.querySelector<HTMLElement>(".jog-start")?.focus();
    open = now;
    const { raised } = jog.seen;
    // on a phone it may lie under the stage
    if (raised && raised !== told) root.querySelector(".jog-raised")?.scrollIntoView({ block: "nearest" });
    told = raised;
  };
}

/** What has the focus when a mask is opened, or was left. */
function first(root: HTMLElement, { areas, mask }: PracticeView, left: string): HTMLElement | null {
  if (mask) return root.querySelector(".jog-fields :is(select, input)");
  const all = areas.flatMap(area => area.masks);
  const before = all.find(({ name }) => name === left);
  return root.querySelector(`[data-mask="${(before ?? all[0])?.name}"]`);
}

const noted = (note: Message): TemplateResult =>
  html`<p class="jog-told jog-note">${iconPart("info")}<span>${say(note)}</span></p>`;

function screen(jog: JogState, seen: PracticeView, practice: Practice, leads: Insert): TemplateResult {
  return html`
    ${seen.mask ? title(seen.mask, practice) : html`<h3>${t("practice-functions")}</h3>`}
    ${seen.raised ? raised(seen, practice) : nothing}
    ${seen.notes.map(noted)}
    ${seen.mask ? jog.told.map(noted) : nothing}
    ${jog.refused && !jog.refused.field ? refusal(jog.refused) : nothing}
    ${seen.mask ? opened(jog, seen, seen.mask, practice) : menu(seen.areas, practice)}
    ${seen.mask ? asProgram(jog.program, practice, leads) : nothing}
  `;
}

function title(mask: PracticeMask, practice: Practice): TemplateResult {
  return html`
    <div class="jog-title">
      <button
        type="button"
        class="jog-back"
        aria-label=${t("practice-back")}
        title=${t("practice-back")}
        @click=${() => practice.press("<<")}
      >
        &lt;&lt;
      </button>
      <h3>${say(mask.label)}</h3>
    </div>
  `;
}

function menu(areas: readonly PracticeArea[], practice: Practice): TemplateResult {
  return html`
    <div class="jog-areas">
      ${areas.map(
        ({ label, masks }) => html`
          <div class="jog-area" role="group" aria-label=${say(label)}>
            <h4>${say(label)}</h4>
            ${masks.map(
              mask => html`
                <button type="button" data-mask=${mask.name} @click=${() => practice.open(mask)}>
                  ${say(mask.label)}
                </button>
              `,
            )}
          </div>
        `,
      )}
    </div>
  `;
}

function opened(jog: JogState, seen: PracticeView, mask: PracticeMask, practice: Practice): TemplateResult {
  return html`
    ${toDo(mask, practice)}
    ${seen.activation ? activation(jog, seen, practice) : fields(jog, mask.fields, practice)}
    ${seen.points.length ? softkeys(seen, practice) : nothing}
    ${keys(jog, seen, practice)}
    ${ahead(seen)} ${results(mask.shows)} ${deviation(seen)} ${written(seen)}
  `;
}

let failed = false;

/** The help of the mask, folded: its words come when it is opened for the first time. */
function toDo(mask: PracticeMask, practice: Practice): TemplateResult {
  const redraw = (): void => practice.change({});
  const fetchWords = ({ target }: Event): void => {
    if (!(target as HTMLDetailsElement).open || hasHelp()) return;
    failed = false;
    helpWords()
      .catch((problem: unknown) => {
        console.error(problem);
        failed = true;
      })
      .finally(redraw);
  };
  const note = html`<p class="jog-quiet">${t(failed ? "help-absent" : "help-coming")}</p>`;
  const seen = new Set<string>(); // a help marks each term once
  const sections = (): TemplateResult[] =>
    mask.help.map(
      ({ label, lines }) => html`
        <h4>${say(label)}</h4>
        <ul>
          ${lines.map(one => html`<li>${glossPart(say(one.message), seen)} <small>${one.source}</small></li>`)}
        </ul>
      `,
    );
  return html`
    <details class="jog-help" @toggle=${fetchWords}>
      <summary>${t("practice-to-do")}</summary>
      ${hasHelp() ? sections() : note}
    </details>
  `;
}

/** What the next key would do from here. */
function ahead({ ahead: next, raised: now }: PracticeView): TemplateResult | typeof nothing {
  if (!next || now) return nothing;
  const {
    start,
    point,
    waits,
    touches,
    raised: why,
    refused,
    notes,
    results: shown,
    changes,
    activates,
    hidden,
  } = next;
  const item = (kind: string, text: string): { kind: string; text: string } => ({ kind, text });
  const items = [
    ...notes.map(note => item("note", say(note))),
    ...touches.map(at => item("touch", t("jog-ahead-touch", { place: placeText(at) }))),
    ...(point ? [item("store", t(waits ? "jog-ahead-hold" : "jog-ahead-store", { point }))] : []),
    ...(why ? [item("wrong", reason(why))] : []),
    ...(refused ? [item("wrong", t("jog-ahead-refuse", { text: say(refused) }))] : []),
    ...shown.map(({ label, value, unit }) =>
      item("show", t("jog-ahead-show", { label: say(label), value: figureText({ axis: "", value, unit }) })),
    ),
    ...changes.map(({ label, before, after, unit }) =>
      item("write", t("jog-ahead-write", { label: say(label), ...writtenText(before, after, unit) })),
    ),
    ...(hidden?.shows ?? []).map(label => item("show", t("jog-ahead-shown", { label: say(label) }))),
    ...(hidden?.corrects ? [item("write", t("jog-ahead-corrects", { offset: hidden.corrects }))] : []),
    ...(shown.length && !changes.length ? [item("nothing", t("jog-ahead-nothing"))] : []),
    ...(activates ? [item("activate", t("jog-ahead-activates"))] : []),
  ];
  return html`
    <section class="jog-ahead">
      <h4>${t(start ? "jog-ahead-start" : "jog-ahead-calculate")}</h4>
      <ul>
        ${items.map(({ kind, text }) => html`<li data-ahead=${kind}>${text}</li>`)}
      </ul>
      ${hidden ? html`<p class="jog-quiet">${t("jog-ahead-hidden")}</p>` : nothing}
    </section>
  `;
}

/** An alarm that would come, or what would be hit, and what helps. */
function reason({ code, message, hint }: Raised): string {
  const text = [message, ...(hint ? [hint] : [])].map(say).join(" ");
  return code ? t("jog-ahead-raise", { alarm: code, text }) : t("jog-ahead-stop", { text });
}

function fields(jog: JogState, all: readonly PracticeField[], practice: Practice): TemplateResult {
  return html`<div class="jog-fields">${all.map(field => one(jog, field, practice))}</div>`;
}

/** A field with what it holds, and why the last entry was refused. */
function one(jog: JogState, field: PracticeField, practice: Practice): TemplateResult {
  const { name, label, unit, value, choices, wrong } = field;
  const id = `jog-${name}`;
  const words = say(label);
  const refused = jog.refused?.field === name ? jog.refused : null;
  const missing = jog.refused?.field === "start" ? wrong : undefined;
  const why = refused ?? (missing && { message: missing });
  const typed = refused ? refused.text.slice(refused.text.indexOf("=") + 1).trim() : null;
  const enter = (event: Event): void =>
    practice.press(`${name} = ${(event.target as HTMLInputElement | HTMLSelectElement).value}`, name);
  const control = choices.length
    ? html`<select id=${id} aria-describedby="${id}-why" @change=${enter}>
        ${choices.map(
          choice =>
            html`<option value=${choice.word} .selected=${live(choice.word === value)}>
              ${choice.label ? say(choice.label) : choice.word}
            </option>`,
        )}
      </select>`
    : html`<span class="jog-entry">
        <input
          id=${id}
          class="figure"
          type="text"
          inputmode="decimal"
          autocomplete="off"
          .value=${unlessTyping(typed ?? plain(Number(value)))}
          aria-invalid=${why ? "true" : nothing}
          aria-describedby="${id}-why"
          @change=${enter}
          @focus=${(event: Event) => (event.target as HTMLInputElement).select()}
        />
        <span class="unit">${t(`unit-${unit}`)}</span>
      </span>`;
  return html`
    <div class="jog-field" data-field=${name}>
      <label for=${id}>${words}</label>
      ${control}
      <p id="${id}-why" class="jog-why" role="status">
        ${why ? html`${iconPart("error")}${told(why.message, words)}` : nothing}
      </p>
    </div>
  `;
}

/** A reason that names a field by the name that it has in a script, with its words. */
function told(message: Message, words: string): string {
  return say({ ...message, args: { ...message.args, ...("field" in message.args ? { field: words } : {}) } });
}

/** What a softkey P1 to P4 says of its point. */
const meaning = ({ stored, waits }: PracticePoint): string =>
  stored ? "practice-point-stored" : waits ? "practice-point-waits" : "practice-point-grey";

/** P1 to P4: black once stored; one that is black is rejected. Beside them the bits of the PLC. */
function softkeys({ points, plc, machine, mask }: PracticeView, practice: Practice): TemplateResult {
  return html`
    <div class="jog-points" role="group" aria-label=${t("practice-points")}>
      ${points.map(
        point => html`
          <button
            type="button"
            class="jog-point"
            data-stored=${String(!!point.stored)}
            data-waits=${String(point.waits)}
            aria-label=${t(meaning(point), { point: point.name })}
            title=${placeOf(point, machine.axes) || t(meaning(point), { point: point.name })}
            @click=${() => practice.press(point.line)}
          >
            ${point.waits ? t("practice-point-waits", { point: point.name }) : point.name}
          </button>
        `,
      )}
    </div>
    <details class="jog-plc" ?hidden=${!!mask?.stores}>
      <summary>${t("practice-plc")}</summary>
      <div>
        ${points.map(
          (point, place) => html`
            <label>
              <input
                type="checkbox"
                .checked=${live(plc[place] ?? false)}
                @change=${() => practice.press(`plc ${point.name} ${plc[place] ? "off" : "on"}`)}
              />
              ${t("practice-plc-reject", { bit: place, point: point.name })}
            </label>
            <span class="jog-lamp" data-on=${String(!!plc[place + 4])}>
              ${t(plc[place + 4] ? "practice-plc-on" : "practice-plc-off", { bit: place + 4, point: point.name })}
            </span>
          `,
        )}
      </div>
    </details>
  `;
}

function placeOf({ stored }: PracticePoint, axes: readonly string[]): string {
  if (!stored) return "";
  const [letters, numbers] = stored.touch ? [["X", "Y", "Z"], stored.touch] : [axes, stored.centre ?? []];
  return numbers.map((value, place) => figureText({ axis: letters[place] ?? "", value, unit: "mm" })).join(", ");
}

function keys(jog: JogState, seen: PracticeView, practice: Practice): TemplateResult {
  const { refused } = jog;
  const { calculate } = seen.keys;
  return html`
    <div class="jog-keys" role="group" aria-label=${t("practice-keys")}>
      <button
        type="button"
        class=${calculate ? "jog-start" : "jog-start primary"}
        @click=${() => practice.press(startLine(seen), "start")}
      >
        ${iconPart("play")}${t("practice-nc-start")}
      </button>
      ${
        calculate && seen.points.length
          ? html`<button
              type="button"
              class="jog-calculate primary"
              @click=${() => practice.press("calculate")}
            >
              ${t("practice-calculate")}
            </button>`
          : nothing
      }
      <button type="button" class="jog-reset" @click=${() => practice.reset()}>RESET</button>
    </div>
    ${refused?.field === "start" ? refusal(refused) : nothing}
  `;
}

function refusal({ message, hint, left, line }: NonNullable<JogState["refused"]>): TemplateResult {
  return html`<p class="jog-told jog-refused" role="alert">
    ${iconPart("alert")}
    <span>
      ${say(message)} ${sayHint({ message, hint })} ${left ? t("jog-left-out", { line, lines: left }) : ""}
    </span>
  </p>`;
}

/** An alarm, or what was hit, with what is to be done. */
function raised({ raised: one, keys: { reset } }: PracticeView, practice: Practice): TemplateResult | typeof nothing {
  if (!one) return nothing;
  return html`
    <div class="jog-told jog-raised" role="alert">
      ${iconPart("error")}
      <span>
        ${one.code ? html`<strong>${t("practice-alarm", { alarm: one.code })}</strong>` : nothing}
        ${say(one.message)} ${one.hint ? html`<br />${sayHint(one)}` : nothing}
      </span>
      ${reset ? html`<button type="button" @click=${() => practice.reset()}>RESET</button>` : nothing}
    </div>
  `;
}

function activation(jog: JogState, seen: PracticeView, practice: Practice): TemplateResult | typeof nothing {
  const screen = seen.activation;
  if (!screen) return nothing;
  return html`
    <div class="jog-activation">
      <h4>${t("practice-activation")}</h4>
      ${screen.lines.map(line => html`<p>${say(line)}</p>`)} ${fields(jog, screen.fields, practice)}
    </div>
  `;
}

function results(shows: readonly PracticeShow[]): TemplateResult {
  return html`
    <dl class="jog-results">
      ${shows
        .filter(({ offset, figures }) => offset || figures.length)
        .map(
          ({ label, offset, figures }) => html`
          <div>
            <dt>${say(label)}${offset ? html` <code>${offset}</code>` : nothing}</dt>
            <dd>${figures.map(figure => html`<span class="figure">${figureText(figure)}</span>`)}</dd>
          </div>
        `,
        )}
    </dl>
  `;
}

const WITHIN = { mm: 0.005, deg: 0.005 } as Record<string, number>;

/** How far what was written is from where it should be. */
function deviation({ deviation: found }: PracticeView): TemplateResult | typeof nothing {
  if (!found) return nothing;
  const near = found.figures.every(({ value, unit }) => Math.abs(value) < (WITHIN[unit] ?? 0));
  return html`
    <div class="jog-deviation" data-near=${String(near)} role="status">
      ${iconPart(near ? "good" : "alert")}
      <div>
        <strong>${t(near ? "practice-near" : "practice-off", { offset: found.offset })}</strong>
        <p>${found.figures.map(figure => html`<span class="figure">${figureText(figure, true)}</span>`)}</p>
      </div>
    </div>
  `;
}

function written({ changes }: PracticeView): TemplateResult | typeof nothing {
  if (!changes.length) return nothing;
  return html`
    <table class="jog-written">
      <caption>${t("practice-written")}</caption>
      <tbody>
        ${changes.map(({ label, before, after, unit }) => {
          const told = writtenText(before, after, unit);
          return html`
            <tr>
              <th scope="row">${say(label)}</th>
              <td class="figure">${told.before} → ${told.after}</td>
            </tr>
          `;
        })}
      </tbody>
    </table>
  `;
}
