// Words of a text, as they are compared and as they are marked.

/** Between words; Chinese is written without gaps, there each character counts as a word. */
const BETWEEN = /([\s,;:."“”()/…，。；：、（）]+)|(?<=\p{Script=Han})|(?=\p{Script=Han})/u;

export interface Piece {
  text: string;
  found: boolean;
}

/** `_OVR[4]` stays whole. */
export function words(text: string): string[] {
  return text
    .split(BETWEEN)
    .filter((_, index) => index % 2 === 0)
    .filter(Boolean);
}

/** Case, accents and the mark of a name at its begin do not count. */
export function plainWord(word: string): string | null {
  return (
    word
      .toLowerCase()
      .normalize("NFKD")
      .replace(/[\u0300-\u036f]/g, "")
      .replace(/^_+(?=.)/, "") || null
  );
}

/** The whole text, cut where found words begin and end. */
export function pieces(text: string, found: readonly string[]): Piece[] {
  return text
    .split(BETWEEN)
    .filter(Boolean)
    .map(part => ({ text: part, found: found.includes(plainWord(part) ?? "") }));
}
