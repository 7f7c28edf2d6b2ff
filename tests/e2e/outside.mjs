// Speed as a user feels it, taken from outside the page: by the browser's own timing of events, by what changes in the
// document, by what is handed to the graphics device and by what other threads tell. `bench.mjs` prints it; by hand:
//   PROBEWRIGHT_URL=http://127.0.0.1:4173/ node tests/e2e/outside.mjs
import { createServer } from "node:http";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { address, launch } from "./browser.mjs";

/** ms: of keys that took less the browser tells nothing. */
const SHORTEST = 16;
const KEYS = 60; // that count
const FIRST = 10; // before them: they compile what the others use
const VISITS = 5;
/** A connection of 50 Mbit/s with 20 ms to the server and back, and a processor of a quarter of the speed. */
const SLOW = { latency: 20, downloadThroughput: 50e6 / 8, uploadThroughput: 10e6 / 8, rate: 4 };

/** What everything costs, beside the page itself: a page that holds an input and says what was typed into it. */
const EMPTY = `<!doctype html><title>Empty</title><div class="field"><input value="1"
  oninput="this.nextElementSibling.textContent = this.value"><b></b></div>`;

const EMPTY_PATH = "./empty.html";

// In the page before its own scripts: when each key was told and painted, and when anything changed after it.
function watch() {
  const seen = { keys: [], pressed: 0, changed: 0 };
  globalThis.outside = seen;
  new PerformanceObserver(list => {
    for (const { name, startTime, processingStart, duration } of list.getEntries())
      if (name === "keydown") seen.keys.push({ startTime, duration, held: processingStart - startTime });
  }).observe({ type: "event", durationThreshold: 16 });
  const press = event => {
    seen.pressed = seen.changed = event.timeStamp;
  };
  addEventListener("keydown", press, true);
  const settled = () => {
    seen.changed = performance.now();
    requestAnimationFrame(() =>
      setTimeout(() => {
        seen.changed = performance.now();
      }),
    );
  };
  new MutationObserver(settled).observe(document, { subtree: true, childList: true, attributes: true });
  const drawing = (type, name) => {
    const plain = type?.prototype[name];
    if (!plain) return;
    type.prototype[name] = function (...args) {
      const result = plain.apply(this, args);
      settled();
      return result;
    };
  };
  // What another thread draws it tells when it is on the screen.
  globalThis.Worker = class extends Worker {
    constructor(...args) {
      super(...args);
      this.addEventListener("message", settled);
    }
  };
  drawing(globalThis.GPUQueue, "submit");
  for (const name of ["drawElements", "drawElementsInstanced", "drawArrays", "drawArraysInstanced"])
    drawing(globalThis.WebGL2RenderingContext, name);
}

/** The field of a length, with the cursor behind its digits. */
async function cursor(page) {
  await page.locator('.field:has(.unit:text-is("mm")) .entry-line > .figure, .field > input').first().click();
  await page.keyboard.press("End");
}

/** A digit, or its removal; a while later at any moment of a frame: ms until nothing changed any more. */
async function press(page, n, pause) {
  await page.keyboard.press(n % 2 ? "Backspace" : "1");
  await page.waitForTimeout(pause + ((n * 7) % 17));
  return page.evaluate(() => globalThis.outside.changed - globalThis.outside.pressed);
}

/** What the browser tells of the keys since then: ms to the paint that shows them, and how long they waited. */
async function told(page, since) {
  await page.waitForTimeout(500);
  return page.evaluate(from => globalThis.outside.keys.filter(one => one.startTime >= from), since);
}

const now = page => page.evaluate(() => performance.now());

/** Processor time of the page's own thread so far, ms. */
async function worked(session) {
  const { metrics } = await session.send("Performance.getMetrics");
  return 1000 * metrics.find(({ name }) => name === "TaskDuration").value;
}

const sorted = list => [...list].sort((a, b) => a - b);
const filled = (list, count, least) => sorted([...list, ...new Array(Math.max(0, count - list.length)).fill(least)]);

/** Keys one at a time: to the paint of form and call, until nothing changes any more, and what they cost. */
async function single(page, session) {
  await cursor(page);
  for (let n = 0; n < FIRST; n++) await press(page, n, 250);
  const [since, before] = [await now(page), await worked(session)];
  const settled = [];
  for (let n = 0; n < KEYS; n++) settled.push(await press(page, n, 250));
  const cost = ((await worked(session)) - before) / KEYS;
  const painted = (await told(page, since)).map(({ duration }) => duration);
  return { painted: filled(painted, KEYS, SHORTEST), settled: sorted(settled), cost };
}

/** A key that is held down, 30 times a second: how long each waits until the page hears of it. */
async function repeated(page, session) {
  await cursor(page);
  const since = await now(page);
  const keys = [
    { key: "1", code: "Digit1", text: "1", windowsVirtualKeyCode: 49 },
    { key: "Backspace", code: "Backspace", windowsVirtualKeyCode: 8 },
  ];
  for (let n = 0; n < KEYS; n++) {
    void session.send("Input.dispatchKeyEvent", { type: "keyDown", ...keys[n % 2] });
    void session.send("Input.dispatchKeyEvent", { type: "keyUp", ...keys[n % 2] });
    await new Promise(resolve => setTimeout(resolve, 33));
  }
  const held = (await told(page, since)).map(one => one.held);
  return filled(held, KEYS, 0);
}

async function typing(browser, url) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, locale: "en-GB" });
  const page = await context.newPage();
  await page.addInitScript(watch);
  await page.goto(url, { waitUntil: "load" });
  await page.locator(".field input").first().waitFor();
  if (url.startsWith("http")) {
    await page.locator(".answer-line b").first().waitFor();
    await page.locator(".stage [data-backend]").waitFor();
    await page.waitForTimeout(2000); // what comes behind the first form
  }
  const session = await context.newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  const one = await single(page, session);
  const held = await repeated(page, session);
  await context.close();
  return { ...one, held };
}

