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

interface Finder {
  pattern: RegExp;
  keys: Map<string, string>; // by the word as it is found
}

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

function finder(): Finder | null {
  if (!hasTerms()) return null;
  const known = finders.get(language());
  if (known) return known;
  const keys = new Map<string, string>();
  for (const key of terms)
    for (const name of names(optional(key))) if (!keys.has(asFound(name))) keys.set(asFound(name), key);
  const longest = [...keys.keys()].sort((one, other) => other.length - one.length);
  const part = (name: string): string => {
    const text = RegExp.escape?.(name) ?? name.replace(/[.*+?^${}()|[\]\\/-]/g, "\\$&");
    if (HAN.test(name)) return `(${text})`;
    return `(?<![\\p{L}\\p{N}_])(${text})${ABBREVIATION.test(name) ? "" : ENDINGS}(?![\\p{L}\\p{N}_])`;
  };
  const made = { pattern: new RegExp(longest.map(part).join("|"), "giu"), keys };
  finders.set(language(), made);
  return made;
}

/** A text with its terms as buttons; `seen`: terms that are marked already, which it adds to. */
export function glossed(text: string, seen: Set<string> = new Set()): (string | HTMLElement)[] {
  const finding = finder();
  if (!finding || !text) return [text];
  const parts: (string | HTMLElement)[] = [];
  let from = 0;
  for (const found of text.matchAll(finding.pattern)) {
    const name = found.slice(1).find(Boolean) ?? "";
    const key = finding.keys.get(asFound(name)) ?? "";
    if (!key || seen.has(key)) continue;
    seen.add(key);
    parts.push(text.slice(from, found.index), marked(found[0], key));
    from = found.index + found[0].length;
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
