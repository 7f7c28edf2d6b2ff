// Opening files: what cannot be taken is told at the place where it was to be opened, and nothing is lost.

import type { Actions } from "./actions";
import type { EditorPlace } from "./editor/place";
import { readProgram, readSetup, type Refusal } from "./files";
import { within, type Job } from "./pace";
import type { ProgramCore } from "./program";
import type { Store } from "./store";

function refuse(store: Store, place: "program" | "setup", why: Refusal): void {
  store.update({ refused: { ...why, place } });
}

export function refuseFolder(name: string, store: Store): void {
  refuse(store, "program", { key: "refused-folder", args: { name } });
}

/** Until all of it is ready to be shown the program before stays, and can go on being changed. */
export async function openProgramFile(file: File, store: Store, actions: Actions, opening: Job, editor: EditorPlace): Promise<void> {
  await opening.start(file.size, async (pace) => {
    const read = await readProgram(file, within(pace, 0, 0.4));
    if ("key" in read) return refuse(store, "program", read);
    await editor.prepare(read.text, within(pace, 0.4, 1));
    actions.openProgram(read.text, read.file);
  });
}

export async function openSetupFile(file: File, core: () => Promise<ProgramCore>, store: Store, actions: Actions): Promise<void> {
  const text = await readSetup(file);
  if (typeof text !== "string") return refuse(store, "setup", text);
  const setup = (await core()).setup(text);
  if ("why" in setup) refuse(store, "setup", { key: "refused-setup", args: { name: file.name, why: setup.why } });
  else actions.openSetup(setup);
}
