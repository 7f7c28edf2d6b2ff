// Light, dark or high contrast: as chosen, or as the system wants it.

import { setAttribute } from "./dom";

/** What can be chosen. */
export type Theme = "system" | Shown;
/** What is seen. */
export type Shown = "light" | "dark" | "contrast";

/** In the order in which a button goes through them. */
export const THEMES: readonly Theme[] = ["system", "light", "dark", "contrast"];

const contrast = matchMedia("(prefers-contrast: more) and (forced-colors: none)");
const dark = matchMedia("(prefers-color-scheme: dark)");

export function shownTheme(theme: Theme): Shown {
  if (theme !== "system") return theme;
  if (contrast.matches) return "contrast";
  return dark.matches ? "dark" : "light";
}

/** `changed` when the system wants another theme than before. */
export function watchTheme(changed: () => void): void {
  for (const wish of [contrast, dark]) wish.addEventListener("change", changed);
}

/** In the page, and in the frame that the system draws around it. */
export function drawTheme(theme: Theme): void {
  const shown = shownTheme(theme);
  if (document.documentElement.dataset.theme === shown) return;
  document.documentElement.dataset.theme = shown;
  for (const colour of document.querySelectorAll<HTMLMetaElement>('meta[name="theme-color"]'))
    setAttribute(colour, "media", colour.dataset.theme === shown ? "all" : "not all");
}
