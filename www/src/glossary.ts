// Terms of the manuals within texts: each is a button, and what the glossary says of it comes up under the pointer, at
// the focus or when it is tapped. Which terms there are the page says once; a text marks each at its first place.

import { guard } from "lit-html/directives/guard.js";
import { el, on } from "./dom";
import { allWords, hasHelp, helpWords, language, optional, t } from "./texts";

const WAITS = 250; // ms that the pointer rests before its term is told
const STAYS = 200; // ms in which it may go from a term to what is told
const EDGE = 8; // px to the edge of the window
const ABBREVIATION = /^\p{Lu}[\p{Lu}\d./-]+$/u;
const HAN = /\p{Script=Han}/u;
const ENDINGS = "(?:e?s|e?n|er?)?"; // plural and case of English and German

/** A name of a term, and what finds it where it begins in a text. */
interface Name {
  key: string;
  pattern: RegExp;
}

/**
 * The names by how they begin, the longest first: a text asks at each place only for what can begin there. One pattern
 * for all of them takes the page half a second.
 */
type Finder = Map<string, Name[]>;

const BEGIN = 2; // characters; no name is shorter

let terms: readonly string[] = [];
const finders = new Map<string, Finder>(); // by language

/** The keys of their names. */
export function knowTerms(keys: readonly string[]): void {
  terms = keys;
  finders.clear();
}

/** Whether texts can be marked: terms and their names have come. */
export function hasTerms(): boolean {
  return allWords() && terms.length > 0;
}

/** What a text may write for a term: its names, and an abbreviation in brackets. */
function names(title: string): string[] {
  return title
    .split(/[,，、]/)
    .flatMap(part => {
      const [, name = part, short = ""] = /^(.*?)\s*[(（]([^)）]+)[)）]\s*$/u.exec(part) ?? [];
      return [name, ABBREVIATION.test(short) || short.includes(" ") || HAN.test(short) ? short : ""];
    })
    .map(name => name.trim())
    .filter(name => name.length > 1);
}

const asFound = (word: string): string => (ABBREVIATION.test(word) ? word : word.toLocaleLowerCase());
const begin = (text: string, at = 0): string => text.slice(at, at + BEGIN).toLocaleLowerCase();

function pattern(name: string): RegExp {
  const text = RegExp.escape?.(name) ?? name.replace(/[.*+?^${}()|[\]\\/-]/g, "\\$&");
  if (HAN.test(name)) return new RegExp(text, "iuy");
  const alone = (word: string): string => `(?<![\\p{L}\\p{N}_])${word}(?![\\p{L}\\p{N}_])`;
  // “IS” is an abbreviation, “is” is not
  return ABBREVIATION.test(name) ? new RegExp(alone(text), "uy") : new RegExp(alone(text + ENDINGS), "iuy");
}

function finder(): Finder | null {
  if (!hasTerms()) return null;
  const known = finders.get(language());
  if (known) return known;
  const keys = new Map<string, string>();
  for (const key of terms)
    for (const name of names(optional(key))) if (!keys.has(asFound(name))) keys.set(asFound(name), key);
  const longest = [...keys].sort(([one], [other]) => other.length - one.length);
  const made: Finder = new Map();
  for (const [name, key] of longest) {
    const alike = made.get(begin(name)) ?? [];
    made.set(begin(name), [...alike, { key, pattern: pattern(name) }]);
  }
  finders.set(language(), made);
  return made;
}

/** The longest name that begins at a place of a text, with what may be behind it. */
function nameAt(finding: Finder, text: string, at: number): { key: string; word: string } | null {
  for (const { key, pattern } of finding.get(begin(text, at)) ?? []) {
    pattern.lastIndex = at;
    const [word] = pattern.exec(text) ?? [];
    if (word) return { key, word };
  }
  return null;
}

