// The machine to practise on in the page: fetched when it is shown, and the ways to it.

import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { type Practice, practises } from "../desk/practice";
import { el, on, setAttribute, show } from "../dom";
import { machine, type State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import type { CallPractice } from "../views/form";
import type { Stage } from "../views/stage";
import type { Dialect, PracticeCallRequest, PracticeProgram } from "../wire";
import type { Layout } from "./layout";
import type { Modules } from "./modules";
import { railButton } from "./rail";
import type { Where } from "./where";

interface Needed {
  store: Store;
  actions: Pick<Actions, "write">;
  practice: Practice;
  stage: Stage;
  where: Where;
  modules: Pick<Modules, "program">;
}

/** The call in the form, on the machine on which it is. */
function requestOf(state: State, { control, cycle }: { control: Dialect; cycle: string }): PracticeCallRequest {
  const { values, around } = state.form;
  const { plane, units } = around ?? {};
  return { control, cycle, values, ...machine(state), ...(plane ? { plane } : {}), ...(units ? { units } : {}) };
}

/** `stop`: nobody wants it any more. */
export function createPracticePlace(
  { header, rail, panels }: Layout,
  { store, actions, practice, stage, where, modules }: Needed,
  stop: AbortSignal,
): { go(): void; call: CallPractice; draw(state: State, derived: Derived): void } {
  const root = el("main", { class: "jog", id: "jog", tabindex: "-1", hidden: true });
  header.after(root);
  const go = (): void => {
    where.go("jog");
    root.focus();
  };
  const button = railButton(t("practice-rail"), "hand", { class: "rail-practice", title: t("practice-title") });
  on(button, "click", go);
  rail.querySelector('[data-panel-button="help"]')?.before(button);
  const toWork = (): void => {
    where.go("work");
    panels[store.state.panels.panel].focus();
  };
  let draw: ((state: State) => void) | null = null;
  let coming = false;
  const fetch = async (): Promise<void> => {
    coming = true;
    const { createPlace } = await import("../jog/place");
    if (stop.aborted) return;
    const insert = ({ cycle, values, text }: PracticeProgram): void => {
      actions.write(cycle ?? "", values, text);
      toWork();
    };
    draw = createPlace(root, practice, stage, { toWork, insert }, stop);
    store.update({});
  };
  let asked: unknown = null;
  let known = false;
  const call: CallPractice = {
    there(state, { cycle, view }) {
      const core = modules.program;
      if (!core || state.page.place !== "work") return false;
      if (asked !== view) {
        asked = view;
        known = core.asMask(requestOf(state, cycle)) !== null;
      }
      return known;
    },
    go() {
      const { state } = store;
      const { control, cycle } = state.form;
      if (practice.call(requestOf(state, { control, cycle }))) go();
    },
  };
  return {
    go,
    call,
    draw(state, { catalogue }) {
      const there = practises(state, catalogue);
      show(button, there);
      const here = state.page.place === "jog";
      if (here && !there) return where.go("work");
      show(root, here);
      setAttribute(root, "aria-busy", here && !draw ? "true" : null);
      if (here && modules.program && !coming) void fetch().catch(console.error);
      draw?.(state);
    },
  };
}
