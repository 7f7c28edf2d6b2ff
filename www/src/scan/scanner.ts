// Scans a surface beside the page: one scan at a time. What came out lies in the state; the worker keeps the points, so
// that they can be shown in either way and saved.

import type { State } from "../state";
import type { Store } from "../store";
import type { ScanRequest, ScanText, ScanView } from "../wire";
import type { ScanAsk, ScanReply } from "./worker";

/** Which points are shown: those that are sent, or those of the surface under the ball. */
export type Shown = "sent" | "surface";
/** `shown`: which are chosen; `cloud` are those of `of`, the others until they come. */
export interface Scanned { request: ScanRequest; view: ScanView; cloud: Float32Array; of: Shown; shown: Shown }

export interface Scanner {
  /** How much is done, 0 to 1; null: nothing is scanned. */
  busy(): number | null;
  start(request: ScanRequest, file: Uint8Array): void;
  stop(): void;
  show(shown: Shown): void;
  /** The whole text, once it is made. */
  text(form: ScanText): Promise<Blob>;
}

/** None before the module is there. */
export function createScanner(module: () => WebAssembly.Module | undefined, store: Store): Scanner {
  let worker: Worker | null = null;
  let share: number | null = null;
  const texts = new Map<ScanText, (text: Blob) => void>();

  const tell = (ask: ScanAsk): void => worker?.postMessage(ask);
  const drop = (): void => {
    worker?.terminate();
    worker = null;
    share = null;
  };
  const fail = (why: string): void => {
    drop();
    store.update({ scan: null, scanProblem: why });
  };
  const hear = (request: ScanRequest, reply: ScanReply): void => {
    if ("problem" in reply) return fail(reply.problem);
    if ("share" in reply) share = reply.share;
    else if ("view" in reply) {
      const view = JSON.parse(reply.view) as ScanView;
      share = null;
      store.update({ scan: { request, view, cloud: new Float32Array(), of: "sent", shown: "sent" }, source: "scan", step: 0, playing: false });
      return tell({ cloud: "sent" });
    } else if ("cloud" in reply) store.update(({ scan }: State) => scan?.shown === reply.of ? { scan: { ...scan, cloud: reply.cloud, of: reply.of } } : {});
    else texts.get(reply.of)?.(reply.text);
    store.update({});
  };

  return {
    busy: () => share,
    start(request, file) {
      const compiled = module();
      if (!compiled) return;
      drop();
      share = 0;
      worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
      worker.onmessage = ({ data }: MessageEvent<ScanReply>) => hear(request, data);
      worker.onerror = (event) => fail(event.message);
      worker.postMessage(compiled);
      tell({ begin: JSON.stringify(request), file });
      store.update({ scan: null, scanProblem: "" });
    },
    stop() {
      drop();
      store.update({ scan: null });
    },
    show(shown) {
      tell({ cloud: shown });
      store.update(({ scan }: State) => scan ? { scan: { ...scan, shown } } : {});
    },
    text: (form) => new Promise((resolve) => {
      texts.set(form, resolve);
      tell({ text: form, points: store.state.scan?.view.points ?? 0 });
    }),
  };
}
