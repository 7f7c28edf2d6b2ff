// The page in a frame of an editor: it is given a program, and tells what becomes of it, and of nothing else.

import type { Actions } from "../desk/actions";
import { fileOf } from "../state/files";
import { programOf } from "../state/state";
import type { Store } from "../state/store";
import type { Dialect } from "../wire";
import type { Open } from "./open";

/** What the editor says; `line`: that of its cursor, from 1. */
interface Given {
  probewright: "open";
  control: Dialect;
  name: string;
  text: string;
  line: number;
}

function isGiven(data: unknown): data is Given {
  const { probewright, control, name, text, line } = (data ?? {}) as Partial<Record<keyof Given, unknown>>;
  const known = probewright === "open" && (control === "sinumerik" || control === "nct");
  return known && typeof name === "string" && typeof text === "string" && Number.isInteger(line);
}

/** First character of a line of a text with line feeds. */
function startOf(text: string, line: number): number {
  return text.split("\n", line - 1).reduce((sum, one) => sum + one.length + 1, 0);
}

/** Gives back what is to be called after each change. */
export function createFrame(
  store: Store,
  actions: Pick<Actions, "chooseControl" | "cursor">,
  open: Pick<Open, "programs">,
): () => void {
  let wanted: Given | null = null; // not shown yet
  let told: { text: string; opened: number | undefined; origin: string } | null = null;
  let from = "";
  addEventListener("message", ({ data, origin, source }: MessageEvent<unknown>) => {
    if (source !== parent || !isGiven(data)) return;
    [wanted, from] = [data, origin];
    if (told && data.text === programOf(store.state)) return changed();
    told = null;
    actions.chooseControl(data.control);
    open.programs([new File([data.text], data.name)]);
  });
  function changed(): void {
    const text = programOf(store.state);
    const { opened, name } = fileOf(store.state);
    if (wanted && text === wanted.text && name === wanted.name) {
      const { line } = wanted;
      wanted = null;
      told = { text, opened, origin: from };
      actions.cursor(Math.min(startOf(text, line), text.length), line);
    } else if (told && opened === told.opened && text !== told.text) {
      told = { ...told, text };
      parent.postMessage({ probewright: "program", text }, told.origin);
    }
  }
  parent.postMessage({ probewright: "ready" }, "*"); // to whoever shows it: it says nothing
  return changed;
}
