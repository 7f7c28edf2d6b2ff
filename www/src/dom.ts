// Small helpers over the DOM. Text always goes in as text; nothing here parses HTML.

type Value = string | number | boolean | null | undefined | EventListener;
export type Attributes = Record<string, Value>;
type Child = Node | string | null | false;

const SVG = "http://www.w3.org/2000/svg";

export function setAttribute(node: Element, name: string, value: Value): void {
  if (value === null || value === undefined || value === false) node.removeAttribute(name);
  else {
    const text = value === true ? "" : String(value);
    if (node.getAttribute(name) !== text) node.setAttribute(name, text);
  }
}

function dress(node: Element, attributes: Attributes, children: Child[]): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") node.addEventListener(name, value);
    else setAttribute(node, name, value);
  }
  for (const child of children) if (child) node.append(child);
}

/** An element with attributes (functions become listeners of that event) and children. */
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const node = document.createElement(tag);
  dress(node, attributes, children);
  return node;
}

export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const node = document.createElementNS(SVG, tag);
  dress(node, attributes, children);
  return node;
}

export function setText(node: Element, text: string): void {
  if (node.textContent !== text) node.textContent = text;
}

export function show(node: Element, visible: boolean): void {
  setAttribute(node, "hidden", !visible);
}

/** What is hidden gives the focus to another element. */
export function showElse(node: HTMLElement, visible: boolean, instead: HTMLElement): void {
  const held = !visible && node.contains(document.activeElement);
  show(node, visible);
  if (held) instead.focus();
}

/** A button that is off gives the focus to another element: the keyboard does not begin again at the page's start. */
export function setOff(button: HTMLButtonElement, off: boolean, instead: HTMLElement): void {
  const held = off && button.matches(":focus");
  button.disabled = off;
  if (held) instead.focus();
}

/** Listeners see the element that they were put on. */
export function on<K extends keyof HTMLElementEventMap>(
  node: HTMLElement,
  name: K,
  listener: (event: HTMLElementEventMap[K]) => void,
): void {
  node.addEventListener(name, listener);
}

const kept = new WeakMap<Element, Map<string, Element>>();

/**
 * Children of `parent` follow `items`: one element a key, made once, brought up to date each time, never remade while
 * its key stays.
 */
export function keyed<T, E extends Element>(
  parent: Element,
  items: readonly T[],
  key: (item: T, index: number) => string,
  make: (item: T) => E,
  update: (node: E, item: T, index: number) => void,
): void {
  const old = kept.get(parent) ?? new Map<string, Element>();
  const now = new Map<string, Element>();
  items.forEach((item, index) => {
    const name = key(item, index);
    const node = (old.get(name) as E | undefined) ?? make(item);
    old.delete(name);
    now.set(name, node);
    update(node, item, index);
  });
  for (const gone of old.values()) gone.remove();
  const focused = document.activeElement;
  let place: Element | null = parent.firstElementChild;
  for (const node of now.values()) {
    if (node === place) place = place.nextElementSibling;
    else parent.insertBefore(node, place);
  }
  // moving a node takes the focus from it
  if (focused instanceof HTMLElement && focused !== document.activeElement) focused.focus();
  kept.set(parent, now);
}

/** The options of a select; what is chosen stays so while its value does. */
export function choicesIn(select: HTMLSelectElement, all: readonly { value: string; text: string }[]): void {
  keyed(
    select,
    all,
    one => one.value,
    one => el("option", { value: one.value }),
    (node, one) => setText(node, one.text),
  );
}
