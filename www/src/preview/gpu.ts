// WebGPU and WebGL2: the same drawing code in two builds, of which the browser loads the one that it can run.
// An adapter alone proves nothing, the canvas may stay blank: a picture is drawn and its pixels are looked at first.

import type { Vec3 } from "../wire";
import type { Backend, BackendName, Cloud, Frame, Hooks } from "./backend";
import { COMING, dotSize } from "./backend";
import { basis, type Camera, eye, matrix } from "./camera";
import { parse } from "./colours";
import { createEffects } from "./effects";
import { fadedFor } from "./fade";
import { stands } from "./ground";
import { packLines, packVertices } from "./mesh";
import { createPoints, type PointRenderer } from "./points";
import type { Scene } from "./scene";
import { sectionOf } from "./section";
import { dot, length, sub } from "./vec";

/** The exports of web/preview that are used here. */
interface Renderer extends PointRenderer {
  set_scene(vertices: Float32Array, corners: Uint32Array, ends: Uint32Array, lines: Float32Array): void;
  set_sky(columns: number, cells: Float32Array): void;
  set_view(uniforms: Float32Array): void;
  set_light(all: boolean, cut: boolean): void;
  set_background(r: number, g: number, b: number): void;
  resize(width: number, height: number): void;
  render(points: number, faded: number): void;
  free(): void;
}
interface Module {
  default(): Promise<unknown>;
  Renderer: { create(canvas: HTMLCanvasElement): Promise<Renderer> };
}

const LOST_EVENT = "probewright-preview-lost";
const PROBE_SIZE = 64;
const DEPTH_BIAS = 0.0015;
const NOTHING_MORE = new Array<number>(44).fill(0);

const load: Record<"webgpu" | "webgl2", () => Promise<Module>> = {
  webgpu: () => import("@pkg/preview-webgpu/preview.js") as Promise<Module>,
  webgl2: () => import("@pkg/preview-webgl/preview.js") as Promise<Module>,
};

/** Rejects with the reason when this browser cannot draw this way. */
export async function openGpu(name: "webgpu" | "webgl2", host: HTMLElement, hooks: Hooks): Promise<Backend> {
  await available(name);
  const module = await load[name]();
  await module.default();
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = PROBE_SIZE;
  host.prepend(canvas);
  try {
    const renderer = await module.Renderer.create(canvas);
    await prove(renderer, canvas);
    return backend(name, canvas, renderer, hooks);
  } catch (reason) {
    canvas.remove();
    throw reason;
  }
}

/** Cheap questions before anything is fetched. */
async function available(name: BackendName): Promise<void> {
  if (name === "webgl2") {
    if (!document.createElement("canvas").getContext("webgl2")) throw new Error("no WebGL2 context");
    return;
  }
  const gpu = (navigator as { gpu?: { requestAdapter(): Promise<unknown> } }).gpu;
  if (!gpu) throw new Error("no navigator.gpu");
  if (!(await gpu.requestAdapter())) throw new Error("no WebGPU adapter");
}

// The probe picture: left half a lit quadrilateral facing the viewer, right half background, a thick line across the
// top.

const TRIES = 3; // pictures of the probe until a device counts as blank

async function prove(renderer: Renderer, canvas: HTMLCanvasElement): Promise<void> {
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
      renderer.render(0, 0);
      look(canvas);
      await shown();
      renderer.render(0, 0);
      return look(canvas);
    } catch (reason) {
      if (left === 1) throw reason;
      await shown();
    }
  }
}

const shown = () =>
  new Promise<void>(resolve => {
    requestAnimationFrame(() => resolve());
    setTimeout(resolve, 100); // a page in the background gets no animation frames
  });

