// The help picture: plain figures from the core, drawn as SVG. What belongs to the focused field stands out.

import { setAttribute, show, svg } from "../dom";
import { drawInto } from "../draw";
import { t } from "../texts";
import type { Picture } from "../wire";
import type { Size } from "./captions";
import { drawing } from "./drawing";

/** Lines at 45° for what is cut. */
function hatching(): SVGElement {
  return svg(
    "defs",
    {},
    svg(
      "pattern",
      { id: "hatch", width: 6, height: 6, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" },
      svg("rect", { width: 6, height: 6, class: "hatch-ground" }),
      svg("path", { d: "M0 0V6", class: "hatch-line" }),
    ),
  );
}

export function createPicture(
  root: HTMLElement,
  pick: (field: string) => void,
  fixed?: Size,
): (picture: Picture, focus: string | null, values: Record<string, string>) => void {
  const shapes = svg("g");
  const canvas = svg("svg", { role: "img", class: "picture" }, hatching(), shapes);
  root.append(canvas);
  let drawn: { picture: Picture; values: Record<string, string> } | null = null;
  let lit: string | null = null;
  canvas.addEventListener("click", event => {
    const field = (event.target as Element).closest("[data-field]")?.getAttribute("data-field");
    if (field) pick(field);
  });
  let size: Size = fixed ?? { width: 120, height: 100 };
  const draw = ({ picture, values }: NonNullable<typeof drawn>): void => {
    setAttribute(canvas, "viewBox", `0 0 ${size.width} ${size.height}`);
    drawInto(shapes, drawing(picture.shapes, values, size));
  };
  const light = (): void => {
    let any = false;
    for (const shape of shapes.children as HTMLCollectionOf<SVGElement>) {
      const { field, also } = shape.dataset;
      const match = lit !== null && (field === lit || also?.split(" ").includes(lit) === true);
      shape.classList.toggle("lit", match);
      any ||= match;
    }
    canvas.classList.toggle("has-lit", any);
  };
  // To ask for the size while drawing would lay out the page once more at each keystroke.
  const observer = new ResizeObserver(() => {
    size = { width: Math.max(canvas.clientWidth, 120), height: Math.max(canvas.clientHeight, 100) };
    if (drawn) draw(drawn);
    light();
  });
  if (!fixed) observer.observe(canvas);
  return (picture, focus, values) => {
    show(root, picture.shapes.length > 0);
    lit = focus;
    if (picture !== drawn?.picture || values !== drawn.values) {
      drawn = { picture, values };
      draw(drawn);
    }
    setAttribute(canvas, "aria-label", t(`picture-${picture.view}`));
    light();
  };
}
