// The search: fetched when somebody searches for the first time. Every word counts, none has to be there; what is
// written on the control counts most. A word of letters may have a slip in it.

import MiniSearch from "minisearch";
import type { AlarmInfo, Catalogue, Dialect, Elsewhere } from "../wire";
import { type Entry, entries, KINDS, type Kind } from "./entries";
import { plainWord, words } from "./words";

/** words: those of the entry that were found, to mark them. complete: everything that was typed was found in it. */
export interface Hit {
  entry: Entry;
  score: number;
  words: string[];
  complete: boolean;
}
export interface Group {
  kind: Kind;
  hits: Hit[];
}
/** `control`: the one in use, whose entries come before as good ones of another. */
export type Search = (text: string, control: Dialect) => Group[];

/** What comes with the core and is searched too. */
export interface Tables {
  readonly alarms: Promise<AlarmInfo[]>;
  readonly elsewhere: Promise<Elsewhere[]>;
}

const PREFIX_FROM = 4; // letters: shorter words stand for themselves, but the last, which is still being typed
const OWN_CONTROL = 8; // times as much as another
const CALIBRATES = 0.5; // who looks for a bore measures one more often than he calibrates in one, or says calibrate
const WHOLE_CYCLE = 0.75; // of several variants that all could be meant, against the one that is
const ELSEWHERE = 0.3; // found in the words of other languages alone, where a word may mean something else
const TITLED = 20; // who types the whole title of what belongs to no control means it
const SLIP_FROM = 5; // letters: shorter words are too near to each other

const NUMBER = /(?<=\p{L})\d{3,}/gu; // behind letters: CYCLE977, SD54600
const OWN_WORDS = ["code", "title", "words"]; // what the control and the language of the page say

export function createSearch(
  catalogue: Catalogue,
  alarms: readonly AlarmInfo[],
  elsewhere: readonly Elsewhere[] = [],
): Search {
  const all = entries(catalogue, alarms, elsewhere);
  const index = new MiniSearch<Entry>({
    fields: [...OWN_WORDS, "names", "foreign"],
    // who types the number of a cycle or datum means it
    tokenize: (text, field) => (field === "code" ? [...words(text), ...(text.match(NUMBER) ?? [])] : words(text)),
    processTerm: plainWord,
  });
  index.addAll(all);
  const options = {
    boost: { code: 6, title: 2 },
    prefix: (word: string, at: number, all: string[]) => at === all.length - 1 || word.length >= PREFIX_FROM,
    fuzzy: (word: string) => (word.length >= SLIP_FROM && /^\p{L}+$/u.test(word) ? 0.2 : false),
    weights: { prefix: 0.5, fuzzy: 0.2 },
  };
  return (text, control) => {
    const typed = words(text).map(plainWord);
    const asked = new Set(typed).size;
    const titled = ({ title, control: of }: Entry): boolean =>
      of === null && words(title).map(plainWord).join(" ") === typed.join(" ");
    const hits = index.search(text, options).flatMap((found): Hit[] => {
      const entry = all[found.id as number];
      const own = entry?.control === control ? OWN_CONTROL : 1;
      const sort = entry?.kind === "measurement" && entry.cycles[0]?.purpose.calibrates ? CALIBRATES : 1;
      const fields = Object.values(found.match).flat();
      const named = fields.includes("code"); // who names it means the cycle
      const several = entry?.kind === "measurement" && !entry.variant && entry.cycles[0]?.variants[1];
      const whole = several && !named ? WHOLE_CYCLE : 1;
      const spoken = OWN_WORDS.some(field => fields.includes(field)) ? 1 : ELSEWHERE;
      return entry
        ? [
            {
              entry,
              score: (titled(entry) ? TITLED : own) * sort * whole * spoken * found.score * found.queryTerms.length,
              words: found.terms,
              complete: found.queryTerms.length >= asked,
            },
          ]
        : [];
    });
    return grouped(hits.sort((a, b) => b.score - a.score));
  };
}

/**
 * The kind with the best hit first, if everything that was typed is in that; else in the order of the kinds, since a
 * chance word says little.
 */
function grouped(hits: Hit[]): Group[] {
  const best = ({ hits: [first] }: Group): number => (first?.complete ? first.score : 0);
  return KINDS.map((kind): Group => ({ kind, hits: hits.filter(hit => hit.entry.kind === kind) }))
    .filter(group => group.hits.length > 0)
    .sort((a, b) => best(b) - best(a));
}
