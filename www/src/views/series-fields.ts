// The fields of a series: how many parts, from which seed, and what varies from part to part.

import { html, nothing, type TemplateResult } from "lit-html";
import { exact, parseNumber, plain } from "../numbers";
import { refusal, say, sayProblem, t } from "../texts";
import type { Mode, Per, Series, SeriesFollow, SeriesName, SeriesPreset, SeriesStart, Shape, Vary } from "../wire";

const SHAPES: Shape[] = ["normal", "uniform", "triangular", "arcsine"];
const MODES: Mode[] = ["production", "independent"];
const PERS: Per[] = ["part", "series"];
const MOST = 10_000; // parts that a page waits for
const FIRST_SPREAD = 0.01; // mm, of the first thing that varies

/** What the core offers for the program and the machine. */
export type Offered = Pick<SeriesStart, "names" | "follows" | "presets">;

/** A variation as typed. */
interface Row {
  what: string;
  as: Shape;
  spread: string; // deviation of the normal distribution, half width of the others
  mean: string;
  drift: string;
  per: Per;
  follows: string; // `name=factor`, separated by semicolons
  values: number[];
}

/** A series as typed. */
export interface Typed {
  parts: string;
  seed: string;
  mode: Mode;
  rows: Row[];
}

const rowOf = (vary: Vary): Row => ({
  what: vary.what,
  as: vary.as ?? "normal",
  spread: exact((vary.as ?? "normal") === "normal" ? (vary.sigma ?? 0) : (vary.half ?? 0)),
  mean: exact(vary.mean ?? 0),
  drift: exact(vary.drift ?? 0),
  per: vary.per ?? "part",
  follows: Object.entries(vary.follows ?? {})
    .map(([name, factor]) => `${name}=${exact(factor)}`)
    .join("; "),
  values: vary.values ?? [],
});

/** As it is typed. Where nothing varies yet, the first of `names` does, so that a run shows something. */
export function typedOf({ runs, seed, mode, vary }: Series, names: readonly SeriesName[]): Typed {
  const first = names[0] ? [rowOf({ what: names[0].name, sigma: FIRST_SPREAD })] : [];
  return { parts: String(runs), seed: String(seed), mode, rows: vary.length ? vary.map(rowOf) : first };
}

const number = (text: string): number => {
  const value = text.trim() ? parseNumber(text) : 0;
  if (value === null) throw new Error(t("runs-no-number", { text }));
  return value;
};

/** Names with their factors. */
function followed(text: string): Record<string, number> {
  const pairs = text.split(";").filter(one => one.trim());
  return Object.fromEntries(
    pairs.map(pair => {
      const at = pair.lastIndexOf("=");
      return [pair.slice(0, Math.max(0, at)).trim(), number(pair.slice(at + 1))];
    }),
  );
}

const varyOf = ({ what, as, spread, mean, drift, per, follows, values }: Row): Vary => ({
  what: what.trim(),
  as,
  ...(as === "normal" ? { sigma: number(spread) } : { half: number(spread) }),
  mean: number(mean),
  drift: number(drift),
  per,
  follows: followed(follows),
  ...(values.length ? { values } : {}),
});

/** What the setup file calls how far a shape reaches. */
const spreadOf = ({ as }: Row): "sigma" | "half" => (as === "normal" ? "sigma" : "half");

/** Where a member of the file is typed: its words in the dialog. */
const FIELDS: Record<string, string> = {
  what: "runs-what",
  as: "runs-as",
  sigma: "runs-sigma",
  half: "runs-half",
  mean: "runs-offset",
  drift: "runs-drift",
  per: "runs-per",
  follows: "runs-follows",
};

