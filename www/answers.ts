// What a first visit shows before the core has come: the core's own answers about its worked measurement, asked while
// the page is built.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Plugin } from "vite";
import { firstCycle, firstQuestion } from "./src/core/example";
import type { Catalogue, CycleInfo, FormView } from "./src/wire";

const NAME = "answers:first";

export interface FirstAnswers {
  cycle: CycleInfo;
  catalogue: Catalogue; // of this cycle alone, without what is looked up
  form: FormView;
}

/** Asks the core in this folder. */
export async function ask(core: string): Promise<FirstAnswers> {
  const wasm = (await import(pathToFileURL(join(core, "core.js")).href)) as typeof import("../pkg/core/core.js");
  wasm.initSync({ module: readFileSync(join(core, "core_bg.wasm")) });
  const catalogue = JSON.parse(wasm.catalogue()) as Catalogue;
  const cycle = firstCycle(catalogue);
  if (!cycle) throw new Error("the catalogue is empty");
  const form = JSON.parse(wasm.form(JSON.stringify({ ...firstQuestion(cycle), predict: true }))) as FormView;
  return { cycle, catalogue: { ...catalogue, cycles: [cycle], explained: [] }, form };
}

/** The module `answers:first`. */
export function answers(first: Promise<FirstAnswers>): Plugin {
  return {
    name: "answers",
    resolveId: id => (id === NAME ? `\0${NAME}` : null),
    async load(id) {
      if (id !== `\0${NAME}`) return null;
      const { catalogue, form } = await first;
      // read as JSON by the browser, which is faster than reading it as script
      const text = JSON.stringify(JSON.stringify({ catalogue, form }));
      return `export const { catalogue, form } = JSON.parse(${text});`;
    },
  };
}
