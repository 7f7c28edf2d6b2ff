// The machine: its profiles, what it has and what only it knows.

import {
  AT_END,
  beginning,
  memoryKey,
  NOBODY,
  openCall,
  ownMachine,
  type Patch,
  profile,
  remember,
  type State,
  systemOf,
  unitsIn,
} from "../../state/state";
import { t } from "../../texts";
import type { CycleInfo, Dialect, MachineView, Message, Offer, OwnMachine, Plane, Setup } from "../../wire";
import { findCycle } from "../derive";
import { asBegun, equipped, errorsOf, freeName, used } from "../equipped";
import { answeredByLeaving } from "../typing";
import { inSystem } from "../variants";
import type { Acting } from "./acting";
import type { FormActions } from "./form";

export interface MachineActions {
  /** A profile is used from now on; null: the core's own machine. The one before stays among the others. */
  openSetup(setup: Setup | null): void;
  /** The form and the program of a control, as they were. */
  chooseControl(control: Dialect): void;
  /** One of the other profiles. */
  chooseProfile(setup: Setup): void;
  /** The profile in use is otherwise: what was done to it. */
  equip(setup: Setup, told: Message): void;
  /** A profile of the core's own machine, and it is used. */
  newProfile(): void;
  /** The profile in use once more, under another name. */
  duplicateProfile(): void;
  /** Takes the profile in use away. */
  deleteProfile(): void;
  /** A value that only the machine has; null: it is assumed again. */
  machineValue(name: string, value: number | string | null): void;
  begin(machine: OwnMachine["own"]): void;
  /** What the machine is built for, what differs in its data, and lines of its definition files; without: as before. */
  data(machine: Pick<MachineView, "basic" | "data">, definitions?: string[]): void;
  /** The machine gets what it lacks. */
  give(offer: Offer): void;
}

