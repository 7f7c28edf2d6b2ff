// The handbook: its pages are whole without this script, which adds the search and brings the contents to the page that
// is shown.

import "../styles/tokens.css";
import "../styles/fonts.css";
import "./book.css";
import "./text.css";
import "./media.css";
import { on } from "../dom";
import { createSearch } from "./search";

/** The contents begin at the page that is shown, and close when one goes on. */
function createContents(contents: HTMLElement): void {
  const current = contents.querySelector<HTMLElement>("[aria-current]");
  const reveal = (): void => {
    if (current) contents.scrollTop = current.offsetTop - contents.clientHeight / 3;
  };
  reveal();
  on(contents, "toggle", reveal);
  on(contents, "click", ({ target }) => {
    if (target instanceof Element && target.closest("a") && contents.matches(":popover-open")) contents.hidePopover();
  });
}

const found = document.getElementById("found");
const query = document.querySelector<HTMLInputElement>("#query");
const contents = document.getElementById("contents");
if (found && query) createSearch(query, found);
if (contents) createContents(contents);
