// What is shown of the state: the form, the calls of the program, the motions. Computed again only when something that
// it depends on is another object. Of the program it shows what was read last (desk.ts), until the next reading is
// there.

import type { FormCore, Formed } from "../core/core";
import type { SceneData } from "../core/scene";
import { type Course, courseOf } from "../core/steps";
import { writtenAs } from "../numbers";
import { type AroundDraft, type FormState, machine, type PartState, programOf, type State } from "../state/state";
import { language, say, t } from "../texts";
import type {
  AroundView,
  CallView,
  Catalogue,
  CertaintyView,
  CycleInfo,
  Diagnostic,
  FileStart,
  FormRequest,
  FormView,
  LoggedCall,
  OwnMachine,
  Plane,
  ReadView,
  RunView,
  ScanView,
  Setup,
  Severity,
  Style,
  Trace,
  Transverse,
  UnitFunction,
} from "../wire";
import { isRead } from "./program";
import { severities } from "./severity";
import { waiting } from "./typing";

export interface Derived {
  catalogue: Catalogue;
  cycle: CycleInfo;
  view: FormView;
  asked: FormRequest; // whose answer it is
  certain: CertaintyView | null; // how certain its measurement is, where that is known
  simulates: FormCore["simulates"]; // "yes" once the part of the core is there that does
  program: string;
  read: ReadView; // of `program`, or while `fresh` is false of what it was a little earlier
  fresh: boolean;
  opened: CallView | null;
  around: AroundView | null; // blocks around the call, while they are unfolded
  // values of the opened call that differ by the way, and count for the outcome as they arrive first
  assumed: CallView["first"];
  states: (Severity | null)[]; // the worst that is said about each call
  style: Style; // of the snippet
  run: RunView | null; // only while the program's motions are shown
  trace: Course | null;
  scene: ((times: number) => SceneData) | null; // what is to be seen of it, with errors so many times as large
  step: number; // of the trace, from 0; within it
  problems: Diagnostic[]; // of the program, by place
  files: FileStart[]; // where those beside it begin in what was said last
}

function memo<A extends unknown[], R>(make: (...args: A) => R): (...args: A) => R {
  let last: { args: A; result: R } | null = null;
  return (...args) => {
    if (last?.args.every((value, index) => value === args[index])) return last.result;
    last = { args, result: make(...args) };
    return last.result;
  };
}

export function findCycle(catalogue: Catalogue, control: string, cycle: string): CycleInfo | undefined {
  return catalogue.cycles.find(one => one.control === control && one.cycle === cycle);
}

/** A cure that reaches into a file beside the program is none. */
function curable({ files }: ReadView, one: Diagnostic): Diagnostic {
  const end = files?.[0]?.from;
  if (end === undefined || !one.cure?.edits.some(edit => edit.to >= end)) return one;
  const { cure: _, elsewhere: __, ...rest } = one;
  return rest;
}

function gather(read: ReadView): Diagnostic[] {
  const seen = new Set<string>();
  const all = [
    ...read.diagnostics,
    ...read.calls.flatMap(call =>
      call.diagnostics.map(one =>
        one.from === undefined ? { from: call.from, to: call.to, line: call.lastLine, ...one } : one,
      ),
    ),
  ];
  return all
    .map(one => curable(read, one))
    .filter(one => {
      const key = `${one.code} ${one.from} ${one.to} ${one.param ?? ""} ${one.message.key}`;
      return !seen.has(key) && seen.add(key);
    })
    .sort((a, b) => (a.from ?? 0) - (b.from ?? 0));
}

const NO_FILES: FileStart[] = [];

const NOTHING_MEASURED: readonly LoggedCall[] = [];
const NOTHING_READ: ReadView = { calls: [], diagnostics: [] };

const NOTHING_ASSUMED: CallView["first"] = {};

/** The measuring calls of a program, whose results its log prints. */
function measuredOf(calls: readonly CallView[]): readonly LoggedCall[] {
  return calls.flatMap(({ cycle, mvar }) => (mvar === null ? [] : [{ cycle, variant: mvar }]));
}

/** What arrives first at the opened call, of the values that nobody has typed over. */
function assumptions(opened: CallView | null, values: FormState["values"]): CallView["first"] {
  const open = Object.entries(opened?.first ?? {}).filter(([name]) => values[name] === opened?.values[name]);
  return open.length ? Object.fromEntries(open) : NOTHING_ASSUMED;
}

/** What a scan leaves to be looked at: nothing moves any more. */
function stillOf({ solids, radius }: ScanView): Trace {
  const nothing = { entries: [], tools: [], inUse: [], toolProbes: [], frames: [], zones: [], limits: [] };
  return { ...nothing, ball: { radius, length: radius, stylus: 0 }, turning: false, solids };
}

