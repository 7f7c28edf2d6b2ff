// Words by key, in the language that is chosen. They come as the build cuts them (words.ts): English with the page and
// behind its first form, it is what a missing word falls back to; another language when it is chosen; help pages are
// long and read by few, and come when one is opened. Nothing here knows which languages there are.

import { first, help, later, whole } from "words:all";
import { FluentNumber } from "@fluent/bundle";
import { createMessages, type Messages } from "./fluent";
import type { Message } from "./wire";

const FALLBACK = "en";
let complete = false; // whether all of English is here
const bundles = new Map<string, Messages>([[FALLBACK, made(FALLBACK, first)]]);
const missing = new Set<string>();
let order: string[] = [FALLBACK];
const helped = new Set<string>(); // languages whose words of help are here
const fetched = new Map<string, Promise<void>>(); // words that are on the way or here, by what they are

function made(language: string, words: string): Messages {
  const messages = createMessages(language);
  messages.add(words);
  return messages;
}

/** The English words that the first form does without. */
export async function laterWords(): Promise<void> {
  bundles.get(FALLBACK)?.add(await later());
  complete = true;
}

/** Whether all words of English have come. */
export function allWords(): boolean {
  return complete;
}

/** The words of the help pages, in the language that is spoken. */
export async function helpWords(): Promise<void> {
  await Promise.all(order.map(one => once(`${one} help`, () => fetchHelp(one))));
}

/** Who asks while words are on the way gets the same ones; what failed may be had the next time. */
function once(what: string, fetch: () => Promise<void>): Promise<void> {
  const known = fetched.get(what);
  if (known) return known;
  const coming = fetch();
  fetched.set(what, coming);
  coming.catch(() => fetched.delete(what));
  return coming;
}

async function fetchHelp(one: string): Promise<void> {
  const words = await help[one]?.();
  if (words !== undefined) bundles.get(one)?.add(words);
  helped.add(one);
}

/** Whether they have come. */
export function hasHelp(): boolean {
  return order.every(one => helped.has(one));
}

/** Codes of the languages that there are. */
export function languages(): string[] {
  return [FALLBACK, ...Object.keys(whole)].sort();
}

/** The one whose words are shown. */
export function language(): string {
  return order[0] ?? FALLBACK;
}

async function fetchWords(language: string): Promise<void> {
  const words = await whole[language]?.();
  if (words !== undefined) bundles.set(language, made(language, words));
}

/** Fetches the words of every language, but for the help pages. */
export async function everyLanguage(): Promise<void> {
  await Promise.all(languages().map(one => once(one, () => fetchWords(one))));
}

/** Fetches the first of the wanted languages that there is and speaks it, English behind it; gives the one taken. */
export async function choose(wanted: readonly string[]): Promise<string> {
  const there = languages();
  const found =
    wanted.map(one => (there.includes(one) ? one : (one.split("-")[0] ?? one))).find(one => there.includes(one)) ??
    FALLBACK;
  await once(found, () => fetchWords(found));
  order = [...new Set([found, FALLBACK])];
  return found;
}

const figures = new Intl.NumberFormat(FALLBACK, { maximumFractionDigits: 6, useGrouping: false });

/** A number with a point in every language, as the control writes it. */
class Figure extends FluentNumber {
  override toString(): string {
    return figures.format(this.value);
  }
}

function argument(value: number | string): FluentNumber | string {
  return typeof value === "number" ? new Figure(value) : value;
}

function pattern(messages: Messages, key: string) {
  const [id = key, attribute] = key.split(".");
  return messages.pattern(id, attribute);
}

type Args = Record<string, number | string>;
const NONE: Args = {};
/**
 * Texts without arguments by language and key: what a bundle once says it says for good, and most of a page is that.
 */
const fixed = new Map<string, string>();

function find(key: string, args: Args, within: readonly string[] = order): string | null {
  for (const language of within) {
    const place = `${language} ${key}`;
    const known = args === NONE ? fixed.get(place) : undefined;
    if (known !== undefined) return known;
    const bundle = bundles.get(language);
    const found = bundle && pattern(bundle, key);
    if (!bundle || !found) continue;
    const problems: Error[] = [];
    const given = Object.fromEntries(Object.entries(args).map(([name, value]) => [name, argument(value)]));
    const text = bundle.format(found, given, problems);
    for (const problem of problems) note(`${key}: ${problem.message}`);
    if (args === NONE && problems.length === 0) fixed.set(place, text);
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
export function t(key: string, args: Args = NONE): string {
  const text = find(key, args);
  if (text !== null) return text;
  if (!complete) return ""; // still on its way; the page is drawn again when it has come
  note(`no text for ${key}`);
  return key;
}

/** The text of a key that may be left out. */
export function optional(key: string): string {
  return find(key, NONE) ?? "";
}

/** The English text of a key, for those who look something up by its English name. */
export function inEnglish(key: string): string {
  return find(key, NONE, [FALLBACK]) ?? "";
}

/** The texts of a key in each language whose words have come, for those who know its name in another one. */
export function inEach(key: string): string {
  return [...new Set([...bundles.keys()].map(language => find(key, NONE, [language]) ?? ""))].join(" ");
}

/** What the core says. An argument that is itself a key is put into words first. */
export function say(message: Message): string {
  const given = Object.entries(message.args ?? {});
  if (given.length === 0) return t(message.key);
  const args = Object.fromEntries(
    given.map(([name, value]) => [name, typeof value === "string" ? spoken(value) : value]),
  );
  return t(message.key, args);
}

/** What a finding advises: it may name what its cause names. */
export const sayHint = ({ message, hint }: { message: Message; hint?: Message | undefined }): string =>
  hint ? say({ ...hint, args: { ...message.args, ...hint.args } }) : "";

/** Names one behind the other, as the language lists them. */
export const listed = (names: readonly string[]): string =>
  names.reduce((one, other) => (one ? t("list-pair", { one, other }) : other), "");

/** Why the core refused something: a message as JSON, with its place; what anybody else says stays as it is. */
export function sayProblem(problem: string): string {
  const refused = refusal(problem);
  if (!refused) return problem;
  const { line, column = 1 } = refused;
  return line === undefined ? say(refused) : t("refused-place", { line, column, text: say(refused) });
}

/** Whether a problem names the line of a document that it is about. */
export const isPlaced = (problem: string): boolean => refusal(problem)?.line !== undefined;

/** Why a document is refused; null: the problem is told in words already. */
export function refusal(problem: string): (Message & { line?: number; column?: number }) | null {
  try {
    const read = JSON.parse(problem);
    return typeof read?.key === "string" ? read : null;
  } catch {
    return null; // the browser's own words
  }
}

function spoken(value: string): string {
  return /^[a-z][a-z0-9]*(-[a-z0-9]+)+(\.[a-z]+)?$/.test(value) ? (find(value, NONE) ?? value) : value;
}
