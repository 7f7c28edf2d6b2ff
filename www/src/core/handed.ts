// A long program on its way into a worker: once, in pieces, so that the page stands still for none of them; after that
// what was edited since. Questions about it come without the text.

import { difference } from "../difference";
import { pieceEnd } from "../encoding";
import type { Splice } from "../eol";
import { LONG, sliced } from "../pace";

/** What a worker is told about the text that questions are about. */
export type Told = { begin: number } | { piece: Uint8Array<ArrayBuffer> } | { edit: Splice };

const LONGEST = 2 ** 20; // characters of an edit

/** The text that lies in a worker. */
export interface Handed {
  /** Whether a text is so long that it is handed over apart from its questions. */
  takes(text: string): boolean;
  /** Hands it over; gives back by what it is known, or null where `over` says that nobody waits for it any more. */
  hand(text: string, over: () => boolean): Promise<string | null>;
}

/** `post`: to the worker. */
export function createHanded(post: (told: Told, transfer: ArrayBuffer[]) => void): Handed {
  const encoder = new TextEncoder();
  let there: string | null = null;
  let version = 0;

  const whole = async (text: string, over: () => boolean): Promise<boolean> => {
    there = null;
    post({ begin: text.length }, []);
    await new Promise(resolve => setTimeout(resolve)); // what asked has had its share of the time
    const pace = sliced();
    for (let from = 0; from < text.length && !over(); ) {
      const to = pieceEnd(text, from);
      const piece = encoder.encode(text.slice(from, to));
      post({ piece }, [piece.buffer]);
      from = to;
      await pace.turn(from / text.length);
    }
    return !over();
  };
  return {
    takes: text => text.length > LONG,
    async hand(text, over) {
      const edit = there === null ? null : difference(there, text);
      const far = there === null || (edit !== null && edit.insert.length > LONGEST);
      if (far && !(await whole(text, over))) return null;
      if (!far && edit) post({ edit }, []);
      if (far || edit) version++;
      there = text;
      return `${version}`;
    },
  };
}
