// How certain the measurement of the form is: asked aside, because it measures a thousand times, and only where
// something spreads. An answer counts for its own question; until it is there, nothing is shown.

import type { Aside } from "../core/aside";
import type { Derived } from "../desk/derive";
import type { State } from "../state/state";
import type { CertaintyView, FormRequest } from "../wire";

/** Whether part or probe spread at all. */
function spreads({ part }: State, { view }: Derived): boolean {
  const { probe, part: form } = part.errors;
  const repeats = [view.setup?.probe, ...(view.setup?.toolProbes ?? [])].some(one => one?.repeatability?.[0]);
  return repeats || probe.repeatability !== 0 || form.outOfRound !== 0;
}

const isMeasured = (state: State, derived: Derived): boolean =>
  derived.simulates === "yes" &&
  state.view.source !== "program" &&
  !!derived.view.outcome?.answer?.figures.length &&
  spreads(state, derived);

/** Adds to what is shown how certain it is, and asks for that. */
export function createCertain(aside: Aside): (state: State, derived: Derived) => Derived {
  let written: { form: FormRequest; asked: string } | null = null;
  let known: { asked: string; view: CertaintyView | null } | null = null;
  return (state, derived) => {
    const answered = aside.take();
    if (answered?.question.ask === "certainty") {
      const view = answered.json === undefined ? null : (JSON.parse(answered.json) as CertaintyView);
      known = { asked: answered.question.asked, view };
    }
    if (!isMeasured(state, derived)) return derived;
    if (written?.form !== derived.asked)
      written = { form: derived.asked, asked: JSON.stringify({ form: derived.asked }) };
    const { asked } = written;
    if (known?.asked === asked) return { ...derived, certain: known.view };
    aside.want({ ask: "certainty", control: derived.cycle.control, text: "", asked });
    return derived;
  };
}
