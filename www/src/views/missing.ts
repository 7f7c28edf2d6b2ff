// What the form still lacks.

import type { Derived } from "../desk/derive";
import { listed, t } from "../texts";

/** Why there is no outcome yet: by name, what the form still lacks. */
export function missing(derived: Derived): string {
  if (!derived.cycle.simulated) return t("outcome-not-simulated", { cycle: derived.cycle.cycle });
  if (derived.simulates === "no") return t("outcome-absent");
  if (derived.simulates === "coming") return t("outcome-coming");
  if (derived.opened?.style === "operate" && derived.view.complete && !derived.view.unknown?.length)
    return t("outcome-newer");
  const names = new Set(
    derived.view.diagnostics.flatMap(one => (one.severity === "error" && one.param ? [one.param] : [])),
  );
  if (names.size) return t("outcome-missing", { names: listed([...names]) });
  const { unknown = [] } = derived.view;
  return unknown.length ? t("outcome-unknown", { names: listed(unknown) }) : t("outcome-incomplete");
}
