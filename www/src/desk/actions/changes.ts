// What changes the program in more than one place: shown, then done or not.

import type { Diagnostic, Edit, TouchedLine } from "../../wire";
import { isRead } from "../program";
import {
  agreed,
  answeredByLeaving,
  declined,
  mended,
  proposed,
  refused,
  replacing,
  typedShown,
  withoutReplacing,
} from "../typing";
import type { Acting } from "./acting";

export interface ChangesActions {
  /** The edits that a finding of the present program proposes; shown before they are made where they reach further. */
  cure(edits: Edit[], elsewhere?: TouchedLine[]): void;
  /** What cures all findings like this one; it is shown before it is done. */
  cureAll(like: Diagnostic): void;
  /** What is shown is done. */
  apply(): void;
  /** It is not. */
  discard(): void;
  /** What was typed and changes more than its own value is shown. */
  show(): void;
  /** It is not, and the form shows again what the program holds. */
  refuse(): void;
  /** That the variable by its place in the expression of a field is assigned so that the value comes true is shown. */
  assign(name: string, variable: number): void;
  /** The value of the field takes the place of the expression. */
  replaceHere(name: string): void;
  /** The expression stays. */
  keep(name: string): void;
  /** What waits for a word is not done: the program goes elsewhere as it is. Whether there was any. */
  settle(): boolean;
}

export function createChangesActions({ store, now }: Acting): ChangesActions {
  return {
    cure(edits, elsewhere = []) {
      const state = now();
      if (!isRead(state)) return;
      if (!elsewhere.length) return store.update(mended(state, edits, "notice-mended"));
      const title = { key: "asks-title", args: { count: elsewhere.length } };
      store.update(proposed(state, { edits, title, notice: "notice-applied" }));
    },
    cureAll: ({ code, message: { key } }) => store.update({ desk: { curing: { code, key } } }),
    apply() {
      store.update(agreed);
      store.flush(); // editor and form have to hold it before the next key
    },
    discard: () => store.update(declined),
    show: () => store.update(state => (state.desk.proposed ? {} : typedShown(state))),
    refuse: () => store.update(refused),
    assign: (name, variable) =>
      store.update(state => {
        const change = replacing(state, name)?.asks.replaced.variables[variable]?.change;
        const found = replacing(state, name)?.asks.replaced.variables[variable]?.name ?? "";
        if (!change) return {};
        const title = { key: "difference-typed", args: { name: found, value: change.value } };
        const { edits, values } = change;
        return proposed(state, { edits, values, title, notice: "notice-assigned", typed: { field: name } });
      }),
    replaceHere: name =>
      store.update(state => {
        const here = replacing(state, name);
        const pending = state.desk.pending.map(one =>
          one === here ? { ...one, asks: undefined, agreed: "here" as const } : one,
        );
        return { desk: { pending } };
      }),
    keep: name => store.update(state => withoutReplacing(state, name)),
    settle() {
      store.flush(); // what was typed last
      const state = now();
      const kept = answeredByLeaving(state, true);
      store.update(kept);
      store.flush();
      return kept !== state;
    },
  };
}
