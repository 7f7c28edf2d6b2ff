// The form of the chosen cycle: status line, picture, fields, what to do with the snippet.

import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { replacing } from "../desk/typing";
import { titleOf, type Variant, variantOf } from "../desk/variants";
import { el, on, setAttribute, setText, show } from "../dom";
import { meantBy } from "../keys";
import { inFocus, type Reset, type State } from "../state/state";
import type { Store } from "../state/store";
import { optional, t } from "../texts";
import type { CallView, Diagnostic } from "../wire";
import { createAround, withBlocks } from "./around";
import { createAsks } from "./asks";
import { createCode, piecesOf } from "./code";
import { createExplain } from "./explain";
import { createField, type FieldView, focusField } from "./field";
import { createFoot } from "./foot";
import { createGroups } from "./groups";
import { createPicture } from "./picture";
import { listProblems } from "./problem";
import { createTwin } from "./twin";
import { createCallWays, createSnippetWays } from "./ways";

/**
 * Problems of a field are shown once it was typed into, or after "check"; a value that came there otherwise is marked
 * at once, and what no field tells, which nobody could type into; doubts about a call in which nothing is wrong or
 * missing at once, as data of the machine may be behind them.
 */
export function shownProblems(state: State, { diagnostics: all, fields }: Derived["view"]): Diagnostic[] {
  const names = new Set<string | undefined>(fields.map(field => field.name));
  const whole = all.every(one => one.severity !== "error");
  return all.filter(
    one =>
      whole ||
      state.form.checked ||
      one.severity === "note" ||
      (one.severity === "error" && !names.has(one.param)) ||
      (one.param !== undefined && (state.form.touched[one.param] || isCarried(state, one.param))),
  );
}

/** Whether a field holds a value, and nobody is typing into it. */
function isCarried({ form: { values, focus } }: State, name: string): boolean {
  return focus !== name && (values[name] ?? "").trim() !== "";
}

const resetSaid = ({ value, before }: Reset): Diagnostic["message"] =>
  before === undefined ? { key: "field-unfit", args: { value } } : { key: "field-reset", args: { value, before } };

/** What is said at a field whose value was taken away with the variant. */
function resetNotes({ form: { resets, values } }: State): Diagnostic[] {
  const gone = Object.entries(resets).filter(([name]) => !values[name]);
  return gone.map(([param, reset]) => ({ severity: "note", code: "", param, message: resetSaid(reset) }));
}

const commas = (text: string): number => text.split(",").length;

/** What is said at a field whose value was typed with a decimal comma: it is written with a point. */
function pointedNotes({ form: { values } }: State, { fields }: Derived["view"]): Diagnostic[] {
  return fields.flatMap(({ name: param, written, expression = "" }): Diagnostic[] => {
    const pointed = commas(values[param] ?? "") > commas(expression) ? expression : "";
    const value = written || pointed;
    return value ? [{ severity: "note", code: "", param, message: { key: "field-pointed", args: { value } } }] : [];
  });
}

/** Where in the program the call stands that the form edits. */
const openedAt = (cycle: string, { line, lastLine }: CallView): string =>
  line === lastLine ? t("form-opened-line", { cycle, line }) : t("form-opened", { cycle, from: line, to: lastLine });

/** How the call of the form is practised in JOG. */
export interface CallPractice {
  /** Whether there is a mask for it. */
  there(state: State, derived: Derived): boolean;
  go(): void;
}

