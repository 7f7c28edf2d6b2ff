// The 3D view of a trace. Draws when something changed and never otherwise.
import type { SceneData } from "../core/scene";
import type { Arrow } from "./arrows";
import type { BackendName, Cloud } from "./backend";
import { type Basis, basis, type Camera, turn, type ViewName } from "./camera";
import type { Colours } from "./colours";
import { EMPTY, lastStep, sameScene } from "./content";
import { heldAt, pulled } from "./hold";
import { listen, turned } from "./input";
import { type Face, faceAt, fieldAt, pick } from "./pick";
import type { Rect } from "./places";
import { createShow, type Show, type ShowOptions } from "./show";
import { makeStage, watchSize } from "./stage";
import type { Refusal } from "./ways";

export type { SceneData } from "../core/scene";
export type { BackendName } from "./backend";
export type { Camera, ViewName } from "./camera";
export { type Colours, coloursFrom, DARK, LIGHT } from "./colours";
export type { Refusal } from "./ways";

export interface Options extends ShowOptions {
  label: string; // what a screen reader says
}

/** What drags the probe. */
export interface Hand {
  /** Along an axis of the machine (0 X …), mm since it was taken hold of. */
  along(axis: number, way: number): void;
  /** It is dropped on a face of the part, away from that axis. */
  onto(face: Face): void;
}

const BESIDE = 40; // CSS pixels from its axis at which a drag is one onto a face

export interface Preview {
  readonly backend: BackendName;
  readonly refused: Refusal[];
  /** From where it is seen. */
  readonly camera: Camera;
  /** `focus`: as `setFocus`, in one step with it. */
  setScene(scene: SceneData, focus?: string | null): void;
  /** Entry `index` of the trace is done to `fraction` (0 … 1). */
  setStep(index: number, fraction: number): void;
  /** Scanned points, over whatever else is shown. */
  setCloud(cloud: Cloud | null): void;
  /** How the faces of a real part lie; null: nothing is known. */
  setArrows(arrows: readonly Arrow[] | null): void;
  setView(name: ViewName): void;
  /** As if it was dragged by so many CSS pixels. */
  turn(dx: number, dy: number): void;
  /** In central projection, else in parallel projection. */
  setCentral(central: boolean): void;
  /** Directions of a standard view, of what is seen now where none is named. */
  basisOf(name: ViewName | null): Basis;
  /** Whether the camera is on its way. */
  readonly turning: boolean;
  /** Whether a picture is under way that is not yet on the screen. */
  readonly drawing: boolean;
  /** Told whenever it was drawn. */
  onDraw(callback: (camera: Camera) => void): void;
  fit(): void;
  /** What a screen reader says. */
  setLabel(label: string): void;
  /** A click on a motion or touch. */
  onPick(callback: (entry: number) => void): void;
  /** A click on the part, before what else is there; null: nobody wants to know. */
  onFace(callback: ((face: Face) => void) | null): void;
  /** The probe is taken hold of; what is answered is told where it is dragged. null: it cannot be. */
  onGrab(callback: (() => Hand) | null): void;
  /** The pointer is on the dimension of a parameter, or on none; a click on one. */
  onField(pointed: (parameter: string | null) => void, chosen: (parameter: string) => void): void;
  setColours(colours: Colours): void;
  /** So many CSS pixels at the left are covered: what is fitted stands beside them where there is room. */
  setCovered(width: number): void;
  /** Diameters of a turned part as on a drawing. */
  setDrawing(shown: boolean): void;
  /** The part is cut open. */
  setSection(shown: boolean): void;
  /** What covers the view, where no words should stand. */
  setTaken(taken: readonly Rect[]): void;
  /** The dimension of this parameter stands out, where there is one. */
  setFocus(parameter: string | null): void;
  destroy(): void;
}

