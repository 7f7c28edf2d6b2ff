// The whole path of a long run on a device: levels while it moves, all of it at rest.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { launch, packages } from "./browser.mjs";
import { allDrawn, makeMotions, showMotions } from "./motions.mjs";
import { serve } from "./sources.mjs";

const { PNG } = packages("pngjs");
const MOTIONS = 60_000; // more than the first frame has
const size = { width: 640, height: 480 };
const DIFFER = 0.002; // pixels that may have another colour, share of those that the path has

let site;
before(async () => {
  site = await serve();
});
after(() => site.close());

const shot = async page => PNG.sync.read(await page.screenshot());

/** Whether each pixel has the colour of a motion. */
function trailIn({ data }, [r, g, b]) {
  return Uint8Array.from({ length: data.length / 4 }, (_, i) =>
    Number(Math.max(Math.abs(data[4 * i] - r), Math.abs(data[4 * i + 1] - g), Math.abs(data[4 * i + 2] - b)) <= 8),
  );
}

const count = mask => mask.reduce((sum, one) => sum + one, 0);
const differing = (a, b) => a.reduce((sum, one, i) => sum + Number(one !== b[i]), 0);

async function opened(browser) {
  const page = await browser.newPage({ viewport: size });
  await page.goto(`${site.url}preview-test.html`);
  await page.waitForFunction(() => window.preview);
  return page;
}

describe("the whole path", () => {
  // oracle: self (all motions in one frame, without levels, portions and the picture made out of sight)
  for (const backend of ["webgpu", "webgl2"])
    test(`is drawn with nothing lost once ${backend} rests`, async () => {
      const browser = await launch(backend);
      try {
        const page = await opened(browser);
        await makeMotions(page, MOTIONS);
        const colour = await page.evaluate(prepare, backend);
        for (const [yaw, scale] of [
          [0.6, 1],
          [2.1, 3],
        ]) {
          await page.evaluate(([yaw, scale]) => window.trail.rest(yaw, scale), [yaw, scale]);
          const rest = trailIn(await shot(page), colour);
          await page.evaluate(() => window.trail.whole());
          const all = trailIn(await shot(page), colour);
          assert.ok(count(all) > 3000, `${count(all)} pixels of the path`);
          assert.ok(differing(rest, all) <= DIFFER * count(all), `${differing(rest, all)} of ${count(all)} differ`);
        }
      } finally {
        await browser.close();
      }
    });

  // oracle: hand (a level that is drawn as it is)
  test("is drawn as strokes where there is no device", async () => {
    const browser = await launch("neither");
    try {
      const page = await opened(browser);
      await showMotions(page, MOTIONS);
      await page.waitForFunction(() => Number(document.querySelector("[role=application]").dataset.motions) > 0);
      const drawn = await page.evaluate(() => Number(document.querySelector("[role=application]").dataset.motions));
      assert.ok(drawn > 500 && drawn <= 4096, `${drawn}`);
    } finally {
      await browser.close();
    }
  });

  // oracle: hand (the number of motions)
  test("is there again after the view was turned", async () => {
    const browser = await launch("webgl2");
    try {
      const page = await opened(browser);
      await showMotions(page, MOTIONS);
      await allDrawn(page, MOTIONS);
      await page.evaluate(() => {
        delete document.querySelector("[role=application]").dataset.motions;
        for (let n = 0; n < 5; n++) window.preview.turn(20, 3);
      });
      await allDrawn(page, MOTIONS);
    } finally {
      await browser.close();
    }
  });
});

/** In the page: a device of its own over everything, with the scene that was made. */
async function prepare(way) {
  const load = name => import(new URL(`src/preview/${name}.ts`, location.href).href);
  const [gpu, scene, camera, colours, ink] = await Promise.all(["gpu", "scene", "camera", "colours", "ink"].map(load));
  const host = document.createElement("div");
  host.style = "position: fixed; inset: 0";
  document.body.append(host);
  const view = { width: innerWidth, height: innerHeight };
  const made = scene.buildScene(window.motions, colours.LIGHT, { index: window.motions.view.entries - 1 });
  let told = 0; // motions that are there
  let frame = null;
  const backend = await gpu.openGpu(way, host, {
    lost: reason => reason && console.error(reason),
    again: () => backend.draw(frame),
    thinned: () => undefined,
    drawn: () => undefined,
    trailed: drawn => {
      told = drawn;
    },
  });
  Object.assign(backend.element.style, { position: "absolute", inset: "0", width: "100%", height: "100%" });
  backend.setScene(made, 1);
  const shown = document.createElement("img");
  window.trail = {
    async rest(yaw, scale) {
      shown.remove();
      const seen = camera.fit({ ...camera.initial(), yaw }, view, made.box);
      frame = {
        camera: { ...seen, scale: seen.scale * scale },
        view,
        ratio: 1,
        time: made.data.view.entries,
        probe: null,
      };
      told = 0;
      backend.draw(frame);
      while (told !== window.motions.path.motions) await new Promise(resolve => setTimeout(resolve, 20));
      await new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    },
    async whole() {
      shown.src = URL.createObjectURL(await backend.picture(frame));
      shown.style = "position: absolute; inset: 0; width: 100%; height: 100%";
      await shown.decode();
      host.append(shown);
    },
  };
  return ink.trailColours(colours.LIGHT)[1].map(value => Math.round(255 * value));
}
