// Scanning a surface: which one, how far it is, how far the points lie from it, and the files.

import type { Derived } from "../desk/derive";
import { el, keyed, on, setOff, setText, show } from "../dom";
import { fixed } from "../numbers";
import type { Scanner, Work } from "../scan/scanner";
import { NotTaken, readSurface, type SurfaceFile } from "../scan/surface";
import { saveFile } from "../state/files";
import type { Scanned, Shown } from "../state/scanned";
import type { State } from "../state/state";
import type { Store } from "../state/store";
import { sayProblem, t } from "../texts";
import type { ScanRequest, ScanText, Setup } from "../wire";
import { createActivity } from "./activity";
import { listProblems } from "./problem";

const OWN = "own"; // value of the choice that stands for the user's file
const SHOWN: Shown[] = ["sent", "surface"];
const WORK: Work[] = ["scanning", "taking", "writing"];
const TEXTS: [ScanText, string][] = [
  ["program", "nc"],
  ["points", "xyz"],
  ["surface", "xyz"],
];

/** Whether what the form says now is what was scanned. */
function isOf({ request }: Scanned, state: State, derived: Derived): boolean {
  return (
    request.cycle === derived.cycle.cycle &&
    request.setup === derived.view.setup &&
    request.values === state.form.values
  );
}

export function createScan(
  root: HTMLElement,
  store: Store,
  scanner: Scanner,
): (state: State, derived: Derived) => void {
  let own: SurfaceFile | null = null;
  let now: { state: State; derived: Derived } | null = null;
  const mine = el("option", { value: OWN, hidden: true });
  const examples = el("optgroup", { label: t("scan-examples") });
  const choice = el("select", { id: "scan-surface" }, examples, mine);
  const file = el("input", {
    type: "file",
    accept: ".stl,image/png,image/*",
    hidden: true,
    "aria-label": t("scan-open"),
  });
  const openButton = el("button", { type: "button", class: "quiet" }, t("scan-open"));
  const begin = el("button", { type: "button", class: "primary" }, t("scan-begin"));
  const status = el("p", { class: "empty", role: "status" });
  const alarms = el("ul", { class: "alarms" });

  const take = async (picked: File): Promise<void> => {
    try {
      own = await readSurface(picked);
      setText(mine, own.name);
      show(mine, true);
      choice.value = OWN;
      store.update({ scan: { problem: "" } });
    } catch (problem) {
      store.update({
        scan: { problem: problem instanceof NotTaken ? t(problem.refusal.key, problem.refusal.args) : String(problem) },
      });
    }
  };
  on(openButton, "click", () => file.click());
  on(file, "change", () => {
    const [picked] = file.files ?? [];
    file.value = "";
    if (picked) void take(picked);
  });
  on(begin, "click", () => {
    const setup = now?.derived.view.setup;
    if (!now || !setup) return;
    const taken = choice.value === OWN ? own : null;
    scanner.start(
      request(now.state, now.derived, setup, taken ? taken.choice : { example: choice.value }),
      taken?.bytes ?? new Uint8Array(),
    );
  });

  const working = WORK.map(work =>
    createActivity(`scan-${work}`, {
      busy: () => doing(scanner, work),
      stopped: () => null,
      stop: scanner.stop,
      again: scanner.stop,
    }),
  );
  const result = createFigures(scanner);
  root.append(
    el(
      "div",
      { class: "scan-ask" },
      el("label", { for: "scan-surface" }, t("scan-surface")),
      choice,
      file,
      openButton,
      begin,
    ),
    ...working.map(one => one.root),
    status,
    alarms,
    result.root,
  );

  return (state, derived) => {
    if (!derived.cycle.surfaces.length) return;
    keyed(
      examples,
      derived.cycle.surfaces,
      name => name,
      name => el("option", { value: name }, t(`scan-example-${name}`)),
      () => undefined,
    );
    if (!own && choice.value === OWN) choice.selectedIndex = 0; // the examples came after it
    now = { state, derived };
    const scanning = !!doing(scanner, "scanning");
    const scan = state.scan.made?.request.cycle === derived.cycle.cycle ? state.scan.made : null;
    setOff(begin, scanning || !derived.view.complete || !derived.view.setup, choice);
    for (const one of working) {
      const held = one.root.contains(document.activeElement);
      one.draw(state);
      if (held && one.root.hidden) begin.focus();
    }
    setText(status, scanning ? "" : said(state, derived, scan));
    show(status, !scanning);
    const raised = scan?.view.alarms ?? [];
    listProblems(
      alarms,
      raised.map(one => ({ ...one, severity: "error" as const })),
    );
    show(alarms, !!scan?.view.alarms.length);
    result.draw(scan);
  };
}

