// The core on a thread of its own. First comes the compiled module, then questions; each gets one answer, before it how
// much of a long program is done. A run goes in pieces, so that it hears between them that it should wait.

import { initSync } from "@pkg/core/core.js";
import type { Told } from "./handed";
import { reasonOf } from "./module";
import { answer, edit, type Held, hold, type Question, runInPieces, type Way } from "./program";
import { buffersOf, type SceneData } from "./scene";
import type { Columns } from "./steps";

/** Some more entries of a long list of an answer that follows, as JSON text. */
export interface Part {
  of: string;
  part: string;
}
export type Reply = { json: string; scene?: SceneData; steps?: Columns } | { problem: string } | Way | Part;
export interface Wait {
  wait: boolean;
}
/** `held`: about the text that was told before. */
export interface Asked {
  question: Question;
  held: boolean;
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

let text: Held | null = null;

function take(told: Told): void {
  if ("begin" in told) {
    text?.free();
    text = hold(told.begin);
  } else if ("piece" in told) text?.push(told.piece);
  else if (text) edit(text, [told.edit]);
}

const LONG_LIST = 500; // entries that the page reads at once without a standstill

/** Hands over what is long, in pieces; gives what remains. */
function inParts(json: string): string {
  if (json === "") return json;
  const view = JSON.parse(json) as Record<string, unknown>;
  const long = Object.entries(view).flatMap(([of, all]) =>
    Array.isArray(all) && all.length > LONG_LIST ? [{ of, all }] : [],
  );
  if (!long.length) return json;
  for (const { of, all } of long) {
    for (let from = 0; from < all.length; from += LONG_LIST)
      tell({ of, part: JSON.stringify(all.slice(from, from + LONG_LIST)) });
    view[of] = [];
  }
  return JSON.stringify(view);
}

async function ran(question: Question & { ask: "run" }, about: Held | null): Promise<Reply> {
  const { json, ...shown } = await runInPieces(question, about, between);
  return { json: inParts(json), ...shown };
}

async function reply({ question, held }: Asked): Promise<Reply> {
  const about = held ? text : null;
  try {
    return question.ask === "run" ? await ran(question, about) : { json: answer(question, about) };
  } catch (problem) {
    return { problem: reasonOf(problem) };
  }
}

addEventListener("message", ({ data }: MessageEvent<WebAssembly.Module | Asked | Told | Wait>) => {
  if (data instanceof WebAssembly.Module) initSync({ module: data });
  else if ("wait" in data) {
    waiting = data.wait;
    goOn();
  } else if ("question" in data) void reply(data).then(tell);
  else take(data);
});
