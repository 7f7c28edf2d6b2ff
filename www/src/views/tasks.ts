// Measuring task: a tree of what is measured on which machine, cycles and variants; a search over everything.

import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import type { Variant } from "../desk/variants";
import { variantOf } from "../desk/variants";
import { el, keyed, on, setAttribute, setText, show } from "../dom";
import { type Command, meantBy } from "../keys";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import type { CycleInfo, Purpose } from "../wire";
import type { Found } from "./found";

interface Node {
  id: string;
  level: number;
  code: string;
  title: string;
  cycle?: CycleInfo;
  variant?: Variant;
  parent: string | null;
}

const MACHINES: Purpose["machine"][] = ["milling", "turning", "any"];
const USES = ["workpiece", "tool", "calibrate", "none", "log"] as const;

function use({ probe, calibrates }: Purpose): (typeof USES)[number] {
  return calibrates ? "calibrate" : probe;
}

/** Three levels: what is measured on which machine, the cycle, the variant. */
function nodes(cycles: CycleInfo[]): Node[] {
  const controls = [...new Set(cycles.map(cycle => cycle.control))];
  const groups = controls.flatMap(control =>
    MACHINES.flatMap(machine => USES.map(what => ({ control, machine, what }))),
  );
  return groups.flatMap(({ control, machine, what }) => {
    const own = cycles.filter(
      cycle => cycle.control === control && cycle.purpose.machine === machine && use(cycle.purpose) === what,
    );
    const id = `${control}/${machine}/${what}`;
    const group: Node = {
      id,
      level: 1,
      code: t(`control-${control}`),
      title: t(`group-${machine}-${what}`),
      parent: null,
    };
    return own.length ? [group, ...own.flatMap(cycle => branch(id, cycle))] : [];
  });
}

function branch(parent: string, cycle: CycleInfo): Node[] {
  const id = `${cycle.control}/${cycle.cycle}`;
  return [
    { id, level: 2, code: cycle.cycle, title: t(`${cycle.key}-title`), cycle, parent },
    ...cycle.variants.map(
      (variant): Node => ({
        id: `${id}/${variant.mvar}`,
        level: 3,
        code: String(variant.mvar),
        title: t(variant.key),
        cycle,
        variant,
        parent: id,
      }),
    ),
  ];
}

/** Scrolls only when the item is not to be seen, and leaves it some of its neighbours above. */
function bringIntoSight(tree: HTMLElement, item: Element | null): void {
  if (!item) return;
  const [frame, box] = [tree.getBoundingClientRect(), item.getBoundingClientRect()];
  if (box.top < frame.top || box.bottom > frame.bottom) tree.scrollTop += box.top - frame.top - frame.height / 4;
}

