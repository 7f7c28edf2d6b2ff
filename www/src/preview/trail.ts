// The whole path on a device. While the view moves, as fine a level of it is drawn as the device draws in a moment;
// once it rests, a picture with every motion is made out of sight, a portion at a time, so that nothing stands still
// meanwhile, and takes the place of the other.
import { inSight, LEVELS, levelFor, type Path, spansOf } from "../core/levels";
import type { Renderer, Seen, Told } from "./renderer";

export interface Trail {
  set(path: Path | null): void;
  /** What of it a frame has that is followed by others. */
  moving(seen: Seen): Uint32Array;
  /** All that is in sight. */
  whole(seen: Seen): Uint32Array;
  /** After a frame: looks how long the device needs for it, and makes the whole picture when no other one comes. */
  follow(seen: Seen, points: number): void;
  /** Another picture is asked for, or another scene. */
  stop(): void;
  end(): void;
}

const FEWEST = 16_384; // motions that every device draws in a moment
const REST = 150; // ms without another frame
export const PATH = 80; // place of the path among the uniforms

/** ms until the page hears of a frame, below which the next one may have twice as much, above which it has half. */
interface Patience {
  quick: number;
  slow: number;
}
const MOVING: Patience = { quick: 34, slow: 70 }; // two frames of the page; from there on it jerks
const RESTING: Patience = { quick: 50, slow: 120 }; // with twice as much still no standstill

function next(now: number, took: number, { quick, slow }: Patience): number {
  return took < quick ? 2 * now : took > slow ? Math.max(FEWEST, now / 2) : now;
}

const NONE = new Uint32Array();

type Drawing = Pick<Renderer, "clear_path" | "add_path" | "begin" | "go_on" | "finish" | "watch" | "is_drawn">;
type Chunks = [part: number, chunk: number][];

export function createTrail(renderer: Drawing, { trailed }: Pick<Told, "trailed">): Trail {
  let path: Path | null = null;
  let most = FEWEST; // motions of a frame while the view moves
  let portion = FEWEST; // motions that are drawn at once while it rests
  let level = 0; // of the last frame
  let measuring = 0; // animation frames in which the device is asked whether it has drawn
  let making = 0;
  let resting: ReturnType<typeof setTimeout> | undefined;

  const stop = (): void => {
    cancelAnimationFrame(making);
    clearTimeout(resting);
    making = 0;
  };
  const end = (): void => {
    stop();
    cancelAnimationFrame(measuring);
    measuring = 0;
  };
  const seenOf = (to: Path, { uniforms }: Seen): Chunks =>
    inSight(to, { matrix: uniforms, shift: [...uniforms.subarray(PATH, PATH + 3)] });
  const measure = (begun: number): void => {
    measuring = requestAnimationFrame(() => {
      measuring = 0;
      if (!renderer.is_drawn()) return measure(begun);
      const found = next(most, performance.now() - begun, MOVING);
      most = level > 0 ? found : Math.min(most, found);
    });
  };
  /** Goes on once the device has drawn what it was asked for. */
  const afterwards = (begun: number, then: () => void): void => {
    making = requestAnimationFrame(() => {
      if (!renderer.is_drawn()) return afterwards(begun, then);
      portion = next(portion, performance.now() - begun, RESTING);
      then();
    });
  };
  const make = (to: Path, seen: Seen, points: number): void => {
    end();
    const chunks = seenOf(to, seen);
    const from = (first: number): void => {
      if (first >= chunks.length) {
        making = 0;
        renderer.finish(seen.faded);
        trailed(to.motions);
        return;
      }
      const until = endOf(to, chunks, first, portion);
      renderer.go_on(spansOf(to, chunks.slice(first, until), 0));
      renderer.watch();
      afterwards(performance.now(), () => from(until));
    };
    renderer.begin(points, seen.faded);
    from(0);
  };
  return {
    set(next) {
      end();
      path = next;
      most = portion = FEWEST;
      renderer.clear_path();
      for (const { vertices, indices } of path?.parts ?? []) renderer.add_path(vertices, indices);
    },
    moving(seen) {
      if (!path) return NONE;
      const chunks = seenOf(path, seen);
      level = levelFor(path, chunks, most);
      return spansOf(path, chunks, level);
    },
    whole(seen) {
      return path ? spansOf(path, seenOf(path, seen), 0) : NONE;
    },
    follow(seen, points) {
      const to = path;
      if (!to) return;
      stop();
      if (!measuring && (level > 0 || most > FEWEST)) {
        renderer.watch();
        measure(performance.now());
      }
      if (level === 0) trailed(to.motions);
      else resting = setTimeout(make, REST, to, seen, points);
    },
    stop,
    end,
  };
}

/** The end of the chunks from one on that have so many motions together, one at least. */
function endOf({ parts }: Path, chunks: readonly (readonly [number, number])[], from: number, most: number): number {
  let count = 0;
  for (let i = from; i < chunks.length; i++) {
    const [part, chunk] = chunks[i]!;
    count += parts[part]!.counts[chunk * LEVELS]!;
    if (count > most && i > from) return i;
  }
  return chunks.length;
}
