// With what the page begins: what was kept the last time, what a link brings, or the first visit.

import type { Core } from "../core/core";
import type { ProgramCore } from "../core/program";
import { findCycle } from "../desk/derive";
import { unpack } from "../link";
import { markOf } from "../state/mark";
import { withMark } from "../state/saved";
import { firstState, NO_ERRORS, type Patch, patched, profile, remember, type State } from "../state/state";
import { type Flat, merge } from "../state/stored";
import type { Catalogue, CycleInfo, Setup } from "../wire";

const FIRST_OVERSIZE = 0.03; // mm: the part of the first visit is this much too big

/** What shows most of what there is: the simulated measurement of a workpiece with the most variants. */
function firstCycle(catalogue: Catalogue): CycleInfo | undefined {
  const measured = catalogue.cycles.filter(
    ({ simulated, purpose }) => simulated && purpose.probe === "workpiece" && !purpose.calibrates,
  );
  return measured.sort((a, b) => b.variants.length - a.variants.length)[0] ?? catalogue.cycles[0];
}

/**
 * A worked measurement: the first cycle's example on a part that is a little too big, already written into the program.
 */
function firstVisit(core: Core, catalogue: Catalogue): State {
  const state = firstState();
  const cycle = firstCycle(catalogue);
  if (!cycle) return state;
  const errors = { ...NO_ERRORS, part: { ...NO_ERRORS.part, size: FIRST_OVERSIZE } };
  const { snippet } = core.form({ control: cycle.control, cycle: cycle.cycle, values: cycle.example, errors });
  return patched(state, {
    form: { control: cycle.control, cycle: cycle.cycle, values: cycle.example },
    part: { errors },
    program: {
      texts: { [cycle.control]: snippet },
      ...withMark(state, cycle.control, undefined, markOf(snippet, "utf-8")).program,
    },
    desk: { sought: { from: 0, to: snippet.length } },
  });
}

/** What a link has brought; it is in the address no longer. null: nothing. */
export function packedWork(): string | null {
  const packed = /^#s=(.+)$/.exec(location.hash)?.[1] ?? null;
  if (packed) history.replaceState({ place: "work" }, "", location.pathname + location.search);
  return packed;
}

/** `stored`: what was kept; `packed`: what a link adds to it. It is nobody's work until it is changed. */
export async function startState(
  core: Core,
  full: () => Promise<ProgramCore>,
  catalogue: Catalogue,
  stored: Flat | null,
  packed: string | null,
): Promise<State> {
  let state = stored ? merge(firstState(), stored) : firstVisit(core, catalogue);
  if (packed) state = patched(withLink(state, await unpack(packed)), { page: { changed: 0 } });
  const known = (): boolean => !!findCycle(catalogue, state.form.control, state.form.cycle);
  if (!known()) await full().catch(console.error); // the first module knows the cycle of the first visit alone
  if (!known()) state = patched(state, remember(state), pickFirst(catalogue));
  const { data = {}, definitions = [] } = state.machine.own[state.form.control]?.own ?? {};
  const given = Object.keys(data).length + definitions.length > 0;
  if (given) await full().catch(console.error); // the first module has no data but those delivered
  const setup = profile(state);
  if (!setup || setupFits(await full(), state, setup)) return state;
  const { [state.form.control]: _, ...setups } = state.machine.setups;
  return patched(state, { machine: { setups }, page: { notice: "notice-setup-outdated" } });
}

/** The work of a link; the profiles that it takes the place of stay among the others. */
function withLink(before: State, data: unknown): State {
  const after = merge(before, data);
  const gone = Object.values(before.machine.setups).filter(
    one => !Object.values(after.machine.setups).some(other => JSON.stringify(one) === JSON.stringify(other)),
  );
  return patched(after, { machine: { parked: [...after.machine.parked, ...gone] } });
}

/** A kept setup may come from an earlier version. */
function setupFits(core: ProgramCore, { form: { control, cycle } }: State, setup: Setup): boolean {
  try {
    core.form({ control, cycle, values: {}, setup });
    return true;
  } catch {
    return false;
  }
}

function pickFirst(catalogue: Catalogue): Patch {
  const cycle = firstCycle(catalogue);
  return cycle ? { form: { control: cycle.control, cycle: cycle.cycle, values: cycle.example, open: null } } : {};
}
