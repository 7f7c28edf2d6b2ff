// Practising to measure in JOG: what is pressed is a line more of a script, which the core carries out.
// A line that does nothing is told, and leaves everything as it was.

import type { ProgramCore } from "../core/program";
import { linesOf } from "../eol";
import { parseNumber, plain } from "../numbers";
import { readText } from "../state/files";
import { AS_SET_UP, type JogState, profile, type State } from "../state/state";
import type { Store } from "../state/store";
import type { PracticeCallRequest, PracticeChoice, PracticeRequest, RunRecord, Setup, Vec3 } from "../wire";

export interface Practice {
  /** Asks what is on the screen, unless that is known. */
  begin(): void;
  /** Carries out a line. `field`: where a refusal is told; none: beside the keys. */
  press(line: string, field?: string): void;
  /** Moves an axis by so many mm. */
  jog(axis: string, by: number): void;
  /** Puts the probe in front of a face of the part: a point of it in the machine, and the direction out of it there. */
  face(at: Vec3, normal: Vec3): void;
  /** Opens a mask, on the piece for it. */
  open(mask: PracticeChoice): void;
  core(): ProgramCore | null;
  /** All that was measured. */
  record(): RunRecord | null;
  /** The machine as it was before the first line, its part where it really lies. */
  setup(): Setup | null;
  /** RESET; a measurement that is still seen to run is cancelled by it. */
  reset(): void;
  /** Whether a measurement is seen to run. */
  running(now: boolean): void;
  undo(): void;
  /** The machine as it was before the first line. */
  restart(): void;
  /** The part lies otherwise; by a seed: as chance puts it. */
  lay(part: JogState["part"] | number): void;
  /** The lines of a script that somebody has kept in a file. */
  take(file: File): Promise<void>;
  /** A call of a program as its mask; false: there is none. */
  call(asked: PracticeCallRequest): boolean;
  /** Whether what the mask means as a program is shown. */
  program(shown: boolean): void;
  /** Whether everybody may know how the part lies. */
  reveal(shown: boolean): void;
  change(change: Partial<JogState>): void;
}

/** Whether a control has it, as the core says. */
export const practises = (state: State, catalogue: { practises: string[] }): boolean =>
  catalogue.practises.includes(state.form.control);

type Asked = Pick<JogState, "lines" | "seed" | "part" | "piece" | "revealed">;

/** NC start, and with RESET while it measures. */
export const START = "start";
const CANCELLED = "start reset";
/** Where it is told that the probe cannot get in front of a face. */
export const FACE = "face";
/** mm: a way that is none. */
const LEAST = 1e-6;
/** A line that moves one axis by a way. */
const BY = /^jog ([XYZ])(-?[\d.]+)$/;
const SHIFT = String.raw`x=(?<x>\S+) y=(?<y>\S+) z=(?<z>\S+)`;
const LEAN = String.raw`( a=(?<a>\S+) b=(?<b>\S+))?`;
/** What the first lines of a kept script say of the part. */
const LAID = new RegExp(
  String.raw`^; part (seed=(?<seed>\d+)|${SHIFT}${LEAN} tilt=(?<tilt>\S+) size=(?<size>\S+))$`,
  "m",
);
const PIECE = /^; piece (?<piece>[a-z]+)$/m;

/** The largest number by which chance puts a part. */
const LAST_SEED = 2 ** 32 - 1;

/** The file of a script. */
export const FILE = "practice.jog";

/** A script with what it begins with, as `probewright jog` reads it. */
export function scriptOf({ lines, seed, part, seen }: JogState): string {
  const { dx, dy, dz, tilt, leanAbscissa: a, leanOrdinate: b, size } = part;
  const leans = a || b ? ` a=${plain(a)} b=${plain(b)}` : "";
  const laid =
    seed === null
      ? `; part x=${plain(dx)} y=${plain(dy)} z=${plain(dz)}${leans} tilt=${plain(tilt)} size=${plain(size)}`
      : `; part seed=${seed}`;
  const piece = seen?.piece ? [`; piece ${seen.piece}`] : [];
  return `${[laid, ...piece, ...lines].join("\n")}\n`;
}

/** The lines with which a session begins anew by the same version of the measuring cycles. */
function beginning({ seen }: JogState): string[] {
  const versions = seen?.machine.versions ?? [];
  const used = versions.find(one => one.used);
  return used && used !== versions[0] ? [used.line] : [];
}

/** What opens a mask of a call, by the other version where this one has no such mask. */
function opening(mask: string, lines: string[], { seen }: JogState): string[] {
  const masks = seen?.areas.flatMap(area => area.masks) ?? [];
  const other = seen?.machine.versions.find(one => !one.used);
  return masks.some(one => one.name === mask) || !other ? lines : [other.line, ...lines];
}

