// What can be wrong with part and probe.

import type { ErrorSliders } from "./wire";

export const NO_ERRORS: ErrorSliders = {
  part: { dx: 0, dy: 0, dz: 0, size: 0, tilt: 0, taper: 0, outOfRound: 0 },
  probe: { skewX: 0, skewY: 0, radius: 0, preTravel: 0, repeatability: 0 },
};
