// The worked measurements of the manuals, with which an installation proves itself: the scenarios of the tests.

import type { Found } from "./files";

const files = import.meta.glob<string>(["../../../tests/cases/*/scenario.json", "../../../tests/cases/*/program.*"], {
  query: "?raw",
  import: "default",
  eager: true,
});

/** Folder and name of a file below tests/cases. */
const parts = (path: string): string[] => path.split("/").slice(-2);

/** All of them, by name. */
export function builtIn(): Found[] {
  const scenarios = Object.entries(files).filter(([path]) => path.endsWith(".json"));
  return scenarios.map(([path, text]) => {
    const [folder = ""] = parts(path);
    const beside = Object.entries(files).filter(([other]) => parts(other)[0] === folder && other !== path);
    return {
      name: folder,
      text: async () => text,
      beside: async () => beside.map(([other, text]) => ({ name: parts(other)[1] ?? "", text })),
    };
  });
}
