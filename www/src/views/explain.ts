// The strip between drawing and fields: what the cycle does, or what the focused field means. It keeps its height, so
// that no field moves; a longer text unfolds over the fields.

import { el, on, setAttribute, setText, show } from "../dom";
import { glossed, hasTerms } from "../glossary";
import { meantBy } from "../keys";
import { say, t } from "../texts";
import type { Field } from "../wire";
import { needText } from "./field";

export interface Explain {
  root: HTMLElement;
  draw(cycle: string, field: Field | undefined): void;
}

/** `background`: shows the concept that explains the field. */
export function createExplain(background: (concept: string) => void): Explain {
  const about = el("p", { class: "lead" });
  const named = el("strong", {});
  const code = el("code", {});
  const told = el("span", {});
  const concept = el("button", { type: "button", class: "explain-concept", hidden: true }, t("explain-concept"));
  concept.title = t("explain-concept-hint");
  const explained = el("p", { class: "lead" }, named, " ", code, " ", concept, " ", told);
  const text = el("div", { class: "explain-text", id: "explain-text" }, about, explained);
  const more = el("button", { type: "button", class: "explain-more", hidden: true, "aria-controls": "explain-text" });
  const root = el("div", { class: "explain" }, text, more);
  let open = false;
  let topic = "";

  const unfold = (now: boolean): void => {
    open = now;
    root.classList.toggle("unfolded", open);
    setText(more, t(open ? "explain-less" : "explain-more"));
    setAttribute(more, "aria-expanded", String(open));
  };
  const fit = (): void => show(more, open || text.scrollHeight > root.clientHeight + 1);
  const sizes = new ResizeObserver(fit);
  for (const part of [root, about, explained]) sizes.observe(part);
  on(more, "click", () => {
    unfold(!open);
    fit();
  });
  on(concept, "click", () => background(topic));
  on(root, "keydown", event => {
    if (meantBy(event, "page") !== "close" || !open) return;
    unfold(false);
    fit();
  });
  unfold(false);

  let shown = "";
  let helped = "";
  let marks = false; // whether terms could be marked when it was drawn
  return {
    root,
    draw(cycle, field) {
      const what = field?.name ?? cycle;
      if (what !== shown && open) unfold(false);
      shown = what;
      setText(about, cycle);
      show(about, !field && cycle !== "");
      show(explained, !!field);
      if (!field) return;
      topic = field.concept ?? "";
      show(concept, topic !== "");
      setText(named, say(field.label));
      setText(code, field.name);
      const source = field.source && t("field-source", { source: field.source });
      const argument = field.argument ? say(field.argument) : "";
      const text = [say(field.help), needText(field), argument, source].filter(Boolean).join(" ");
      if (text === helped && marks === hasTerms()) return;
      helped = text;
      marks = hasTerms();
      told.replaceChildren(...glossed(text));
    },
  };
}
