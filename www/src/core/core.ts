// What the form asks of the core. Until it has come (program.ts), the page answers a first visit with what the core
// said while the page was built.

import { catalogue, form } from "answers:first";
import type {
  AroundRequest,
  AroundView,
  Catalogue,
  CycleInfo,
  FormRequest,
  FormView,
  Unfit,
  UnfitRequest,
} from "../wire";
import { firstQuestion } from "./example";
import type { SceneData } from "./scene";

/** `scene`: what is to be seen of a call that was carried out, made when it is first asked for. */
export interface Formed extends FormView {
  scene?: (times: number) => SceneData;
}

export interface FormCore {
  /** Whether it is the core that answers; else whether that will come. */
  simulates: "yes" | "coming" | "no";
  form(request: FormRequest): Formed;
  /** What of a form's values does not fit the variant that it has now; absent until the core has come. */
  unfit?(request: UnfitRequest): Unfit[];
  /** The blocks around a call; absent until the core has come. */
  around?(request: AroundRequest): AroundView;
}

/** What stands in for the core. */
export interface FirstCore extends FormCore {
  catalogue: Catalogue;
  /** The same with what the measurement comes to, for which there are words once all of them have come. */
  measured(): FormCore;
}

const { outcome: _, ...bare } = form;

/** Of values that somebody has typed meanwhile nothing is said. */
function unanswered({ values }: FormRequest): Formed {
  const fields = bare.fields.map(field => ({ ...field, value: values[field.name] ?? "" }));
  return { ...bare, fields, diagnostics: [], snippet: "", snippetPlaces: {}, complete: false, mvar: null };
}

const told = ({ control, cycle, values, errors }: FormRequest): string =>
  JSON.stringify([control, cycle, Object.entries(values).sort(), errors]);

export function firstCore(): FirstCore {
  const known = catalogue.cycles.map((cycle: CycleInfo) => told(firstQuestion(cycle)));
  const answered = (view: Formed): FormCore => ({
    simulates: "coming",
    form: request => (known.includes(told(request)) ? view : unanswered(request)),
  });
  return { ...answered(bare), catalogue, measured: () => answered(form) };
}
