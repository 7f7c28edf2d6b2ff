// A large part program in the page: time until it is seen, read and run, standstills of the page, memory of its
// process. `bench.mjs` prints it; by hand, with how many millions of blocks (default 1):
//   PROBEWRIGHT_URL=http://127.0.0.1:4173/ node tests/e2e/large.mjs 1
import { createWriteStream } from "node:fs";
import { mkdtemp, readFile, rm, stat } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { finished } from "node:stream/promises";
import { fileURLToPath } from "node:url";
import { launch, open } from "./browser.mjs";

const MILLION = 1_000_000;
const EVERY = 100_000; // blocks between two measuring calls
const CALL =
  "G0 Z50\r\nG0 X0 Y0\r\n_MVAR=1 _SETVAL=132 _TNUM=20 _KNUM=2001 _PRNUM=1 _FA=2 _TSA=1\r\nCYCLE977\r\nG0 X300 Y300\r\n";
const PATIENCE = 600_000; // ms

/** A spiral in a million pieces, with a measuring call now and then, as a file. */
async function written(file, blocks) {
  const out = createWriteStream(file);
  out.write("%_N_PART_MPF\r\nG17 G54 G90 G40\r\nT20 D1\r\nM6\r\nG0 Z50\r\n");
  for (let from = 0; from < blocks; from += EVERY) {
    let piece = "";
    for (let n = from; n < from + EVERY; n++) {
      const [x, y] = [Math.cos, Math.sin].map(of => (300 + 200 * of(n / 500) * (1 + n / blocks)).toFixed(3));
      piece += `N${(n * 10) % 9_999_990} G1 X${x} Y${y} Z${(100 + (20 * n) / blocks).toFixed(3)} F1200\r\n`;
    }
    if (!out.write(piece + CALL)) await new Promise(resolve => out.once("drain", resolve));
  }
  out.end("M30\r\n");
  await finished(out);
  return (await stat(file)).size;
}

/** Watches the process of the page, where the system tells of it (Linux): the most memory that is its own, MB. */
async function memoryOf(browser) {
  const session = await browser.newBrowserCDPSession();
  const own = async ({ id }) => {
    const status = await readFile(`/proc/${id}/status`, "utf8").catch(() => "");
    return Number(/^RssAnon:\s+(\d+)/m.exec(status)?.[1] ?? 0) / 1024;
  };
  const now = async () => {
    const { processInfo } = await session.send("SystemInfo.getProcessInfo");
    return Math.max(...(await Promise.all(processInfo.filter(one => one.type === "renderer").map(own))));
  };
  let most = 0;
  const timer = setInterval(async () => {
    most = Math.max(most, await now().catch(() => 0));
  }, 200);
  return { now, most: () => most, stop: () => clearInterval(timer) };
}

/** The longest time without a frame since it was asked last. */
async function watchFrames(page) {
  await page.evaluate(() => {
    globalThis.longest = 0;
    let last = performance.now();
    const tick = now => {
      globalThis.longest = Math.max(globalThis.longest, now - last);
      last = now;
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  });
  return () =>
    page.evaluate(() => {
      const { longest } = globalThis;
      globalThis.longest = 0;
      return longest;
    });
}

/** Opens, reads and runs a program of so many million blocks. `row` prints, `verdict` compares with a goal. */
export async function large(browser, row, verdict, millions = 1) {
  const folder = await mkdtemp(join(tmpdir(), "large-"));
  const file = join(folder, "part.mpf");
  const bytes = await written(file, millions * MILLION);
  const name = `${millions === 1 ? "a million" : `${millions} million`} blocks (${Math.round(bytes / 1e6)} MB)`;
  const { page, context } = await open(browser);
  const memory = await memoryOf(browser);
  const told = (what, value, unit, goal, digits = 1) =>
    row(`${name}, ${what}, ${unit}`, [
      value.toFixed(digits),
      ...(goal ? ["", "", `< ${goal}`, verdict(value, goal)] : []),
    ]);
  try {
    await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
    await page.locator(".stage [data-backend]").waitFor();
    await page.waitForTimeout(2000); // editor and types have come too
    const still = await watchFrames(page);
    const part = async (what, goal, doing) => {
      const start = performance.now();
      await doing();
      told(what, (performance.now() - start) / 1000, "s", goal);
      told(`${what}: standstill`, await still(), "ms", 200, 0);
      told(`${what}: memory`, await memory.now(), "MB", 1000, 0);
    };
    const until = (condition, ...given) => page.waitForFunction(condition, ...given, { timeout: PATIENCE });
    await part("opened", 3, async () => {
      await page.locator(".panel-program input[type=file]").setInputFiles(file);
      await page.locator('.notice:has-text("Program opened.")').waitFor({ timeout: PATIENCE });
      await page.locator('.cm-line:has-text("N0 G1")').waitFor();
    });
    await part("read behind that", 0, async () => {
      await until(
        () =>
          Number(document.querySelector('.panel-program [aria-controls="outline"]')?.textContent.replace(/\D/g, "")),
        null,
      );
      await page.locator(".activity[data-work=reading]").waitFor({ state: "hidden", timeout: PATIENCE });
    });
    await part("first motions", 3, async () => {
      await page.getByRole("button", { name: "Whole program" }).click();
      await until(() => Number(document.querySelector(".stage [data-motions]")?.dataset.motions) > 0, null);
    });
    await part("run", 0, () =>
      until(() => Number(document.querySelector(".timeline input[type=range]")?.max) > 1000, null),
    );
    await part("key in the editor", 0, async () => {
      await page.locator('.cm-line:has-text("N0 G1")').click();
      await page.keyboard.type(" ");
      await page.waitForTimeout(500);
      await page.locator(".activity[data-work=reading]").waitFor({ state: "hidden", timeout: PATIENCE });
    });
    told("most memory", memory.most(), "MB", 1000, 0);
  } finally {
    memory.stop();
    await context.close();
    await rm(folder, { recursive: true });
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const browser = await launch("as-it-is");
  const row = (name, cells) => console.log(name.padEnd(56), ...cells.map(cell => String(cell).padStart(9)));
  const verdict = (value, goal) => `${(value / goal).toFixed(2)} ${value < goal ? "met" : "missed"}`;
  try {
    await large(browser, row, verdict, Number(process.argv[2] ?? 1));
  } finally {
    await browser.close();
  }
}
