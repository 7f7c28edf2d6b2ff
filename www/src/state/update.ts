// A new version of the page waits until the user wants it: a page that is at work keeps all its files until then.

import type { Store } from "./store";

let wanted = false; // this page has asked for the new version

/** Registers what serves the page without a network, and says in the state when a newer version is there. */
export async function watchForUpdate(store: Store): Promise<void> {
  const workers = navigator.serviceWorker as ServiceWorkerContainer | undefined; // none without https
  if (!workers) return;
  const tell = (): void => store.update({ page: { newer: true } });
  let served = workers.controller !== null;
  workers.addEventListener("controllerchange", () => {
    if (wanted) location.reload();
    else if (served) tell(); // another tab has asked: what this one still has to fetch may be gone
    served = true;
  });
  try {
    const registration = await workers.register("./sw.js");
    const look = (): void => {
      if (registration.waiting && served) tell();
    };
    look();
    registration.addEventListener("updatefound", () => registration.installing?.addEventListener("statechange", look));
  } catch (problem) {
    console.warn("the page is not kept for use without a network", problem);
  }
}

/** Loads the page again, in its newest version. */
export async function reload(): Promise<void> {
  const registration = await navigator.serviceWorker?.getRegistration();
  if (!registration?.waiting) return location.reload();
  wanted = true;
  registration.waiting.postMessage({ type: "SKIP_WAITING" });
}
