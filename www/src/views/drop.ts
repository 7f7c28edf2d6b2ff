// Files and folders dropped onto the page: a setup is JSON, everything else a program. Before the editor sees them: it
// would paste them.

const isSetup = (file: File): boolean => file.type === "application/json" || /\.json$/i.test(file.name);

const MOST = 1000; // files of a folder

/** All that lies in a folder, and in those in it. */
async function filesIn(folder: FileSystemDirectoryEntry, into: File[]): Promise<void> {
  const reader = folder.createReader();
  const next = (): Promise<FileSystemEntry[]> => new Promise((take, fail) => reader.readEntries(take, fail));
  for (let entries = await next(); entries.length > 0 && into.length < MOST; entries = await next())
    for (const entry of entries) {
      if (entry.isDirectory) await filesIn(entry as FileSystemDirectoryEntry, into);
      else into.push(await new Promise<File>((take, fail) => (entry as FileSystemFileEntry).file(take, fail)));
    }
}

/** Files as they were dropped; of a folder those in it. */
async function unfolded(files: File[], entries: (FileSystemEntry | null | undefined)[]): Promise<File[]> {
  const all: File[] = [];
  for (const [at, file] of files.entries()) {
    const entry = entries[at];
    if (entry?.isDirectory) await filesIn(entry as FileSystemDirectoryEntry, all);
    else all.push(file);
  }
  return all;
}

/** `refuseFolder`: nothing was in it. */
export function acceptDrops(
  openPrograms: (files: File[]) => void,
  openSetup: (file: File) => void,
  refuseFolder: (name: string) => void,
): void {
  const take = (all: File[]): void => {
    const programs = all.filter(file => !isSetup(file));
    if (programs.length) openPrograms(programs);
    for (const file of all.filter(isSetup)) openSetup(file);
  };
  const mark = (on: boolean): void => {
    document.body.toggleAttribute("data-dropping", on);
  };
  const carriesFiles = (event: DragEvent): boolean => !!event.dataTransfer?.types.includes("Files");
  addEventListener(
    "dragover",
    event => {
      if (!carriesFiles(event)) return;
      event.preventDefault();
      mark(true);
    },
    true,
  );
  addEventListener(
    "dragleave",
    event => {
      if (!event.relatedTarget) mark(false);
    },
    true,
  );
  addEventListener(
    "drop",
    event => {
      if (!carriesFiles(event)) return;
      event.preventDefault();
      mark(false);
      if ((event.target as Element).closest("[data-takes-files]")) return; // it takes them itself
      event.stopPropagation();
      const files = [...(event.dataTransfer?.files ?? [])];
      // only now does the browser tell; a folder has a size of 0 as an empty file has
      const entries = [...(event.dataTransfer?.items ?? [])].map(item => item.webkitGetAsEntry());
      if (!entries.some(entry => entry?.isDirectory)) return take(files);
      unfolded(files, entries).then(all => {
        if (all.length) take(all);
        else refuseFolder(files[0]?.name ?? "");
      }, console.error);
    },
    true,
  );
}
