// What follows from the state: the form, the calls of the program, the motions to show. Computed again only when
// something that it depends on is another object.

import type { Core } from "./core";
import type { State } from "./state";
import { say } from "./texts";
import type { CallView, Catalogue, CycleInfo, Diagnostic, FormView, Plane, ReadView, RunView, Setup, Trace, UnitFunction } from "./wire";

export interface Derived {
  catalogue: Catalogue;
  cycle: CycleInfo;
  view: FormView;
  program: string;
  read: ReadView;
  opened: CallView | null;
  run: RunView | null;           // only while the program's motions are shown
  trace: Trace | null;
  step: number;                  // of the trace, from 0; within it
  problems: Diagnostic[];        // of the program, by place
}

function memo<A extends unknown[], R>(make: (...args: A) => R): (...args: A) => R {
  let last: { args: A; result: R } | null = null;
  return (...args) => {
    if (last && last.args.every((value, index) => value === args[index])) return last.result;
    last = { args, result: make(...args) };
    return last.result;
  };
}

export function findCycle(catalogue: Catalogue, control: string, cycle: string): CycleInfo | undefined {
  return catalogue.cycles.find((one) => one.control === control && one.cycle === cycle);
}

function gather(read: ReadView): Diagnostic[] {
  const seen = new Set<string>();
  const all = [...read.diagnostics, ...read.calls.flatMap((call) => call.diagnostics.map((one) => one.from === undefined ? { from: call.from, to: call.to, line: call.lastLine, ...one } : one))];
  return all.filter((one) => {
    const key = `${one.code} ${one.from} ${one.to} ${one.param ?? ""} ${one.message.key}`;
    return !seen.has(key) && seen.add(key);
  }).sort((a, b) => (a.from ?? 0) - (b.from ?? 0));
}

/** The imported machine, for a control that it has. */
export function machine(control: State["control"], setup: Setup | null): { setup?: Setup } {
  return setup?.control === control ? { setup } : {};
}

/** The names of the fields in the reader's language, for the comments of the snippet. */
function labels(view: FormView): Record<string, string> {
  return Object.fromEntries(view.fields.map((field) => [field.name, say(field.label)]));
}

export function createDerive(core: Core, catalogue: Catalogue): (state: State) => Derived {
  const first = catalogue.cycles[0];
  if (!first) throw new Error("the catalogue is empty");
  const form = memo((cycle: CycleInfo, values: State["values"], errors: State["errors"], comments: boolean, setup: Setup | null, plane?: Plane, units?: UnitFunction): FormView => {
    const request = { control: cycle.control, cycle: cycle.cycle, values, errors, ...machine(cycle.control, setup), ...(plane && units ? { plane, units } : {}) };
    const view = core.form({ ...request, predict: true });
    return comments ? { ...view, snippet: core.form({ ...request, comments: labels(view) }).snippet } : view;
  });
  const read = memo((control: State["control"], text: string, setup: Setup | null): ReadView => core.read({ control, text, ...machine(control, setup) }));
  const run = memo((control: State["control"], text: string, setup: Setup | null): RunView =>
    core.run({ control, text, ...(setup ? { setup } : {}) }));
  const problems = memo(gather);

  return (state) => {
    const cycle = findCycle(catalogue, state.control, state.cycle) ?? first;
    const program = state.programs[cycle.control] ?? "";
    const reading = read(cycle.control, program, state.setup);
    const opened = state.open === null ? null : reading.calls[state.open] ?? null;
    const view = form(cycle, state.values, state.errors, state.comments, state.setup, opened?.plane, opened?.units);
    const ran = state.source === "program" ? run(cycle.control, program, view.setup ?? state.setup) : null;
    const trace = ran ? ran.trace : view.outcome?.trace ?? null;
    return {
      catalogue, cycle, view, program, read: reading, opened, run: ran,
      trace, step: Math.max(0, Math.min(state.step, (trace?.entries.length ?? 0) - 1)),
      problems: problems(reading),
    };
  };
}
