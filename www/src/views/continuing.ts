// A new tab asks whose work it continues. The page works meanwhile, with the work that was changed last: typing there
// or Escape is an answer too, it goes on with that.

import { el, on } from "../dom";
import { type OtherWork, type State, workName } from "../state/state";
import { language, t } from "../texts";

export interface Choices {
  /** Goes on with a copy of that work. */
  take(other: OtherWork): void;
  startAnew(): void;
  /** Goes on with what is shown. */
  stay(): void;
}

/** The time of a day; with the day, where it is not today. */
function when(changed: number): string {
  const today = new Date(changed).toDateString() === new Date().toDateString();
  const day: Intl.DateTimeFormatOptions = today ? {} : { day: "numeric", month: "short" };
  const clock: Intl.DateTimeFormatOptions = { hour: "2-digit", minute: "2-digit", hourCycle: "h23" };
  return new Intl.DateTimeFormat(language(), { ...day, ...clock }).format(changed);
}

function choice(text: string, chosen: () => void): HTMLElement {
  const button = el("button", { type: "button" }, text);
  on(button, "click", chosen);
  return el("li", {}, button);
}

/** Listens to Escape in the whole page until `end`. */
export function createContinuing(
  { take, startAnew, stay }: Choices,
  end: AbortSignal,
): { dialog: HTMLDialogElement; draw(state: State): void } {
  const list = el("ul", {});
  const dialog = el(
    "dialog",
    { class: "about continuing", "aria-labelledby": "continuing-title", "aria-describedby": "continuing-why" },
    el("h2", { id: "continuing-title" }, t("continuing-title")),
    el("p", { id: "continuing-why" }, t("continuing-why")),
    list,
  );
  document.addEventListener("keydown", event => event.key === "Escape" && dialog.open && stay(), { signal: end });
  let drawn: readonly OtherWork[] = [];

  const copyOf = ({ name, changed }: Omit<OtherWork, "from">, chosen: () => void): HTMLElement =>
    choice(t("continuing-copy", { name, when: when(changed) }), chosen);
  const fill = (state: State): void => {
    const { changed, others } = state.page;
    const different = others.filter(
      (one, index) => one.changed !== changed && others.findIndex(two => two.changed === one.changed) === index,
    );
    list.replaceChildren(
      ...(changed ? [copyOf({ name: workName(state), changed }, stay)] : []),
      ...different.map(one => copyOf(one, () => take(one))),
      choice(t("continuing-anew"), changed ? startAnew : stay),
    );
  };
  return {
    dialog,
    draw(state) {
      const { others } = state.page;
      if (others === drawn) return;
      drawn = others;
      if (!others.length) return dialog.close();
      const focused = list.contains(document.activeElement);
      fill(state);
      if (dialog.open && !focused) return;
      const before = document.activeElement;
      dialog.show();
      if (before instanceof HTMLElement && before !== document.body && !focused) before.focus();
      else list.querySelector("button")?.focus();
    },
  };
}
