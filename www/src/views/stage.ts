// The 3D view outlives the panel around it: when the language changes, it moves into the new panel with its camera.

import { el } from "../dom";
import type { Preview } from "../preview/view";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { say, t } from "../texts";

type Colours = Parameters<Preview["setColours"]>[0];
export interface Stage {
  readonly box: HTMLElement;
  readonly preview: Preview | null;
  /** Why there is none. */
  readonly failed: string;
  /** So many points of the shown cloud are drawn. */
  readonly drawn: number;
  /** Fetches the drawing unless it is there or on its way. */
  fetch(): void;
  colours(night: boolean): Colours | null;
}

const dark = matchMedia("(prefers-color-scheme: dark)");

/** The stage takes its colours from the tokens that count now. */
export function isDark(state: State): boolean {
  return state.page.theme === "dark" || (state.page.theme === "system" && dark.matches);
}

export function createStage(store: Store): Stage {
  const box = el("div", { class: "stage" });
  let preview: Preview | null = null;
  let failed = "";
  let drawn = 0;
  let fetching = false;
  let colours = (_: boolean): Colours | null => null;

  const onThinned = (points: number): void => {
    if (points === drawn) return;
    drawn = points;
    store.update({});
  };
  const start = async (): Promise<void> => {
    try {
      const { createPreview, coloursFrom, LIGHT, DARK } = await import("../preview/view");
      const known = new Map<boolean, Colours>(); // to ask makes the browser work out all styles: once is enough
      const of = (night: boolean): Colours => {
        const found = known.get(night) ?? coloursFrom(box, night ? DARK : LIGHT);
        known.set(night, found);
        return found;
      };
      colours = of;
      preview = await createPreview(box, {
        label: t("view-canvas"),
        colours: of(isDark(store.state)),
        say,
        onThinned,
      });
      preview.onPick(entry => store.update({ view: { step: entry, playing: false } }));
    } catch (problem) {
      failed = problem instanceof Error ? problem.message : String(problem);
    }
    store.update({});
  };
  dark.addEventListener("change", () => store.update({}));
  return {
    box,
    get preview() {
      return preview;
    },
    get failed() {
      return failed;
    },
    get drawn() {
      return drawn;
    },
    fetch() {
      if (fetching) return;
      fetching = true;
      void start();
    },
    colours: night => colours(night),
  };
}
