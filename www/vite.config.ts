import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { VitePWA } from "vite-plugin-pwa";
import { answers, ask } from "./answers";
import { inOne } from "./first";
import { icons } from "./icons";
import { manifest } from "./manifest";
import { chunkOfWords, words } from "./words";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

// Relative paths everywhere (`base`), so that the folder works at any address of any static file server.
// `@pkg` is what `cargo xtask` built from Rust: core, preview-webgpu, preview-webgl.
const first = ask(here("../pkg/core"));

/** Its files, but for the lists of them. Where a page opens at a title, the address has the title's name. */
const HANDBOOK = /\/book\/([\w/-]+\.html|[\w-]+\.(js|css|svg|woff2|png))(#.*)?$/;

export default defineConfig({
  base: "./",
  resolve: { alias: { "@pkg": here("../pkg") } },
  // After the first load everything comes from the browser's store: shop networks are closed. A new version waits until
  // the user wants it (`src/state/update.ts`); only a first visit is served from the store at once.
  plugins: [
    answers(first),
    words(
      here("../core/messages"),
      here("messages"),
      first.then(({ cycle }) => cycle.cycle),
    ),
    icons(here("public/icon.svg")),
    VitePWA({
      registerType: "prompt",
      injectRegister: null,
      includeAssets: ["icon.svg"],
      workbox: {
        globPatterns: ["**/*.{html,js,css,wasm,svg,png,woff2}"],
        maximumFileSizeToCacheInBytes: 12_000_000, // of the core in the quick profile, which is twice that of `dist`
        inlineWorkboxRuntime: true,
        sourcemap: false,
        // The handbook is no part of the page and of what a first visit waits for: what is asked of it is kept
        // (`src/handbook.ts` asks for all of it), shown from there, and brought up to date behind that.
        navigateFallbackDenylist: [HANDBOOK],
        runtimeCaching: [
          {
            urlPattern: HANDBOOK,
            handler: "StaleWhileRevalidate",
            // a file is the same for whoever asks, whatever a server says: its fonts are asked for in another way
            options: { cacheName: "handbook", matchOptions: { ignoreVary: true } },
          },
        ],
        clientsClaim: true,
      },
      manifest,
    }),
  ],
  worker: { format: "es" },
  build: {
    outDir: here("../dist"),
    emptyOutDir: true,
    target: "es2022",
    assetsInlineLimit: 0, // a strict content policy allows no data: addresses
    modulePreload: { polyfill: false },
    rollupOptions: { output: { manualChunks: inOne(here("src/page/main.ts"), chunkOfWords) } },
  },
});
