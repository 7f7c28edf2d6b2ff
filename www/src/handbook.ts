// The handbook beside the page (`cargo xtask book`): its address, and how it is there without a network too.

import { language } from "./texts";

const FOLDER = "./book/";
/** Where the service worker keeps its files (vite.config.ts). */
const KEPT = "handbook";

/** Its first page, in the language that is spoken. */
export function handbook(): string {
  return `${FOLDER}${language()}/index.html`;
}

/**
 * Asks for each of its files once, in the language that is spoken, one after another: the service worker keeps what it
 * hands on. Nothing is asked for again until there is a newer one.
 */
export async function keepHandbook(): Promise<void> {
  if (!navigator.serviceWorker?.controller) return; // none without https, or not yet
  try {
    const list = new URL(`${FOLDER}${language()}.json`, document.baseURI);
    const told = await fetch(list, { cache: "no-cache" });
    if (!told.ok) return; // a page without a handbook
    const { files, revision }: { files: string[]; revision: string } = await told.clone().json();
    const kept = await caches.open(KEPT);
    const known = await (await kept.match(list))?.json();
    if (known?.revision === revision) return;
    for (const file of files) await fetch(new URL(`${FOLDER}${file}`, document.baseURI), { cache: "no-cache" });
    await kept.put(list, told);
  } catch (problem) {
    console.warn("the handbook is not kept for use without a network", problem);
  }
}
