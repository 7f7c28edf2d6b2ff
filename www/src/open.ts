// Opening files: what cannot be taken is told at the place where it was to be opened, and nothing is lost.

import type { Actions } from "./actions";
import { readProgram, readSetup, type Refusal } from "./files";
import type { ProgramCore } from "./program";
import type { Store } from "./store";

function refuse(store: Store, place: "program" | "setup", why: Refusal): void {
  store.update({ refused: { ...why, place } });
}

export async function openProgramFile(file: File, store: Store, actions: Actions): Promise<void> {
  const read = await readProgram(file);
  if ("key" in read) refuse(store, "program", read);
  else actions.openProgram(read.text, read.file);
}

export async function openSetupFile(file: File, core: () => Promise<ProgramCore>, store: Store, actions: Actions): Promise<void> {
  const text = await readSetup(file);
  if (typeof text !== "string") return refuse(store, "setup", text);
  const setup = (await core()).setup(text);
  if ("why" in setup) refuse(store, "setup", { key: "refused-setup", args: { name: file.name, why: setup.why } });
  else actions.openSetup(setup);
}
