// A protocol of the real machine laid onto the calls of the program: which lines fit and which do not, what stands in
// which column where the figures do not tell it, and its values in the place of the simulated ones.

import { html, nothing, render, type TemplateResult } from "lit-html";
import type { ProgramCore } from "../core/program";
import { createProver, type Prover } from "../core/proving";
import type { Derived } from "../desk/derive";
import { givenTo, machineTo } from "../desk/given";
import { el } from "../dom";
import { guidePart } from "../guide";
import { iconPart } from "../icons";
import { readTexts, saveFile } from "../state/files";
import type { State } from "../state/state";
import { say, sayProblem, t } from "../texts";
import type { Arrow, ProtocolColumns, ProtocolLine, ProtocolRequest, ProtocolView } from "../wire";
import type { Real } from "./answer";

const ROLES = ["number", "line", "result", "nominal", "actual", "deviation"] as const;
const SHOWN = 200; // lines that are told; all of them are saved
const LARGEST = 100 * 2 ** 20; // bytes

/** The files of a log in their order: LOG_1.MPF, LOG_1_1.MPF, LOG_1_2.MPF. */
const byName = new Intl.Collator("en", { numeric: true });
const stem = (name: string): string => name.replace(/\.[^.]*$/, "");

/** What a protocol needs of the page. */
export interface ProtocolWays {
  core(): ProgramCore | null;
  /** The arrows of the 3D view; none: there is no protocol. */
  arrows(all: readonly (Arrow & { bad: boolean })[] | null): void;
  /** What it tells of the calls, for the line of the answer; none: there is no protocol. */
  real(told: Real | null): void;
}

export interface Protocol {
  readonly root: HTMLElement;
  /** What it came to; null: there is none, and what was simulated counts. */
  readonly view: ProtocolView | null;
  pick(): void;
  /** It is about the run that there is, and over with another. */
  draw(state: State, derived: Derived): void;
}

