// Words come from Fluent files: core/messages/<language>/ for what the core says, www/messages/<language>/ for the page.
// Nothing here knows which languages there are; English is the one that has every message.

import { FluentBundle, FluentNumber, FluentResource } from "@fluent/bundle";
import type { Message } from "./wire";

const FALLBACK = "en";
const files: Record<string, string> = {
  ...import.meta.glob<string>("../../core/messages/*/*.ftl", { query: "?raw", import: "default", eager: true }),
  ...import.meta.glob<string>("../messages/*/*.ftl", { query: "?raw", import: "default", eager: true }),
};

const bundles = new Map<string, FluentBundle>();
const missing = new Set<string>();
let order: string[] = [FALLBACK];

for (const [path, source] of Object.entries(files)) {
  const language = path.split("/").at(-2) ?? FALLBACK;
  const bundle = bundles.get(language) ?? new FluentBundle(language, { useIsolating: false });
  for (const problem of bundle.addResource(new FluentResource(source))) console.error(`messages: ${path}: ${problem.message}`);
  bundles.set(language, bundle);
}

export function languages(): string[] {
  return [...bundles.keys()].sort();
}

/** Takes the first of the wanted languages that is there, English behind it; gives the one taken. */
export function choose(wanted: readonly string[]): string {
  const found = wanted.map((one) => bundles.has(one) ? one : one.split("-")[0] ?? one).find((one) => bundles.has(one)) ?? FALLBACK;
  order = found === FALLBACK ? [FALLBACK] : [found, FALLBACK];
  return found;
}

function argument(value: number | string): FluentNumber | string {
  return typeof value === "number" ? new FluentNumber(value, { maximumFractionDigits: 6, useGrouping: false }) : value;
}

function pattern(bundle: FluentBundle, key: string) {
  const [id = key, attribute] = key.split(".");
  const message = bundle.getMessage(id);
  return attribute ? message?.attributes[attribute] : message?.value;
}

function find(key: string, args: Record<string, number | string>): string | null {
  for (const language of order) {
    const bundle = bundles.get(language);
    const found = bundle && pattern(bundle, key);
    if (!bundle || !found) continue;
    const problems: Error[] = [];
    const given = Object.fromEntries(Object.entries(args).map(([name, value]) => [name, argument(value)]));
    const text = bundle.formatPattern(found, given, problems);
    for (const problem of problems) note(`${key}: ${problem.message}`);
    return text;
  }
  return null;
}

function note(what: string): void {
  if (missing.has(what)) return;
  missing.add(what);
  console.warn(`messages: ${what}`);
}

/** The text of a key; a key without text shows itself and is logged once. */
export function t(key: string, args: Record<string, number | string> = {}): string {
  const text = find(key, args);
  if (text !== null) return text;
  note(`no text for ${key}`);
  return key;
}

/** The text of a key that may be left out. */
export function optional(key: string): string {
  return find(key, {}) ?? "";
}

/** What the core says. An argument that is itself a key is put into words first. */
export function say(message: Message): string {
  const args = Object.fromEntries(Object.entries(message.args ?? {}).map(([name, value]) => [name, typeof value === "string" ? spoken(value) : value]));
  return t(message.key, args);
}

function spoken(value: string): string {
  return /^[a-z][a-z0-9]*(-[a-z0-9]+)+(\.[a-z]+)?$/.test(value) ? find(value, {}) ?? value : value;
}
