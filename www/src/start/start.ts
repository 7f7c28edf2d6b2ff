// The start screen: what is to be measured, what that corrects, what is left to choose; beside it the other ways in.

import { html, nothing, render, type TemplateResult } from "lit-html";
import { guard } from "lit-html/directives/guard.js";
import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { variantOf } from "../desk/variants";
import { iconPart } from "../icons";
import { type Command, meantBy } from "../keys";
import { type Recent, recentItems, removeRecent } from "../state/recent";
import type { State } from "../state/state";
import { language, t } from "../texts";
import type { CycleInfo, Dialect, Element as Measured } from "../wire";
import { answered, firstWay, isAt, openWay, questions, type Way, waysOf } from "./aims";
import { elementsOf, PICTOGRAMS, pictogram, shownOf } from "./pictogram";
import "../styles/start.css";

const CONTROLS: Dialect[] = ["sinumerik", "nct"];

/** What the start screen leads to. */
export interface Leads {
  /** A program or form that was worked on lately is opened again. */
  again(item: Recent): void;
  /** The work: form, program, motions. */
  toWork(): void;
  /** A program is picked to be opened. */
  openProgram(): void;
  /** The machine to practise on. */
  practise(): void;
  /** The worked example is told of a way. */
  tell(way: Way): void;
}

interface Chosen {
  element: Measured;
  way: Way | undefined;
}

/** What is chosen; it outlives this screen, which another language makes anew. */
let chosen: Chosen | null = null;

