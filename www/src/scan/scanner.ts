// Scans a surface beside the page: one scan at a time. What came out lies in the state; the worker keeps the points, so
// that they can be shown in either way and saved.

import type { SceneData } from "../core/scene";
import type { Scanned, Shown } from "../state/scanned";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import type { ScanRequest, ScanText, ScanView } from "../wire";
import type { ScanAsk, ScanReply } from "./worker";

/** `taking`: points are made ready to be drawn; `writing`: a file. */
export type Work = "scanning" | "taking" | "writing";
/** `since`: ms, as performance.now; `share`: how much is done, 0 to 1; `size`: points that it is about. */
export interface Doing {
  work: Work;
  since: number;
  share: number;
  size: number;
}

export interface Scanner {
  /** What is being done. */
  busy(): Doing | null;
  start(request: ScanRequest, file: Uint8Array): void;
  /** Ends what is being done: with it a scan on its way is gone, one that is there stays as it is shown. */
  stop(): void;
  show(shown: Shown): void;
  /** `then` hears the whole text, once it is made. */
  text(form: ScanText, then: (text: Blob) => void): void;
}

/** None before the module is there. */
export function createScanner(module: () => WebAssembly.Module | undefined, store: Store): Scanner {
  let worker: Worker | null = null;
  let doing: Doing | null = null;
  let written: { form: ScanText; then: (text: Blob) => void } | null = null;

  const change = (to: (scan: Scanned) => Scanned): void =>
    store.update(({ scan: { made: scan } }: State) => (scan ? { scan: { made: to(scan) } } : {}));
  const begin = (work: Work, ask: ScanAsk): void => {
    doing = { work, since: performance.now(), share: 0, size: store.state.scan.made?.view.points ?? 0 };
    worker?.postMessage(ask);
    store.update({});
  };
  /** What is newly asked ends what was asked before. */
  const rest = (): void => {
    doing = written = null;
    worker?.postMessage("nothing" satisfies ScanAsk);
    change(scan => ({ ...scan, shown: scan.of }));
  };
  const drop = (): void => {
    worker?.terminate();
    worker = doing = written = null;
  };
  const fail = (why: string): void => {
    drop();
    store.update({ scan: { made: null, problem: why } });
  };
  const scanned = (request: ScanRequest, view: ScanView, scene: SceneData): void => {
    store.update({
      scan: { made: { request, view, scene, clouds: {}, of: "sent", shown: "sent" } },
      view: { source: "scan", step: 0, playing: false },
    });
    begin("taking", { cloud: "sent" });
  };
  const taken = (of: Shown, cloud: Float32Array): void => {
    if (doing?.work === "taking" && store.state.scan.made?.shown === of) doing = null;
    change(scan => ({ ...scan, clouds: { ...scan.clouds, [of]: cloud }, of: scan.shown === of ? of : scan.of }));
  };
  const wrote = (form: ScanText, text: Blob): void => {
    if (written?.form !== form) return; // another one was asked for meanwhile
    written.then(text);
    doing = written = null;
    store.update({});
  };
  const hear = (request: ScanRequest, reply: ScanReply): void => {
    if ("problem" in reply) fail(reply.problem);
    else if ("share" in reply) doing = doing && { ...doing, share: reply.share };
    else if ("view" in reply) scanned(request, JSON.parse(reply.view) as ScanView, reply.scene);
    else if ("cloud" in reply) taken(reply.of, reply.cloud);
    else wrote(reply.of, reply.text);
  };

  return {
    busy: () => doing,
    start(request, file) {
      const compiled = module();
      if (!compiled) return;
      drop();
      store.update({ scan: { made: null, problem: "" } });
      const made = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
      worker = made;
      made.onmessage = ({ data }: MessageEvent<ScanReply>) => hear(request, data);
      made.onerror = event => fail(event.message);
      made.postMessage(compiled);
      begin("scanning", { begin: JSON.stringify(request), file });
    },
    stop() {
      if (doing?.work !== "scanning") return rest();
      drop();
      store.update({ scan: { made: null } });
    },
    show(shown) {
      rest();
      change(scan => ({ ...scan, shown, of: scan.clouds[shown] ? shown : scan.of }));
      if (!store.state.scan.made?.clouds[shown]) begin("taking", { cloud: shown });
    },
    text(form, then) {
      rest();
      written = { form, then };
      begin("writing", { text: form });
    },
  };
}
