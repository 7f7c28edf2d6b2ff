// The machine as tables: its own data, tools, zero offsets, probes and part. Which fields there are, their words, units
// and limits say the core.

import { html, nothing, render, type TemplateResult } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { repeat } from "lit-html/directives/repeat.js";
import type { ProgramCore } from "../core/program";
import type { Actions } from "../desk/actions";
import { el, on, setAttribute, setOff, setText } from "../dom";
import { type IconName, iconPart } from "../icons";
import { meantBy } from "../keys";
import { plain } from "../numbers";
import { profile, programMachine, type State } from "../state/state";
import type { Store } from "../state/store";
import { optional, say, sayHint, t } from "../texts";
import { unlessTyping } from "../unless-typing";
import type {
  EquipmentCell,
  EquipmentChange,
  EquipmentRow,
  EquipmentRows,
  EquipmentTable,
  EquipView,
  FormRequest,
  Message,
} from "../wire";
import { rangeText } from "./field";
import { profileName } from "./profile";

export interface Equipment {
  /** Shows the screen. */
  open(): void;
  /** Whether there is something to undo. */
  draw(state: State): void;
}

/** A text that was not taken, and why. */
interface Wrong {
  table: EquipmentTable;
  row: string;
  cell: string;
  text: string;
  why: string;
}

const ICON: Record<string, IconName> = {
  "equipment-earlier": "up",
  "equipment-later": "down",
  "equipment-copy": "copy",
  "equipment-remove": "delete",
};
const AS_TABLE: EquipmentTable[] = ["tools", "offsets"];
const cellId = (table: string, row: string, cell: string): string =>
  `${table}-${row}-${cell}`.replace(/[^A-Za-z0-9_-]/g, "-");

const unitText = (unit: string): string => (unit ? t(`unit-${unit.replace("/", "-per-").toLowerCase()}`) : "");

/** The call in the form, as it is asked about. */
function callOf({ form: { control, cycle, values, around } }: State): FormRequest {
  return { control, cycle, values, ...(around ?? {}) };
}

