// Files dropped onto the page: a setup is JSON, everything else a program. Before the editor sees them: it would paste them.

const isSetup = (file: File): boolean => file.type === "application/json" || /\.json$/i.test(file.name);

export function acceptDrops(openProgram: (file: File) => void, openSetup: (file: File) => void): void {
  const mark = (on: boolean): void => { document.body.toggleAttribute("data-dropping", on); };
  const carriesFiles = (event: DragEvent): boolean => !!event.dataTransfer?.types.includes("Files");
  addEventListener("dragover", (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    mark(true);
  }, true);
  addEventListener("dragleave", (event) => { if (!event.relatedTarget) mark(false); }, true);
  addEventListener("drop", (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    event.stopPropagation();
    mark(false);
    for (const file of event.dataTransfer?.files ?? []) (isSetup(file) ? openSetup : openProgram)(file);
  }, true);
}
