// Fetches the pieces of the screen that come behind the first form.

import { painted } from "../pace";

type Later = typeof import("./later");
let later: Later | null = null;
let coming: Promise<Later> | null = null;

/**
 * A piece of the screen: null until it is there, then `made` is called. Once they were fetched pieces are there at
 * once. `stop`: nobody wants it any more.
 */
export function behind<T>(make: (pieces: Later) => T, made: () => void, stop: AbortSignal): () => T | null {
  let piece = later && make(later);
  if (!later) {
    coming ??= painted().then(() => import("./later"));
    coming.then(pieces => {
      later = pieces;
      if (stop.aborted) return;
      piece = make(pieces);
      made();
    }, console.error);
  }
  return () => piece;
}