/**
 * The values of the opened call that are the worth of an expression and stand there as they were read, or as written;
 * and all values with what these are worth.
 */
function worth(
  opened: CallView | null,
  values: FormState["values"],
): { values: FormState["values"]; expressions: Record<string, string> } {
  const still = Object.entries(opened?.expressions ?? {}).filter(
    ([name, text]) => values[name] === opened?.values[name] || writtenAs(values[name] ?? "", text),
  );
  if (!still.length) return { values, expressions: NO_EXPRESSIONS };
  return {
    values: { ...values, ...Object.fromEntries(still.map(([name]) => [name, opened?.values[name] ?? ""])) },
    expressions: Object.fromEntries(still),
  };
}

/** What the form asked of the core, and its answer. */
interface Asked {
  question: FormRequest;
  view: Formed;
}

/** The values of a call, those with these names as the program has them: what is typed waits for a word. */
function unchangedIn(call: CallView, values: FormState["values"], names: string): FormState["values"] {
  return { ...values, ...Object.fromEntries(names.split(",").map(name => [name, call.values[name] ?? ""])) };
}

/** What is said of the call as the program has it; at the fields of what is typed there. */
const withTyped = (view: Formed, { fields, diagnostics }: Formed): Formed => ({ ...view, fields, diagnostics });

/**
 * A call that is never written anew in its own call style is the one that the program holds, byte by byte; comments
 * stand before it.
 */
function asHeld(view: Formed, program: string, { from, to, places }: CallView): Formed {
  const call = view.snippet.lastIndexOf("\n", view.snippet.length - 2) + 1;
  const comments = view.snippet.slice(0, call);
  const own = Object.entries(places).filter(([, [start, end]]) => from <= start && end <= to);
  const shift = comments.length - from;
  return {
    ...view,
    snippet: comments + program.slice(from, to),
    snippetPlaces: Object.fromEntries(own.map(([name, [start, end]]) => [name, [start + shift, end + shift]])),
    snippetFindings: [],
  };
}

/** Whether such a call has all its values in one bracket, so that the program's text is the whole of it. */
const inOneCall = ({ style }: CallView): boolean => style === "operate";

const NO_EXPRESSIONS: Record<string, string> = {};

function alike(a: Record<string, string>, b: Record<string, string>): boolean {
  const keys = Object.keys(a);
  return keys.length === Object.keys(b).length && keys.every(key => a[key] === b[key]);
}

/** The names of the fields in the reader's language, for the comments of the snippet: asked again when that changes. */
function labels(view: FormView): Record<string, string> {
  return Object.fromEntries(view.fields.map(field => [field.name, say(field.label)]));
}

/** Which call the blocks around one belong to. */
export const aroundAt = ({ form: { control, cycle, open } }: State): string => `${control}/${cycle}/${open ?? ""}`;

/** The wanted blocks of the call in the form; null: they are folded. */
function aroundHere(state: State): AroundDraft | null {
  const { around } = state.snippet;
  if (!around) return null;
  const at = aroundAt(state);
  return around.at === at ? around : { at, blocks: null };
}

/** The blocks around a call, and what the wanted ones would be: asked twice, as the first answer names the words. */
function aroundOf(
  core: FormCore,
  cycle: CycleInfo,
  values: FormState["values"],
  text: string,
  call: number | null,
  draft: AroundDraft | null,
  comments: boolean,
  setup: Setup | OwnMachine | undefined,
  _language: string,
): AroundView | null {
  if (!draft || !core.around || call === -1) return null;
  const wanted = draft.blocks && Object.entries(draft.blocks).map(([name, values]) => ({ name, values }));
  const request = {
    control: cycle.control,
    cycle: cycle.cycle,
    values,
    text,
    comments,
    ...(setup ? { setup } : {}),
    ...(call === null ? {} : { call }),
    ...(wanted ? { wanted } : {}),
  };
  const view = core.around(request);
  const keys = view.blocks.filter(block => block.wanted).flatMap(block => block.says);
  if (!keys.length) return view;
  return core.around({ ...request, words: Object.fromEntries(keys.map(key => [key, t(key)])) });
}

