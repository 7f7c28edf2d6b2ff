// The worked example of a first visit, told in steps.

import { NO_ERRORS } from "../../errors";
import { openedNow, type ProgramFile } from "../../state/files";
import type { State } from "../../state/state";
import { t } from "../../texts";
import type { CycleInfo } from "../../wire";
import { STEPS } from "../story";
import type { Variant } from "../variants";
import type { Acting } from "./acting";
import type { FilesActions } from "./files";
import { type FormActions, LIES_OFF } from "./form";

export interface ExampleActions {
  /**
   * The worked example is told of a variant that corrects a zero offset: `told` is the program of its values. The part
   * lies off.
   */
  tell(cycle: CycleInfo, variant: Variant, values: Record<string, string>, told: (state: State) => string): void;
  /** To a step of it, from 1; 0: it ends, and what it opened stays. */
  story(step: number): void;
}

export function createExampleActions({ store, now }: Acting, form: FormActions, files: FilesActions): ExampleActions {
  const actions: ExampleActions = {
    tell(cycle, chosen, given, told) {
      form.measure(cycle, chosen, given);
      store.update({ part: { errors: { ...NO_ERRORS, part: { ...NO_ERRORS.part, ...LIES_OFF } } } });
      const { control } = cycle;
      const file: ProgramFile = { name: t(`program-file-${control}`), encoding: "utf-8", opened: openedNow() };
      files.openProgram(told(now()), file, null);
      store.update({ desk: { sought: { call: 0 } }, page: { notice: "" } });
      actions.story(1);
    },
    story(step) {
      const telling = STEPS[step - 1];
      if (telling) store.update({ page: { story: step } }, telling.show);
      else store.update({ page: { story: 0, notice: "notice-story-left", offer: true }, view: { playing: false } });
    },
  };
  return actions;
}
