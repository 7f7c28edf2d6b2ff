// Guides to what the page does, concepts of measuring, a page each, and the terms of the manuals: searched by any word
// of them. Nothing is kept.

import "../styles/exported.css";
import "../styles/terms.css";
import type { ProgramCore } from "../core/program";
import { el, on, setText, show } from "../dom";
import { glossed } from "../glossary";
import { helpWords, optional, say, t } from "../texts";
import type { ConceptView, GuideView, Message, TermsView, TermView } from "../wire";
import { passingDialog, printNow, showPassing } from "./passing";
import { createTermPicture, printedPicture, type TermPicture } from "./term-picture";

/** What the search finds, and where. */
interface Entry {
  root: HTMLElement;
  words: string;
}

const plain = (text: string): string => text.toLocaleLowerCase();
const entry = (root: HTMLElement, more = ""): Entry => ({ root, words: plain(`${root.textContent} ${more}`) });

/** Data that hold it, and the place in the manual. */
function place(names: string[], source: string): HTMLElement {
  const codes = names.flatMap(name => [el("code", {}, name), " "]);
  return el("small", {}, ...codes, t("field-source", { source }));
}

/** The page of a concept; its picture is drawn once it is opened. */
function page(core: ProgramCore, concept: ConceptView): HTMLDetailsElement {
  const { id, title, lines, names, source, example, still } = concept;
  const behind = place(names, source);
  const seen = new Set<string>(); // a page marks each term once
  const printing = el("button", { type: "button" }, t("terms-print"));
  const root = el(
    "details",
    { class: "term-page", id: `concept-${id}` },
    el("summary", {}, say(title)),
    ...lines.map(line => el("p", {}, ...glossed(say(line), seen))),
    still ? el("p", {}, el("small", {}, say(still))) : null,
    behind,
    el("p", {}, printing),
  );
  let picture: TermPicture | null = null;
  on(printing, "click", () => printPage(core, concept, picture?.value()));
  if (example)
    root.addEventListener(
      "toggle",
      () => {
        picture = createTermPicture(core, id, example);
        behind.before(picture.root);
      },
      { once: true },
    );
  return root;
}

/** The page of a concept on paper, with its picture as it is shown. */
function printPage(core: ProgramCore, concept: ConceptView, value: number | undefined): void {
  const { id, title, lines, names, source, example, still } = concept;
  const picture = example ? printedPicture(core, id, example, value ?? example.value) : null;
  const told = lines.map(line => el("p", {}, say(line)));
  const parts = [...told, picture, still ? el("p", {}, say(still)) : null, place(names, source)];
  printNow({ paper: "concept", title: say(title), parts });
}

/** `go`: leads to what it tells about; null: from there it was opened. */
function guidePage(
  { title, lines, way, terminal, source }: GuideView,
  go: ((way: string) => void) | null,
): HTMLElement {
  const going = el("button", { type: "button" }, t("guide-go"));
  on(going, "click", () => go?.(way));
  return el(
    "details",
    { class: "term-page", id: title.key },
    el("summary", {}, say(title)),
    ...lines.map(line => el("p", {}, say(line))),
    el("p", {}, el("small", {}, t("terms-terminal"))),
    el("pre", { tabindex: "0" }, terminal.join("\n")),
    source ? place([], source) : null,
    go ? el("p", {}, going) : null,
  );
}

function definition({ term, meaning, names, see, source }: TermView): HTMLElement {
  const further = see.length ? [el("span", { class: "term-see" }, `→ ${see.map(say).join(", ")}`)] : [];
  return el(
    "div",
    { class: "term", id: term.key, tabindex: "-1" },
    el("dt", {}, say(term)),
    el("dd", {}, el("p", {}, ...glossed(say(meaning), new Set([term.key]))), ...further, place(names, source)),
  );
}

/** Guides and concepts by group, then the terms in the order of the language. */
function list(
  core: ProgramCore,
  { guides, concepts, terms }: TermsView,
  go: ((way: string) => void) | null,
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
  const add = (under: Message, root: HTMLElement, more = ""): void => {
    if (under.key !== group) head(say(under));
    group = under.key;
    parts.push(root);
    entries.push(entry(root, more));
  };
  for (const guide of guides) add(guide.group, guidePage(guide, go), optional(`${guide.title.key}-words`));
  for (const concept of concepts) add(concept.group, page(core, concept));
  head(t("terms-list"));
  const sorted = terms.toSorted((one, other) => say(one.term).localeCompare(say(other.term)));
  const roots = sorted.map(definition);
  parts.push(el("dl", {}, ...roots));
  entries.push(...roots.map(root => entry(root)));
  return { parts, entries, heads };
}

/** Opens the dialog; `go`: leads to what a guide tells about; `first`: id of the page that is open at first. */
export async function openTerms(
  core: ProgramCore,
  end: AbortSignal,
  go: (way: string) => void,
  first?: string,
): Promise<void> {
  await helpWords();
  const leave = (way: string): void => {
    dialog.close();
    go(way);
  };
  const inDialog = document.querySelector("dialog[open]") !== null; // what it tells about, or something else
  const { parts, entries, heads } = list(core, core.terms(), inDialog ? null : leave);
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
  const opened = first ? dialog.querySelector<HTMLElement>(`#${first}`) : null;
  if (!opened) {
    search.focus();
    return;
  }
  if (opened instanceof HTMLDetailsElement) opened.open = true;
  opened.scrollIntoView({ block: "start" });
  (opened.querySelector("summary") ?? opened).focus();
}
