// Sets of values that are kept under a name.

import { asWritten, memoryKey, type Patch, patched, setsOf } from "../../state/state";
import { typedIn } from "../typing";
import type { Acting } from "./acting";

export interface SetsActions {
  saveSet(name: string): void;
  loadSet(name: string): void;
  /** false: the name is taken, or it is none. */
  renameSet(name: string, next: string): boolean;
  deleteSet(name: string): void;
}

export function createSetsActions({ store, now, replace }: Acting): SetsActions {
  const withSets = (sets: Record<string, Record<string, string>>): Patch => ({
    form: { sets: { ...now().form.sets, [memoryKey(now().form)]: sets } },
  });

  return {
    saveSet(name) {
      const sets = setsOf(now());
      const next = withSets({ ...sets, [name]: asWritten(now()) });
      if (sets[name]) replace("notice-set-replaced", next);
      else store.update(next, { page: { notice: "notice-set-saved" } });
    },
    loadSet(name) {
      const values = asWritten(now());
      const set = setsOf(now())[name] ?? {};
      const names = [...new Set([...Object.keys(values), ...Object.keys(set)])];
      const changes = names
        .filter(one => (values[one] ?? "") !== (set[one] ?? ""))
        .map((one): [string, string] => [one, set[one] ?? ""]);
      replace("notice-set-loaded", patched(typedIn(now(), changes), { form: { touched: {}, checked: false } }));
    },
    renameSet(name, next) {
      const sets = setsOf(now());
      if (!next || (next !== name && sets[next])) return false;
      store.update(
        withSets(Object.fromEntries(Object.entries(sets).map(([one, values]) => [one === name ? next : one, values]))),
      );
      return true;
    },
    deleteSet(name) {
      const { [name]: _, ...rest } = setsOf(now());
      replace("notice-set-deleted", withSets(rest));
    },
  };
}
