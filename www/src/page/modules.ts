// The two modules of the core: the page comes with that of the form, the one that knows everything follows.

import type { Core, FormCore } from "../core/core";
import type { ProgramCore } from "../core/program";
import { laterWords } from "../texts";
import type { AlarmInfo, Catalogue } from "../wire";

export interface Modules {
  /** What answers about forms: the second one as soon as it is there. */
  readonly forms: FormCore;
  readonly program: ProgramCore | null;
  readonly alarms: Promise<AlarmInfo[]>;
  /** Fetches the second one, once; where that fails, whoever asks next tries again. The catalogue stays as it is. */
  bring(): Promise<ProgramCore>;
  /** The same with its catalogue: to list all that it can takes as long as to measure. */
  full(): Promise<ProgramCore>;
  /** The form goes on alone. */
  goWithout(): void;
}

/** `catalogue`: of the first one; it becomes that of the second. */
export function createModules(core: Core, catalogue: Catalogue): Modules {
  let program: ProgramCore | null = null;
  let forms: FormCore = core;
  let fetching: Promise<ProgramCore> | null = null;
  let came = (_: ProgramCore): void => undefined;
  const coming = new Promise<ProgramCore>(resolve => {
    came = resolve;
  });
  let listed = false;
  const fetched = async (): Promise<ProgramCore> => {
    const [part] = await Promise.all([
      import("../core/program").then(module => module.loadProgramCore()),
      laterWords(),
    ]);
    forms = program = part;
    return part;
  };
  const bring = (): Promise<ProgramCore> =>
    (fetching ??= fetched().catch((problem: unknown) => {
      fetching = null;
      throw problem;
    }));
  return {
    get forms() {
      return forms;
    },
    get program() {
      return program;
    },
    alarms: coming.then(part => part.alarms()),
    bring,
    async full() {
      const part = await bring();
      if (!listed) catalogue.cycles = part.catalogue().cycles;
      listed = true;
      came(part);
      return part;
    },
    goWithout() {
      forms = { ...core, simulates: "no" };
    },
  };
}
