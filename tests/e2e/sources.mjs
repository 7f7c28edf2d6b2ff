// The sources of the page without a build: served to a browser, and loaded into Node for tests of plain functions.

import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = fileURLToPath(new URL("../../", import.meta.url));
const vite = () => import(pathToFileURL(join(root, "www/node_modules/vite/dist/node/index.js")).href);

async function server(options) {
  const { createServer } = await vite();
  return createServer({
    root: join(root, "www"),
    configFile: join(root, "www/vite.config.ts"),
    logLevel: "error",
    optimizeDeps: { noDiscovery: true, include: [] },
    ...options,
  });
}

// Serves `www/` on a free port, with these plugins of the build besides; `{ url, close }`.
export async function serve(plugins = []) {
  const started = await server({
    plugins,
    server: { host: "127.0.0.1", port: 0, hmr: false, watch: null, fs: { allow: [root] } },
  });
  await started.listen();
  return { url: started.resolvedUrls.local[0], close: () => started.close() };
}

// Loads TypeScript modules of `www/`, such as "/src/preview/camera.ts"; `{ load, close }`.
export async function modules() {
  const started = await server({ server: { middlewareMode: true, hmr: false, ws: false, watch: null } });
  return { load: path => started.ssrLoadModule(path), close: () => started.close() };
}

// The core as the page has it, in Node.
export async function program() {
  const module = await import(pathToFileURL(join(root, "pkg/core/core.js")).href);
  module.initSync({ module: await readFile(join(root, "pkg/core/core_bg.wasm")) });
  return module;
}
