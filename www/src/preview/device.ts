// A graphics device and its canvas: takes what the renderer wants and draws it, on the page's own thread or on another.

import { dotSize, type GpuName } from "./backend";
import { createEffects } from "./effects";
import { createPoints } from "./points";
import { PROBE_SIZE, prove } from "./proof";
import type { Canvas, Device, Handed, Renderer, Seen, Told } from "./renderer";
import { createTrail } from "./trail";

interface Module {
  default(): Promise<unknown>;
  Renderer: { create(canvas: Canvas): Promise<Renderer> };
}

/** This browser, or this thread of it, has no such device. */
export class Unavailable extends Error {}

const LOST_EVENT = "probewright-preview-lost";
const DOT = 39; // place of the size of a point among the uniforms

const load: Record<GpuName, () => Promise<Module>> = {
  webgpu: () => import("@pkg/preview-webgpu/preview.js") as Promise<Module>,
  webgl2: () => import("@pkg/preview-webgl/preview.js") as Promise<Module>,
};

/** Cheap questions before anything is fetched. */
export async function available(name: GpuName, scratch: () => Canvas): Promise<void> {
  if (name === "webgl2") {
    if (!scratch().getContext("webgl2")) throw new Unavailable("no WebGL2 context");
    return;
  }
  const gpu = (navigator as { gpu?: { requestAdapter(): Promise<unknown> } }).gpu;
  if (!gpu) throw new Unavailable("no navigator.gpu");
  if (!(await gpu.requestAdapter())) throw new Unavailable("no WebGPU adapter");
}

/** Rejects with the reason when it cannot draw on this canvas. */
export async function openDevice(name: GpuName, canvas: Canvas, told: Told): Promise<Device> {
  const module = await load[name]();
  await module.default();
  canvas.width = canvas.height = PROBE_SIZE;
  const renderer = await module.Renderer.create(canvas);
  await prove(renderer, canvas);
  return device(canvas, renderer, told);
}

function device(canvas: Canvas, renderer: Renderer, told: Told): Device {
  const points = createPoints(renderer, told);
  const trail = createTrail(renderer, told);
  let last: Seen | null = null; // on the canvas, and so many points with it
  let count = 0;
  const effects = createEffects(renderer, told, () => {
    if (last) trail.follow(last, count);
  });
  let cloud = false;
  let shapes: Handed["solids"] = null;
  let size: readonly [number, number] = [0, 0];
  const stop = new AbortController();
  canvas.addEventListener("webglcontextlost", () => told.lost("WebGL context lost"), { signal: stop.signal });
  globalThis.addEventListener(LOST_EVENT, () => told.lost(), { signal: stop.signal });
  const paint = (seen: Seen, spans: (seen: Seen) => Uint32Array): void => {
    const { ratio, uniforms, all, cut, faded } = seen;
    const [width, height] = seen.size;
    trail.stop();
    if (size[0] !== width || size[1] !== height) {
      [canvas.width, canvas.height] = size = [width, height];
      renderer.resize(width, height);
    }
    last = seen;
    count = points.bring();
    uniforms[DOT] = dotSize(count) * ratio;
    renderer.set_light(all, cut);
    renderer.set_view(uniforms);
    renderer.render(count, faded, spans(seen));
  };
  return {
    setScene({ solids, lines, background, sky }) {
      trail.stop();
      shapes = solids ?? shapes;
      renderer.set_background(...background);
      if (shapes) renderer.set_scene(shapes.vertices, shapes.corners, shapes.ends, lines);
      if (sky) renderer.set_sky(sky.columns, sky.cells);
    },
    setCloud(next) {
      cloud = next !== null;
      points.set(next);
    },
    setPath: trail.set,
    draw(seen) {
      paint(seen, trail.moving);
      if (cloud) points.follow();
      else if (!effects.follow(seen.size[0] * seen.size[1])) trail.follow(seen, count);
    },
    async picture(seen) {
      paint(seen, trail.whole);
      return kept(canvas);
    },
    end() {
      stop.abort();
      points.end();
      trail.end();
      effects.end();
      renderer.free();
    },
  };
}

/** What is on it now; with the next frame it may be gone. */
function kept(canvas: Canvas): Promise<Blob> {
  if ("convertToBlob" in canvas) return canvas.convertToBlob();
  return new Promise((resolve, reject) =>
    canvas.toBlob(blob => (blob ? resolve(blob) : reject(new Error("no picture of the canvas")))),
  );
}
