// One parameter is in focus, wherever it is named or drawn: at its field, in the picture, on the stage, in the code and
// at the limits. Every such place has its name as `data-field`; the picture, the stage and the editor draw theirs.

import { inFocus, type State } from "../state/state";
import type { Store } from "../state/store";
import { focusField } from "./field";

const REST = 60; // ms on the same place: what the pointer only passes is not lit

export interface Pointing {
  /** The pointer is at a place of this parameter, or at none. */
  at(name: string | null): void;
  /** To the field of a parameter. */
  choose(name: string): void;
  /** Lights what is in focus, once everything is drawn. */
  draw(state: State): void;
}

const isNode = (one: EventTarget): one is HTMLElement | SVGElement => one instanceof Element;

/** Of the innermost place that names a parameter, also within the editor. */
function named(event: Event, within = ""): string | null {
  const path = event.composedPath().filter(isNode);
  const found = path.find(one => one.dataset.field !== undefined && (!within || one.closest(within)));
  return found?.dataset.field ?? null;
}

/** Whether a pointer has moved, and not the page under it, as it does while somebody types. */
function createMoved(): (event: PointerEvent) => boolean {
  let last = [Number.NaN, Number.NaN];
  return ({ screenX, screenY }) => {
    const before = last;
    last = [screenX, screenY];
    return before[0] !== screenX || before[1] !== screenY;
  };
}

export function createPointing(store: Store): Pointing {
  let timer = 0;
  let rests: string | null = null; // where the pointer is
  let lit = new Set<Element>();
  const point = (name: string | null): void => {
    clearTimeout(timer);
    if (store.state.form.pointed !== name) store.update({ form: { pointed: name } });
  };
  const at = (name: string | null): void => {
    if (name === rests) return;
    rests = name;
    clearTimeout(timer);
    timer = window.setTimeout(() => point(name), REST);
  };
  const moved = createMoved();
  document.addEventListener("pointermove", moved);
  document.addEventListener("pointerover", event => {
    const onStage = event.target instanceof Element && event.target.closest(".stage");
    if (moved(event) && event.pointerType !== "touch" && !onStage) at(named(event));
  });
  document.documentElement.addEventListener("pointerleave", () => at(null));
  document.addEventListener("focusin", () => {
    rests = null;
    point(null);
  });
  document.addEventListener("click", event => {
    const name = named(event, ".leads");
    if (name !== null && !getSelection()?.toString()) focusField(name);
  });
  return {
    at,
    choose: focusField,
    draw(state) {
      const name = inFocus(state);
      const now = new Set(name === null ? [] : document.querySelectorAll(`[data-field="${CSS.escape(name)}"]`));
      for (const one of lit) if (!now.has(one)) one.classList.remove("lit");
      for (const one of now) one.classList.add("lit");
      lit = now;
    },
  };
}
