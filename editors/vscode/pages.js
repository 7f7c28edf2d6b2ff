// The page for the form: a folder of files, served to this machine alone under an address that nobody can guess. A
// frame of its own origin is what it needs: workers, storage and its content policy are those of any other place.
const { createServer } = require("node:http");
const { createReadStream } = require("node:fs");
const { stat } = require("node:fs/promises");
const { randomBytes } = require("node:crypto");
const { extname, join, normalize, sep } = require("node:path");

const TYPES = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
  ".woff2": "font/woff2",
};
const LEFT_OUT = ["sw.js"]; // the page is at hand without it, and its address is another one with each start

/** The file that an address names; null: none. */
function fileOf(folder, secret, url) {
  let path;
  try {
    path = decodeURIComponent(new URL(url, "http://localhost").pathname);
  } catch {
    return null;
  }
  if (!path.startsWith(`/${secret}/`)) return null;
  const name = path.slice(secret.length + 2) || "index.html";
  const file = normalize(join(folder, name));
  return file.startsWith(folder + sep) && !LEFT_OUT.includes(name) && !name.includes("\0") ? file : null;
}

/** Serves the folder until `close`; gives back where. */
async function serve(folder) {
  const secret = randomBytes(16).toString("hex");
  const server = createServer(async (asked, answer) => {
    const local = /^(127\.0\.0\.1|localhost)(:\d+)?$/.test(asked.headers.host ?? "");
    const file = local && asked.method === "GET" ? fileOf(normalize(folder), secret, asked.url ?? "") : null;
    const found = file && (await stat(file).catch(() => null));
    if (!found?.isFile()) return answer.writeHead(404).end();
    const type = TYPES[extname(file)] ?? "application/octet-stream";
    answer.writeHead(200, { "Content-Type": type, "X-Content-Type-Options": "nosniff", "Cache-Control": "no-store" });
    createReadStream(file)
      .on("error", () => answer.destroy())
      .pipe(answer);
  });
  await new Promise((resolve, reject) => server.once("error", reject).listen(0, "127.0.0.1", resolve));
  const { port } = server.address();
  return { port, path: `/${secret}/`, close: () => server.close() };
}

module.exports = { serve };
