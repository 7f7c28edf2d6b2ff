// What is wrong with the part and with the probe. Each error is a slider and a figure.

import type { Actions } from "../desk/actions";
import type { Derived } from "../desk/derive";
import { el, on, setAttribute, setText, show } from "../dom";
import { NO_ERRORS } from "../errors";
import { parseNumber, plain } from "../numbers";
import { planeOf, type State } from "../state/state";
import type { Store } from "../state/store";
import { t } from "../texts";
import type { ErrorSliders, Outcome, Purpose, Solid } from "../wire";

interface Scale {
  reach: number;
  step: number;
  low?: number;
  unit: "mm" | "deg" | "percent";
  /** How many of the unit make 1 of the core. */
  per?: number;
}
const LENGTH: Scale = { reach: 2, step: 0.01, unit: "mm" };
const FINE: Scale = { reach: 0.2, step: 0.001, unit: "mm" };
const ANGLE: Scale = { reach: 3, step: 0.01, unit: "deg" };
/** Growth of the diameter in percent of the depth. */
const TAPER: Scale = { reach: 10, step: 0.1, unit: "percent", per: 100 };
const SCALES: { [G in keyof ErrorSliders]: Record<keyof ErrorSliders[G], Scale> } = {
  part: {
    size: { ...LENGTH, reach: 1 },
    dx: LENGTH,
    dy: LENGTH,
    dz: LENGTH,
    tilt: ANGLE,
    taper: TAPER,
    outOfRound: { ...FINE, low: 0 },
  },
  probe: {
    skewX: FINE,
    skewY: FINE,
    radius: FINE,
    preTravel: { ...FINE, low: 0 },
    repeatability: { reach: 0.02, step: 0.0001, low: 0, unit: "mm" },
  },
};

const TOUCHING: Purpose["probe"][] = ["workpiece", "tool"];
/** What else is called otherwise, or is the tool's, where a tool touches its probe. */
const OF_TOOL: string[] = ["part", "probe", "probe-skew-x", "probe-skew-y", "probe-radius"];

/** Key of the words for a group or an error, given the probe that a cycle uses. */
const wordsOf = (name: string, probe: Purpose["probe"]): string =>
  probe === "tool" && OF_TOOL.includes(name) ? `tool-${name}` : name;

/** Shapes of a part on which an error shows; an error that is not here shows on each. */
const SHOWS_ON: Partial<Record<keyof ErrorSliders["part"], (shape: Solid["shape"]) => boolean>> = {
  outOfRound: shape => ["hole", "shaft", "turned"].includes(shape),
  taper: shape => !["sphere", "surface"].includes(shape),
  tilt: shape => shape !== "sphere",
  size: shape => shape !== "surface",
};

/** Whether an error can show: on something of the part, or on the cap of a tool probe, which has no lobes. */
function acts(group: keyof ErrorSliders, name: string, solids: Solid[], probe: Purpose["probe"]): boolean {
  if (group !== "part") return true;
  if (probe === "tool") return name !== "outOfRound";
  const shows = SHOWS_ON[name as keyof ErrorSliders["part"]];
  const touched = solids.filter(({ shape }) => shape !== "chuck");
  return !shows || touched.length === 0 || touched.some(({ shape }) => shows(shape));
}

/** Axis along which a skew lies. Behind the applicate, in the order X Y Z, come the abscissa and the ordinate. */
const axisOf = (name: string, applicate: number): string => "XYZ".charAt((applicate + (name === "skewX" ? 1 : 2)) % 3);

const slug = (name: string): string => name.replace(/[A-Z]/g, letter => `-${letter.toLowerCase()}`);

type Limit = NonNullable<Outcome["limits"]>[number];

/** Up to which errors on both sides, as figures; nothing where they are not looked for. */
function range(limit: Limit | undefined, { step, per = 1 }: Scale): string {
  if (!limit) return "";
  const digits = Math.round(-Math.log10(step));
  const side = (value: number | null): string => (value === null ? "∞" : plain(Math.abs(value) * per, digits));
  return t("slider-limits", { low: side(limit.low), high: side(limit.high) });
}

