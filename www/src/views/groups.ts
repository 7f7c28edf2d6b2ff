// The fields of a form in sections by what they are about. A section with something to fill in stands open; of another
// one line says what in it differs from delivery.

import { el, keyed, on, setAttribute, show } from "../dom";
import { icon } from "../icons";
import { plain } from "../numbers";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { say, t } from "../texts";
import type { Field, Topic } from "../wire";

const TOPICS: readonly Topic[] = ["task", "correction", "approach", "tolerances", "statistics", "probe", "list"];
const NAMED = 3; // values in the line of a folded section
const ENTRY = ".entry-line > .figure";

/** Asks the section around a node to open; it does so at once. */
export function reveal(node: Element | null): void {
  node?.dispatchEvent(new Event("reveal", { bubbles: true }));
}

const idOf = (topic: Topic): string => `form/${topic}`;

/** As it would be read out: the name of a choice, else the number with its unit. */
function worthOf(field: Field): string {
  const text = field.expression ?? field.value;
  const choices = field.kind === "choice" ? field.choices : [];
  const chosen = choices.find(({ value }) => String(value) === field.value.trim());
  if (chosen && field.expression === undefined) return say(chosen.label);
  return field.unit ? `${text} ${t(`unit-${field.unit.replace("/", "-per-")}`)}` : text;
}

/** Whether something else is entered than what counts anyway. */
function differs({ value, expression, fallback }: Field): boolean {
  if (expression !== undefined) return true;
  const typed = value.trim();
  return typed !== "" && (fallback === undefined || typed !== plain(fallback));
}

/** A piece of the line of a folded section: a value is the way to its field. */
interface Said {
  text: string;
  field?: string;
}

function summaryOf(fields: readonly Field[]): Said[] {
  const changed = fields.filter(differs);
  const named = changed
    .slice(0, NAMED)
    .map(field => ({ text: `${say(field.label)} ${worthOf(field)}`, field: field.name }));
  const more = changed.length - named.length;
  const all: Said[] = more > 0 ? [...named, { text: t("group-more", { count: more }) }] : named;
  return all.length ? all : [{ text: t("group-as-delivered") }];
}

function drawSummary(node: HTMLElement, all: readonly Said[]): void {
  if (node.textContent === all.map(({ text }) => text).join(" · ")) return;
  const piece = ({ text, field }: Said): HTMLElement => el("span", { "data-leads": field }, text);
  node.replaceChildren(...all.flatMap((one, index) => [...(index ? [" · "] : []), piece(one)]));
}

interface Group {
  topic: Topic;
  fields: Field[];
}

function grouped(fields: readonly Field[]): Group[] {
  return TOPICS.map(topic => ({ topic, fields: fields.filter(field => field.topic === topic) })).filter(
    group => group.fields.length > 0,
  );
}

/** Chosen by hand, else as it is needed. `troubled`: with an error or a warning. */
function isOpen({ topic, fields }: Group, { panels, form }: State, troubled: ReadonlySet<string>): boolean {
  const chosen = panels.unfolded[idOf(topic)] ?? (panels.unfolded[ALL] || undefined);
  return (
    chosen ??
    (topic === "task" || fields.some(({ name, required }) => required || troubled.has(name) || name === form.focus))
  );
}

/** All sections are open until one is folded by hand. */
const ALL = "form";

export interface Groups {
  /** The button that opens all sections, or lets them be as they are needed. */
  all: HTMLButtonElement;
  draw(fields: readonly Field[], state: State, troubled: ReadonlySet<string>): void;
}

export function createGroups(
  root: HTMLElement,
  store: Store,
  keyOf: (field: Field) => string,
  drawings: Partial<Record<Topic, HTMLElement>>, // above the fields of a section
  make: (field: Field) => HTMLElement,
  update: (node: HTMLElement, field: Field) => void,
): Groups {
  const choose = (chosen: Record<string, boolean>): void =>
    store.update(({ panels: { unfolded } }) => {
      const others = Object.entries(unfolded).filter(([id]) => !id.startsWith(ALL) || !(ALL in chosen));
      return { panels: { unfolded: { ...Object.fromEntries(others), ...chosen } } };
    });
  const all = el("button", { type: "button", class: "quiet fields-all" }, t("fields-all"));
  on(all, "click", () => choose({ [ALL]: !store.state.panels.unfolded[ALL] }));

  const makeGroup = ({ topic }: Group): HTMLElement => {
    const id = `group-${topic}`;
    const head = el("button", { type: "button", class: "group-head", "aria-controls": id });
    head.append(
      icon("right"),
      el("span", { class: "group-name" }, t(`topic-${topic}`)),
      el("span", { class: "group-sum" }),
    );
    const body = el("div", { id, class: "group-fields" });
    on(head, "click", event => {
      const opens = body.hasAttribute("hidden");
      const name = (event.target as Element).closest<HTMLElement>("[data-leads]")?.dataset.leads;
      choose({ [idOf(topic)]: opens });
      store.flush();
      if (!opens) return;
      body.parentElement?.scrollIntoView({ block: "nearest" });
      const field = name ? body.querySelector<HTMLElement>(`[data-field="${name}"] ${ENTRY}`) : null;
      field?.focus();
      if (field instanceof HTMLInputElement) field.select();
    });
    on(body, "focusin", () => {
      if (!store.state.panels.unfolded[idOf(topic)] && !store.state.panels.unfolded[ALL])
        choose({ [idOf(topic)]: true });
    });
    body.addEventListener("reveal", () => {
      show(body, true);
      choose({ [idOf(topic)]: true });
    });
    return el("section", { class: "group", "data-topic": topic }, el("h3", {}, head), drawings[topic] ?? null, body);
  };

  return {
    all,
    draw(fields, state, troubled) {
      const groups = grouped(fields);
      setAttribute(all, "aria-pressed", String(!!state.panels.unfolded[ALL]));
      show(all, groups.length > 1);
      keyed(
        root,
        groups,
        ({ topic }) => topic,
        makeGroup,
        (node, group) => {
          const open = groups.length === 1 || isOpen(group, state, troubled);
          const [heading, body] = [node.firstElementChild, node.lastElementChild] as [HTMLElement, HTMLElement];
          const drawing = drawings[group.topic];
          const head = heading.firstElementChild as HTMLElement;
          show(heading, groups.length > 1);
          setAttribute(head, "aria-expanded", String(open));
          drawSummary(head.lastElementChild as HTMLElement, open ? [] : summaryOf(group.fields));
          show(body, open);
          if (drawing) show(drawing, open);
          keyed(body, group.fields, keyOf, make, update);
        },
      );
    },
  };
}
