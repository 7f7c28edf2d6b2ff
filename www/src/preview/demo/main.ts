// Page for the browser test: shows a fixed scene and says which way of drawing came.
// ?scene=shapes: every shape. ?theme=dark. The test reads `window.preview` and `window.picked`.
import init, * as program from "@pkg/core/core.js";
import { createPreview, DARK, LIGHT, type Preview } from "../view";
import { hole, shapes } from "./scenes";

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
  await init();
  preview.setScene(query.get("scene") === "shapes" ? shapes(program) : hole(program));
  preview.onPick(entry => {
    window.picked = entry;
  });
  window.preview = preview;
}
