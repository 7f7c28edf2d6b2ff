// Words beside what is drawn: what the core says, and how it stands there.

import type { LineGroup, Reading, SceneLabel, SceneView } from "../core/scene";
import { fixed, MM_PER_INCH } from "../numbers";
import type { LabelKind, Message, Vec3 } from "../wire";
import type { Colours } from "./colours";
import { add, dot, length, sub, times } from "./vec";

/**
 * `below`: under its point on the screen, `aside`: to the left of it as well; both clear of others. `raised`: so many
 * CSS pixels above. `beside`: it begins there instead of standing over it. `during`: entries of the trace between which
 * it is shown. `field`: parameter that it explains. `zero`: the name of a coordinate system. `lit`: it stands out.
 * `origin`: out of sight, this is not shown either.
 */
export interface Label {
  at: Vec3;
  text: string;
  colour: string;
  below?: boolean;
  aside?: boolean;
  raised?: number;
  beside?: boolean;
  zero?: boolean;
  lit?: boolean;
  origin?: Vec3;
  during?: readonly [number, number];
  field?: string | undefined;
  number?: number | undefined; // of a touch
}

/** Puts what the core says into words. */
export type Say = (message: Message) => string;

const UP = [10, -4] as const; // CSS pixels from the upper end of a dimension line up to both lines of its text
const DOWN = [4, -10] as const; // and from the lower end
const ABOVE = 14; // from a touched point to its diameter
const OVER = 5; // from the middle of a dimension line to its name
const LETTER = 1.14; // from the zero to the letter of an axis, in lengths of the axis
const SAME = 0.3; // of that length: letters nearer to each other than this are one

const colourOf: Record<LabelKind, "text" | "touch" | "crash"> = {
  frame: "text",
  diameter: "text",
  nominal: "text",
  touched: "touch",
  touch: "text",
  collision: "crash",
  size: "text",
  anchor: "text",
};
const PLACES: Record<LabelKind, (upper: boolean) => Partial<Label>> = {
  frame: () => ({ below: true, aside: true, zero: true }),
  diameter: upper => ({ beside: true, raised: (upper ? UP : DOWN)[0] }),
  nominal: upper => ({ beside: true, raised: (upper ? UP : DOWN)[1] }),
  touched: () => ({ raised: ABOVE }),
  touch: () => ({}),
  collision: () => ({ below: true }),
  size: () => ({ raised: OVER }),
  anchor: () => ({ raised: OVER }),
};
const ON_DRAWINGS = ["diameter", "nominal", "touched", "dimension"];

/** `drawing`: with the diameters of a turned part; `focus`: parameter of the focused field. */
export interface Wanted {
  drawing: boolean;
  focus: string | null;
}

/** The part's own sizes are always there, the diameters of a turned part and what a field explains when wanted. */
export function isWanted(
  { kind, field }: Pick<LineGroup, "kind" | "field"> | SceneLabel,
  { drawing, focus }: Wanted,
): boolean {
  if (kind === "touch") return !drawing;
  return kind === "anchor" ? field === focus : drawing || !ON_DRAWINGS.includes(kind);
}

/** `around`: entries of the trace of which paths are drawn. */
export function labelsOf(
  view: SceneView,
  colours: Colours,
  say: Say,
  wanted: Wanted,
  [first, end]: readonly [number, number] = [0, Infinity],
): Label[] {
  const near = ({ from = first, to = end }: SceneLabel): boolean => from < end && to >= first;
  const shown = view.labels.filter(label => near(label) && isWanted(label, wanted));
  return [...letters(view, colours), ...shown.map(label => placed(label, colours, say, wanted))];
}

function placed(
  { kind, at, text, upper = false, number, field, from, to = Infinity }: SceneLabel,
  colours: Colours,
  say: Say,
  { focus }: Wanted,
): Label {
  const lit = !!field && field === focus;
  return {
    at,
    text: text.map(say).filter(Boolean).join(", ") || (field ?? ""),
    colour: lit ? colours.lit : colours[colourOf[kind]],
    ...PLACES[kind](upper),
    lit,
    ...(from !== undefined && { during: [from, to] }),
    field,
    number,
  };
}

/**
 * The letters of the axes, not of a system that has been moved since; of systems that nearly lie in one another a
 * letter is written once.
 */
function letters({ frames, axis }: SceneView, colours: Colours): Label[] {
  const axes = [
    ["X", colours.axisX],
    ["Y", colours.axisY],
    ["Z", colours.axisZ],
  ] as const;
  const all = frames
    .filter(({ moved }) => moved !== "before")
    .flatMap(({ at, axes: directions }) =>
      axes.map(([text, colour], i): Label => {
        return { at: add(at, times(directions[i]!, LETTER * axis)), origin: at, text, colour };
      }),
    );
  const near = (a: Label, b: Label): boolean => a.text === b.text && length(sub(a.at, b.at)) < SAME * axis;
  return all.filter((one, index) => !all.slice(0, index).some(other => near(one, other)));
}

/** X and Z of a position as the control shows them, X as a diameter where it counts so. */
export function readingText({ at, axes, diameter, inch }: Reading, position: Vec3): string {
  const [x, , z] = axes.map(axis => dot(sub(position, at), axis)) as Vec3;
  const shown = (length: number): string => (inch ? fixed(length / MM_PER_INCH, 4) : fixed(length, 3));
  return `X ${diameter ? `Ø${shown(2 * x)}` : shown(x)}  Z ${shown(z)}`;
}
