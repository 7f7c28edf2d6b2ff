// The core on a thread of its own. First comes the compiled module, then questions; each gets one answer, before it how much of a long
// program is done.

import { initSync } from "@pkg/program/program.js";
import { answer, type Question } from "./program";

export type Reply = { json: string } | { problem: string } | { share: number };

addEventListener("probewright-progress", (event) => {
  const share = event instanceof CustomEvent ? Number(event.detail) : 0;
  postMessage({ share } satisfies Reply);
});

function reply(question: Question): Reply {
  try {
    return { json: answer(question) };
  } catch (problem) {
    return { problem: problem instanceof Error ? problem.message : String(problem) };
  }
}

addEventListener("message", ({ data }: MessageEvent<WebAssembly.Module | Question>) => {
  if (data instanceof WebAssembly.Module) initSync({ module: data });
  else postMessage(reply(data));
});
