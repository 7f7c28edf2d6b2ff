// How many times as large the errors of the part are drawn.

import type { SceneView } from "../core/scene";
import { el, on, setAttribute, setText, show } from "../dom";
import { plain } from "../numbers";
import { EXAGGERATIONS, type State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";

export function createExaggeration(store: Store): {
  root: HTMLElement;
  draw(state: State, view: SceneView | null): void;
} {
  const slider = el("input", { type: "range", min: 0, max: EXAGGERATIONS.length - 1, step: 1, id: "errors-shown" });
  const times = el("output", { class: "badge-measure figure", for: "errors-shown" });
  const ghost = el("p", { class: "ghost-note" }, t("view-nominal"));
  const root = el(
    "div",
    { class: "stage-card errors-shown" },
    el("div", { class: "card-row" }, el("label", { for: "errors-shown" }, t("view-errors")), times),
    slider,
    ghost,
  );
  on(slider, "input", () => store.update({ view: { errors: EXAGGERATIONS[Number(slider.value)] ?? 1 } }));
  return {
    root,
    draw(state, view) {
      const { errors } = state.view;
      slider.value = String(Math.max(0, EXAGGERATIONS.indexOf(errors)));
      const drawn = errors > 1 ? (view?.exaggerated ?? 1) : 1;
      const said = `×${plain(drawn)}`;
      setText(times, said);
      setAttribute(slider, "aria-valuetext", said);
      setText(ghost, drawn < errors ? t("view-errors-most", { times: said }) : t("view-nominal"));
      show(ghost, errors > 1);
    },
  };
}
