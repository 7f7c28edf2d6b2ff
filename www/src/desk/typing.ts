// What was typed in the form on its way into the program, and edits that the core proposes.

import { type Asks, asked, hasToAsk, hasToReplace, isWaiting, type Pending } from "../core/pending";
import type { ChangeRequest, ConvertRequest } from "../core/program";
import { difference } from "../difference";
import { splice } from "../eol";
import {
  AT_END,
  besideOf,
  openCall,
  type Proposal,
  patched,
  programMachine,
  programOf,
  type Reset,
  type State,
} from "../state/state";
import type { Changed, ComparedValue, Converted, CuredAll, CureRequest, Edit, Message, Replaced, Unfit } from "../wire";
import { isCurrent, SOUGHT, withEdits } from "./program";

/** The form with these values typed; where it edits a call of the program, they are on their way there. */
export function typedIn(state: State, pairs: [string, string][]): State {
  const { control, open } = state.form;
  const at = state.desk.sought ? SOUGHT : open;
  const names = new Set(pairs.map(([name]) => name));
  const others = state.desk.pending.filter(one => one.control !== control || one.at !== at || !names.has(one.name));
  const pending =
    at === null ? state.desk.pending : [...others, ...pairs.map(([name, value]) => ({ control, at, name, value }))];
  const resets = Object.fromEntries(Object.entries(state.form.resets).filter(([name]) => !names.has(name)));
  return patched(state, {
    form: { values: { ...state.form.values, ...Object.fromEntries(pairs) }, resets },
    view: { step: AT_END },
    desk: { pending },
  });
}

/** Whether this waits for a word in the program that is shown. */
const waitsIn =
  (state: State) =>
  (one: Pending): boolean =>
    one.control === state.form.control && isWaiting(one, programOf(state));

/** Names of the values that wait for a word in the call that the form edits. */
export function waiting(state: State): string[] {
  const mine = state.desk.pending.filter(waitsIn(state));
  return mine.filter(one => one.at === state.form.open).map(one => one.name);
}

/** The form as the program has its call, without what is typed into it and these do not hold yet. */
function withoutTyped(state: State, gone: readonly Pending[]): State {
  const call = openCall(state);
  const names = gone.filter(one => one.control === state.form.control && one.at === call?.from).map(one => one.name);
  const back = Object.fromEntries(names.map(name => [name, call?.values[name] ?? ""]));
  const pending = state.desk.pending.filter(one => !gone.includes(one));
  return patched(state, { desk: { pending }, form: { values: { ...state.form.values, ...back } } });
}

/** What was typed and is not in the program yet is not done; the same state where that is nothing. */
export function takenBack(state: State): State {
  const { control, open } = state.form;
  const mine = state.desk.pending.filter(one => one.control === control && one.at === open);
  return mine.length && openCall(state) ? withoutTyped(state, mine) : state;
}

/**
 * What waits for a word and is asked no more keeps what the program has, and that is said. A question belongs to its
 * field: `all`: none stays open, else those of calls that the form does not edit go.
 */
export function answeredByLeaving(state: State, all = false): State {
  const { open } = state.form;
  const gone = state.desk.pending.filter(one => waitsIn(state)(one) && (all || one.at !== open));
  if (!gone.length) return state;
  return patched(withoutTyped(state, gone), { desk: { proposed: null }, page: { notice: "notice-kept", offer: true } });
}

/** What waits for a word since it would take the place of an expression in the call that the form edits. */
export function replacing(state: State, name: string): (Pending & { asks: { replaced: Replaced } }) | undefined {
  const { control, open } = state.form;
  const one = state.desk.pending.find(one => one.control === control && one.at === open && one.name === name);
  const waits = one?.asks?.replaced && isWaiting(one, programOf(state));
  return waits ? (one as Pending & { asks: { replaced: Replaced } }) : undefined;
}

/** The field as the program has it, and nothing in it that waits for a word. */
export function withoutReplacing(state: State, name: string): State {
  const here = replacing(state, name);
  const value = openCall(state)?.values[name] ?? "";
  return patched(state, {
    desk: { pending: state.desk.pending.filter(one => one !== here) },
    form: { values: { ...state.form.values, [name]: value } },
  });
}

