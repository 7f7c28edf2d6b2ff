// Files dropped onto the page: a setup is JSON, everything else a program. Before the editor sees them: it would paste
// them.

const isSetup = (file: File): boolean => file.type === "application/json" || /\.json$/i.test(file.name);

/** Where the system tells a folder's size as 0, its entry is all that tells it from an empty file. */
const isFolder = (event: DragEvent, at: number): boolean =>
  !!event.dataTransfer?.items[at]?.webkitGetAsEntry()?.isDirectory;

export function acceptDrops(
  openProgram: (file: File) => void,
  openSetup: (file: File) => void,
  refuseFolder: (name: string) => void,
): void {
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
      event.stopPropagation();
      mark(false);
      for (const [at, file] of [...(event.dataTransfer?.files ?? [])].entries()) {
        if (isFolder(event, at)) refuseFolder(file.name);
        else (isSetup(file) ? openSetup : openProgram)(file);
      }
    },
    true,
  );
}
