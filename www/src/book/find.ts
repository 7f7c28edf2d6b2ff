// Finding in the handbook: every word that is asked for has to be there, as a part of the text, so that Chinese needs
// no gaps. Case and accents do not count; a title counts more than a heading, a heading more than text.

import { type Book, ENTRY, HEADING, type Sort, TITLE } from "./index";

export interface Piece {
  text: string;
  found: boolean;
}
export interface Hit {
  page: string;
  title: string;
  /** Of the section, below the folder of the language. */
  address: string;
  excerpt: Piece[];
}
export interface Found {
  count: number;
  /** The best ones. */
  hits: Hit[];
}

const WEIGHT: Record<Sort, number> = { [TITLE]: 8, [HEADING]: 4, [ENTRY]: 4 };
const OF_THE_PAGE = 0.5; // the title of its page, for a section in which other words were found
const LINES = 40; // that are shown
const OF_A_PAGE = 5; // of them: variants of a cycle say much alike
const WORD = 15; // characters of a long one
const AROUND = 60; // characters before and after the first word of an excerpt

/** As it is compared. */
export function fold(text: string): string {
  return text.toLowerCase().normalize("NFKD").replace(/\p{M}/gu, "").replaceAll("ß", "ss");
}

/** Words that are asked for, none within another. */
export function terms(asked: string): string[] {
  const all = [...new Set(fold(asked).split(/\s+/u).filter(Boolean))];
  return all.filter(one => !all.some(other => other !== one && other.includes(one)));
}

const LETTER = /[\p{L}\p{N}_]/u;

/** How well a folded text has a word: 0 not at all, more at the begin of a word or a text, most as the whole text. */
function match(text: string, term: string): number {
  if (text === term) return 6;
  let best = 0;
  for (let at = text.indexOf(term); at >= 0 && best < 3; at = text.indexOf(term, at + 1)) {
    const begins = !LETTER.test(text[at - 1] ?? " ");
    const ends = !LETTER.test(text[at + term.length] ?? " ");
    best = Math.max(best, begins ? (ends ? 3 : 2) : 1, at === 0 ? 3 : 0);
  }
  return best;
}

interface Section {
  at: number; // in the book
  score: number;
  text: string; // of which there is an excerpt
}

/** Prepares the search. */
export function createFind(book: Book): (asked: string) => Found {
  const texts = book.texts.map(fold);
  const pages = book.pages.map(([, title]) => fold(title));
  const titles = book.sections.map(([, , , title]) => fold(title));

  /** `inTexts`: how well each text has each word; `phrase`: all of them, one behind the other, which need not be. */
  function scored(at: number, asked: string[], inTexts: Float32Array[], phrase: string): Section | null {
    const [page, sort, , , told] = book.sections[at] ?? [0, TITLE, "", "", []];
    let score = 0;
    let own = false;
    let text = told[0];
    let best = 0;
    for (const [index, term] of asked.entries()) {
      const title = WEIGHT[sort] * match(titles[at] ?? "", term);
      let found = 0;
      for (const number of told) {
        const here = inTexts[index]?.[number] ?? 0;
        found = Math.max(found, here);
        if (here > best) [best, text] = [here, number];
      }
      const around = sort === TITLE ? 0 : OF_THE_PAGE * match(pages[page] ?? "", term);
      if (title + found + around === 0) return null;
      own ||= title + found > 0;
      score += Math.max(title, found, around);
    }
    if (asked.length > 1) {
      const inPhrase = told.map(number => match(texts[number] ?? "", phrase));
      score += Math.max(WEIGHT[sort] * match(titles[at] ?? "", phrase), ...inPhrase, 0);
    }
    return own ? { at, score, text: text === undefined ? "" : (book.texts[text] ?? "") } : null;
  }

  return typed => {
    const asked = terms(typed);
    if (asked.length === 0) return { count: 0, hits: [] };
    const inTexts = asked.map(term => Float32Array.from(texts, text => match(text, term)));
    const phrase = fold(typed).trim().replace(/\s+/gu, " ");
    const all = book.sections.flatMap((_, at) => scored(at, asked, inTexts, phrase) ?? []);
    const length = ({ at }: Section): number => book.sections[at]?.[4].length ?? 0; // a short one says little else
    all.sort((one, other) => other.score - one.score || length(one) - length(other) || one.at - other.at);
    const shown = new Map<number, number>(); // hits by page
    const hits = all.filter(({ at }) => {
      const page = book.sections[at]?.[0] ?? 0;
      const count = (shown.get(page) ?? 0) + 1;
      shown.set(page, count);
      return count <= OF_A_PAGE;
    });
    return { count: all.length, hits: hits.slice(0, LINES).map(one => hit(book, one, asked)) };
  };
}

function hit(book: Book, { at, text }: Section, asked: string[]): Hit {
  const [page, sort, id, title] = book.sections[at] ?? [0, TITLE, "", ""];
  const [file, name] = book.pages[page] ?? ["", ""];
  const address = sort === TITLE ? file : `${file}#${id}`;
  return { page: sort === TITLE ? "" : name, title, address, excerpt: excerpt(text, asked) };
}

/** The next place to cut a text on this side: at a gap, if there is one soon. */
function gap(characters: readonly string[], from: number, side: 1 | -1): number {
  for (let steps = 0; steps < WORD; steps++)
    if (characters[from + side * steps] === " ") return from + side * steps + (side > 0 ? 1 : 0);
  return from;
}

/** The text around the first word that was found, cut where found words begin and end. */
export function excerpt(text: string, asked: string[]): Piece[] {
  const characters = [...text];
  const origins: number[] = []; // character from which each unit of the folded text came
  let folded = "";
  for (const [index, character] of characters.entries()) {
    const part = fold(character);
    for (let unit = 0; unit < part.length; unit++) origins.push(index);
    folded += part;
  }
  const found = new Set<number>(); // characters that were found
  let first = characters.length;
  for (const term of asked)
    for (let at = folded.indexOf(term); at >= 0; at = folded.indexOf(term, at + term.length)) {
      first = Math.min(first, origins[at] ?? first);
      for (let unit = at; unit < at + term.length; unit++) found.add(origins[unit] ?? 0);
    }
  if (found.size === 0) first = 0;
  const from = first <= AROUND ? 0 : gap(characters, first - AROUND, 1);
  const to = first + 2 * AROUND >= characters.length ? characters.length : gap(characters, first + 2 * AROUND, -1);
  const pieces: Piece[] = from > 0 ? [{ text: "… ", found: false }] : [];
  for (let at = from; at < to; at++) {
    const last = pieces.at(-1);
    if (last?.found === found.has(at)) last.text += characters[at];
    else pieces.push({ text: characters[at] ?? "", found: found.has(at) });
  }
  return to < characters.length ? [...pieces, { text: " …", found: false }] : pieces;
}
