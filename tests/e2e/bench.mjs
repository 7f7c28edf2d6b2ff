// Speed in Chromium and sizes over the wire; `cargo xtask bench` runs it. Prints a table of figure, goal and their
// ratio; fails only when the page does.
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { launch, open } from "./browser.mjs";
import { large } from "./large.mjs";
import { outside } from "./outside.mjs";
import { givesWork } from "./painted.mjs";
import { practising } from "./practising.mjs";
import { searchTasks } from "./start.mjs";

const row = (name, cells) => console.log(name.padEnd(50), ...cells.map(cell => String(cell).padStart(11)));
// Figure over goal, and whether the goal is met; `more` where more is better.
const verdict = (value, goal, more = false) => {
  const met = more ? value > goal : value < goal;
  return `${(value / goal).toFixed(2)} ${met ? "met" : "missed"}`;
};

// The module that answers once the form stands, reachable for a measurement without the page around them.
async function programModule(page) {
  const root = new URL("../../pkg/", import.meta.url);
  await page.route("**/bench-pkg/**", async route => {
    const path = new URL(route.request().url()).pathname.split("/bench-pkg/")[1];
    const contentType = path.endsWith(".wasm") ? "application/wasm" : "text/javascript";
    await route.fulfill({ body: await readFile(new URL(path, root)), contentType });
  });
  await page.evaluate(async () => {
    const module = await import(new URL("bench-pkg/core/core.js", location.href).href);
    await module.default();
    globalThis["bench-program"] = module;
  });
}

/** Calls before the first that counts: the browser compiles what is used often a second time, and better. */
const WARM = 200;

// Runs in the page: milliseconds of `runs` calls, sorted. Timers of a browser are coarse (0.1 ms), so calls are
// timed in small groups where they are short.
async function perKeystroke(page, request, runs, group) {
  return page.evaluate(
    ([text, count, size, warm]) => {
      const times = [];
      for (let i = 0; i < warm; i++) globalThis["bench-program"].form(text);
      for (let i = 0; i < count; i++) {
        const start = performance.now();
        for (let j = 0; j < size; j++) globalThis["bench-program"].form(text);
        times.push((performance.now() - start) / size);
      }
      return times.sort((a, b) => a - b);
    },
    [JSON.stringify(request), runs, group, WARM],
  );
}

const at = (times, percent) => times[Math.floor(((times.length - 1) * percent) / 100)];

function report(name, times, percent, goal) {
  const cells = [50, 95, 99].map(p => at(times, p).toFixed(3));
  row(name, goal ? [...cells, `< ${goal}`, verdict(at(times, percent), goal)] : cells);
}

async function cycles(page) {
  const catalogue = await page.evaluate(() => JSON.parse(globalThis["bench-program"].catalogue()));
  for (const { control, cycle, example } of catalogue.cycles) {
    const request = { control, cycle, values: example };
    report(`${cycle} form, check, write`, await perKeystroke(page, request, 400, 5), 99, 1);
    report(`${cycle} the same and simulate`, await perKeystroke(page, { ...request, predict: true }, 400, 1), 99, 5);
  }
}

// How certain a hole is, from 10,000 measurements: with a probe that scatters a quarter as many come on top for each of
// the two causes alone; and with a part out of round, which is the only cause then.
async function certainty(page) {
  const worked = (errors, asked) =>
    page.evaluate(
      ([errors, asked]) => {
        const module = globalThis["bench-program"];
        const { cycles } = JSON.parse(module.catalogue());
        const { control, cycle, example } = cycles.find(one => one.cycle === "CYCLE977");
        const form = { control, cycle, values: example, errors };
        const ask = runs => JSON.parse(module.certainty(JSON.stringify({ form, runs })));
        ask(500); // compiled well before it counts
        const start = performance.now();
        const { runs } = ask(asked);
        return runs === asked ? (performance.now() - start) / 1000 : Number.NaN;
      },
      [errors, asked],
    );
  const scattering = await worked({ probe: { repeatability: 0.001 } }, 6667);
  row("10,000 measurements of CYCLE977, s", [scattering.toFixed(2), "< 1", verdict(scattering, 1)]);
  const lobed = await worked({ part: { outOfRound: 0.002 } }, 10_000);
  row("10,000 measurements of CYCLE977, out of round, s", [lobed.toFixed(2), "", ""]);
}

