// What every browser test uses: the built page in Chromium, in the browser set-ups that the page must cope with.
// `cargo xtask test --only page` sets CHROME (the browser) and PROBEWRIGHT_URL (the served page). By hand:
//   cargo xtask serve                                        (in one terminal)
//   PROBEWRIGHT_URL=http://127.0.0.1:4173/ node --test tests/e2e/
// PROBEWRIGHT_SLOW=8 lets the page run eight times slower: it shows which test reads without waiting.
import assert from "node:assert/strict";
import { createRequire } from "node:module";

// The packages of the page: `packages("axe-core")`, `packages("pngjs")`.
export const packages = createRequire(new URL("../../www/package.json", import.meta.url));
const { chromium } = packages("playwright-core");

export const address = process.env.PROBEWRIGHT_URL ?? "http://127.0.0.1:4173/";

const always = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

// The set-ups. Software rendering everywhere, so that a machine without a GPU shows the same.
// `webgpu-blank`: an adapter is found, but nothing is ever drawn; only pixels tell.
// `as-it-is`: what Chromium does by itself on a machine without a graphics card, for measurements. Where `--use-angle`
// forces software, it also puts the page itself together that way, at several times the cost.
export const setups = {
  webgpu: ["--enable-unsafe-webgpu", "--enable-features=Vulkan", "--use-vulkan=swiftshader", "--use-angle=swiftshader"],
  "webgpu-blank": ["--enable-unsafe-webgpu", "--use-angle=swiftshader"],
  webgl2: ["--use-angle=swiftshader"],
  "as-it-is": ["--enable-unsafe-swiftshader"],
  neither: ["--disable-gpu", "--disable-3d-apis"],
};

// Starts Chromium in one of the set-ups. Now and then it crashes while it starts, which no page can help: then once
// more.
export async function launch(setup = "neither") {
  const start = () =>
    chromium.launch({
      executablePath: process.env.CHROME ?? "/usr/bin/chromium",
      headless: true,
      args: [...always, ...setups[setup]],
    });
  return start().catch(start);
}

// Opens the page in a fresh profile, at the form of a first visit. `problems` fills with everything that must not
// happen: errors in the console, uncaught errors, failed answers, requests to other origins. `options` are
// Playwright's (viewport, colorScheme, …); a test of the page without a network asks for `serviceWorkers: "allow"`:
// what the worker fetches ahead costs each new profile a second of a processor.
export async function open(browser, { path = "#measure", ...options } = {}) {
  const usual = { viewport: { width: 1280, height: 800 }, locale: "en-GB", serviceWorkers: "block" };
  const context = await browser.newContext({ ...usual, ...options });
  context.setDefaultTimeout(30_000); // a busy machine with two cores takes a third of it
  context.setDefaultNavigationTimeout(90_000); // of the sources, which are put together while they are loaded
  const page = await context.newPage();
  if (process.env.PROBEWRIGHT_SLOW) await slow(page, Number(process.env.PROBEWRIGHT_SLOW));
  const problems = watch(page);
  await page.goto(new URL(path, address).href, { waitUntil: "load" });
  return { context, page, problems };
}

async function slow(page, rate) {
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate });
}

function watch(page) {
  const problems = [];
  const origin = new URL(address).origin;
  page.on("console", message => {
    if (message.type() === "error") problems.push(`console: ${message.text()}`);
  });
  page.on("pageerror", error => problems.push(`uncaught: ${error.stack ?? error}`));
  page.on("response", response => {
    if (response.status() >= 400) problems.push(`${response.status()}: ${response.url()}`);
  });
  page.on("request", request => {
    const url = new URL(request.url());
    const local = ["data:", "blob:", "about:"].includes(url.protocol);
    if (!local && url.origin !== origin) problems.push(`request to another origin: ${url.href}`);
  });
  return problems;
}

const SOON = 10_000; // ms

// Fails unless there are `expected` elements, or soon will be: what an action changes is drawn after it, on a slow
// machine well after it. An action that is to change nothing is followed by something that can be waited for.
export async function counts(locator, expected, message) {
  let found = await locator.count();
  for (const until = Date.now() + SOON; found !== expected && Date.now() < until; found = await locator.count())
    await new Promise(resolve => setTimeout(resolve, 20));
  assert.equal(found, expected, message ?? String(locator));
}

// Chooses a file whose text is the pieces, each as often as is said. The page puts it together: megabytes that are
// handed to the browser take longer than the page on a slow machine.
export async function chooseLarge(input, name, pieces) {
  await input.evaluate(
    (field, { name, pieces }) => {
      const chosen = new DataTransfer();
      const parts = pieces.map(([piece, times]) => piece.repeat(times));
      chosen.items.add(new File(parts, name, { type: "text/plain" }));
      field.files = chosen.files;
      field.dispatchEvent(new Event("change", { bubbles: true }));
    },
    { name, pieces },
  );
}

// Starts the browser before the tests of a file and ends it after them: `const chrome = shared("webgpu")`, then
// `await open(chrome.browser)` inside a test.
export function shared(setup, { before, after }) {
  const held = {};
  before(async () => {
    held.browser = await launch(setup);
  });
  after(async () => {
    await held.browser?.close();
  });
  return held;
}
