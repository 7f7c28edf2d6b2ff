// Opening files: what cannot be taken is told at the place where it was to be opened, and nothing is lost.

import type { ProgramCore } from "../core/program";
import type { Actions } from "../desk/actions";
import { mainOf } from "../desk/beside";
import type { EditorPlace } from "../editor/place";
import { asMarked, decode, type Encoding, encode } from "../encoding";
import { type Job, within } from "../pace";
import { fileOf, openedNow, type Refusal, readProgram, readSetup } from "../state/files";
import { looksLikeProgram } from "../state/looks";
import { markInPieces } from "../state/mark";
import { keepPlace, movePlace } from "../state/places";
import { isUnsaved } from "../state/saved";
import { type Patch, programOf, type State } from "../state/state";
import type { Store } from "../state/store";
import { sayProblem, t } from "../texts";
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
  programs(files: File[]): void;
  /** Files that are to lie beside the program, whatever they are called. */
  beside(files: File[]): void;
  /** A file that the page may write back to. */
  place(place: FileSystemFileHandle): void;
  places(places: FileSystemFileHandle[]): void;
  again(encoding: Encoding): void;
  setup(file: File): void;
}

/** `absent`: the core that reads them does not come. */
export function createOpen(needed: Needed, absent: (problem: unknown) => void): Open {
  const open: Open = {
    programs: files => void openPrograms(bare(files), needed).catch(absent),
    beside: files => void openBeside(bare(files), needed).catch(absent),
    place: place => void openPlaces([place], needed).catch(absent),
    places: places => void openPlaces(places, needed).catch(absent),
    again: encoding => void readAgain(encoding, needed),
    setup: file => void openSetupFile(file, needed).catch(absent),
  };
  const refuseFolder = (name: string): void =>
    refuse(needed.store, "program", { key: "refused-folder", args: { name } });
  acceptDrops(open.programs, open.setup, refuseFolder);
  return open;
}

/** A file, and where it lies, as far as the browser tells. */
interface Source {
  file: File;
  place?: FileSystemFileHandle;
}

const bare = (files: File[]): Source[] => files.map(file => ({ file }));

/** Until all of it is ready to be shown the program before stays, and can go on being changed. */
async function openProgramFile(
  { file, place }: Source,
  { full, store, actions, opening, editor }: Needed,
): Promise<void> {
  await opening.start(file.size, async pace => {
    const read = await readProgram(file, await full(), within(pace, 0, 0.4));
    if ("key" in read) return refuse(store, "program", read);
    await editor.prepare(read.text, within(pace, 0.4, 1));
    keepPlace(read.file.opened, place, file);
    actions.openProgram(read.text, read.file, read.mark);
    tellDoubts(store, read);
  });
}

/**
 * A program whose beginning tells another control than the one in use is opened, and the way to that one shown; so is
 * what may be no program, which is told.
 */
function tellDoubts(store: Store, { text, file: { name }, control }: Read): void {
  const another = control && control !== store.state.form.control;
  if (!looksLikeProgram(text)) refuse(store, "program", { key: "refused-no-blocks", args: { name }, taken: true });
  else if (another)
    refuse(store, "program", {
      key: "refused-other-control",
      args: { name, control: t(`control-${control}`) },
      control,
    });
}

/** One file is read as ever; of several the program is opened, and the others lie beside it. */
async function openPrograms(files: Source[], needed: Needed): Promise<void> {
  const [first] = files;
  const empty = (): boolean => programOf(needed.store.state) === "";
  const wanted = wantedBy(needed.store.state);
  if (files.length === 1 && first && mainOf([first], wanted, empty())) return openProgramFile(first, needed);
  await takeSeveral(files, needed, read => mainOf(read, wanted, empty()));
}

const openBeside = (files: Source[], needed: Needed): Promise<void> => takeSeveral(files, needed, () => null);

/** The programs that the one that is open calls and that are not here. */
function wantedBy(state: State): string[] {
  return state.program.reading?.view.diagnostics.flatMap(one => one.wants ?? []) ?? [];
}

type Read = Exclude<Awaited<ReturnType<typeof readProgram>>, Refusal>;

/** `choose`: which of them is opened as the program. What is no program is told, and the others are there. */
async function takeSeveral(
  files: Source[],
  { full, store, actions, opening, editor }: Needed,
  choose: (read: Read[]) => Read | null,
): Promise<void> {
  const size = files.reduce((sum, { file }) => sum + file.size, 0);
  await opening.start(size, async pace => {
    const core = await full();
    const read: Read[] = [];
    let refused: Refusal | null = null;
    for (const [at, { file, place }] of files.entries()) {
      const [from, to] = [at, at + 1].map(count => (0.6 * count) / files.length) as [number, number];
      const one = await readProgram(file, core, within(pace, from, to));
      if ("key" in one) {
        refused ??= one;
        continue;
      }
      keepPlace(one.file.opened, place, file);
      read.push(one);
    }
    const main = choose(read);
    const others = read.filter(one => one !== main);
    if (main) {
      await editor.prepare(main.text, within(pace, 0.6, 1));
      actions.openProgram(main.text, main.file, main.mark, others);
      tellDoubts(store, main);
    } else if (others.length) actions.putBeside(others);
    if (refused) refuse(store, "program", refused);
  });
}

async function openPlaces(places: FileSystemFileHandle[], needed: Needed): Promise<void> {
  const found = await Promise.all(
    places.map(async place => ({ place, file: await place.getFile().catch(() => null) })),
  );
  const lost = found.find(one => !one.file)?.place;
  if (lost) refuse(needed.store, "program", { key: "refused-unreadable", args: { name: lost.name } });
  const there = found.flatMap(({ place, file }) => (file ? [{ place, file }] : []));
  if (there.length) await openPrograms(there, needed);
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
    const opened = openedNow();
    movePlace(file.opened, opened);
    actions.openProgram(text, { ...file, encoding: next, opened }, mark);
  });
}

async function openSetupFile(file: File, { full, store, actions }: Needed): Promise<void> {
  const core = await full();
  const text = await readSetup(file, core);
  if (typeof text !== "string") return refuse(store, "setup", text);
  const setup = core.setup(text);
  if ("why" in setup)
    refuse(store, "setup", { key: "refused-setup", args: { name: file.name, why: sayProblem(setup.why) } });
  else actions.openSetup(setup);
}
