// The live picture of a concept: a value is dragged, and the core draws what follows from it.

import type { ProgramCore } from "../core/program";
import { el, on, setAttribute, setText, show } from "../dom";
import { plain } from "../numbers";
import { say, t } from "../texts";
import type { ConceptExample } from "../wire";
import { unitBehind } from "./amounts";
import { createPicture } from "./picture";

export function createTermPicture(core: ProgramCore, concept: string, example: ConceptExample): HTMLElement {
  const { name, label, unit, from, to, step } = example;
  const id = `drag-${concept}`;
  const slider = el("input", { type: "range", id, min: from, max: to, step, value: example.value });
  const figure = el("output", { class: "figure", for: id });
  const told = el("p", { "aria-live": "polite" });
  const box = el("div", { class: "term-picture" });
  const code = name ? [" ", el("code", {}, name)] : [];
  const root = el(
    "div",
    { class: "term-live" },
    box,
    el("div", { class: "card-row" }, el("label", { for: id }, t("terms-drag", { what: say(label) }), ...code), figure),
    slider,
    told,
  );
  const drawPicture = createPicture(box, () => slider.focus());
  let frame = 0;
  const draw = (): void => {
    frame = 0;
    const value = Number(slider.value);
    const amount = `${plain(value)}${unitBehind(unit)}`.replace("-", "−");
    setText(figure, amount);
    setAttribute(slider, "aria-valuetext", amount);
    const answer = core.conceptPicture({ concept, value });
    if ("why" in answer) return;
    drawPicture(answer.picture, name || null, answer.values);
    setText(told, answer.told ? say(answer.told) : "");
    show(told, !!answer.told);
  };
  on(slider, "input", () => {
    if (frame === 0) frame = requestAnimationFrame(draw);
  });
  draw();
  return root;
}