/** A problem of a series in the words of its fields, not in those of the setup file. */
export function seriesProblem(problem: string, { rows }: Typed, names: readonly SeriesName[]): string {
  const refused = refusal(problem);
  const [, at, member = ""] = /^series\.vary\[(\d+)\](?:\.(\w+))?/.exec(String(refused?.args.path ?? "")) ?? [];
  const row = rows[Number(at)];
  if (!refused || !row) return sayProblem(problem);
  const known = names.find(({ name }) => name === row.what);
  const name = known ? say(known.label) : row.what;
  const number = t("runs-vary", { number: Number(at) + 1 });
  if (refused.key === "setup-vary-nothing") return t("runs-nothing", { place: number, name });
  const field = FIELDS[member] ? `, ${t(FIELDS[member])}` : "";
  const args = { ...refused.args, path: `${number}${field}` };
  // below `follows` the name is that of the variable
  return say({ ...refused, args: member === "follows" ? args : { ...args, name } });
}

/** A whole number from `least` to `most`; anything else is refused by the name of its field, and nothing is changed. */
function whole(text: string, label: string, least: number, most: number): number {
  const value = parseNumber(text);
  if (value !== null && Number.isInteger(value) && value >= least && value <= most) return value;
  throw new Error(t("runs-whole", { field: t(label), least, most }));
}

/** What was typed. Throws what is no number, or which ones there may be, in words. */
export function seriesOf({ parts, seed, mode, rows }: Typed): Series {
  const runs = whole(parts, "runs-count", 1, MOST);
  const from = whole(seed, "runs-seed", 0, Number.MAX_SAFE_INTEGER);
  return { runs, seed: from, mode, vary: rows.map(varyOf) };
}

/** How the setup file calls a field; the name that a person reads is its label. */
const inFile = (name: string): string => t("runs-in-file", { name });

const input = (id: string, value: string, file: string, take: (value: string) => void): TemplateResult =>
  html`<input id=${id} .value=${value} title=${inFile(file)} autocomplete="off"
    @input=${(event: Event) => take((event.target as HTMLInputElement).value)} />`;

function choice<T extends string>(
  id: string,
  all: readonly T[],
  value: T,
  file: string,
  take: (value: T) => void,
): TemplateResult {
  const chosen = (event: Event): void => take((event.target as HTMLSelectElement).value as T);
  return html`<select id=${id} title=${inFile(file)} @change=${chosen}>
    ${all.map(one => html`<option value=${one} .selected=${one === value}>${t(`runs-${one}`)}</option>`)}
  </select>`;
}

const field = (id: string, label: string, control: unknown): TemplateResult =>
  html`<div class="series-field"><label for=${id}>${label}</label>${control}</div>`;

/** What varies, by its name in words, or any other datum by its name. */
function whatOf(id: string, row: Row, names: readonly SeriesName[], change: () => void): TemplateResult {
  const known = names.some(({ name }) => name === row.what);
  const parts = [...new Set(names.map(({ part }) => part))];
  const option = ({ name, label }: SeriesName): TemplateResult =>
    html`<option value=${name} .selected=${name === row.what}>${say(label)}</option>`;
  const chosen = (event: Event): void => {
    row.what = (event.target as HTMLSelectElement).value;
    change();
  };
  const groups = parts.map(
    part => html`<optgroup label=${part === undefined ? t("runs-of-probe") : t("runs-of-part", { part })}
      >${names.filter(one => one.part === part).map(option)}</optgroup>`,
  );
  return html`${field(
    id,
    t("runs-what"),
    html`<select id=${id} title=${inFile(row.what)} @change=${chosen}>${groups}
      <option value="data." .selected=${!known}>${t("runs-of-name")}</option></select>`,
  )}
  ${
    known
      ? nothing
      : field(
          `${id}-name`,
          t("runs-name"),
          input(`${id}-name`, row.what, "what", value => (row.what = value)),
        )
  }`;
}

/** Corrections of the program that reach what varies here; a choice writes one behind the others. */
function followOf(id: string, row: Row, follows: readonly SeriesFollow[], change: () => void): unknown {
  const own = follows.filter(({ what, variable }) => what === row.what && !row.follows.includes(`${variable}=`));
  if (!own.length) return nothing;
  const chosen = (event: Event): void => {
    const one = own[Number((event.target as HTMLSelectElement).value)];
    if (one) row.follows = [row.follows.trim(), `${one.variable}=${exact(one.factor)}`].filter(Boolean).join("; ");
    change();
  };
  const named = ({ target, part, variable, factor }: SeriesFollow): string =>
    t("runs-follow", { name: `${say(target)} ${part}`.trim(), variable, factor: plain(factor) });
  return field(
    id,
    t("runs-follow-add"),
    html`<select id=${id} @change=${chosen}>
      <option value="" .selected=${true}>–</option>
      ${own.map((one, at) => html`<option value=${String(at)}>${named(one)}</option>`)}
    </select>`,
  );
}

