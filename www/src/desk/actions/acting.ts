// What every action works with.

import type { ProgramCore } from "../../core/program";
import type { Patch, State } from "../../state/state";
import type { Store } from "../../state/store";
import type { Catalogue } from "../../wire";

export interface Acting {
  store: Store;
  catalogue: Catalogue;
  /** null: the module is still on its way. */
  core(): ProgramCore | null;
  now(): State;
  /** A change that takes work away: it is said, and can be undone beside that. */
  replace(notice: string, ...patches: Patch[]): void;
}

export function createActing(store: Store, catalogue: Catalogue, core: () => ProgramCore | null): Acting {
  return {
    store,
    catalogue,
    core,
    now: () => store.state,
    replace(notice, ...patches) {
      store.update(...patches, { page: { notice, offer: true } });
      store.flush(); // editor and form have to hold it before the next key
    },
  };
}
