// The seam to the core: JSON functions of probewright-web, here with types. Short questions are answered on this
// thread; what may take long is asked in a worker (aside.ts), with the same module.

import init, * as wasm from "@pkg/core/core.js";
import address from "@pkg/core/core_bg.wasm?url";
import { splice } from "./eol";
import type { Catalogue, Edit, FormRequest, FormView, Pending, ReadRequest, ReadView, RunRequest } from "./wire";

/** All values of one call that were changed in the form: `pending` of `control` at `at`, the call being number `call`. */
export interface ChangeRequest extends ReadRequest { call: number; at: number; pending: readonly Pending[] }

/** What is asked about a whole program. */
export type Question = { ask: "read" } & ReadRequest | { ask: "change" } & ChangeRequest | { ask: "run" } & RunRequest;

export interface Core {
  catalogue(): Catalogue;
  form(request: FormRequest): FormView;
  read(request: ReadRequest): ReadView;
  change(request: ChangeRequest): Edit[][];
}

/** The core broke: a bug, never a wrong input. After it no call is safe. */
export class Broken extends Error {}

function call(name: string, run: () => string): string {
  try {
    return run();
  } catch (problem) {
    throw new Broken(`${name}: ${problem instanceof Error ? problem.message : String(problem)}`, { cause: problem });
  }
}

/** One list of edits a value, each for the text after the edits before it. */
function changes({ control, text, call: index, at, pending }: ChangeRequest): Edit[][] {
  let now = text;
  return pending.filter((one) => one.control === control && one.at === at).map(({ name, value }) => {
    const edits = JSON.parse(call("change", () => wasm.change(JSON.stringify({ control, text: now, call: index, name, value })))) as Edit[];
    now = splice(now, edits);
    return edits;
  });
}

/** The answer as JSON text, so that a worker can hand it over as it is. */
export function answer(question: Question): string {
  const { ask, ...request } = question;
  if (question.ask === "change") return JSON.stringify(changes(question));
  return call(ask, () => ask === "read" ? wasm.read(JSON.stringify(request)) : wasm.run(JSON.stringify(request)));
}

/** Fetched and compiled once, for this thread and for the workers. */
async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(address);
  const served = response.headers.get("Content-Type")?.startsWith("application/wasm");
  return served ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

export async function loadCore(): Promise<{ core: Core; module: WebAssembly.Module }> {
  const module = await compile();
  await init({ module_or_path: module });
  const core: Core = {
    catalogue: () => JSON.parse(call("catalogue", () => wasm.catalogue())) as Catalogue,
    form: (request) => JSON.parse(call("form", () => wasm.form(JSON.stringify(request)))) as FormView,
    read: (request) => JSON.parse(answer({ ask: "read", ...request })) as ReadView,
    change: changes,
  };
  return { core, module };
}
