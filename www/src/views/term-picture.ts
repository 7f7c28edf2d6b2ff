// The live picture of a concept: a value is dragged or typed, and the core draws what follows from it.

import type { ProgramCore } from "../core/program";
import { el, on, setAttribute, setText, show } from "../dom";
import { parseNumber, plain } from "../numbers";
import { say, t } from "../texts";
import type { ConceptExample, ConceptPicture } from "../wire";
import { unitBehind } from "./amounts";
import { createPicture } from "./picture";

export interface TermPicture {
  root: HTMLElement;
  /** The value that is shown. */
  value(): number;
}

const figure = (value: number): string => plain(value).replace("-", "−");

/** Why a typed value is none of this; empty: it is one. */
function refused(value: number | null, { from, to, unit, whole }: ConceptExample): string {
  if (value === null) return t("terms-no-number");
  const ends = { from: figure(from), to: figure(to) };
  if (whole && !Number.isInteger(value)) return t("terms-whole", ends);
  return value < from || value > to ? t("terms-range", { ...ends, unit: unitBehind(unit) }) : "";
}

export function createTermPicture(core: ProgramCore, concept: string, example: ConceptExample): TermPicture {
  const { name, label, unit, from, to, step } = example;
  const id = `drag-${concept}`;
  const slider = el("input", {
    type: "range",
    id,
    min: from,
    max: to,
    step,
    value: example.value,
    "aria-label": t("terms-drag", { what: say(label) }),
  });
  const typed = el("input", {
    type: "text",
    id: `type-${concept}`,
    inputmode: "decimal",
    class: "figure",
    autocomplete: "off",
    "aria-describedby": `limits-${concept} why-${concept}`,
  });
  const code = name ? [" ", el("code", {}, name)] : [];
  const limits = t("terms-limits", { from: figure(from), to: figure(to) });
  const why = el("p", { class: "term-why", id: `why-${concept}`, role: "alert" });
  const told = el("p", { "aria-live": "polite" });
  const box = el("div", { class: "term-picture" });
  const root = el(
    "div",
    { class: "term-live" },
    box,
    el(
      "div",
      { class: "card-row" },
      el("label", { for: typed.id }, say(label), ...code),
      el(
        "span",
        { class: "term-value" },
        el("small", { id: `limits-${concept}` }, limits),
        typed,
        el("span", { class: "unit" }, unitBehind(unit).trim()),
      ),
    ),
    why,
    slider,
    told,
  );
  const drawPicture = createPicture(box, () => typed.focus());
  let value = example.value;
  let frame = 0;
  const draw = (): void => {
    frame = 0;
    setAttribute(slider, "aria-valuetext", `${figure(value)}${unitBehind(unit)}`);
    const answer = core.conceptPicture({ concept, value });
    if ("why" in answer) return;
    drawPicture(answer.picture, name || null, answer.values);
    setText(told, toldOf(answer));
    show(told, !!answer.told);
  };
  const wrong = (reason: string): void => {
    setText(why, reason);
    show(why, reason !== "");
    setAttribute(typed, "aria-invalid", reason ? "true" : null);
  };
  const take = (next: number): void => {
    value = next;
    wrong("");
    if (frame === 0) frame = requestAnimationFrame(draw);
  };
  /** Shows it in both; the field holds it as it is typed. */
  const place = (next: number): void => {
    slider.value = String(next);
    typed.value = plain(next);
    take(next);
  };
  on(slider, "input", () => {
    typed.value = plain(Number(slider.value));
    take(Number(slider.value));
  });
  on(typed, "input", () => {
    const next = parseNumber(typed.value);
    const reason = refused(next, example);
    if (reason || next === null) {
      wrong(reason);
      return;
    }
    slider.value = String(next);
    take(next);
  });
  on(typed, "keydown", event => {
    const way = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (!way) return;
    event.preventDefault();
    place(Math.min(Math.max(value + way * step, from), to));
  });
  typed.value = plain(value);
  wrong("");
  draw();
  return { root, value: () => value };
}

const toldOf = ({ told }: ConceptPicture): string => (told ? say(told) : "");

const PAPER = { width: 640, height: 400 }; // CSS pixels: as wide as a page between its margins

/** The picture as it is printed, with its value below. */
export function printedPicture(
  core: ProgramCore,
  concept: string,
  example: ConceptExample,
  value: number,
): HTMLElement | null {
  const answer = core.conceptPicture({ concept, value });
  if ("why" in answer) return null;
  const box = el("div", { class: "concept-picture" });
  createPicture(box, () => undefined, PAPER)(answer.picture, null, answer.values);
  const what = `${say(example.label)} ${example.name}`.trim();
  const shown = t("terms-shown", { what, value: `${figure(value)}${unitBehind(example.unit)}` });
  return el("figure", {}, box, el("figcaption", {}, shown, " ", toldOf(answer)));
}
