// A change before it is made: what is added, lost and worth checking, then the lines as they are and as they would be.

import { changes, countChanges, type Hunk, marked, type Part, type Row } from "../changes";
import type { Actions } from "../desk/actions";
import { type Derived, findCycle } from "../desk/derive";
import { isCurrent } from "../desk/program";
import { el, on, setAttribute, setText, show } from "../dom";
import { meantBy } from "../keys";
import type { Proposal, State } from "../state/state";
import { listed, optional, say, t } from "../texts";
import type { ComparedValue } from "../wire";
import { listProblems } from "./problem";

const AT_ONCE = 200; // hunks that are shown at once; the next ones come when they are asked for
const NAMED = 60; // values of a sort that are named

export interface DifferenceView {
  dialog: HTMLDialogElement;
  draw(state: State, derived: Derived): void;
}

/** Old and new lines beside each other, with the way from change to change. */
export interface ChangeList {
  root: HTMLElement;
  show(hunks: readonly Hunk[]): void;
  /** To the change that stands so many further; gives its number, from 1. */
  step(by: number): number;
}

function side(row: Row, which: "before" | "after", parts: readonly Part[]): HTMLElement[] {
  const line = row[which];
  const changed = row.before && row.after && !row.same;
  const word = row.same || !line ? "" : changed ? `changed-${which === "before" ? "from" : "to"}` : null;
  const told = word === null ? (which === "before" ? "gone" : "came") : word;
  const tag = row.same ? "span" : which === "before" ? "del" : "ins";
  const text = el(tag, {}, ...parts.map(part => (part.marked ? el("mark", {}, part.text) : part.text)));
  return [
    el("span", { class: "difference-number", role: "cell", "data-side": which }, line ? String(line.line) : ""),
    el(
      "span",
      { class: "difference-text", role: "cell", "data-side": which, "data-changed": !row.same && !!line },
      told ? el("span", { class: "visually-hidden" }, `${t(`difference-${told}`)} `) : null,
      line ? text : null,
    ),
  ];
}

function rowItem(row: Row): HTMLElement {
  const { before, after, same } = row;
  const parts = before && after && !same ? marked(before.text, after.text) : null;
  const plain = (text: string | undefined): Part[] => [{ text: text ?? "", marked: false }];
  return el(
    "div",
    { class: "difference-row", role: "row", "data-same": same, tabindex: same ? null : "-1" },
    ...side(row, "before", parts?.before ?? plain(before?.text)),
    ...side(row, "after", parts?.after ?? plain(after?.text)),
  );
}

function hunkItem(hunk: Hunk): HTMLElement {
  const rows = hunk.map(rowItem);
  for (const [at, row] of rows.entries())
    if (!hunk[at]?.same && (hunk[at - 1]?.same ?? true)) setAttribute(row, "data-change", true);
  return el("div", { class: "difference-hunk", role: "rowgroup" }, ...rows);
}

export function createChangeList(): ChangeList {
  const head = el(
    "div",
    { class: "difference-row difference-head", role: "row" },
    ...["line", "before", "line", "after"].map(name =>
      el("span", { role: "columnheader", "data-name": name }, t(`difference-${name}`)),
    ),
  );
  const body = el("div", { class: "difference-hunks", role: "presentation" });
  const more = el("button", { type: "button", class: "quiet difference-further" });
  const table = el("div", { role: "table", "aria-label": t("difference-list") }, head, body);
  const root = el("div", { class: "difference-list", tabindex: "0" }, table, more);
  let waiting: readonly Hunk[] = [];
  let at = -1;
  const grow = (): void => {
    body.append(...waiting.slice(0, AT_ONCE).map(hunkItem));
    waiting = waiting.slice(AT_ONCE);
    show(more, waiting.length > 0);
    setText(more, t("difference-further", { count: countChanges(waiting) }));
  };
  const marks = (): HTMLElement[] => [...body.querySelectorAll<HTMLElement>("[data-change]")];
  on(more, "click", () => {
    const known = marks().length;
    grow();
    marks()[known]?.focus();
  });
  return {
    root,
    show(hunks) {
      body.replaceChildren();
      root.scrollTop = 0;
      waiting = hunks;
      at = -1;
      grow();
    },
    step(by) {
      if (at + by >= marks().length && waiting.length) grow();
      const all = marks();
      if (!all.length) return 0;
      at = (Math.max(at, by < 0 ? 0 : -1) + by + all.length) % all.length;
      const row = all[at];
      row?.focus({ preventScroll: true });
      row?.scrollIntoView({ block: "center" });
      return at + 1;
    },
  };
}

/** The values of one sort, the same one of several calls once. */
function named(values: readonly ComparedValue[], many: boolean): HTMLElement[] {
  const alike = new Map<string, ComparedValue[]>();
  for (const one of values) {
    const key = `${one.param} ${one.before} ${one.after}`;
    alike.set(key, [...(alike.get(key) ?? []), one]);
  }
  const items = [...alike.values()].slice(0, NAMED).map(all => {
    const [{ param, key, before, after }] = all as [ComparedValue];
    const text =
      before !== null && after !== null
        ? t("difference-becomes", { name: param, before, after })
        : t("difference-value", { name: param, value: before ?? after ?? "" });
    const lines = listed(all.map(one => String(one.line)));
    return el(
      "li",
      {},
      el("code", {}, text),
      ` ${key ? optional(key) : ""}`,
      many
        ? el("span", { class: "difference-where" }, ` ${t("difference-lines", { count: all.length, lines })}`)
        : null,
    );
  });
  const rest = alike.size - items.length;
  return rest > 0 ? [...items, el("li", {}, t("difference-more", { count: rest }))] : items;
}

const SORTS = ["lost", "added", "changed"] as const;