export function createMachineActions(
  { store, catalogue, core, now, replace }: Acting,
  form: FormActions,
): MachineActions {
  const actions: MachineActions = {
    openSetup(setup) {
      const { control, remembered } = now().form;
      const cycle = catalogue.cycles.find(one => one.control === setup?.control);
      const values = cycle && (remembered[memoryKey(cycle)] ?? cycle.example);
      const other: Patch =
        setup && cycle && values && setup.control !== control
          ? {
              form: { control: setup.control, cycle: cycle.cycle, values, open: null, around: null, touched: {} },
              desk: { sought: null },
            }
          : {};
      replace(setup ? "notice-setup" : "notice-own-setup", remember(now()), other, {
        machine: inUse(now(), setup?.control ?? control, setup),
        ...(setup ? { part: { errors: errorsOf(setup, catalogue.applicate) } } : {}),
        view: { step: AT_END },
        page: { refused: null },
      });
    },
    chooseControl(control) {
      if (control === now().form.control) return;
      store.update(state => answeredByLeaving(state, true));
      const state = now();
      const known = findCycle(catalogue, control, state.machine.before[control] ?? "");
      const cycle = known ?? catalogue.cycles.find(one => one.control === control);
      if (!cycle) return;
      const open = openCall(state);
      const call = open ? state.program.reading?.view.calls.indexOf(open) : undefined;
      form.chooseCycle(cycle);
      const there = state.desk.left[control];
      store.update({
        machine: { before: { ...state.machine.before, [state.form.control]: state.form.cycle } },
        desk: {
          left: { ...state.desk.left, [state.form.control]: call },
          sought: there === undefined ? null : { call: there },
        },
      });
    },
    chooseProfile(setup) {
      actions.chooseControl(setup.control);
      actions.openSetup(setup);
    },
    equip(setup, told) {
      store.update(equipped(now(), setup, told, catalogue), { page: { offer: false } });
    },
    newProfile() {
      const { control } = now().form;
      const view = core()?.equip({ control, setup: { own: ownMachine(now()) } });
      if (!view) return; // the module is still on its way
      const setup = { ...view.setup, name: freeName(now(), t("profile-new")) };
      replace("notice-profile-new", { machine: inUse(now(), control, setup), view: { step: AT_END } });
    },
    duplicateProfile() {
      const setup = profile(now());
      if (!setup) return;
      const name = freeName(now(), setup.name ?? "");
      replace("notice-profile-new", { machine: inUse(now(), setup.control, { ...setup, name }) });
    },
    deleteProfile() {
      const { control } = now().form;
      const { [control]: _, ...setups } = now().machine.setups;
      replace("notice-profile-deleted", { machine: { setups, told: { key: "step-profile-delete", args: {} } } });
    },
    machineValue(name, value) {
      const setup = profile(now());
      const own = ownMachine(now());
      const { [name]: _, ...others } = (setup ? setup.data : own.data) ?? {};
      const data = value === null ? others : { ...others, [name]: value };
      const { control } = now().form;
      const machine: Patch["machine"] = setup
        ? used(now(), { ...setup, data })
        : { own: { ...now().machine.own, [control]: { own: { ...own, data } } } };
      const told: Message = { key: "step-machine-value", args: { name } };
      store.update({ machine: { ...machine, told }, run: { stopped: null }, page: { offer: false } });
    },
    begin(own) {
      const { control } = now().form;
      const setup = profile(now());
      const turns = own.plane !== beginning(now()).plane;
      const chosen = turns ? own : { units: own.units };
      const described: Patch["machine"] = setup
        ? used(now(), { ...setup, plane: own.plane, active: { ...setup.active, units: own.units } })
        : { own: { ...now().machine.own, [control]: { own: { ...ownMachine(now()), ...chosen } } } };
      const cycle = findCycle(catalogue, control, now().form.cycle);
      const suited = turns && cycle?.purpose.plane ? suits(now(), cycle.purpose.plane) : {};
      store.update({ machine: described }, suited, turned(cycle, now(), own), asBegun(now()), {
        view: { step: AT_END },
      });
    },
    data({ basic, data }, definitions) {
      const { control } = now().form;
      const { own } = now().machine;
      const setup = profile(now());
      const before = beginning(now());
      // rebuilt, it begins in the new system
      const units = basic === (before.basic ?? "mm") ? before.units : unitsIn(control, before.units, basic);
      const defined = definitions && { definitions };
      const described: Patch["machine"] = setup
        ? used(now(), { ...setup, units: basic, active: { ...setup.active, units }, data, ...defined })
        : { own: { ...own, [control]: { own: { ...ownMachine(now()), basic, units, data, ...defined } } } };
      store.update({ machine: described }, asBegun(now()), { view: { step: AT_END } });
    },
    give(offer) {
      const giving = { change: { give: offer.supply }, told: offer.label };
      store.update({ desk: { giving }, page: { changed: Date.now(), others: NOBODY } });
      store.flush();
    },
  };
  return actions;
}

/** Another profile in use; the one before stays among the others. */
function inUse({ machine: { setups, parked } }: State, control: Dialect, setup: Setup | null): Patch["machine"] {
  const { [control]: before, ...rest } = setups;
  const others = parked.filter(one => one !== setup);
  return {
    setups: setup ? { ...rest, [control]: setup } : rest,
    parked: before && before !== setup ? [...others, before] : others,
    told: null,
  };
}

/** The sort of machine that was last chosen for, told by its usual plane. */
function suits({ form: { control }, machine }: State, plane: Plane): Patch {
  return { machine: { suits: { ...machine.suits, [control]: plane } } };
}

/** The worked measurement as another plane and other units have it, where the form holds one as it is. */
function turned(cycle: CycleInfo | undefined, state: State, system: OwnMachine["own"]): Patch {
  const { values, open } = state.form;
  const { sought } = state.desk;
  const filled = (all: Record<string, string>): string =>
    JSON.stringify(
      Object.entries(all)
        .filter(([, value]) => value)
        .sort(),
    );
  const held = cycle?.variants.find(one => filled(inSystem(one, systemOf(state)).example) === filled(values));
  return held && open === null && sought === null ? { form: { values: inSystem(held, system).example } } : {};
}
