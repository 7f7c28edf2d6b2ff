// The page's icon as pictures, for systems that take no SVG: made from public/icon.svg with each build.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { initWasm, Resvg } from "@resvg/resvg-wasm";
import type { Plugin } from "vite";

/** What the ground of the icon is painted with. */
export const GROUND = "#14202a";

/** `margin`: around the icon, in parts of its width. `whole`: the system rounds the corners itself. */
interface Icon {
  file: string;
  size: number; // pixels
  margin: number;
  whole: boolean;
}

const ICONS: Icon[] = [
  { file: "icon-192.png", size: 192, margin: 0, whole: false },
  { file: "icon-512.png", size: 512, margin: 0, whole: false },
  // a system may cut it to a circle of 4/5 of its width
  { file: "icon-maskable-512.png", size: 512, margin: 1 / 8, whole: true },
  { file: "apple-touch-icon.png", size: 180, margin: 0, whole: true },
];

/** An icon whose view box begins at 0 0, drawn. */
function drawn(svg: string, { size, margin, whole }: Icon): Uint8Array {
  const framed = svg.replace(/viewBox="0 0 (\d+) \1"/, (_, width: string) => {
    const [around, all] = [Number(width) * margin, Number(width) * (1 + 2 * margin)];
    return `viewBox="${-around} ${-around} ${all} ${all}"`;
  });
  const ground = whole ? { background: GROUND } : {};
  const picture = new Resvg(framed, { fitTo: { mode: "width", value: size }, ...ground });
  return picture.render().asPng();
}

/** `path`: of the icon. */
export function icons(path: string): Plugin {
  const module = createRequire(import.meta.url).resolve("@resvg/resvg-wasm/index_bg.wasm");
  let ready: Promise<void> | null = null; // it begins once in a process
  return {
    name: "icons",
    async generateBundle() {
      ready ??= initWasm(readFileSync(module));
      await ready;
      const svg = readFileSync(path, "utf8");
      for (const icon of ICONS) this.emitFile({ type: "asset", fileName: icon.file, source: drawn(svg, icon) });
    },
  };
}
