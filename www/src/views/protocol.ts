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
import { saveFile } from "../state/files";
import type { State } from "../state/state";
import { say, sayProblem, t } from "../texts";
import type { Arrow, ProtocolColumns, ProtocolRequest, ProtocolView } from "../wire";
import type { Real } from "./answer";

const ROLES = ["number", "line", "result", "nominal", "actual", "deviation"] as const;
const SHOWN = 200; // lines that do not fit; all of them are saved
const LARGEST = 100 * 2 ** 20; // bytes

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
  /** `run`: it is about this one, and is over with another. */
  draw(state: State, derived: Derived): void;
}

/** A text as control and office write it. */
export async function textOf(file: File): Promise<string> {
  const bytes = await file.arrayBuffer();
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder("windows-1252").decode(bytes);
  }
}

/** `changed`: what it came to is another. */
export function createProtocol({ core, arrows, real }: ProtocolWays, changed: () => void): Protocol {
  const picker = el("input", { type: "file", hidden: true, tabindex: "-1", "aria-label": t("protocol-open") });
  const body = el("div");
  const root = el("section", { class: "protocol", "aria-label": t("protocol-title"), hidden: true }, body, picker);
  let prover: Prover | null = null;
  let file: { name: string; text: string } | null = null;
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
    const asked: ProtocolRequest = { run, protocol: file.text, ...chosen };
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
      const bad = view.answers.map(({ verdict }) => ["beyond", "rework", "scrap"].includes(verdict));
      arrows(view.arrows.map(one => ({ ...one, bad: bad[one.call] ?? false })));
      real({ answers: view.answers, file: name });
    }
    show();
    changed();
  };
  picker.addEventListener("change", () => {
    const [chosen] = picker.files ?? [];
    picker.value = "";
    if (!chosen) return;
    void (async () => {
      columns = {};
      view = null;
      file = { name: chosen.name, text: "" };
      of = now?.derived.run ?? null;
      problem = chosen.size > LARGEST ? t("protocol-too-large", { most: LARGEST / 2 ** 20 }) : "";
      if (problem) return show();
      file = { name: chosen.name, text: await textOf(chosen) };
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
    ><select .value=${columns[role] ?? ""} @change=${chosen(role)}>
      <option value="">–</option>
      ${heads.map((head, index) => html`<option value=${String(index + 1)}>${`${index + 1}: ${head}`}</option>`)}
    </select></label
  >`;
  const unfit = ({ unfit: all }: ProtocolView): TemplateResult | typeof nothing => {
    if (!all.length) return nothing;
    const text = (): string => all.map(({ line, text, why }) => `${line}: ${say(why)} | ${text}\n`).join("");
    const save = (): void => saveFile(text(), "lines.txt");
    return html`<details class="protocol-unfit">
      <summary>${t("protocol-unfit", { count: all.length })}</summary>
      <ol>
        ${all
          .slice(0, SHOWN)
          .map(
            ({ line, text, why }) =>
              html`<li value=${line}><b>${line}</b> <code>${text}</code> <span>${say(why)}</span></li>`,
          )}
      </ol>
      ${all.length > SHOWN ? html`<button type="button" @click=${save}>${t("protocol-unfit-save")}</button>` : nothing}
    </details>`;
  };
  function show(): void {
    root.hidden = !file;
    const heads = view?.heads ?? [];
    render(
      file
        ? html`<p class="protocol-top">
              <strong>${t("protocol-of", { name: file.name })}</strong>
              <span role="status">${busy ? t("protocol-busy") : view ? say(view.ending) : ""}</span>
              <button type="button" @click=${over}>${iconPart("close")}<span>${t("protocol-close")}</span></button>
              ${guidePart("measured")}
            </p>
            <p role="alert" ?hidden=${!problem}>${problem}</p>
            ${view ? unfit(view) : nothing}
            ${
              heads.length > 1
                ? html`<details class="protocol-columns">
                    <summary>${t("protocol-columns")}</summary>
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