export function createDerive(forms: () => FormCore, catalogue: Catalogue): (state: State) => Derived {
  const first = catalogue.cycles[0];
  if (!first) throw new Error("the catalogue is empty");
  let names: Record<string, string> = {}; // as the snippet's comments were asked for last
  const ask = (
    core: FormCore,
    cycle: CycleInfo,
    values: FormState["values"],
    expressions: Record<string, string>,
    errors: PartState["errors"],
    comments: string | null,
    style: Style | null,
    twin: boolean,
    limits: boolean,
    assumed: CallView["first"],
    setup: Setup | OwnMachine | undefined,
    plane?: Plane,
    units?: UnitFunction,
    transverse?: Transverse,
    written?: Style,
    measured: readonly LoggedCall[] = [],
  ): Asked => {
    const request = {
      control: cycle.control,
      cycle: cycle.cycle,
      values,
      errors,
      ...(expressions !== NO_EXPRESSIONS ? { expressions } : {}),
      ...(style ? { style } : {}),
      ...(setup ? { setup } : {}),
      ...(plane && units && transverse ? { plane, units, transverse } : {}),
      ...(written ? { written } : {}),
      ...(measured.length ? { measured: [...measured] } : {}),
    };
    const first = Object.fromEntries(Object.entries(assumed).map(([name, { value }]) => [name, value]));
    const question = { ...request, predict: true, ...(assumed !== NOTHING_ASSUMED ? { assumed: first } : {}) };
    const view = core.form({
      ...question,
      ...(twin ? { twin } : {}),
      ...(limits ? { limits } : {}),
      ...(comments !== null ? { comments: names } : {}),
    });
    const before = names;
    names = comments !== null ? labels(view) : names;
    if (alike(before, names)) return { question, view };
    const { snippet, snippetPlaces } = core.form({ ...request, comments: names });
    return { question, view: { ...view, snippet, snippetPlaces } };
  };
  const form = memo(ask);
  const typedForm = memo(ask); // while something that is typed waits for a word
  const around = memo(aroundOf);
  const assume = memo(assumptions);
  const measuredBy = memo(measuredOf);
  const known = memo(worth);
  const knownTyped = memo(worth);
  const unchanged = memo(unchangedIn);
  const both = memo(withTyped);
  const held = memo(asHeld);
  const still = memo(stillOf);
  const problems = memo(gather);
  const states = memo(severities);

  return state => {
    const cycle = findCycle(catalogue, state.form.control, state.form.cycle) ?? first;
    const reading = state.program.reading?.control === cycle.control ? state.program.reading.view : NOTHING_READ;
    const opened = reading.calls.find(call => call.from === state.form.open) ?? null;
    const style = cycle.styles.find(one => one === state.snippet.style) ?? null;
    const core = forms();
    const { values } = state.form;
    const waits = opened ? waiting(state).join() : "";
    const there = opened && waits ? unchanged(opened, values, waits) : values;
    const assumed = assume(opened, there);
    const answer = (of: typeof ask, { values, expressions }: ReturnType<typeof worth>): Asked =>
      of(
        core,
        cycle,
        values,
        expressions,
        state.part.errors,
        state.snippet.comments ? language() : null,
        style,
        state.snippet.twin && cycle.twins,
        state.part.limits,
        assumed,
        machine(state).setup,
        state.form.around?.plane,
        state.form.around?.units,
        state.form.around?.transverse,
        opened?.style,
        cycle.purpose.probe === "log" ? measuredBy(reading.calls) : NOTHING_MEASURED,
      );
    const { question, view: said } = answer(form, known(opened, there));
    const asked = waits ? both(said, answer(typedForm, knownTyped(opened, values)).view) : said;
    const own = opened?.style === (style ?? asked.preset) ? opened : null;
    const view = own && (inOneCall(own) || !asked.snippet) ? held(asked, programOf(state), own) : asked;
    const index = opened ? reading.calls.indexOf(opened) : null;
    const blocks = around(
      core,
      cycle,
      question.values,
      programOf(state),
      index,
      aroundHere(state),
      state.snippet.comments,
      machine(state).setup,
      language(),
    );
    const all = problems(reading);
    const ran =
      state.view.source === "program" && state.run.done?.control === cycle.control ? state.run.done.view : null;
    const scanned =
      state.view.source === "scan" && state.scan.made?.request.cycle === cycle.cycle ? state.scan.made : null;
    const shown = scanned ?? (ran && state.run.done);
    const objects = scanned ? still(scanned.view) : view.outcome?.trace;
    const trace =
      (state.view.source === "program" ? ran && state.run.done?.course : objects && courseOf(objects)) ?? null;
    return {
      catalogue,
      cycle,
      view,
      asked: question,
      certain: null,
      assumed,
      simulates: core.simulates,
      program: programOf(state),
      read: reading,
      fresh: isRead(state),
      opened,
      around: blocks,
      states: states(reading.calls, all),
      style: style ?? view.preset,
      run: ran,
      trace,
      scene: shown ? () => shown.scene : state.view.source === "program" ? null : (view.scene ?? null),
      step: Math.max(0, Math.min(state.view.step, (trace?.steps.length ?? 0) - 1)),
      problems: all,
      files: ran?.files ?? reading.files ?? NO_FILES,
    };
  };
}