/** What the form typed, for the first call that waits for it. */
export function change(state: State): ChangeRequest | null {
  const { control } = state.form;
  const { pending } = state.desk;
  const text = programOf(state);
  const first = pending.find(one => one.control === control && !isWaiting(one, text));
  const call = state.program.reading?.view.calls.findIndex(one => one.from === first?.at) ?? -1;
  return first && call >= 0
    ? { control, text, call, at: first.at, pending, ...programMachine(state), ...besideOf(state) }
    : null;
}

/**
 * The program with what the form typed, unless something else was typed meanwhile: then that is asked anew. What would
 * change more than its own value waits for a word, with all that was typed at once with it.
 */
export function changed(state: State, request: ChangeRequest, answers: Changed[]): State {
  if (state.desk.pending !== request.pending) return state;
  const mine = asked(request.pending, request).map((one, index) => ({ one, answer: answers[index] as Changed }));
  const replaces = mine.filter(({ one, answer }) => hasToReplace(one, answer));
  const others = mine.filter(pair => !replaces.includes(pair));
  const shows = others.some(({ one, answer }) => hasToAsk(one, answer));
  const waits = shows ? mine : replaces;
  const done = shows ? [] : others;
  const waiting = waits.map(({ one, answer }): Pending => ({ ...one, asks: asksOf(one, answer, request.text) }));
  const left = new Set(mine.map(({ one }) => one));
  const pending = [...state.desk.pending.filter(one => !left.has(one)), ...waiting];
  const next = done.flatMap(({ answer }) => answer.steps).reduce(withEdits, patched(state, { desk: { pending } }));
  return told(state, next, request, done);
}

function asksOf(one: Pending, answer: Changed, text: string): Asks {
  const { elsewhere: lines, steps, values, replaced } = answer;
  return { text, lines, steps, values, ...(replaced && hasToReplace(one, answer) ? { replaced } : {}) };
}

/** The notes at the fields whose values went. */
export const resetsOf = (unfit: readonly Unfit[]): Record<string, Reset> =>
  Object.fromEntries(
    unfit.map(({ name, value, before }) => [name, before === undefined ? { value } : { value, before }]),
  );

/** What a change did beside the value: it is said, and can be taken back. */
function told(before: State, after: State, { at }: ChangeRequest, done: { one: Pending; answer: Changed }[]): State {
  const answers = done.map(({ answer }) => answer);
  const findings = answers.flatMap(one => one.findings);
  if (!done.some(({ one }) => one.agreed === true) && !findings.length) return after;
  const taken = answers.flatMap(one => one.taken);
  const unfit = answers.flatMap(one => one.unfit);
  const inForm = before.form.open === at;
  const { values, resets } = after.form;
  const kept = Object.entries(values).filter(([name]) => !inForm || !taken.includes(name));
  const text = programOf(after);
  return patched(after, {
    form: inForm ? { values: Object.fromEntries(kept), resets: { ...resets, ...resetsOf(unfit) } } : {},
    page: { offer: true, notice: findings.length ? "notice-revised" : "notice-applied" },
    desk: {
      ...(findings.length ? { converted: { control: after.form.control, text, findings } } : {}),
    },
  });
}

/** Edits that the core proposes, made at once and undone as one. */
export function mended(state: State, edits: readonly Edit[], notice: string): State {
  return patched(withEdits(state, edits), { desk: { follow: "edits" }, page: { notice, offer: true } });
}

/** The call that is to be written in another way, or all; null: none is, or it is gone. */
export function conversion(state: State): ConvertRequest | null {
  const { control } = state.form;
  const { converting } = state.desk;
  if (!converting) return null;
  const call = state.program.reading?.view.calls.findIndex(one => one.from === converting.at) ?? -1;
  const wanted = converting.all ? {} : { call };
  const asked = {
    control,
    text: programOf(state),
    style: converting.style,
    ...wanted,
    ...programMachine(state),
    ...besideOf(state),
  };
  return converting.all || call >= 0 ? asked : null;
}

/** The findings that are to be cured together. */
export function curing(state: State): CureRequest | null {
  const { control } = state.form;
  const { curing } = state.desk;
  return (
    curing && {
      control,
      text: programOf(state),
      code: curing.code,
      key: curing.key,
      ...programMachine(state),
      ...besideOf(state),
    }
  );
}

