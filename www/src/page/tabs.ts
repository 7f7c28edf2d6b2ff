// The page open in several tabs of one browser: a new one asks the others for their work. They answer each other
// directly; what is kept has no part in that.

import { AT_END, NOBODY, type OtherWork, type State, workName } from "../state/state";
import type { Store } from "../state/store";
import { type Flat, kept, work } from "../state/stored";
import type { Choices } from "../views/continuing";

/** `from`, `to`: of which tab and for which. */
type Message =
  | { is: "question"; from: string }
  | { is: "answer"; to: string; other: OtherWork }
  | { is: "wish"; to: string; from: string }
  | { is: "copy"; to: string; work: Flat };

const PATIENCE = 2000; // ms for the copy, before that tab counts as closed

/** `asks`: the tab is new; `begun`: the state that it has with this work, or with none. */
export function createTabs(store: Store, asks: boolean, begun: (stored: Flat | null) => Promise<State>): Choices {
  const me = Math.random().toString(36).slice(2);
  const channel = new BroadcastChannel("probewright-1");
  const send = (message: Message): void => channel.postMessage(message);
  const { changed } = store.state.page;
  let asking = asks; // until it is answered once

  const drop = (from: string): void =>
    store.update(({ page: { others } }) => ({ page: { others: others.filter(one => one.from !== from) } }));
  const stay = (): void => {
    asking = false;
    store.update({ page: { others: NOBODY } });
  };
  const start = async (stored: Flat | null): Promise<void> => {
    const state = await begun(stored);
    store.update(work(state), {
      program: { reading: null, saved: state.program.saved, cursor: 0, line: 1 },
      desk: { sought: state.desk.sought, follow: null },
      run: { done: null },
      view: { step: AT_END },
      page: { changed: state.page.changed },
      history: { past: [], future: [], texts: {} }, // what this tab showed before was nobody's step
    });
    stay();
  };
  const hear = (message: Message): void => {
    const { state } = store;
    if (message.is === "question") {
      const other = { from: me, changed: state.page.changed, name: workName(state) };
      if (other.changed) send({ is: "answer", to: message.from, other });
    } else if (message.to !== me) return;
    else if (message.is === "wish") send({ is: "copy", to: message.from, work: kept(state) });
    else if (!asking || state.page.changed !== changed)
      return; // who works here has answered by that
    else if (message.is === "copy") void start(message.work);
    else store.update({ page: { others: [...state.page.others, message.other] } });
  };
  channel.onmessage = ({ data }: MessageEvent<Message>) => hear(data);
  if (asking) send({ is: "question", from: me });
  return {
    take({ from }) {
      send({ is: "wish", to: from, from: me });
      setTimeout(() => drop(from), PATIENCE);
    },
    startAnew: () => void start(null),
    stay,
  };
}
