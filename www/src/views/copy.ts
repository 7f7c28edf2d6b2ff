// To the clipboard, where the browser lets it.

import type { Store } from "../state/store";

/** Copies a text and confirms it with `notice`, the key of a message. */
export async function copyText(text: string, store: Store, notice: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    store.update({ page: { notice } });
  } catch {
    store.update({ page: { notice: "notice-no-clipboard" } });
  }
}
