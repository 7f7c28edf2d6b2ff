// The braking path of an axis as a calculator: the path of a feed, and the largest feed for the deflection that a probe
// allows. What the export of a control says of its slowest axis stands in the fields that nobody filled in.

import { html, nothing, render } from "lit-html";
import type { ProgramCore } from "../core/program";
import { el, on } from "../dom";
import { guideButton } from "../guide";
import { parseNumber, plain } from "../numbers";
import { sayProblem, t } from "../texts";
import type { BrakingRequest, BrakingView, MachineAxis } from "../wire";

const FIELDS = ["deflection", "delay", "acceleration", "gain", "feed"] as const;
type Name = (typeof FIELDS)[number];

export interface BrakingCard {
  root: HTMLElement;
  /** Deflection that the probe allows, mm; null: none is entered. */
  deflection(): number | null;
  /** The slowest axis of the export; null: it says nothing of it. */
  take(axis: MachineAxis | null): void;
}

/** Whether an axis or a probe can have this value. */
const possible = (name: Name, value: number): boolean => value > 0 || (name === "delay" && value === 0);

/** What is told; a feed is rounded down. */
function outcome({ path, feed }: BrakingView): string[] {
  const round = (value: number): number => Number(value.toFixed(4));
  const parts = path && {
    sum: round(path.sum),
    delay: round(path.delay),
    braking: round(path.braking),
    following: round(path.following),
  };
  return [
    parts ? t("braking-path", parts) : "",
    feed === undefined ? "" : t("braking-feed", { feed: Math.floor(feed * 10) / 10 }),
  ].filter(Boolean);
}

/** `changed`: the deflection is another. */
export function createBraking(core: () => ProgramCore | null, changed: () => void): BrakingCard {
  const card = el("div", { class: "braking-told", "aria-live": "polite" });
  const entries = Object.fromEntries(
    FIELDS.map(name => [name, el("input", { type: "text", id: `braking-${name}`, inputmode: "decimal" })]),
  ) as Record<Name, HTMLInputElement>;
  const fields = FIELDS.map(name =>
    el("p", {}, el("label", { for: `braking-${name}` }, t(`exported-${name}`)), entries[name]),
  );
  const root = el(
    "details",
    { class: "braking" },
    el("summary", {}, t("exported-braking")),
    guideButton("braking"),
    el("div", { class: "braking-fields" }, ...fields),
    card,
  );
  let axis: MachineAxis | null = null;

  const typed = (name: Name): number | null => {
    const value = parseNumber(entries[name].value);
    return value !== null && possible(name, value) ? value : null;
  };
  /** Marks what was typed and cannot be; whether there is such a field is told. */
  const wrong = (): Name[] => {
    const names = FIELDS.filter(name => entries[name].value.trim() !== "" && typed(name) === null);
    for (const name of FIELDS) entries[name].setAttribute("aria-invalid", String(names.includes(name)));
    return names;
  };
  const draw = (): void => {
    const of = (name: keyof MachineAxis): number | null => typed(name) ?? axis?.[name] ?? null;
    const [delay, acceleration, gain] = [of("delay"), of("acceleration"), of("gain")];
    const [feed, deflection] = [typed("feed"), typed("deflection")];
    const whole = delay !== null && acceleration !== null && gain !== null && (feed ?? deflection) !== null;
    const asked = (): BrakingRequest => ({
      delay: delay ?? 0,
      acceleration: acceleration ?? 0,
      gain: gain ?? 0,
      ...(feed === null ? {} : { feed }),
      ...(deflection === null ? {} : { deflection }),
    });
    const refused = wrong().map(name => t("braking-value", { name, value: entries[name].value.trim() }));
    const answer = whole && !refused.length ? core()?.braking(asked()) : null;
    const told = answer ? ("why" in answer ? [sayProblem(answer.why)] : outcome(answer)) : [];
    const lines = [...refused, ...told];
    render(lines.length ? lines.map(line => html`<p>${line}</p>`) : nothing, card);
  };
  for (const name of FIELDS)
    on(entries[name], "input", () => {
      draw();
      if (name === "deflection") changed();
    });
  return {
    root,
    deflection: () => typed("deflection"),
    take(given) {
      axis = given;
      for (const name of ["delay", "acceleration", "gain"] as const)
        entries[name].placeholder = given ? plain(given[name]) : "";
      draw();
    },
  };
}
