// With what the page begins: what was kept the last time, what a link brings, or the first visit.

import { FIRST_ERRORS, firstCycle, firstQuestion } from "../core/example";
import type { ProgramCore } from "../core/program";
import { findCycle } from "../desk/derive";
import { unpack } from "../link";
import { markOf } from "../state/mark";
import { withMark } from "../state/saved";
import { firstState, type Patch, patched, profile, remember, type State } from "../state/state";
import { type Flat, merge } from "../state/stored";
import type { Catalogue, Setup } from "../wire";
import type { Modules } from "./modules";

/**
 * A worked measurement: the first cycle's example on a part that is a little too big, already written into the program.
 */
function firstVisit({ forms, catalogue }: Modules): State {
  const state = firstState();
  const cycle = firstCycle(catalogue);
  if (!cycle) return state;
  const { snippet } = forms.form(firstQuestion(cycle));
  return patched(state, {
    form: { control: cycle.control, cycle: cycle.cycle, values: cycle.example },
    part: { errors: FIRST_ERRORS },
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
export async function startState(modules: Modules, stored: Flat | null, packed: string | null): Promise<State> {
  const { catalogue, full } = modules;
  if (stored || packed) await full().catch(console.error);
  let state = stored ? merge(firstState(), stored) : firstVisit(modules);
  if (packed) state = patched(withLink(state, await unpack(packed)), { page: { changed: 0 } });
  const known = findCycle(catalogue, state.form.control, state.form.cycle);
  if (!known) state = patched(state, remember(state), pickFirst(catalogue));
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
