// Scenarios beside the page, in a worker: one after the other, and stopped by ending the worker.

import type { Proof, Proved } from "./prover";

export interface Prover {
  /** Waits for the answer before; nothing comes of what is stopped. */
  ask(proof: Proof): Promise<Proved>;
  stop(): void;
}

export function createProver(module: WebAssembly.Module): Prover {
  let worker: Worker | null = null;
  const start = (): Worker => {
    const made = new Worker(new URL("./prover.ts", import.meta.url), { type: "module" });
    made.postMessage(module);
    return made;
  };
  return {
    ask(proof) {
      worker ??= start();
      const asked = worker;
      return new Promise(resolve => {
        asked.onmessage = ({ data }: MessageEvent<Proved>) => resolve(data);
        asked.onerror = event => resolve({ problem: event.message });
        asked.postMessage(proof);
      });
    },
    stop() {
      worker?.terminate();
      worker = null;
    },
  };
}
