// The profile in use becomes another one: by hand, or by what the program lacks and a finding offers. Of a long program
// a worker says what that is.

import type { SupplyRequest } from "../core/program";
import { NO_ERRORS } from "../errors";
import { AT_END, besideOf, type Patch, patched, profile, programMachine, programOf, type State } from "../state/state";
import { t } from "../texts";
import type { Catalogue, EquipView, ErrorSliders, Message, Setup } from "../wire";
import { isOfNow } from "./program";

/**
 * On the machine on which the program ran, with the part that stood there; one that fits the whole program is made of
 * the machine as it was before. null: it is to get nothing.
 */
export function supplying(state: State): SupplyRequest | null {
  const { giving } = state.desk;
  if (!giving) return null;
  const { control } = state.form;
  const { done } = state.run;
  const { change } = giving;
  const ran = done && change.give !== "parts" && state.view.source === "program" && isOfNow(done, state);
  const { setup } = ran ? done : programMachine(state);
  return { control, text: programOf(state), change, ...besideOf(state), ...(setup ? { setup } : {}) };
}

/** The machine has what it was to get. */
export function supplied(state: State, { setup }: EquipView, catalogue: Pick<Catalogue, "applicate">): State {
  const { giving } = state.desk;
  if (!giving) return state;
  const page = { notice: "notice-given", offer: true };
  return patched(state, equipped(state, setup, giving.told, catalogue), { desk: { giving: null }, page });
}

/** This profile is in use, by what was done; the core's own machine becomes one by that. */
export function equipped(
  state: State,
  setup: Setup,
  told: Message,
  { applicate }: Pick<Catalogue, "applicate">,
): Patch {
  const first = profile(state) === undefined;
  return {
    machine: { ...used(state, first ? withName(state, setup) : setup), told },
    view: { step: AT_END },
    ...(first ? { part: { errors: errorsOf(setup, applicate) } } : {}),
    ...asBegun(state),
  };
}

/** A form of no call of the program in what the machine begins with. */
export function asBegun({ form: { open } }: State): Patch {
  return open === null ? { form: { around: null } } : {};
}

/** The profile in use, changed. */
export function used({ machine: { setups } }: State, setup: Setup): Patch["machine"] {
  return { setups: { ...setups, [setup.control]: setup } };
}

/** A name that no profile has: this one, or with a number behind it. */
export function freeName({ machine: { setups, parked } }: State, wanted: string): string {
  const taken = [...Object.values(setups), ...parked].map(one => one.name ?? "");
  if (!taken.includes(wanted)) return wanted;
  const stem = wanted.replace(/\s+\d+$/, "");
  let number = 2;
  while (taken.includes(`${stem} ${number}`)) number++;
  return `${stem} ${number}`;
}

/** A machine that becomes a profile by what is done to it. */
export function withName(state: State, setup: Setup): Setup {
  return setup.name ? setup : { ...setup, name: freeName(state, t("profile-new")) };
}

/** What is wrong with the part of a setup, for the sliders. The probe's own errors are in the setup already. */
export function errorsOf(setup: Setup, applicate: Catalogue["applicate"]): ErrorSliders {
  const errors = setup.workpiece[0]?.errors;
  if (!errors) return NO_ERRORS;
  const [dx, dy, dz] = errors.shift;
  return {
    ...NO_ERRORS,
    part: {
      dx,
      dy,
      dz,
      size: errors.size,
      tilt: errors.tilt[applicate[setup.plane]],
      taper: errors.taper,
      outOfRound: errors.outOfRound[0],
    },
  };
}
