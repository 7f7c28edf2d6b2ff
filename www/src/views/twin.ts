// The same task on the other control, folded under the snippet: both calls side by side, what they share, what differs.

import type { Derived } from "../derive";
import { el, keyed, on, setText, show } from "../dom";
import { plain } from "../numbers";
import type { State } from "../state";
import type { Store } from "../store";
import { say, t } from "../texts";
import type { TwinView } from "../wire";
import { copyText } from "./copy";

function column(): { root: HTMLElement; name: HTMLElement; code: HTMLElement } {
  const name = el("h4", {});
  const code = el("pre", { class: "twin-code", tabindex: "0" });
  return { root: el("div", { class: "twin-call" }, name, code), name, code };
}

/** Asked for only while it is unfolded. */
export function createTwin(store: Store): { root: HTMLElement; draw(state: State, derived: Derived): void } {
  const [here, there] = [column(), column()];
  const copy = el("button", { type: "button" }, t("form-copy"));
  const task = el("p", { class: "lead" });
  const shared = el("dl", { class: "twin-shared", "aria-label": t("twin-shared") });
  const differences = el("ul", { class: "twin-differences", "aria-label": t("twin-differences") });
  const calls = el("div", { class: "twin-calls" }, here.root, there.root);
  const found = el(
    "div",
    {},
    task,
    calls,
    el("div", { class: "actions" }, copy),
    el("h4", {}, t("twin-shared")),
    shared,
    el("h4", {}, t("twin-differences")),
    differences,
  );
  const none = el("p", { class: "quiet-text" }, t("twin-none"));
  const head = el("summary", {}, t("twin-open"));
  const root = el("details", { class: "twin" }, head, found, none);
  let text = "";

  // The browser tells an unfolding only later: what is drawn meanwhile would fold it again.
  on(head, "click", event => {
    event.preventDefault();
    store.update(state => ({ snippet: { twin: !state.snippet.twin } }));
  });
  on(copy, "click", () => void copyText(text, store, "notice-copied"));

  const fill = (twin: TwinView, { cycle, view }: Derived): void => {
    text = twin.snippet;
    setText(task, t("twin-task", { task: say(twin.task), cycle: twin.cycle }));
    setText(here.name, `${t(`control-${cycle.control}`)} · ${cycle.cycle}`);
    setText(here.code, view.snippet);
    setText(there.name, `${t(`control-${twin.control}`)} · ${twin.cycle}`);
    setText(there.code, twin.snippet);
    keyed(
      shared,
      twin.shared,
      one => one.label.key,
      () => el("div", {}, el("dt", {}), el("dd", {})),
      (node, one) => {
        const [label, value] = node.children as unknown as [HTMLElement, HTMLElement];
        setText(label, say(one.label));
        setText(value, plain(one.value));
      },
    );
    keyed(
      differences,
      twin.differences,
      one => one.key,
      () => el("li", {}),
      (node, one) => setText(node, say(one)),
    );
  };

  return {
    root,
    draw(state, derived) {
      const { cycle, view } = derived;
      show(root, cycle.twins && derived.simulates === "yes");
      if (root.open !== state.snippet.twin) root.open = state.snippet.twin;
      show(found, !!view.twin);
      show(none, view.twin === null);
      if (view.twin) fill(view.twin, derived);
    },
  };
}
