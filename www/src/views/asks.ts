// What was typed and would change more than its own value: which lines elsewhere, as they are and as they would be.
// Nothing is done before all of it was shown and agreed to.

import type { Actions } from "../desk/actions";
import { unseen } from "../desk/typing";
import { el, keyed, on, setText, show } from "../dom";
import { meantBy } from "../keys";
import type { State } from "../state/state";
import { t } from "../texts";
import type { TouchedLine } from "../wire";

export interface Asks {
  root: HTMLElement;
  said: HTMLElement;
  draw(state: State): void;
  waits(): boolean;
  focus(): void;
}

/** Each line once; of several changes the last one that concerns it counts. */
function lines(state: State): TouchedLine[] {
  const all = unseen(state).flatMap(one => one.asks.lines);
  return [...new Map(all.map(one => [one.line, one])).values()].sort((a, b) => a.line - b.line);
}

function lineItem(): HTMLLIElement {
  return el(
    "li",
    {},
    el("span", { class: "asks-line" }),
    el("span", { class: "visually-hidden" }, t("asks-before")),
    el("del", {}),
    el("span", { class: "visually-hidden" }, t("asks-after")),
    el("ins", {}),
  );
}

export function createAsks(actions: Actions): Asks {
  const title = el("h3", { id: "asks-title" });
  const said = el("p", { class: "visually-hidden", role: "status" }); // there before it says something
  const list = el("ul", {});
  const look = el("button", { type: "button", class: "primary" }, t("asks-show"));
  const cancel = el("button", { type: "button" }, t("asks-cancel"));
  const root = el(
    "section",
    { class: "asks", "aria-labelledby": "asks-title", hidden: true },
    title,
    list,
    el("div", { class: "actions" }, look, cancel),
  );
  on(look, "click", actions.show);
  on(cancel, "click", actions.refuse);
  on(root, "keydown", event => {
    if (meantBy(event, "form") === "refuse") actions.refuse();
  });
  return {
    root,
    said,
    waits: () => !root.hidden,
    focus: () => look.focus(),
    draw(state) {
      const all = lines(state);
      const waits = unseen(state).length > 0;
      const came = root.hidden && waits;
      show(root, waits);
      // it takes room from the fields
      if (came) document.activeElement?.closest(".field")?.scrollIntoView({ block: "nearest" });
      const text = all.length ? t("asks-title", { count: all.length }) : waits ? t("asks-more") : "";
      setText(title, text);
      setText(said, text);
      keyed(
        list,
        all,
        one => String(one.line),
        lineItem,
        (node, one) => {
          const [line, , before, , after] = node.children as unknown as [
            HTMLElement,
            HTMLElement,
            HTMLElement,
            HTMLElement,
            HTMLElement,
          ];
          setText(line, t("asks-line", { line: one.line }));
          setText(before, one.before);
          setText(after, one.after);
        },
      );
    },
  };
}