/** Of the scanner, unless it does something else. */
function doing(scanner: Scanner, work: Work): ReturnType<Scanner["busy"]> {
  const busy = scanner.busy();
  return busy?.work === work ? busy : null;
}

function said(state: State, derived: Derived, scan: Scanned | null): string {
  if (state.scan.problem) return t("scan-failed", { problem: sayProblem(state.scan.problem) });
  if (!derived.view.complete) return t("scan-incomplete");
  if (!scan) return t("scan-none");
  const figures = t("scan-done", { points: scan.view.points, lines: scan.view.lines });
  return isOf(scan, state, derived) ? figures : `${figures} ${t("scan-outdated")}`;
}

function request(state: State, { cycle, opened }: Derived, setup: Setup, surface: ScanRequest["surface"]): ScanRequest {
  const modal = opened ? { plane: opened.plane, units: opened.units } : {};
  return {
    control: cycle.control,
    cycle: cycle.cycle,
    values: state.form.values,
    setup,
    ...modal,
    ...(surface ? { surface } : {}),
  };
}

/** Deviations of both sorts of points, which of them are shown, and what is saved. */
function createFigures(scanner: Scanner): { root: HTMLElement; draw(scan: Scanned | null): void } {
  const rows = SHOWN.map(shown => {
    const radio = el("input", { type: "radio", name: "scan-shown", id: `scan-shown-${shown}` });
    const [greatest, mean] = [el("td", {}), el("td", {})];
    on(radio, "change", () => scanner.show(shown));
    return {
      shown,
      radio,
      greatest,
      mean,
      row: el(
        "tr",
        {},
        el("th", { scope: "row" }, radio, " ", el("label", { for: radio.id }, t(`scan-shown-${shown}`))),
        greatest,
        mean,
      ),
    };
  });
  const heads = ["scan-points", "scan-greatest", "scan-mean"].map(key => el("th", { scope: "col" }, t(key)));
  const table = el(
    "table",
    { class: "scan-figures" },
    el("caption", {}, t("scan-deviations")),
    el("thead", {}, el("tr", {}, ...heads)),
    el("tbody", {}, ...rows.map(({ row }) => row)),
  );
  const key = el(
    "p",
    { class: "scan-key" },
    ...(["outside", "level", "inside"] as const).flatMap(sort => [
      el("span", { class: `scan-dot scan-${sort}` }),
      t(`scan-${sort}`),
    ]),
  );
  const saves = TEXTS.map(([form, ending]) => {
    const button = el("button", { type: "button" }, t(`scan-save-${form}`));
    on(button, "click", () => scanner.text(form, text => saveFile(text, `scan-${form}.${ending}`)));
    return button;
  });
  const root = el(
    "section",
    { class: "scan-result", hidden: true },
    table,
    key,
    el("div", { class: "scan-files" }, ...saves),
  );
  return {
    root,
    draw(scan) {
      show(root, !!scan && scan.view.points > 0);
      for (const { shown, radio, greatest, mean } of scan ? rows : []) {
        radio.checked = scan?.shown === shown && (!!scan.clouds[shown] || !!doing(scanner, "taking"));
        const deviation = scan?.view[shown];
        setText(greatest, fixed(deviation?.greatest ?? 0));
        setText(mean, fixed(deviation?.mean ?? 0));
      }
    },
  };
}
