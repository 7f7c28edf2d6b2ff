// WebGPU and WebGL2: the same drawing code in two builds, of which the browser loads the one that it can run. It draws
// on a thread of its own, on that of the page only where the browser cannot do so elsewhere.

import type { Path } from "../core/levels";
import type { Vec3 } from "../wire";
import type { Backend, Cloud, Frame, GpuName, Hooks } from "./backend";
import { COMING } from "./backend";
import { basis, type Camera, eye, matrix } from "./camera";
import { parse } from "./colours";
import { available, openDevice, Unavailable } from "./device";
import { fadedFor } from "./fade";
import { type Ground, stands } from "./ground";
import { trailColours } from "./ink";
import { packLines, packVertices } from "./mesh";
import { openRemote } from "./remote";
import type { Device, Handed, Seen, Told } from "./renderer";
import type { Scene } from "./scene";
import { sectionOf } from "./section";
import { dot, length, sub } from "./vec";

const DEPTH_BIAS = 0.0015;

/** Rejects with the reason when this browser cannot draw this way. */
export async function openGpu(name: GpuName, host: HTMLElement, hooks: Hooks): Promise<Backend> {
  await available(name, () => document.createElement("canvas"));
  try {
    return await opened(name, host, hooks, openRemote);
  } catch (reason) {
    if (!(reason instanceof Unavailable)) throw reason;
    return opened(name, host, hooks, openDevice);
  }
}

type Open = (name: GpuName, canvas: HTMLCanvasElement, told: Told) => Promise<Device>;

async function opened(name: GpuName, host: HTMLElement, hooks: Hooks, open: Open): Promise<Backend> {
  const canvas = document.createElement("canvas");
  host.prepend(canvas);
  const state = { all: true, under: 0 };
  const told: Told = {
    ...hooks,
    effects(all) {
      state.all = all;
    },
    drawn() {
      state.under = Math.max(0, state.under - 1);
      hooks.drawn();
    },
  };
  try {
    const device = await open(name, canvas, told);
    return backend(name, canvas, device, state, open === openRemote);
  } catch (reason) {
    canvas.remove();
    throw reason;
  }
}

/** `all`: it has the time for all effects; `under`: pictures under way. */
interface Doing {
  all: boolean;
  under: number;
}

function backend(name: GpuName, canvas: HTMLCanvasElement, device: Device, doing: Doing, remote: boolean): Backend {
  let scene: Scene | null = null; // that the device has
  let cloud: Cloud | null = null;
  let full = true; // what the device has is for all effects
  let ground: Ground | null = null; // whose map the device has
  let path: Path | null = null; // that the device has
  const hand = (next: Scene, ratio: number, all: boolean): void => {
    full = all;
    const known = scene?.mesh === next.mesh && length(sub(scene.origin, next.origin)) === 0;
    scene = next;
    device.setScene(handed(next, ratio, { full, known, mapped: ground === next.ground }));
    if (full) ground = next.ground;
  };
  return {
    name,
    element: canvas,
    get busy() {
      return doing.under > 0;
    },
    setScene(next, ratio) {
      hand(next, ratio, doing.all);
      if (next.data.path !== path) device.setPath(next.data.path);
      path = next.data.path;
    },
    setCloud(next) {
      cloud = next;
      device.setCloud(next);
    },
    draw(frame) {
      if (!scene) return;
      if (full !== doing.all) hand(scene, frame.ratio, doing.all);
      if (remote) doing.under += 1;
      device.draw(seen(scene, frame, cloud, full));
    },
    async picture(frame) {
      if (!scene) throw new Error("nothing to draw");
      if (!full) hand(scene, frame.ratio, true);
      return device.picture(seen(scene, frame, cloud, true)); // nobody waits for a frame: with all effects
    },
    destroy() {
      canvas.remove();
      device.end();
    },
  };
}

/** `full`: for all effects; `known`: it has these solids; `mapped`: and the map of their ground. */
interface Had {
  full: boolean;
  known: boolean;
  mapped: boolean;
}

/** What a device needs of a scene. */
function handed(scene: Scene, ratio: number, { full, known, mapped }: Had): Handed {
  const { mesh, origin, ends, lines, ground, colours } = scene;
  const [r, g, b] = parse(colours.background);
  return {
    solids: known
      ? null
      : { vertices: packVertices(mesh, origin), corners: mesh.corners, ends: Uint32Array.from(ends) },
    lines: packLines(full ? lines.filter(({ style }) => !style.onGround) : lines, origin, ratio),
    background: [r, g, b],
    sky: full && !mapped ? { columns: ground.columns, cells: ground.cells() } : null,
  };
}

function seen(scene: Scene, frame: Frame, cloud: Cloud | null, full: boolean): Seen {
  const side = (length: number): number => Math.max(1, Math.round(length * frame.ratio));
  const size = [side(frame.view.width), side(frame.view.height)] as const;
  return {
    size,
    ratio: frame.ratio,
    uniforms: uniforms(scene, frame, size, cloud, full),
    all: full,
    cut: scene.section,
    faded: fadedFor(scene, frame),
  };
}

/** The uniform block of web/preview/src/layout.rs. */
function uniforms(
  scene: Scene,
  frame: Frame,
  [width, height]: readonly [number, number],
  cloud: Cloud | null,
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
    0, // size of a point: as many are drawn as the device bears
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
    ...(scene.data.path ? sub(scene.data.path.origin, scene.origin) : [0, 0, 0]),
    0,
    ...trailColours(colours).flat(),
    ...parse(colours.background),
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
