// Every component in every state, made by the functions of the page, for the test that looks at them
// (tests/e2e/components.spec.mjs). ?theme=dark shows the dark theme. Not part of the built page.

import "../styles/main.css";
import "../styles/fonts.css";
import "../styles/start.css";
import "../styles/components.css";
import { render } from "lit-html";
import { changes } from "../changes";
import { loadProgramCore } from "../core/program";
import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { el, setAttribute } from "../dom";
import { createEditor } from "../editor/editor";
import { editorWords } from "../editor/words";
import { icon } from "../icons";
import { speak } from "../language";
import { basis, initial, turn, type ViewName } from "../preview/camera";
import { PICTOGRAMS, pictogram } from "../start/pictogram";
import { firstState, type Panel, patched, SHEETS } from "../state/state";
import { createStore } from "../state/store";
import { t } from "../texts";
import { createCube } from "../views/cube";
import { createChangeList } from "../views/difference";
import { createExaggeration } from "../views/exaggerate";
import { createField } from "../views/field";
import { gaugePicture } from "../views/gauge";
import { createKeys } from "../views/keys";
import { createMenu } from "../views/menu";
import { listProblems } from "../views/problem";
import { createWhole } from "../views/whole";
import type { BandKind, Diagnostic, Field, RunAnswer, RunView } from "../wire";
import { createRail } from "./rail";
import { createSheetBar } from "./sheet";

type States = [state: string, node: Node][];

/** Nothing that is done here has consequences. */
const actions = new Proxy({}, { get: () => () => undefined }) as Actions;
const store = createStore(
  firstState(),
  () => undefined,
  () => undefined,
);
const PANELS: Panel[] = ["tasks", "form", "view", "program", "results", "help"];
const SEVERITIES = ["error", "warning", "note"] as const;

function component(name: string, states: States): HTMLElement {
  const figures = states.map(([state, node]) => el("figure", { "data-state": state }, node));
  return el("section", { "data-component": name }, el("h2", {}, name), el("div", { class: "states" }, ...figures));
}

function buttons(): States {
  const kinds = { primary: "primary", plain: "", quiet: "quiet" };
  const pairs = Object.entries(kinds).flatMap(([name, sort]): States => {
    const one = (disabled: boolean): HTMLElement =>
      el("button", { type: "button", class: sort, disabled }, t("form-copy-call"));
    return [
      [name, one(false)],
      [`${name}, disabled`, one(true)],
    ];
  });
  const name = t("history");
  return [
    ...pairs,
    ["icon", el("button", { type: "button", class: "quiet icon-button", "aria-label": name }, icon("history"))],
  ];
}

const told = (severity: Diagnostic["severity"]): Diagnostic =>
  ({
    severity,
    code: "PW000",
    message: { key: "history-undo-none" },
    hint: { key: "history-redo-none" },
  }) as Diagnostic;

function fields(all: readonly Field[]): States {
  const made: States = [];
  const one = (state: string, field: Field | undefined, problems: Diagnostic[] = []): void => {
    if (!field) return;
    const name = `${field.name}-${made.length}`; // an identity of its own
    const view = createField(
      { ...field, name },
      actions,
      () => undefined,
      () => undefined,
    );
    view.update({ ...field, name }, field.value, problems, null);
    made.push([state, view.root]);
  };
  const real = all.find(field => field.kind === "real" && field.unit && field.required);
  one("value", real && { ...real, value: "50.02" });
  one("empty", real && { ...real, value: "" });
  one("expression", real && { ...real, value: "50.02", expression: "R2" });
  for (const severity of SEVERITIES) one(severity, real, [told(severity)]);
  for (const kind of ["choice", "digits", "text", "integer"] as const)
    one(
      kind,
      all.find(field => field.kind === kind),
    );
  return made;
}