function look(canvas: HTMLCanvasElement): void {
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

function backend(name: "webgpu" | "webgl2", canvas: HTMLCanvasElement, renderer: Renderer, hooks: Hooks): Backend {
  let scene: Scene | null = null;
  const points = createPoints(renderer, hooks);
  let size: [number, number] = [0, 0];
  const effects = createEffects(renderer, hooks);
  let full = true; // what the device has is for all effects
  /** Gives the device what it needs of a scene. */
  const hand = (next: Scene, ratio: number): void => {
    full = effects.all;
    const lines = full ? next.lines.filter(({ style }) => !style.onGround) : next.lines;
    renderer.set_scene(
      packVertices(next.mesh, next.origin),
      next.mesh.corners,
      Uint32Array.from(next.ends),
      packLines(lines, next.origin, ratio),
    );
    if (full) renderer.set_sky(next.ground.columns, next.ground.cells());
  };
  const stop = new AbortController();
  canvas.addEventListener("webglcontextlost", () => hooks.lost("WebGL context lost"), { signal: stop.signal });
  window.addEventListener(LOST_EVENT, () => hooks.lost(), { signal: stop.signal });
  return {
    name,
    element: canvas,
    setScene(next, ratio) {
      scene = next;
      const [r, g, b] = parse(next.colours.background);
      renderer.set_background(r, g, b);
      hand(next, ratio);
    },
    setCloud: cloud => points.set(cloud),
    draw(frame) {
      if (!scene) return;
      const [width, height] = [frame.view.width, frame.view.height].map(side =>
        Math.max(1, Math.round(side * frame.ratio)),
      ) as [number, number];
      if (size[0] !== width || size[1] !== height) {
        [canvas.width, canvas.height] = size = [width, height];
        renderer.resize(width, height);
      }
      if (full !== effects.all) hand(scene, frame.ratio);
      const count = points.bring();
      renderer.set_light(full, scene.section);
      renderer.set_view(uniforms(scene, frame, [width, height], points.cloud, count, full));
      renderer.render(count, fadedFor(scene, frame));
      if (points.cloud) points.follow();
      else effects.follow(width * height);
    },
    destroy() {
      stop.abort();
      points.end();
      effects.end();
      canvas.remove();
      renderer.free();
    },
  };
}

/** The uniform block of web/preview/src/layout.rs. */
function uniforms(
  scene: Scene,
  frame: Frame,
  [width, height]: [number, number],
  cloud: Cloud | null,
  count: number,
  full: boolean,
): Float32Array {
  const camera = { ...frame.camera, target: sub(frame.camera.target, scene.origin) };
  const { right, up, back } = basis(camera);
  const reach = scene.radius + Math.abs(dot(camera.target, back)) + length(camera.target);
  const from = eye(camera, frame.view, reach);
  const { colours } = scene;
  const probe = frame.probe ? sub(frame.probe, scene.origin) : [0, 0, 0];
  return Float32Array.from([
    ...matrix(camera, frame.view, reach),
    ...right,
    from[0],
    ...up,
    from[1],
    ...back,
    from[2],
    width,
    height,
    frame.time,
    COMING,
    ...probe,
    DEPTH_BIAS,
    ...(cloud ? sub(cloud.origin, scene.origin) : [0, 0, 0]),
    dotSize(count) * frame.ratio,
    ...parse(colours.outside),
    ...parse(colours.level),
    ...parse(colours.inside),
    cloud?.full ?? 1,
    scene.radius,
    0,
    0,
    ...onGround(scene, back, full),
    ...parse(colours.grid),
    ...beyond(scene, frame.camera),
    ...parse(colours.cut),
  ]);
}

/** Twelve numbers: where the map over the ground lies, the ground, and its grid; from below there is no ground. */
function onGround({ ground, origin }: Scene, back: Vec3, full: boolean): number[] {
  const { turning, middle, size, height, spacing, radius, reaches } = ground;
  const [u, v, up] = stands(origin, turning);
  const low = [middle[0] - size / 2 - u, middle[1] - size / 2 - v];
  const phase = [u, v].map(at => -(at - Math.floor(at / spacing) * spacing));
  const seen = full && stands(back, turning)[2] > 0.02;
  return [
    ...[...low, 1 / size, 1 / size],
    ...[height - up, spacing, seen ? radius : 0, turning ? 1 : 0],
    ...[...phase, 1 / reaches[0], 1 / reaches[1]],
  ];
}

/** Four numbers: the plane beyond which the part is cut away. */
function beyond(scene: Scene, camera: Camera): number[] {
  const plane = sectionOf(scene, camera);
  return plane ? [...plane.normal, plane.distance - dot(plane.normal, scene.origin)] : [0, 0, 0, 1];
}
