// A dialog that is made when it is opened and gone when it is closed: nothing of it is kept.

import { el, on } from "../dom";

type Child = Parameters<typeof el>[2];

/**
 * With its title and what stands beside that, what scrolls, and its buttons; `id`: of the title, from which its other
 * names come.
 */
export function passingDialog(
  id: string,
  title: string,
  body: Child[],
  buttons: Child[],
  beside: Child = null,
): HTMLDialogElement {
  const scrolls = { class: "exported-body scroll", tabindex: "0", role: "region", "aria-labelledby": id };
  return el(
    "dialog",
    { class: "exported", "aria-labelledby": id },
    el("header", {}, el("h2", { id }, title), beside),
    el("div", scrolls, ...body),
    el("div", { class: "actions" }, ...buttons),
  );
}

/** What stands on paper: its class, its title, and what is below that. */
export interface Printed {
  paper: string;
  title: string;
  parts: Child[];
}

/** The page has one way for paper (`paper.ts`), which clears it when it is printed. */
function put({ paper, title, parts }: Printed): void {
  document.body.append(el("div", { class: `paper ${paper}-paper` }, el("h2", {}, title), ...parts));
  document.documentElement.dataset.paper = paper;
}

/** Prints it. */
export function printNow(made: Printed): void {
  put(made);
  print();
}

/** What the dialog has on paper, by its own button and by the browser's command alike; `make`: none: nothing yet. */
export function printsWith(dialog: HTMLDialogElement, button: HTMLElement, make: () => Printed | null): void {
  on(button, "click", () => {
    const made = make();
    if (made) printNow(made);
  });
  const closed = new AbortController();
  on(dialog, "close", () => closed.abort());
  const bring = (): void => {
    const made = dialog.isConnected && !document.documentElement.dataset.paper ? make() : null;
    if (made) put(made);
  };
  addEventListener("beforeprint", bring, { signal: closed.signal });
}

/** Shows it until it is closed, or the page ends; `gone`: what then ends with it. */
export function showPassing(dialog: HTMLDialogElement, closing: HTMLElement, end: AbortSignal, gone: () => void): void {
  const drop = (): void => {
    gone();
    dialog.remove();
  };
  on(closing, "click", () => dialog.close());
  on(dialog, "close", drop);
  end.addEventListener("abort", drop);
  document.body.append(dialog);
  dialog.showModal();
  // else the focus is on the help beside the title
  dialog.querySelector<HTMLElement>("input:not([hidden]), select, textarea")?.focus();
}
