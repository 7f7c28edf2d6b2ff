import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { VitePWA } from "vite-plugin-pwa";
import { chunkOfWords, words } from "./words";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

// Relative paths everywhere (`base`), so that the folder works at any address of any static file server.
// `@pkg` is what `cargo xtask` built from Rust: core, program, preview-webgpu, preview-webgl.
export default defineConfig({
  base: "./",
  resolve: { alias: { "@pkg": here("../pkg") } },
  // After the first load everything comes from the browser's store: shop networks are closed.
  // `script`: registered by a file of its own, the content policy allows no inline script.
  plugins: [
    words(here("../core/messages"), here("messages")),
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
    rollupOptions: { output: { manualChunks: chunkOfWords } },
  },
});