// 10 MB of motion blocks with a measuring call now and then.
async function reading(page) {
  const seconds = await page.evaluate(() => {
    let block = "";
    for (let n = 0; n < 500; n++) block += `N${n * 10} G1 F1200 X${(n / 7).toFixed(3)} Y-${(n / 21).toFixed(3)}\r\n`;
    block += "_MVAR=1 _SETVAL=132 _TNUM=20 _KNUM=2001\r\nCYCLE977\r\n";
    const ask = bytes => JSON.stringify({ control: "sinumerik", text: block.repeat(Math.ceil(bytes / block.length)) });
    globalThis["bench-program"].read(ask(2e6)); // compiled well before it counts, as after the programs before
    const request = ask(10e6);
    const start = performance.now();
    globalThis["bench-program"].read(request);
    return (performance.now() - start) / 1000;
  });
  const speed = 10 / seconds;
  row("read a 10 MB program and list its calls, MB/s", [speed.toFixed(1), "> 20", verdict(speed, 20, true)]);
}

// Programs of 1,000 measuring calls of a cycle on its part, from the text to the answer as JSON, and how many steps
// that is; and programs that never end, until they are given up. Those that measure count the passes, so that nothing
// proves that the same comes again, and each part out of round is worked out the long way.
async function running(page) {
  const measured = await page.evaluate(
    cycles => {
      const core = globalThis["bench-program"];
      const run = request => {
        const start = performance.now();
        const under = new core.Run(JSON.stringify(request));
        while (!under.advance(1000));
        const answer = under.finish(); // as the page asks: what it came to as text, its steps as arrays
        const view = answer.view();
        const steps = answer.steps();
        const seconds = (performance.now() - start) / 1000;
        return { seconds, steps: steps.sorts().length, finished: JSON.parse(view).finished };
      };
      const all = JSON.parse(core.catalogue()).cycles;
      const calls = cycles.map(name => {
        const { control, cycle, example } = all.find(one => one.cycle === name);
        const { setup, snippet } = JSON.parse(
          core.form(JSON.stringify({ control, cycle, values: example, predict: true })),
        );
        const [x, y, z] = setup.position;
        const part = `SUPA G0 X${x} Y${y}\nSUPA G0 Z${z}\n${snippet}\n`;
        const endless = { control, text: `LOOP\nR1=R1+1\n${part}ENDLOOP`, blocks: 100_000 };
        const workpiece = setup.workpiece.map(solid => ({
          ...solid,
          errors: { ...solid.errors, outOfRound: [0.02, 3] },
        }));
        return {
          thousand: { name: `1,000 calls of ${name}`, ...run({ control, text: part.repeat(1000), setup }) },
          loops: [
            { name: `never ends: ${name} at an ideal part`, ...run({ ...endless, setup }) },
            {
              name: `never ends: ${name} at a part out of round`,
              ...run({ ...endless, setup: { ...setup, workpiece } }),
            },
          ],
        };
      });
      const endless = ["LOOP\nR1=R1+1\nENDLOOP", "LOOP\nG0 X=IC(1)\nX=IC(-1)\nENDLOOP", "BACK: GOTOB BACK"];
      const stopped = endless.map(text => ({
        name: `never ends: ${text.replaceAll("\n", " ")}`,
        ...run({ control: "sinumerik", text, blocks: 100_000 }),
      }));
      return {
        calls: calls.map(({ thousand }) => thousand),
        stopped: [...stopped, ...calls.flatMap(({ loops }) => loops)],
      };
    },
    ["CYCLE961", "CYCLE976", "CYCLE977", "CYCLE978", "CYCLE979", "CYCLE997", "CYCLE998"],
  );
  for (const { name, seconds, steps, finished } of measured.calls) {
    row(`${name}${finished ? "" : " (given up)"}, s`, [
      seconds.toFixed(2),
      `${steps} steps`,
      "< 2",
      verdict(seconds, 2),
    ]);
  }
  for (const { name, seconds } of measured.stopped)
    row(`${name}, s`, [seconds.toFixed(2), "", "< 1", verdict(seconds, 1)]);
}

