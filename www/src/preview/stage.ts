// The element that holds the picture and its letters, and what a key or a screen reader meets.
import type { Viewport } from "./camera";

export function makeStage(host: HTMLElement, label: string): HTMLElement {
  const stage = document.createElement("div");
  stage.tabIndex = 0;
  stage.setAttribute("role", "application");
  stage.setAttribute("aria-label", label);
  Object.assign(stage.style, {
    position: "relative",
    width: "100%",
    height: "100%",
    overflow: "hidden",
    userSelect: "none",
  });
  host.append(stage);
  return stage;
}

/** CSS pixels. To ask for it lays out the page: keep it while nothing was resized. */
export function sizeOf(stage: HTMLElement): Viewport {
  return { width: Math.max(1, stage.clientWidth), height: Math.max(1, stage.clientHeight) };
}

/** Calls back when the size is another; ends with the returned function. */
export function watchSize(stage: HTMLElement, resized: (size: Viewport) => void): () => void {
  const sizes = new ResizeObserver(() => resized(sizeOf(stage)));
  sizes.observe(stage);
  return () => sizes.disconnect();
}
