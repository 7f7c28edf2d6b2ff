// A device alone proves nothing, its canvas may stay blank: a picture is drawn and its pixels are looked at first.
// Left half a lit quadrilateral facing the viewer, right half background, a thick line across the top.
import type { Canvas, Renderer } from "./renderer";

export const PROBE_SIZE = 64;
const NOTHING_MORE = new Array<number>(68).fill(0);
const TRIES = 3; // pictures until a device counts as blank

/** Rejects with the pixels that are wrong. */
export async function prove(renderer: Renderer, canvas: Canvas): Promise<void> {
  const face = (x: number, y: number) => [x, y, 0, 0, 0, 1, 0.1, 0.8, 0.2, 1, 0, 0];
  const vertices = Float32Array.from([...face(-1, -1), ...face(0, -1), ...face(0, 1), ...face(-1, 1)]);
  const line = Float32Array.from([-1, 0.75, 0.5, 1, 0.75, 0.5, 1, 0.5, 0, 1, 10, 0, -1, 0, 0, 1]);
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -0.5, 0, 0, 0, 0.5, 1];
  const axes = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1000]; // and the eye
  renderer.set_scene(vertices, Uint32Array.of(0, 1, 2, 0, 2, 3), Uint32Array.of(6, 6, 6), line);
  renderer.set_view(
    Float32Array.from([...identity, ...axes, PROBE_SIZE, PROBE_SIZE, 0, 1, 0, 0, 0, 0, ...NOTHING_MORE]),
  );
  renderer.set_background(0.2, 0.2, 0.6);
  // A device that is busy may be a frame late; one that draws nothing never does.
  for (let left = TRIES; ; left--) {
    try {
      renderer.render(0, 0, new Uint32Array());
      look(canvas);
      await shown();
      renderer.render(0, 0, new Uint32Array());
      return look(canvas);
    } catch (reason) {
      if (left === 1) throw reason;
      await shown();
    }
  }
}

/** In the next frame. */
export const shown = () =>
  new Promise<void>(resolve => {
    requestAnimationFrame(() => resolve());
    setTimeout(resolve, 100); // a page in the background gets no animation frames
  });

function look(canvas: Canvas): void {
  const context = new OffscreenCanvas(PROBE_SIZE, PROBE_SIZE).getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("no 2D context to read pixels with");
  context.drawImage(canvas, 0, 0);
  const at = (x: number, y: number) => [...context.getImageData(x, y, 1, 1).data] as [number, number, number, number];
  const [part, behind, line] = [at(16, 40), at(48, 40), at(48, 8)];
  const green = part[1] > 120 && part[0] < 90 && part[2] < 120;
  const blue = Math.abs(behind[2] - 153) < 6 && Math.abs(behind[0] - 51) < 6;
  const orange = line[0] > 240 && Math.abs(line[1] - 128) < 8 && line[2] < 12;
  if (!green || !blue || !orange) throw new Error(`wrong pixels: ${part} | ${behind} | ${line}`);
}
