// Page for the browser test: shows a fixed trace and says which way of drawing came.
// ?scene=shapes: every shape. ?theme=dark. The test reads `window.preview` and `window.picked`.
import { createPreview, DARK, LIGHT, type Preview } from "../view";
import { hole, shapes } from "./trace";

declare global {
  interface Window {
    preview?: Preview;
    picked?: number;
  }
}

const query = new URLSearchParams(location.search);
const colours = query.get("theme") === "dark" ? DARK : LIGHT;
const host = document.querySelector<HTMLElement>("#view");

if (host) {
  document.body.style.background = colours.background;
  const preview = await createPreview(host, {
    label: "3D view",
    colours,
    onBackend: name => {
      document.documentElement.dataset.backend = name;
    },
  });
  preview.setTrace(query.get("scene") === "shapes" ? shapes : hole);
  preview.onPick(entry => {
    window.picked = entry;
  });
  window.preview = preview;
}
