// How the system starts the page: by a shortcut of its icon, or with a file.

import type { Actions } from "../desk/actions";
import type { Panel } from "../state/state";
import type { Store } from "../state/store";
import type { Open } from "./open";

/** Not in every browser, nor among TypeScript's. */
interface LaunchQueue {
  setConsumer(take: (launch: { files?: readonly FileSystemFileHandle[] }) => void): void;
}

/** The places of the shortcuts in `manifest.ts`: the panel, and what of it gets the focus. */
const PLACES: Record<string, { panel: Panel; focus: string }> = {
  tasks: { panel: "tasks", focus: '.tree [tabindex="0"]' },
  program: { panel: "program", focus: "#program-open" },
  search: { panel: "tasks", focus: "#task-search" },
};

export function takeLaunch(store: Store, actions: Actions, open: Open): void {
  const place = PLACES[/^#start=(\w+)$/.exec(location.hash)?.[1] ?? ""];
  if (place) {
    history.replaceState({ place: "work" }, "", location.pathname + location.search);
    actions.panel(place.panel);
    store.flush();
    document.querySelector<HTMLElement>(place.focus)?.focus();
  }
  const { launchQueue } = globalThis as { launchQueue?: LaunchQueue };
  launchQueue?.setConsumer(({ files }) => {
    for (const file of files ?? []) open.place(file);
  });
}
