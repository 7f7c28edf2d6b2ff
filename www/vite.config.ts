import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

// Relative paths everywhere (`base`), so that the folder works at any address of any static file server.
// `@pkg` is what `cargo xtask` built from Rust: core, preview-webgpu, preview-webgl.
export default defineConfig({
  base: "./",
  resolve: { alias: { "@pkg": here("../pkg") } },
  build: {
    outDir: here("../dist"),
    emptyOutDir: true,
    target: "es2022",
    assetsInlineLimit: 0,      // a strict content policy allows no data: addresses
    modulePreload: { polyfill: false },
  },
});
