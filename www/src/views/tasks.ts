// What to measure: a tree of controls, cycles and variants, searched by number and by words.

import type { Actions, Variant } from "../actions";
import { variantOf } from "../actions";
import type { Derived } from "../derive";
import { el, keyed, on, setAttribute, setText } from "../dom";
import type { State } from "../state";
import type { Store } from "../store";
import { optional, t } from "../texts";
import type { CycleInfo } from "../wire";

interface Node { id: string; level: number; code: string; title: string; words: string; cycle?: CycleInfo; variant?: Variant; parent: string | null }

function nodes(cycles: CycleInfo[]): Node[] {
  const list: Node[] = [];
  for (const control of [...new Set(cycles.map((cycle) => cycle.control))]) {
    list.push({ id: control, level: 1, code: "", title: t(`control-${control}`), words: "", parent: null });
    for (const cycle of cycles.filter((one) => one.control === control)) list.push(...branch(control, cycle));
  }
  return list;
}

function branch(control: string, cycle: CycleInfo): Node[] {
  const id = `${control}/${cycle.cycle}`;
  const title = t(`${cycle.key}-title`);
  const words = `${t(`control-${control}`)} ${cycle.cycle} ${title} ${optional(`${cycle.key}-words`)}`;
  return [
    { id, level: 2, code: cycle.cycle, title, words, cycle, parent: control },
    ...cycle.variants.map((variant): Node => {
      const name = t(variant.key);
      return { id: `${id}/${variant.mvar}`, level: 3, code: String(variant.mvar), title: name, words: `${words} ${variant.mvar} ${name}`, cycle, variant, parent: id };
    }),
  ];
}

const normal = (text: string): string => text.toLowerCase().normalize("NFKD").replace(/[\u0300-\u036f]/g, "");

/** Every word has to be found; a branch stays while something below it does. */
function matching(all: Node[], search: string): Node[] {
  const words = normal(search).split(/\s+/).filter(Boolean);
  if (words.length === 0) return all;
  const hit = new Set(all.filter((node) => node.words && words.every((word) => normal(node.words).includes(word))).map((node) => node.id));
  for (const node of [...all].reverse()) if (hit.has(node.id) && node.parent) hit.add(node.parent);
  return all.filter((node) => hit.has(node.id));
}

/** Scrolls only when the item is not to be seen, and leaves it some of its neighbours above. */
function bringIntoSight(tree: HTMLElement, item: Element | null): void {
  if (!item) return;
  const [frame, box] = [tree.getBoundingClientRect(), item.getBoundingClientRect()];
  if (box.top < frame.top || box.bottom > frame.bottom) tree.scrollTop += box.top - frame.top - frame.height / 4;
}

export function createTasks(root: HTMLElement, store: Store, actions: Actions): (state: State, derived: Derived) => void {
  const input = el("input", { type: "search", id: "task-search", autocomplete: "off", spellcheck: "false", placeholder: t("tasks-search-hint") });
  const tree = el("div", { role: "tree", "aria-labelledby": "tasks-title", class: "tree" });
  const none = el("p", { class: "empty", role: "status" });
  root.append(
    el("h2", { id: "tasks-title" }, t("tasks-title")),
    el("label", { for: "task-search", class: "visually-hidden" }, t("tasks-search")), input, tree, none,
  );
  let all: Node[] | null = null;
  let shown: Node[] = [];
  let active = "";
  let inSight = ""; // the chosen variant that was scrolled to

  const fold = (id: string, closed: boolean): void => {
    const folded = { ...store.state.folded };
    if (closed) folded[id] = true; else delete folded[id];
    store.update({ folded });
  };
  const pick = (node: Node): void => {
    active = node.id;
    if (node.variant && node.cycle) actions.chooseCycle(node.cycle, node.variant);
    else fold(node.id, !store.state.folded[node.id]);
  };
  const focus = (node: Node | undefined): void => {
    if (!node) return;
    const item = tree.children[shown.indexOf(node)];
    if (!(item instanceof HTMLElement)) return;
    for (const other of tree.querySelectorAll('[tabindex="0"]')) setAttribute(other, "tabindex", -1);
    setAttribute(item, "tabindex", 0);
    active = node.id;
    item.focus();
  };
  const key = (event: KeyboardEvent): void => {
    store.flush(); // the key is meant for what the last one has led to
    const index = shown.findIndex((node) => node.id === active);
    const node = shown[index];
    if (!node) return;
    const closed = !!store.state.folded[node.id] && !store.state.search;
    const moves: Record<string, () => void> = {
      ArrowDown: () => focus(shown[index + 1]),
      ArrowUp: () => focus(shown[index - 1]),
      Home: () => focus(shown[0]),
      End: () => focus(shown.at(-1)),
      ArrowRight: () => node.variant ? undefined : closed ? fold(node.id, false) : focus(shown[index + 1]),
      ArrowLeft: () => node.variant || closed ? focus(shown.find((one) => one.id === node.parent)) : fold(node.id, true),
      Enter: () => pick(node),
      " ": () => pick(node),
    };
    const move = moves[event.key];
    if (!move) return;
    event.preventDefault();
    move();
  };
  on(tree, "keydown", key);
  on(input, "input", () => store.update({ search: input.value }));
  on(input, "keydown", (event) => {
    if (event.key === "ArrowDown") {
      store.flush();
      focus(shown.find((node) => node.variant) ?? shown[0]);
    }
    if (event.key === "Escape") { input.value = ""; store.update({ search: "" }); }
  });

  const make = (node: Node): HTMLElement => {
    const item = el("div", { role: "treeitem", class: `tree-item level-${node.level}`, "aria-level": node.level },
      el("span", { class: "code" }, node.code), el("span", { class: "tree-title" }, node.title));
    on(item, "click", () => pick(node));
    return item;
  };

  return (state, derived) => {
    all ??= nodes(derived.catalogue.cycles);
    const found = matching(all, state.search);
    const hidden = (node: Node): boolean => !!node.parent && !state.search && (!!state.folded[node.parent] || !!all?.some((one) => one.id === node.parent && hidden(one)));
    shown = found.filter((node) => !hidden(node));
    const variant = variantOf(derived.cycle, state.values);
    const chosen = all.find((node) => node.cycle === derived.cycle && node.variant && node.variant === variant);
    if (!shown.some((node) => node.id === active)) active = shown.find((node) => node.id === chosen?.id)?.id ?? shown[0]?.id ?? "";
    keyed(tree, shown, (node) => node.id, make, (item, node) => {
      setAttribute(item, "aria-selected", node.variant ? String(node.id === chosen?.id) : null);
      setAttribute(item, "aria-expanded", node.variant ? null : String(!state.folded[node.id] || !!state.search));
      setAttribute(item, "tabindex", node.id === active ? 0 : -1);
      item.classList.toggle("holds-choice", !node.variant && node.cycle === derived.cycle);
    });
    if (chosen && chosen.id !== inSight) bringIntoSight(tree, tree.querySelector('[aria-selected="true"]'));
    inSight = chosen?.id ?? "";
    setText(none, found.length === 0 ? t("tasks-none", { search: state.search }) : "");
  };
}