export function createTasks(
  root: HTMLElement,
  store: Store,
  actions: Actions,
  createFound: (back: () => void) => Found,
): (state: State, derived: Derived) => void {
  const input = el("input", {
    type: "search",
    id: "task-search",
    autocomplete: "off",
    spellcheck: "false",
    placeholder: t("tasks-search-hint"),
  });
  const tree = el("div", { role: "tree", "aria-labelledby": "tasks-title", class: "tree" });
  const others = el("p", { class: "empty", role: "status" }); // what is said while the tree knows the first cycle alone
  const found = createFound(() => input.focus());
  root.append(
    el("h2", { id: "tasks-title" }, t("tasks-title")),
    el("label", { for: "task-search", class: "visually-hidden" }, t("tasks-search")),
    input,
    tree,
    others,
    found.root,
  );
  let cycles: CycleInfo[] = []; // of the tree: a few, until all are known
  let all: Node[] = [];
  let shown: Node[] = [];
  let active = "";
  let inSight = ""; // the chosen variant that was scrolled to

  let holding = new Set<string>(); // the branches that hold the choice

  /** As it was set by hand; else open around the choice. */
  const isOpen = (id: string): boolean => store.state.panels.unfolded[id] ?? holding.has(id);
  const unfold = (id: string, open: boolean): void =>
    store.update({ panels: { unfolded: { ...store.state.panels.unfolded, [id]: open } } });
  /** Around the old choice, so that nothing moves away under the pointer. */
  const keepOpen = (): void =>
    store.update(({ panels: { unfolded } }) => ({
      panels: { unfolded: { ...Object.fromEntries([...holding].map(id => [id, true])), ...unfolded } },
    }));
  /** The variant is chosen: its form takes the place of the tree. */
  const leave = (): void => {
    const inside = root.contains(document.activeElement);
    actions.panel("form");
    if (inside) document.getElementById("panel-form")?.focus();
  };
  const pick = (node: Node): void => {
    active = node.id;
    if (node.variant && node.cycle) {
      keepOpen();
      actions.chooseCycle(node.cycle, node.variant);
      leave();
    } else unfold(node.id, !isOpen(node.id));
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
    const index = shown.findIndex(node => node.id === active);
    const node = shown[index];
    if (!node) return;
    const closed = !node.variant && !isOpen(node.id);
    const moves: Partial<Record<Command<"list">, () => void>> = {
      next: () => focus(shown[index + 1]),
      previous: () => focus(shown[index - 1]),
      first: () => focus(shown[0]),
      last: () => focus(shown.at(-1)),
      unfold: () => (node.variant ? undefined : closed ? unfold(node.id, true) : focus(shown[index + 1])),
      fold: () => (node.variant || closed ? focus(shown.find(one => one.id === node.parent)) : unfold(node.id, false)),
      choose: () => pick(node),
    };
    const move = moves[meantBy(event, "list") ?? "leave"];
    if (!move) return;
    event.preventDefault();
    move();
  };
  on(tree, "keydown", key);
  on(input, "focus", () => found.load());
  on(input, "input", () => store.update({ page: { search: input.value } }));
  on(input, "keydown", event => {
    const command = meantBy(event, "list");
    if (command === "next") {
      event.preventDefault();
      store.flush();
      if (store.state.page.search) found.focusFirst();
      else focus(shown.find(node => node.variant) ?? shown[0]);
    }
    if (command === "leave" && input.value !== "") {
      event.preventDefault();
      input.value = "";
      store.update({ page: { search: "" } });
    }
  });

  const make = (node: Node): HTMLElement => {
    const item = el(
      "div",
      { role: "treeitem", class: `tree-item level-${node.level}`, "aria-level": node.level },
      el("span", { class: "code" }, node.code),
      el("span", { class: "tree-title" }, node.title),
    );
    on(item, "click", () => pick(node));
    return item;
  };

  return (state, derived) => {
    if (cycles !== derived.catalogue.cycles) {
      cycles = derived.catalogue.cycles;
      all = nodes(cycles);
    }
    const variant = variantOf(derived);
    const chosen = all.find(node => node.cycle === derived.cycle && node.variant && node.variant === variant);
    const parent = all.find(node => !node.variant && node.cycle === derived.cycle);
    holding = new Set([parent?.id ?? "", parent?.parent ?? ""]);
    const open = new Set(all.filter(node => !node.variant && isOpen(node.id)).map(node => node.id));
    const above = new Map(all.map(node => [node.id, node.parent]));
    const next = all.filter(
      ({ parent }) => parent === null || (open.has(parent) && open.has(above.get(parent) ?? parent)),
    );
    const still = keepPlace(tree, next.length !== shown.length);
    shown = next;
    if (!shown.some(node => node.id === active))
      active = shown.find(node => node.id === chosen?.id)?.id ?? shown[0]?.id ?? "";
    keyed(
      tree,
      shown,
      node => node.id,
      make,
      (item, node) => {
        setAttribute(item, "aria-selected", node.variant ? String(node.id === chosen?.id) : null);
        setAttribute(item, "aria-expanded", node.variant ? null : String(open.has(node.id)));
        setAttribute(item, "tabindex", node.id === active ? 0 : -1);
        item.classList.toggle("holds-choice", !node.variant && holding.has(node.id));
      },
    );
    still();
    if (input.value !== state.page.search) input.value = state.page.search;
    const searching = state.page.search.trim() !== "";
    show(tree, !searching);
    show(others, !searching && derived.simulates !== "yes");
    setText(
      others,
      derived.simulates === "yes" ? "" : t(derived.simulates === "coming" ? "tasks-coming" : "tasks-absent"),
    );
    setAttribute(tree, "aria-busy", derived.simulates === "coming" ? "true" : null);
    found.draw(state);
    if (state.panels.left !== "tasks") return;
    if (chosen && chosen.id !== inSight) bringIntoSight(tree, tree.querySelector('[aria-selected="true"]'));
    inSight = chosen?.id ?? "";
  };
}

/** What has the focus stays under the eye while branches above it open or close. */
function keepPlace(tree: HTMLElement, changes: boolean): () => void {
  const item = changes && tree.contains(document.activeElement) ? document.activeElement : null;
  const before = item?.getBoundingClientRect().top ?? 0;
  return () => {
    if (item?.isConnected) tree.scrollTop += item.getBoundingClientRect().top - before;
  };
}
