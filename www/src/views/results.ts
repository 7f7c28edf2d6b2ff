// Result of a call: values, decisions, changes, alarms; beside them problems, motions and the log.

import { html, render, type TemplateResult } from "lit-html";
import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { el, on, setAttribute, setText, show } from "../dom";
import { guidePart } from "../guide";
import { meantBy } from "../keys";
import type { Scanner } from "../scan/scanner";
import { saveFile } from "../state/files";
import type { ResultTab, State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import type { WrittenFile } from "../wire";
import { createAnswer } from "./answer";
import { createFindings, located } from "./findings";
import { type Lacks, parameterId } from "./given";
import { createMotions } from "./motions";
import { createOutcome, shownOutcome } from "./outcome";
import { createScan } from "./scan";
import type { WholeWays } from "./whole";

const TABS: ResultTab[] = ["outcome", "problems", "motions", "log", "scan"];
type Draw = (state: State, derived: Derived) => void;

const PIECE = 500; // lines, as the style sheet has it

/** The first lines of a text, in pieces of which the full ones are laid out when they come into sight. */
function piecesOf(lines: readonly string[], count = lines.length): TemplateResult[] {
  return Array.from({ length: Math.ceil(count / PIECE) }, (_, at) => {
    const [from, to] = [at * PIECE, Math.min(count, (at + 1) * PIECE)];
    const kind = to - from === PIECE ? "log-piece" : "log-rest";
    return html`<span class=${kind}>${lines.slice(from, to).join("\n")}</span>`;
  });
}

/** A file of the control as it is at a step; below it what it will have later. */
function fileAt({ name, lines, at }: WrittenFile, step: number): TemplateResult {
  const shown = at.findIndex(entry => entry > step);
  const count = shown < 0 ? lines.length : shown;
  return html`<section class="log-file" data-file=${name}>
    <h3>${name} <span class="figure">${t("log-lines", { shown: count, count: lines.length })}</span></h3>
    <pre class="log" tabindex="0" aria-label=${name} ?hidden=${count === 0}>${piecesOf(lines, count)}</pre>
    <div class="actions">
      <button type="button" @click=${() => saveFile(lines.map(line => `${line}\n`).join(""), name)}>
        ${t("log-save-file", { name })}
      </button>
    </div>
  </section>`;
}

function createLog(root: HTMLElement): Draw {
  return (state, derived) => {
    if (state.panels.tab !== "log") return;
    const outcome = shownOutcome(state, derived);
    const [log, written] = [outcome?.log ?? [], outcome?.written ?? []];
    const none = log.length === 0;
    render(
      html`${guidePart("log")}
        <p class="empty" ?hidden=${!none || written.length > 0}>${t("log-none")}</p>
        ${written.map(file => fileAt(file, derived.step))}
        <pre class="log" tabindex="0" aria-label=${t("tab-log")} ?hidden=${none}>${piecesOf(log)}</pre>
        <div class="actions" ?hidden=${none}>
          <button type="button" @click=${() => saveFile(`${log.join("\n")}\n`, "print.txt")}>${t("log-save")}</button>
        </div>`,
      root,
    );
  };
}

/** `answered`: where the line stands that says what the call came to. */
export function createResults(
  root: HTMLElement,
  answered: HTMLElement,
  store: Store,
  actions: Actions,
  scanner: Scanner,
  goTo: (offset: number) => void,
  goToLine: (line: number) => void,
  given: Pick<Lacks, "pickFiles" | "machineValues">,
  ways: Omit<WholeWays, "real" | "certain">,
): Draw {
  const bar = el("div", { role: "tablist", class: "tabs", "aria-label": t("panel-results") });
  const answer = createAnswer(actions.give);
  root.append(el("h2", { class: "visually-hidden" }, t("panel-results")), bar);
  answered.append(answer.root);
  const tabs = new Map<ResultTab, { button: HTMLButtonElement; page: HTMLElement }>();
  for (const name of TABS) {
    const button = el("button", { type: "button", role: "tab", id: `tab-${name}`, "aria-controls": `page-${name}` });
    const page = el("div", {
      role: "tabpanel",
      id: `page-${name}`,
      "aria-labelledby": `tab-${name}`,
      class: "scroll",
      tabindex: "0",
    });
    on(button, "click", () => store.update({ panels: { tab: name } }));
    bar.append(button);
    root.append(page);
    tabs.set(name, { button, page });
  }
  on(bar, "keydown", event => {
    const command = meantBy(event, "tabs");
    if (!command) return;
    const move = command === "next-tab" ? 1 : -1;
    const there = TABS.filter(name => !tabs.get(name)?.button.hidden);
    const next = there[(there.indexOf(store.state.panels.tab) + move + there.length) % there.length] ?? "outcome";
    store.update({ panels: { tab: next } });
    tabs.get(next)?.button.focus();
  });
  const page = (name: ResultTab): HTMLElement => tabs.get(name)?.page ?? root;
  const lacks: Lacks = {
    ...given,
    parameter(name) {
      store.update({ panels: { tab: "outcome" } });
      store.flush();
      document.getElementById(parameterId(name))?.focus();
    },
  };
  const draws: Draw[] = [
    createOutcome(page("outcome"), store, actions, goToLine, lacks, {
      ...ways,
      real: answer.setReal,
      certain: answer.setCertain,
    }),
    createFindings(page("problems"), actions, goTo, lacks),
    createMotions(page("motions"), store),
    createLog(page("log")),
    createScan(page("scan"), store, scanner),
  ];
  return (state, derived) => {
    answer.draw(state, derived);
    const problems = located(state, derived, actions, goTo).length;
    for (const [name, { button, page: body }] of tabs) {
      const chosen =
        name === (state.panels.tab === "scan" && !derived.cycle.surfaces.length ? "outcome" : state.panels.tab);
      show(button, name !== "scan" || derived.cycle.surfaces.length > 0);
      setText(
        button,
        name === "problems" && problems > 0 ? t("tab-problems-count", { count: problems }) : t(`tab-${name}`),
      );
      setAttribute(button, "aria-selected", String(chosen));
      setAttribute(button, "tabindex", chosen ? 0 : -1);
      show(body, chosen);
    }
    for (const draw of draws) draw(state, derived);
  };
}
