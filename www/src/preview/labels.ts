// Words beside what is drawn: coordinate systems, diameters of a turned part, what must not touch and did.

import type { Collision, Drawing, Frame, Reading, SceneView } from "../core/scene";
import { fixed, signed } from "../numbers";
import type { Vec3 } from "../wire";
import type { Colours } from "./colours";
import { add, dot, sub, times } from "./vec";

/**
 * `below`: under its point on the screen, `aside`: to the left of it as well; both clear of others. `raised`: so many
 * CSS pixels above. `beside`: it begins there instead of standing over it. `during`: entries of the trace between which
 * it is shown.
 */
export interface Label {
  at: Vec3;
  text: string;
  colour: string;
  below?: boolean;
  aside?: boolean;
  raised?: number;
  beside?: boolean;
  during?: readonly [number, number];
}

/** The name of a coordinate system in words. */
export type FrameWords = (frame: Frame) => string;

/** Words beside what is drawn. */
export interface Words {
  collision?(found: Collision): string; // beside what must not touch and did
  frame?: FrameWords; // beside a coordinate system
}

const UP = [10, -4] as const; // CSS pixels from the upper end of a dimension line up to both lines of its text
const DOWN = [4, -10] as const; // and from the lower end
const ABOVE = 14; // from a touched point to its diameter
const EXACT = 5e-4; // mm; a smaller deviation is none
const LETTER = 1.14; // from the zero to the letter of an axis, in lengths of the axis

export function labelsOf(view: SceneView, colours: Colours, words: Words, drawing: boolean): Label[] {
  return [
    ...frameLabels(view, colours, words.frame ?? (({ name }) => name)),
    ...(drawing && view.drawing ? drawingLabels(view.drawing, colours) : []),
    ...collisionLabels(view.collisions, colours, words.collision ?? (() => "")),
  ];
}

/** The letters of the axes, not of a system that has been moved since; the names of those at one place together. */
function frameLabels({ frames, axis }: SceneView, colours: Colours, words: FrameWords): Label[] {
  const axes = [
    ["X", colours.axisX],
    ["Y", colours.axisY],
    ["Z", colours.axisZ],
  ] as const;
  const letters = frames
    .filter(({ moved }) => moved !== "before")
    .flatMap(({ at, axes: directions }) =>
      axes.map(([text, colour], i): Label => ({ at: add(at, times(directions[i]!, LETTER * axis)), text, colour })),
    );
  const names = new Map<string, Label>();
  for (const frame of frames) {
    const place = JSON.stringify([frame.at, frame.axes]);
    const text = [names.get(place)?.text, words(frame)].filter(Boolean).join(", ");
    names.set(place, { at: frame.at, text, colour: colours.text, below: true, aside: true });
  }
  return [...letters, ...names.values()];
}

const diameterText = (diameter: number): string => `Ø${fixed(diameter, 3)}`;

/**
 * Dimension lines with the diameter as it is, below it the set one and the deviation; the diameter at each touched
 * point, until that point is touched again.
 */
export function drawingLabels({ dimensions, touched }: Drawing, colours: Colours): Label[] {
  const found = touched.map(
    ({ at, diameter, from, to = Infinity }): Label => ({
      at,
      text: diameterText(diameter),
      colour: colours.touch,
      raised: ABOVE,
      during: [from, to],
    }),
  );
  const dimensioned = dimensions.flatMap(({ at, upper, set, real }): Label[] => {
    const [first, second] = upper ? UP : DOWN;
    const words = { at, colour: colours.text, beside: true };
    const deviation = real - set;
    const exact = Math.abs(deviation) < EXACT;
    const below = exact ? `= ${diameterText(set)}` : `${diameterText(set)} ${signed(deviation, 3)}`;
    return [
      { ...words, text: diameterText(real), raised: first },
      { ...words, text: below, raised: second },
    ];
  });
  return [...found, ...dimensioned];
}

/** X and Z of a position as the control shows them, X as a diameter where it counts so. */
export function readingText({ at, axes, diameter }: Reading, position: Vec3): string {
  const [x, , z] = axes.map(axis => dot(sub(position, at), axis)) as Vec3;
  return `X ${diameter ? diameterText(2 * x) : fixed(x, 3)}  Z ${fixed(z, 3)}`;
}

/** From the entry on in which it happens. */
export function collisionLabels(found: Collision[], colours: Colours, words: (one: Collision) => string): Label[] {
  return found.map(
    (one): Label => ({
      at: one.at,
      text: words(one),
      colour: colours.crash,
      below: true,
      during: [one.entry, Infinity],
    }),
  );
}
