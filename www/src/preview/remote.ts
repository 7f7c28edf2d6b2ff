// A graphics device on another thread, as if it was on this one.
import type { GpuName } from "./backend";
import { Unavailable } from "./device";
import type { Device, Told } from "./renderer";
import type { Ask, Reply } from "./worker";

/** Rejects with the reason when it cannot draw on this canvas, with `Unavailable` when no other thread can. */
export async function openRemote(name: GpuName, canvas: HTMLCanvasElement, told: Told): Promise<Device> {
  const offscreen = canvas.transferControlToOffscreen();
  const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
  let keep = (_: Blob): void => undefined; // whoever waits for a picture
  let fail = (_: Error): void => undefined;
  let asked: Ask[] = [];
  let handed: Transferable[] = [];
  const later = (one: Ask, transfer: Transferable[] = []): void => {
    asked.push(one);
    handed.push(...transfer);
  };
  /** With all that was left for later: each message wakes the other thread, which takes the time of this one. */
  const ask = (one: Ask, transfer: Transferable[] = []): void => {
    later(one, transfer);
    worker.postMessage(asked, handed);
    [asked, handed] = [[], []];
  };
  try {
    await new Promise<void>((resolve, reject) => {
      const hear = (reply: Reply): void => {
        if ("opened" in reply) resolve();
        else if ("kept" in reply) keep(reply.kept);
        else if ("tell" in reply) (told[reply.tell] as (about: unknown) => void)(reply.about);
        else reject(reply.unavailable ? new Unavailable(reply.refused) : new Error(reply.refused));
      };
      worker.onmessage = ({ data }: MessageEvent<Reply>) => hear(data);
      worker.onerror = ({ message }) => reject(new Unavailable(message));
      ask({ open: name, canvas: offscreen }, [offscreen]);
    });
  } catch (reason) {
    worker.terminate();
    throw reason;
  }
  worker.onerror = ({ message }) => told.lost(message);
  return {
    setScene: scene => later({ scene }, [scene.lines.buffer, ...(scene.solids ? [scene.solids.vertices.buffer] : [])]),
    setCloud: cloud => later({ cloud }),
    setPath: path => later({ path }),
    draw: seen => ask({ seen }, [seen.uniforms.buffer]),
    picture: seen =>
      new Promise((resolve, reject) => {
        [keep, fail] = [resolve, reject];
        ask({ keep: seen }, [seen.uniforms.buffer]);
      }),
    end() {
      worker.terminate();
      fail(new Error("the device is gone"));
    },
  };
}
