// The same task on other controls, folded under the snippet: the calls side by side, what each shares with this one,
// what differs.

import { html, nothing, render } from "lit-html";
import type { Derived } from "../desk/derive";
import { el, on, show } from "../dom";
import { plain } from "../numbers";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { say, t } from "../texts";
import type { TwinView } from "../wire";
import { copyText } from "./copy";

type Copy = (text: string) => void;

const column = (control: string, cycle: string, code: string) =>
  html`<div class="twin-call">
    <h4>${`${control} · ${cycle}`}</h4>
    <pre class="twin-code" tabindex="0">${code}</pre>
  </div>`;

function there({ control, cycle, snippet, refused }: TwinView, copy: Copy) {
  return html`<div class="twin-call">
    <h4>${`${control} · ${cycle}`}</h4>
    ${
      refused
        ? html`<p class="quiet-text">${say(refused)}</p>`
        : html`<pre class="twin-code" tabindex="0">${snippet}</pre>
          <div class="actions"><button type="button" @click=${() => copy(snippet)}>${t("form-copy")}</button></div>`
    }
  </div>`;
}

function compared({ control, cycle, task, shared, differences }: TwinView) {
  const name = `${control} · ${cycle}`;
  return html`<section aria-label=${name}>
    <p class="lead">${t("twin-task", { task: say(task), cycle, control })}</p>
    <h4>${t("twin-shared")}</h4>
    <dl class="twin-shared" aria-label=${t("twin-shared")}>
      ${shared.map(({ label, value }) => html`<div><dt>${say(label)}</dt><dd>${plain(value)}</dd></div>`)}
    </dl>
    ${
      differences.length === 0
        ? nothing
        : html`<h4>${t("twin-differences")}</h4>
          <ul class="twin-differences" aria-label=${t("twin-differences")}>
            ${differences.map(one => html`<li>${say(one)}</li>`)}
          </ul>`
    }
  </section>`;
}

const all = (twins: TwinView[], here: Derived, copy: Copy) =>
  html`<div class="twin-calls">
      ${column(t(`control-${here.cycle.control}`), here.cycle.cycle, here.view.snippet)}
      ${twins.map(one => there(one, copy))}
    </div>
    ${twins.map(compared)}`;

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
      const { twins } = derived.view;
      show(root, derived.cycle.twins && derived.simulates === "yes");
      if (root.open !== state.snippet.twin) root.open = state.snippet.twin;
      show(found, !!twins?.length);
      show(none, twins?.length === 0);
      if (twins?.length)
        render(
          all(twins, derived, text => void copyText(text, store, "notice-copied")),
          found,
        );
    },
  };
}
