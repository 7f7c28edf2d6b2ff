// Long work on the page's own thread, in slices: between two of them the page draws and hears keys and clicks. One job
// at a time; it tells how far it is, and can be stopped.

/** Characters that are taken at once, without a rest for the page. */
export const LONG = 200_000;
const SLICE = 12; // ms

export interface Pace {
  /**
   * Lets the page have its turn when the slice is over. `share`: how much is done, 0 to 1. Rejects once the job is
   * stopped.
   */
  turn(share: number): Promise<void>;
}

/** Slices that nobody counts or stops. */
export function sliced(): Pace {
  let until = performance.now() + SLICE;
  return {
    async turn() {
      if (performance.now() < until) return;
      await new Promise(resolve => setTimeout(resolve));
      until = performance.now() + SLICE;
    },
  };
}

/** `since`: ms, as performance.now; `size`: characters or bytes that it is about. */
export interface Underway {
  since: number;
  share?: number;
  size: number;
}

export interface Job {
  busy(): Underway | null;
  stop(): void;
  /** Ends what is under way, and does this work. */
  start(size: number, work: (pace: Pace) => Promise<void>): Promise<void>;
}

/** The same for a part of the work, `from` and `to` being shares of the whole. */
export function within({ turn }: Pace, from: number, to: number): Pace {
  return { turn: share => turn(from + share * (to - from)) };
}

/** `changed` is called when a job begins and when it ends. */
export function createJob(changed: () => void): Job {
  let running: { underway: Underway; stopped: boolean } | null = null;

  const stop = (): void => {
    if (running) running.stopped = true;
    running = null;
  };
  return {
    busy: () => running?.underway ?? null,
    stop,
    async start(size, work) {
      stop();
      const own = { underway: { since: performance.now(), size } as Underway, stopped: false };
      running = own;
      const slices = sliced();
      const turn = async (share: number): Promise<void> => {
        own.underway.share = share;
        await slices.turn(share);
        if (own.stopped) throw new Ended();
      };
      changed();
      try {
        await work({ turn });
      } catch (problem) {
        if (!(problem instanceof Ended)) throw problem;
      } finally {
        if (running === own) running = null;
        changed();
      }
    },
  };
}

/** A job that was stopped. */
class Ended extends Error {}

/** When what is drawn now is on the screen. */
export const painted = (): Promise<void> =>
  new Promise(resolve => {
    requestAnimationFrame(() => setTimeout(resolve));
    setTimeout(resolve, 100); // a page in the background gets no animation frames
  });