export function createStart(
  root: HTMLElement,
  actions: Actions,
  leads: Leads,
): (state: State, derived: Derived) => void {
  let ways: readonly Way[] = [];
  let known: unknown = null; // cycles and control that the ways are of
  let shown: { state: State; derived: Derived } | null = null;

  const choose = (change: Partial<Chosen>): void => {
    if (chosen) chosen = { ...chosen, ...change };
    draw();
  };
  const chooseElement = (element: Measured): void =>
    choose({ element, way: firstWay(ways, shownOf(element), chosen?.way?.corrects) });
  const open = (): void => {
    const way = chosen?.way;
    if (!way || !shown) return;
    const { state, derived } = shown;
    const here = derived.cycle === way.cycle && variantOf(derived) === way.variant && state.form.open === null;
    if (!here || !isAt(ways, way, state.form.values)) openWay(actions, way);
    actions.panel("form");
    leads.toWork();
  };

  const tile = (one: (typeof PICTOGRAMS)[number], current: boolean): TemplateResult => html`
    <button
      type="button"
      role="radio"
      class="tile"
      data-element=${one.element}
      aria-checked=${String(current)}
      tabindex=${current ? 0 : -1}
      @click=${() => chooseElement(one.element)}
      @dblclick=${open}
    >
      ${guard([one], () => pictogram(one))}
      <span class="tile-name">${t(one.keys[0])}</span>
      <span class="tile-what">${t(one.keys[1])}</span>
    </button>
  `;

  const moved = (event: KeyboardEvent): void => {
    const grid = event.currentTarget as HTMLElement;
    const tiles = [...grid.querySelectorAll<HTMLElement>(".tile")];
    const at = tiles.indexOf(event.target as HTMLElement);
    const top = tiles[0]?.offsetTop;
    const row = Math.max(1, tiles.filter(one => one.offsetTop === top).length);
    const ways: Record<string, number> = {
      ArrowLeft: at - 1,
      ArrowRight: at + 1,
      ArrowUp: at - row,
      ArrowDown: at + row,
    };
    const command = meantBy(event, "list");
    const ends: Partial<Record<Command<"list">, number>> = { first: 0, last: tiles.length - 1 };
    const next = tiles[ways[event.key] ?? (command ? (ends[command] ?? -1) : -1)];
    if (event.key === "Enter") {
      event.preventDefault();
      chooseElement((event.target as HTMLElement).dataset.element as Measured);
      root.querySelector<HTMLElement>(".start-answer button.primary")?.focus();
    }
    if (!next) return;
    event.preventDefault();
    chooseElement(next.dataset.element as Measured);
    next.focus();
  };

  /** Buttons of which one is pressed. */
  const answers = (label: string, all: { key: string; pressed: boolean; pick: () => void }[]): TemplateResult => html`
    <div class="start-answers" role="group" aria-label=${label}>
      ${all.map(
        ({ key, pressed, pick }) =>
          html`<button type="button" class="chip" aria-pressed=${String(pressed)} @click=${pick}>${t(key)}</button>`,
      )}
    </div>
  `;

  const corrections = ({ element, way }: Chosen): TemplateResult => {
    const all = [...new Map(ways.filter(one => one.element === element).map(one => [one.corrects, one.key]))];
    return answers(
      t("start-corrects"),
      all.map(([corrects, key]) => ({
        key,
        pressed: way?.corrects === corrects,
        pick: () => choose({ way: nearestWith(way, corrects) }),
      })),
    );
  };
  /** With another correction, what is left to choose stays as far as it can. */
  const nearestWith = (way: Way | undefined, corrects: Way["corrects"]): Way | undefined => {
    const first = chosen && firstWay(ways, shownOf(chosen.element), corrects);
    if (!first || !way) return first ?? undefined;
    return Object.entries(way.options).reduce((to, [question, answer]) => answered(ways, to, question, answer), first);
  };

  const options = (way: Way): TemplateResult[] =>
    questions(ways, way).map(
      ({ key, answers: given }) => html`
        <div class="start-option">
          <span aria-hidden="true">${t(key)}</span>
          ${answers(
            t(key),
            given.map(answer => ({
              key: answer,
              pressed: way.options[key] === answer,
              pick: () => choose({ way: answered(ways, way, key, answer) }),
            })),
          )}
        </div>
      `,
    );

  const answer = (now: Chosen, coming: boolean): TemplateResult => {
    const name = PICTOGRAMS.find(one => one.element === now.element)?.keys[0] ?? "";
    const { way } = now;
    const left = way ? options(way) : [];
    return html`
      <section class="start-answer" aria-label=${t("start-corrects")} aria-busy=${coming && !way ? "true" : nothing}>
        <div class="start-row">
          <strong>${t(name)}</strong>
          <span class="start-question">${t("start-corrects")}</span>
          ${way ? corrections(now) : html`<span role="status">${t(coming ? "start-coming" : "tasks-absent")}</span>`}
        </div>
        ${left.length ? html`<div class="start-row start-options">${left}</div>` : nothing}
        <div class="start-row start-end">
          ${
            way
              ? html`<span class="start-variant">${t(way.variant.key)}</span>
                  <code class="start-code">
                    ${way.cycle.numbered ? `${way.cycle.cycle} · ${way.variant.mvar}` : way.cycle.cycle}
                  </code>`
              : nothing
          }
          <button type="button" class="primary" ?disabled=${!way} @click=${open}>
            ${t("start-open-form")}${iconPart("start")}
          </button>
        </div>
      </section>
    `;
  };

  const controls = (control: Dialect): TemplateResult => html`
    <div class="start-control" role="group" aria-label=${t("fact-control")}>
      ${CONTROLS.map(
        one => html`
          <button
            type="button"
            class="chip"
            aria-pressed=${String(one === control)}
            @click=${() => actions.chooseControl(one)}
          >
            ${t(`control-${one}`)}
          </button>
        `,
      )}
    </div>
  `;

  let recent: readonly Recent[] = [];
  const look = async (): Promise<void> => {
    recent = await recentItems();
    draw();
  };
  const remove = async (item: Recent): Promise<void> => {
    await removeRecent(item.id);
    await look();
    root.querySelector<HTMLElement>(".start-recent button, .start-open-program")?.focus();
  };
  const lately = (cycles: readonly CycleInfo[]): TemplateResult => html`
    <section class="start-card start-recent">
      <h3 id="start-recent">${t("start-recent")}</h3>
      <ul aria-labelledby="start-recent">
        ${recent.map(item => {
          const { name, what } = told(item, cycles);
          return html`
            <li>
              <button type="button" class="quiet" @click=${() => leads.again(item)}>
                ${iconPart("text" in item ? "file" : "measure")}
                <span><strong>${name}</strong><span>${what}</span></span>
                <time>${day(item.at)}</time>
              </button>
              <button
                type="button"
                class="quiet"
                title=${t("start-remove", { name })}
                aria-label=${t("start-remove", { name })}
                @click=${() => void remove(item)}
              >
                ${iconPart("close")}
              </button>
            </li>
          `;
        })}
      </ul>
    </section>
  `;

  /** The worked example: a bore that corrects a zero offset. */
  const example = (): TemplateResult | typeof nothing => {
    const way = ways.find(one => one.corrects === "zero" && one.element === "hole");
    if (!way) return nothing;
    return html`
      <section class="start-card">
        <h3>${t("story-title")}</h3>
        <p>${t("story-lead")}</p>
        <button type="button" class="start-story" @click=${() => leads.tell(way)}>
          ${iconPart("start")}${t("story-start")}
        </button>
      </section>
    `;
  };

  /** Measuring in JOG, where the control has it. */
  const practice = (): TemplateResult => html`
    <section class="start-card">
      <h3>${t("practice-title")}</h3>
      <p>${t("practice-lead")}</p>
      <button type="button" class="start-practice" @click=${leads.practise}>
        ${iconPart("hand")}${t("practice-start")}
      </button>
    </section>
  `;

  const side = (cycles: readonly CycleInfo[], practises: boolean): TemplateResult => html`
    <aside class="start-side" aria-label=${t("start-others")}>
      <section class="start-card">
        <h3>${t("start-program")}</h3>
        <p class="start-drop">${iconPart("file")}<strong>${t("start-drop")}</strong><span>${t("start-stays")}</span></p>
        <button type="button" class="start-open-program" @click=${leads.openProgram}>
          ${iconPart("open")}${t("start-open")}
        </button>
      </section>
      ${example()}
      ${practises ? practice() : nothing}
      ${recent.length ? lately(cycles) : nothing}
      <button
        type="button"
        class="quiet start-variants"
        @click=${() => {
          actions.panel("tasks");
          leads.toWork();
        }}
      >
        ${iconPart("calls")}${t("start-variants")}${iconPart("right")}
      </button>
    </aside>
  `;

  const draw = (): void => {
    if (!shown) return;
    const { derived } = shown;
    const { control } = derived.cycle;
    const elements = elementsOf(control);
    const [first] = elements;
    if (!first) return;
    chosen ??= { element: first.element, way: undefined };
    const mark = `${control} ${derived.catalogue.cycles.length}`;
    if (known !== mark) {
      ways = waysOf(derived.catalogue, control);
      known = mark;
    }
    if (!elements.some(({ element }) => element === chosen?.element))
      chosen = { ...chosen, element: first.element, way: undefined };
    const { way, element } = chosen;
    const same = (one: Way): boolean =>
      one.cycle.cycle === way?.cycle.cycle && one.variant.mvar === way.variant.mvar && one.corrects === way.corrects;
    const now: Chosen = { ...chosen, way: ways.find(same) ?? firstWay(ways, shownOf(element), way?.corrects) };
    chosen = now;
    render(
      html`
        <div class="start-main">
          <div class="start-head">
            <div>
              <h2 id="start-title">${t("start-title")}</h2>
              <p>${t("start-lead")}</p>
            </div>
            ${controls(control)}
          </div>
          <div class="start-grid" role="radiogroup" aria-labelledby="start-title" @keydown=${moved}>
            ${elements.map(one => tile(one, one.element === now.element))}
          </div>
          ${answer(now, derived.simulates === "coming")}
        </div>
        ${side(derived.catalogue.cycles, derived.catalogue.practises.includes(control))}
      `,
      root,
    );
  };
  void look();
  let place: State["page"]["place"] = "start";
  return (state, derived) => {
    shown = { state, derived };
    if (place !== state.page.place && state.page.place === "start") void look();
    place = state.page.place;
    if (place === "start") draw();
  };
}

/** What a recent item is called, and what is said of it. */
function told(item: Recent, cycles: readonly CycleInfo[]): { name: string; what: string } {
  if ("text" in item) return { name: item.name, what: t("start-counts", { calls: item.calls, lines: item.lines }) };
  const cycle = cycles.find(one => one.control === item.control && one.cycle === item.cycle);
  const variant = cycle?.variants.find(one => one.mvar === item.mvar);
  return { name: variant ? t(variant.key) : item.cycle, what: t("start-form", { cycle: item.cycle }) };
}

const DAY = 24 * 3600 * 1000; // ms

/** The day as one says it: today, the day of the week, the date. */
function day(at: number): string {
  const midnight = (time: number): number => new Date(time).setHours(0, 0, 0, 0);
  const days = Math.round((midnight(Date.now()) - midnight(at)) / DAY);
  if (days < 2) return new Intl.RelativeTimeFormat(language(), { numeric: "auto" }).format(-days, "day");
  const parts: Intl.DateTimeFormatOptions = days < 7 ? { weekday: "short" } : { day: "numeric", month: "short" };
  return new Intl.DateTimeFormat(language(), parts).format(at);
}
