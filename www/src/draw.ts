// SVG as plain data, brought into the document by changing what differs: to make all of it anew at each keystroke costs
// the browser several times as much.

import { type Attributes, setAttribute, setText, svg } from "./dom";

/** An element to be; `text` or `children`, not both. */
export interface Drawn {
  tag: keyof SVGElementTagNameMap;
  attributes: Attributes;
  text?: string;
  children?: Drawn[];
}

/**
 * The children of `parent` become these, each made from the one that stood in its place if it is of the same kind and
 * explains the same parameter: whoever lights a parameter has marked the element.
 */
export function drawInto(parent: Element, wanted: readonly Drawn[]): void {
  wanted.forEach((one, index) => {
    const there = parent.children[index];
    const node = there && continues(there, one) ? there : svg(one.tag);
    if (!there) parent.append(node);
    else if (there !== node) there.replaceWith(node);
    dress(node, one);
  });
  while (parent.children.length > wanted.length) parent.lastElementChild?.remove();
}

/** As an element was drawn last: asking the document instead costs more than drawing. */
const before = new WeakMap<Element, Attributes>();

const continues = (there: Element, { tag, attributes }: Drawn): boolean =>
  there.tagName === tag && before.get(there)?.["data-field"] === attributes["data-field"];

/** Without asking what stands there: `before` knows. */
function write(node: Element, name: string, value: Attributes[string]): void {
  if (typeof value === "number" || typeof value === "string") node.setAttribute(name, String(value));
  else setAttribute(node, name, value);
}

function dress(node: Element, { attributes, text, children }: Drawn): void {
  const old = before.get(node) ?? {};
  for (const name in old) if (!(name in attributes)) node.removeAttribute(name);
  for (const name in attributes) if (attributes[name] !== old[name]) write(node, name, attributes[name]);
  before.set(node, attributes);
  if (children) drawInto(node, children);
  else setText(node, text ?? "");
}