export function createForm(
  root: HTMLElement,
  store: Store,
  actions: Actions,
  chain: HTMLElement,
  showSets: () => void,
  goToLine: (line: number) => void,
  practise: CallPractice,
  background: (concept: string) => void,
): (state: State, derived: Derived) => void {
  const title = el("h2", { id: "form-title" });
  const explain = createExplain(background);
  const where = el("span", {});
  const chip = el("button", { type: "button", class: "chip", "aria-controls": "panel-tasks" });
  const help = el(
    "button",
    { type: "button", class: "quiet help-open", "aria-controls": "panel-help" },
    t("help-open"),
  );
  const detach = el("button", { type: "button", class: "quiet" }, t("form-detach"));
  const opened = el(
    "div",
    { class: "opened", role: "status" },
    el("span", { class: "opened-mark", "aria-hidden": "true" }, "◆"),
    where,
    detach,
  );
  const callWays = createCallWays(actions);
  const asks = createAsks(actions);
  const ways = createSnippetWays(actions);
  const around = createAround(store, actions);
  const twin = createTwin(store);
  const jog = el("button", { type: "button", class: "quiet practise-call" }, t("practice-call"));
  on(jog, "click", practise.go);
  const pictureBox = el("div", { class: "picture-box" });
  const fields = el("div", { class: "fields", role: "group", "aria-labelledby": "form-title" });
  let shown: { cycle: Derived["cycle"]; state: State; problems: Diagnostic[] } | null = null;
  const views = new WeakMap<Element, FieldView>();
  const focused = (name: string | null): void => {
    if (store.state.form.focus !== name) store.update({ form: { focus: name } });
  };
  const groups = createGroups(
    fields,
    store,
    field => `${shown?.cycle.control}/${shown?.cycle.cycle}/${field.name}/${field.kind}`,
    { tolerances: chain },
    field => {
      const view = createField(field, actions, focused, goToLine);
      views.set(view.root, view);
      return view.root;
    },
    (node, field) => {
      const problems = shown?.problems.filter(one => one.param === field.name) ?? [];
      const { name } = field;
      if (shown)
        views
          .get(node)
          ?.update(
            field,
            shown.state.form.values[name] ?? "",
            problems,
            replacing(shown.state, name)?.asks.replaced ?? null,
          );
    },
  );
  const loose = el("ul", { class: "loose-problems", "aria-live": "polite" });
  const count = el("p", { class: "form-state", role: "status" });
  const check = el("button", { type: "button" }, t("form-check"));
  const sets = el("button", { type: "button" }, t("sets-open"));
  const example = el("button", { type: "button" }, t("form-example"));
  const snippet = el("pre", { class: "snippet", tabindex: "0", "aria-label": t("form-snippet") });
  const drawSnippet = createCode(snippet);
  const comments = el("input", { type: "checkbox", id: "comments" });
  const foot = createFoot(store, actions, goToLine, [check, example, sets]);
  const snippetBox = el(
    "section",
    { class: "snippet-box", "aria-label": t("form-snippet") },
    el(
      "div",
      { class: "snippet-head" },
      el("h3", {}, t("form-snippet")),
      el("label", { class: "check", for: "comments" }, comments, t("form-comments")),
    ),
    opened,
    callWays.root,
    el("div", { class: "ways" }, ways.choice),
    snippet,
    ways.said,
    el("div", { class: "actions" }, jog),
    twin.root,
  );
  const scroll = el(
    "div",
    { class: "scroll" },
    loose,
    fields,
    el("div", { class: "actions" }, groups.all),
    around.root,
    snippetBox,
  );
  root.append(
    el("header", { class: "panel-head form-head" }, el("div", { class: "form-name" }, title, chip), count, help),
    pictureBox,
    explain.root,
    scroll,
    asks.root,
    asks.said,
    foot.root,
  );

  const drawPicture = createPicture(pictureBox, focusField);
  let chosen: Variant | undefined;

  on(fields, "keydown", event => {
    if (!asks.waits() || event.target instanceof HTMLSelectElement) return;
    const command = meantBy(event, "form");
    if (command === "ask") actions.show();
    else if (command === "refuse") actions.refuse();
    else return;
    event.preventDefault();
  });
  /** Whether somebody types into a field, or decides beside it. */
  const isBusy = (at: Element | null): boolean =>
    (at instanceof HTMLInputElement && fields.contains(at)) || asks.root.contains(at);
  const showIfLeft = (at: Element | null): void => {
    if (asks.waits() && document.hasFocus() && !isBusy(at) && !store.state.desk.proposed) actions.show();
  };
  on(fields, "focusout", event => {
    if (!asks.root.contains(event.relatedTarget as Element | null)) showIfLeft(null);
  });
  on(detach, "click", () => actions.closeCall());
  on(help, "click", () => {
    actions.help();
    if (store.state.panels.right === "help") document.getElementById("panel-help")?.focus();
  });
  on(example, "click", () => actions.example(chosen));
  on(sets, "click", showSets);
  on(comments, "change", () => store.update({ snippet: { comments: comments.checked } }));
  on(chip, "click", () => {
    actions.panel("tasks");
    document.querySelector<HTMLElement>('.tree [tabindex="0"]')?.focus();
  });
  on(check, "click", () => {
    actions.check();
    store.flush();
    root.querySelector<HTMLElement>('[aria-invalid="true"]')?.focus();
  });

  return (state, derived) => {
    const { view, cycle } = derived;
    chosen = variantOf(derived);
    setText(title, titleOf(cycle, view));
    setText(chip, chosen ? `${cycle.cycle} · ${chosen.mvar}` : cycle.cycle);
    setAttribute(chip, "title", t("form-variant-open"));
    setAttribute(help, "aria-expanded", String(state.panels.right === "help"));
    explain.draw(
      optional(`${cycle.key}-help`),
      view.fields.find(field => field.name === state.form.focus),
    );
    show(opened, !!derived.opened);
    if (derived.opened) setText(where, openedAt(cycle.cycle, derived.opened));
    const names = new Set(view.fields.map(field => field.name));
    const arrivals = derived.opened?.arrivals.filter(one => one.param === undefined || names.has(one.param)) ?? [];
    // what is said of how a value arrives there tells more than that it is not known
    const told = (one: Diagnostic): boolean =>
      arrivals.some(other => other.param === one.param && other.code === one.code);
    const own = shownProblems(state, view).filter(one => !told(one));
    const problems = [...own, ...arrivals, ...resetNotes(state), ...pointedNotes(state, view)];
    shown = { cycle, state, problems };
    const troubled = problems.flatMap(({ severity, param }) => (severity !== "note" && param ? [param] : []));
    groups.draw(view.fields, state, new Set(troubled));
    listProblems(
      loose,
      problems.filter(one => one.param === undefined || !names.has(one.param)),
      actions.give,
    );
    if (view.picture) drawPicture(view.picture, inFocus(state), state.form.values);
    renderCount(count, state, view);
    if (comments.checked !== state.snippet.comments) comments.checked = state.snippet.comments;
    around.draw(state, derived);
    const whole = withBlocks(derived);
    drawSnippet(piecesOf(whole, whole === view.snippet ? view.snippetPlaces : {}));
    setAttribute(snippet, "data-style", derived.style);
    show(snippet, view.snippet !== "");
    foot.draw(state, derived);
    asks.draw(state);
    queueMicrotask(() => showIfLeft(document.activeElement)); // what nobody types any more
    ways.draw(state, derived);
    twin.draw(state, derived);
    show(jog, practise.there(state, derived));
    callWays.draw(state, derived);
    setAttribute(root, "data-complete", String(view.complete));
  };
}

function renderCount(node: HTMLElement, state: State, view: Derived["view"]): void {
  const { complete } = view;
  const seen = shownProblems(state, view).filter(one => one.severity === "error").length;
  const text = complete ? t("form-complete") : seen > 0 ? t("form-errors", { count: seen }) : t("form-incomplete");
  setText(node, text);
  setAttribute(node, "data-state", complete ? "complete" : seen > 0 ? "errors" : "incomplete");
}
