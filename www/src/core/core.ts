// The seam to the core: JSON functions of probewright-web, here with types. This module of it is all that the form
// needs and is fetched first; what carries out cycles, reads and runs programs comes when the form stands (program.ts)
// and answers about forms from then on.

import init, * as wasm from "@pkg/core/core.js";
import address from "@pkg/core/core_bg.wasm?url";
import whole from "@pkg/program/program_bg.wasm?url";
import type { Catalogue, FormRequest, FormView } from "../wire";
import { call, compile } from "./module";
import type { SceneData } from "./scene";

/** `scene`: what is to be seen of a call that was carried out, made when it is first asked for. */
export interface Formed extends FormView {
  scene?: (times: number) => SceneData;
}

export interface FormCore {
  /** Whether `predict` is answered and a setup that the user described is read; else whether that will come. */
  simulates: "yes" | "coming" | "no";
  form(request: FormRequest): Formed;
}

export interface Core extends FormCore {
  catalogue(): Catalogue;
}

export async function loadCore(): Promise<Core> {
  const module = await compile(address);
  void compile(whole).catch(() => undefined); // it comes while the form is made; whoever needs it hears of a problem
  await init({ module_or_path: module });
  return {
    simulates: "coming",
    catalogue: () => JSON.parse(call("catalogue", () => wasm.catalogue())) as Catalogue,
    form: request => JSON.parse(call("form", () => wasm.form(JSON.stringify(request)))) as FormView,
  };
}
