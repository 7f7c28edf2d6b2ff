// The page itself: what it shows where, its steps and its language.

import { speak } from "../../language";
import { stepped } from "../../state/history";
import { AT_END, type Card, firstState, type Panel, type Sheet } from "../../state/state";
import { isSettled } from "../desk";
import { takenBack } from "../typing";
import type { Acting } from "./acting";

export interface PageActions {
  panel(panel: Panel): void;
  /** How far the dock of a tablet is drawn up. */
  sheet(sheet: Sheet): void;
  card(card: Card | null): void;
  /** Shows the help page of the variant in the form, or closes it. */
  help(): void;
  /** So many steps back; forth where it is negative. */
  step(back: number): void;
  /** The page in another language, as soon as its words are there. */
  speak(language: string): void;
}

const LEFT: Panel[] = ["tasks", "form"];

export function createPageActions({ store, now }: Acting): PageActions {
  return {
    panel(panel) {
      const docked = panel === "program" || panel === "results";
      store.update({
        panels: {
          panel,
          [LEFT.includes(panel) ? "left" : "right"]: panel,
          ...(docked ? { dock: panel } : {}),
          sheet: sheetFor(panel, now().panels.sheet),
        },
      });
      store.flush(); // who shows a panel goes on in it, mostly with the focus
    },
    sheet: sheet => store.update({ panels: { sheet } }),
    card: card => store.update({ page: { card } }),
    help() {
      const closes = now().panels.right === "help";
      store.update(
        closes
          ? { panels: { panel: "form", left: "form", right: firstState().panels.right } }
          : { panels: { panel: "help", right: "help" } },
      );
      store.flush(); // the focus goes there
    },
    step(back) {
      store.flush(); // what was typed just now is a step too
      if (back > 0 && !isSettled(now()) && takenBack(now()) !== now()) {
        store.update(takenBack, { desk: { proposed: null }, page: { notice: "notice-undone", offer: false } });
        return store.flush();
      }
      const there = stepped(now(), back);
      if (!there) return;
      const page = { notice: back > 0 ? "notice-undone" : "notice-redone", offer: false };
      store.update(there, { desk: { sought: null, follow: null, proposed: null }, view: { step: AT_END }, page });
      store.flush(); // editor and form have to hold it before the next key
    },
    speak(language) {
      speak(language).then(
        () => store.update({ page: { language } }),
        () => store.update({ page: { notice: "notice-no-language" } }),
      );
    },
  };
}

/** The sheet leaves room for a panel that is wanted. */
function sheetFor(panel: Panel, sheet: Sheet): Sheet {
  const docked = panel === "program" || panel === "results";
  return (docked && sheet === "peek") || (panel === "view" && sheet === "full") ? "half" : sheet;
}
