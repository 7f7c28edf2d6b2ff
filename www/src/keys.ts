// All keys that the page knows, by where they count. Whoever listens asks here what a key means, and the sheet of keys
// shows this table, so that no key is without a line and no line without a key.

/** `Ctrl` stands for the command key too; a character that needs Shift is written as itself. */
export const KEYS = {
  page: {
    save: ["Ctrl+S"],
    open: ["Ctrl+O"],
    undo: ["Ctrl+Z"],
    redo: ["Ctrl+Y", "Ctrl+Shift+Z"],
    palette: ["Ctrl+K"],
    "next-panel": ["F6"],
    "previous-panel": ["Shift+F6"],
    keys: ["?"],
    close: ["Escape"],
  },
  // the first two are the browser's own
  form: {
    "next-field": ["Tab"],
    "previous-field": ["Shift+Tab"],
    ask: ["Enter"],
    refuse: ["Escape"],
  },
  // while a change is shown before it is made
  difference: {
    apply: ["Enter"],
    cancel: ["Escape"],
    "next-change": ["F7"],
    "previous-change": ["Shift+F7"],
  },
  list: {
    next: ["ArrowDown"],
    previous: ["ArrowUp"],
    "next-page": ["PageDown"],
    "previous-page": ["PageUp"],
    first: ["Home"],
    last: ["End"],
    unfold: ["ArrowRight"],
    fold: ["ArrowLeft"],
    choose: ["Enter", " "],
    leave: ["Escape"],
  },
  tabs: {
    "next-tab": ["ArrowRight"],
    "previous-tab": ["ArrowLeft"],
  },
  splitter: {
    nearer: ["ArrowLeft", "ArrowUp"],
    further: ["ArrowRight", "ArrowDown"],
    least: ["Home"],
    most: ["End"],
    maximise: ["Enter"],
  },
  // Tab is the browser's own; the editor has more keys, which are those of every editor
  editor: {
    "leave-editor": ["Tab"],
    find: ["Ctrl+F"],
    "next-problem": ["F8"],
    problems: ["Ctrl+Shift+M"],
    tell: ["Ctrl+I"],
    untell: ["Escape"],
  },
  // the axes where the machine is under the hand
  jog: {
    "x-minus": ["ArrowLeft"],
    "x-plus": ["ArrowRight"],
    "y-minus": ["ArrowDown"],
    "y-plus": ["ArrowUp"],
    "z-minus": ["PageDown"],
    "z-plus": ["PageUp"],
    start: ["Ctrl+Enter"],
  },
  view: {
    turn: ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"],
    shift: ["Shift+ArrowLeft", "Shift+ArrowRight", "Shift+ArrowUp", "Shift+ArrowDown"],
    "zoom-in": ["+", "="],
    "zoom-out": ["-"],
    fit: ["F"],
    top: ["1"],
    front: ["2"],
    right: ["3"],
    oblique: ["4"],
  },
} as const satisfies Record<string, Record<string, readonly string[]>>;

export type Group = keyof typeof KEYS;
export type Command<G extends Group> = keyof (typeof KEYS)[G] & string;

/** A pressed key, as the table writes it. */
function pressed(event: KeyboardEvent): string {
  const name = event.key.length === 1 ? event.key.toUpperCase() : event.key;
  const held = [
    event.ctrlKey || event.metaKey ? "Ctrl" : "",
    event.altKey ? "Alt" : "",
    event.shiftKey && /^([A-Z]|..+)$/.test(name) ? "Shift" : "",
  ];
  return [...held.filter(one => one), name].join("+");
}

/** What the key means there; null: nothing. */
export function meantBy<G extends Group>(event: KeyboardEvent, group: G): Command<G> | null {
  const key = pressed(event);
  const found = Object.entries<readonly string[]>(KEYS[group]).find(([, keys]) => keys.includes(key));
  return (found?.[0] as Command<G> | undefined) ?? null;
}

/** Whether the command key of the reader's keyboard is that of Apple; false where nobody reads. */
export const isMac = /Mac|iPhone|iPad/.test(globalThis.navigator?.platform ?? "");

/** The names of the keys that are pressed together. */
export function partsOf(key: string): string[] {
  return key.split(/\+(?=.)/);
}

/** The first key of a command, for assistive technology. */
export function ariaKey<G extends Group>(group: G, command: Command<G>): string {
  const [first = ""] = KEYS[group][command] as readonly string[];
  return first.replace("Ctrl", isMac ? "Meta" : "Control");
}
