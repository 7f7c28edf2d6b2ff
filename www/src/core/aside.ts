// Long work beside the page, in a worker: one question at a time, of those that wait only the newest. An answer lies
// ready until the next redraw takes it, so that nothing changes between two redraws.

import { createHanded, type Handed } from "./handed";
import type { Question, Way } from "./program";
import type { SceneData } from "./scene";
import type { Columns } from "./steps";
import type { Asked, Part, Reply, Wait } from "./worker";

export interface Answered {
  question: Question;
  json?: string;
  parts?: Parts;
  scene?: SceneData; // of a run
  steps?: Columns; // the same
  problem?: string;
}
/** Long lists of an answer, by name: they came in pieces before it, which the page read one by one. */
export type Parts = Record<string, unknown[]>;
/**
 * `since`: ms, as performance.now; `share`: how much is done, where that is told; `halted`: since when it waits;
 * `seen`: what is to be seen of it already.
 */
export interface Busy {
  question: Question;
  since: number;
  share?: number;
  halted?: number;
  seen?: SceneData;
}
export interface Aside {
  /**
   * Asks, unless just this is already asked. An older question that waits is forgotten, one that takes long is broken
   * off.
   */
  want(question: Question): void;
  /** The answer that came since the last time. */
  take(): Answered | null;
  /** What is being worked on. */
  busy(): Busy | null;
  /** Lets a run wait, or go on. */
  halt(on: boolean): void;
  stop(): void;
}

const PATIENCE = 1500; // ms that an outdated question may still take
const GIANT = 100_000_000; // characters

/**
 * Whether a text is so long that one worker at a time has it, and none waits for the next question about it: each needs
 * several times its memory, and hands that back only at its own end.
 */
export const isGiant = (text: string): boolean => text.length > GIANT;

function same(a: Question | null | undefined, b: Question): boolean {
  return !!a && Object.entries(b).every(([name, value]) => a[name as keyof Question] === value);
}

/**
 * The worker starts with the first question, none before the module is there; `ready` is called when there is something
 * to take.
 */
export function createAside(module: () => WebAssembly.Module | undefined, ready: () => void): Aside {
  let worker: Worker | null = null;
  let handed: Handed | null = null; // of this worker
  let running: Busy | null = null;
  let parts: Parts = {}; // of its answer
  let waiting: Question | null = null;
  let done: Answered | null = null;

  const end = (answered: Answered): void => {
    done = answered;
    running = null;
    const next = waiting;
    waiting = null;
    if (next) ask(next);
    else if (isGiant(answered.question.text)) drop();
    ready();
  };
  const drop = (): void => {
    worker?.terminate();
    worker = handed = null;
  };
  const start = (compiled: WebAssembly.Module): Worker => {
    const made = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    const finish = (reply: Exclude<Reply, Way | Part>): void => {
      if ("problem" in reply) drop(); // no call is safe any more
      if (running) end({ question: running.question, ...reply, parts });
    };
    const take = ({ of, part }: Part): void => {
      const all = parts[of] ?? [];
      all.push(...(JSON.parse(part) as unknown[]));
      parts[of] = all;
    };
    const hear = (reply: Reply): void => {
      if ("part" in reply) take(reply);
      else if (!("share" in reply)) finish(reply);
      else if (running) {
        running = { ...running, ...reply };
        if (reply.seen) ready();
      }
    };
    made.onmessage = ({ data }: MessageEvent<Reply>) => hear(data);
    made.onerror = event => finish({ problem: event.message });
    made.postMessage(compiled);
    handed = createHanded((told, transfer) => made.postMessage(told, transfer));
    return made;
  };
  /** Long texts come before the question, which is about them then. */
  const hand = async (to: Worker, question: Question): Promise<void> => {
    const text = await handed?.hand(question.text, () => worker !== to);
    if (text != null && worker === to) to.postMessage({ question: { ...question, text }, held: true } satisfies Asked);
  };
  const ask = (question: Question): void => {
    const compiled = module();
    if (!compiled) return;
    worker ??= start(compiled);
    running = { question, since: performance.now() };
    parts = {};
    if (handed?.takes(question.text)) void hand(worker, question);
    else worker.postMessage({ question, held: false } satisfies Asked);
  };
  const stop = (): void => {
    if (running) drop();
    running = waiting = done = null;
  };

  return {
    want(question) {
      if (same(running?.question, question)) {
        waiting = null;
        return;
      }
      if (same(waiting ?? done?.question, question)) return;
      if (running && performance.now() - running.since > PATIENCE) stop();
      if (running) waiting = question;
      else ask(question);
    },
    take() {
      const taken = done;
      done = null;
      return taken;
    },
    busy: () => running,
    halt(on) {
      if (!running || on === (running.halted !== undefined)) return;
      worker?.postMessage({ wait: on } satisfies Wait);
      const { halted, ...going } = running;
      running = on
        ? { ...going, halted: performance.now() }
        : { ...going, since: going.since + performance.now() - (halted ?? 0) };
      ready();
    },
    stop,
  };
}
