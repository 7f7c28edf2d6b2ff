// The pictograms of the elements: areas that the core has drawn, coloured by the page (start.css).

import { svg } from "../dom";
import type { Dialect, Element } from "../wire";
import drawn from "./pictograms.json";

interface Pictogram {
  element: Element;
  /** Keys of its name and of what is measured of it. */
  keys: [string, string];
  controls: Dialect[];
  /** The answers of the variant that is drawn. */
  options: Record<string, string>;
  /** What each area is, and its outline, from the back to the front. */
  areas: [string, string][];
}

export const PICTOGRAMS = drawn as unknown as readonly Pictogram[];

/** The elements that a control measures. */
export const elementsOf = (control: Dialect): Pictogram[] =>
  PICTOGRAMS.filter(({ controls }) => controls.includes(control));

/** What the pictogram of an element shows. */
export const shownOf = (element: Element): Pick<Pictogram, "element" | "options"> =>
  PICTOGRAMS.find(one => one.element === element) ?? { element, options: {} };

/** It says nothing: its name stands beside it. */
export function pictogram({ areas }: Pictogram): SVGSVGElement {
  const paths = areas.map(([matter, d]) => svg("path", { class: matter, d, "fill-rule": "evenodd" }));
  return svg("svg", { class: "pictogram", viewBox: "0 0 768 480", "aria-hidden": "true" }, ...paths);
}
