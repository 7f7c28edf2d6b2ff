// The same task on the other control, folded under the snippet: both calls side by side, what they share, what differs.

import { html, render } from "lit-html";
import type { Derived } from "../desk/derive";
import { el, on, show } from "../dom";
import { plain } from "../numbers";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { say, t } from "../texts";
import type { TwinView } from "../wire";
import { copyText } from "./copy";

const column = (control: string, cycle: string, code: string) =>
  html`<div class="twin-call">
    <h4>${`${t(`control-${control}`)} · ${cycle}`}</h4>
    <pre class="twin-code" tabindex="0">${code}</pre>
  </div>`;

function both({ control, cycle, task, snippet, shared, differences }: TwinView, here: Derived, copy: () => void) {
  return html`<p class="lead">${t("twin-task", { task: say(task), cycle })}</p>
    <div class="twin-calls">
      ${column(here.cycle.control, here.cycle.cycle, here.view.snippet)}${column(control, cycle, snippet)}
    </div>
    <div class="actions"><button type="button" @click=${copy}>${t("form-copy")}</button></div>
    <h4>${t("twin-shared")}</h4>
    <dl class="twin-shared" aria-label=${t("twin-shared")}>
      ${shared.map(({ label, value }) => html`<div><dt>${say(label)}</dt><dd>${plain(value)}</dd></div>`)}
    </dl>
    <h4>${t("twin-differences")}</h4>
    <ul class="twin-differences" aria-label=${t("twin-differences")}>
      ${differences.map(one => html`<li>${say(one)}</li>`)}
    </ul>`;
}

/** Asked for only while it is unfolded. */
export function createTwin(store: Store): { root: HTMLElement; draw(state: State, derived: Derived): void } {
  const found = el("div");
  const none = el("p", { class: "quiet-text" }, t("twin-none"));
  const head = el("summary", {}, t("twin-open"));
  const root = el("details", { class: "twin" }, head, found, none);

  // The browser tells an unfolding only later: what is drawn meanwhile would fold it again.
  on(head, "click", event => {
    event.preventDefault();
    store.update(state => ({ snippet: { twin: !state.snippet.twin } }));
  });

  return {
    root,
    draw(state, derived) {
      const { twin } = derived.view;
      show(root, derived.cycle.twins && derived.simulates === "yes");
      if (root.open !== state.snippet.twin) root.open = state.snippet.twin;
      show(found, !!twin);
      show(none, twin === null);
      if (twin)
        render(
          both(twin, derived, () => void copyText(twin.snippet, store, "notice-copied")),
          found,
        );
    },
  };
}
