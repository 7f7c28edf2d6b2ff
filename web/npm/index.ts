// Probewright for JavaScript: measuring cycles of CNC controls, in Node and in the browser. Nothing leaves the machine.

import init, * as wasm from "./core/core.js";
import type {
  AlarmInfo,
  Catalogue,
  Changed,
  Converted,
  CuredAll,
  CureRequest,
  Dialect,
  FormRequest,
  FormView,
  HelpRequest,
  HelpView,
  MachineRequest,
  MachineView,
  ReadRequest,
  ReadView,
  Recognised,
  RunRequest,
  RunView,
  Setup,
  Style,
} from "./wire.js";

export type * from "./wire.js";

/** A value of a call of a program, to be changed: `call` is its number among the calls that `read` lists. */
export interface ChangeRequest extends ReadRequest {
  call: number;
  name: string;
  value: string;
}

/** A call of a program, or all of them where none is given, to be written in another way. */
export interface ConvertRequest extends ReadRequest {
  call?: number;
  style: Style;
}

/**
 * What can be asked. Texts are part programs as they stand in the file; places in them are UTF-16 offsets, as
 * JavaScript counts. A question of the wrong shape throws an `Error` that says what is wrong with it.
 */
export interface Probewright {
  /** All cycles: variants, parameters, results, a worked example of each. */
  catalogue(): Catalogue;
  /** All alarms and messages of the controls. */
  alarms(): AlarmInfo[];
  /**
   * A form filled with these values: its fields, what is wrong with them, the part program that it writes
   * (`snippet`), and with `predict` what the control would do.
   */
  form(request: FormRequest): FormView;
  /** The measuring calls of a part program, and what is wrong with it. */
  read(request: ReadRequest): ReadView;
  /** The edits that give a value of a call; nothing else of the text changes. See `apply`. */
  change(request: ChangeRequest): Changed;
  /** The edits that write calls in another way. */
  convert(request: ConvertRequest): Converted;
  /** The edits that cure all findings of a kind. */
  cure(request: CureRequest): CuredAll;
  /** Runs a part program on a machine (`setup`): motions, touches, results, corrections, alarms, log. */
  run(request: RunRequest): RunView;
  /** What a measuring variant does, what it needs, what can go wrong. */
  help(request: HelpRequest): HelpView;
  /** User data and machine data, with what is wrong with them. */
  machine(request: MachineRequest): MachineView;
  /** The text of a setup file, with all that it leaves to its default. */
  setup(text: string): Setup;
  /** What the bytes of a file are: a part program in this encoding, or why it is none. */
  recognise(bytes: Uint8Array): Recognised;
  /** Version of the package. */
  version: string;
}

const RUN_PIECE = 2000; // blocks

/**
 * Loads the module: in Node from its file, in a browser by `fetch` from beside this script, or from `module`, the bytes
 * of `core/core_bg.wasm` or its address.
 */
export async function load(module?: BufferSource | WebAssembly.Module | URL | string): Promise<Probewright> {
  await init({ module_or_path: module ?? (await beside()) });
  const ask = <Answer>(function_: (question: string) => string, question: unknown): Answer =>
    JSON.parse(function_(JSON.stringify(question))) as Answer;
  return {
    catalogue: () => JSON.parse(wasm.catalogue()) as Catalogue,
    alarms: () => JSON.parse(wasm.alarms()) as AlarmInfo[],
    form: request => ask(wasm.form, request),
    read: request => ask(wasm.read, request),
    change: request => ask(wasm.change, request),
    convert: request => ask(wasm.convert, request),
    cure: request => ask(wasm.cure, request),
    run: request => run(request),
    help: request => ask(wasm.help, request),
    machine: request => ask(wasm.machine, request),
    setup: text => JSON.parse(wasm.setup(text)) as Setup,
    recognise: bytes => recognise(bytes),
    version: wasm.version(),
  };
}

/** The text behind the edits of a change: each step holds edits for the text behind the step before. */
export function apply(text: string, steps: Changed["steps"]): string {
  return steps.reduce((before, edits) => {
    // what is inserted where another edit begins stands before it
    const inOrder = [...edits].sort((one, other) => one.from - other.from || one.to - other.to);
    return inOrder.reduceRight((now, edit) => now.slice(0, edit.from) + edit.insert + now.slice(edit.to), before);
  }, text);
}

/** A part program with one call: the snippet of a form, in what the control wants around it. */
export function program(control: Dialect, snippet: string): string {
  return control === "nct" ? `%\n${snippet}M30\n%\n` : `${snippet}M30\n`;
}

function run(request: RunRequest): RunView {
  const run = new wasm.Run(JSON.stringify(request));
  while (!run.advance(RUN_PIECE)) {} // a run ends by itself: steps and entries are limited
  return JSON.parse(run.view()) as RunView;
}

function recognise(bytes: Uint8Array): Recognised {
  const recogniser = new wasm.Recogniser();
  recogniser.take(bytes);
  return JSON.parse(recogniser.finish()) as Recognised;
}

/** The module beside this script: its bytes in Node, where nothing serves it, its address in a browser. */
async function beside(): Promise<BufferSource | URL> {
  const address = new URL("./core/core_bg.wasm", import.meta.url);
  if (address.protocol !== "file:") return address;
  const { readFile } = await import("node:fs/promises");
  return readFile(address);
}
