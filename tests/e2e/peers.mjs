// The same generated programs in Probewright and in its peers, in turns; `cargo xtask bench --peers` runs it. Prints
// a table of both figures and their ratio, Probewright's over the peer's; fails only when one of them does.
// PROBEWRIGHT_PROGRAM: the terminal program; PEER_PREVIEW: where npm put the one that draws; PEER_PYTHON: a Python that
// has the one that runs. Memory is told by systems like Unix only.
import { spawn } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { launch } from "./browser.mjs";
import { allDrawn, showMotions, written } from "./motions.mjs";
import { serve } from "./sources.mjs";

const { PROBEWRIGHT_PROGRAM = "", PEER_PREVIEW = "", PEER_PYTHON = "" } = process.env;
const FRAMES = 10;
const TURN = 6; // CSS pixels of a drag between two frames
const SEGMENTS = [90_000, 1_000_000];
const BLOCKS = [100_000, 1_000_000];
const TRIES = 3; // of a run; the quickest counts

const row = (name, cells) => console.log(name.padEnd(46), ...cells.map(cell => String(cell).padStart(13)));
function compare(name, own, peer, digits = 2) {
  const ratio = own && peer ? (own / peer).toFixed(2) : "–";
  row(name, [own?.toFixed(digits) ?? "failed", peer?.toFixed(digits) ?? "failed", ratio]);
}

// Preview

/**
 * Milliseconds that each frame takes while the view is turned, and until every segment is drawn once it rests; how many
 * ms it takes to run the program and draw it, and how many motions the run keeps.
 */
async function ours(page, url, count) {
  await page.goto(`${url}preview-test.html`);
  await page.waitForFunction(() => window.preview);
  await showMotions(page, count);
  await allDrawn(page, count);
  const turned = await page.evaluate(turnedIn, [FRAMES, TURN]);
  const [loaded, motions] = await page.evaluate(loadedIn, written(count));
  await allDrawn(page, motions);
  return { ...turned, loaded, motions };
}

async function turnedIn([frames, turn]) {
  const { preview } = window;
  const stage = document.querySelector("[role=application]");
  const soon = () => new Promise(resolve => setTimeout(resolve));
  const times = [];
  for (let n = 0; n < frames; n++) {
    const begun = performance.now();
    preview.turn(turn, 1);
    await new Promise(requestAnimationFrame);
    do await soon();
    while (preview.drawing);
    times.push(performance.now() - begun);
  }
  delete stage.dataset.motions;
  const rests = performance.now();
  while (!stage.dataset.motions) await soon();
  return { times, whole: performance.now() - rests };
}

async function loadedIn(text) {
  const { loadProgramCore, runInPieces } = await import(new URL("src/core/program.ts", location.href).href);
  await loadProgramCore();
  const question = { ask: "run", control: "sinumerik", text, times: 1, known: false };
  const begun = performance.now();
  const { scene } = await runInPieces(question, async () => undefined);
  window.preview.setScene(scene);
  await new Promise(requestAnimationFrame);
  while (window.preview.drawing) await new Promise(resolve => setTimeout(resolve));
  return [performance.now() - begun, scene.path.motions];
}

/** The same of gcode-preview, with lines of one pixel as ours. */
async function theirs(page, url, count) {
  await page.goto(`${url}peer/`);
  return page.evaluate(
    async ([text, frames, turn]) => {
      const { init } = await import("gcode-preview");
      const canvas = document.querySelector("canvas");
      const begun = performance.now();
      const preview = init({ canvas, nonTravelMoves: ["G1"], renderTravel: true });
      const gl = preview.renderer.getContext();
      const shown = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      preview.processGCode(text);
      shown();
      const loaded = performance.now() - begun;
      cancelAnimationFrame(preview.animationFrameId);
      const times = [];
      for (let n = 0; n < frames; n++) {
        const begun = performance.now();
        preview.camera.position.applyAxisAngle(preview.camera.up, 0.008 * turn);
        preview.controls.update();
        preview.renderer.render(preview.scene, preview.camera);
        shown();
        await new Promise(requestAnimationFrame); // the page shows it, as it does ours
        times.push(performance.now() - begun);
      }
      return { times, loaded };
    },
    [written(count).replaceAll("N10 ", ""), FRAMES, TURN], // it reads no block numbers
  );
}

