// What can be measured, as one chooses it: element, what is corrected, and what is left to choose. All of it is data of
// the catalogue; a choice leads to the way that keeps most of the choices before it.

import type { Actions } from "../desk/actions";
import type { Variant } from "../desk/variants";
import type { Catalogue, Corrects, CycleInfo, Dialect, Element } from "../wire";

/** A way to a form: a variant with the values that make it correct this. */
export interface Way {
  element: Element;
  corrects: Corrects;
  /** Key of the name of what is corrected. */
  key: string;
  cycle: CycleInfo;
  variant: Variant;
  values: Record<string, string>;
  /** The answer to each question. */
  options: Record<string, string>;
}

/** A question with its answers, keys of their words. */
export interface Question {
  key: string;
  answers: string[];
}

const ORDER: Corrects[] = ["zero", "tool", "probe", "setter", "nothing"];

/** All ways of a control. */
export function waysOf({ cycles }: Catalogue, control: Dialect): Way[] {
  const ways = cycles
    .filter(cycle => cycle.control === control)
    .flatMap(cycle => cycle.variants.map(variant => ({ cycle, variant })))
    .flatMap(({ cycle, variant }) =>
      (variant.aim?.corrects ?? []).map(({ corrects, key, values }) => ({
        element: variant.aim?.element as Element,
        corrects,
        key,
        cycle,
        variant,
        values: values as Record<string, string>,
        options: Object.fromEntries(variant.aim?.options ?? []),
      })),
    );
  const late = ({ corrects, cycle }: Way): number =>
    2 * ORDER.indexOf(corrects) + Number(cycle.purpose.machine === "turning");
  return ways.sort((a, b) => late(a) - late(b));
}

/** Those beside which a way is offered: the same is measured and corrected. */
export function beside(ways: readonly Way[], way: Way): Way[] {
  return ways.filter(one => one.element === way.element && one.corrects === way.corrects);
}

/** What is left to choose: each question to which there is more than one answer, once those before it are answered. */
export function questions(ways: readonly Way[], way: Way): Question[] {
  let left = beside(ways, way);
  const asked: Question[] = [];
  for (const [key, answer] of Object.entries(way.options)) {
    const answers = [...new Set(left.map(one => one.options[key]).filter(one => one !== undefined))];
    if (answers.length > 1) asked.push({ key, answers });
    left = left.filter(one => one.options[key] === answer);
  }
  return asked;
}

/** The way with this answer that keeps most of the others, earlier questions before later ones. */
export function answered(ways: readonly Way[], way: Way, question: string, answer: string): Way {
  const kept = (one: Way): string =>
    Object.keys(way.options)
      .map(key => (one.options[key] === way.options[key] ? "1" : "0"))
      .join("");
  const all = beside(ways, way).filter(one => one.options[question] === answer);
  return all.sort((a, b) => kept(b).localeCompare(kept(a)))[0] ?? way;
}

/** The way to an element that is most like the one shown, with this correction where there is one. */
export function firstWay(
  ways: readonly Way[],
  { element, options }: { element: Element; options: Record<string, string> },
  corrects?: Corrects,
): Way | undefined {
  const own = ways.filter(one => one.element === element);
  const wanted = own.some(one => one.corrects === corrects) ? corrects : own[0]?.corrects;
  const alike = (one: Way): number =>
    Object.entries(options).filter(([question, answer]) => one.options[question] === answer).length;
  return own.filter(one => one.corrects === wanted).sort((a, b) => alike(b) - alike(a))[0];
}

/** Whether these values, of a form of this way's variant, are of this way and of no other one. */
export function isAt(ways: readonly Way[], way: Way, values: Record<string, string>): boolean {
  const has = (one: Way): boolean =>
    Object.entries(one.values).every(([name, value]) => (values[name] ?? "") === value);
  const closer = ways.filter(
    one => one.variant === way.variant && Object.keys(one.values).length > Object.keys(way.values).length,
  );
  return has(way) && !closer.some(has);
}

/** Opens the form of a way; one that is there already stays as it is. */
export function openWay(actions: Actions, way: Way): void {
  actions.measure(way.cycle, way.variant, way.values);
}
