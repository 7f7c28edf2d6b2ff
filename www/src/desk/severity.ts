// What the outline of a program tells about each measuring call.

import type { CallView, Diagnostic, Severity } from "../wire";

const WORST: Severity[] = ["error", "warning"];

/** The worst that is said between the first line of each call and its last; null: nothing that matters. */
export function severities(calls: readonly CallView[], problems: readonly Diagnostic[]): (Severity | null)[] {
  const ends = calls.map(call => call.lastLine);
  const found = calls.map(() => new Set<Severity>());
  for (const problem of problems) {
    const line = problem.line ?? 0;
    const index = firstAtLeast(ends, line);
    const call = calls[index];
    if (call && call.line <= line) found[index]?.add(problem.severity);
  }
  return found.map(said => WORST.find(severity => said.has(severity)) ?? null);
}

/** Index of the first of ascending numbers that is not below `wanted`. */
function firstAtLeast(sorted: readonly number[], wanted: number): number {
  let low = 0,
    high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((sorted[middle] ?? 0) < wanted) low = middle + 1;
    else high = middle;
  }
  return low;
}
