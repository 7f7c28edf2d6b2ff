// What the first form needs, so that it comes in one go: one script.
import type { Rollup } from "vite";

/** All that a module imports without waiting; not itself: it waits for parts that come later and need the same. */
function imports(of: string, getInfo: Rollup.GetModuleInfo): Set<string> {
  const found = new Set<string>();
  const add = (id: string): void => {
    for (const one of getInfo(id)?.importedIds ?? []) {
      if (found.has(one)) continue;
      found.add(one);
      add(one);
    }
  };
  add(of);
  return found;
}

/** One chunk of what `main` imports; others are cut by `otherwise`. */
export function inOne(main: string, otherwise: (id: string) => string | undefined): Rollup.GetManualChunk {
  let known: Set<string> | null = null;
  return (id, { getModuleInfo }) => {
    known ??= imports(main, getModuleInfo);
    return known.has(id) ? "first" : otherwise(id);
  };
}
