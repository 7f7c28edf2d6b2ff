// The core, which comes while the page is shown, and what stands in for it until then.

import { type FormCore, firstCore } from "../core/core";
import type { ProgramCore } from "../core/program";
import { knowTerms } from "../glossary";
import { allWords, laterWords } from "../texts";
import type { AlarmInfo, Catalogue, Elsewhere } from "../wire";

export interface Modules {
  /** What answers about forms: the core as soon as it is there. */
  readonly forms: FormCore;
  readonly program: ProgramCore | null;
  readonly alarms: Promise<AlarmInfo[]>;
  readonly elsewhere: Promise<Elsewhere[]>;
  /** What can be measured; until the core is listed, by the first visit alone. */
  readonly catalogue: Catalogue;
  /** Fetches the core, once; where that fails, whoever asks next tries again. The catalogue stays as it is. */
  bring(): Promise<ProgramCore>;
  /** The same with its catalogue: to list all that it can takes as long as to measure. */
  full(): Promise<ProgramCore>;
  /** The form goes on alone. */
  goWithout(): void;
}

/** `answers`: told when forms are answered with more than before, other than by a module that was waited for. */
export function createModules(answers: () => void): Modules {
  const first = firstCore();
  const { catalogue } = first;
  let program: ProgramCore | null = null;
  let forms: FormCore = first;
  let fetching: Promise<ProgramCore> | null = null;
  let came = (_: ProgramCore): void => undefined;
  const coming = new Promise<ProgramCore>(resolve => {
    came = resolve;
  });
  let listed = false;
  const worded = async (): Promise<void> => {
    if (allWords()) return;
    await laterWords();
    if (forms !== first) return;
    forms = first.measured();
    answers();
  };
  const fetched = async (): Promise<ProgramCore> => {
    const core = import("../core/program").then(module => module.loadProgramCore());
    const [part] = await Promise.all([core, worded()]);
    forms = program = part;
    return part;
  };
  const bring = (): Promise<ProgramCore> =>
    (fetching ??= fetched().catch((problem: unknown) => {
      fetching = null;
      throw problem;
    }));
  const list = ({ cycles, explained }: Catalogue): void => {
    Object.assign(catalogue, { cycles, explained });
    knowTerms(explained.filter(({ kind }) => kind === "term").map(({ key }) => key));
  };
  return {
    get forms() {
      return forms;
    },
    get program() {
      return program;
    },
    catalogue,
    alarms: coming.then(part => part.alarms()),
    elsewhere: coming.then(part => part.elsewhere()),
    bring,
    async full() {
      const part = await bring();
      if (!listed) list(part.catalogue());
      listed = true;
      came(part);
      return part;
    },
    goWithout() {
      forms = { ...first, simulates: "no" };
    },
  };
}