function gauges(): States {
  const one = (kind: BandKind, value: number): [string, Node] => {
    const root = el("div", {});
    const bands = [
      { kind: "bad" as const, from: -0.04, to: -0.03 },
      { kind: "mean" as const, from: -0.03, to: -0.02 },
      { kind: "good" as const, from: -0.02, to: 0.02 },
      { kind: "mean" as const, from: 0.02, to: 0.03 },
      { kind: "bad" as const, from: 0.03, to: 0.04 },
    ];
    const marks = [{ value: -0.03 }, { value: 0.03 }] as Parameters<typeof gaugePicture>[0]["marks"];
    const needles = [{ label: "", value, kind }];
    render(gaugePicture({ unit: "mm", low: -0.04, high: 0.04, bands, marks, needles }), root);
    return [kind, root];
  };
  return [one("good", 0.01), one("mean", 0.025), one("bad", 0.05)];
}

function findings(): States {
  return SEVERITIES.map(severity => {
    const list = el("ul", {});
    listProblems(list, [told(severity)]);
    return [severity, list];
  });
}

function rails(): States {
  return (["form", "program"] as const).map(panel => {
    const rail = createRail(actions, PANELS);
    rail.draw(patched(store.state, { panels: { panel } }));
    return [panel, rail.root];
  });
}

function sheets(): States {
  return SHEETS.map(sheet => {
    const bar = createSheetBar(el("div"), actions);
    bar.draw(patched(store.state, { panels: { sheet } }));
    return [sheet, bar.root];
  });
}

function tabs(): States {
  return [0, 1].map(chosen => {
    const all = ["form", "program"].map((name, at) =>
      el("button", { type: "button", role: "tab", "aria-selected": String(at === chosen) }, t(`panel-${name}`)),
    );
    return [String(chosen), el("div", { class: "tabs", role: "tablist", "aria-label": t("panels") }, ...all)];
  });
}

function segments(): States {
  return [0, 1].map(chosen => {
    const all = ["form", "program"].map((name, at) =>
      el("button", { type: "button", "aria-pressed": String(at === chosen) }, t(`view-${name}`)),
    );
    return [String(chosen), el("div", { class: "segments", role: "group", "aria-label": t("view-source") }, ...all)];
  });
}

function floating(): States {
  const entries = (["undo", "redo"] as const).map(name =>
    el("button", { type: "button", class: "quiet" }, icon(name), el("span", {}, t(name))),
  );
  const menu = createMenu("menu-shown", t("form-more"), entries);
  const toast = el("div", { class: "notice" }, el("span", {}, t("notice-copied")), el("button", {}, t("undo")));
  const keys = createKeys();
  setAttribute(keys, "open", true);
  const list = createChangeList();
  list.show(changes("G0 X1\nG1 Y2\nM5\n", [{ from: 10, to: 11, insert: "3" }]));
  return [
    ["menu", el("div", {}, menu.button, menu.list)],
    ["notice", toast],
    ["difference", list.root],
    ["dialog", keys],
  ];
}

function tables(): States {
  const row = (cell: "th" | "td", ...texts: string[]): HTMLElement =>
    el("tr", {}, ...texts.map(one => el(cell, {}, one)));
  const head = el("thead", {}, row("th", t("panel-form"), t("panel-results")));
  return [["table", el("table", {}, head, el("tbody", {}, row("td", "A", "+0.030"), row("td", "B", "-0.010")))]];
}

function sliders(): States {
  return [1, 100].map(errors => {
    const card = createExaggeration(store);
    card.draw(patched(store.state, { view: { errors } }), null);
    return [`×${errors}`, card.root];
  });
}

const BLOCKS = "N10 G17 G54 ; zero\nR1=1 R2=50\nMEASURE\nM30\n";

function editors(): States {
  const call = { from: 2, to: 3, open: true };
  const shown = {
    program: {},
    "call in the form": { marks: { calls: [call], step: null, hints: [{ line: 3, text: "Ø 50.030" }] } },
    step: { marks: { calls: [{ ...call, open: false }], step: 3 } },
    problem: { problems: [{ from: 24, to: 29, severity: "error" as const, message: "PW000" }] },
    value: { values: { all: [{ field: "R2", from: 27, to: 29 }], lit: "R2" } },
  };
  return Object.entries(shown).map(([state, part]) => {
    const box = el("div", { class: "editor" });
    const editor = createEditor(box, editorWords(), {
      typed: () => BLOCKS,
      moved: () => undefined,
      pointed: () => null,
    });
    editor.set({ text: BLOCKS, ...part });
    return [state, box];
  });
}

