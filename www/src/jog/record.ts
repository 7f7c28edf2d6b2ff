// What the session has measured: a line for each measurement once it is unfolded, saved as the record of a run is.

import { html, nothing, type TemplateResult } from "lit-html";
import type { Practice } from "../desk/practice";
import { saveFile } from "../state/files";
import type { JogState } from "../state/state";
import { say, t } from "../texts";
import { csv } from "../views/csv";
import { recordText } from "../views/record";
import type { RunRecord } from "../wire";
import { figureText } from "./figures";

type Call = RunRecord["calls"][number];
type Pieces = (made: RunRecord) => Promise<string[]>;

const measured = ({ feature, figures, why }: Call): TemplateResult => html`<li>
  <b>${say(feature)}</b>
  ${figures.map(
    ({ label, symbol, actual, unit }) => html`<span>
      ${say(label)} <span class="figure">${figureText({ axis: symbol, value: actual, unit })}</span>
    </span>`,
  )}
  ${figures.length ? nothing : html`<span>${say(why)}</span>`}
</li>`;

export function createRecord(practice: Practice): (jog: JogState) => TemplateResult {
  let open = false;
  let made: { of: unknown; record: RunRecord | null } | null = null;
  /** The session is carried out once more for it: only where it is looked at, and once for what is seen. */
  const recordOf = ({ seen }: JogState): RunRecord | null => {
    if (made?.of !== seen) made = { of: seen, record: practice.record() };
    return made.record;
  };
  const saving = (record: RunRecord, pieces: Pieces, ending: string, type: string): TemplateResult => html`<button
    type="button"
    title=${t(`whole-${ending}-hint`)}
    @click=${() => void pieces(record).then(all => saveFile(new Blob(all), `practice.${ending}`, type))}
  >
    ${t(`whole-${ending}`)}
  </button>`;
  const tableOf = async (record: RunRecord): Promise<string[]> => {
    const core = practice.core();
    return core ? csv(record, core) : [];
  };
  const all = (record: RunRecord): TemplateResult => html`
    <ol class="jog-measured">${record.calls.map(measured)}</ol>
    <div class="jog-part-keys">
      ${saving(record, tableOf, "csv", "text/csv;charset=utf-8")}
      ${saving(record, recordText, "json", "application/json")}
    </div>
  `;
  const toggled = ({ target }: Event): void => {
    open = (target as HTMLDetailsElement).open;
    practice.change({});
  };
  return jog => {
    const record = open ? recordOf(jog) : null;
    return html`<details class="jog-record" @toggle=${toggled}>
      <summary>${t("practice-record")}</summary>
      ${record?.calls.length ? all(record) : html`<p class="jog-quiet">${t("practice-record-none")}</p>`}
    </details>`;
  };
}
