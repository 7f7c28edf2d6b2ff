// A scan on a thread of its own. First comes the compiled module, then what is to be scanned; the scan stays here, and
// points and texts are asked for when somebody wants them.

import { initSync, Scan } from "@pkg/program/program.js";
import type { ScanText } from "../wire";

export type ScanAsk =
  | { begin: string; file: Uint8Array }
  | { cloud: "sent" | "surface" }
  | { text: ScanText; points: number };
export type ScanReply =
  | { share: number }
  | { view: string }
  | { problem: string }
  | { cloud: Float32Array<ArrayBuffer>; of: "sent" | "surface" }
  | { text: Blob; of: ScanText };

const PIECE = 200;    // points between two looks at the clock
const SLICE = 100;    // ms between two words about how far it is
const LINES = 50_000; // points a piece of text

const tell = (reply: ScanReply, transfer: Transferable[] = []): void => postMessage(reply, { transfer });
let scan: Scan | null = null;

function scanAll(begin: string, file: Uint8Array): void {
  scan = new Scan(begin, file);
  for (let over = false; !over;) {
    const until = performance.now() + SLICE;
    while (!over && performance.now() < until) over = scan.advance(PIECE);
    tell({ share: scan.share() });
  }
  tell({ view: scan.view() });
}

function write(form: ScanText, points: number): Blob {
  const parts: string[] = [];
  for (let from = 0; scan && from < points; from += LINES) parts.push(scan.text(form, from, from + LINES));
  return new Blob(parts, { type: "text/plain" });
}

function answer(ask: ScanAsk): void {
  if ("begin" in ask) scanAll(ask.begin, ask.file);
  else if ("cloud" in ask) {
    const cloud = (scan?.cloud(ask.cloud === "surface") ?? new Float32Array()) as Float32Array<ArrayBuffer>;
    tell({ cloud, of: ask.cloud }, [cloud.buffer]);
  } else tell({ text: write(ask.text, ask.points), of: ask.text });
}

addEventListener("message", ({ data }: MessageEvent<WebAssembly.Module | ScanAsk>) => {
  if (data instanceof WebAssembly.Module) {
    initSync({ module: data });
    return;
  }
  try {
    answer(data);
  } catch (problem) {
    tell({ problem: problem instanceof Error ? problem.message : String(problem) });
  }
});
