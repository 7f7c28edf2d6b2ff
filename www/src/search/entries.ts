// Everything that can be looked up, out of the catalogue and the messages: cycles, variants, parameters, results,
// alarms, guides, concepts, terms, connections.

import type { Variant } from "../desk/variants";
import { inEach, inEnglish, optional, t } from "../texts";
import type { AlarmInfo, Catalogue, CycleInfo, Dialect, Elsewhere, ExplainedInfo, ExplainedKind } from "../wire";

export type Kind = "measurement" | "around" | "parameter" | "result" | "alarm" | "elsewhere" | "guide" | ExplainedKind;
/** In the order in which they are shown where they fit equally well. */
export const KINDS: Kind[] = [
  ...(["measurement", "around", "parameter", "result", "alarm", "elsewhere", "guide"] as const),
  ...(["connection", "concept", "term"] as const),
];

export interface Entry {
  id: number;
  kind: Kind;
  control: Dialect | null; // null: of no cycle that is known here
  code: string; // as on the control: CYCLE977, _SZA, _OVR[4], 61303
  title: string;
  words: string; // found too, not shown
  names: string; // title in each language
  foreign: string; // search words in each language
  key: string; // stem of its messages
  cycles: CycleInfo[]; // that have it
  others: string[]; // other programs that have it
  variant?: Variant;
  told?: Elsewhere; // of a newer control or of another maker's
}
type Found = Omit<Entry, "id">;

function measurements(cycle: CycleInfo): Found[] {
  const title = t(`${cycle.key}-title`);
  const control = t(`control-${cycle.control}`);
  const of = {
    kind: "measurement" as const,
    control: cycle.control,
    code: cycle.cycle,
    key: cycle.key,
    cycles: [cycle],
    others: [],
  };
  const own: Found = {
    ...of,
    title,
    words: `${digits(cycle.cycle)} ${control} ${inEnglish(`${cycle.key}-title`)} ${searched(cycle.key)}`,
    names: inEach(`${cycle.key}-title`),
    foreign: inEach(`${cycle.key}-words`),
  };
  return [
    own,
    ...cycle.variants.map((variant): Found => {
      const keys = [`${cycle.key}-each`, ...variant.choices, variant.key];
      return {
        ...of,
        variant,
        code: `${cycle.cycle} ${variant.mvar}`,
        title: t(variant.key),
        words: [digits(cycle.cycle), inEnglish(variant.key), ...keys.map(searched)].join(" "),
        names: inEach(variant.key),
        foreign: keys.map(key => inEach(`${key}-words`)).join(" "),
      };
    }),
  ];
}

/**
 * Search words: of a cycle, of each of its variants, of what a digit of a variant's number chooses, of what a variant
 * alone adds. In the page's language and in English: many know the English word, and the English name.
 */
function searched(key: string): string {
  return [...new Set([optional(`${key}-words`), inEnglish(`${key}-words`)])].join(" ");
}

/** The number in a name, by which people look for it. */
function digits(name: string): string {
  return /\d+$/.exec(name)?.[0] ?? "";
}

/** One entry for what several cycles share: the same name with the same meaning. */
function shared(cycles: readonly CycleInfo[], list: (cycle: CycleInfo) => Omit<Found, "cycles" | "others">[]): Found[] {
  const all = new Map<string, Found>();
  for (const cycle of cycles)
    for (const one of list(cycle)) {
      const id = `${one.control}/${one.code}/${one.key}`;
      const known = all.get(id);
      if (known) known.cycles.push(cycle);
      else all.set(id, { ...one, cycles: [cycle], others: [] });
    }
  return [...all.values()];
}

function ofAlarm(cycles: readonly CycleInfo[], { code, key, cycles: names }: AlarmInfo): Found {
  const having = cycles.filter(cycle => names.includes(cycle.cycle));
  const others = names.filter(name => !having.some(cycle => cycle.cycle === name));
  const words = `${optional(`${key}.cause`)} ${optional(`${key}.cure`)}`;
  return {
    kind: "alarm",
    control: having[0]?.control ?? null,
    code,
    key,
    title: t(key),
    words,
    names: inEach(key),
    foreign: "",
    cycles: having,
    others,
  };
}

/** What only newer controls and those of other makers have: whatever the machine in use is, it is found. */
const ofElsewhere = (told: Elsewhere): Found => ({
  kind: told.alarm ? "alarm" : "elsewhere",
  control: null,
  code: told.code,
  key: told.key,
  title: t(told.key),
  words: `${told.words} ${optional(told.help)}`,
  names: inEach(told.key),
  foreign: "",
  cycles: [],
  others: told.owners,
  told,
});

/** A block around a call, by the name that the terminal has for it. */
const block = ({ control, name, key }: Catalogue["around"][number]): Found => ({
  kind: "around",
  control,
  code: name,
  title: t(key),
  words: `${inEnglish(key)} ${searched(key)}`,
  names: inEach(key),
  foreign: inEach(`${key}-words`),
  key,
  cycles: [],
  others: [],
});

/** A guide, by the stem of its messages. */
function guide(id: string): Found {
  const key = `guide-${id}`;
  return {
    kind: "guide",
    control: null,
    code: "",
    key,
    title: t(key),
    words: `${inEnglish(key)} ${searched(key)}`,
    names: inEach(key),
    foreign: inEach(`${key}-words`),
    cycles: [],
    others: [],
  };
}

/** A concept, a term or a connection, by its name and, on the control, its plug or address. */
const explanation = ({ kind, code, key }: ExplainedInfo): Found => ({
  kind,
  control: null,
  code,
  key,
  title: t(key),
  words: inEnglish(key),
  names: inEach(key),
  foreign: "",
  cycles: [],
  others: [],
});

export function entries(
  { cycles, around, guides, explained }: Catalogue,
  alarms: readonly AlarmInfo[],
  elsewhere: readonly Elsewhere[],
): Entry[] {
  const all = [
    ...cycles.flatMap(measurements),
    ...shared(cycles, ({ control, parameters }) =>
      parameters.map(({ name, key }) => ({
        kind: "parameter",
        control,
        code: name,
        key: `param-${key}`,
        title: t(`param-${key}`),
        words: optional(`param-${key}-help`),
        names: inEach(`param-${key}`),
        foreign: "",
      })),
    ),
    ...shared(cycles, ({ control, results }) =>
      results.map(({ name, key }) => ({
        kind: "result",
        control,
        code: name,
        key,
        title: t(key),
        words: "",
        names: inEach(key),
        foreign: "",
      })),
    ),
    ...around.map(block),
    ...alarms.map(alarm => ofAlarm(cycles, alarm)),
    ...elsewhere.map(ofElsewhere),
    ...guides.map(guide),
    ...explained.map(explanation),
  ];
  return all.map((one, id) => ({ ...one, id }));
}
