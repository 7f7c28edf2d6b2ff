/** What the core says of a first visit, asked while the page is built (`answers.ts`). */
declare module "answers:first" {
  /** Of the cycle of the first visit alone. */
  export const catalogue: import("./wire").Catalogue;
  /** Its worked measurement, carried out. */
  export const form: import("./wire").FormView;
}
