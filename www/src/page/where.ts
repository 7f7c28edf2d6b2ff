// Where on the page the reader is: at the start or at work. It is a place of the browser's history, so that Back leads
// from the form to the start, and of the address: `#measure` is the work, `#jog` the machine to practise on.

import type { PageState, State } from "../state/state";
import type { Store } from "../state/store";
import type { Flat } from "../state/stored";

type Place = PageState["place"];
const HASHES: Record<Place, string> = { start: "", work: "#measure", jog: "#jog" };

/** The place that the address names. */
const named = (): Place | undefined => (location.hash ? (location.hash === HASHES.jog ? "jog" : "work") : undefined);

/** Where a visit begins: whoever has work kept, or comes by a link, is at it. */
export function firstPlace(stored: Flat | null): Place {
  const { place } = (history.state ?? {}) as { place?: Place }; // of this place in the history, before a reload
  if (place) return place;
  return named() ?? (Number(stored?.changed ?? 0) > 0 ? "work" : "start");
}

export interface Where {
  go(place: Place): void;
  /** To be called with each state that is drawn: what is opened is shown. */
  follow(state: State): void;
}

export function createWhere(store: Store): Where {
  const first = store.state.page.place;
  const arrived = (): void => {
    const { place } = (history.state ?? {}) as { place?: Place };
    store.update({ page: { place: place ?? named() ?? first } });
  };
  addEventListener("popstate", arrived);
  const go = (place: Place): void => {
    if (store.state.page.place === place) return;
    const path = location.pathname + location.search;
    history.pushState({ place }, "", HASHES[place] || path);
    store.update({ page: { place } });
    store.flush(); // the focus goes there
  };
  let { files } = store.state.program;
  let { refused } = store.state.page;
  return {
    go,
    follow({ program, page }) {
      const opened = program.files !== files || (page.refused && page.refused !== refused);
      files = program.files;
      refused = page.refused;
      if (opened && page.place !== "work") go("work");
    },
  };
}
