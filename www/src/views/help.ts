// The help page of the variant in the form: what it measures, where the probe stands before, what happens in order,
// what it corrects, what goes wrong. It stands beside the form, in the place of program, view and results.

import type { ProgramCore } from "../core/program";
import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { titleOf, variantOf } from "../desk/variants";
import { el, on, setText, show } from "../dom";
import { glossed } from "../glossary";
import { meantBy } from "../keys";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { hasHelp, helpWords, language, optional, say, t } from "../texts";
import type { AlarmInfo, HelpView } from "../wire";
import { focusField } from "./field";

export function createHelp(
  root: HTMLElement,
  store: Store,
  actions: Actions,
  core: () => ProgramCore | null,
  background: () => void,
): (state: State, derived: Derived) => void {
  const title = el("h2", { id: "help-title" });
  const terms = el("button", { type: "button", class: "quiet" }, t("terms-open"));
  const close = el("button", { type: "button", class: "quiet" }, t("help-close"));
  const note = el("p", { class: "empty" });
  const page = el("div", { class: "help-page" });
  root.append(
    el("header", { class: "panel-head" }, title, terms, close),
    el("div", { class: "scroll", tabindex: "0", role: "region", "aria-labelledby": "help-title" }, note, page),
  );
  const leave = (): void => {
    actions.help();
    document.querySelector<HTMLElement>(".help-open")?.focus();
  };
  on(terms, "click", () => background());
  on(close, "click", leave);
  on(root, "keydown", event => {
    if (meantBy(event, "page") === "close") leave();
  });

  const goTo = (name: string): void => {
    actions.panel("form");
    focusField(name);
  };
  let asking = ""; // the language whose words are on their way
  let failed = false;
  const fetchWords = (): void => {
    if (asking === language()) return;
    asking = language();
    helpWords()
      .catch((problem: unknown) => {
        console.error(problem);
        failed = true;
      })
      .finally(() => {
        asking = "";
        store.update({});
      });
  };

  let drawn = "";
  return (state, derived) => {
    const { cycle, view: form } = derived;
    if (state.panels.right !== "help") {
      failed = false; // opened again, it tries again
      return;
    }
    if (!hasHelp() && !failed) fetchWords();
    const variant = variantOf(derived);
    const from = hasHelp() ? core() : null;
    setText(title, t("help-title", { cycle: cycle.cycle, name: titleOf(cycle, form) }));
    setText(note, failed ? t("help-absent") : !from ? t("help-coming") : variant ? "" : t("help-no-variant"));
    show(note, !from || !variant);
    show(page, !!from && !!variant);
    if (!from || !variant) return;
    const what = `${cycle.control}/${cycle.cycle}/${variant.mvar}/${form.preset}`;
    if (what === drawn) return;
    drawn = what;
    const view = from.help({ control: cycle.control, cycle: cycle.cycle, mvar: variant.mvar, style: form.preset });
    page.replaceChildren(...fill(view, goTo));
    page.parentElement?.scrollTo({ top: 0 });
  };
}

/** A text with the names of data in it marked as such, and terms that are not `seen` yet. */
function marked(text: string, seen: Set<string>): (string | HTMLElement)[] {
  return text
    .split(/([_$][A-Z][A-Z0-9_]*(?:\[[^\]]*\])?)/)
    .flatMap((part, index) => (index % 2 ? [el("code", {}, part)] : glossed(part, seen)));
}

/**
 * Headings and lines; the values stand with where the probe is before the call, the results with what is corrected, the
 * alarms at the end.
 */
function fill(
  { note, sections, required, results, alarms, places }: HelpView,
  goTo: (name: string) => void,
): HTMLElement[] {
  const seen = new Set<string>();
  const older = note ? [el("p", { class: "help-older" }, ...marked(say(note), seen))] : [];
  const parts = sections.map(({ label, lines }) =>
    el(
      "section",
      {},
      el("h3", {}, say(label)),
      el(
        "ul",
        {},
        ...lines.map(({ message, source }) =>
          el("li", {}, ...marked(say(message), seen), " ", el("small", {}, source)),
        ),
      ),
    ),
  );
  const name = (one: string): HTMLElement => {
    const button = el("button", { type: "button", class: "quiet" }, el("code", {}, one));
    on(button, "click", () => goTo(one));
    return el("li", {}, button);
  };
  const values = el(
    "section",
    {},
    el("h3", {}, t("help-values-title")),
    el("ul", { class: "help-values" }, ...required.map(name)),
  );
  const left = el(
    "details",
    { class: "help-folded" },
    el("summary", {}, t("help-results-title", { count: results.length })),
    el("dl", {}, ...results.flatMap(one => [el("dt", {}, el("code", {}, one.name)), el("dd", {}, t(one.key))])),
  );
  const list = el(
    "section",
    {},
    el("h3", {}, t("help-alarms-title", { count: alarms.length })),
    ...alarms.map(alarmEntry),
  );
  const where = el(
    "details",
    { class: "help-folded" },
    el("summary", {}, t("where-title")),
    ...places.map(({ message, source }) => el("p", {}, ...marked(say(message), seen), " ", el("small", {}, source))),
  );
  return [
    ...older,
    ...parts.slice(0, 2),
    ...(required.length ? [values] : []),
    ...parts.slice(2, 4),
    ...(results.length ? [left] : []),
    ...parts.slice(4),
    where,
    ...(alarms.length ? [list] : []),
  ];
}

function alarmEntry({ code, key }: AlarmInfo): HTMLElement {
  const told = [`${key}.cause`, `${key}.cure`].map(optional).filter(text => text !== "");
  return el(
    "details",
    { class: "help-folded" },
    el("summary", {}, el("code", {}, code), ` ${t(key)}`),
    ...told.map(text => el("p", {}, text)),
  );
}
