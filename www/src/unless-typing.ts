// The value of a field that is taken when it is left. The page is drawn at any time, also when an answer arrives while
// somebody types: what is typed and not yet taken stays.

import { noChange } from "lit-html";
import { Directive, directive, type PropertyPart } from "lit-html/directive.js";
import { setCommittedValue } from "lit-html/directive-helpers.js";

class UnlessTyping extends Directive {
  private field: HTMLInputElement | null = null;
  private typing = false;

  render(value: string): string {
    return value;
  }

  override update(part: PropertyPart, [value]: [string]): string | typeof noChange {
    const field = part.element as HTMLInputElement;
    if (this.field !== field) this.watch(field);
    if (this.typing || field.value === value) return noChange;
    setCommittedValue(part); // else lit-html compares with what it set last, not with what stands there
    return value;
  }

  private watch(field: HTMLInputElement): void {
    this.field = field;
    field.addEventListener("input", () => {
      this.typing = true;
    });
    // before the listener that takes the value, which may write it in another way
    for (const left of ["change", "blur"]) field.addEventListener(left, () => (this.typing = false), { capture: true });
  }
}

/** `.value=${unlessTyping(text)}` */
export const unlessTyping = directive(UnlessTyping);
