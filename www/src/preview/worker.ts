// A graphics device on a thread of its own: the page goes on while it draws. First comes the canvas, then scenes,
// clouds and pictures in the order in which they are asked for.
import type { Path } from "../core/levels";
import type { Cloud, GpuName } from "./backend";
import { available, openDevice, Unavailable } from "./device";
import { shown } from "./proof";
import type { Device, Handed, Seen, Told } from "./renderer";

export type Ask =
  | { open: GpuName; canvas: OffscreenCanvas }
  | { scene: Handed }
  | { cloud: Cloud | null }
  | { path: Path | null }
  | { seen: Seen }
  | { keep: Seen };
export type Reply =
  | { opened: true }
  | { refused: string; unavailable: boolean }
  | { kept: Blob }
  | { [K in keyof Told]: { tell: K; about: Parameters<Told[K]>[0] } }[keyof Told];

const post = (reply: Reply): void => postMessage(reply);
const told: Told = {
  lost: about => post({ tell: "lost", about }),
  again: () => post({ tell: "again", about: undefined }),
  thinned: about => post({ tell: "thinned", about }),
  trailed: about => post({ tell: "trailed", about }),
  effects: about => post({ tell: "effects", about }),
  drawn: () => post({ tell: "drawn", about: undefined }),
};
const reasonOf = (problem: unknown): string => (problem instanceof Error ? problem.message : String(problem));

let device: Device | null = null;

async function open(name: GpuName, canvas: OffscreenCanvas): Promise<void> {
  try {
    await available(name, () => new OffscreenCanvas(1, 1));
    device = await openDevice(name, canvas, told);
    post({ opened: true });
  } catch (problem) {
    post({ refused: reasonOf(problem), unavailable: problem instanceof Unavailable });
  }
}

/** What is drawn reaches the screen with the next frame of this thread. */
async function draw(to: Device, seen: Seen): Promise<void> {
  to.draw(seen);
  await shown();
  setTimeout(told.drawn);
}

addEventListener("message", ({ data }: MessageEvent<Ask[]>) => data.forEach(answer));

function answer(data: Ask): void {
  if ("open" in data) return void open(data.open, data.canvas);
  if (!device) return;
  try {
    if ("scene" in data) device.setScene(data.scene);
    else if ("cloud" in data) device.setCloud(data.cloud);
    else if ("path" in data) device.setPath(data.path);
    else if ("seen" in data) void draw(device, data.seen).catch(lost);
    else void device.picture(data.keep).then(kept => post({ kept }), lost);
  } catch (problem) {
    lost(problem);
  }
}

const lost = (problem: unknown): void => told.lost(reasonOf(problem));
