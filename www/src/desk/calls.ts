// Which call of the program the form edits, once the program is read.

import { AT_END, patched, type Reading, remember, type State, type Surroundings } from "../state/state";
import type { CallView } from "../wire";
import { SOUGHT } from "./program";

/** The form with what counts at its call. */
function within(state: State, { plane, units, transverse }: Surroundings): State {
  const { around } = state.form;
  const same = around && around.plane === plane && around.units === units && around.transverse === transverse;
  return same ? state : patched(state, { form: { around: { plane, units, transverse } } });
}

/** The form filled with a call; what is still on the way into the program counts already. */
function filled(state: State, call: CallView): State {
  const typed = state.desk.pending.filter(one => one.control === state.form.control && one.at === call.from);
  const values = { ...call.values, ...Object.fromEntries(typed.map(one => [one.name, one.value])) };
  const resets = state.form.open === call.from ? state.form.resets : {};
  return patched(state, {
    form: { open: call.from, cycle: call.cycle, values, resets, checked: true, touched: {} },
    view: { step: AT_END },
  });
}

/** Another call comes into the form; the values of the cycle that leaves it are kept. */
export function opened(state: State, call: CallView): State {
  return patched(within(filled(patched(state, remember(state)), call), call), { view: { source: "form" } });
}

/**
 * The call that was looked for, now that the program is read. It came out of the form, or a click wants it in the form.
 */
function found(state: State, calls: CallView[]): State {
  const { sought } = state.desk;
  if (!sought) return state;
  const rest = patched(state, { desk: { sought: null } });
  if ("call" in sought) {
    const call = calls[sought.call];
    return call ? opened(rest, call) : rest;
  }
  const call = calls.find(one => one.from >= sought.from && one.from < sought.to);
  const at = call ? call.from : SOUGHT;
  const pending = rest.desk.pending.map(one =>
    one.at === SOUGHT && one.control === state.form.control ? { ...one, at } : one,
  );
  return patched(rest, { desk: { pending }, form: { open: call?.from ?? null } });
}

/** The form after the cursor has moved, something was typed in the program or its call was edited. */
function followed(state: State, calls: CallView[]): State {
  const { follow } = state.desk;
  const { line } = state.program;
  if (!follow) return state;
  const rest = patched(state, { desk: { follow: null } });
  const under = follow === "edits" ? undefined : calls.find(call => call.line <= line && line <= call.lastLine);
  if (under && under.from !== state.form.open) {
    const { source, step } = state.view;
    // beside the whole program the cursor goes from measurement to measurement
    const whole = follow === "cursor" && source === "program";
    return whole ? patched(opened(rest, under), { view: { source, step } }) : opened(rest, under);
  }
  const call = calls.find(one => one.from === state.form.open);
  return follow !== "cursor" && call ? filled(rest, call) : rest;
}

/** The call in which this place lies now. */
function callAt(calls: CallView[], place: number | null): CallView | undefined {
  return place === null ? undefined : calls.find(call => call.from <= place && place <= call.to);
}

/** The state once the program is read: the form shows what it was to show. Values for a call that is gone are lost. */
export function arrived(state: State, reading: Reading): State {
  const { calls } = reading.view;
  const open = callAt(calls, state.form.open)?.from ?? null;
  const anchored = patched(state, { program: { reading }, form: { open } });
  const shown = followed(found(anchored, calls), calls);
  const call = calls.find(one => one.from === shown.form.open);
  const next = call ? within(shown, call) : shown;
  const there = new Set(calls.map(call => call.from));
  const pending = next.desk.pending.filter(one => one.control !== state.form.control || there.has(one.at));
  return pending.length < next.desk.pending.length ? patched(next, { desk: { pending } }) : next;
}
