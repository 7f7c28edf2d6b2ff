// What the first form needs, so that it comes in one go: one script, and beside it the module of the core, which that
// script would ask for only once it runs.
import type { Plugin, Rollup } from "vite";

const MODULE = /\/core_bg-[^/]*\.wasm$/;

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

/** The browser fetches the module while it reads the script. */
export function ahead(): Plugin {
  return {
    name: "ahead",
    transformIndexHtml: {
      order: "post",
      handler(_, { bundle = {} }) {
        const names = Object.keys(bundle).filter(name => MODULE.test(`/${name}`));
        return names.map(name => ({
          tag: "link",
          attrs: { rel: "preload", as: "fetch", crossorigin: true, href: `./${name}` },
          injectTo: "head",
        }));
      },
    },
  };
}
