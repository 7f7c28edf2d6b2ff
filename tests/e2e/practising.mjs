// Speed of measuring in JOG: one function simulated, and in the page from NC start to the picture of the finished
// touch.
// What is done is tests/data/jog_practice.json, as in jog-all.spec.mjs. `bench.mjs` prints it.
import { readFileSync } from "node:fs";
import { open } from "./browser.mjs";
import { givesWork } from "./painted.mjs";

const WORK = JSON.parse(readFileSync(new URL("../data/jog_practice.json", import.meta.url), "utf8"));
const PRESSES = 30; // of NC start for each function, those that count
const FIRST = 5; // before them: they compile what the others use
const AS_LONG = 8; // ms of arithmetic between them: what the machine itself makes of as much work

/** Each function with its mask, the piece for it, and its lines as far as the last NC start, without it. */
async function functions(page) {
  const areas = await page.evaluate(() => {
    const answer = new globalThis["bench-program"].Practice().practise(
      JSON.stringify({ control: "sinumerik", script: "", hides: false }),
    );
    const { areas } = JSON.parse(answer.view());
    answer.free();
    return areas;
  });
  return areas.flatMap(area =>
    area.masks.map(({ name, piece }) => {
      const lines = [`mask ${name}`, ...WORK[name]];
      return { name, piece, lines: lines.slice(0, lines.lastIndexOf("start")) };
    }),
  );
}

/** ms of a function from the menu to its last NC start, with what it shows then and would do next. */
async function simulated(page, { piece, lines }) {
  const script = [...lines, "start"].join("\n");
  const request = JSON.stringify({ control: "sinumerik", piece, script, hides: false });
  return page.evaluate(text => {
    const core = globalThis["bench-program"];
    const times = [];
    for (let n = 0; n < 300; n++) {
      const start = performance.now();
      const session = new core.Practice();
      const answer = session.practise(text);
      answer.view();
      times.push(performance.now() - start);
      answer.free();
      session.free();
    }
    return times.slice(200).sort((a, b) => a - b);
  }, request);
}

/**
 * ms of the page's own work from a press of NC start to the layout of the frame that shows the finished touch; before
 * each press, ms of arithmetic that takes `AS_LONG` while nobody disturbs the machine.
 */
async function pictured(page, { piece, lines }) {
  const buffer = Buffer.from([`; piece ${piece}`, ...lines].join("\n"));
  await page.locator(".jog > input[type=file]").setInputFiles({ name: "part.jog", mimeType: "text/plain", buffer });
  await page.locator(".jog-start").waitFor();
  return page.evaluate(
    async ([count, first, asLong]) => {
      const pause = () => new Promise(resolve => setTimeout(resolve, 250)); // the picture before stands
      const arithmetic = steps => {
        const begin = performance.now();
        let sum = 0;
        for (let n = 0; n < steps; n++) sum += Math.sin(sum + n);
        return [performance.now() - begin, sum][0];
      };
      const fastest = Math.min(...Array.from({ length: 20 }, () => arithmetic(1e5)));
      const steps = (1e5 * asLong) / fastest;
      const [times, reference] = [[], []];
      for (let n = 0; n < count; n++) {
        await pause();
        reference.push(arithmetic(steps));
        times.push(await globalThis.workOf(() => document.querySelector(".jog-start").click()));
        await pause();
        document.querySelector(".jog-actions button").click(); // undo
      }
      return { times: times.slice(first).sort((a, b) => a - b), reference };
    },
    [PRESSES + FIRST, FIRST, AS_LONG],
  );
}

/** Prints both for every function; `page` has the program module, `browser` makes a visit of its own. */
export async function practising(browser, page, report) {
  const all = await functions(page);
  for (const one of all) report(`JOG ${one.name} simulated`, await simulated(page, one), 95, 2);
  const visit = await open(browser, { path: "#jog", reducedMotion: "reduce" });
  await visit.page.locator(".jog-stage [data-backend]").waitFor();
  await givesWork(visit.page);
  const machine = [];
  for (const one of all) {
    const { times, reference } = await pictured(visit.page, one);
    machine.push(...reference);
    report(`JOG ${one.name}: NC start to its picture`, times, 95, 16);
  }
  report(
    `the machine itself: ${AS_LONG} ms of arithmetic`,
    machine.sort((a, b) => a - b),
    95,
  );
  await visit.context.close();
}
