// The rooms of the page's sources import downwards only, types too. Circles between files are Biome's (noImportCycles).
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join, normalize } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../../www/src/", import.meta.url));
// From the bottom to the top; the files of `src` itself are the ground.
const ROOMS = [
  ...[".", "core", "editor", "preview", "state", "scan", "desk", "search", "book", "start", "scenarios"],
  ...["views", "jog", "page"],
];

const files = readdirSync(root, { recursive: true }).filter(name => name.endsWith(".ts"));
const roomOf = file => (file.includes("/") ? file.split("/")[0] : ".");

/** What a file imports of the page, as paths below `src`. */
function imports(file) {
  const text = readFileSync(join(root, file), "utf8");
  const found = text.matchAll(/(?:from|import|import\(|new URL\()\s*"(\.[^"]+)"/g);
  return [...found].map(([, path]) => normalize(join(dirname(file), path))).filter(path => !path.startsWith(".."));
}

// oracle: hand (the order is that of ARCHITECTURE.md)
test("no room names a higher one, and none is missing in the order", () => {
  assert.ok(files.length > 90, "the sources are found");
  assert.deepEqual([...new Set(files.map(roomOf))].sort(), [...ROOMS].sort());
  const height = file => ROOMS.indexOf(roomOf(file));
  const upwards = files.flatMap(file =>
    imports(file)
      .filter(path => !path.startsWith("styles/") && height(path) > height(file))
      .map(path => `${file} imports ${path}`),
  );
  assert.deepEqual(upwards, []);
});

// oracle: hand
test("what is looked at is all that is imported", () => {
  assert.ok(imports("page/app.ts").includes("views/broken"), "static imports");
  assert.ok(imports("page/modules.ts").includes("core/program"), "dynamic imports");
});
