// A scan on a thread of its own. First comes the compiled module, then what is to be scanned; the scan stays here, and
// points and texts are asked for when somebody wants them. Only what was asked last is gone on with.

import { initSync, Scan } from "@pkg/core/core.js";
import { buffersOf, type SceneData, takeScene } from "../core/scene";
import type { Shown } from "../state/scanned";
import type { ScanText } from "../wire";

export type ScanAsk = { begin: string; file: Uint8Array } | { cloud: Shown } | { text: ScanText } | "nothing";
export type ScanReply =
  | { share: number }
  | { view: string; scene: SceneData }
  | { problem: string }
  | { cloud: Float32Array<ArrayBuffer>; of: Shown }
  | { text: Blob; of: ScanText };

const PIECE = 200; // points that are scanned between two looks at the clock
const POINTS = 5000; // points of a piece of what is made of them
const SLICE = 100; // ms between two words about how far it is
const NUMBERS = 4; // a point

const tell = (reply: ScanReply, transfer: Transferable[] = []): void => postMessage(reply, { transfer });
let scan: Scan | null = null;
let turns: Uint32Array = new Uint32Array(); // of each point, when they are drawn
let newest = 0; // number of what was asked last

function scanAll(begin: string, file: Uint8Array): void {
  const made = new Scan(begin, file);
  scan = made;
  for (let over = false; !over; ) {
    const until = performance.now() + SLICE;
    while (!over && performance.now() < until) over = made.advance(PIECE);
    tell({ share: made.share() });
  }
  turns = made.turns();
  const scene = takeScene(made.scene());
  tell({ view: made.view(), scene }, buffersOf(scene));
}

/** Goes through all points, and lets messages in meanwhile; false: something else was asked. */
async function inPieces(asked: number, piece: (scan: Scan, from: number, to: number) => void): Promise<boolean> {
  let until = performance.now() + SLICE;
  for (let from = 0; scan && from < turns.length; from += POINTS) {
    piece(scan, from, Math.min(from + POINTS, turns.length));
    if (performance.now() < until) continue;
    tell({ share: from / turns.length });
    await new Promise(resolve => setTimeout(resolve));
    if (asked !== newest) return false;
    until = performance.now() + SLICE;
  }
  return true;
}

async function cloud(asked: number, of: Shown): Promise<void> {
  const numbers = new Float32Array(NUMBERS * turns.length);
  const done = await inPieces(asked, (scan, from, to) => {
    const piece = scan.cloud(of === "surface", from, to);
    for (const [i, turn] of turns.subarray(from, to).entries())
      numbers.set(piece.subarray(NUMBERS * i, NUMBERS * (i + 1)), NUMBERS * turn);
  });
  if (done) tell({ cloud: numbers, of }, [numbers.buffer]);
}

async function write(asked: number, form: ScanText): Promise<void> {
  const parts: string[] = [];
  const done = await inPieces(asked, (scan, from, to) => parts.push(scan.text(form, from, to)));
  if (done) tell({ text: new Blob(parts, { type: "text/plain" }), of: form });
}

async function answer(ask: ScanAsk): Promise<void> {
  const asked = ++newest;
  if (ask === "nothing") return;
  if ("begin" in ask) scanAll(ask.begin, ask.file);
  else if ("cloud" in ask) await cloud(asked, ask.cloud);
  else await write(asked, ask.text);
}

addEventListener("message", ({ data }: MessageEvent<WebAssembly.Module | ScanAsk>) => {
  if (data instanceof WebAssembly.Module) {
    initSync({ module: data });
    return;
  }
  answer(data).catch((problem: unknown) =>
    tell({ problem: problem instanceof Error ? problem.message : String(problem) }),
  );
});
