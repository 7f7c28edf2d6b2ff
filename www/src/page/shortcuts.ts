// The keys that count everywhere on the page.

import { type Command, meantBy } from "../keys";

/** What closes is heard where it is open. */
type PageCommand = Exclude<Command<"page">, "close">;

/** Words that are looked for or given as a name are no work. */
const NO_WORK = "input[type=search], .cm-search input";
const TEXT = 'input:not([type="checkbox"], [type="range"], [type="file"]), textarea, [contenteditable="true"]';

/** Where a key keeps the meaning that it has there by itself. */
const EXCEPT: Partial<Record<PageCommand, string>> = { undo: NO_WORK, redo: NO_WORK, keys: TEXT };
const HISTORY: PageCommand[] = ["undo", "redo"];
/** A dialog keeps the focus, and nothing changes behind it. */
const NOT_BESIDE_DIALOG: PageCommand[] = [...HISTORY, "next-panel", "previous-panel", "keys", "palette"];
/** What a key that is held down does once. */
const ONCE: PageCommand[] = ["save", "open", "keys", "palette"];

/** Listens until `end`. */
export function listenToKeys(does: Record<PageCommand, () => void>, end: AbortSignal): void {
  document.addEventListener(
    "keydown",
    event => {
      const command = meantBy(event, "page");
      if (!command || command === "close") return;
      const [target] = event.composedPath();
      const except = EXCEPT[command];
      if (except && target instanceof Element && target.matches(except)) return;
      if (NOT_BESIDE_DIALOG.includes(command) && document.querySelector("dialog:modal")) {
        // the browser would take back what was typed last, wherever that is
        if (HISTORY.includes(command) && !(target instanceof Element && target.matches(TEXT))) event.preventDefault();
        return;
      }
      event.preventDefault();
      if (!event.repeat || !ONCE.includes(command)) does[command]();
    },
    { signal: end },
  );
}
