// Colours of the view, from the design tokens of the page. Blue, grey and orange are told apart without red and green.

/** Red, green, blue, opacity, each 0 … 1, sRGB. */
export type Rgba = [number, number, number, number];

/** CSS colours. */
export interface Colours {
  background: string;
  part: string;
  cut: string; // where a part is cut open
  edge: string;
  grid: string;
  stylus: string;
  stem: string;
  body: string;
  ring: string;
  chuck: string;
  ball: string;
  rapid: string;
  positioning: string;
  measuring: string;
  retract: string;
  touch: string;
  crash: string;
  zone: string;
  outside: string; // points of a scan that lie outside of the surface, on it, inside
  level: string;
  inside: string;
  axisX: string;
  axisY: string;
  axisZ: string;
  text: string;
  nominal: string; // a part without its errors
  chip: string; // value of a touch: its ground, edge, number and ink
  chipEdge: string;
  chipNumber: string;
  chipInk: string;
  chipPresent: string; // number of the present one
  lit: string; // what belongs to the focused field
}

export const LIGHT: Colours = {
  background: "#f1f3f6",
  part: "#c6cdd4",
  cut: "#d98a54",
  edge: "#4d5762",
  grid: "#d9dde1",
  stylus: "#98a2ac",
  stem: "#f3f1ec",
  body: "#23272d",
  ring: "#35c47c",
  chuck: "#7c8791",
  ball: "#c01830",
  rapid: "#1f6fb8",
  positioning: "#5b6f8a",
  measuring: "#f59e0b",
  retract: "#d9a860",
  touch: "#9a3d00",
  crash: "#c0007a",
  zone: "#b57900",
  outside: "#c0460a",
  level: "#3a7d5f",
  inside: "#1f4fb8",
  axisX: "#a8452f",
  axisY: "#3d7d5a",
  axisZ: "#2f5fa8",
  text: "#2a323a",
  nominal: "#2353d1",
  chip: "#ffffff",
  chipEdge: "#808a99",
  chipNumber: "#fff3dc",
  chipInk: "#9a4d00",
  chipPresent: "#14181f",
  lit: "#b3400f",
};

export const DARK: Colours = {
  background: "#15191d",
  part: "#6f7982",
  cut: "#b9703f",
  edge: "#0c1014",
  grid: "#2a3138",
  stylus: "#8b959f",
  stem: "#e6e3dc",
  body: "#2a2f36",
  ring: "#3ddc8c",
  chuck: "#5c6670",
  ball: "#d41c38",
  rapid: "#5fb0f5",
  positioning: "#8fa3bf",
  measuring: "#f59e0b",
  retract: "#c98f4e",
  touch: "#ffdfae",
  crash: "#ff5cc0",
  zone: "#f0c060",
  outside: "#ff8a4a",
  level: "#86cfa8",
  inside: "#7fa8ff",
  axisX: "#e0846d",
  axisY: "#7bc79d",
  axisZ: "#84aef0",
  text: "#dbe2e8",
  nominal: "#84a9ff",
  chip: "#14191f",
  chipEdge: "#6d7887",
  chipNumber: "#33260f",
  chipInk: "#ffb84d",
  chipPresent: "#14181f",
  lit: "#ff9a6a",
};

/** `--view-part`, `--view-axis-x` … of an element; what is not set there comes from `fallback`. */
export function coloursFrom(element: Element, fallback: Colours): Colours {
  const style = getComputedStyle(element);
  const token = (name: string) => `--view-${name.replace(/[A-Z]/g, letter => `-${letter.toLowerCase()}`)}`;
  const entries = Object.entries(fallback).map(([name, value]) => [
    name,
    style.getPropertyValue(token(name)).trim() || value,
  ]);
  return Object.fromEntries(entries) as Colours;
}

const parsed = new Map<string, Rgba>(); // a page has a few dozen colours, and every line of a scene asks for one

/**
 * `#rgb`, `#rrggbb`, `#rrggbbaa`, `rgb()`, `rgba()`; anything else through the browser, and grey where there is none.
 */
export function parse(css: string): Rgba {
  const known = parsed.get(css);
  if (known) return known;
  const colour = hex(css.trim()) ?? rgb(css.trim()) ?? byBrowser(css) ?? [0.5, 0.5, 0.5, 1];
  parsed.set(css, colour);
  return colour;
}

function hex(css: string): Rgba | null {
  const digits = /^#([0-9a-f]{3,8})$/i.exec(css)?.[1];
  if (!digits || ![3, 4, 6, 8].includes(digits.length)) return null;
  const wide = digits.length > 4 ? digits : [...digits].map(digit => digit + digit).join("");
  const part = (i: number) => parseInt(wide.slice(2 * i, 2 * i + 2), 16) / 255;
  return [part(0), part(1), part(2), wide.length === 8 ? part(3) : 1];
}

function rgb(css: string): Rgba | null {
  const inner = /^rgba?\(([^)]*)\)$/i.exec(css)?.[1];
  const numbers = inner
    ?.split(/[\s,/]+/)
    .filter(Boolean)
    .map(Number);
  if (!numbers || numbers.length < 3 || numbers.some(Number.isNaN)) return null;
  return [numbers[0]! / 255, numbers[1]! / 255, numbers[2]! / 255, numbers[3] ?? 1];
}

function byBrowser(css: string): Rgba | null {
  if (typeof document === "undefined" || !CSS.supports("color", css)) return null;
  const context = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  if (!context) return null;
  context.fillStyle = css;
  context.fillRect(0, 0, 1, 1);
  const [r, g, b, a] = context.getImageData(0, 0, 1, 1).data;
  return [r! / 255, g! / 255, b! / 255, a! / 255];
}

export function css([r, g, b, a]: Rgba): string {
  const byte = (value: number) => Math.round(255 * Math.min(1, Math.max(0, value)));
  return `rgb(${byte(r)} ${byte(g)} ${byte(b)} / ${Math.round(a * 1000) / 1000})`;
}
