// The 3D view outlives the panel around it: when the language changes, it moves into the new panel with its camera.

import { el } from "../dom";
import type { Collision, Frame, Preview } from "../preview/view";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";

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

/** What stands beside what is drawn. */
export const WORDS = { collision, frame };

const dark = matchMedia("(prefers-color-scheme: dark)");

/** The stage takes its colours from the tokens that count now. */
export function isDark(state: State): boolean {
  return state.page.theme === "dark" || (state.page.theme === "system" && dark.matches);
}

/** What must not touch and did, in a few words. */
function collision({ by, crash, alarm }: Collision): string {
  const what = t(`collision-${by}`);
  if (crash) return t("collision-crash", { what });
  return alarm ? t("collision-alarm", { code: alarm, what }) : t("collision-first", { what });
}

/** A coordinate system by its name, and whether it stands before or after a correction. */
function frame({ name, moved }: Frame): string {
  return moved ? t(`frame-${moved}`, { name }) : name;
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
        ...WORDS,
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
