// Whether a device has the time for all effects: a graphics card has, a processor lights the corners of the surfaces
// only and draws the ground as lines. It is measured at the first frames, and again where the view has another size.
import type { Renderer, Told } from "./renderer";

export interface Effects {
  /** After a frame of so many pixels: looks how long the device needs for it. False: that is known. */
  follow(pixels: number): boolean;
  end(): void;
}

const SLOW = 30; // ms until the page hears of a frame, two frames of the page included
const LOOKS = 3; // frames of which the quickest counts: others may have held one up

/** `settled`: it is known, and the frame that was drawn last stays. */
export function createEffects(
  renderer: Pick<Renderer, "watch" | "is_drawn">,
  { again, effects }: Pick<Told, "again" | "effects">,
  settled: () => void,
): Effects {
  let all = true;
  let measured = 0; // pixels of the frames that were measured
  let looks = 0;
  let quickest = Infinity;
  let looking = 0;
  const judge = (took: number): void => {
    quickest = Math.min(quickest, took);
    looks += 1;
    const sure = quickest < SLOW || looks >= LOOKS;
    if (sure) {
      all = quickest < SLOW;
      effects(all);
    }
    if (sure) looks = LOOKS;
    if (!sure || !all) again();
    else settled();
  };
  const look = (begun: number): void => {
    looking = requestAnimationFrame(() => {
      looking = 0;
      if (renderer.is_drawn()) judge(performance.now() - begun);
      else look(begun);
    });
  };
  return {
    follow(pixels) {
      if (pixels > 1.2 * measured && all) {
        measured = pixels;
        looks = 0;
        quickest = Infinity;
      }
      if (looks >= LOOKS) return false;
      if (looking) return true;
      renderer.watch();
      look(performance.now());
      return true;
    },
    end() {
      cancelAnimationFrame(looking);
      looking = 0;
    },
  };
}
