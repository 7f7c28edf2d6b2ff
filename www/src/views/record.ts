// The record of a run as a document: docs/record.schema.json. Beside every key stands what it says.

import { sliced } from "../pace";
import { say } from "../texts";
import type { Message, RunRecord, RunView } from "../wire";

const FORMAT = 1;
/** What only people know of a record, filled in before it is printed; empty: there is room to write. */
export const TITLES = ["part", "order", "machine", "inspector"] as const;

/** What is shown of a run, simulated or measured on the machine. */
export type RecordShown = Pick<RunView, "about" | "answers" | "ending" | "files">;

/** `program`: name of the file. */
export function recordOf({ about, answers, ending, files }: RecordShown, program: string): RunRecord {
  const beside = (files ?? []).map(({ name, line }) => ({ name, line }));
  return { format: FORMAT, program, about, files: beside, ending, calls: answers };
}

const isMessage = (value: object): value is Message => "key" in value && "args" in value;

/** With the sentence beside every key. */
export function spoken(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(spoken);
  if (typeof value !== "object" || value === null) return value;
  const members = Object.fromEntries(Object.entries(value).map(([name, one]) => [name, spoken(one)]));
  return isMessage(value) ? { ...members, text: say(value) } : members;
}

/** The file in pieces, a call a line; between them the page has its turn. */
export async function recordText({ calls, ...head }: RunRecord): Promise<string[]> {
  const begin = JSON.stringify(spoken(head), null, 2).slice(0, -2); // without its end
  const pieces = [`${begin},\n  "calls": [`];
  const pace = sliced();
  for (const [index, call] of calls.entries()) {
    await pace.turn(0);
    pieces.push(`${index > 0 ? "," : ""}\n    ${JSON.stringify(spoken(call))}`);
  }
  return [...pieces, "\n  ]\n}\n"];
}
