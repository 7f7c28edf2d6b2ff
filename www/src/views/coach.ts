// Beside the work while the worked example is told: what there is to see, and the way from step to step.

import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { STEPS } from "../desk/story";
import { el, on, setText, show } from "../dom";
import { icon } from "../icons";
import { fixed } from "../numbers";
import type { State } from "../state/state";
import { t } from "../texts";
import { correctedText } from "./amounts";

/** What the words of the steps name. */
function figures({ part, run }: State, { view }: Derived): Record<string, string> {
  const { dx, dy } = part.errors.part;
  const answer = view.outcome?.answer;
  const again = run.done?.view.answers[1];
  return {
    x: fixed(dx, 3),
    y: fixed(dy, 3),
    corrected: answer ? correctedText(answer) : "",
    left: again ? correctedText(again) || t("bar-nothing") : "…",
  };
}

export function createCoach(actions: Actions): { root: HTMLElement; draw(state: State, derived: Derived): void } {
  const count = el("span", { class: "story-count" });
  const words = el("p", { role: "status" });
  const button = (key: string, of: "left" | "right" | "close", step: (now: number) => number): HTMLButtonElement => {
    const node = el("button", { type: "button" }, icon(of), el("span", {}, t(key)));
    on(node, "click", () => actions.story(step(at)));
    return node;
  };
  let at = 0;
  const back = button("story-back", "left", now => now - 1);
  const next = button("story-next", "right", now => now + 1);
  const leave = button("story-leave", "close", () => 0);
  next.classList.add("primary");
  const root = el(
    "section",
    { class: "story", "aria-label": t("story-title"), hidden: true },
    count,
    words,
    el("div", { class: "actions" }, back, next, leave),
  );
  return {
    root,
    draw(state, derived) {
      const begins = at === 0 && state.page.story > 0;
      at = state.page.story;
      show(root, at > 0);
      const step = STEPS[at - 1];
      if (!step) return;
      setText(count, t("story-count", { step: at, of: STEPS.length }));
      setText(words, t(step.key, figures(state, derived)));
      back.disabled = at === 1;
      show(next, at < STEPS.length);
      leave.classList.toggle("primary", at === STEPS.length);
      if (begins) next.focus();
    },
  };
}
