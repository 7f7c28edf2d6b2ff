// What is to become of an expression of the program where a value was typed over it: its variable is changed where that
// is assigned, the value takes its place here, or it stays. Nothing is done before one of them is chosen.

import { html, nothing, render, type TemplateResult } from "lit-html";
import type { Actions } from "../desk/actions";
import { el, on, show } from "../dom";
import { meantBy } from "../keys";
import { say, t } from "../texts";
import type { Replaced, TouchedLine, Variable } from "../wire";

/** Lines that are named at first. */
const FEW = 3;

export interface ReplacedNote {
  root: HTMLElement;
  /** `empty`: the field was emptied. */
  draw(replaced: Replaced | null, empty: boolean): void;
  waits(): boolean;
  focus(): void;
}

export function createReplaced(
  name: string,
  actions: Actions,
  goToLine: (line: number) => void,
  back: () => void,
): ReplacedNote {
  const root = el("div", { class: "replaced", role: "group", hidden: true });
  let again = (): void => undefined; // draws the same once more
  const done =
    (act: () => void): (() => void) =>
    () => {
      back(); // the button goes
      act();
    };
  on(root, "keydown", event => {
    if (meantBy(event, "form") !== "refuse") return;
    event.stopPropagation();
    done(() => actions.keep(name))();
  });

  const line = (one: number): TemplateResult =>
    html`<button type="button" class="quiet" @click=${() => goToLine(one)}>${t("asks-line", { line: one })}</button>`;

  const unfolded = new Set<string>(); // variables whose lines are shown, all of them
  const lines = (of: string, all: readonly number[]): (TemplateResult | typeof nothing)[] => {
    const few = unfolded.has(of) || all.length <= FEW + 1; // one more takes no more room than the words
    const more = (): void => {
      unfolded.add(of);
      again();
      (root.querySelectorAll<HTMLElement>(`[data-of="${CSS.escape(of)}"] button`)[FEW] ?? root).focus();
    };
    return [
      ...(few ? all : all.slice(0, FEW)).map(line),
      few
        ? nothing
        : html`<button type="button" class="quiet replaced-more" @click=${more}>
            ${t("replaced-more", { count: all.length - FEW })}
          </button>`,
    ];
  };

  const changedLine = (touched: TouchedLine): TemplateResult => html`<p class="replaced-change">
    ${line(touched.line)}
    <span class="visually-hidden">${t("asks-before")}</span><del>${touched.before}</del>
    <span class="visually-hidden">${t("asks-after")}</span><ins>${touched.after}</ins>
  </p>`;

  const variable = (one: Variable): TemplateResult => html`<li>
    ${
      one.uses.length
        ? html`<p data-of=${one.name}>
            ${t("replaced-uses", { name: one.name, count: one.uses.length })} ${lines(one.name, one.uses)}
          </p>`
        : nothing
    }
    ${
      one.change
        ? changedLine(one.change.line)
        : html`<p data-of=${`${one.name}=`}>
            ${one.why ? say(one.why) : ""} ${lines(`${one.name}=`, one.assigned)}
          </p>`
    }
  </li>`;

  const change = (one: Variable, index: number): TemplateResult | typeof nothing =>
    one.change
      ? html`<button type="button" class="replaced-assign" @click=${done(() => actions.assign(name, index))}>
          ${t("replaced-assign", { name: one.name, value: one.change.value })}
        </button>`
      : nothing;

  const note = ({ text, worth, variables }: Replaced, empty: boolean): TemplateResult => html`
    <p class="replaced-title" role="status">
      ${worth === null ? t("replaced-open", { text }) : t("replaced-title", { text, worth })}
    </p>
    <ul>${variables.map(variable)}</ul>
    <div class="actions">
      ${variables.map(change)}
      <button type="button" class="replaced-here" @click=${done(() => actions.replaceHere(name))}>
        ${t(empty ? "replaced-remove" : "replaced-here")}
      </button>
      <button type="button" class="replaced-keep" @click=${done(() => actions.keep(name))}>
        ${t("replaced-keep", { text })}
      </button>
    </div>`;

  return {
    root,
    waits: () => !root.hidden,
    focus: () => root.querySelector<HTMLElement>(".actions button")?.focus(),
    draw(replaced, empty) {
      const comes = replaced !== null && root.hidden;
      if (!replaced) unfolded.clear();
      again = () => render(replaced ? note(replaced, empty) : nothing, root);
      show(root, replaced !== null);
      again();
      // the field with what is asked about it
      if (comes && root.parentElement?.contains(document.activeElement)) bringInSight(root.parentElement);
    },
  };
}

/** All of it, where there is room for that; it is drawn first. */
function bringInSight(field: HTMLElement): void {
  requestAnimationFrame(() => field.scrollIntoView({ block: "nearest", behavior: "instant" }));
}
