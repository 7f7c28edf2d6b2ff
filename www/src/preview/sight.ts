// From where the scene is seen: what the user chose and moved, fitted again for as long as nobody moved it.
import type { Vec3 } from "../wire";
import { between, type Camera, fit, initial, turn, type ViewName, type Viewport } from "./camera";
import type { Box } from "./vec";

export interface Sight {
  readonly camera: Camera;
  readonly view: Viewport;
  move(camera: Camera): void;
  setView(name: ViewName): void;
  /** In parallel or in central projection. */
  project(central: boolean): void;
  fit(): void;
  /** Whether it is on its way to another view. */
  readonly turning: boolean;
  end(): void;
  resize(view: Viewport): void;
  /** So many CSS pixels at the left are covered. */
  cover(width: number): void;
  /** Another thing is looked at, on a turning machine or not; `first`: nothing was before. */
  turnTo(turning: boolean, first: boolean): void;
  /** What is looked at became larger or smaller. */
  refit(): void;
}

/** What is looked at, asked for when it matters. */
export interface Seen {
  box(): Box;
  held(): Vec3 | undefined; // direction from the ball to what holds it
  changed(): void; // it is seen from elsewhere now
}

const EASE = 240; // ms
const still = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;
const eased = (part: number): number => part * part * (3 - 2 * part);

const WIDE = 1.5; // width of a view over its height from which on there is room at its side
const MOST_COVERED = 0.35; // of its width that is left free; what is broader covers the view anyway

export function createSight(view: Viewport, seen: Seen): Sight {
  let camera = initial();
  let covered = 0;
  let untouched = true; // fitted again on a new size until somebody moved the camera
  let chosen: ViewName | null = "iso"; // until somebody moved the camera

  const beside = (): number => (view.width > WIDE * view.height && covered < MOST_COVERED * view.width ? covered : 0);
  let easing = 0;
  const stop = (): void => {
    cancelAnimationFrame(easing);
    easing = 0;
  };
  const fitted = (): void => {
    stop();
    camera = fit(camera, view, seen.box(), beside());
    seen.changed();
  };
  /** To where a change leads, not at once. */
  const ease = (change: () => void): void => {
    const from = camera;
    change();
    if (still()) return;
    const to = camera;
    const begun = performance.now();
    const step = (now: number): void => {
      const part = Math.min(1, Math.max(0, (now - begun) / EASE));
      camera = part < 1 ? between(from, to, eased(part)) : to;
      easing = part < 1 ? requestAnimationFrame(step) : 0;
      seen.changed();
    };
    camera = from;
    easing = requestAnimationFrame(step);
  };
  const look = (): void => {
    if (chosen) camera = turn(camera, chosen, seen.held());
  };
  return {
    get camera() {
      return camera;
    },
    get view() {
      return view;
    },
    get turning() {
      return easing !== 0;
    },
    end: stop,
    move(next) {
      stop();
      camera = next;
      untouched = false;
      chosen = null;
      seen.changed();
    },
    setView(name) {
      chosen = name;
      untouched = true;
      ease(() => {
        look();
        fitted();
      });
    },
    project(central) {
      if (central === !!camera.central) return;
      camera = { ...camera, central };
      fitted();
    },
    fit() {
      untouched = true;
      ease(fitted);
    },
    resize(next) {
      view = next;
      if (untouched) fitted();
      else seen.changed();
    },
    cover(width) {
      if (width === covered) return;
      covered = width;
      if (untouched) fitted();
    },
    turnTo(turning, first) {
      const other = camera.turning !== turning;
      camera = { ...camera, turning };
      look();
      if (first || untouched || other) fitted();
    },
    refit() {
      if (untouched) fitted();
    },
  };
}