// A program of 1,000 measuring calls in the page: frames while it is played, milliseconds from one to the next.
async function playing(page) {
  const part = await page.evaluate(() => {
    const core = globalThis["bench-program"];
    const { control, cycle, example } = JSON.parse(core.catalogue()).cycles.find(one => one.cycle === "CYCLE977");
    const { setup, snippet } = JSON.parse(
      core.form(JSON.stringify({ control, cycle, values: example, predict: true })),
    );
    const [x, y, z] = setup.position;
    return `SUPA G0 X${x} Y${y}\nSUPA G0 Z${z}\n${snippet}\n`;
  });
  const remove = await program(page, part.repeat(1000));
  await listed(page, 1000);
  await remove();
  await page.getByRole("button", { name: "Whole program" }).click();
  await page.waitForFunction(() => Number(document.querySelector(".timeline input[type=range]")?.max) > 1000, null, {
    timeout: 120_000,
  });
  await page.locator(".timeline .transport").nth(2).click();
  const times = await page.evaluate(
    () =>
      new Promise(resolve => {
        const found = [];
        const start = performance.now();
        let last = 0;
        const tick = now => {
          if (last) found.push(now - last);
          last = now;
          if (now - start < 5000) requestAnimationFrame(tick);
          else resolve(found.sort((a, b) => a - b));
        };
        requestAnimationFrame(tick);
      }),
  );
  report("1,000 calls played, from frame to frame", times, 95, 50);
}

// Work of the page from the event of a keystroke to the layout of the frame that shows it in form and call; what
// follows that paint is measured from outside (outside.mjs). Without a graphics
// card the browser draws with the same cores, so the time on the clock holds the waiting for them; what the page itself
// spends is told apart.
async function keystrokes(browser, page) {
  await browser.startTracing(page, { categories: ["devtools.timeline"] });
  const times = await typed(page);
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  const own = traceEvents
    .filter(one => one.name === "FireAnimationFrame" && one.tdur > 2000)
    .map(one => one.tdur / 1000);
  report("keystroke to form and call redrawn", times, 95, 16);
  report(
    "  of it, processor time of the page",
    own.sort((a, b) => a - b),
    95,
    16,
  );
}

async function typed(page) {
  await givesWork(page);
  return page.evaluate(async () => {
    const input = [...document.querySelectorAll(".field input")].find(field => Number(field.value) > 1);
    const set = Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value").set;
    const start = Number(input.value);
    const times = [];
    for (let i = 0; i < 150; i++) {
      await new Promise(resolve => setTimeout(resolve, 20));
      set.call(input, (start + (i % 9) / 1000).toFixed(3));
      times.push(await globalThis.workOf(() => input.dispatchEvent(new Event("input", { bubbles: true }))));
    }
    return times.slice(30).sort((a, b) => a - b); // the first ones compile what the others use
  });
}

// Opens a program as a file of the disk: handed over as bytes it would travel through the page itself.
async function program(page, text) {
  const folder = await mkdtemp(join(tmpdir(), "bench-"));
  const file = join(folder, "part.mpf");
  await writeFile(file, text);
  await page.locator(".panel-program input[type=file]").setInputFiles(file);
  return () => rm(folder, { recursive: true });
}
/** The program is read: its head tells the calls (whatever stands between the digits), and nothing is under way. */
const listed = async (page, count) => {
  await page.waitForFunction(
    wanted =>
      document.querySelector('.panel-program [aria-controls="outline"]')?.textContent.replace(/\D/g, "") === wanted,
    String(count),
    { timeout: 120_000 },
  );
  await page.locator(".activity[data-work=reading]").waitFor({ state: "hidden", timeout: 120_000 });
};

// Typing into a program with a thousand calls: from the key to the end of the frame that shows it, the wait for that
// frame included.
async function manyCalls(page) {
  const call = n => `N${n * 10} G0 X${n} Y${n}\r\n_MVAR=1 _SETVAL=${100 + n / 100} _TNUM=20 _KNUM=2001\r\nCYCLE977\r\n`;
  const remove = await program(page, Array.from({ length: 1000 }, (_, n) => call(n)).join(""));
  await listed(page, 1000);
  await remove();
  await page.locator(".cm-line").nth(3).click();
  await page.evaluate(() => {
    globalThis.times = [];
    addEventListener(
      "keydown",
      () => {
        const pressed = performance.now();
        requestAnimationFrame(() => setTimeout(() => globalThis.times.push(performance.now() - pressed)));
      },
      true,
    );
  });
  for (let n = 0; n < 120; n++) await page.keyboard.type(n % 2 ? " " : "G", { delay: 40 });
  const times = await page.evaluate(() => globalThis.times.sort((a, b) => a - b));
  report("keystroke in a program with 1,000 calls to redrawn", times, 95, 50);
}