/** `changed`: what it came to is another. */
export function createProtocol({ core, arrows, real }: ProtocolWays, changed: () => void): Protocol {
  const picker = el("input", {
    type: "file",
    multiple: true,
    hidden: true,
    tabindex: "-1",
    "aria-label": t("protocol-open"),
  });
  const body = el("div");
  const root = el("section", { class: "protocol", "aria-label": t("protocol-title"), hidden: true }, body, picker);
  let prover: Prover | null = null;
  let file: { name: string; names: string[]; texts: string[] } | null = null;
  let view: ProtocolView | null = null;
  let columns: ProtocolColumns = {};
  let problem = "";
  let busy = false;
  let now: { state: State; derived: Derived } | null = null;
  let of: Derived["run"] = null;

  const over = (): void => {
    prover?.stop();
    [file, view, columns, problem, busy] = [null, null, {}, "", false];
    arrows(null);
    real(null);
    show();
    changed();
  };
  const lay = async (): Promise<void> => {
    const module = core()?.module;
    if (!file || !now || !module) return;
    const { state, derived } = now;
    const { known: _, ...given } = givenTo(state);
    const setup = machineTo(state, derived.view);
    const run = { control: state.form.control, text: derived.program, ...(setup ? { setup } : {}), ...given };
    const chosen = Object.keys(columns).length ? { columns } : {};
    const asked: ProtocolRequest = { run, protocol: file.texts, names: file.names, ...chosen };
    [busy, problem] = [true, ""];
    show();
    prover ??= createProver(module);
    const name = file.name;
    const proved = await prover.ask({ protocol: asked });
    if (file?.name !== name) return; // another one meanwhile
    busy = false;
    if ("problem" in proved) problem = sayProblem(proved.problem);
    else {
      view = JSON.parse(proved.json) as ProtocolView;
      if (!Object.keys(columns).length) columns = { ...view.recognised };
      const bad = view.answers.map(({ verdict }) => ["beyond", "rework", "scrap"].includes(verdict));
      arrows(view.arrows.map(one => ({ ...one, bad: bad[one.call] ?? false })));
      real({ answers: view.answers, file: name });
    }
    show();
    changed();
  };
  picker.addEventListener("change", () => {
    const chosen = [...(picker.files ?? [])].sort((one, other) => byName.compare(stem(one.name), stem(other.name)));
    picker.value = "";
    if (!chosen.length) return;
    void (async () => {
      const size = chosen.reduce((sum, one) => sum + one.size, 0);
      const reader = core();
      problem = size > LARGEST ? t("protocol-too-large", { most: LARGEST / 2 ** 20 }) : "";
      if (problem || !reader) return show();
      const texts = await readTexts(chosen, reader);
      if ("key" in texts) {
        problem = t(texts.key, texts.args); // what was laid before stays
        return show();
      }
      const names = chosen.map(one => one.name);
      [columns, view] = [{}, null];
      file = { name: names.join(", "), names, texts };
      of = now?.derived.run ?? null;
      await lay();
    })();
  });

  const choose = (role: (typeof ROLES)[number], value: string): void => {
    const { [role]: _, ...others } = columns;
    columns = value ? { ...others, [role]: value } : others;
    const enough = columns.actual || (columns.nominal && columns.deviation);
    if (enough || !Object.keys(columns).length) void lay();
    else show();
  };
  const chosen =
    (role: (typeof ROLES)[number]) =>
    (event: Event): void =>
      choose(role, (event.target as HTMLSelectElement).value);
  const column = (role: (typeof ROLES)[number], heads: readonly string[]): TemplateResult => html`<label
    ><span>${t(`protocol-column-${role}`)}</span
    ><select @change=${chosen(role)}>
      <option value="" .selected=${!columns[role]}>–</option>
      ${heads.map((head, index) => {
        const number = String(index + 1);
        return html`<option value=${number} .selected=${columns[role] === number}>${`${number}: ${head}`}</option>`;
      })}
    </select></label
  >`;
  /** Lines that do not fit, or are in doubt, with why. */
  const told = (all: readonly ProtocolLine[], title: string): TemplateResult | typeof nothing => {
    if (!all.length) return nothing;
    const names = file && file.names.length > 1 ? file.names : [];
    const place = (one: ProtocolLine): string =>
      names.length ? `${names[one.file] ?? ""}:${one.line}` : String(one.line);
    const text = (): string => all.map(one => `${place(one)}: ${say(one.why)} | ${one.text}\n`).join("");
    const save = (): void => saveFile(text(), "lines.txt");
    return html`<details class="protocol-lines">
      <summary>${t(title, { count: all.length })}</summary>
      <ol>
        ${all
          .slice(0, SHOWN)
          .map(one => html`<li><b>${place(one)}</b> <code>${one.text}</code> <span>${say(one.why)}</span></li>`)}
      </ol>
      ${all.length > SHOWN ? html`<button type="button" @click=${save}>${t("protocol-unfit-save")}</button>` : nothing}
    </details>`;
  };
  function show(): void {
    root.hidden = !file && !problem;
    const heads = view?.heads ?? [];
    render(
      file || problem
        ? html`<p class="protocol-top">
              <strong>${file ? t("protocol-of", { name: file.name }) : t("protocol-title")}</strong>
              <span role="status">${busy ? t("protocol-busy") : view ? say(view.ending) : ""}</span>
              <button type="button" @click=${over}>${iconPart("close")}<span>${t("protocol-close")}</span></button>
              ${guidePart("measured")}
            </p>
            <p role="alert" ?hidden=${!problem}>${problem}</p>
            ${view?.gap ? html`<p role="alert">${say(view.gap)}</p>` : nothing}
            ${view ? [told(view.unfit, "protocol-unfit"), told(view.doubtful, "protocol-doubtful")] : nothing}
            ${
              heads.length > 1
                ? html`<details class="protocol-columns" ?open=${view?.fitted === 0}>
                    <summary>${t("protocol-columns")}</summary>
                    ${view?.fitted === 0 ? html`<p>${t("protocol-columns-ask")}</p>` : nothing}
                    <div>${ROLES.map(role => column(role, heads))}</div>
                  </details>`
                : nothing
            }`
        : nothing,
      body,
    );
  }
  return {
    root,
    get view() {
      return view;
    },
    pick: () => picker.click(),
    draw(state, derived) {
      now = { state, derived };
      if (file && derived.run && of && derived.run !== of) over();
    },
  };
}
