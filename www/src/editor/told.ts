// What is told of a place of the program: where the pointer rests, and by a key at the caret.

import { type EditorState, type Extension, StateEffect, StateField } from "@codemirror/state";
import {
  type Command,
  closeHoverTooltips,
  EditorView,
  hasHoverTooltips,
  hoverTooltip,
  showTooltip,
  type Tooltip,
} from "@codemirror/view";

/** What is told of a unit of a line, and of which of its units; null: nothing. */
export type Pointed = (line: string, at: number) => { from: number; to: number; told: HTMLElement } | null;

function at(state: EditorState, pointed: Pointed, place: number): Tooltip | null {
  const { from, text } = state.doc.lineAt(place);
  const found = pointed(text, place - from);
  if (!found) return null;
  return { pos: from + found.from, end: from + found.to, above: true, create: () => ({ dom: found.told }) };
}

export const underPointer = (pointed: Pointed): Extension =>
  hoverTooltip(({ state }, place) => at(state, pointed, place));

const showEffect = StateEffect.define<Tooltip | null>();

/** Until the caret moves. */
export const atCaret = StateField.define<Tooltip | null>({
  create: () => null,
  update(shown, { docChanged, selection, effects }) {
    for (const effect of effects) if (effect.is(showEffect)) return effect.value;
    return docChanged || selection ? null : shown;
  },
  provide: field => showTooltip.from(field),
});

/** Shows what is told of the place of the caret, and says it. */
export const tell =
  (pointed: Pointed): Command =>
  view => {
    const shown = at(view.state, pointed, view.state.selection.main.head);
    const effects: StateEffect<unknown>[] = [showEffect.of(shown)];
    const said = shown?.create(view).dom.textContent;
    if (said) effects.push(EditorView.announce.of(said));
    view.dispatch({ effects });
    return true;
  };

/** Takes away what is told, also under the pointer; false: there was nothing. */
export const untell: Command = view => {
  const shown = view.state.field(atCaret) !== null || hasHoverTooltips(view.state);
  if (shown) view.dispatch({ effects: [showEffect.of(null), closeHoverTooltips] });
  return shown;
};