function createSlider(
  id: string,
  scale: Scale,
  set: (value: number) => void,
): { root: HTMLElement; update(label: string, value: number, limit: Limit | undefined): void } {
  const { per = 1 } = scale;
  const slide = el("input", { type: "range", id, min: scale.low ?? -scale.reach, max: scale.reach, step: scale.step });
  const figure = el("input", { type: "text", inputmode: "decimal", class: "figure", autocomplete: "off" });
  const name = el("label", { for: id });
  on(slide, "input", () => set(Number(slide.value) / per));
  on(figure, "input", () => {
    const value = parseNumber(figure.value);
    if (value !== null) set(value / per);
  });
  const survived = el("output", { class: "survived", for: id });
  const root = el(
    "div",
    { class: "slider" },
    name,
    slide,
    figure,
    el("span", { class: "unit" }, t(`unit-${scale.unit}`)),
    survived,
  );
  return {
    root,
    update(label, value, limit) {
      setText(name, label);
      setAttribute(figure, "aria-label", t("slider-figure", { name: label }));
      setText(survived, range(limit, scale));
      show(survived, !!limit);
      if (Number(slide.value) / per !== value) slide.value = String(value * per);
      if ((parseNumber(figure.value) ?? Number.NaN) / per !== value) figure.value = plain(value * per);
      root.classList.toggle("moved", value !== 0);
    },
  };
}

/** Whether anything is wrong at all. */
function isMoved(errors: ErrorSliders): boolean {
  return Object.values(errors).some(group => Object.values(group).some(value => value !== 0));
}

/** `open` shows and hides them. */
export function createSliders(
  root: HTMLElement,
  open: HTMLButtonElement,
  store: Store,
  actions: Actions,
): (state: State, derived: Derived) => void {
  on(open, "click", () => store.update(state => ({ panels: { errors: !state.panels.errors } })));
  const reset = el("button", { type: "button", class: "quiet" }, t("sliders-reset"));
  on(reset, "click", actions.noErrors);
  const limits = el("button", { type: "button", class: "quiet", title: t("sliders-limits-help") }, t("sliders-limits"));
  on(limits, "click", () => store.update({ part: { limits: !store.state.part.limits } }));
  const title = el("h3", {});
  root.append(el("div", { class: "sliders-head" }, title, limits, reset));
  const updates: ((
    errors: ErrorSliders,
    survived: Limit[],
    probe: Purpose["probe"],
    solids: Solid[],
    applicate: number,
  ) => void)[] = [];
  for (const group of Object.keys(SCALES) as (keyof ErrorSliders)[]) {
    const head = el("h4", {});
    const box = el("div", { class: "slider-group", role: "group" }, head);
    updates.push((_, __, probe) => {
      const words = t(`sliders-${wordsOf(group, probe)}`);
      setText(head, words);
      setAttribute(box, "aria-label", words);
    });
    for (const [name, scale] of Object.entries(SCALES[group])) {
      const id = `${group}-${slug(name)}`;
      const slider = createSlider(`error-${id}`, scale, value => actions.error(group, name as never, value));
      box.append(slider.root);
      const limitOf = (survived: Limit[]): Limit | undefined =>
        survived.find(limit => group === "part" && limit.error === name);
      updates.push((errors, survived, probe, solids, applicate) => {
        show(slider.root, acts(group, name, solids, probe));
        slider.update(
          t(`error-${wordsOf(id, probe)}`, { axis: axisOf(name, applicate) }),
          (errors[group] as Record<string, number>)[name] ?? 0,
          limitOf(survived),
        );
      });
    }
    root.append(box);
  }
  return (state, { catalogue, cycle, view }) => {
    const counts = cycle.simulated && TOUCHING.includes(cycle.purpose.probe); // elsewhere nothing would come of them
    show(root, counts && state.panels.errors);
    show(open, counts);
    setAttribute(open, "aria-expanded", String(state.panels.errors));
    setAttribute(open, "data-moved", state.part.errors !== NO_ERRORS && isMoved(state.part.errors));
    setText(title, t("sliders-title"));
    setAttribute(limits, "aria-pressed", String(state.part.limits));
    const applicate = catalogue.applicate[planeOf(state)];
    const solids = view.outcome?.trace.solids ?? [];
    for (const update of updates)
      update(state.part.errors, view.outcome?.limits ?? [], cycle.purpose.probe, solids, applicate);
  };
}
