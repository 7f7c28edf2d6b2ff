/** The words by language, made by `words.ts` beside the page's build. Each function fetches Fluent messages. */
declare module "words:all" {
  /** English, what the first form says. */
  export const first: string;
  /** The rest of English, without the help pages. */
  export const later: () => Promise<string>;
  /** Another language, without the help pages. */
  export const whole: Record<string, () => Promise<string>>;
  /** The help pages of a language. */
  export const help: Record<string, () => Promise<string>>;
}
