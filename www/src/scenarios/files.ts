// Scenarios among files that were picked, and the files that they name.

import type { ProgramCore } from "../core/program";
import { createJob } from "../pace";
import { type Refusal, readProgram, readText } from "../state/files";
import type { Beside, Scenario, ScenarioText } from "../wire";

/** Of a scenario that is built in, where its truth is: a worked measurement or figures of a manual, a closed loop. */
export type Kind = "example" | "vector" | "loop";

/** A scenario; what it needs is read when its turn comes. */
export interface Found {
  name: string;
  kind?: Kind;
  text(): Promise<string | Refusal>;
  /** The files that a text names. */
  beside(text: string): Promise<Beside[]>;
}

const isScenario = (name: string): boolean => /(^|\.)scenario\.json$/i.test(name);
const isJson = (name: string): boolean => /\.json$/i.test(name);

const pathOf = (file: File): string => file.webkitRelativePath || file.name;
const folderOf = (file: File): string => pathOf(file).slice(0, -file.name.length);

/** Names of files that a scenario has no text of; none: it is no scenario, which the core tells. */
function named(text: string): string[] {
  try {
    const { program, with: others = [] } = JSON.parse(text) as Scenario;
    return [program, ...others].filter(({ text }: ScenarioText) => text === undefined).map(({ name }) => name);
  } catch {
    return [];
  }
}

/** A program as text, whatever its encoding; none: it is not there, or no program. */
async function program(file: File | undefined, core: ProgramCore): Promise<string | null> {
  if (!file) return null;
  let text: string | null = null;
  await createJob(() => undefined).start(file.size, async pace => {
    const read = await readProgram(file, core, pace);
    if ("text" in read) text = read.text;
  });
  return text;
}

/** Scenarios among files, and the names of those that none of them needs: known once all were read. */
export interface Picked {
  found: Found[];
  unused(): string[];
}

/** Of a folder its scenarios; of single files each that could be one. */
export function scenariosIn(files: readonly File[], core: ProgramCore): Picked {
  const wanted = files.some(file => file.webkitRelativePath) ? isScenario : isJson;
  const sorted = [...files].sort((a, b) => pathOf(a).localeCompare(pathOf(b)));
  const scenarios = sorted.filter(file => wanted(file.name));
  const used = new Set<File>(scenarios);
  const found = scenarios.map(file => ({
    name: pathOf(file),
    text: () => readText(file, core),
    async beside(text: string) {
      const near = (name: string): File | undefined => {
        const one = files.find(other => other.name === name && folderOf(other) === folderOf(file));
        if (one) used.add(one);
        return one;
      };
      const read = named(text).map(async name => ({ name, text: await program(near(name), core) }));
      return (await Promise.all(read)).filter((one): one is Beside => one.text !== null);
    },
  }));
  return { found, unused: () => sorted.filter(file => !used.has(file)).map(pathOf) };
}
