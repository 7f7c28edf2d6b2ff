// The words of the page out of the Fluent files of the core and of the page: a module for each language and part, so
// that a visit fetches what it shows. `words:all` names them; nobody else knows which languages and files there are.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Plugin } from "vite";

const FALLBACK = "en"; // comes with the page, in two parts; another language comes whole when it is chosen

// What is asked for only when the form stands: cures, search words and results of the core, all that measuring,
// running, alarms and machine data say, and the words of other cycles than that of the first visit. The page's own
// words stand from the start, but for those of such a file.
const LATER_WORDS = /^([a-z0-9-]+-(help|hint|words)|result-[a-z0-9-]+) =/;
const LATER_FILES = [
  ..."advice alarms around braking changes datum definitions digitizing equipment evaluate exported foreign".split(" "),
  ..."jog lathe lists logging machine-check nct protocol record repeat run scenarios series setup syntax".split(" "),
  "jog-program",
  "commissioning",
  "tool-probe",
  "twin",
  "user-programs",
].map(name => `${name}.ftl`);
// Names of what is explained: the search finds them, and texts mark terms; what they mean comes with the help.
// A number at the end is a line of a concept; a connection has it as its own.
const NAME_OF_EXPLAINED =
  /^(connection-(?!group-|[a-z0-9-]+-is =)|(concept|term)-(?!group-|[a-z0-9-]+-(is|\d+) =))[a-z0-9-]+ =/;
const GUIDE_LINE = /^guide-[a-z-]+-\d+ =/;
const OF_CYCLE = /^cycle\d+\.ftl$/;
const TERMINAL = "report.ftl"; // never shown in the page
const HANDBOOK = "book.ftl"; // of the page's words, those of the handbook alone

type Part = "first" | "later" | "help";

/** Where a message of the core belongs; help pages are long and read by few. `first`: the file of the first cycle. */
function partOf(file: string, message: string, first: string): Part | null {
  if (file === TERMINAL) return null;
  if (NAME_OF_EXPLAINED.test(message)) return "later";
  if (/^((jog-)?help|concept|term|commission|connection|compatibility|where|guide-group)-/.test(message)) return "help";
  if (GUIDE_LINE.test(message)) return "help";
  const later = LATER_FILES.includes(file) || (OF_CYCLE.test(file) && file !== first) || LATER_WORDS.test(message);
  return later ? "later" : "first";
}

/** Messages of a text, each with its attributes. */
function messages(text: string): string[] {
  return text.split(/\n(?=[a-z#]|$)/).filter(message => /^[a-z]/.test(message));
}

/** `firstCycle`: the cycle whose words a first visit shows. */
export function words(core: string, page: string, firstCycle: Promise<string>): Plugin {
  const languages = readdirSync(core);
  const others = languages.filter(one => one !== FALLBACK);
  const files = (folder: string): string[] => readdirSync(folder).filter(name => name.endsWith(".ftl"));

  async function text(language: string, wanted: Part[]): Promise<string> {
    const first = `${(await firstCycle).toLowerCase()}.ftl`;
    const said = (folder: string, belongs: (file: string, message: string) => Part | null): string[] =>
      files(join(folder, language)).flatMap(file =>
        messages(readFileSync(join(folder, language, file), "utf8")).filter(message => {
          const part = belongs(file, message);
          return part !== null && wanted.includes(part);
        }),
      );
    const ofPage = (file: string): Part | null => {
      if (file === HANDBOOK) return null;
      return LATER_FILES.includes(file) ? "later" : "first";
    };
    return [...said(core, (file, message) => partOf(file, message, first)), ...said(page, ofPage)].join("\n");
  }

  const fetched = (of: string[], part: string): string =>
    `{ ${of.map(one => `${JSON.stringify(one)}: () => import("words:${one}/${part}").then(made => made.default)`)} }`;

  return {
    name: "words",
    resolveId: id => (id.startsWith("words:") ? `\0${id}` : null),
    async load(id) {
      const name = /^\0words:(.+)$/.exec(id)?.[1];
      if (name === undefined) return null;
      if (name === "all")
        return [
          `export { default as first } from "words:${FALLBACK}/first";`,
          `export const later = ${fetched([FALLBACK], "later")}[${JSON.stringify(FALLBACK)}];`,
          `export const whole = ${fetched(others, "whole")};`,
          `export const help = ${fetched(languages, "help")};`,
        ].join("\n");
      const [language = "", part = ""] = name.split("/");
      for (const folder of [core, page])
        for (const file of files(join(folder, language))) this.addWatchFile(join(folder, language, file));
      const wanted: Part[] = part === "whole" ? ["first", "later"] : [part as Part];
      return `export default ${JSON.stringify(await text(language, wanted))}`;
    },
  };
}

/** The file in which a module of words comes: one for each language and part, but for what comes with the page. */
export function chunkOfWords(id: string): string | undefined {
  const [, language, part] = /^\0words:([^/]+)\/(\w+)$/.exec(id) ?? [];
  if (part === "help") return `help-${language}`;
  if (part === "later") return `words-${language}-later`;
  return part === "whole" ? `words-${language}` : undefined;
}
