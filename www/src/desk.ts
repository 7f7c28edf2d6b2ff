// What follows from a change of the program or of the form before it is drawn: the program is read, what the form
// changed is written into it, the form follows the cursor. Short programs at once, long ones by a worker.

import type { Answered, Aside } from "./aside";
import { carried, type Splice, splice } from "./eol";
import { asked, hasToAsk, isWaiting } from "./pending";
import type { ChangeRequest, ConvertRequest, ProgramCore } from "./program";
import { AT_END, machine, programOf, type Reading, remember, type State, work } from "./state";
import type { CallView, Changed, Converted, Diagnostic, Edit, Pending, ReadView } from "./wire";

/** Of a program that is read between two keystrokes, in characters. */
const SHORT = 8_000;
/** Place of what was typed in the form while the call that it belongs to is still sought. */
export const SOUGHT = -1;

export function isCurrent(about: { control: string; text: string } | null, state: State): boolean {
  return about?.control === state.control && about.text === programOf(state);
}

/** Whether it is known what the program holds now, on the present machine. */
export function isRead(state: State): boolean {
  return isCurrent(state.reading, state) && state.reading?.setup === machine(state).setup;
}

/** The program with these edits; whatever points into it moves along. */
export function withEdits(state: State, edits: readonly Splice[]): State {
  const move = (at: number): number => carried(at, edits);
  return {
    ...state,
    programs: { ...state.programs, [state.control]: splice(programOf(state), edits) },
    open: state.open === null ? null : move(state.open),
    pending: state.pending.map(one =>
      one.control === state.control && one.at !== SOUGHT ? { ...one, at: move(one.at) } : one,
    ),
    cursor: move(state.cursor),
  };
}

/** The form filled with a call; what is still on the way into the program counts already. */
function filled(state: State, call: CallView): State {
  const typed = state.pending.filter(one => one.control === state.control && one.at === call.from);
  const values = { ...call.values, ...Object.fromEntries(typed.map(one => [one.name, one.value])) };
  const resets = state.open === call.from ? state.resets : {};
  return { ...state, open: call.from, cycle: call.cycle, values, resets, checked: true, touched: {}, step: AT_END };
}

/** Another call comes into the form; the values of the cycle that leaves it are kept. */
export function opened(state: State, call: CallView): State {
  return { ...filled({ ...state, ...remember(state) }, call), source: "form" };
}

/**
 * The call that was looked for, now that the program is read. It came out of the form, or a click wants it in the form.
 */
function found(state: State, calls: CallView[]): State {
  const { sought } = state;
  if (!sought) return state;
  const rest = { ...state, sought: null };
  if ("call" in sought) {
    const call = calls[sought.call];
    return call ? opened(rest, call) : rest;
  }
  const call = calls.find(one => one.from >= sought.from && one.from < sought.to);
  const place = call ? call.from : SOUGHT;
  const pending = rest.pending.map(one =>
    one.at === SOUGHT && one.control === state.control ? { ...one, at: place } : one,
  );
  return { ...rest, pending, open: call?.from ?? null };
}

function followed(state: State, calls: CallView[]): State {
  const { follow, cursorLine } = state;
  if (!follow) return state;
  const rest = { ...state, follow: null };
  const under =
    follow === "edits" ? undefined : calls.find(call => call.line <= cursorLine && cursorLine <= call.lastLine);
  if (under && under.from !== state.open) return opened(rest, under);
  const call = calls.find(one => one.from === state.open);
  return follow !== "cursor" && call ? filled(rest, call) : rest;
}

/** The state once the program is read. */
function arrived(state: State, reading: Reading): State {
  const { calls } = reading.view;
  const near = calls.find(call => state.open !== null && call.from <= state.open && state.open <= call.to);
  const anchored = { ...state, reading, open: near?.from ?? null };
  const next = followed(found(anchored, calls), calls);
  const there = new Set(calls.map(call => call.from));
  const lost = next.pending.filter(one => one.control === state.control && !there.has(one.at));
  return lost.length ? { ...next, pending: next.pending.filter(one => !lost.includes(one)) } : next;
}

/** What the form typed, for the first call that waits for it. */
function wanted(state: State): ChangeRequest | null {
  const { control, pending, reading } = state;
  const text = programOf(state);
  const first = pending.find(one => one.control === control && !isWaiting(one, text));
  const call = reading?.view.calls.findIndex(one => one.from === first?.at) ?? -1;
  return first && call >= 0 ? { control, text, call, at: first.at, pending, ...machine(state) } : null;
}

/** The program with what the form typed, unless something else was typed meanwhile: then that is asked anew. What would
 *  change lines outside of the call waits for a word. */
function changed(state: State, request: ChangeRequest, answers: Changed[]): State {
  if (state.pending !== request.pending) return state;
  const { text } = request;
  const mine = asked(request.pending, request);
  const waits = mine.flatMap((one, index): Pending[] => {
    const answer = answers[index];
    return answer && hasToAsk(one, answer) ? [{ ...one, asks: { text, lines: answer.elsewhere } }] : [];
  });
  const done = answers.filter((answer, index) => !hasToAsk(mine[index] as Pending, answer));
  const left = [...state.pending.filter(one => !mine.includes(one)), ...waits];
  const next = done.flatMap(({ steps }) => steps).reduce(withEdits, { ...state, pending: left });
  const after = mine.every(one => one.value === "" && state.resets[one.name]) ? stillTold(state, next) : next;
  return told(
    state,
    after,
    request,
    mine.some(one => one.agreed),
    done,
  );
}

