// Tables of encodings, in both directions, out of what the browser decodes: each sequence of bytes is asked for once,
// in one text with a line for each. Of two sequences for one character the first is written.

export interface Table {
  /** How many bytes the character at a byte from 0x80 on has, and its code point; -1: there is none. */
  read(bytes: Uint8Array, at: number): { length: number; point: number };
  /** null: it has no such character. */
  write(point: number): number[] | null;
}

const NONE = { length: 1, point: -1 };
const LINE = 0x0a; // no part of a character in any of them

/** The code point of each sequence, all being of the same length; -1: it is none, or more than one. */
function points(label: string, sequences: readonly number[][]): number[] {
  const width = (sequences[0]?.length ?? 0) + 1;
  const bytes = new Uint8Array(sequences.length * width);
  for (const [index, sequence] of sequences.entries()) bytes.set([...sequence, LINE], index * width);
  const lines = new TextDecoder(label).decode(bytes).split("\n");
  return sequences.map((_, index) => {
    const [only, more] = [...(lines[index] ?? "")];
    return only === undefined || more !== undefined || only === "\ufffd" ? -1 : (only.codePointAt(0) as number);
  });
}

const range = (from: number, to: number): number[] => Array.from({ length: to - from + 1 }, (_, index) => from + index);

interface Both {
  points: Map<number, number>;
  written: Map<number, number[]>;
}

/** By the bytes as a number, and back. */
function both(
  label: string,
  sequences: readonly number[][],
  into: Both = { points: new Map(), written: new Map() },
): Both {
  points(label, sequences).forEach((point, index) => {
    const sequence = sequences[index] as number[];
    if (point < 0) return;
    into.points.set(
      sequence.reduce((sum, byte) => sum * 0x100 + byte, 0),
      point,
    );
    if (!into.written.has(point)) into.written.set(point, sequence);
  });
  return into;
}

const ONE = range(0x80, 0xff).map(byte => [byte]);

export function singleByte(label: string): Table {
  const { points, written } = both(label, ONE);
  return {
    read: (bytes, at) => ({ length: 1, point: points.get(bytes[at] as number) ?? -1 }),
    write: point => (point < 0x80 ? [point] : (written.get(point) ?? null)),
  };
}

/** Single bytes, then pairs; `last`: lead bytes whose characters are written with others where there are others. */
function pairs(label: string, last: (lead: number) => boolean): Both {
  const found = both(label, ONE);
  const leads = range(0x81, 0xfe)
    .filter(lead => !found.points.has(lead))
    .sort((a, b) => Number(last(a)) - Number(last(b)) || a - b);
  return both(
    label,
    leads.flatMap(lead => range(0x40, 0xfe).map(trail => [lead, trail])),
    found,
  );
}

function readPair({ points }: Both, bytes: Uint8Array, at: number): { length: number; point: number } {
  const lead = bytes[at] as number;
  const alone = points.get(lead);
  if (alone !== undefined) return { length: 1, point: alone };
  const point = points.get(lead * 0x100 + (bytes[at + 1] ?? 0));
  return point === undefined ? NONE : { length: 2, point };
}

export function doubleByte(label: string, last: (lead: number) => boolean = () => false): Table {
  return ofPairs(pairs(label, last));
}

function ofPairs(found: Both): Table {
  return {
    read: (bytes, at) => readPair(found, bytes, at),
    write: point => (point < 0x80 ? [point] : (found.written.get(point) ?? null)),
  };
}

/** How many sequences of four bytes there are for the characters below U+10000, and the first one beyond. */
const FOUR_BELOW = 39_420;
const FOUR_BEYOND = 189_000;

/** The sequences are counted: digits of base 10 and 126 in turn. */
const four = (index: number): number[] => [
  0x81 + Math.floor(index / 12_600),
  0x30 + (Math.floor(index / 1260) % 10),
  0x81 + (Math.floor(index / 10) % 126),
  0x30 + (index % 10),
];

function counted(bytes: Uint8Array, at: number): number {
  const [a = 0, b = 0, c = 0, d = 0] = bytes.subarray(at, at + 4);
  const is = a >= 0x81 && b >= 0x30 && b <= 0x39 && c >= 0x81 && c <= 0xfe && d >= 0x30 && d <= 0x39;
  return is ? ((a - 0x81) * 10 + b - 0x30) * 1260 + (c - 0x81) * 10 + d - 0x30 : -1;
}

/** The euro as one byte is Microsoft's; it is written with two. */
function chinese(): Both {
  const found = pairs("gb18030", () => false);
  const euro = found.points.get(0x80);
  found.points.delete(0x80);
  if (euro !== undefined) found.written.set(euro, [0xa2, 0xe3]);
  return found;
}

export function gbk(): Table {
  return ofPairs(chinese());
}

/** GBK with sequences of four bytes for everything else. */
export function gb18030(): Table {
  const found = both(
    "gb18030",
    Array.from({ length: FOUR_BELOW }, (_, index) => four(index)),
    chinese(),
  );
  return {
    read(bytes, at) {
      const index = counted(bytes, at);
      if (index < 0) return readPair(found, bytes, at);
      const point =
        index < FOUR_BELOW
          ? (found.points.get(four(index).reduce((sum, byte) => sum * 0x100 + byte, 0)) ?? -1)
          : index - FOUR_BEYOND + 0x10000;
      return point < 0 || (index >= FOUR_BELOW && (point < 0x10000 || point > 0x10ffff)) ? NONE : { length: 4, point };
    },
    write(point) {
      if (point < 0x80) return [point];
      return point > 0xffff ? four(point - 0x10000 + FOUR_BEYOND) : (found.written.get(point) ?? null);
    },
  };
}