// The page as a server hands it out that compresses: what CDP holds back is counted as it comes over the wire.
async function compressed() {
  const known = new Map();
  const asked = async path => {
    const response = await fetch(new URL(path, address));
    const type = response.headers.get("Content-Type") ?? "";
    const body = gzipSync(Buffer.from(await response.arrayBuffer()), { level: 9 });
    return { status: response.status, type, body };
  };
  const empty = async () => ({ status: 200, type: "text/html", body: gzipSync(EMPTY) });
  const server = createServer(async ({ url }, reply) => {
    const path = `.${url}`;
    if (!known.has(path)) known.set(path, path === EMPTY_PATH ? empty() : asked(path));
    const { status, type, body } = await known.get(path);
    const headers = { "Content-Type": type, "Content-Encoding": "gzip", "Content-Length": body.length };
    reply.writeHead(status, headers).end(body);
  });
  await new Promise(resolve => server.listen(0, "127.0.0.1", resolve));
  const at = path => `http://127.0.0.1:${server.address().port}/${path}`;
  return { url: at("#measure"), empty: at(EMPTY_PATH.slice(2)), end: () => server.close() };
}

/** s to the first form and to the first result, of a visit to a page that the browser does not know. */
async function visit(browser, url, slow) {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 },
    locale: "en-GB",
    serviceWorkers: "block",
  });
  const page = await context.newPage();
  const session = await context.newCDPSession(page);
  if (slow) {
    const { rate, ...network } = slow;
    await session.send("Network.enable");
    await session.send("Network.emulateNetworkConditions", { offline: false, ...network });
    await session.send("Emulation.setCPUThrottlingRate", { rate });
  }
  // The page draws in frames: what is asked for when it has drawn comes once the browser has painted that frame.
  await page.addInitScript(() => {
    const found = {};
    globalThis.first = found;
    const seen = { form: ".field input", result: ".answer-line b" };
    const look = () => {
      for (const [name, where] of Object.entries(seen)) {
        if (name in found || !document.querySelector(where)) continue;
        found[name] = 0;
        const painted = () => {
          found[name] = performance.now() / 1000;
        };
        globalThis.scheduler.postTask(painted, { priority: "user-blocking" });
      }
    };
    new MutationObserver(look).observe(document, { subtree: true, childList: true });
  });
  await page.goto(url, { waitUntil: "commit" });
  const last = url.includes("#") ? "result" : "form";
  await page.waitForFunction(name => globalThis.first?.[name], last, { timeout: 60_000 });
  const first = await page.evaluate(() => globalThis.first);
  await context.close();
  return first;
}

/** Medians of some visits to the page and to one that is empty, in turn: what else the machine does meets both. */
async function visits(browser) {
  const server = await compressed();
  await visit(browser, server.url, null); // the server has compressed everything
  const [all, empty] = [[], []];
  for (let n = 0; n < VISITS; n++) {
    empty.push(await visit(browser, server.empty, SLOW));
    all.push(await visit(browser, server.url, SLOW));
  }
  server.end();
  const middle = (list, name) => sorted(list.map(one => one[name]))[Math.floor(VISITS / 2)];
  return { form: middle(all, "form"), result: middle(all, "result"), empty: middle(empty, "form") };
}

const percent = (times, share) => times[Math.floor(((times.length - 1) * share) / 100)];

/**
 * Prints figure and limit of each, and how many times that of the empty page it is: the rest is the browser and what
 * else the machine does. `row(name, cells)` and `verdict(value, goal)` are those of the bench.
 */
export async function outside(browser, row, verdict) {
  const empty = await typing(browser, `data:text/html,${encodeURIComponent(EMPTY)}`);
  const page = await typing(browser, new URL("#measure", address).href);
  const over = (value, floor) => (floor > 0 ? `x ${(value / floor).toFixed(1)}` : "");
  const times = (name, part, share, goal) => {
    const [all, floor] = [page[part], empty[part]];
    const cells = list => [50, 95, 100].map(one => percent(list, one).toFixed(0));
    const [value, least] = [percent(all, share), percent(floor, share)];
    const reached = verdict(value, goal + 0.001); // up to the goal and with it
    row(name, [...cells(all), `<= ${goal}`, reached, over(value, least)]);
    row("  the same with an empty page", cells(floor));
  };
  const once = (name, value, floor, goal) =>
    row(name, [
      value.toFixed(2),
      "",
      "",
      ...(goal ? [`< ${goal}`, verdict(value, goal)] : ["", ""]),
      over(value, floor),
    ]);
  row("from outside, ms", ["50 %", "95 %", "100 %", "goal", "ratio", "empty page"]);
  times("key to the paint of form and call", "painted", 95, 16);
  times("key until nothing changes any more", "settled", 95, 50);
  times("key held down, until the page hears of it", "held", 100, 50);
  once("processor time of the page a key, ms", page.cost, empty.cost);
  const first = await visits(browser);
  once("first form, 50 Mbit/s and CPU x 4, s", first.form, first.empty, 1);
  once("first result, 50 Mbit/s and CPU x 4, s", first.result, first.empty, 2.5);
  row("  an empty page, s", [first.empty.toFixed(2)]);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const browser = await launch("as-it-is");
  const row = (name, cells) => console.log(name.padEnd(50), ...cells.map(cell => String(cell).padStart(11)));
  const verdict = (value, goal) => `${(value / goal).toFixed(2)} ${value < goal ? "met" : "missed"}`;
  try {
    await outside(browser, row, verdict);
  } finally {
    await browser.close();
  }
}