function cubes(): States {
  return (["iso", "top", "back"] satisfies ViewName[]).map(name => {
    const camera = turn(initial(), name);
    const cube = createCube({
      setView: () => undefined,
      turn: () => undefined,
      basisOf: of => basis(of ? turn(camera, of) : camera),
    });
    cube.draw(camera);
    return [name, cube.root];
  });
}

/** A hole that is this much too large. */
function measured(kind: BandKind, verdict: RunAnswer["verdict"], deviation: number, line: number): RunAnswer {
  const words = { key: "notice-copied", args: {} };
  const bands = [
    { kind: "bad" as const, from: -0.04, to: -0.03 },
    { kind: "good" as const, from: -0.03, to: 0.03 },
    { kind: "bad" as const, from: 0.03, to: 0.04 },
  ];
  const needles = [{ label: "", value: deviation, kind }];
  const limits = { low: -0.03, high: 0.03, used: Math.abs(deviation) / 0.03 };
  const named = { name: "", label: words, heading: words, symbol: "Ø", unit: "mm" };
  const figure = { ...named, actual: 50 + deviation, set: 50, limits };
  const calibration = { key: "panel-form", args: {} };
  return {
    from: line,
    to: line,
    line,
    feature: { key: "panel-form", args: {} },
    figures: [{ ...figure, deviation }],
    corrected: [],
    gauge: { unit: "mm", low: -0.04, high: 0.04, bands, marks: [], needles },
    verdict,
    verdict_words: { key: "panel-results", args: {} },
    why: words,
    probe: { number: 1, tool: false, name: words, state: verdict === "beyond" ? "differs" : "run", calibration },
    alarms: verdict === "beyond" ? ["62304"] : [],
  };
}

function wholes(): States {
  const rows = [
    measured("good", "within", 0.01, 3),
    measured("bad", "beyond", 0.05, 6),
    { ...measured("bad", "alarm", 0, 9), figures: [] },
  ];
  return [rows.slice(0, 1), rows].map(answers => {
    const none = (): undefined => undefined;
    const ways = {
      paper: none,
      series: none,
      program: () => null,
      core: () => null,
      arrows: none,
      real: none,
      certain: none,
    };
    const whole = createWhole(store, actions, none, ways);
    const run = { answers, finished: true, about: { machine: "" } } as unknown as RunView;
    const derived = { run, read: { calls: [] }, step: 3 } as unknown as Derived;
    whole.draw(patched(store.state, { view: { source: "program" } }), derived);
    return [`${answers.length} rows`, el("div", { class: "results-main" }, whole.root)]; // it is as wide as its panel
  });
}

const theme = new URLSearchParams(location.search).get("theme");
setAttribute(document.documentElement, "data-theme", theme ?? "light");
const core = await loadProgramCore();
await speak("en");
const [cycle] = core.catalogue().cycles;
const form = cycle && core.form({ control: cycle.control, cycle: cycle.cycle, values: {} });
document.body.append(
  el(
    "main",
    { class: "components" },
    component("button", buttons()),
    component("field", fields(form?.fields ?? [])),
    component("finding", findings()),
    component("gauge", gauges()),
    component("segments", segments()),
    component("tabs", tabs()),
    component("table", tables()),
    component("whole", wholes()),
    component("editor", editors()),
    component("cube", cubes()),
    component("slider", sliders()),
    component("sheet", sheets()),
    component("rail", rails()),
    component("floating", floating()),
    component(
      "pictogram",
      PICTOGRAMS.map(one => [one.element, pictogram(one)]),
    ),
  ),
);
await document.fonts.ready;
setAttribute(document.documentElement, "data-ready", true);
