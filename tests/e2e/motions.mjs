// Programs of any size for tests and measurements: a face in wavy lines, in ten layers.

/** Where block number `n` of so many ends. */
function placeOf(n, count) {
  const layer = count / 10;
  const lines = Math.sqrt(layer);
  const [line, along] = [Math.floor((n % layer) / lines), n % lines];
  const x = (line % 2 ? lines - along : along) * (200 / lines);
  return [x, line * (100 / lines) + Math.sin(x / 9), Math.floor(n / layer)];
}

const words = place => place.map((at, axis) => `${"XYZ"[axis]}${at.toFixed(4)}`).join(" ");

/** Its text, without an end. */
export const written = count =>
  Array.from({ length: count }, (_, n) => `N10 G1 ${words(placeOf(n, count))} F1200\n`).join("");

/** Puts its motions as a scene into `window.motions` of the page of preview-test.html, without running it. */
export const makeMotions = (page, count) => page.evaluate(made, [String(placeOf), count]);

async function made([placeOf, count]) {
  const load = path => import(new URL(path, location.href).href);
  const place = new Function(`return ${placeOf}`)();
  const [{ NOTHING }, { pathOf }] = await Promise.all([load("src/core/scene.ts"), load("src/core/levels.ts")]);
  const ways = new Float64Array(8 * count);
  for (let n = 0; n < count; n++) ways.set([...place(n, count), ...place(n + 1, count), 0, 1], 8 * n);
  const wayEntries = Uint32Array.from({ length: count }, (_, n) => n);
  const wayKinds = new Uint8Array(count).fill(1);
  const box = [
    [0, -1, 0],
    [200, 101, 10],
  ];
  const view = { ...NOTHING.view, entries: count, standings: [{ ...NOTHING.view.standings[0], whole: box }] };
  const path = pathOf({ ways, wayEntries, wayKinds });
  window.motions = { ...NOTHING, view, ways, wayEntries, wayKinds, path };
}

/** Shows them. */
export async function showMotions(page, count) {
  await makeMotions(page, count);
  await page.evaluate(() => window.preview.setScene(window.motions));
}

/** Waits until every motion is drawn. */
export const allDrawn = (page, count) =>
  page.waitForFunction(all => document.querySelector("[role=application]")?.dataset.motions === String(all), count, {
    timeout: 120_000,
  });
