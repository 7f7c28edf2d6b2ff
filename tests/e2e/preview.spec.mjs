// The 3D view in browsers that have WebGPU, a WebGPU that stays blank, only WebGL2, or neither: what came, and its
// pixels.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { launch, packages } from "./browser.mjs";
import { modules, program, serve } from "./sources.mjs";

const { PNG } = packages("pngjs");
const size = { width: 900, height: 640 };
const expected = { webgpu: "webgpu", "webgpu-blank": "webgl2", webgl2: "webgl2", neither: "svg" };

let site, sources, theme, topFace, inView;
before(async () => {
  [site, sources] = await Promise.all([serve(), modules()]);
  const [camera, colours, light, scene, demo, motion] = await Promise.all(
    ["camera", "colours", "light", "scene", "demo/scenes", "motion"].map(name =>
      sources.load(`/src/preview/${name}.ts`),
    ),
  );
  theme = Object.fromEntries(Object.entries(colours.LIGHT).map(([name, css]) => [name, bytes(colours.parse(css))]));
  const lit = light.shader(camera.basis(camera.initial()));
  topFace = bytes(lit([0, 0, 1], colours.parse(colours.LIGHT.part)));
  const hole = demo.hole(await program());
  const { box } = scene.buildScene(hole, colours.LIGHT);
  inView = (name, entry, share) => {
    const looking = camera.fit(camera.turn(camera.initial(), name), size, box);
    return camera.projector(looking, size)(motion.probeAt(hole, entry, share));
  };
});
after(async () => {
  await sources?.close();
  await site?.close();
});

const bytes = rgba => rgba.slice(0, 3).map(value => Math.round(255 * value));

for (const [setup, backend] of Object.entries(expected)) {
  describe(`3D view, browser with ${setup}`, () => {
    let browser;
    before(async () => {
      browser = await launch(setup);
    });
    after(() => browser?.close());

    // oracle: hand (the colours of the theme; the lit upper face as light.ts says, WGSL is a second writing of it)
    test(`draws with ${backend}: part, paths and background are there`, async () => {
      const page = await show(browser);
      assert.equal(await page.evaluate(() => window.preview.backend), backend);
      const picture = await shot(page);
      atLeast(picture, topFace, 15_000, "upper face");
      atLeast(picture, theme.background, 200_000, "background");
      atLeast(picture, theme.measuring, 80, "measuring");
      atLeast(picture, theme.rapid, 80, "rapid");
      atLeast(picture, theme.touch, 20, "touch");
      await page.close();
    });

    // oracle: hand (nothing is measured at the beginning; a motion to come is faint, a touch to come unseen)
    test("the step decides what has happened", async () => {
      const page = await show(browser);
      await page.evaluate(() => window.preview.setStep(0, 0));
      const picture = await shot(page);
      assert.equal(count(picture, theme.measuring), 0);
      assert.equal(count(picture, theme.touch, 12), 0);
      await page.close();
    });

    // oracle: hand (entry 3 is the first measuring motion, 5 the way back on the same line)
    test("keys turn the view, a click finds the motion, and an idle view draws nothing", async () => {
      const page = await show(browser);
      const iso = await shot(page);
      await page.keyboard.press("Tab");
      await page.keyboard.press("1");
      const top = await shot(page);
      assert.ok(Buffer.compare(iso.data, top.data) !== 0);
      const { x, y } = inView("top", 3, 0.5);
      await page.mouse.click(x, y);
      assert.ok([3, 5].includes(await page.evaluate(() => window.picked)));
      const frames = await page.evaluate(() => window.frames_asked);
      await page.waitForTimeout(400);
      assert.equal(await page.evaluate(() => window.frames_asked), frames);
      await page.close();
    });

    // oracle: hand (10,000 points above the part, those of the first columns outside of the surface, the others inside;
    // as SVG no more than 4096 are drawn, on a device as many as it bears, at least as many as that)
    test("points of a scan have the colours of their deviations", async () => {
      const page = await show(browser);
      await page.evaluate(() => {
        // from all over, wherever it is cut off
        const points = Float32Array.from({ length: 10_000 }, (_, i) => (i * 37) % 10_000).reduce((all, place, i) => {
          const [column, row] = [place % 100, Math.floor(place / 100)];
          all.set([0.4 * column, 0.4 * row, 0, column < 50 ? 0.2 : -0.2], 4 * i);
          return all;
        }, new Float32Array(40_000));
        window.preview.setCloud({ points, origin: [300, 260, -30], full: 0.1 });
      });
      await page.waitForFunction(
        fewest => Number(document.querySelector("[role=application]").dataset.drawn) >= fewest,
        4096,
      );
      const picture = await shot(page);
      atLeast(picture, theme.outside, 2_000, "outside");
      atLeast(picture, theme.inside, 2_000, "inside");
      const idle = await page.evaluate(() => window.frames_asked);
      await page.waitForTimeout(400);
      assert.equal(await page.evaluate(() => window.frames_asked), idle, "a cloud that is drawn is left alone");
      await page.evaluate(() => window.preview.setCloud(null));
      assert.equal(count(await shot(page), theme.outside), 0);
      await page.close();
    });
  });
}

