// The 3D view outlives the panel around it: when the language changes, it moves into the new panel with its camera.

import { el, on } from "../dom";
import { type IconName, icon } from "../icons";
import type { Preview } from "../preview/view";
import type { Store } from "../state/store";
import { say, t } from "../texts";
import { type Shown, shownTheme, watchTheme } from "../theme";
import type { Pointing } from "./pointing";

type Colours = Parameters<Preview["setColours"]>[0];
export interface Stage {
  readonly box: HTMLElement;
  readonly preview: Preview | null;
  /** Why there is none. */
  readonly failed: string;
  /** So many points of the shown cloud are drawn. */
  readonly drawn: number;
  /** How the faces of the real part lie, where a protocol tells it. */
  arrows: Parameters<Preview["setArrows"]>[0];
  /** Fetches the drawing unless it is there or on its way. */
  fetch(): void;
  /** From the tokens of that theme, which the page has now. */
  colours(theme: Shown): Colours | null;
}

/** `calm`: the drawing is not fetched before. */
export function createStage(store: Store, pointing: Pointing, calm: Promise<void>): Stage {
  const box = el("div", { class: "stage" });
  let preview: Preview | null = null;
  let failed = "";
  let drawn = 0;
  let fetching = false;
  let colours = (_: Shown): Colours | null => null;

  const onThinned = (points: number): void => {
    if (points === drawn) return;
    drawn = points;
    store.update({});
  };
  const start = async (): Promise<void> => {
    try {
      const { createPreview, coloursFrom, LIGHT, DARK } = await import("../preview/view");
      const known = new Map<Shown, Colours>(); // to ask makes the browser work out all styles: once is enough
      const of = (theme: Shown): Colours => {
        const found = known.get(theme) ?? coloursFrom(box, theme === "light" ? LIGHT : DARK);
        known.set(theme, found);
        return found;
      };
      colours = of;
      preview = await createPreview(box, {
        label: t("view-canvas"),
        colours: of(shownTheme(store.state.page.theme)),
        say,
        onThinned,
      });
      preview.onField(pointing.at, pointing.choose);
      preview.onPick(entry => store.update({ view: { step: entry, playing: false } }));
    } catch (problem) {
      failed = problem instanceof Error ? problem.message : String(problem);
    }
    store.update({});
  };
  watchTheme(() => store.update({}));
  return {
    box,
    arrows: null,
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
      void calm.then(start);
    },
    colours: theme => colours(theme),
  };
}

/** A button of the stage that shows an icon and says its name. */
export function tool(name: IconName, label: string, run: () => void): HTMLButtonElement {
  const button = el("button", { type: "button", class: "stage-tool", "aria-label": label, title: label }, icon(name));
  on(button, "click", run);
  return button;
}

/** Tells the preview what covers it, whenever that changes and is seen at all: two places have the stage in turn. */
export function watchTaken(stage: HTMLElement, cards: readonly HTMLElement[], preview: Preview): void {
  const sizes = new ResizeObserver(() => {
    const { left, top } = stage.getBoundingClientRect();
    const boxes = cards.map(card => card.getBoundingClientRect()).filter(({ width }) => width > 0);
    if (boxes.length === 0) return;
    preview.setTaken(
      boxes.map(box => ({
        left: box.left - left,
        top: box.top - top,
        right: box.right - left,
        bottom: box.bottom - top,
      })),
    );
  });
  for (const node of [stage, ...cards]) sizes.observe(node);
}
