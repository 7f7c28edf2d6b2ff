// How certain each measurement of a whole program is. The program is run many times for that, so it is asked for; what
// came of it stands beside the values until the program or its machine is another.

import { createAside } from "../core/aside";
import type { ProgramCore, ProgramQuestion } from "../core/program";
import { el, on, setText, show } from "../dom";
import { guideButton } from "../guide";
import { icon } from "../icons";
import { fixed } from "../numbers";
import { say, sayProblem, t } from "../texts";
import type { Certain, RunView, WholeCertainty } from "../wire";
import type { CertainRun } from "./answer";
import { largestOf, provenOf, spokenOf, stoppedOf } from "./certain";

type Row = RunView["answers"][number];
const LOOK = 250; // ms between two looks at how far it is

/** What it needs of the page. */
export interface CertainWays {
  core(): ProgramCore | null;
  /** The open program on the machine in use; null: there is none. */
  program(): ProgramQuestion | null;
  /** What is known of all calls, for the line of the answer; null: nothing. */
  certain(known: CertainRun | null): void;
}

export interface WholeCertain {
  button: HTMLButtonElement;
  status: HTMLElement;
  /** What is known of a figure of the call in this row. */
  of(index: number, figure: string): Certain | undefined;
  known(): boolean;
  /** What decides about the row. */
  proof(index: number): Certain | undefined;
  /** The chosen row: its certainty is told in words. */
  about(index: number): void;
  /** Another run is shown: nothing is known of it. */
  forget(): void;
}

/** "±0.0040". */
export const spreadOf = (one: Certain | undefined): string => (one ? ` ±${fixed(one.expanded, one.decimals)}` : "");

/** `rows`: what is shown; `changed`: it is to be drawn anew. */
export function createWholeCertain(ways: CertainWays, rows: () => Row[], changed: () => void): WholeCertain {
  const word = el("span", {}, t("whole-certain"));
  const button = el("button", { type: "button", title: t("whole-certain-hint") }, icon("gauge"), word);
  const sum = el("span", {});
  const chosen = el("span", { class: "whole-certain-row", hidden: true });
  const status = el(
    "p",
    { class: "whole-certain", role: "status", hidden: true },
    sum,
    " ",
    chosen,
    guideButton("certainty"),
  );
  let known: WholeCertainty | null = null;
  let looking = 0;
  const report = (text: string): void => {
    setText(sum, text);
    show(status, text !== "");
  };
  const aside = createAside(() => ways.core()?.module, take);
  const over = (): void => {
    clearInterval(looking);
    setText(word, t("whole-certain"));
  };
  const proof = (index: number): Certain | undefined => known?.calls[index]?.figures.find(one => one.proof);
  /** How much of it is proven. */
  const told = ({ runs, nothing, stopped }: WholeCertainty): string => {
    if (nothing) return say(nothing);
    const judged = rows().flatMap((_, index) => proof(index)?.proof ?? []);
    const count = (which: Certain["proof"]): number => judged.filter(one => one === which).length;
    const counts = { good: count("good"), undecided: count("undecided"), bad: count("bad") };
    return [stoppedOf(stopped), t("whole-certain-told", { ...counts, runs })].filter(Boolean).join(" ");
  };
  function take(): void {
    const answered = aside.take();
    if (!answered) return;
    over();
    known = answered.json === undefined ? null : (JSON.parse(answered.json) as WholeCertainty);
    ways.certain(known && { known, answers: rows() });
    report(known ? told(known) : sayProblem(answered.problem ?? ""));
    changed();
  }
  const ask = (): void => {
    const asked = ways.program();
    if (!asked) return;
    aside.want({ ask: "whole_certainty", ...asked });
    setText(word, t("whole-certain-stop"));
    const look = (): void => report(t("whole-certain-busy", { share: Math.floor(100 * (aside.busy()?.share ?? 0)) }));
    look();
    looking = window.setInterval(look, LOOK);
  };
  const stop = (): void => {
    aside.stop();
    over();
    report("");
  };
  on(button, "click", () => (aside.busy() ? stop() : ask()));
  return {
    button,
    status,
    known: () => known !== null && known.runs > 0,
    proof,
    about(index) {
      const first = known?.calls[index]?.figures[0];
      const told = proof(index) ?? first;
      const parts = told ? [spokenOf(told), provenOf(told), largestOf(told)] : [];
      setText(chosen, told ? t("whole-certain-row", { row: index + 1, told: parts.filter(Boolean).join(" ") }) : "");
      show(chosen, !!told && !aside.busy());
    },
    of: (index, figure) => known?.calls[index]?.figures.find(one => one.name === figure),
    forget() {
      if (!known && !aside.busy() && status.hidden) return;
      known = null;
      ways.certain(null);
      show(chosen, false);
      stop();
    },
  };
}
