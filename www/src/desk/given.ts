// What a run is given beside program and machine: files, which program of the text it is, values of its parameters,
// whether it is strict, and how it is carried out.

import { parseNumber } from "../numbers";
import {
  type Arguments,
  beginningIn,
  besideOf,
  profile,
  programMachine,
  programPlane,
  type Ran,
  type State,
} from "../state/state";
import type { FormView, Machine, ProgramParameter, ProgramPlace, ReadView } from "../wire";
import { isCurrent } from "./program";

export type Given = Pick<Ran, "with" | "arguments" | "strict" | "mode" | "target" | "program" | "file">;

/** The program of a text that is to be run, where one is chosen that is in it. */
export function chosenIn(view: ReadView | undefined, { run: { main } }: State): ProgramPlace | undefined {
  return main === "" ? undefined : view?.programs?.find(({ name }) => name === main);
}

/** The parameters of the program that is run. */
export function parametersIn(view: ReadView | undefined, state: State): readonly ProgramParameter[] | undefined {
  const chosen = chosenIn(view, state);
  return chosen ? chosen.parameters : view?.parameters;
}

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

/** The machine of a run: the opened one, else that of the form. */
export function machineTo(state: State, view: Pick<FormView, "setup">): Machine | undefined {
  const opened = profile(state);
  return opened ?? (view.setup ? beginningIn(view.setup, programPlane(state)) : programMachine(state).setup);
}

/** How the program is carried out; only one control has modes. */
function modeIn({ form: { control }, run: { mode, target } }: State): Pick<Given, "mode" | "target"> {
  if (control !== "sinumerik" || mode === "automatic") return {};
  return mode === "block-search" ? { mode, target } : { mode };
}

/** `known`: whether the program is read, so that it is clear which parameters it has. */
export function givenTo(state: State): Given & { known: boolean } {
  const { reading, given } = state.program;
  const typed = given[state.form.control];
  const parameters = parametersIn(reading?.view, state);
  const chosen = chosenIn(reading?.view, state);
  const file = state.program.files[state.form.control]?.name;
  const values = typed && parameters ? argumentsOf(typed, parameters) : {};
  return {
    known: (!typed && state.run.main === "") || isCurrent(reading, state),
    ...besideOf(state),
    ...(Object.keys(values).length ? { arguments: values } : {}),
    ...(state.run.strict ? { strict: true } : {}),
    ...modeIn(state),
    ...(chosen ? { program: chosen.name } : {}),
    ...(file ? { file } : {}),
  };
}
