// The 3D view with its timeline. The drawing itself is loaded when it is first shown.

import type { Derived } from "../derive";
import { el, on, setAttribute, setText, show } from "../dom";
import type { State } from "../state";
import type { Store } from "../store";
import { t } from "../texts";
import { createTimeline } from "./timeline";

const SOURCES = ["form", "program"] as const;

export function createScene(root: HTMLElement, store: Store, goToLine: (line: number) => void): (state: State, derived: Derived) => void {
  const segments = el("div", { class: "segments", role: "group", "aria-label": t("view-source") });
  const buttons = SOURCES.map((source) => {
    const button = el("button", { type: "button" }, t(`view-${source}`));
    on(button, "click", () => store.update({ source, step: 0, playing: false }));
    segments.append(button);
    return { source, button };
  });
  const tools = el("div", { class: "head-actions" });
  const stage = el("div", { class: "stage" });
  const note = el("p", { class: "empty", role: "status" }, t("view-loading"));
  const timeline = el("div", { class: "timeline", role: "group", "aria-label": t("timeline-scrub") });
  root.append(el("header", { class: "panel-head" }, el("h2", {}, t("view-title")), segments, tools), note, stage, timeline);
  const drawTimeline = createTimeline(timeline, store, goToLine);

  return (state, derived) => {
    for (const { source, button } of buttons) setAttribute(button, "aria-pressed", String(source === state.source));
    setText(note, derived.trace ? "" : t("view-empty"));
    show(note, !derived.trace);
    drawTimeline(state, derived);
  };
}