/** The peer beside our sources: one server, so that both get their modules the same way. */
const PEER_PAGE = `<!doctype html><script type="importmap">{"imports": {
  "gcode-preview": "/peer/gcode-preview/dist/gcode-preview.es.js",
  "three": "/peer/three/build/three.module.js",
  "lil-gui": "/peer/lil-gui/dist/lil-gui.esm.js"
}}</script><style>html, body { margin: 0; height: 100% } canvas { width: 100%; height: 100% }</style><canvas></canvas>`;

const peer = {
  name: "peer",
  configureServer(server) {
    server.middlewares.use("/peer", async (request, response) => {
      const path = request.url.split("?")[0];
      const page = path === "/";
      response.setHeader("Content-Type", page ? "text/html" : "text/javascript");
      try {
        response.end(page ? PEER_PAGE : await readFile(join(PEER_PREVIEW, path)));
      } catch {
        response.statusCode = 404;
        response.end();
      }
    });
  },
};

const middle = times => times.toSorted((a, b) => a - b)[times.length >> 1];

async function preview() {
  const site = await serve([peer]);
  const browser = await launch("webgl2"); // the peer has no other way; the same software or card draws both
  row("", ["Probewright", "gcode-preview", "ratio"]);
  try {
    for (const count of SEGMENTS) {
      const visit = async look => {
        const page = await browser.newPage({ viewport: { width: 1000, height: 700 } });
        try {
          return await look(page, site.url, count);
        } catch (problem) {
          console.error(`${look.name}, ${count}: ${problem.message}`);
          return null;
        } finally {
          await page.close();
        }
      };
      const [own, other] = [await visit(ours), await visit(theirs)];
      const name = `${count} segments`;
      compare(`${name}: a frame while it turns, ms`, own && middle(own.times), other && middle(other.times), 0);
      compare(`${name}: loaded, s`, own && own.loaded / 1000, other && other.loaded / 1000);
      if (own) row(`${name}: all of them, once it rests, ms`, [own.whole.toFixed(0), "", ""]);
      if (own) row(`${name}: motions that the run keeps`, [own.motions, "", ""]);
    }
  } finally {
    await browser.close();
    await site.close();
  }
}

// Run

/** Seconds and MB that a command takes at most, with its children. */
function measured(command, args) {
  return new Promise(resolve => {
    const watched = ["-c", WATCH, command, ...args];
    const child = spawn(PEER_PYTHON, watched, { stdio: ["ignore", "pipe", "inherit"] });
    let said = "";
    child.stdout.on("data", data => {
      said += data;
    });
    child.on("error", () => resolve(null));
    child.on("close", code => resolve(code === 0 ? JSON.parse(said) : null));
  });
}

// What a process took is told to the one that waited for it.
const WATCH = `
import json, resource, subprocess, sys, time
begun = time.monotonic()
done = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
megabyte = 1024 if sys.platform == "linux" else 1024 ** 2
print(json.dumps({"seconds": time.monotonic() - begun, "memory": used.ru_maxrss / megabyte}))
sys.exit(0 if done.returncode in (0, 1) else 2)
`;

/** The peer reads a file and makes its table of states. */
const PEER_RUN = `
import sys
from nc_gcode_interpreter import nc_to_dataframe
nc_to_dataframe(open(sys.argv[1]))
`;

async function running() {
  const folder = await mkdtemp(join(tmpdir(), "peers-"));
  row("", ["Probewright", "nc-gcode-i.", "ratio"]);
  try {
    for (const count of BLOCKS) {
      const file = join(folder, `${count}.mpf`);
      await writeFile(file, `${written(count)}\nM30\n`);
      const best = { own: null, other: null };
      for (let n = 0; n < TRIES; n++) {
        const quickest = (a, b) => (!a || (b && b.seconds < a.seconds) ? b : a);
        best.own = quickest(best.own, await measured(PROBEWRIGHT_PROGRAM, ["run", file]));
        best.other = quickest(best.other, await measured(PEER_PYTHON, ["-c", PEER_RUN, file]));
      }
      const { own, other } = best;
      compare(`${count} blocks: run, s`, own?.seconds, other?.seconds);
      compare(`${count} blocks: memory at most, MB`, own?.memory, other?.memory, 0);
    }
  } finally {
    await rm(folder, { recursive: true });
  }
}

await preview();
await running();
