// The core on a thread of its own. First comes the compiled module, then questions; each gets one answer, before it how
// much of a long program is done. A run goes in pieces, so that it hears between them that it should wait.

import { initSync } from "@pkg/program/program.js";
import { answer, type Question, runInPieces, type Way } from "./program";
import { buffersOf, type SceneData } from "./scene";
import type { Columns } from "./steps";

export type Reply = { json: string; scene?: SceneData; steps?: Columns } | { problem: string } | Way;
export interface Wait {
  wait: boolean;
}

const tell = (reply: Reply): void => postMessage(reply, { transfer: handed(reply) });

function handed(reply: Reply): ArrayBuffer[] {
  if ("share" in reply) return reply.seen ? buffersOf(reply.seen) : [];
  if (!("json" in reply)) return [];
  const steps = Object.values(reply.steps ?? {}).map(({ buffer }) => buffer as ArrayBuffer);
  return [...(reply.scene ? buffersOf(reply.scene) : []), ...steps];
}

addEventListener("probewright-progress", event =>
  tell({ share: event instanceof CustomEvent ? Number(event.detail) : 0 }),
);

let waiting = false;
let goOn = (): void => {};

/** Lets messages in, and comes back once nobody wants the run to wait. */
async function between(way: Way): Promise<void> {
  tell(way);
  await new Promise(resolve => setTimeout(resolve));
  while (waiting)
    await new Promise<void>(resolve => {
      goOn = resolve;
    });
}

async function reply(question: Question): Promise<Reply> {
  try {
    return question.ask === "run" ? await runInPieces(question, between) : { json: answer(question) };
  } catch (problem) {
    return { problem: problem instanceof Error ? problem.message : String(problem) };
  }
}

addEventListener("message", ({ data }: MessageEvent<WebAssembly.Module | Question | Wait>) => {
  if (data instanceof WebAssembly.Module) initSync({ module: data });
  else if ("wait" in data) {
    waiting = data.wait;
    goOn();
  } else void reply(data).then(tell);
});
