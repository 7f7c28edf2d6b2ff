// What a run is given beside program and machine: files, values of the program's own parameters, whether it is strict.

import { parseNumber } from "../numbers";
import { type Arguments, besideOf, type Ran, type State } from "../state/state";
import type { ProgramParameter } from "../wire";
import { isCurrent } from "./program";

export type Given = Pick<Ran, "with" | "arguments" | "strict">;

/** As typed: a number, else a text, with or without quotation marks. */
function worth(typed: string): number | string {
  return parseNumber(typed) ?? typed.trim().replace(/^"(.*)"$/, "$1");
}

let last: { typed: object; parameters: object; made: Arguments } | null = null;

/** The typed values of parameters that the program has; always the same object for the same. */
function argumentsOf(typed: Record<string, string>, parameters: readonly ProgramParameter[]): Arguments {
  if (last?.typed === typed && last.parameters === parameters) return last.made;
  const there = parameters.filter(({ name }) => typed[name]?.trim());
  const made = Object.fromEntries(there.map(({ name }) => [name, worth(typed[name] ?? "")]));
  last = { typed, parameters, made };
  return made;
}

/** `known`: whether the program is read, so that it is clear which parameters it has. */
export function givenTo(state: State): Given & { known: boolean } {
  const { reading, given } = state.program;
  const typed = given[state.form.control];
  const parameters = reading?.view.parameters;
  const values = typed && parameters ? argumentsOf(typed, parameters) : {};
  return {
    known: !typed || isCurrent(reading, state),
    ...besideOf(state),
    ...(Object.keys(values).length ? { arguments: values } : {}),
    ...(state.run.strict ? { strict: true } : {}),
  };
}
