// What goes on by itself after each change: the work is kept, and a notice goes again.

import { lay, save } from "../state/keep";
import type { State } from "../state/state";
import type { Store } from "../state/store";

const NOTICE_SHOWN = 4000; // ms
const UNDO_SHOWN = 12_000; // ms; the key works longer

/** To be called after each change. Says once that nothing can be kept. */
export function createKeeping(store: Store): () => void {
  let waiting = 0; // for what is to be laid down
  let warned = false;
  const tell = (kept: boolean): void => {
    if (kept || warned) return;
    warned = true;
    store.update({ page: { notice: "notice-not-kept" } });
  };
  const layDown = async (): Promise<void> => {
    clearTimeout(waiting);
    waiting = 0;
    tell(await lay(() => store.state));
  };
  const leave = (): void => {
    if (waiting && document.visibilityState === "hidden") void layDown();
  };
  document.addEventListener("visibilitychange", leave); // before the page goes too
  return () => {
    const { kept, layAfter } = save(store.state);
    tell(kept);
    if (layAfter === 0) return void layDown();
    if (layAfter === undefined) return;
    clearTimeout(waiting);
    waiting = window.setTimeout(() => void layDown(), layAfter);
  };
}

/** Where it lies over what is read, a notice goes as soon as somebody goes on. */
function goneOnTap(store: Store, narrow = matchMedia("(max-width: 1199px)")): void {
  document.addEventListener("pointerdown", ({ target }) => {
    if (!narrow.matches || !store.state.page.notice || (target as Element).closest(".notice, dialog")) return;
    store.update({ page: { notice: "" } });
  });
}

/** To be called with each state that is drawn. */
export function createNoticing(store: Store): (state: State) => void {
  let noticed = "";
  let hiding = 0;
  goneOnTap(store);
  return ({ page: { notice, offer } }) => {
    if (notice === noticed) return;
    noticed = notice;
    clearTimeout(hiding);
    if (!notice) return;
    const hide = (): void => store.update({ page: { notice: "" } });
    hiding = window.setTimeout(hide, offer ? UNDO_SHOWN : NOTICE_SHOWN);
  };
}