/** What was typed and waits until it was seen what it changes, about the program as it is. */
export function unseen({ form: { control }, desk, program }: State): (Pending & { asks: Asks })[] {
  const text = program.texts[control] ?? "";
  const waits = (one: Pending): one is Pending & { asks: Asks } =>
    one.control === control && isWaiting(one, text) && !one.asks?.replaced;
  return desk.pending.filter(waits);
}

/** The values of several steps: those of the first as they are, of the last as they would be. */
function overall(values: readonly ComparedValue[]): ComparedValue[] {
  const all = new Map<string, ComparedValue>();
  for (const one of values) {
    const key = `${one.line} ${one.param}`;
    all.set(key, { ...one, before: (all.get(key) ?? one).before });
  }
  return [...all.values()].filter(one => one.before !== one.after);
}

/** What was typed and reaches further is shown. */
export function typedShown(state: State): State {
  const waiting = unseen(state);
  const [first] = waiting;
  if (!first) return state;
  const text = programOf(state);
  const steps = waiting.flatMap(one => one.asks.steps);
  const whole = difference(text, steps.reduce(splice, text));
  const title: Message =
    waiting.length > 1
      ? { key: "difference-typed-several", args: { count: waiting.length } }
      : { key: "difference-typed", args: { name: first.name, value: first.value.trim() || "–" } };
  return proposed(state, {
    edits: steps.length === 1 ? (steps[0] ?? []) : whole ? [whole] : [],
    title,
    values: overall(waiting.flatMap(one => one.asks.values)),
    notice: "notice-applied",
    typed: "values",
  });
}

/** All that waited until it was seen may be done. */
function seen(state: State): State {
  const pending = state.desk.pending.map(one =>
    one.asks && !one.asks.replaced ? { ...one, asks: undefined, agreed: true } : one,
  );
  return patched(state, { desk: { pending } });
}

/** What waited until it was seen is not done, and the form shows again what the program holds. */
export function refused(state: State): State {
  return withoutTyped(
    state,
    state.desk.pending.filter(one => one.asks && !one.asks.replaced),
  );
}

type Shown = Pick<Proposal, "edits" | "title" | "notice"> & Partial<Proposal>;

/** Edits of the present program that are shown before they are made. */
export function proposed(state: State, shown: Shown): State {
  const { control } = state.form;
  const nothing = { values: [], findings: [], converting: null, said: null, typed: null };
  const desk = { converting: null, curing: null, proposed: { ...nothing, control, text: programOf(state), ...shown } };
  return patched(state, { desk });
}

/** A conversion is shown; where there is none of the call, the reason is told beside it. */
export function converted(state: State, { edits, findings, values, calls }: Converted): State {
  const { converting } = state.desk;
  if (!converting) return state;
  const { all, style } = converting;
  if (!edits.length && !all) {
    const said = { control: state.form.control, text: programOf(state), findings };
    return patched(state, { desk: { converting: null, converted: said } });
  }
  const way = `way-${style}`;
  const line = state.program.reading?.view.calls.find(one => one.from === converting.at)?.lastLine ?? 0;
  const title: Message = all
    ? { key: "difference-convert-all", args: { way, count: calls } }
    : { key: "difference-convert", args: { way, line } };
  return proposed(state, { edits, findings, values, converting, title, notice: "notice-converted" });
}

/** What curing all findings of a kind would do is shown. */
export function cured(state: State, { edits, gone, left }: CuredAll): State {
  const said = left ? { key: "difference-left", args: { count: left } } : null;
  const title = { key: "difference-cure", args: { count: gone } };
  return state.desk.curing ? proposed(state, { edits, said, title, notice: "notice-mended" }) : state;
}

/** What was shown is not done. */
export function declined(state: State): State {
  const next = patched(state, { desk: { proposed: null } });
  return state.desk.proposed?.typed === "values" ? refused(next) : next;
}

/** The edits that were shown are made. */
export function agreed(state: State): State {
  const { proposed } = state.desk;
  const next = patched(state, { desk: { proposed: null } });
  if (!proposed?.edits.length || !isCurrent(proposed, state)) return next;
  if (proposed.typed === "values") return seen(next);
  const typed = proposed.typed ? withoutReplacing(next, proposed.typed.field) : next;
  const after = mended(typed, proposed.edits, proposed.notice);
  const { control, findings, converting } = proposed;
  const ofOpen = converting && converting.at === openCall(state)?.from && findings.length > 0;
  return ofOpen ? patched(after, { desk: { converted: { control, text: programOf(after), findings } } }) : after;
}
