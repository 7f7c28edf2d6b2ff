// The story of the worked example: a part that lies off is measured, its zero offset corrected, and measured again.
// Everything that it shows is simulated like any other work.

import { AT_END, type Patch } from "../state/state";

/** A step: the stem of its words, and what of the page it shows. */
export interface Telling {
  key: string;
  show: Patch;
}

const FORM = { panel: "form", left: "form" } as const;
const VIEW = { panel: "view", left: "form" } as const;
const RESULTS = { panel: "results", left: "form", dock: "results", tab: "outcome", right: "results" } as const;

export const STEPS: readonly Telling[] = [
  { key: "story-part", show: { panels: VIEW, view: { source: "form", step: 0, playing: false, errors: 100 } } },
  { key: "story-call", show: { panels: FORM, view: { source: "form", step: 0, playing: false, errors: 1 } } },
  { key: "story-probe", show: { panels: VIEW, view: { source: "form", step: 0, playing: true, errors: 1 } } },
  { key: "story-correct", show: { panels: RESULTS, view: { source: "form", step: AT_END, playing: false } } },
  { key: "story-again", show: { panels: RESULTS, view: { source: "program", step: AT_END, playing: false } } },
];
