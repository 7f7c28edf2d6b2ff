// Worked measurements of the manuals, their figures and closed loops, with which an installation proves itself: the
// scenarios of the tests.

import type { Found, Kind } from "./files";

const files = import.meta.glob<string>(["../../../tests/cases/*/scenario.json", "../../../tests/cases/*/program.*"], {
  query: "?raw",
  import: "default",
  eager: true,
});

/** Folder and name of a file below tests/cases. */
const parts = (path: string): string[] => path.split("/").slice(-2);

/** Of what kind a scenario is: its folder begins with it, those of worked measurements do not. */
function kindOf(folder: string): Kind {
  if (folder.startsWith("loop_")) return "loop";
  return folder.startsWith("vector_") ? "vector" : "example";
}

/** All of them, by name. */
export function builtIn(): Found[] {
  const scenarios = Object.entries(files).filter(([path]) => path.endsWith(".json"));
  return scenarios.map(([path, text]) => {
    const [folder = ""] = parts(path);
    const beside = Object.entries(files).filter(([other]) => parts(other)[0] === folder && other !== path);
    return {
      name: folder,
      kind: kindOf(folder),
      text: async () => text,
      beside: async () => beside.map(([other, text]) => ({ name: parts(other)[1] ?? "", text })),
    };
  });
}
