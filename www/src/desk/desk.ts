// What follows from a change of the program or of the form before it is drawn: the program is read, what the form
// changed is written into it, the form follows the cursor. Short programs at once, long ones by a worker.
//
// A state stands in one of a few ways, and each way has one transition to the next; the desk goes through them until
// the state is settled, or waits for an answer.

import type { Answered, Aside } from "../core/aside";
import { isWaiting } from "../core/pending";
import type { AtOnce, ProgramCore } from "../core/program";
import { besideOf, patched, programMachine, programOf, type Reading, type State } from "../state/state";
import type { Catalogue, Changed, Converted, CuredAll, EquipView, ReadView } from "../wire";
import { arrived } from "./calls";
import { supplied, supplying } from "./equipped";
import { isCurrent, isOfNow, isRead } from "./program";
import { answeredByLeaving, change, changed, conversion, converted, cured, curing } from "./typing";

/** Of a program that is read between two keystrokes, in characters. */
const SHORT = 8_000;

export type Answer = ReadView | Changed[] | Converted | CuredAll | EquipView;

/** How program and form stand to each other; the first that is so counts. */
export type Standing =
  | { is: "stopped" } // nothing is asked any more about this long text
  | { is: "unread"; question: AtOnce } // it is not known what the program holds: it is read
  | { is: "looking"; reading: Reading } // the form is to show another call: it does
  | { is: "typed"; question: AtOnce } // the form is ahead of the program: it is written into it
  | { is: "rewriting"; question: AtOnce } // calls are to be written in another way, findings to be cured: it is shown
  | { is: "giving"; question: AtOnce } // the machine gets what the program lacks
  | { is: "astray" } // that call is gone: nobody waits for it any more
  | { is: "left"; kept: State } // the form has left a call in which something waits for a word
  | { is: "settled" };

export function standing(state: State): Standing {
  const { control } = state.form;
  const { follow, sought, converting } = state.desk;
  const { reading, stoppedReading } = state.program;
  const supply = supplying(state);
  if (supply) return { is: "giving", question: { ask: "equip", ...supply } };
  if (!reading || !isRead(state)) {
    if (isLong(state) && isCurrent(stoppedReading, state)) return { is: "stopped" };
    return {
      is: "unread",
      question: { ask: "read", control, text: programOf(state), ...programMachine(state), ...besideOf(state) },
    };
  }
  if (follow || sought) return { is: "looking", reading };
  const kept = answeredByLeaving(state);
  if (kept !== state) return { is: "left", kept };
  const typed = change(state);
  if (typed) return { is: "typed", question: { ask: "change", ...typed } };
  const rewritten = conversion(state);
  if (rewritten) return { is: "rewriting", question: { ask: "convert", ...rewritten } };
  const cures = curing(state);
  if (cures) return { is: "rewriting", question: { ask: "cure", ...cures } };
  return { is: converting ? "astray" : "settled" };
}

/** The state with an answer. The question was about its program as it is. */
export function answered(state: State, question: AtOnce, answer: Answer, catalogue: Catalogue): State {
  switch (question.ask) {
    case "read": {
      const { ask: _, ...about } = question;
      return arrived(state, { ...about, view: answer as ReadView });
    }
    case "change":
      return changed(state, question, answer as Changed[]);
    case "convert":
      return converted(state, answer as Converted);
    case "cure":
      return cured(state, answer as CuredAll);
    case "equip":
      return supplied(state, answer as EquipView, catalogue);
  }
}

/** The state without an answer: nothing is asked about this text any more. */
export function failed(state: State, { ask, control, text }: AtOnce, why: string): State {
  return patched(state, {
    desk: { converting: null, curing: null, giving: null, pending: ask === "change" ? [] : state.desk.pending },
    program: { stoppedReading: { control, text, why } },
  });
}

/** The next state; null: there is none, or not before an answer. */
export function next(state: State, answer: (question: AtOnce) => Answer | null, catalogue: Catalogue): State | null {
  const now = standing(state);
  switch (now.is) {
    case "unread":
    case "typed":
    case "rewriting":
    case "giving": {
      const found = answer(now.question);
      return found && answered(state, now.question, found, catalogue);
    }
    case "looking":
      return arrived(state, now.reading);
    case "left":
      return now.kept;
    case "astray":
      return patched(state, { desk: { converting: null } });
    case "stopped":
    case "settled":
      return null;
  }
}

/** Whether nothing more follows from a state by itself; what waits for a word may wait. */
export function isSettled(state: State): boolean {
  const text = programOf(state);
  const onTheWay = state.desk.pending.some(one => one.control === state.form.control && !isWaiting(one, text));
  return !onTheWay && ["settled", "stopped"].includes(standing(state).is);
}

function isLong(state: State): boolean {
  return programOf(state).length > SHORT;
}

function atOnce(core: ProgramCore, question: AtOnce): Answer {
  switch (question.ask) {
    case "read":
      return core.read(question);
    case "change":
      return core.change(question);
    case "convert":
      return core.convert(question);
    case "cure":
      return core.cure(question);
    case "equip":
      return core.equip(question);
  }
}

/** What the worker has answered, if it is about the program as it is. */
function taken(state: State, answer: Answered | null, catalogue: Catalogue): State {
  if (!answer || !isOfNow(answer.question, state)) return state;
  const { question, json, problem } = answer;
  switch (question.ask) {
    case "run":
    case "certainty":
    case "whole_certainty":
    case "series":
      return state;
  }
  return json === undefined
    ? failed(state, question, problem ?? "")
    : answered(state, question, JSON.parse(json) as Answer, catalogue);
}

/** Until the part of the core that reads is there, nothing is settled. */
export function createDesk(
  programCore: () => ProgramCore | null,
  reader: Aside,
  catalogue: Catalogue,
): (state: State) => State {
  return state => {
    const core = programCore();
    let settled = taken(state, reader.take(), catalogue);
    const answer = (question: AtOnce): Answer | null => {
      if (core && !isLong(settled)) return atOnce(core, question);
      reader.want(question);
      return null;
    };
    const after = (): State | null => next(settled, answer, catalogue);
    for (let found = core && after(); found; found = after()) settled = found;
    return settled;
  };
}
