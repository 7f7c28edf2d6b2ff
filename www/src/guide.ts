// The way to a guide, from wherever something is that it tells about: an event that the page hears, so that no dialog
// has to know who shows guides.

import { guard } from "lit-html/directives/guard.js";
import { el, on } from "./dom";
import { icon } from "./icons";
import { t } from "./texts";

const ASKED = "probewright-guide";

/** `key`: stem of the messages of a guide, or the name of a concept, a term, a connection. */
export function openGuide(key: string): void {
  document.dispatchEvent(new CustomEvent(ASKED, { detail: key }));
}

/** Whether what is found of this kind is shown by `openGuide`. */
export const isExplained = (kind: string): boolean => ["guide", "connection", "concept", "term"].includes(kind);

/** A question mark that leads to the guide with this id. */
export function guideButton(id: string): HTMLButtonElement {
  const key = `guide-${id}`;
  const named = { "aria-label": t("guide-open"), title: t(key) };
  const button = el("button", { type: "button", class: "quiet guide-open", "data-guide": id, ...named }, icon("help"));
  on(button, "click", () => openGuide(key));
  return button;
}

/** The same within a template. */
export function guidePart(id: string): unknown {
  return guard([id], () => guideButton(id));
}

/** `show`: shows the guide with these messages, until `end`. */
export function listenToGuides(show: (key: string) => void, end: AbortSignal): void {
  const heard = (event: Event): void => show((event as CustomEvent<string>).detail);
  document.addEventListener(ASKED, heard, { signal: end });
}
