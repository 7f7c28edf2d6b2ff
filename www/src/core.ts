// The seam to the core: JSON functions of probewright-web, here with types. This module of it is all that the form
// needs and is fetched first; what reads and runs programs comes when the form stands (program.ts).

import init, * as wasm from "@pkg/core/core.js";
import address from "@pkg/core/core_bg.wasm?url";
import { call, compile } from "./module";
import type { Catalogue, FormRequest, FormView } from "./wire";

export interface Core {
  catalogue(): Catalogue;
  form(request: FormRequest): FormView;
}

export async function loadCore(): Promise<Core> {
  await init({ module_or_path: await compile(address) });
  return {
    catalogue: () => JSON.parse(call("catalogue", () => wasm.catalogue())) as Catalogue,
    form: (request) => JSON.parse(call("form", () => wasm.form(JSON.stringify(request)))) as FormView,
  };
}