function rowShown(
  row: Row,
  at: number,
  { names, follows }: Offered,
  { change, remove }: { change(): void; remove(): void },
): TemplateResult {
  const id = (name: string): string => `series-${name}-${at}`;
  const put = (name: "spread" | "mean" | "drift" | "follows") => (value: string) => {
    row[name] = value;
  };
  const shape = choice(id("as"), SHAPES, row.as, "as", value => {
    row.as = value;
    change();
  });
  const per = choice(id("per"), PERS, row.per, "per", value => {
    row.per = value;
  });
  const typed = (name: "spread" | "mean" | "drift" | "follows", label: string): TemplateResult =>
    field(id(name), label, input(id(name), row[name], name === "spread" ? spreadOf(row) : name, put(name)));
  const values = row.values.map(one => plain(one)).join(" ");
  return html`<fieldset class="series-vary">
    <legend>${t("runs-vary", { number: at + 1 })}</legend>
    ${whatOf(id("what"), row, names, change)}
    ${field(id("as"), t("runs-as"), shape)}
    ${typed("spread", t(`runs-${spreadOf(row)}`))}
    ${typed("mean", t("runs-offset"))}
    ${typed("drift", t("runs-drift"))}
    ${field(id("per"), t("runs-per"), per)}
    ${followOf(id("follow"), row, follows, change)}
    ${typed("follows", t("runs-follows"))}
    ${values ? html`<p>${t("runs-values", { values })}</p>` : nothing}
    <button type="button" @click=${remove}>${t("runs-remove")}</button>
  </fieldset>`;
}

/** All fields. `change`: draws them anew. */
export function fieldsOf(typed: Typed, offered: Offered, change: () => void): TemplateResult {
  const { rows } = typed;
  const { names, presets } = offered;
  const others = names.filter(({ name }) => !rows.some(({ what }) => what === name));
  const add = (): void => {
    rows.push(rowOf({ what: others[0]?.name ?? "data." }));
    change();
  };
  const preset = (event: Event): void => {
    const chosen = presets[Number((event.target as HTMLSelectElement).value)];
    if (chosen) rows.push(rowOf(chosen.vary));
    change();
  };
  const presetName = ({ label, of, part }: SeriesPreset): string => {
    const behind = [of ? `${say(of.target)} ${of.part}`.trim() : "", part ? t("runs-of-part", { part }) : ""];
    return [say(label), ...behind.filter(Boolean)].join(" · ");
  };
  const remove = (at: number) => (): void => {
    rows.splice(at, 1);
    change();
  };
  return html`
    ${field(
      "series-runs",
      t("runs-count"),
      input("series-runs", typed.parts, "runs", value => (typed.parts = value)),
    )}
    ${field(
      "series-seed",
      t("runs-seed"),
      input("series-seed", typed.seed, "seed", value => (typed.seed = value)),
    )}
    ${field(
      "series-mode",
      t("runs-mode"),
      choice("series-mode", MODES, typed.mode, "mode", value => (typed.mode = value)),
    )}
    ${rows.map((row, at) => rowShown(row, at, offered, { change, remove: remove(at) }))}
    <button type="button" @click=${add}>${t("runs-add")}</button>
    ${
      presets.length
        ? field(
            "series-preset",
            t("runs-preset"),
            html`<select id="series-preset" @change=${preset}>
              <option value="" .selected=${true}>–</option>
              ${presets.map((one, at) => html`<option value=${String(at)}>${presetName(one)}</option>`)}
            </select>`,
          )
        : nothing
    }
    <p class="series-note">${t("runs-units")}</p>`;
}