/** A text with its terms as buttons; `seen`: terms that are marked already, which it adds to. */
export function glossed(text: string, seen: Set<string> = new Set()): (string | HTMLElement)[] {
  const finding = finder();
  if (!finding || !text) return [text];
  const parts: (string | HTMLElement)[] = [];
  let from = 0;
  for (let at = 0; at < text.length; ) {
    const found = nameAt(finding, text, at);
    if (found && !seen.has(found.key)) {
      seen.add(found.key);
      parts.push(text.slice(from, at), marked(found.word, found.key));
      from = at + found.word.length;
    }
    at += found?.word.length ?? 1;
  }
  return [...parts, text.slice(from)].filter(part => part !== "");
}

/** The same within a template, kept while the text stays. */
export function glossPart(text: string, seen?: Set<string>): unknown {
  return guard([text, hasTerms()], () => glossed(text, seen));
}

function marked(word: string, key: string): HTMLElement {
  const button = el("button", { type: "button", class: "gloss", "data-term": key }, word);
  on(button, "pointerenter", ({ pointerType }) => {
    if (pointerType === "mouse") later(() => tell(button, key), WAITS);
  });
  on(button, "pointerleave", ({ pointerType }) => {
    if (pointerType === "mouse") later(hide, STAYS);
  });
  on(button, "focus", () => tell(button, key));
  on(button, "blur", hide);
  on(button, "click", () => tell(button, key));
  return button;
}

let tip: HTMLElement | null = null;
let told: HTMLElement | null = null; // the term whose meaning is shown
let waiting: ReturnType<typeof setTimeout> | undefined;

function later(does: () => void, after: number): void {
  clearTimeout(waiting);
  waiting = setTimeout(does, after);
}

function create(): HTMLElement {
  const made = el("div", { id: "gloss-tip", class: "gloss-tip", role: "tooltip", popover: "manual" });
  on(made, "pointerenter", () => clearTimeout(waiting));
  on(made, "pointerleave", () => later(hide, STAYS));
  const leaves = (event: KeyboardEvent): void => {
    if (event.key !== "Escape" || !told) return;
    event.preventDefault(); // the dialog below stays
    event.stopPropagation();
    hide();
  };
  document.addEventListener("keydown", leaves, { capture: true });
  document.addEventListener("scroll", ({ target }) => target !== made && hide(), { capture: true, passive: true });
  return made;
}

function hide(): void {
  clearTimeout(waiting);
  told?.removeAttribute("aria-describedby");
  told = null;
  if (tip?.isConnected && tip.matches(":popover-open")) tip.hidePopover();
}

function tell(at: HTMLElement, key: string): void {
  clearTimeout(waiting);
  if (told === at || !at.isConnected) return;
  hide();
  tip ??= create();
  told = at;
  // what is outside of an open dialog is out of reach
  (at.closest("dialog") ?? document.body).append(tip);
  at.setAttribute("aria-describedby", tip.id);
  fill(tip, key, at);
  if (hasHelp()) return;
  const filled = (): void => {
    if (told === at && tip) fill(tip, key, at);
  };
  helpWords().then(filled, console.error);
}

function fill(tip: HTMLElement, key: string, at: HTMLElement): void {
  const meaning = optional(`${key}-is`) || t("help-coming");
  tip.replaceChildren(el("strong", {}, t(key)), el("span", {}, meaning));
  tip.showPopover();
  place(tip, at);
}

/** Below the term, above it where there is no room. */
function place(tip: HTMLElement, at: HTMLElement): void {
  const word = at.getBoundingClientRect();
  const { width, height } = tip.getBoundingClientRect();
  const left = Math.max(EDGE, Math.min(word.left, innerWidth - width - EDGE));
  const below = word.bottom + 4;
  const top = below + height > innerHeight - EDGE ? Math.max(EDGE, word.top - height - 4) : below;
  tip.style.setProperty("left", `${Math.round(left)}px`);
  tip.style.setProperty("top", `${Math.round(top)}px`);
}
