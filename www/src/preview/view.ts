// The 3D view of a trace. Draws when something changed and never otherwise.
import type { Trace } from "../wire";
import type { Backend, BackendName, Cloud, Frame, Hooks } from "./backend";
import { type Camera, fit, initial, turn, type ViewName, type Viewport } from "./camera";
import { type Collision, collisionLabels } from "./collisions";
import { type Colours, LIGHT } from "./colours";
import { openGpu } from "./gpu";
import { listen } from "./input";
import { drawOverlay, overlay } from "./overlay";
import { blockOf, type FrameWords, probeAt, toolAt } from "./paths";
import { pick } from "./pick";
import { buildScene, type Scene, standing } from "./scene";
import { SORTED_PIECES } from "./solids";
import { openSvg } from "./svg";

export type { BackendName } from "./backend";
export type { ViewName } from "./camera";
export type { Collision } from "./collisions";
export { type Colours, coloursFrom, DARK, LIGHT } from "./colours";

export interface Options {
  label: string; // what a screen reader says
  colours?: Colours;
  collision?(found: Collision): string; // words beside what must not touch and did
  frame?: FrameWords; // words beside a coordinate system
  onBackend?(name: BackendName, refused: Refusal[]): void; // at the start, and again after a loss
  onThinned?(drawn: number): void; // so many points of the cloud are drawn
}
/** A way of drawing that this browser has not, and why. */
export interface Refusal {
  backend: BackendName;
  reason: string;
}

export interface Preview {
  readonly backend: BackendName;
  readonly refused: Refusal[];
  /** From where it is seen. */
  readonly camera: Camera;
  setTrace(trace: Trace, colours?: Colours): void;
  /** Entry `index` of the trace is done to `fraction` (0 … 1). */
  setStep(index: number, fraction: number): void;
  /** Scanned points, over whatever else is shown. */
  setCloud(cloud: Cloud | null): void;
  setView(name: ViewName): void;
  fit(): void;
  /** What a screen reader says. */
  setLabel(label: string): void;
  /** A click on a motion or touch. */
  onPick(callback: (entry: number) => void): void;
  setColours(colours: Colours): void;
  /** So many CSS pixels at the left are covered: what is fitted stands beside them where there is room. */
  setCovered(width: number): void;
  /** Diameters of a turned part as on a drawing. */
  setDrawing(shown: boolean): void;
  destroy(): void;
}

const EMPTY: Trace = { entries: [], ball: { radius: 3, length: 100 }, solids: [], frames: [] };
const WIDE = 1.5; // width of a view over its height from which on there is room at its side
const MOST_COVERED = 0.35; // of its width that is left free; what is broader covers the view anyway
const WAYS: BackendName[] = ["webgpu", "webgl2", "svg"];

