// What the search finds, in groups: measurements, parameters, results, alarms. The search itself comes when it is first
// needed.

import type { Actions } from "../desk/actions";
import { el, on, setAttribute, setText, show } from "../dom";
import { isExplained, openGuide } from "../guide";
import { type Command, meantBy } from "../keys";
import type { Group, Hit, Search, Tables } from "../search";
import { pieces } from "../search/words";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { everyLanguage, t } from "../texts";
import type { Catalogue, Dialect } from "../wire";

const MOST = 40; // hits of a group that are listed; more say nothing

export interface Found {
  root: HTMLElement;
  load(): void;
  draw(state: State): void;
  focusFirst(): void;
}

function marked(text: string, words: readonly string[]): Node[] {
  return pieces(text, words).map(piece =>
    piece.found ? el("mark", {}, piece.text) : document.createTextNode(piece.text),
  );
}

function button(hit: Hit, pick: (hit: Hit) => void): HTMLElement {
  const { code, title, control, kind } = hit.entry;
  const node = el(
    "button",
    { type: "button", class: "hit", "data-kind": kind },
    code ? el("code", {}, ...marked(code, hit.words)) : null,
    el("span", { class: "hit-title" }, ...marked(title, hit.words)),
    kind === "measurement" || !control ? null : el("span", { class: "hit-control" }, t(`control-${control}`)),
  );
  on(node, "click", () => pick(hit));
  return el("li", {}, node);
}

export function createFound(
  catalogue: Catalogue,
  tables: Tables,
  store: Store,
  actions: Actions,
  goToField: (control: Dialect, name: string) => void,
  back: () => void,
): Found {
  const list = el("div", { class: "hits" });
  const none = el("p", { class: "empty", role: "status" });
  const root = el("div", { class: "found", hidden: true }, list, none);
  let search: Search | null = null;
  let loading = false;
  let shown = "";

  const pick = ({ entry }: Hit): void => {
    const { kind, code, key, variant, cycles, others, told } = entry;
    const [cycle] = cycles;
    if (isExplained(kind)) openGuide(key);
    else if (kind === "result" || kind === "alarm" || kind === "elsewhere")
      actions.card({ kind, code, key, cycles, others, ...(told ? { told } : {}) });
    else if (kind === "around") {
      actions.panel("form");
      actions.around(code);
    } else if (kind !== "parameter") {
      if (cycle) actions.chooseCycle(cycle, variant);
      actions.panel("form");
    } else if (cycle) goToField(cycle.control, code);
  };
  const section = ({ kind, hits }: Group): HTMLElement => {
    const title = el("h3", {}, t(`found-${kind}`, { count: hits.length }));
    const more = hits.length > MOST && el("p", { class: "empty" }, t("found-more", { count: hits.length - MOST }));
    return el("section", {}, title, el("ul", {}, ...hits.slice(0, MOST).map(hit => button(hit, pick))), more);
  };
  const buttons = (): HTMLElement[] => [...list.querySelectorAll<HTMLElement>(".hit")];
  on(list, "keydown", event => {
    const all = buttons();
    const at = all.indexOf(document.activeElement as HTMLElement);
    const next: Partial<Record<Command<"list">, HTMLElement | undefined>> = {
      next: all[at + 1],
      previous: all[at - 1],
      first: all[0],
      last: all.at(-1),
    };
    const command = meantBy(event, "list");
    if (command === "leave" || (command === "previous" && at === 0)) back();
    else if (command && command in next) next[command]?.focus();
    else return;
    event.preventDefault();
  });

  const load = (): void => {
    if (loading) return;
    loading = true;
    const named = everyLanguage().catch(console.warn); // without them it finds what the page's own words say
    void Promise.all([import("../search"), tables.alarms, tables.elsewhere, named]).then(
      ([{ createSearch }, known, elsewhere]) => {
        search = createSearch(catalogue, known, elsewhere);
        store.update({});
      },
    );
  };
  return {
    root,
    load,
    focusFirst: () => buttons()[0]?.focus(),
    draw({ page: { search: text }, form: { control } }) {
      const asked = text.trim();
      show(root, asked !== "");
      if (asked) load();
      const now = `${control} ${asked}`;
      if (!search || now === shown) return;
      shown = now;
      const groups = asked ? search(asked, control) : [];
      list.replaceChildren(...groups.map(section));
      setAttribute(list, "data-search", asked);
      list.scrollTop = 0;
      setText(none, asked && groups.length === 0 ? t("tasks-none", { search: asked }) : "");
    },
  };
}
