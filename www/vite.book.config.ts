import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

// Of the handbook, whose pages are without state: the system's wish is the theme.
const WISHES = { dark: "prefers-color-scheme: dark", contrast: "prefers-contrast: more" };

/** The themes of the page's tokens as what the system wishes. */
function systemThemes(): Plugin {
  return {
    name: "system-themes",
    enforce: "pre",
    transform(code, id) {
      if (!id.endsWith("/styles/tokens.css")) return null;
      let made = code;
      for (const [theme, wish] of Object.entries(WISHES)) {
        const before = made;
        const block = new RegExp(`:root\\[data-theme="${theme}"\\] (\\{[^{}]*\\})`);
        made = made.replace(block, (_, rules: string) => `@media (${wish}) { :root ${rules} }`);
        if (made === before) this.error(`tokens.css has no theme ${theme}`);
      }
      return made;
    },
  };
}

// Script, style and type of the handbook, for `cargo xtask book`: one of each, with names that its pages know, and no
// module, which a browser would not load from a disk.
export default defineConfig({
  root: here("src/book"),
  base: "./",
  publicDir: false,
  plugins: [systemThemes()],
  build: {
    emptyOutDir: true,
    target: "es2022",
    assetsInlineLimit: 0, // a strict content policy allows no data: addresses
    cssCodeSplit: false,
    modulePreload: false,
    rollupOptions: {
      input: here("src/book/main.ts"),
      output: {
        format: "iife",
        entryFileNames: "book.js",
        assetFileNames: ({ names }) => (names.some(name => name.endsWith(".css")) ? "book.css" : "[name][extname]"),
      },
    },
  },
});