export function createEquipment(
  store: Store,
  actions: Actions,
  core: () => ProgramCore | null,
  machineData: { open(): void },
): Equipment {
  const title = el("h2", { id: "equipment-title" });
  const tabs = el("div", { role: "tablist", class: "tabs", "aria-label": t("equipment-title") });
  const body = el("div", { class: "equipment-body scroll", role: "tabpanel", id: "equipment-page", tabindex: "0" });
  const data = el("button", { type: "button" }, t("machine-data-title"));
  const undo = el("button", { type: "button" }, t("undo"));
  const close = el("button", { type: "button", class: "primary", id: "equipment-close" }, t("machine-data-close"));
  const dialog = el(
    "dialog",
    { class: "equipment", "aria-labelledby": "equipment-title" },
    el("header", {}, title, tabs),
    body,
    el("div", { class: "actions" }, data, undo, close),
  );
  document.body.append(dialog);

  let view: EquipView | null = null;
  let tab: EquipmentTable = "machine";
  let wrong: Wrong | null = null;
  const shape = el("select", { id: "equipment-shape", "aria-label": t("equipment-shape") });

  const ask = (change?: EquipmentChange): EquipView | null => {
    const { state } = store;
    const { control } = state.form;
    const machine = programMachine(state);
    return (
      core()?.equip({
        control,
        ...machine,
        ...(change ? { change } : {}),
        ...(change === "measured" ? { call: { ...callOf(state), ...machine } } : {}),
      }) ?? null
    );
  };
  const make = (change: EquipmentChange, told: Message): EquipView | null => {
    const answer = ask(change);
    if (!answer) return null;
    wrong = null;
    view = answer;
    if (answer.problem) return answer;
    const named = profile(store.state) !== undefined;
    actions.equip(answer.setup, told);
    if (tab === "part") store.update({ view: { source: "program" } });
    if (!named) view = ask() ?? answer; // it has a name now
    return answer;
  };
  const edit = (table: EquipmentTable, row: EquipmentRow, cell: EquipmentCell, text: string): void => {
    if (text === cell.value) return;
    const told = { key: "step-equip-set", args: { cell: t(cell.key), row: say(row.title) } };
    const answer = make({ set: { table, row: row.id, cell: cell.key, text } }, told);
    if (answer?.problem) {
      const { message, hint } = answer.problem;
      wrong = { table, row: row.id, cell: cell.key, text, why: `${say(message)} ${sayHint({ message, hint })}` };
    }
    drawAll();
  };
  /** The focus goes to the row that came or moved. */
  const change = (asked: EquipmentChange, told: Message): void => {
    const answer = make(asked, told);
    drawAll();
    const row = answer?.row;
    const first = row === undefined ? null : body.querySelector(`[data-row="${CSS.escape(row)}"]`);
    (first?.querySelector<HTMLElement>("input, select") ?? body).focus();
  };
  const rowsOf = (table: EquipmentTable): EquipmentRows | undefined => view?.tables.find(one => one.table === table);

  function drawAll(): void {
    if (!view || !dialog.open) return;
    setText(title, t("equipment-of", { name: profileName(profile(store.state)) }));
    for (const button of tabs.querySelectorAll("button")) {
      const chosen = button.dataset.table === tab;
      setAttribute(button, "aria-selected", String(chosen));
      setAttribute(button, "tabindex", chosen ? 0 : -1);
    }
    setAttribute(body, "aria-labelledby", `equipment-tab-${tab}`);
    const now = rowsOf(tab);
    if (now) render(AS_TABLE.includes(tab) ? gridOf(now) : listOf(now), body);
  }

  function input(table: EquipmentTable, row: EquipmentRow, cell: EquipmentCell, named: boolean): TemplateResult {
    const id = cellId(table, row.id, cell.key);
    const bad = wrong?.table === table && wrong.row === row.id && wrong.cell === cell.key ? wrong : null;
    const value = bad?.text ?? cell.value;
    const taken = ({ target }: Event): void => edit(table, row, cell, (target as HTMLInputElement).value);
    const label = named ? nothing : `${t(cell.key)}, ${say(row.title)}`;
    const entry =
      cell.kind === "choice"
        ? html`<select id=${id} class="choice" aria-label=${label} aria-describedby=${`${id}-why`} @change=${taken}>
            ${choices(cell, value)}
          </select>`
        : html`<input
            id=${id}
            class=${cell.kind === "text" ? "" : "figure"}
            type="text"
            autocomplete="off"
            spellcheck="false"
            inputmode=${cell.kind === "text" ? "text" : "decimal"}
            aria-label=${label}
            aria-invalid=${bad ? "true" : nothing}
            aria-describedby=${`${id}-why`}
            .value=${unlessTyping(value)}
            @change=${taken}
          />`;
    return html`${entry}<span class="datum-problem" id=${`${id}-why`} role="alert" ?hidden=${!bad}
        >${bad?.why ?? ""}</span
      >`;
  }

  const act = (key: string, row: EquipmentRow, run: () => void, off = false): TemplateResult =>
    html`<button
      type="button"
      class="quiet icon-button"
      data-act=${key}
      aria-label=${`${t(key)}: ${say(row.title)}`}
      title=${t(key)}
      ?disabled=${off}
      @click=${run}
    >
      ${iconPart(ICON[key] ?? "more")}
    </button>`;

  function rowActions(table: EquipmentTable, row: EquipmentRow, index: number, count: number): TemplateResult {
    const named = { row: say(row.title) };
    const of = { table, row: row.id };
    return html`<span class="row-actions"
      >${
        row.active === undefined
          ? nothing
          : html`<label class="check"
              ><input
                type="radio"
                name=${`use-${table}`}
                .checked=${live(row.active)}
                aria-label=${`${t("equipment-use")}: ${named.row}`}
                @change=${() => change({ use: of }, { key: "step-equip-use", args: named })}
              />${t("equipment-use")}</label
            >`
      }${
        table === "part"
          ? html`${act(
              "equipment-earlier",
              row,
              () => change({ earlier: of }, { key: "step-equip-move", args: named }),
              index === 0,
            )}${act(
              "equipment-later",
              row,
              () => change({ later: of }, { key: "step-equip-move", args: named }),
              index === count - 1,
            )}`
          : nothing
      }${act("equipment-copy", row, () => change({ copy: of }, { key: "step-equip-copy", args: named }))}${act(
        "equipment-remove",
        row,
        () => change({ remove: of }, { key: "step-equip-remove", args: named }),
        !row.removable,
      )}</span
    >`;
  }

  /** Rows of the same fields: one under the other. */
  function gridOf({ table, rows }: EquipmentRows): TemplateResult {
    const [first] = rows;
    const head = first?.cells ?? [];
    return html`<div class="equipment-scroll">
        <table class="equipment-table">
          <thead>
            <tr>
              ${table === "offsets" ? html`<th scope="col">${t("equipment-offset")}</th>` : nothing}
              ${head.map(
                cell => html`<th scope="col">${t(cell.key)} <span class="unit">${unitText(cell.unit)}</span></th>`,
              )}
              <th scope="col"><span class="visually-hidden">${t("equipment-actions")}</span></th>
            </tr>
          </thead>
          <tbody>
            ${repeat(
              rows,
              row => row.id,
              (row, index) => html`<tr data-row=${row.id} class=${row.active ? "active" : ""}>
                ${table === "offsets" ? html`<th scope="row">${say(row.title)}</th>` : nothing}
                ${row.cells.map(
                  cell => html`<td data-kind=${cell.kind} data-cell=${cell.key} data-label=${t(cell.key)}>
                    ${input(table, row, cell, false)}
                  </td>`,
                )}
                <td>${rowActions(table, row, index, rows.length)}</td>
              </tr>`,
            )}
          </tbody>
        </table>
      </div>
      <p class="empty" ?hidden=${rows.length > 0}>${t("equipment-empty")}</p>
      <div class="actions">
        <button
          type="button"
          id="equipment-add"
          @click=${() => change({ add: { table, row: "" } }, { key: `step-equip-add-${table}`, args: {} })}
        >
          ${t(`equipment-add-${table}`)}
        </button>
      </div>`;
  }

  /** Rows of their own fields: a box each. */
  function listOf({ table, rows, adds }: EquipmentRows): TemplateResult {
    const boxes = repeat(
      rows,
      row => row.id,
      (row, index) => html`<fieldset class="equipment-box" data-row=${row.id}>
        <legend>${say(row.title)}</legend>
        ${row.removable ? rowActions(table, row, index, rows.length) : nothing}
        <div class="equipment-fields">
          ${row.cells.map(cell => {
            const id = cellId(table, row.id, cell.key);
            const limits = cell.kind === "real" || cell.kind === "integer" ? rangeText(cell.range) : "";
            return html`<div class="equipment-field" data-kind=${cell.kind} data-cell=${cell.key}>
              <label for=${id}>${t(cell.key)}</label>
              <span class="entry-line"
                >${input(table, row, cell, true)}<span class="unit">${unitText(cell.unit)}</span></span
              >
              <span class="meta">${limits}</span>
            </div>`;
          })}
        </div>
      </fieldset>`,
    );
    const add = (): void =>
      change({ add: { table, row: shape.value } }, { key: "step-equip-add-part", args: { shape: t(shape.value) } });
    const measured = (): void => change("measured", { key: "step-equip-measured", args: {} });
    shape.replaceChildren(...adds.map(key => el("option", { value: key, selected: key === shape.value }, t(key))));
    return html`${boxes}
      <p class="empty" ?hidden=${rows.length > 0}>${optional(`equipment-no-${table}`)}</p>
      <div class="actions" ?hidden=${adds.length === 0}>
        ${shape}<button type="button" id="equipment-add" @click=${add}>${t("equipment-add-part")}</button
        >${
          table === "part"
            ? html`<button type="button" id="equipment-measured" @click=${measured}>${t("equipment-measured")}</button>`
            : nothing
        }
      </div>`;
  }

  const choose = (table: EquipmentTable): void => {
    tab = table;
    wrong = null;
    drawAll();
  };
  const fill = (): void => {
    tabs.replaceChildren(
      ...(view?.tables ?? []).map(({ table }) => {
        const button = el(
          "button",
          {
            type: "button",
            role: "tab",
            id: `equipment-tab-${table}`,
            "aria-controls": "equipment-page",
            "data-table": table,
          },
          t(`equipment-tab-${table}`),
        );
        on(button, "click", () => choose(table));
        return button;
      }),
    );
  };
  on(tabs, "keydown", event => {
    const command = meantBy(event, "tabs");
    if (!command || !view) return;
    const all = view.tables.map(one => one.table);
    const move = command === "next-tab" ? 1 : -1;
    choose(all[(all.indexOf(tab) + move + all.length) % all.length] ?? tab);
    document.getElementById(`equipment-tab-${tab}`)?.focus();
  });
  on(close, "click", () => dialog.close());
  on(undo, "click", () => {
    actions.step(1);
    wrong = null;
    view = ask();
    drawAll();
    undo.focus();
  });
  on(data, "click", () => {
    dialog.close();
    machineData.open();
  });
  return {
    open() {
      view = ask();
      if (!view) return; // the module is still on its way
      wrong = null;
      fill();
      dialog.showModal();
      drawAll();
    },
    draw({ history }) {
      setOff(undo, history.past.length === 0, close);
    },
  };
}

function choices(cell: EquipmentCell, value: string): TemplateResult[] {
  const known = (cell.kind === "choice" ? cell.choices : []).map(String);
  const text = (one: string): string => optional(`${cell.key}.v${one}`) || plain(Number(one));
  return (known.includes(value) ? known : [...known, value]).map(
    one => html`<option value=${one} .selected=${live(one === value)}>${text(one)}</option>`,
  );
}
