// The start screen in the page: fetched when it is shown, and the way to it and from it.

import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { el, on, setAttribute, show } from "../dom";
import { icon } from "../icons";
import type { Way } from "../start/aims";
import { mayRead } from "../state/places";
import type { Recent } from "../state/recent";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import type { Layout } from "./layout";
import type { Modules } from "./modules";
import type { Open } from "./open";
import { createNoting } from "./recent";
import type { Where } from "./where";

/** What a field has to be filled for; of those with a unit the first is what is measured. */
const NEEDED = '[aria-required="true"]';

interface Needed {
  open: Open;
  modules: Pick<Modules, "full">;
  store: Store;
  actions: Actions;
  where: Where;
}

type Draw = (state: State, derived: Derived) => void;

/** `openProgram`: picks a program to be opened; `stop`: nobody wants it any more. */
export function createStartPlace(
  { header, main, panels }: Layout,
  { store, actions, where, open, modules: { full } }: Needed,
  openProgram: () => void,
  stop: AbortSignal,
): { draw: Draw; drawButton: (state: State) => void } {
  const root = el("main", { class: "start", id: "start", tabindex: "-1", hidden: true });
  header.after(root);
  const button = el(
    "button",
    { type: "button", class: "quiet to-start", title: t("start-place") },
    icon("home"),
    el("span", {}, t("start-place")),
  );
  on(button, "click", () => {
    where.go("start");
    (root.querySelector<HTMLElement>('[tabindex="0"]') ?? root).focus();
  });
  header.prepend(button);
  const toWork = (): void => {
    where.go("work");
    const field = panels.form.querySelector<HTMLElement>(`.field:has(.unit:not(:empty)) ${NEEDED}`);
    if (store.state.panels.panel === "form") (field ?? panels.form).focus();
    else panels[store.state.panels.panel].focus();
  };
  const again = async (item: Recent): Promise<void> => {
    const cycles = (await full()).catalogue().cycles.filter(one => one.control === item.control);
    if ("text" in item) {
      const [cycle] = cycles;
      if (cycle && store.state.form.control !== item.control) actions.chooseCycle(cycle);
      if (item.place && (await mayRead(item.place))) return open.place(item.place);
      return actions.openProgram(item.text, { name: item.name, encoding: item.encoding, opened: Date.now() }, null);
    }
    const cycle = cycles.find(one => one.cycle === item.cycle);
    const variant = cycle?.variants.find(one => one.mvar === item.mvar);
    if (!cycle || !variant) return;
    actions.measure(cycle, variant, item.values);
    toWork();
  };
  const tell = async ({ cycle, variant, values }: Way): Promise<void> => {
    const core = await full();
    const told = ({ form: { control, cycle, values }, part: { errors } }: State): string =>
      core.story({ control, cycle, values, errors }).text;
    actions.tell(cycle, variant, values, told);
    where.go("work");
  };
  const note = createNoting();
  let draw: Draw | null = null;
  let coming = false;
  const fetch = async (): Promise<void> => {
    coming = true;
    const { createStart } = await import("../start/start");
    if (stop.aborted) return;
    const practise = (): void => where.go("jog");
    draw = createStart(root, actions, {
      toWork,
      openProgram,
      again,
      practise,
      tell: way => void tell(way).catch(console.error),
    });
    store.update({});
  };
  return {
    draw(state, derived) {
      where.follow(state);
      const here = store.state.page.place === "start";
      if (here && !coming) void fetch().catch(console.error);
      show(root, here);
      show(main, store.state.page.place === "work");
      setAttribute(document.body, "data-place", store.state.page.place);
      note(state, derived);
      draw?.(state, derived);
    },
    drawButton: ({ page }) => setAttribute(button, "aria-current", page.place === "start" ? "page" : null),
  };
}
