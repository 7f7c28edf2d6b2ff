// The files beside the program: what lies there, which one is shown, and how more come there.

import { html, nothing, render, type TemplateResult } from "lit-html";
import { repeat } from "lit-html/directives/repeat.js";
import type { Actions } from "../desk/actions";
import { isDefinition } from "../desk/beside";
import type { Derived } from "../desk/derive";
import { el, on, show } from "../dom";
import { icon, iconPart } from "../icons";
import { fileOf } from "../state/files";
import { ENDINGS } from "../state/places";
import { besideOf, type State } from "../state/state";
import { t } from "../texts";

export interface BesideView {
  /** Lets the user pick files. */
  button: HTMLButtonElement;
  root: HTMLElement;
  draw(state: State, derived: Derived): void;
  pick(): void;
}

/** A file or a program in the list. */
interface Entry {
  name: string;
  shown: boolean;
  at?: { from: number; line: number }; // a program of the text that is shown
}

function entries(state: State, { read, fresh }: Derived): Entry[] {
  const beside = besideOf(state).with ?? [];
  const programs = fresh ? (read.programs ?? []) : [];
  const shown: Entry[] = beside.length ? [{ name: fileOf(state).name, shown: true }] : [];
  const files = [...shown, ...beside.map(({ name }) => ({ name, shown: false }))];
  const named = files.sort((a, b) => a.name.localeCompare(b.name));
  return [...named, ...programs.map(({ name, from, line }) => ({ name, shown: false, at: { from, line } }))];
}

/** `define`: its definitions are to become part of the machine. */
export function createBeside(
  actions: Actions,
  take: (files: File[]) => void,
  define: (name: string) => void,
  goTo: (offset: number) => void,
): BesideView {
  const name = t("beside-add");
  const button = el(
    "button",
    { type: "button", class: "quiet icon-button", id: "beside-add", "aria-label": name, title: t("beside-add-help") },
    icon("plus"),
  );
  const input = el("input", {
    type: "file",
    multiple: true,
    accept: [...ENDINGS, "text/plain"].join(),
  }); // it only asks, and is shown nowhere
  const root = el("section", { class: "beside", "aria-label": t("beside-title"), hidden: true });
  const pick = (): void => input.click();
  on(button, "click", pick);
  on(input, "change", () => {
    const files = [...(input.files ?? [])];
    if (files.length) take(files);
    input.value = "";
  });

  const ofFile = (one: Entry): TemplateResult => html`<li class="beside-file" ?data-shown=${one.shown}>
    <button
      type="button"
      class="quiet beside-name"
      aria-current=${one.shown ? "true" : nothing}
      title=${t(one.shown ? "beside-shown" : "beside-show", { name: one.name })}
      @click=${() => actions.showFile(one.name)}
    ><span>${one.name}</span></button>
    ${
      isDefinition(one.name) && !one.shown
        ? html`<button type="button" class="quiet beside-define" @click=${() => define(one.name)}>
            ${t("beside-define")}
          </button>`
        : nothing
    }
    ${
      one.shown
        ? nothing
        : html`<button
            type="button"
            class="quiet icon-button"
            aria-label=${t("beside-remove", { name: one.name })}
            title=${t("beside-remove", { name: one.name })}
            @click=${() => {
              actions.removeFile(one.name);
              button.focus(); // the one that had the focus goes with its file
            }}
          >
            ${iconPart("close")}
          </button>`
    }
  </li>`;
  const ofProgram = ({ name, at }: Entry): TemplateResult => html`<li class="beside-file beside-program">
    <button type="button" class="quiet beside-name" @click=${() => goTo(at?.from ?? 0)}>
      <span>${name}</span><span class="count">${t("program-call-line", { line: at?.line ?? 1 })}</span>
    </button>
  </li>`;

  return {
    button,
    root,
    pick,
    draw(state, derived) {
      const all = entries(state, derived);
      show(root, all.length > 0);
      render(
        html`<ul>
          ${repeat(
            all,
            one => `${one.at?.from ?? ""} ${one.name}`,
            one => (one.at ? ofProgram(one) : ofFile(one)),
          )}
        </ul>`,
        root,
      );
    },
  };
}
