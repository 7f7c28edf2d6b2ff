// What goes on by itself after each change: the work is kept, and a notice goes again.

import { save } from "../state/keep";
import type { State } from "../state/state";
import type { Store } from "../state/store";

const SAVE_AFTER = 200; // ms without a change; sooner when the page goes or the core breaks
const NOTICE_SHOWN = 4000; // ms
const UNDO_SHOWN = 12_000; // ms; the key works longer

/** To be called after each change. Says once that nothing can be kept. */
export function createKeeping(store: Store): () => void {
  let saving = 0;
  let warned = false;
  const keep = async (): Promise<void> => {
    if ((await save(store.state)) || warned) return;
    warned = true;
    store.update({ page: { notice: "notice-not-kept" } });
  };
  addEventListener("pagehide", () => void save(store.state));
  return () => {
    clearTimeout(saving);
    saving = window.setTimeout(() => void keep(), SAVE_AFTER);
  };
}

/** To be called with each state that is drawn. */
export function createNoticing(store: Store): (state: State) => void {
  let noticed = "";
  let hiding = 0;
  return ({ page: { notice, offer } }) => {
    if (notice === noticed) return;
    noticed = notice;
    clearTimeout(hiding);
    if (!notice) return;
    const hide = (): void => store.update({ page: { notice: "" } });
    hiding = window.setTimeout(hide, offer ? UNDO_SHOWN : NOTICE_SHOWN);
  };
}