// The longest time without a frame while something is done, until nothing is under way any more.
async function standstill(page, doing) {
  await page.evaluate(() => {
    globalThis.longest = 0;
    if (globalThis.watched) return;
    globalThis.watched = true;
    let last = performance.now();
    const tick = now => {
      globalThis.longest = Math.max(globalThis.longest, now - last);
      last = now;
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(now => {
      last = now;
      tick(now);
    });
  });
  await doing();
  await page.waitForTimeout(500); // reading begins, keeping the work
  await page.locator(".activity[data-work=reading]").waitFor({ state: "hidden", timeout: 120_000 });
  return page.evaluate(() => globalThis.longest);
}

/**
 * ms without a frame. Below it a page that works is felt as slow, not as hanging: a key repeated ten times a second
 * loses one place, a click shows its outcome within the time of a glance. A dozen lost frames are what one copy of 30
 * MB with the clearing up behind it may need on the slowest machine that is meant, two cores without a graphics card.
 */
const STANDSTILL = 200;

// A program of a million lines: how long the page stands still while it is opened and read, looked at and changed.
async function million(page) {
  const one = "N10 G1 F1200 X12.345 Y-6.789\r\n";
  const call = "_MVAR=1 _SETVAL=132 _TNUM=20 _KNUM=2001\r\nCYCLE977\r\nM30\r\n";
  const still = async (name, doing) => {
    const longest = await standstill(page, doing);
    row(`a million lines, ${name}: standstill, ms`, [
      longest.toFixed(0),
      "",
      "",
      `< ${STANDSTILL}`,
      verdict(longest, STANDSTILL),
    ]);
  };
  const opened = async text => {
    const remove = await program(page, text);
    await page.locator('.notice:has-text("Program opened.")').waitFor({ timeout: 60_000 });
    await listed(page, 1);
    await remove();
  };
  const setpoint = value => page.locator(`.cm-line:has-text("_SETVAL=${value}")`);
  const start = performance.now();
  await still("opened and read", () => opened(one.repeat(999_997) + call));
  row("a million lines: opened and read, s", [((performance.now() - start) / 1000).toFixed(1)]);
  await still("call opened", async () => {
    await page.locator(".call-row").click();
    await setpoint(132).waitFor();
  });
  await still("key in the editor", async () => {
    await setpoint(132).click();
    await page.keyboard.type("G");
  });
  await still("undone", () => page.keyboard.press("Control+z"));
  await still("value in the form", async () => {
    await page.locator(".call-row").click();
    await page.locator('[data-field="_SETVAL"] .entry-line > .figure').fill("133");
    await setpoint(133).waitFor();
  });
  await still("replaced", () => opened(`G0 X1\r\n${call}`));
  await still("brought back", async () => {
    await page.locator(".notice").getByRole("button", { name: "Undo" }).click();
    await setpoint(133).waitFor({ state: "detached" });
  });
}

// A surface scanned with a million points in the page: how long it stands still from the click until the points are
// drawn, and while the view is turned then. A visit of its own, so that nothing else is drawn.
async function scanInPage(browser) {
  const { page, context } = await open(browser);
  await page.locator(".tree:not([aria-busy])").waitFor({ state: "attached" });
  await searchTasks(page, "G65 P9969");
  await page.locator('.hits[data-search="G65 P9969"] .hit').first().click();
  for (const [name, value] of Object.entries(MILLION))
    await page.locator(`.field[data-field="${name}"] input`).first().fill(value);
  await page.locator("#tab-scan").click();
  await page.locator(".stage [data-backend]").waitFor();
  await page.waitForTimeout(1000); // the form has drawn its own small scan
  const still = async (name, doing) => {
    const longest = await standstill(page, doing);
    row(`a million points, ${name}: standstill, ms`, [
      longest.toFixed(0),
      "",
      "",
      `< ${STANDSTILL}`,
      verdict(longest, STANDSTILL),
    ]);
  };
  const start = performance.now();
  await still("scanned and drawn", async () => {
    await page.locator("#page-scan button.primary").click();
    await page.locator(".scan-result").waitFor({ timeout: 120_000 });
    row("a million points in the page: scanned and compared, s", [((performance.now() - start) / 1000).toFixed(1)]);
    await page.locator("[role=application][data-drawn]").waitFor();
  });
  await still("turned", async () => {
    const stage = await page.locator(".stage").boundingBox();
    const [x, y] = [stage.x + stage.width / 2, stage.y + stage.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let n = 1; n <= 60; n++) await page.mouse.move(x + 3 * n, y + n);
    await page.mouse.up();
  });
  await context.close();
}

/** Values of the digitizing cycle beside those of its example: they make a scan of a million points. */
const MILLION = { Q: "1", R: "0.06", J: "0.04" };

// A surface scanned with a million points, in the page's own module: scan and comparison, and the texts.
async function scan(page) {
  const [points, scanned, texts] = await page.evaluate(million => {
    const core = globalThis["bench-program"];
    const { control, cycle, example } = JSON.parse(core.catalogue()).cycles.find(one => one.surfaces.length > 0);
    const { setup } = JSON.parse(core.form(JSON.stringify({ control, cycle, values: example, predict: true })));
    const values = { ...example, ...million };
    const start = performance.now();
    const scan = new core.Scan(JSON.stringify({ control, cycle, values, setup }), new Uint8Array());
    while (!scan.advance(1000));
    const scanned = performance.now();
    const { points } = JSON.parse(scan.view());
    for (const form of ["program", "points", "surface"]) {
      for (let from = 0; from < points; from += 50_000) scan.text(form, from, from + 50_000);
    }
    return [points, (scanned - start) / 1000, (performance.now() - scanned) / 1000];
  }, MILLION);
  row(`a surface of ${points} points: scanned and compared, s`, [scanned.toFixed(1), "< 20", verdict(scanned, 20)]);
  row("its three texts, s", [texts.toFixed(1)]);
}

// The first form is all that the page has asked for until the form is painted. But for the core, which the form does
// not wait for: it begins to come while the form is made, and counts as its own part. What is asked for later, by name
// of the part, its files.
const FIRST = "first form";
const WITHOUT = /\/core_bg-/;
const LATER = "later: types, start screen, icons";
const PARTS = [
  ["editor", /\/(editor|document)-/],
  ["preview", /\/(preview|view)[-_]/],
  ["programs", /\/(core|program|worker|words-en-later)[-_]/],
  ["results, help, machine data", /\/later-/],
];

// Everything that the page fetches on its first visit, gzipped.
async function wire(browser) {
  const context = await browser.newContext({ serviceWorkers: "block" });
  const page = await context.newPage();
  const fetched = [];
  page.on("response", response => fetched.push(response));
  await page.addInitScript(() => {
    const painted = () => {
      globalThis.formPainted = performance.now();
    };
    const look = new MutationObserver(() => {
      if (!document.querySelector(".field input")) return;
      look.disconnect();
      globalThis.scheduler.postTask(painted, { priority: "user-blocking" });
    });
    look.observe(document, { subtree: true, childList: true });
  });
  await page.goto(new URL("#measure", process.env.PROBEWRIGHT_URL).href, { waitUntil: "load" });
  await page.locator(".field").first().waitFor();
  await page.waitForLoadState("networkidle");
  const before = await page.evaluate(() => {
    const asked = performance
      .getEntriesByType("resource")
      .filter(({ startTime }) => startTime <= globalThis.formPainted);
    return [location.href.replace(location.hash, ""), ...asked.map(({ name }) => name)];
  });
  const sums = Object.fromEntries([FIRST, ...PARTS.map(([name]) => name), LATER].map(name => [name, 0]));
  for (const response of fetched) {
    const name = new URL(response.url()).pathname;
    const needed = before.includes(response.url()) && !WITHOUT.test(name);
    const part = needed ? FIRST : (PARTS.find(([, files]) => files.test(name))?.[0] ?? LATER);
    const size = gzipSync(await response.body(), { level: 9 }).length;
    sums[part] += size;
    if (part === FIRST) row(`  ${name}, KB gzipped`, [(size / 1000).toFixed(1)]);
  }
  await context.close();
  for (const [part, bytes] of Object.entries(sums)) {
    const goal = part === FIRST ? ["< 250", verdict(bytes, 250_000)] : [];
    const asked = part === FIRST ? `${part}, asked for until its paint` : part;
    row(`over the wire, ${asked}, KB gzipped`, [(bytes / 1000).toFixed(1), ...goal]);
  }
}

const browser = await launch("as-it-is");
try {
  const { page, context } = await open(browser);
  await page.locator(".field").first().waitFor();
  await programModule(page);
  row("ms, in Chromium", ["50 %", "95 %", "99 %", "goal", "ratio"]);
  await cycles(page);
  await certainty(page);
  await practising(browser, page, report);
  await keystrokes(browser, page);
  await reading(page);
  await running(page);
  await scan(page);
  await manyCalls(page);
  await playing(page);
  await million(page);
  await context.close();
  await scanInPage(browser);
  await large(browser, row, verdict);
  await outside(browser, row, verdict);
  await wire(browser);
} finally {
  await browser.close();
}
