// Everything that can happen. Views call these; only these change what is kept.

import type { ProgramCore } from "../core/program";
import type { Store } from "../state/store";
import type { Catalogue } from "../wire";
import { createActing } from "./actions/acting";
import { type CallsActions, createCallsActions } from "./actions/calls";
import { type ChangesActions, createChangesActions } from "./actions/changes";
import { createExampleActions, type ExampleActions } from "./actions/example";
import { createFilesActions, type FilesActions } from "./actions/files";
import { createFormActions, type FormActions } from "./actions/form";
import { createMachineActions, type MachineActions } from "./actions/machine";
import { createPageActions, type PageActions } from "./actions/page";
import { createSetsActions, type SetsActions } from "./actions/sets";

export interface Actions
  extends FormActions,
    MachineActions,
    FilesActions,
    CallsActions,
    ChangesActions,
    SetsActions,
    ExampleActions,
    PageActions {}

export function createActions(store: Store, catalogue: Catalogue, core: () => ProgramCore | null): Actions {
  const acting = createActing(store, catalogue, core);
  const form = createFormActions(acting);
  const machine = createMachineActions(acting, form);
  const files = createFilesActions(acting, machine);
  return {
    ...form,
    ...machine,
    ...files,
    ...createCallsActions(acting),
    ...createChangesActions(acting),
    ...createSetsActions(acting),
    ...createExampleActions(acting, form, files),
    ...createPageActions(acting),
  };
}
