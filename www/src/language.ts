// The language of the page.

import { choose } from "./texts";

/** Puts the words of a language in place; without one, of what the browser wants. */
export async function speak(language: string): Promise<void> {
  document.documentElement.lang = await choose(language ? [language] : navigator.languages);
}

/** A language in its own words, as the browser knows it. */
export function nameOf(language: string): string {
  return new Intl.DisplayNames([language], { type: "language" }).of(language) ?? language;
}
