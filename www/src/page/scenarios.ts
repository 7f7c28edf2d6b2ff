// The way to the scenarios, which come when somebody asks for them.

import type { Derived } from "../desk/derive";
import type { Scenarios } from "../scenarios/scenarios";
import type { State } from "../state/state";
import type { Modules } from "./modules";

export function createScenariosWay(
  modules: Pick<Modules, "full">,
  shown: () => { state: State; derived: Derived } | null,
  end: AbortSignal,
): Scenarios {
  let coming: Promise<Scenarios> | null = null;
  const fetched = async (): Promise<Scenarios> => {
    const [{ createScenarios }, core] = await Promise.all([import("../scenarios/scenarios"), modules.full()]);
    return createScenarios(core, shown, end);
  };
  const come = (): Promise<Scenarios> =>
    (coming ??= fetched().catch((problem: unknown) => {
      coming = null;
      throw problem;
    }));
  const go = (does: "open" | "check") => (): void =>
    void come()
      .then(scenarios => scenarios[does]())
      .catch(console.error);
  return { open: go("open"), check: go("check") };
}
