// What a graphics device takes and tells, on whatever thread it is.
import type { Path } from "../core/levels";
import type { Cloud } from "./backend";

/** The exports of web/preview that are used here. */
export interface Renderer {
  set_scene(vertices: Float32Array, corners: Uint32Array, ends: Uint32Array, lines: Float32Array): void;
  set_sky(columns: number, cells: Float32Array): void;
  set_view(uniforms: Float32Array): void;
  set_light(all: boolean, cut: boolean): void;
  set_background(r: number, g: number, b: number): void;
  resize(width: number, height: number): void;
  clear_path(): void;
  add_path(vertices: Uint32Array, indices: Uint16Array): void;
  render(points: number, faded: number, spans: Uint32Array): void;
  begin(points: number, faded: number): void;
  go_on(spans: Uint32Array): void;
  finish(faded: number): void;
  reserve_cloud(points: number): void;
  add_points(points: Float32Array): void;
  watch(): void;
  is_drawn(): boolean;
  free(): void;
}
export type Canvas = HTMLCanvasElement | OffscreenCanvas;

/** A scene as the renderer wants it (web/preview/src/layout.rs). */
export interface Handed {
  solids: { vertices: Float32Array; corners: Uint32Array; ends: Uint32Array } | null; // none: those of before
  lines: Float32Array;
  background: readonly [r: number, g: number, b: number];
  sky: { columns: number; cells: Float32Array } | null; // none: that of before, or without what needs it
}

/** One picture of it. */
export interface Seen {
  size: readonly [width: number, height: number]; // device pixels
  ratio: number; // device pixels a CSS pixel
  uniforms: Float32Array; // but for the size of a point
  all: boolean; // with all effects
  cut: boolean;
  faded: number;
}

/** Whom a device tells. */
export interface Told {
  /** It is gone: with the reason when surely so, without when drawing again will tell. */
  lost(reason?: string): void;
  /** There is more to draw than in the last picture. */
  again(): void;
  /** So many points of the cloud are drawn. */
  thinned(drawn: number): void;
  /** So many motions of the whole path are there, those that are out of sight among them. */
  trailed(drawn: number): void;
  /** Whether it has the time for all effects. */
  effects(all: boolean): void;
  /** The last picture is on the screen, where it is not so at once. */
  drawn(): void;
}

export interface Device {
  setScene(scene: Handed): void;
  setCloud(cloud: Cloud | null): void;
  setPath(path: Path | null): void;
  /** Throws when it cannot draw any more. */
  draw(seen: Seen): void;
  /** One to keep. */
  picture(seen: Seen): Promise<Blob>;
  end(): void;
}
