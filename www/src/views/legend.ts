// What the colours and dashes of the 3D view mean: only what the shown motions have. What is drawn and meets nothing,
// and how many points of a scan are left out.

import { type Course, Sort } from "../core/steps";
import { el, keyed, svg } from "../dom";
import type { Colours } from "../preview/view";
import { t } from "../texts";

type Kind =
  | "rapid"
  | "positioning"
  | "measuring"
  | "retract"
  | "touch"
  | "crash"
  | "zone"
  | "limit"
  | "carrier"
  | "swept";
const KINDS: Kind[] = [
  "measuring",
  "touch",
  "positioning",
  "rapid",
  "retract",
  "swept",
  "zone",
  "limit",
  "carrier",
  "crash",
];

/** What a step is drawn as, by its sort. */
const DRAWN: (Kind | undefined)[] = ["rapid", "positioning", "measuring", "retract", "touch", "touch", "crash"];

function present(trace: Course | null): Kind[] {
  const sorts = new Set(trace?.steps.sorts);
  const found = new Set([...sorts].map(sort => DRAWN[sort]));
  if (trace?.zones?.length) found.add("zone");
  if (trace?.limits?.length) found.add("limit");
  const moves = [...sorts].some(sort => sort < Sort.touch); // else no tool is drawn
  if (moves && (!trace?.tools || trace.tools.some(({ ball, carrier }) => ball || carrier.length))) found.add("carrier");
  if (moves && (!trace?.tools || trace.tools.some(({ ball }) => ball))) found.add("swept");
  return KINDS.filter(kind => found.has(kind));
}

const strokeOf = (kind: Kind, colours: Colours): string =>
  colours[kind === "limit" ? "crash" : kind === "carrier" || kind === "swept" ? "stylus" : kind];

/** Drawn as the view draws it. */
function sample(kind: Kind, stroke: string): SVGElement {
  const line = (width: number, dash: string | null = null): SVGElement =>
    svg("path", { d: "M1 4H25", stroke, "stroke-width": width, "stroke-dasharray": dash });
  const mark: Record<Kind, () => SVGElement[]> = {
    measuring: () => [line(3.5)],
    positioning: () => [line(1.75)],
    rapid: () => [line(1.75, "5 4")],
    retract: () => [line(1.5)],
    touch: () => [
      svg("path", { d: "M6 4H22", stroke, "stroke-width": 2 }),
      svg("circle", { cx: 6, cy: 4, r: 3.25, fill: stroke }),
    ],
    zone: () => [
      svg("rect", {
        x: 1,
        y: 0.5,
        width: 24,
        height: 7,
        fill: stroke,
        "fill-opacity": 0.25,
        stroke,
        "stroke-dasharray": "4 3",
      }),
    ],
    carrier: () => [svg("rect", { x: 1, y: 0.5, width: 24, height: 7, fill: stroke, "fill-opacity": 0.35 })],
    swept: () => [svg("rect", { x: 1, y: 0.5, width: 24, height: 7, rx: 3.5, fill: stroke, "fill-opacity": 0.45 })],
    limit: () => [line(1.25, "4 3")],
    crash: () => [svg("circle", { cx: 13, cy: 4, r: 4, fill: stroke })],
  };
  return svg("svg", { viewBox: "0 0 26 8", "aria-hidden": "true" }, ...mark[kind]());
}

/** How many of so many points of a scan are drawn. */
export interface Thinned {
  drawn: number;
  points: number;
}

export function createLegend(): {
  root: HTMLElement;
  draw(trace: Course | null, colours: Colours, thinned: Thinned | null): void;
} {
  const root = el("ul", { class: "legend", "aria-label": t("legend") });
  const item = (kind: Kind, colours: Colours): Item => ({
    key: `${kind} ${strokeOf(kind, colours)}`,
    sample: [sample(kind, strokeOf(kind, colours))],
    text: t(`legend-${kind}`),
  });
  const left = ({ drawn, points }: Thinned): Item => ({
    key: `${drawn} ${points}`,
    sample: [],
    text: t("legend-thinned", { drawn, points }),
  });
  return {
    root,
    draw(trace, colours, thinned) {
      const items = [...present(trace).map(kind => item(kind, colours)), ...(thinned ? [left(thinned)] : [])];
      keyed(
        root,
        items,
        ({ key }) => key,
        ({ sample, text }) => el("li", {}, ...sample, text),
        () => undefined,
      );
    },
  };
}

interface Item {
  key: string;
  sample: SVGElement[];
  text: string;
}