/** What was said of a new variant is said on while the values go that were codes of something else before. */
function stillTold(before: State, after: State): State {
  return before.converted && isCurrent(before.converted, before)
    ? { ...after, converted: { ...before.converted, text: programOf(after) } }
    : after;
}

/** What a change did beside the value: it is said, and can be taken back. */
function told(
  before: State,
  after: State,
  { at, call: index, pending }: ChangeRequest,
  agreed: boolean,
  done: Changed[],
): State {
  const taken = done.flatMap(one => one.taken);
  const findings: Diagnostic[] = done.flatMap(one => one.findings);
  if (!agreed && !findings.length) return after;
  const call = before.reading?.view.calls[index];
  const inForm = before.open === at;
  const undo = work({
    ...before,
    pending: before.pending.filter(one => !pending.includes(one)),
    ...(call && inForm ? { values: call.values } : {}),
  });
  const values = inForm
    ? Object.fromEntries(Object.entries(after.values).filter(([name]) => !taken.includes(name)))
    : after.values;
  const text = programOf(after);
  return {
    ...after,
    values,
    undo,
    notice: agreed ? "notice-applied" : "notice-revised",
    ...(agreed ? { mended: text } : {}),
    ...(findings.length ? { converted: { control: after.control, text, findings } } : {}),
  };
}

/** The form with these values typed; where it edits a call of the program, they are on their way there. */
export function typedIn(state: State, pairs: [string, string][]): State {
  const { control } = state;
  const at = state.sought ? SOUGHT : state.open;
  const names = new Set(pairs.map(([name]) => name));
  const others = state.pending.filter(one => one.control !== control || one.at !== at || !names.has(one.name));
  const pending =
    at === null ? state.pending : [...others, ...pairs.map(([name, value]) => ({ control, at, name, value }))];
  const resets = Object.fromEntries(Object.entries(state.resets).filter(([name]) => !names.has(name)));
  return { ...state, values: { ...state.values, ...Object.fromEntries(pairs) }, resets, step: AT_END, pending };
}

/** Edits that the core proposes, made at once: one step in the editor, and undone as one. */
export function mended(state: State, edits: readonly Edit[], notice: string): State {
  const next = withEdits(state, edits);
  return { ...next, mended: programOf(next), follow: "edits", notice, undo: work(state) };
}

/** The call that is to be written in another way, once everything that was typed is in the program. */
function conversion(state: State): ConvertRequest | null {
  const { control, converting, reading } = state;
  const call = reading?.view.calls.findIndex(one => one.from === converting?.at) ?? -1;
  return converting && call >= 0
    ? { control, text: programOf(state), call, style: converting.style, ...machine(state) }
    : null;
}

function converted(state: State, { edits, findings }: Converted): State {
  const rest = { ...state, converting: null };
  const next = edits.length ? mended(rest, edits, "notice-converted") : rest;
  return { ...next, converted: { control: next.control, text: programOf(next), findings } };
}

function answered(state: State, { question, json, problem }: Answered): State {
  if (question.ask === "run" || !isCurrent(question, state)) return state;
  const { control, text, setup } = question;
  if (json === undefined)
    return {
      ...state,
      converting: null,
      pending: question.ask === "change" ? [] : state.pending,
      stoppedReading: { control, text, why: problem ?? "" },
    };
  if (question.ask === "read")
    return arrived(state, { control, text, ...(setup ? { setup } : {}), view: JSON.parse(json) as ReadView });
  if (question.ask === "convert") return state.converting ? converted(state, JSON.parse(json) as Converted) : state;
  return changed(state, question, JSON.parse(json) as Changed[]);
}

/** Until the part of the core that reads is there, nothing is settled. */
export function createDesk(programCore: () => ProgramCore | null, reader: Aside): (state: State) => State {
  const settle = (state: State): State => {
    const core = programCore();
    if (!core) return state;
    const { control, reading } = state;
    const text = programOf(state);
    const short = text.length <= SHORT;
    if (!reading || !isRead(state)) {
      const request = { control, text, ...machine(state) };
      if (short) return settle(arrived(state, { ...request, view: core.read(request) }));
      if (!isCurrent(state.stoppedReading, state)) reader.want({ ask: "read", ...request });
      return state;
    }
    if (state.follow || state.sought) return settle(arrived(state, reading));
    const request = wanted(state);
    if (request && short) return settle(changed(state, request, core.change(request)));
    if (request) reader.want({ ask: "change", ...request });
    return request ? state : convert(core, state, short);
  };
  const convert = (core: ProgramCore, state: State, short: boolean): State => {
    const request = conversion(state);
    if (!request) return state.converting ? { ...state, converting: null } : state;
    if (short) return settle(converted(state, core.convert(request)));
    reader.want({ ask: "convert", ...request });
    return state;
  };
  return state => {
    const answer = reader.take();
    return settle(answer ? answered(state, answer) : state);
  };
}