export function createPractice(store: Store, core: () => ProgramCore | null): Practice {
  const requestOf = (asked: Asked): PracticeRequest => {
    const { state } = store;
    const setup = profile(state);
    return {
      control: state.form.control,
      ...(setup ? { setup } : {}),
      ...(asked.piece ? { piece: asked.piece } : {}),
      script: asked.lines.join("\n"),
      hides: asked.seed !== null && !asked.revealed,
      ...(asked.seed === null ? { part: asked.part } : { seed: asked.seed }),
    };
  };
  const set = (jog: Partial<JogState>): void => store.update({ jog });
  /** With these lines, as far as they do something. */
  const carryOut = (change: Partial<Asked>, field = ""): void => {
    const asked = { ...store.state.jog, ...change };
    const { lines, seed, part, piece, revealed } = asked;
    const seen = core()?.practise(requestOf(asked));
    if (!seen) return;
    const { refused } = seen;
    const last = refused ? (lines[refused.line - 1] ?? "") : "";
    if (refused && lines.length === refused.line && change.lines && Object.keys(change).length === 1) {
      set({ refused: { ...refused, field, text: last } });
      return;
    }
    const done = refused ? lines.slice(0, refused.line - 1) : lines;
    const why = refused ? { ...refused, field, text: last } : null;
    const program = store.state.jog.program && (core()?.asProgram(requestOf({ ...asked, lines: done })) ?? null);
    const told = seen.mask ? store.state.jog.told : [];
    const setup = profile(store.state) ?? null;
    set({ lines: done, seed, part, piece, revealed, seen, refused: why, told, program, setup });
  };
  let running = false;
  const press = (line: string, field = ""): void => carryOut({ lines: [...store.state.jog.lines, line] }, field);
  return {
    begin() {
      const { seen, setup } = store.state.jog;
      if (!seen)
        carryOut({}); // what is kept of the last visit
      else if (setup !== (profile(store.state) ?? null)) carryOut({ piece: null });
    },
    press,
    jog(axis, by) {
      const { lines, seen } = store.state.jog;
      const [, before, way] = BY.exec(lines.at(-1) ?? "") ?? [];
      const goesOn = before === axis && !seen?.raised;
      const sum = goesOn ? Number(way) + by : by;
      const others = goesOn ? lines.slice(0, -1) : lines;
      const back = goesOn && Math.abs(sum) < LEAST; // it is where it was
      carryOut({ lines: back ? others : [...others, `jog ${axis}${plain(sum)}`] });
    },
    face(at, normal) {
      const { jog } = store.state;
      const found = core()?.approach({ practice: requestOf(jog), at, normal });
      if (found?.line) press(found.line, FACE);
      else if (found?.refused)
        set({ refused: { line: jog.lines.length + 1, message: found.refused, field: FACE, text: "", left: 0 } });
    },
    open({ name, piece }) {
      set({ told: [] });
      const { seen, lines } = store.state.jog;
      const here = !seen?.piece || seen.piece === piece;
      const first = here ? lines : beginning(store.state.jog);
      carryOut({ lines: [...first, `mask ${name}`], ...(here ? {} : { piece }) });
    },
    core,
    record: () => core()?.practiceRecord(requestOf(store.state.jog), FILE) ?? null,
    setup: () => core()?.practiceSetup(requestOf(store.state.jog)) ?? null,
    reset() {
      const { lines } = store.state.jog;
      const cancels = running && lines.at(-1) === START;
      running = false;
      if (cancels) carryOut({ lines: [...lines.slice(0, -1), CANCELLED] });
      else press("reset");
    },
    running(now) {
      running = now;
    },
    undo: () => carryOut({ lines: store.state.jog.lines.slice(0, -1) }),
    restart: () => carryOut({ lines: beginning(store.state.jog), seed: store.state.jog.seed }),
    lay(part) {
      const mask = store.state.jog.seen?.mask;
      const lines = [...beginning(store.state.jog), ...(mask ? [`mask ${mask.name}`] : [])];
      const lies = typeof part === "number" ? { seed: part, part: AS_SET_UP } : { seed: null, part };
      carryOut({ lines, ...lies, revealed: typeof part !== "number" });
    },
    async take(file) {
      const reader = core();
      const text = reader ? await readText(file, reader) : "";
      if (typeof text !== "string") return set({ refused: { field: "", text: "", line: 0, message: text, left: 0 } });
      const laid: Record<string, string | undefined> = LAID.exec(text)?.groups ?? {};
      const { seed, x, y, z, a, b, tilt, size } = laid;
      if (seed && Number(seed) > LAST_SEED) {
        const message = { key: "document-whole-range", args: { path: "seed", value: seed, min: 0, max: LAST_SEED } };
        return set({ refused: { field: "", text: seed, line: 1, message, left: 0 } });
      }
      const number = (value: string | undefined): number => parseNumber(value ?? "") ?? 0;
      const part = {
        dx: number(x),
        dy: number(y),
        dz: number(z),
        tilt: number(tilt),
        leanAbscissa: number(a),
        leanOrdinate: number(b),
        size: number(size),
      };
      const known = PIECE.exec(text)?.groups?.piece;
      const pieces = store.state.jog.seen?.areas.flatMap(area => area.masks) ?? [];
      const piece = pieces.find(one => one.piece === known)?.piece ?? null;
      const written = linesOf(text).map((line, place) => ({
        line: line.replace(/[;#].*$/, "").trim(),
        number: place + 1,
      }));
      const says = written.filter(({ line }) => line);
      const lines = says.map(({ line }) => line);
      carryOut({ lines, seed: seed ? Number(seed) : null, part, piece, revealed: !seed });
      const { refused } = store.state.jog;
      if (refused) set({ refused: { ...refused, line: says[refused.line - 1]?.number ?? refused.line } });
    },
    call(asked) {
      const found = core()?.asMask(asked);
      if (!found) return false;
      const { mask, told } = found;
      const { seen, lines: before } = store.state.jog;
      const lines = opening(mask.name, found.lines, store.state.jog);
      const here = !seen?.piece || seen.piece === mask.piece;
      set({ told });
      carryOut(here ? { lines: [...before, ...lines] } : { lines, piece: mask.piece });
      return true;
    },
    program(shown) {
      set({ program: shown ? (core()?.asProgram(requestOf(store.state.jog)) ?? null) : null });
    },
    reveal: revealed => carryOut({ revealed }),
    change: set,
  };
}
