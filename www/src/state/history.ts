// What was done, step by step: undone and done again across form, program and machine. A step is told by what differs
// between the work before and after it, so that nothing that changes the work has to say so.

import { difference } from "../difference";
import { type Splice, splice } from "../eol";
import { LONG } from "../pace";
import type { Dialect } from "../wire";
import { type History, type Patch, patched, type State, type Step, type StepName } from "./state";
import { work } from "./stored";

/** Steps that are kept, and characters of different programs in them. */
const MOST = 200;
const MOST_TEXT = 32_000_000;
/** What is typed into the same place within this time is one step, ms. */
const TOGETHER = 1000;

/** Whether two values of the state say the same. */
function same(one: unknown, other: unknown): boolean {
  if (one === other) return true;
  if (typeof one !== "object" || typeof other !== "object" || !one || !other) return false;
  const names = Object.keys(one);
  const value = (of: object, name: string): unknown => (of as Record<string, unknown>)[name];
  return names.length === Object.keys(other).length && names.every(name => same(value(one, name), value(other, name)));
}

/** Names of the values of one list that differ from those of the other. */
function differing(one: Record<string, unknown>, other: Record<string, unknown>): string[] {
  const names = new Set([...Object.keys(one), ...Object.keys(other)]);
  return [...names].filter(name => !same(one[name] ?? "", other[name] ?? ""));
}

type Told = Omit<Step, "work" | "edits" | "at">;

const named = (key: string, args: StepName["args"] = {}): Told => ({ name: { key, args }, subject: "" });

/** Notices of what the page itself has done: their step is called after them. */
const DONE: Record<string, string> = {
  "notice-inserted": "step-insert",
  "notice-converted": "step-convert",
  "notice-mended": "step-fix",
  "notice-applied": "step-fix",
  "notice-assigned": "step-assign",
  "notice-example": "step-example",
  "notice-set-loaded": "step-set-load",
};

/** A step between two states; `inEditor`: the user typed into the program. */
interface Between {
  before: State;
  after: State;
  inEditor: boolean;
}

const textsDiffer = ({ before, after }: Between): boolean =>
  differing(before.program.texts, after.program.texts).length > 0;
const sameForm = ({ before, after }: Between): boolean =>
  before.form.cycle === after.form.cycle && before.form.control === after.form.control;

/** What waits for a word in the call of the form. */
const asksIn = ({ form: { control, open }, desk: { pending } }: State): string[] =>
  pending.filter(one => one.control === control && one.at === open && one.asks).map(one => one.name);

/** A question that nobody answers: the program keeps what it has. */
function ofQuestion({ before, after }: Between): Told | null {
  const { notice } = after.page;
  const [field] = asksIn(before);
  return field !== undefined && notice === "notice-kept" && !after.desk.pending.some(one => one.asks)
    ? named("step-kept", { field, value: before.form.values[field] || "–" })
    : null;
}

function ofFile({ before, after }: Between): Told | null {
  const { control } = after.form;
  const file = after.program.files[control];
  return file?.opened === before.program.files[control]?.opened ? null : named("step-open", { file: file?.name ?? "" });
}

function ofPage(step: Between): Told | null {
  const { before, after } = step;
  const { notice } = after.page;
  const key = notice === before.page.notice ? undefined : DONE[notice];
  const differs = textsDiffer(step) || differing(before.form.values, after.form.values).length > 0;
  return key && differs ? named(key) : null;
}

const IN_PROGRAM = "program ";

function ofEditor(step: Between): Told | null {
  const { line } = step.after.program;
  return step.inEditor && textsDiffer(step)
    ? { ...named("step-program", { line }), subject: `${IN_PROGRAM}${line}` }
    : null;
}

/** Of another task the form has the values it had; another call that is looked at is no step. */
function ofForm(step: Between): Told | null {
  const [was, is] = [step.before.form, step.after.form];
  if (!sameForm(step)) return is.open === null ? named("step-task", { cycle: is.cycle }) : null;
  if (was.open !== is.open && !textsDiffer(step)) return null;
  const names = differing(was.values, is.values);
  const [field] = names;
  if (field === undefined) return null;
  if (names.length > 1) return named("step-values", { cycle: is.cycle });
  return { ...named("step-field", { field, value: is.values[field] || "–" }), subject: `field ${field}` };
}

/** What says itself what it does to the machine is called so. */
function ofMachine({ before, after }: Between): Told {
  const { told } = after.machine;
  return told && told !== before.machine.told ? named(told.key, told.args) : named("step-machine");
}

function ofRest(step: Between): Told | null {
  const { before, after } = step;
  if (textsDiffer(step)) return named("step-program", { line: after.program.line });
  const encoding = after.program.files[after.form.control]?.encoding ?? "";
  const told = after.machine.told !== before.machine.told;
  if (!same(before.program.beside, after.program.beside)) return told ? ofMachine(step) : named("step-beside");
  if (!same(before.program.given, after.program.given)) return { ...named("step-given"), subject: "given" };
  if (!same(before.program.files, after.program.files)) return named("step-encoding", { encoding });
  if (!same(before.part.errors, after.part.errors)) return { ...named("step-errors"), subject: "errors" };
  if (!same({ ...before.machine, told: null }, { ...after.machine, told: null })) return ofMachine(step);
  return same(before.form.sets, after.form.sets) ? null : named("step-sets");
}

