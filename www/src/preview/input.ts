// Mouse, touch, pen and keys: orbit, pan, zoom, standard views, fit, pick.
import { type Command, meantBy } from "../keys";
import { type Camera, orbit, pan, type ViewName, type Viewport, zoom } from "./camera";

/** What is dragged. */
export interface Held {
  move(x: number, y: number): void;
  drop(): void;
}

/** What the input works on. */
export interface Handle {
  camera(): Camera;
  view(): Viewport;
  move(camera: Camera): void;
  setView(name: ViewName): void;
  fit(): void;
  pick(x: number, y: number): void;
  /** Takes hold of what is there: a drag then moves it and not the view; null: nothing is. */
  grab(x: number, y: number): Held | null;
  /** A pointer is there, and nothing is dragged. */
  point(x: number, y: number): void;
  leave(): void;
}

const TURN = 0.008; // radians a CSS pixel
const KEY_TURN = Math.PI / 24;
const KEY_PAN = 24; // CSS pixels
const KEY_ZOOM = 1.2;
const CLICK = 5; // CSS pixels that a click may wander

/** Listens until the returned function is called. */
export function listen(element: HTMLElement, handle: Handle): () => void {
  const stop = new AbortController();
  const options = { signal: stop.signal };
  const pointers = new Map<number, { x: number; y: number }>();
  let wandered = 0;
  let held: Held | null = null;
  element.style.touchAction = "none";
  element.addEventListener(
    "pointerdown",
    event => {
      element.setPointerCapture(event.pointerId);
      const at = place(element, event);
      if (pointers.size === 0) wandered = 0;
      held = pointers.size === 0 && event.button === 0 ? handle.grab(at.x, at.y) : null;
      pointers.set(event.pointerId, at);
    },
    options,
  );
  element.addEventListener(
    "pointermove",
    event => {
      const before = pointers.get(event.pointerId);
      if (!before) {
        const { x, y } = place(element, event);
        if (event.pointerType !== "touch") handle.point(x, y);
        return;
      }
      const now = place(element, event);
      wandered += Math.hypot(now.x - before.x, now.y - before.y);
      const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
      if (held) held.move(now.x, now.y);
      else handle.move(other ? pinched(handle, before, now, other) : dragged(handle.camera(), event, before, now));
      pointers.set(event.pointerId, now);
    },
    options,
  );
  const up = (event: PointerEvent) => {
    if (event.type === "pointerup") held?.drop();
    held = null;
    const last = pointers.size === 1 && pointers.delete(event.pointerId);
    if (last && event.type === "pointerup" && event.button === 0 && wandered < CLICK) {
      const { x, y } = place(element, event);
      handle.pick(x, y);
    }
    pointers.delete(event.pointerId);
  };
  element.addEventListener("pointerup", up, options);
  element.addEventListener("pointercancel", up, options);
  element.addEventListener("pointerleave", () => handle.leave(), options);
  element.addEventListener("contextmenu", event => event.preventDefault(), options);
  element.addEventListener("dblclick", () => handle.fit(), options);
  element.addEventListener("wheel", event => wheel(element, handle, event), { ...options, passive: false });
  element.addEventListener(
    "keydown",
    event => {
      if (key(handle, event)) event.preventDefault();
    },
    options,
  );
  return () => stop.abort();
}

function place(element: HTMLElement, event: MouseEvent): { x: number; y: number } {
  const { left, top } = element.getBoundingClientRect();
  return { x: event.clientX - left, y: event.clientY - top };
}

type Point = { x: number; y: number };

function dragged(camera: Camera, event: PointerEvent, before: Point, now: Point): Camera {
  const [dx, dy] = [now.x - before.x, now.y - before.y];
  const shifts = event.shiftKey || (event.buttons & 6) !== 0; // right or middle button
  return shifts ? pan(camera, dx, dy) : turned(camera, dx, dy);
}

/** As a drag by so many CSS pixels turns it. */
export const turned = (camera: Camera, dx: number, dy: number): Camera => orbit(camera, -dx * TURN, dy * TURN);

/** Two fingers: what is between them stays between them. */
function pinched(handle: Handle, before: Point, now: Point, other: Point): Camera {
  const apart = (p: Point) => Math.max(1, Math.hypot(p.x - other.x, p.y - other.y));
  const moved = pan(handle.camera(), (now.x - before.x) / 2, (now.y - before.y) / 2);
  return zoom(moved, handle.view(), apart(now) / apart(before), (now.x + other.x) / 2, (now.y + other.y) / 2);
}

function wheel(element: HTMLElement, handle: Handle, event: WheelEvent): void {
  event.preventDefault();
  const { x, y } = place(element, event);
  const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : 1);
  handle.move(zoom(handle.camera(), handle.view(), Math.exp(-pixels * 0.0015), x, y));
}

/** True if the key meant something here. */
function key(handle: Handle, event: KeyboardEvent): boolean {
  const command = meantBy(event, "view");
  if (!command) return false;
  const arrow = ARROWS[event.key] ?? [0, 0];
  const commands: Record<Command<"view">, () => void> = {
    turn: () => handle.move(arrowed(handle.camera(), arrow, false)),
    shift: () => handle.move(arrowed(handle.camera(), arrow, true)),
    "zoom-in": () => handle.move(zoom(handle.camera(), handle.view(), KEY_ZOOM)),
    "zoom-out": () => handle.move(zoom(handle.camera(), handle.view(), 1 / KEY_ZOOM)),
    fit: () => handle.fit(),
    top: () => handle.setView("top"),
    front: () => handle.setView("front"),
    right: () => handle.setView("right"),
    oblique: () => handle.setView("iso"),
  };
  commands[command]();
  return true;
}

const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

function arrowed(camera: Camera, [x, y]: [number, number], shifts: boolean): Camera {
  return shifts ? pan(camera, -x * KEY_PAN, -y * KEY_PAN) : orbit(camera, x * KEY_TURN, -y * KEY_TURN);
}
