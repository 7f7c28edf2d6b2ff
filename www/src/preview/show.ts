// What is shown, from where, by which way of drawing and when: the four of them together.

import { firstFrom, vec } from "../core/scene";
import { type Arrow, longest } from "./arrows";
import type { BackendName, Cloud, Frame } from "./backend";
import { type Camera, projector } from "./camera";
import { type Colours, LIGHT } from "./colours";
import { type Content, EMPTY, lastStep, type Say, type Step, sceneOf } from "./content";
import { flash } from "./flash";
import { probeAt, toolAt } from "./motion";
import { drawOverlay, overlay } from "./overlay";
import { createPainter, type Painter } from "./painter";
import type { Rect } from "./places";
import type { Scene } from "./scene";
import { createSight, type Sight } from "./sight";
import { sizeOf } from "./stage";
import { openWays, type Refusal, type Ways } from "./ways";

export interface ShowOptions {
  say?: Say; // what is written beside what is drawn
  colours?: Colours;
  onBackend?(name: BackendName, refused: readonly Refusal[]): void; // at the start, and again after a loss
  onThinned?(drawn: number): void; // so many points of the cloud are drawn
}

export interface Show {
  readonly content: Content;
  readonly scene: Scene;
  readonly ways: Ways;
  readonly sight: Sight;
  readonly painter: Painter;
  /** Shows this part of it otherwise, with a new scene unless the old one still shows it. */
  change(part: Partial<Content>, same?: boolean): void;
  setCloud(cloud: Cloud | null): void;
  setArrows(arrows: readonly Arrow[] | null): void;
  onDraw(callback: (camera: Camera) => void): void;
  /** What covers the view, where no words should stand. */
  setTaken(taken: readonly Rect[]): void;
}

export async function createShow(stage: HTMLElement, options: ShowOptions): Promise<Show> {
  const letters = overlay(stage);
  let taken: readonly Rect[] = [];
  let given: readonly Arrow[] | null = null;
  let arrows: readonly Arrow[] = [];
  let drawn: (camera: Camera) => void = () => undefined;
  let missed = false; // what was to be drawn while a picture was under way
  const painter = createPainter(() => {
    missed = ways.backend.busy;
    if (missed) return;
    draw(show, letters, taken, arrows);
    drawn(show.sight.camera);
  });
  const ways = await openWays(stage, {
    replaced: adopt,
    again: painter.soon,
    drawn() {
      if (missed) painter.now();
    },
    trailed(drawn) {
      stage.dataset.motions = String(drawn);
    },
    thinned(drawn) {
      stage.dataset.drawn = String(drawn);
      options.onThinned?.(drawn);
    },
  });
  let content: Content = {
    data: EMPTY,
    colours: options.colours ?? LIGHT,
    step: lastStep(EMPTY),
    drawing: false,
    section: false,
    focus: null,
  };
  let scene: Scene;
  let cloud: Cloud | null = null;
  const sight = createSight(sizeOf(stage), {
    box: () => scene.box,
    held: () => toolAt(content.data, content.step.index)?.ball,
    changed: painter.soon,
  });

  function build(): void {
    scene = sceneOf(content, options.say);
    ways.backend.setScene(scene, devicePixelRatio);
  }
  /** Gives everything to a way of drawing that has nothing yet. */
  function adopt(): void {
    fill(ways.backend.element);
    build();
    ways.backend.setCloud(cloud);
    stage.dataset.backend = ways.backend.name;
    options.onBackend?.(ways.backend.name, ways.refused);
    painter.soon();
  }

  const show: Show = {
    get content() {
      return content;
    },
    get scene() {
      return scene;
    },
    ways,
    sight,
    painter,
    change(part, same = false) {
      if (part.step && same) flashed(show, part.step, stage);
      content = { ...content, ...part };
      if (!same) build();
      painter.now();
    },
    setCloud(next) {
      if (next === cloud) return;
      cloud = next;
      delete stage.dataset.drawn;
      ways.backend.setCloud(cloud);
      painter.now();
    },
    setArrows(next) {
      if (next === given) return;
      given = next;
      arrows = longest(next ?? []);
      painter.now();
    },
    setTaken(next) {
      taken = next;
      painter.soon();
    },
    onDraw(callback) {
      drawn = callback;
      painter.soon();
    },
  };
  adopt();
  return show;
}

function fill(element: Element & ElementCSSInlineStyle): void {
  Object.assign(element.style, { position: "absolute", inset: "0", width: "100%", height: "100%", display: "block" });
}

const SOON = 4; // steps that may lie between two frames of playing

/** The touches between the last step and this one flash, where it is played and not leapt. */
function flashed({ content, sight: { camera, view } }: Show, next: Step, stage: HTMLElement): void {
  const { data, step, colours } = content;
  if (next.index <= step.index || next.index > step.index + SOON) return;
  const project = projector(camera, view);
  for (let i = firstFrom(data.touchEntries, step.index + 1); data.touchEntries[i]! <= next.index; i++)
    flash(stage, project(vec(data.touches, 6 * i)), colours.measuring);
}

function draw(
  { content, scene, ways, sight: { camera, view } }: Show,
  letters: SVGSVGElement,
  taken: readonly Rect[],
  arrows: readonly Arrow[],
): void {
  const { index, fraction } = content.step;
  const probe = probeAt(content.data, index, fraction);
  const frame: Frame = { camera, view, ratio: devicePixelRatio, time: index + fraction, probe };
  try {
    ways.backend.draw(frame);
    drawOverlay(letters, scene, frame, taken, arrows);
  } catch (reason) {
    void ways.replace(reason);
  }
}
