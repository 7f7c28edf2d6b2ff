// What every way of drawing can do.
import type { Vec3 } from "../wire";
import type { Camera, Viewport } from "./camera";
import type { Scene } from "./scene";

export type GpuName = "webgpu" | "webgl2";
export type BackendName = GpuName | "svg";

/** One picture. `time`: entries of the trace done; the fraction is that of the current one. */
export interface Frame {
  camera: Camera;
  view: Viewport;
  ratio: number; // device pixels a CSS pixel
  time: number;
  probe: Vec3 | null; // centre of the ball
}

/**
 * Scanned points: four numbers each, X Y Z from the origin and the deviation, mm; the first ones are spread evenly over
 * all. `full`: deviation of full colour, mm.
 */
export interface Cloud {
  points: Float32Array;
  origin: Vec3;
  full: number;
}

const MANY = 20_000; // points that cover the surface anyway

/** Size of a scanned point where so many are drawn, CSS pixels. */
export function dotSize(drawn: number): number {
  return drawn > MANY ? 2.4 : 5;
}

/** What a way of drawing tells whoever shows it. */
export interface Hooks {
  /** The device is gone: with the reason when surely so, without when drawing again will tell. */
  lost(reason?: string): void;
  /** There is more to draw than in the last frame. */
  again(): void;
  /** So many points of the cloud are drawn. */
  thinned(drawn: number): void;
  /** So many motions of the whole path are drawn. */
  trailed(drawn: number): void;
  /** A picture that was under way is on the screen. */
  drawn(): void;
}

export interface Backend {
  name: BackendName;
  element: HTMLElement | SVGElement;
  /** A picture is under way: another one would only wait. */
  readonly busy: boolean;
  setScene(scene: Scene, ratio: number): void;
  setCloud(cloud: Cloud | null): void;
  /** Throws when it cannot draw any more. */
  draw(frame: Frame): void;
  /** One to keep, of the scene that was set last; none where what is drawn keeps anyway. */
  picture?(frame: Frame): Promise<Blob>;
  destroy(): void;
}

/** Opacity of motions that are still to come. */
export const COMING = 0.28;
