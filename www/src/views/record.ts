// The record of a run as a document: docs/record.schema.json. Beside every key stands what it says.

import { say } from "../texts";
import type { Message, RunRecord, RunView } from "../wire";

const FORMAT = 1;

/** `program`: name of the file. */
export function recordOf({ about, answers, ending, files }: RunView, program: string): RunRecord {
  const beside = files?.map(({ name, line }) => ({ name, line }));
  return { format: FORMAT, program, about, ...(beside?.length && { files: beside }), ending, calls: answers };
}

const isMessage = (value: object): value is Message => "key" in value && "args" in value;

/** With the sentence beside every key. */
function spoken(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(spoken);
  if (typeof value !== "object" || value === null) return value;
  const members = Object.fromEntries(Object.entries(value).map(([name, one]) => [name, spoken(one)]));
  return isMessage(value) ? { ...members, text: say(value) } : members;
}

export function recordText(record: RunRecord): string {
  return `${JSON.stringify(spoken(record), null, 2)}\n`;
}
