// Concepts of measuring, a page each, and the terms of the manuals: searched by any word of them. Nothing is kept.

import "../styles/exported.css";
import "../styles/terms.css";
import type { ProgramCore } from "../core/program";
import { el, on, setText, show } from "../dom";
import { helpWords, say, t } from "../texts";
import type { ConceptView, TermsView, TermView } from "../wire";
import { passingDialog, showPassing } from "./passing";
import { createTermPicture } from "./term-picture";

/** What the search finds, and where. */
interface Entry {
  root: HTMLElement;
  words: string;
}

const plain = (text: string): string => text.toLocaleLowerCase();
const entry = (root: HTMLElement): Entry => ({ root, words: plain(root.textContent ?? "") });

/** Data that hold it, and the place in the manual. */
function place(names: string[], source: string): HTMLElement {
  const codes = names.flatMap(name => [el("code", {}, name), " "]);
  return el("small", {}, ...codes, t("field-source", { source }));
}

/** The page of a concept; its picture is drawn once it is opened. */
function page(core: ProgramCore, { id, title, lines, names, source, example }: ConceptView): HTMLDetailsElement {
  const behind = place(names, source);
  const root = el(
    "details",
    { class: "term-page", id: `concept-${id}` },
    el("summary", {}, say(title)),
    ...lines.map(line => el("p", {}, say(line))),
    behind,
  );
  if (example)
    root.addEventListener("toggle", () => behind.before(createTermPicture(core, id, example)), { once: true });
  return root;
}

function definition({ term, meaning, names, see, source }: TermView): HTMLElement {
  const further = see.length ? [el("span", { class: "term-see" }, `→ ${see.map(say).join(", ")}`)] : [];
  return el(
    "div",
    { class: "term" },
    el("dt", {}, say(term)),
    el("dd", {}, el("p", {}, say(meaning)), ...further, place(names, source)),
  );
}

/** Concepts by group, then the terms in the order of the language. */
function list(
  core: ProgramCore,
  { concepts, terms }: TermsView,
): { parts: HTMLElement[]; entries: Entry[]; heads: HTMLElement[] } {
  const parts: HTMLElement[] = [];
  const entries: Entry[] = [];
  const heads: HTMLElement[] = [];
  const head = (text: string): void => {
    const heading = el("h3", {}, text);
    heads.push(heading);
    parts.push(heading);
  };
  let group = "";
  for (const concept of concepts) {
    if (concept.group.key !== group) head(say(concept.group));
    group = concept.group.key;
    const root = page(core, concept);
    parts.push(root);
    entries.push(entry(root));
  }
  head(t("terms-list"));
  const sorted = terms.toSorted((one, other) => say(one.term).localeCompare(say(other.term)));
  const roots = sorted.map(definition);
  parts.push(el("dl", {}, ...roots));
  entries.push(...roots.map(entry));
  return { parts, entries, heads };
}

/** Opens the dialog; `concept`: whose page is open at first. */
export async function openTerms(core: ProgramCore, end: AbortSignal, concept?: string): Promise<void> {
  await helpWords();
  const { parts, entries, heads } = list(core, core.terms());
  const search = el("input", { type: "search", id: "terms-search", placeholder: t("terms-search-hint") });
  const none = el("p", { class: "empty", role: "status" });
  const closing = el("button", { type: "button", class: "primary" }, t("exported-close"));
  const dialog = passingDialog(
    "terms-title",
    t("terms-title"),
    [el("label", { for: search.id }, t("terms-search")), search, none, ...parts],
    [closing],
  );
  const find = (): void => {
    const wanted = plain(search.value).split(/\s+/).filter(Boolean);
    const found = entries.filter(({ root, words }) => {
      const has = wanted.every(word => words.includes(word));
      show(root, has);
      return has;
    });
    for (const head of heads) show(head, wanted.length === 0);
    setText(none, found.length ? "" : t("terms-none"));
    show(none, found.length === 0);
  };
  on(search, "input", find);
  find();
  showPassing(dialog, closing, end, () => {});
  const opened = concept ? dialog.querySelector<HTMLDetailsElement>(`#concept-${concept}`) : null;
  if (!opened) {
    search.focus();
    return;
  }
  opened.open = true;
  opened.scrollIntoView({ block: "start" });
  opened.querySelector("summary")?.focus();
}
