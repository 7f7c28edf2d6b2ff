// What the editor tells where the pointer rests: the core says it of the line alone.

import type { ProgramCore } from "../core/program";
import { el } from "../dom";
import type { EditorHost } from "../editor/editor";
import type { State } from "../state/state";
import { optional, say } from "../texts";

export const createTold =
  (core: () => ProgramCore | null, state: () => State): EditorHost["pointed"] =>
  (line, at) => {
    const found = core()?.pointed({ control: state().form.control, line, at });
    if (!found) return null;
    const { from, to, name, meaning, help, about } = found;
    const head = el("p", {}, el("strong", {}, name ? `${name}: ${say(meaning)}` : say(meaning)));
    const more = optional(help.key);
    const lines = [...(more ? [more] : []), ...about.map(say)];
    return { from, to, told: el("div", { class: "cm-told" }, head, ...lines.map(one => el("p", {}, one))) };
  };