export async function createPreview(host: HTMLElement, options: Options): Promise<Preview> {
  const stage = makeStage(host, options.label);
  const letters = overlay(stage);
  const refused: Refusal[] = [];
  let colours = options.colours ?? LIGHT;
  let drawing = false;
  let trace = EMPTY;
  let solids = trace.solids; // as they stand at this step
  let cloud: Cloud | null = null;
  let camera = initial();
  let size = sizeOf(stage); // kept: to ask for it while drawing would lay out the page once more
  let step = { index: 0, fraction: 0 };
  let untouched = true; // fitted again on a new size until somebody moved the camera
  let chosen: ViewName | null = "iso"; // until somebody moved the camera
  let asked = 0; // animation frame under way
  let ended = false;
  let picked: (entry: number) => void = () => undefined;
  const hooks: Hooks = {
    lost: reason => {
      if (reason) void replace(reason);
      else redraw();
    },
    again: () => redraw(),
    thinned(drawn) {
      stage.dataset["drawn"] = String(drawn);
      options.onThinned?.(drawn);
    },
  };
  let backend = await open(WAYS);
  const built = (): Scene => {
    const scene = buildScene(trace, colours, {
      solids,
      pieces: backend.name === "svg" ? SORTED_PIECES : 1,
      index: step.index,
      drawing,
      ...(options.frame && { words: options.frame }),
    });
    return { ...scene, labels: [...scene.labels, ...collisionLabels(trace, colours, options.collision ?? (() => ""))] };
  };
  let scene = built();

  async function open(ways: BackendName[]): Promise<Backend> {
    for (const name of ways) {
      if (name === "svg") break;
      try {
        return await openGpu(name, stage, hooks);
      } catch (reason) {
        refused.push({ backend: name, reason: reason instanceof Error ? reason.message : String(reason) });
      }
    }
    return openSvg(stage, hooks);
  }

  /** The device is gone: go on with the next way of drawing. */
  let replacing = false;
  async function replace(reason: unknown): Promise<void> {
    if (replacing || ended || backend.name === "svg") return;
    replacing = true;
    const gone = backend;
    refused.push({ backend: gone.name, reason: String(reason) });
    const next = await open(WAYS.slice(WAYS.indexOf(gone.name) + 1));
    try {
      gone.destroy();
    } catch {
      gone.element.remove();
    }
    backend = next;
    replacing = false;
    if (ended) return backend.destroy();
    scene = built();
    adopt();
  }

  function adopt(): void {
    Object.assign(backend.element.style, {
      position: "absolute",
      inset: "0",
      width: "100%",
      height: "100%",
      display: "block",
    });
    backend.setScene(scene, devicePixelRatio);
    backend.setCloud(cloud);
    stage.dataset["backend"] = backend.name;
    options.onBackend?.(backend.name, refused);
    redraw();
  }

  const viewport = (): Viewport => size;
  const redraw = () => {
    if (!asked && !ended) asked = requestAnimationFrame(draw);
  };
  /** What the page shows changes within its own frame: the view with it, once everything of it is told. */
  let telling = false;
  const redrawNow = () => {
    if (telling) return;
    telling = true;
    queueMicrotask(() => {
      telling = false;
      if (!ended) draw();
    });
  };

  function draw(): void {
    cancelAnimationFrame(asked);
    asked = 0;
    const probe = probeAt(trace, step.index, step.fraction);
    const frame: Frame = { camera, view: viewport(), ratio: devicePixelRatio, time: step.index + step.fraction, probe };
    try {
      backend.draw(frame);
      drawOverlay(letters, scene, frame);
    } catch (reason) {
      void replace(reason);
    }
  }

  function rebuild(): void {
    solids = standing(trace, step.index);
    scene = built();
    backend.setScene(scene, devicePixelRatio);
    redrawNow();
  }
  let covered = 0;
  const beside = () => (size.width > WIDE * size.height && covered < MOST_COVERED * size.width ? covered : 0);
  const refit = () => {
    camera = fit(camera, viewport(), scene.box, beside());
    redraw();
  };
  const move = (next: typeof camera) => {
    camera = next;
    untouched = false;
    chosen = null;
    redraw();
  };
  const look = () => {
    if (chosen) camera = turn(camera, chosen, toolAt(trace, step.index)?.ball);
  };
  const setView = (name: ViewName) => {
    chosen = name;
    untouched = true;
    look();
    refit();
  };
  const fitAgain = () => {
    untouched = true;
    refit();
  };

  const silence = listen(stage, {
    camera: () => camera,
    view: viewport,
    move,
    setView,
    fit: fitAgain,
    pick(x, y) {
      const entry = pick(scene.lines, camera, viewport(), x, y);
      if (entry !== null) picked(entry);
    },
  });
  const sizes = new ResizeObserver(() => {
    size = sizeOf(stage);
    if (untouched) refit();
    else redraw();
  });
  sizes.observe(stage);
  adopt();

  return {
    get backend() {
      return backend.name;
    },
    get refused() {
      return [...refused];
    },
    get camera() {
      return camera;
    },
    setTrace(next, palette) {
      const first = trace === EMPTY;
      trace = next;
      const other = camera.turning !== (next.turning ?? false);
      camera = { ...camera, turning: next.turning ?? false };
      colours = palette ?? colours;
      step = { index: Math.max(0, next.entries.length - 1), fraction: 1 };
      look();
      rebuild();
      if (first || untouched || other) refit();
    },
    setStep(index, fraction) {
      const same =
        blockOf(index) === blockOf(step.index) &&
        standing(trace, index) === solids &&
        toolAt(trace, index) === scene.tool;
      step = { index, fraction };
      if (same) redrawNow();
      else rebuild();
    },
    setCloud(next) {
      if (next === cloud) return;
      cloud = next;
      delete stage.dataset["drawn"];
      backend.setCloud(cloud);
      redrawNow();
    },
    setView,
    fit: fitAgain,
    setCovered(width) {
      if (width === covered) return;
      covered = width;
      if (untouched) refit();
    },
    setLabel(label) {
      stage.setAttribute("aria-label", label);
    },
    onPick(callback) {
      picked = callback;
    },
    setColours(palette) {
      colours = palette;
      rebuild();
    },
    setDrawing(shown) {
      if (shown === drawing) return;
      drawing = shown;
      rebuild();
      if (untouched) refit();
    },
    destroy() {
      ended = true;
      cancelAnimationFrame(asked);
      sizes.disconnect();
      silence();
      backend.destroy();
      stage.remove();
    },
  };
}

function sizeOf(stage: HTMLElement): Viewport {
  return { width: Math.max(1, stage.clientWidth), height: Math.max(1, stage.clientHeight) };
}

function makeStage(host: HTMLElement, label: string): HTMLElement {
  const stage = document.createElement("div");
  stage.tabIndex = 0;
  stage.setAttribute("role", "application");
  stage.setAttribute("aria-label", label);
  Object.assign(stage.style, {
    position: "relative",
    width: "100%",
    height: "100%",
    overflow: "hidden",
    userSelect: "none",
  });
  host.append(stage);
  return stage;
}