/** What was done between two states; none: nothing that could be undone. */
export function toldStep(before: State, after: State, inEditor: boolean): Told | null {
  const step = { before, after, inEditor };
  return ofFile(step) ?? ofQuestion(step) ?? ofPage(step) ?? ofEditor(step) ?? ofForm(step) ?? ofRest(step);
}

type Texts = State["program"]["texts"];
type Work = Pick<Step, "work" | "edits">;

const textsOf = ({ program }: Patch): Texts => program?.texts ?? {};
const withTexts = (work: Patch, texts: Texts): Patch => ({ ...work, program: { ...work.program, texts } });

/** The work as a step holds it that has these programs on its other side. */
function held(whole: Patch, other: Texts): Work {
  const edits: Step["edits"] = {};
  const texts: Texts = {};
  for (const [control, text] of Object.entries(textsOf(whole)) as [Dialect, string][]) {
    const from = other[control];
    const edit = text.length > LONG && from !== undefined ? difference(from, text) : undefined;
    if (edit === undefined || (edit && edit.insert.length > LONG)) texts[control] = text;
    else edits[control] = edit;
  }
  return { work: withTexts(whole, texts), edits };
}

/** The work that a step holds, all of it. */
function whole({ work, edits }: Work, other: Texts): Patch {
  const made = (Object.entries(edits) as [Dialect, Splice | null][]).map(([control, edit]) => {
    const text = other[control] ?? "";
    return [control, edit ? splice(text, [edit]) : text];
  });
  return withTexts(work, { ...textsOf(work), ...Object.fromEntries(made) });
}

/** A step on whose other side these programs stand now: what followed from a step back is no step. */
function standing(step: Step, other: Texts, now: Texts): Step {
  return other === now ? step : { ...step, ...held(whole(step, other), now) };
}

/** Characters that a step holds and the step after it does not. */
function weight({ work, edits }: Step, next: Step | undefined): number {
  const after = next && textsOf(next.work);
  const texts = Object.entries(textsOf(work)).filter(([one, text]) => after?.[one as Dialect] !== text);
  const inserts = Object.values(edits).map(edit => edit?.insert ?? "");
  return [...texts.map(([, text]) => text), ...inserts].reduce((sum, text) => sum + text.length, 0);
}

/** The last steps, no more than can be kept. */
function bounded(steps: Step[]): Step[] {
  let room = MOST_TEXT;
  let first = steps.length;
  while (first > Math.max(0, steps.length - MOST)) {
    room -= weight(steps[first - 1] as Step, steps[first]);
    if (room < 0) break;
    first -= 1;
  }
  return steps.slice(first);
}

/** What comes of a question that is answered with a change of the program. */
const ANSWERS = ["step-assign", "step-fix", "step-program", "step-field", "step-values"];
/** Those that have a name of their own. */
const NAMED = ["step-assign", "step-fix"];

/**
 * What was typed last and waits for a word, with all that is typed there until it is answered and what comes of the
 * answer: one step, however long that takes. null: it did not wait.
 */
function ofAsked(last: Step | undefined, told: Told, before: State, after: State): Told | null {
  const was = asksIn(before);
  if (!last?.asking || !was.length || told.name.key === "step-kept") return null;
  const left = was.some(name => asksIn(after).includes(name));
  const same = !differing(before.program.texts, after.program.texts).length;
  if (same && (told.subject ? told.subject === last.subject : !left)) return { ...told, asking: left };
  if (same || left || told.subject.startsWith(IN_PROGRAM) || !ANSWERS.includes(told.name.key)) return null;
  return { name: NAMED.includes(told.name.key) ? told.name : last.name, subject: "", asking: false };
}

/** The history with a step more, or with the last step longer by it. */
export function withStep(history: History, told: Told, before: State, after: State, at: number): History {
  const { texts } = after.program;
  const [rest, last] = [history.past.slice(0, -1), history.past.at(-1)];
  const asked = ofAsked(last, told, before, after);
  const longer = last && (asked || (told.subject && last.subject === told.subject && at - last.at < TOGETHER));
  const began = longer ? whole(last, history.texts) : work(before);
  // what was typed and not done after all is no step
  if (asked && !asked.asking && !toldStep(patched(after, began), after, false))
    return { past: rest, future: [], texts };
  const asking = asksIn(after).length > 0 && !asksIn(before).length;
  const step = { ...(asked ?? { ...told, asking }), at, ...held(began, texts) };
  const done = last && !longer ? [standing(last, history.texts, before.program.texts)] : [];
  return { past: bounded([...rest, ...done, step]), future: [], texts };
}

/** What goes back by so many steps, or forth where it is negative. */
export function stepped(state: State, steps: number): Patch | null {
  let { past, future, texts } = state.history;
  let now = work(state);
  for (let left = Math.abs(steps); left > 0; left--) {
    const [from, to] = steps > 0 ? [past, future] : [future, past];
    const step = from.at(-1);
    if (!step) return null;
    const there = whole(step, texts);
    texts = textsOf(there);
    const [rest, more] = [from.slice(0, -1), [...to, { ...step, ...held(now, texts), subject: "" }]];
    now = there;
    [past, future] = steps > 0 ? [rest, more] : [more, rest];
  }
  return { ...now, history: { past, future, texts } };
}
