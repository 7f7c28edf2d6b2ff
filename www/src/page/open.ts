// Opening files: what cannot be taken is told at the place where it was to be opened, and nothing is lost.

import type { ProgramCore } from "../core/program";
import type { Actions } from "../desk/actions";
import type { EditorPlace } from "../editor/place";
import { asMarked, decode, type Encoding, encode } from "../encoding";
import { type Job, within } from "../pace";
import { fileOf, type Refusal, readProgram, readSetup } from "../state/files";
import { markInPieces } from "../state/mark";
import { keepPlace, movePlace } from "../state/places";
import { isUnsaved } from "../state/saved";
import { type Patch, programOf } from "../state/state";
import type { Store } from "../state/store";
import { sayProblem } from "../texts";
import { acceptDrops } from "../views/drop";

/** Told in the program panel, which help may cover and another panel replace: it is shown. */
function refuse(store: Store, place: "program" | "setup", why: Refusal): void {
  const shown: Patch = place === "program" ? { panels: { panel: place, right: place, dock: place } } : {};
  store.update({ page: { refused: { ...why, place } } }, shown);
}

/** What opening a file needs; `full`: the core that reads it, as soon as it is there. */
interface Needed {
  full(): Promise<ProgramCore>;
  store: Store;
  actions: Actions;
  opening: Job;
  editor: EditorPlace;
}

/** Files from buttons, from a drop, and the program once more in another encoding. */
export interface Open {
  program(file: File): void;
  /** A file that the page may write back to. */
  place(place: FileSystemFileHandle): void;
  again(encoding: Encoding): void;
  setup(file: File): void;
}

/** `absent`: the core that reads them does not come. */
export function createOpen(needed: Needed, absent: (problem: unknown) => void): Open {
  const open: Open = {
    program: file => void openProgramFile({ file }, needed).catch(absent),
    place: place => void openPlace(place, needed).catch(absent),
    again: encoding => void readAgain(encoding, needed),
    setup: file => void openSetupFile(file, needed).catch(absent),
  };
  const refuseFolder = (name: string): void =>
    refuse(needed.store, "program", { key: "refused-folder", args: { name } });
  acceptDrops(open.program, open.setup, refuseFolder);
  return open;
}

/** Until all of it is ready to be shown the program before stays, and can go on being changed. */
async function openProgramFile(
  { file, place }: { file: File; place?: FileSystemFileHandle },
  { full, store, actions, opening, editor }: Needed,
): Promise<void> {
  await opening.start(file.size, async pace => {
    const read = await readProgram(file, await full(), within(pace, 0, 0.4));
    if ("key" in read) return refuse(store, "program", read);
    await editor.prepare(read.text, within(pace, 0.4, 1));
    keepPlace(read.file.opened, place, file);
    actions.openProgram(read.text, read.file, read.mark);
  });
}

async function openPlace(place: FileSystemFileHandle, needed: Needed): Promise<void> {
  const file = await place.getFile().catch(() => null);
  if (file) await openProgramFile({ file, place }, needed);
  else refuse(needed.store, "program", { key: "refused-unreadable", args: { name: place.name } });
}

/** The bytes of the program, as they would be saved now, as characters of another encoding. */
async function readAgain(encoding: Encoding, { store, actions, opening, editor }: Needed): Promise<void> {
  const file = fileOf(store.state);
  const bytes = encode(programOf(store.state), file.encoding);
  if (!bytes) return store.update({}); // what is lacking is told already
  const next = asMarked(bytes, encoding);
  await opening.start(bytes.length, async pace => {
    const text = await decode(bytes, next, within(pace, 0, 0.4));
    await editor.prepare(text, within(pace, 0.4, 1));
    const mark = isUnsaved(store.state) ? null : await markInPieces(text, next, pace);
    const opened = Date.now();
    movePlace(file.opened, opened);
    actions.openProgram(text, { ...file, encoding: next, opened }, mark);
  });
}

async function openSetupFile(file: File, { full, store, actions }: Needed): Promise<void> {
  const text = await readSetup(file);
  if (typeof text !== "string") return refuse(store, "setup", text);
  const setup = (await full()).setup(text);
  if ("why" in setup)
    refuse(store, "setup", { key: "refused-setup", args: { name: file.name, why: sayProblem(setup.why) } });
  else actions.openSetup(setup);
}
