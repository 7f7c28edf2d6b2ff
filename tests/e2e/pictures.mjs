// Takes the pictures of the README from the built page: docs/start.png, screenshot.png, program.png, tablet.png and the
// animation measuring.png (APNG).
//   PROBEWRIGHT_URL=http://127.0.0.1:4173/ node tests/e2e/pictures.mjs [NAME …]
import { writeFileSync } from "node:fs";
import { crc32, deflateSync } from "node:zlib";
import { launch, open, packages } from "./browser.mjs";
import { drawn, openProgram } from "./start.mjs";

const { PNG } = packages("pngjs");
const place = name => new URL(`../../docs/${name}.png`, import.meta.url);
const VALUES = "_TUL=0.03 _TLL=-0.03 _TNUM=20 _KNUM=0 _TSA=1 _PRNUM=1 _NMSP=1 _FA=2";
const PROGRAM = `; FLANGE
G17 G500 G40 D1
T9 D1
_MVAR=1 _SETVAL=132 ${VALUES}
CYCLE977
_MVAR=101 _SETVAL=132 _KNUM=1 _TSA=1 _PRNUM=1 _NMSP=1 _FA=2
CYCLE977
_MVAR=1 _SETVAL=132 ${VALUES.replaceAll("0.03", "0.01")}
CYCLE977
M30
`;
const FRAMES = 24;

/** Until the stage is drawn and its camera rests. */
async function rest(page) {
  await page.locator(".view-cube").first().waitFor();
  await page.waitForTimeout(2500);
}

const pictures = {
  async start(browser) {
    const { context, page } = await open(browser, { path: "" });
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
    await page.locator('.tile[data-element="hole"]').click();
    return { context, page };
  },
  async screenshot(browser) {
    const { context, page } = await open(browser);
    await rest(page);
    return { context, page };
  },
  async program(browser) {
    const { context, page } = await open(browser, {
      viewport: { width: 1600, height: 900 },
      colorScheme: "dark",
      serviceWorkers: "block",
    });
    await page.locator(".cm-content").waitFor();
    await openProgram(page, PROGRAM, "FLANGE.MPF");
    await page.locator("#panel-view .segments button").nth(1).click();
    await rest(page);
    await page.locator(".notice").evaluate(node => node.remove());
    return { context, page };
  },
  async tablet(browser) {
    const { context, page } = await open(browser, { viewport: { width: 1024, height: 768 }, hasTouch: true });
    await rest(page);
    return { context, page };
  },
};

/** A chunk of a PNG file. */
function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, "latin1"), data]);
  const length = Buffer.alloc(4);
  length.writeUInt32BE(data.length);
  const sum = Buffer.alloc(4);
  sum.writeUInt32BE(crc32(body));
  return Buffer.concat([length, body, sum]);
}

const numbers = (...all) =>
  Buffer.concat(
    all.map(([value, bytes]) => {
      const one = Buffer.alloc(bytes);
      one.writeUIntBE(value, 0, bytes);
      return one;
    }),
  );

/** The rectangle in which a frame differs from the one before; what is the same there is transparent. */
function changed({ width, height, data }, before) {
  let [left, top, right, bottom] = [width, height, 0, 0];
  const same = at => before && data.readUInt32LE(at) === before.data.readUInt32LE(at);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++)
      if (!same(4 * (y * width + x))) {
        [left, top] = [Math.min(left, x), Math.min(top, y)];
        [right, bottom] = [Math.max(right, x + 1), Math.max(bottom, y + 1)];
      }
  if (right === 0) [left, top, right, bottom] = [0, 0, 1, 1];
  const [wide, high] = [right - left, bottom - top];
  const rows = Buffer.alloc(high * (1 + 4 * wide)); // filter 0 before each row
  for (let y = 0; y < high; y++)
    for (let x = 0; x < wide; x++) {
      const at = 4 * ((y + top) * width + x + left);
      if (!same(at)) data.copy(rows, y * (1 + 4 * wide) + 1 + 4 * x, at, at + 4);
    }
  return { left, top, wide, high, bytes: deflateSync(rows, { level: 9 }) };
}

/** An animated PNG; each frame with the ms that it stays. */
function animated(frames) {
  const { width, height } = frames[0].picture;
  let count = 0; // of the chunks that are counted through
  const parts = frames.flatMap(({ picture, stays }, index) => {
    const { left, top, wide, high, bytes } = changed(picture, frames[index - 1]?.picture);
    const control = numbers(
      [count++, 4],
      [wide, 4],
      [high, 4],
      [left, 4],
      [top, 4],
      [stays, 2],
      [1000, 2],
      [0, 1], // stays when the next one comes
      [index === 0 ? 0 : 1, 1], // which is laid over it
    );
    const image = index === 0 ? chunk("IDAT", bytes) : chunk("fdAT", Buffer.concat([numbers([count++, 4]), bytes]));
    return [chunk("fcTL", control), image];
  });
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
    chunk("IHDR", numbers([width, 4], [height, 4], [8, 1], [6, 1], [0, 1], [0, 1], [0, 1])),
    chunk("acTL", numbers([frames.length, 4], [0, 4])),
    ...parts,
    chunk("IEND", Buffer.alloc(0)),
  ]);
}

/** A hole is measured, then its errors are enlarged. */
async function measuring(browser) {
  const { context, page } = await open(browser, { viewport: { width: 1280, height: 760 } });
  await rest(page);
  const frames = [];
  const track = page.locator(".track input");
  const most = Number(await track.getAttribute("max"));
  const slide = (input, value) =>
    input.evaluate((node, to) => {
      node.value = String(to);
      node.dispatchEvent(new Event("input", { bubbles: true }));
    }, value);
  for (let at = 0; at <= FRAMES; at++) {
    await slide(track, Math.round((at * most) / FRAMES));
    await drawn(page);
    await page.waitForTimeout(350); // a touch has flashed
    frames.push({ picture: PNG.sync.read(await page.screenshot()), stays: at === FRAMES ? 1500 : 160 });
  }
  const errors = page.locator("#errors-shown");
  for (let at = 1; at <= Number(await errors.getAttribute("max")); at++) {
    await slide(errors, at);
    await page.waitForTimeout(600);
    frames.push({ picture: PNG.sync.read(await page.screenshot()), stays: 350 });
  }
  frames.at(-1).stays = 2000;
  await context.close();
  return animated(frames);
}

const browser = await launch("webgl2");
const wanted = process.argv.slice(2); // none: all
const isWanted = name => wanted.length === 0 || wanted.includes(name);
for (const [name, show] of Object.entries(pictures).filter(([name]) => isWanted(name))) {
  const { context, page } = await show(browser);
  await drawn(page);
  await page.screenshot({ path: place(name).pathname });
  await context.close();
}
if (isWanted("measuring")) writeFileSync(place("measuring"), await measuring(browser));
await browser.close();