function sortOf({ before, after }: ComparedValue): (typeof SORTS)[number] {
  return before === null ? "added" : after === null ? "lost" : "changed";
}

/** What a change does to the values of calls, and what is to be checked. */
function createNotes(): { root: HTMLElement; show(proposal: Proposal): void } {
  const findings = el("ul", { class: "difference-findings" });
  const root = el("div", { class: "difference-notes" });
  return {
    root,
    show({ values, findings: all, converting, said }) {
      const lines = new Set(values.map(one => one.line));
      const parts = SORTS.flatMap(sort => {
        const own = values.filter(one => sortOf(one) === sort);
        if (!own.length) return [];
        const title = el("h3", {}, t(`difference-${sort}`));
        return [
          el("section", { "data-sort": sort }, title, el("ul", {}, ...named(own, converting?.all ?? lines.size > 1))),
        ];
      });
      const none = converting && !values.length ? el("p", {}, t("difference-values-none")) : null;
      listProblems(findings, all);
      const check = el("section", {}, el("h3", {}, t("difference-findings")), findings);
      root.replaceChildren(
        ...[...parts, none, said && el("p", {}, say(said)), all.length ? check : null].filter(one => one !== null),
      );
    },
  };
}

/** Whether one call or all are written anew, where there are others. */
function createScope(actions: Actions): { root: HTMLElement; draw(proposal: Proposal, others: number): void } {
  const one = el("button", { type: "button" }, t("difference-scope-one"));
  const all = el("button", { type: "button" });
  const root = el("div", { class: "segments", role: "group", "aria-label": t("difference-scope") }, one, all);
  let shown: Proposal["converting"] = null;
  for (const button of [one, all])
    on(button, "click", () => {
      if (shown && shown.all !== (button === all)) actions.convert(shown.style, button === all);
    });
  return {
    root,
    draw({ converting }, others) {
      shown = converting;
      show(root, !!converting && others > 1);
      setText(all, t("difference-scope-all", { count: others }));
      setAttribute(one, "aria-pressed", String(!converting?.all));
      setAttribute(all, "aria-pressed", String(converting?.all ?? false));
    },
  };
}

export function createDifference(actions: Actions): DifferenceView {
  const title = el("h2", { id: "difference-title" });
  const summary = el("p", { class: "difference-summary", role: "status" });
  const scope = createScope(actions);
  const notes = createNotes();
  const list = createChangeList();
  const place = el("span", { class: "difference-place", role: "status" });
  const button = (key: string, run: () => void, attributes = {}): HTMLButtonElement => {
    const node = el("button", { type: "button", ...attributes }, t(key));
    on(node, "click", run);
    return node;
  };
  let count = 0;
  const step = (by: number): void => {
    const number = list.step(by);
    setText(place, number ? t("difference-place", { number, count }) : "");
  };
  const next = button("difference-next", () => step(1), { class: "quiet", "aria-keyshortcuts": "F7" });
  const previous = button("difference-previous", () => step(-1), { class: "quiet", "aria-keyshortcuts": "Shift+F7" });
  const cancel = button("asks-cancel", () => dialog.close());
  const apply = button("asks-apply", actions.apply, { class: "primary" });
  const dialog = el(
    "dialog",
    { class: "difference", "aria-labelledby": "difference-title", "aria-describedby": "difference-summary" },
    el("header", {}, title, summary, scope.root),
    notes.root,
    list.root,
    el("div", { class: "actions" }, previous, next, place, el("span", { class: "space" }), cancel, apply),
  );
  summary.id = "difference-summary";
  on(dialog, "close", () => {
    if (shown) actions.discard();
  });
  on(dialog, "keydown", event => {
    if (event.repeat && event.key === "Enter") {
      event.preventDefault(); // held down since before it opened
      return;
    }
    const inButton = event.target instanceof Element && !!event.target.closest("button");
    const does = { apply: actions.apply, "next-change": () => step(1), "previous-change": () => step(-1) };
    const command = meantBy(event, "difference");
    // a button has its own meaning of Enter; Escape is the dialog's
    if (!command || command === "cancel" || (command === "apply" && (inButton || !count))) return;
    event.preventDefault();
    does[command]();
  });

  let shown: Proposal | null = null;
  let from: Element | null = null; // had the focus before
  /** What had the focus may be gone with what was changed. */
  const back = (): void => {
    const panel = from?.closest<HTMLElement>("section[tabindex]") ?? document.querySelector<HTMLElement>("#panel-form");
    if (document.activeElement === document.body) panel?.focus();
  };
  const fill = (proposal: Proposal): void => {
    const hunks = changes(proposal.text, proposal.edits);
    count = countChanges(hunks);
    setText(title, say(proposal.title));
    setText(summary, t("difference-summary", { count }));
    setText(place, "");
    notes.show(proposal);
    list.show(hunks);
    show(list.root, count > 0);
    for (const node of [next, previous]) show(node, count > 1);
    show(apply, count > 0);
    setText(cancel, t(count > 0 ? "asks-cancel" : "difference-close"));
  };
  return {
    dialog,
    draw(state, { read, catalogue }) {
      const wanted = state.desk.proposed;
      const proposal = wanted && isCurrent(wanted, state) ? wanted : null;
      if (proposal === shown) return;
      shown = proposal;
      if (!proposal) {
        dialog.close();
        back();
        return;
      }
      fill(proposal);
      const { converting, control } = proposal;
      const others = read.calls.filter(
        one =>
          one.style !== converting?.style &&
          findCycle(catalogue, control, one.cycle)?.styles.some(style => style === converting?.style),
      );
      scope.draw(proposal, state.form.open === null ? 0 : others.length);
      if (dialog.open) return;
      from = document.activeElement;
      dialog.showModal();
      apply.focus();
    },
  };
}
