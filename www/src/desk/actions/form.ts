// The form: which cycle, which values, what the part differs by.

import { NO_ERRORS } from "../../errors";
import {
  AT_END,
  asWritten,
  memoryKey,
  ownMachine,
  type Patch,
  PLANES,
  patched,
  remember,
  type State,
  systemOf,
} from "../../state/state";
import type { CycleInfo, ErrorSliders } from "../../wire";
import { findCycle } from "../derive";
import { typedIn } from "../typing";
import { exampleOf, inSystem, isExample, type Variant } from "../variants";
import type { Acting } from "./acting";

export interface FormActions {
  chooseCycle(cycle: CycleInfo, variant?: Variant): void;
  /**
   * A form of its own for this variant: its worked measurement, with these values instead. On a first visit, while
   * nothing is anybody's work, its part lies off, so that there is something to correct.
   */
  measure(cycle: CycleInfo, variant: Variant, values: Record<string, string>): void;
  edit(name: string, value: string): void;
  touch(name: string): void;
  check(): void;
  example(variant: Variant | undefined): void;
  error<G extends keyof ErrorSliders>(group: G, name: keyof ErrorSliders[G], value: number): void;
  noErrors(): void;
  closeCall(): void;
}

/** How far the part of a first visit lies off, mm. */
export const LIES_OFF = { dx: 0.084, dy: -0.046 };
/** And how far askew where its angle is measured, degree. */
const ASKEW = { tilt: 0.12 };

/**
 * The core's own machine becomes one of the other sort with its usual plane, where the task is for another sort than
 * the last one on its control.
 */
function planeFor(state: State, { control, purpose: { plane } }: CycleInfo): Patch {
  const [usual] = PLANES;
  if (!plane || (state.machine.suits[control] ?? usual) === plane) return {};
  const own = ownMachine(patched(state, { form: { control } }));
  return {
    machine: {
      suits: { ...state.machine.suits, [control]: plane },
      own: { ...state.machine.own, [control]: { own: { ...own, plane } } },
    },
  };
}

export function createFormActions({ store, catalogue, now, replace }: Acting): FormActions {
  const edits = (pairs: [string, string][]): void =>
    store.update(state =>
      patched(typedIn(state, pairs), { form: { edits: state.form.edits + 1 }, page: { offer: false } }),
    );

  return {
    chooseCycle(cycle, chosen) {
      const state = now();
      const same = cycle.control === state.form.control && cycle.cycle === state.form.cycle;
      const suited = planeFor(state, cycle);
      const system = systemOf(
        same ? state : patched(state, suited, { form: { control: cycle.control, open: null, around: null } }),
      );
      const variant = chosen && inSystem(chosen, system);
      if (same && variant)
        return edits(Object.entries(isExample(cycle, state.form.values, system) ? variant.example : variant.values));
      const values = same
        ? state.form.values
        : (state.form.remembered[memoryKey(cycle)] ?? variant?.example ?? exampleOf(cycle, system));
      store.update(remember(state), suited, {
        form: {
          control: cycle.control,
          cycle: cycle.cycle,
          values: { ...values, ...variant?.values },
          open: same ? state.form.open : null,
          around: same ? state.form.around : null,
          resets: {},
          touched: {},
          checked: false,
        },
        desk: { sought: null },
        view: { step: AT_END, source: "form" },
        page: { offer: false },
      });
    },
    measure(cycle, chosen, given) {
      const state = now();
      const suited = planeFor(state, cycle);
      const own: Patch = { form: { control: cycle.control, open: null, around: null } };
      const { example } = inSystem(chosen, systemOf(patched(state, suited, own)));
      const { errors } = state.part;
      const askew = chosen.aim?.element === "angle" ? ASKEW : {};
      const part = { ...errors.part, ...LIES_OFF, ...askew };
      const lies: Patch = state.page.changed === 0 ? { part: { errors: { ...errors, part } } } : {};
      store.update(remember(state), suited, own, lies, {
        form: { cycle: cycle.cycle, values: { ...example, ...given }, resets: {}, touched: {}, checked: false },
        desk: { sought: null },
        view: { step: AT_END, source: "form" },
        panels: { panel: "form", left: "form" },
        page: { offer: false },
      });
    },
    edit: (name, value) => edits([[name, value]]),
    touch(name) {
      if (!now().form.touched[name]) store.update({ form: { touched: { ...now().form.touched, [name]: true } } });
    },
    check: () => store.update({ form: { checked: true } }),
    example(variant) {
      const cycle = findCycle(catalogue, now().form.control, now().form.cycle);
      if (cycle)
        replace("notice-example", {
          form: {
            values: variant ? inSystem(variant, systemOf(now())).example : exampleOf(cycle, systemOf(now())),
            open: null,
            resets: {},
            touched: {},
            checked: false,
          },
          desk: { sought: null },
          view: { step: AT_END },
        });
    },
    error(group, name, value) {
      const errors = now().part.errors;
      store.update({
        part: { errors: { ...errors, [group]: { ...errors[group], [name]: value } } },
        view: { step: AT_END },
        page: { offer: false },
      });
    },
    noErrors: () => replace("notice-no-errors", { part: { errors: NO_ERRORS }, view: { step: AT_END } }),
    closeCall: () =>
      store.update(state => {
        const pending = state.desk.pending.filter(one => !one.asks);
        return { form: { values: asWritten(state), open: null }, desk: { sought: null, pending } };
      }),
  };
}