export async function createPreview(host: HTMLElement, options: Options): Promise<Preview> {
  const stage = makeStage(host, options.label);
  const show = await createShow(stage, options);
  let picked: (entry: number) => void = () => undefined;
  let faced: ((face: Face) => void) | null = null;
  let grabbed: (() => Hand) | null = null;
  let pointed: (parameter: string | null) => void = () => undefined;
  let chosen: (parameter: string) => void = () => undefined;
  const { sight } = show;
  const at = (x: number, y: number): string | null => fieldAt(stage, show.scene.lines, sight, x, y);
  const silence = listen(stage, {
    camera: () => sight.camera,
    view: () => sight.view,
    move: sight.move,
    setView: sight.setView,
    fit: sight.fit,
    point(x, y) {
      stage.style.cursor = grabbed && heldAt(show.content, sight, x, y) ? "grab" : "";
      pointed(at(x, y));
    },
    grab(x, y) {
      const ball = grabbed && heldAt(show.content, sight, x, y);
      if (!ball || !grabbed) return null;
      const [way, hand] = [pulled(ball, sight, x, y), grabbed()];
      let onto: Face | null = null;
      return {
        move(nowX, nowY) {
          const moved = way(nowX, nowY);
          if (!moved) return;
          const part = moved.beside > BESIDE;
          onto = part ? faceAt(show.content.data, show.content.step.index, sight, nowX, nowY) : null;
          hand.along(moved.axis, onto ? 0 : moved.way);
        },
        drop: () => void (onto && hand.onto(onto)),
      };
    },
    leave: () => pointed(null),
    pick(x, y) {
      const field = at(x, y);
      if (field !== null) return chosen(field);
      const face = faced && faceAt(show.content.data, show.content.step.index, sight, x, y);
      if (face) return faced?.(face);
      const entry = pick(show.scene.lines, sight.camera, sight.view, x, y);
      if (entry !== null) picked(entry);
    },
  });
  const unwatch = watchSize(stage, sight.resize);
  return {
    ...changes(show),
    get backend() {
      return show.ways.backend.name;
    },
    get refused() {
      return [...show.ways.refused];
    },
    get camera() {
      return sight.camera;
    },
    setView: sight.setView,
    turn: (dx, dy) => sight.move(turned(sight.camera, dx, dy)),
    basisOf: name => basis(name ? turn(sight.camera, name) : sight.camera),
    setCentral: sight.project,
    get turning() {
      return sight.turning;
    },
    get drawing() {
      return show.ways.backend.busy;
    },
    onDraw: show.onDraw,
    setTaken: show.setTaken,
    fit: sight.fit,
    setCovered: sight.cover,
    setLabel: label => stage.setAttribute("aria-label", label),
    onPick(callback) {
      picked = callback;
    },
    onFace(callback) {
      faced = callback;
    },
    onGrab(callback) {
      grabbed = callback;
    },
    onField(onPoint, onChoose) {
      [pointed, chosen] = [onPoint, onChoose];
    },
    destroy() {
      show.painter.end();
      sight.end();
      unwatch();
      silence();
      show.ways.end();
      stage.remove();
    },
  };
}

/** What may be shown otherwise, and what follows for the sight. */
function changes(
  show: Show,
): Pick<
  Preview,
  "setScene" | "setStep" | "setCloud" | "setArrows" | "setColours" | "setDrawing" | "setSection" | "setFocus"
> {
  return {
    setScene(data, focus = show.content.focus) {
      const first = show.content.data === EMPTY;
      show.change({ data, step: lastStep(data), focus: explained(data, focus) });
      show.sight.turnTo(data.view.turning, first);
    },
    setStep(index, fraction) {
      const step = { index, fraction };
      show.change({ step }, sameScene(show.content.data, show.content.step, step));
    },
    setCloud: show.setCloud,
    setArrows: show.setArrows,
    setColours: colours => show.change({ colours }),
    setDrawing(drawing) {
      if (drawing === show.content.drawing) return;
      show.change({ drawing });
      show.sight.refit();
    },
    setSection(section) {
      if (section !== show.content.section) show.change({ section });
    },
    setFocus(parameter) {
      const { data, focus } = show.content;
      const next = explained(data, parameter);
      if (next !== focus) show.change({ focus: next });
    },
  };
}

/** The parameter, if the scene has its dimension. */
const explained = ({ view }: SceneData, parameter: string | null): string | null =>
  view.labels.some(({ field }) => field && field === parameter) ? parameter : null;
