// The core on a thread of its own, for scenarios and protocols: first comes the compiled module, then questions, each
// with an answer.

import { initSync, note, protocol, scenario } from "@pkg/core/core.js";
import type { Beside, NoteRequest, ProtocolRequest } from "../wire";

/** A scenario file with the files that it names, a run of which one is made, or a protocol laid onto a run. */
export type Proof = { text: string; beside: readonly Beside[] } | { note: NoteRequest } | { protocol: ProtocolRequest };
export type Proved = { json: string } | { problem: string };

function answer(proof: Proof): Proved {
  try {
    if ("note" in proof) return { json: note(JSON.stringify(proof.note)) };
    if ("protocol" in proof) return { json: protocol(JSON.stringify(proof.protocol)) };
    return { json: scenario(proof.text, JSON.stringify(proof.beside)) };
  } catch (problem) {
    return { problem: problem instanceof Error ? problem.message : String(problem) };
  }
}

addEventListener("message", ({ data }: MessageEvent<WebAssembly.Module | Proof>) => {
  if (data instanceof WebAssembly.Module) initSync({ module: data });
  else postMessage(answer(data));
});