describe("3D view after a loss", () => {
  // oracle: hand (the next way of drawing shows the same part)
  test("a lost WebGL2 context is replaced by SVG", async () => {
    await replaced("webgl2", "svg", { elsewhere: true });
  });

  test("a lost WebGPU device is replaced by WebGL2", async () => {
    await replaced("webgpu", "webgl2", { elsewhere: true });
  });

  // oracle: hand (the same picture, drawn by the page itself, and lost there)
  test("where no other thread has WebGL2, the page draws itself", async () => {
    const before = () => {
      OffscreenCanvas.prototype.getContext = new Proxy(OffscreenCanvas.prototype.getContext, {
        apply: (plain, self, [kind, ...more]) => (kind === "2d" ? plain.call(self, kind, ...more) : null),
      });
    };
    await replaced("webgl2", "svg", { elsewhere: false, before });
  });

  // `elsewhere`: it is drawn by another thread, and the page gets no context of the canvas.
  async function replaced(from, to, { elsewhere, before }) {
    const browser = await launch(from);
    try {
      const page = await show(browser, before);
      assert.equal(await page.evaluate(() => window.preview.backend), from);
      atLeast(await shot(page), topFace, 15_000, "upper face before");
      assert.equal(await page.evaluate(isElsewhere), elsewhere);
      await page.evaluate(() => new BroadcastChannel("lose").postMessage(""));
      await page.waitForFunction(name => window.preview.backend === name, to);
      atLeast(await shot(page), topFace, 15_000, "upper face");
    } finally {
      await browser.close();
    }
  }
});

// `before`: what else is done on every thread before anything is drawn.
async function show(browser, before = () => undefined) {
  const page = await browser.newPage({ viewport: size });
  await page.addInitScript(watch);
  await page.addInitScript({ content: `onEveryThread(${keep}, ${before})` });
  await page.goto(`${site.url}preview-test.html`);
  await page.waitForFunction(() => window.preview);
  return page;
}

// Counts animation frames of the page, and does something on each thread before its own code runs.
function watch() {
  const ask = window.requestAnimationFrame.bind(window);
  window.frames_asked = 0;
  window.requestAnimationFrame = callback => {
    window.frames_asked += 1;
    return ask(callback);
  };
  window.onEveryThread = (...all) => {
    const code = all.map(one => `(${one})();`).join("");
    new Function(code)();
    const made = text => URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
    globalThis.Worker = class extends Worker {
      constructor(address, options) {
        super(made(`import "${made(code)}"; import "${new URL(address, location.href)}";`), options);
      }
    };
  };
}

// Keeps devices and contexts, and loses them when it is told to.
function keep() {
  const lose = [];
  const contexts = (type, wanted) => {
    const plain = type?.prototype.getContext;
    if (!plain) return;
    type.prototype.getContext = function (...args) {
      const context = plain.apply(this, args);
      if (context && args[0] === wanted) lose.push(() => context.getExtension("WEBGL_lose_context").loseContext());
      return context;
    };
  };
  contexts(globalThis.HTMLCanvasElement, "webgl2");
  contexts(globalThis.OffscreenCanvas, "webgl2");
  if (typeof GPUAdapter !== "undefined") {
    const request = GPUAdapter.prototype.requestDevice;
    GPUAdapter.prototype.requestDevice = async function (...options) {
      const device = await request.apply(this, options);
      lose.push(() => device.destroy());
      return device;
    };
  }
  new BroadcastChannel("lose").onmessage = () => {
    for (const one of lose) one();
  };
}

// A canvas that another thread has gives nobody a context.
function isElsewhere() {
  try {
    document.querySelector("canvas").getContext("2d");
    return false;
  } catch {
    return true;
  }
}

async function shot(page) {
  await page.evaluate(
    () => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 150)))),
  );
  await page.waitForFunction(() => !window.preview.drawing);
  return PNG.sync.read(await page.screenshot());
}

// Pixels within `tolerance` of a colour in every channel.
function count({ data }, [r, g, b], tolerance = 6) {
  let found = 0;
  for (let i = 0; i < data.length; i += 4) {
    const off = Math.max(Math.abs(data[i] - r), Math.abs(data[i + 1] - g), Math.abs(data[i + 2] - b));
    if (off <= tolerance) found += 1;
  }
  return found;
}

function atLeast(picture, colour, wanted, what) {
  const found = count(picture, colour);
  assert.ok(found >= wanted, `${what}: ${found} pixels of ${colour}, wanted ${wanted}`);
}
