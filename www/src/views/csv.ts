// The record of a run as a file for spreadsheets, which the core writes, in pieces of some calls.

import type { ProgramCore } from "../core/program";
import { sliced } from "../pace";
import { t } from "../texts";
import type { RunRecord } from "../wire";
import { spoken } from "./record";

const PIECE = 200; // calls

/** The file in pieces; between them the page has its turn. */
export async function csv({ calls, files }: Pick<RunRecord, "calls" | "files">, core: ProgramCore): Promise<string[]> {
  const pieces: string[] = [];
  const pace = sliced();
  for (let first = 0; first === 0 || first < calls.length; first += PIECE) {
    await pace.turn(0);
    pieces.push(core.recordTable({ calls: spoken(calls.slice(first, first + PIECE)), first, files }, t));
  }
  return pieces;
}
