import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";
import { VitePWA } from "vite-plugin-pwa";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

// What is asked for only when the form stands comes in a part of its own: help, cures, search words and results of the
// core, and all that measuring, running, alarms and machine data say. The page's own words stand from the start.
const LATER_WORDS = /^([a-z0-9-]+-(help|hint|words)|result-[a-z0-9-]+) =/;
const LATER_FILES = /\/core\/messages\/[^/]+\/(advice|alarms|changes|datum|evaluate|lists|run|setup|syntax|twin)\.ftl$/;

/** The messages of a file (`?first`, `?later`), each with its attributes. */
function partsOfWords(): Plugin {
  return {
    name: "parts-of-words",
    enforce: "pre",
    load(id) {
      const [path = "", part] = id.split("?");
      if (!path.endsWith(".ftl") || (part !== "first" && part !== "later")) return null;
      const messages = readFileSync(path, "utf8")
        .split(/\n(?=[a-z#]|$)/)
        .filter(message => /^[a-z]/.test(message));
      const isLater = (message: string): boolean =>
        LATER_FILES.test(path) || (path.includes("/core/") && LATER_WORDS.test(message));
      const wanted = messages.filter(message => isLater(message) === (part === "later"));
      return `export default ${JSON.stringify(wanted.join("\n"))}`;
    },
  };
}

// Relative paths everywhere (`base`), so that the folder works at any address of any static file server.
// `@pkg` is what `cargo xtask` built from Rust: core, program, preview-webgpu, preview-webgl.
export default defineConfig({
  base: "./",
  resolve: { alias: { "@pkg": here("../pkg") } },
  // After the first load everything comes from the browser's store: shop networks are closed.
  // `script`: registered by a file of its own, the content policy allows no inline script.
  plugins: [
    partsOfWords(),
    VitePWA({
      registerType: "autoUpdate",
      injectRegister: "script-defer",
      includeAssets: ["icon.svg"],
      workbox: {
        globPatterns: ["**/*.{html,js,css,wasm,svg}"],
        maximumFileSizeToCacheInBytes: 8_000_000,
        inlineWorkboxRuntime: true,
        sourcemap: false,
        clientsClaim: true,
        skipWaiting: true,
      },
      manifest: {
        name: "Probewright",
        short_name: "Probewright",
        start_url: "./",
        scope: "./",
        display: "standalone",
        background_color: "#eceff1",
        theme_color: "#14202a",
        icons: [{ src: "icon.svg", sizes: "any", type: "image/svg+xml", purpose: "any" }],
      },
    }),
  ],
  worker: { format: "es" },
  build: {
    outDir: here("../dist"),
    emptyOutDir: true,
    target: "es2022",
    assetsInlineLimit: 0, // a strict content policy allows no data: addresses
    modulePreload: { polyfill: false },
    // A language in one piece; English comes with the page, in two parts; help pages by themselves, when one is opened.
    rollupOptions: {
      output: {
        manualChunks: id => {
          const [, language, name, part] = /\/messages\/([^/]+)\/([^/]+)\.ftl\?(\w+)/.exec(id) ?? [];
          if (language && name?.startsWith("help")) return `help-${language}`;
          if (language === "en") return part === "later" ? "words-en-later" : undefined;
          return language ? `words-${language}` : undefined;
        },
      },
    },
  },
});
