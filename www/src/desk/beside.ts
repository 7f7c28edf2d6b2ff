// Files beside the program: which of several files is the program, and in which one a place of an answer lies.

import type { FileStart, RecordFile } from "../wire";

/** A file that was read. */
interface Named {
  file: { name: string };
}

const isDefinition = (name: string): boolean => /[._]def$/i.test(name);
const isSubprogram = (name: string): boolean => /[._]spf$/i.test(name);
const isMain = (name: string): boolean => /[._]mpf$/i.test(name);

export { isDefinition };

const stem = (name: string): string =>
  name
    .replace(/^_N_/i, "")
    .replace(/[._](spf|mpf|nc|txt)$/i, "")
    .toUpperCase();

/** Whether two names are those of one file. */
export const sameName = (one: string, other: string): boolean => one.toUpperCase() === other.toUpperCase();

/**
 * The file that is opened as the program; null: all lie beside the one that is open. `wanted`: programs that it calls
 * and that are not here.
 */
export function mainOf<F extends Named>(files: readonly F[], wanted: readonly string[], empty: boolean): F | null {
  const programs = files.filter(({ file }) => !isDefinition(file.name));
  const main = programs.find(({ file }) => isMain(file.name)) ?? programs.find(({ file }) => !isSubprogram(file.name));
  const called = (one: F): boolean => wanted.some(name => name.toUpperCase() === stem(one.file.name));
  if (files.length === 1 && programs[0]) return called(programs[0]) && !empty ? null : programs[0];
  return main ?? (empty ? (programs[0] ?? null) : null);
}

/** In which file a line of an answer lies, and which one of it; no name: in the program itself. */
export function lineIn(files: readonly RecordFile[] | undefined, line: number): { file?: string; line: number } {
  const start = files?.findLast(one => one.line <= line);
  return start ? { file: start.name, line: line - start.line + 1 } : { line };
}

/** A line as narrow as it can be told: `L105.SPF:3`. */
export function shortLine(files: readonly RecordFile[] | undefined, of: number): string {
  const { file, line } = lineIn(files, of);
  return file === undefined ? String(line) : `${file}:${line}`;
}

/** The same for a place in the text; null: in the program itself. */
export function placeIn(files: readonly FileStart[] | undefined, from: number): { file: string; from: number } | null {
  const start = files?.findLast(one => one.from <= from);
  return start ? { file: start.name, from: from - start.from } : null;
}
