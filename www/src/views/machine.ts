// In which plane and with which units the machine begins. What a program says before a call counts there instead.

import type { Actions } from "../desk/actions";
import { choicesIn, el, on, setAttribute, setText } from "../dom";
import { beginning, INCH, PLANES, type State, UNITS } from "../state/state";
import { t } from "../texts";
import type { Dialect, OwnMachine, UnitFunction } from "../wire";

function unitText(control: Dialect, units: UnitFunction): string {
  const unit = t(INCH.includes(units) ? "unit-inch" : "unit-mm");
  return `${unit} · ${units}${UNITS[control].indexOf(units) > 1 ? ` ${t("machine-all-data")}` : ""}`;
}

function options(select: HTMLSelectElement, values: readonly string[], text: (value: string) => string): void {
  choicesIn(
    select,
    values.map(value => ({ value, text: text(value) })),
  );
}

export function createMachine(actions: Actions): { root: HTMLElement; draw(state: State): void } {
  const plane = el("select", { id: "machine-plane" });
  const units = el("select", { id: "machine-units" });
  const call = el("span", { class: "at-call" });
  const root = el(
    "div",
    { class: "machine", role: "group", "aria-label": t("machine") },
    el("div", {}, el("label", { for: "machine-plane" }, t("fact-plane")), plane),
    el("div", {}, el("label", { for: "machine-units" }, t("fact-unit")), units),
    call,
  );
  const change = (): void =>
    actions.begin({ plane: plane.value as OwnMachine["own"]["plane"], units: units.value as UnitFunction });
  on(plane, "change", change);
  on(units, "change", change);
  return {
    root,
    draw(state) {
      const now = beginning(state);
      options(plane, PLANES, value => `${value} · ${t(`plane-${value.toLowerCase()}`)}`);
      options(units, UNITS[state.form.control], value => unitText(state.form.control, value as UnitFunction));
      if (plane.value !== now.plane) plane.value = now.plane;
      if (units.value !== now.units) units.value = now.units;
      const { plane: at, units: unitsAt } = state.form.around ?? now;
      const other = [at !== now.plane && at, unitsAt !== now.units && unitsAt].filter(Boolean);
      setText(call, other.length ? t("machine-at-call", { functions: other.join(" ") }) : "");
      setAttribute(call, "hidden", other.length === 0);
    },
  };
}
