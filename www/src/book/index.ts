// The search index of the handbook, as `cargo xtask book` writes it (xtask/src/book/search.rs): a script, because a
// page from a disk may load that and fetch nothing.

/** What a section is: a page with its title, a heading, an entry: a row that begins with a name, a term. */
export const TITLE = 0;
export const HEADING = 1;
export const ENTRY = 2;
export type Sort = typeof TITLE | typeof HEADING | typeof ENTRY;

export interface Book {
  pages: [file: string, title: string][];
  sections: [page: number, sort: Sort, id: string, title: string, texts: number[]][];
  texts: string[];
}

declare global {
  var probewrightBook: ((book: Book) => void) | undefined;
}

/** Loads it from this address. */
export function loadBook(address: string): Promise<Book> {
  return new Promise((done, failed) => {
    globalThis.probewrightBook = done;
    const script = document.createElement("script");
    script.src = address;
    script.addEventListener("error", () => failed(new Error(address)));
    document.head.append(script);
  });
}
