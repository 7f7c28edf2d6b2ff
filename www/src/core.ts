// The seam to the core: JSON functions of probewright-web, here with types. Calls are made on this thread;
// whoever wants them in a worker puts it behind `Core` and nothing else changes.

import init, * as wasm from "@pkg/core/core.js";
import type { Catalogue, Dialect, Edit, FormRequest, FormView, ReadRequest, ReadView, RunRequest, RunView } from "./wire";

export interface Core {
  catalogue(): Catalogue;
  form(request: FormRequest): FormView;
  read(request: ReadRequest): ReadView;
  change(request: { control: Dialect; text: string; call: number; name: string; value: string }): Edit[];
  run(request: RunRequest): RunView;
}

/** The core broke: a bug, never a wrong input. After it no call is safe. */
export class Broken extends Error {}

function call<T>(name: string, run: () => string): T {
  let json: string;
  try {
    json = run();
  } catch (problem) {
    throw new Broken(`${name}: ${problem instanceof Error ? problem.message : String(problem)}`, { cause: problem });
  }
  return JSON.parse(json) as T;
}

/** The cursor, the marks and the list of problems all ask about the same text: it is read once. */
function readOnce(read: Core["read"]): Core["read"] {
  let last: { request: ReadRequest; view: ReadView } | null = null;
  return (request) => {
    const same = last?.request.control === request.control && last.request.text === request.text && last.request.setup === request.setup;
    if (!last || !same) last = { request, view: read(request) };
    return last.view;
  };
}

export async function loadCore(): Promise<Core> {
  await init();
  return {
    catalogue: () => call("catalogue", () => wasm.catalogue()),
    form: (request) => call("form", () => wasm.form(JSON.stringify(request))),
    read: readOnce((request) => call("read", () => wasm.read(JSON.stringify(request)))),
    change: (request) => call("change", () => wasm.change(JSON.stringify(request))),
    run: (request) => call("run", () => wasm.run(JSON.stringify(request))),
  };
}
