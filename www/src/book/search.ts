// The search of the handbook: a field, and the lines of what was found below it.

import { el, on, setText, show } from "../dom";
import { createFind, type Found, type Hit } from "./find";
import { loadBook } from "./index";

/** The elements of a page that take part. */
interface Parts {
  query: HTMLInputElement;
  found: HTMLElement;
  status: HTMLElement;
  list: HTMLElement;
}

/** The line of a hit: where it is, and what stands there. */
function line(hit: Hit, folder: string): HTMLLIElement {
  const excerpt = hit.excerpt.map(({ text, found }) => (found ? el("mark", {}, text) : text));
  const title = el("span", { class: "hit-title" }, hit.title, hit.page && el("small", {}, hit.page));
  return el("li", {}, el("a", { href: folder + hit.address }, title, el("span", { class: "hit-text" }, ...excerpt)));
}

/** Shows what comes of what is typed. The index comes when it is wanted first. */
function createAnswer({ query, found, status, list }: Parts): () => Promise<void> {
  const { index = "", pages = "", count = "", none = "", absent = "" } = found.dataset;
  let finding: Promise<(asked: string) => Found> | null = null;
  return async () => {
    const asked = query.value;
    try {
      finding ??= loadBook(index).then(createFind);
      const find = await finding;
      if (asked !== query.value) return; // more has been typed meanwhile
      const { count: all, hits } = find(asked);
      list.replaceChildren(...hits.map(hit => line(hit, pages)));
      setText(status, all > 0 ? `${count} ${all}` : none);
    } catch {
      finding = null;
      list.replaceChildren();
      setText(status, absent);
    }
    show(found, asked.trim() !== "");
    found.scrollTop = 0;
  };
}

/** Arrows lead from the field through the lines and back, Enter to the first line, Escape closes. */
function createKeys({ query, found, list }: Parts): (event: KeyboardEvent) => void {
  const links = (): HTMLElement[] => [...list.querySelectorAll("a")];
  const step = (by: number): void => {
    const all: HTMLElement[] = [query, ...links()];
    const at = all.indexOf(document.activeElement as HTMLElement);
    all[Math.min(Math.max(at + by, 0), all.length - 1)]?.focus();
  };
  return event => {
    const { key, target, isComposing } = event;
    if (isComposing) return; // the keys are those of who writes Chinese
    if (key === "Escape") {
      query.value = "";
      show(found, false);
      query.focus();
    } else if (key === "ArrowDown" && !found.hidden) step(1);
    else if (key === "ArrowUp" && !found.hidden) step(-1);
    else if (key === "Enter" && target === query) links()[0]?.click();
    else return;
    event.preventDefault();
  };
}

/** `query`: its field; `found`: where the lines stand. */
export function createSearch(query: HTMLInputElement, found: HTMLElement): void {
  const [status, list] = [found.querySelector("p"), found.querySelector("ol")];
  if (!status || !list) return;
  const parts = { query, found, status, list };
  const answer = createAnswer(parts);
  const keys = createKeys(parts);
  for (const event of ["focus", "input"] as const) on(query, event, () => void answer());
  on(query, "keydown", keys);
  on(found, "keydown", keys);
  on(found, "click", ({ target }) => {
    if (target instanceof Element && target.closest("a")) show(found, false);
  });
  on(document.body, "pointerdown", ({ target }) => {
    if (target instanceof Node && target !== query && !found.contains(target)) show(found, false);
  });
  on(document.body, "keydown", event => {
    const typing = event.target instanceof HTMLInputElement;
    if (event.key !== "/" || typing || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    query.select();
    query.focus();
  });
  if (query.parentElement) show(query.parentElement, true);
}
