// The points of a cloud on a device: as many as it draws in a moment. A graphics card draws all of them; where the
// processor draws, a million would hold the page for seconds, at each turn of the view. The first frame has few, each
// further one twice as many for as long as they come quickly, and half as many where they do not. So they also reach
// the device in pieces.
import type { Cloud } from "./backend";
import type { Renderer, Told } from "./renderer";

export interface Points {
  set(cloud: Cloud | null): void;
  /** Before a frame: brings what of it is missing on the device. How many points are to be drawn. */
  bring(): number;
  /** After a frame: looks how long the device needs for it. */
  follow(): void;
  end(): void;
}

const FEWEST = 16_384; // points that every device draws in a moment
const QUICK = 50; // ms until the page hears of it, two frames included; with twice as many points still no standstill
const SLOW = 120;
const FLOATS = 4; // a point
const ROW = 2048; // only the last piece that is brought may be no multiple (web/preview/src/layout.rs)

/** How many points of `all` the next frame has, when the one with `drawn` took so long. */
export function howMany(drawn: number, all: number, took: number): number {
  if (took < QUICK) return Math.min(all, 2 * drawn);
  return took > SLOW ? Math.min(all, Math.max(FEWEST, Math.floor(drawn / 2))) : drawn;
}

export function createPoints(
  renderer: Pick<Renderer, "reserve_cloud" | "add_points" | "watch" | "is_drawn">,
  { again, thinned }: Pick<Told, "again" | "thinned">,
): Points {
  let cloud: Cloud | null = null;
  let there = 0; // points on the device
  let drawn = 0;
  let looking = 0; // animation frame in which the device is asked whether it has drawn
  const all = (): number => (cloud ? cloud.points.length / FLOATS : 0);
  // how long the last frame took, if it alone decides nothing: others may have held it up
  let before: number | null = null;
  const look = (begun: number): void => {
    looking = requestAnimationFrame(() => {
      looking = 0;
      if (renderer.is_drawn()) judge(Math.min(performance.now() - begun, before ?? Infinity));
      else look(begun);
    });
  };
  const judge = (took: number): void => {
    const sure = took < QUICK || before !== null;
    before = sure ? null : took;
    const next = sure ? howMany(drawn, all(), took) : drawn;
    const settled = sure && next === drawn;
    drawn = next;
    if (settled) thinned(drawn);
    else again();
  };
  const end = (): void => {
    cancelAnimationFrame(looking);
    looking = 0;
    before = null;
  };
  return {
    set(next) {
      end();
      cloud = next;
      there = 0;
      drawn = Math.min(all(), FEWEST);
      renderer.reserve_cloud(all());
    },
    bring() {
      const enough = Math.min(all(), Math.ceil(drawn / ROW) * ROW);
      if (cloud && there < enough) renderer.add_points(cloud.points.subarray(FLOATS * there, FLOATS * enough));
      there = Math.max(there, enough);
      return drawn;
    },
    follow() {
      if (looking || drawn === 0) return;
      renderer.watch();
      look(performance.now());
    },
    end,
  };
}
