// A step of a trace in words.

import type { Shown } from "../core/steps";
import { fixed, plain } from "../numbers";
import { say, t } from "../texts";
import type { CycleInfo, Vec3 } from "../wire";

const at = (p: Vec3): string => `X ${fixed(p[0], 3)}  Y ${fixed(p[1], 3)}  Z ${fixed(p[2], 3)}`;

/** The number of a variant is told where `cycles` has a cycle whose programs write one. */
export function describe(step: Shown, cycles: CycleInfo[]): string {
  switch (step.step) {
    case "motion":
      return t(`motion-${step.kind}`, { to: at(step.to), feed: plain(step.feed, 1) });
    case "touch":
      return t(step.by ? `step-touch-${step.by}` : "step-touch", { at: at(step.point) });
    case "crash":
      return t(step.by ? `step-crash-${step.by}` : "step-crash", { at: at(step.point) });
    case "orient":
      return t("step-orient", { angle: plain(step.angle, 3) });
    case "spin":
      return t("step-spin", {
        direction: step.speed > 0 ? "M3" : step.speed < 0 ? "M4" : "M5",
        speed: plain(Math.abs(step.speed), 1),
      });
    case "table":
      return t("step-table", { axis: step.axis, angle: plain(step.to, 3) });
    case "tool":
      return t("step-tool", { tool: step.tool, edge: step.edge });
    case "set":
      return t("step-set", { name: step.name, before: plain(step.before), after: plain(step.after) });
    case "decision":
      return say(step.message);
    case "alarm":
      return `${step.code}: ${say(step.message)}`;
    case "message":
    case "log":
      return step.text;
    case "file":
      return step.text === undefined ? t("step-file", { name: step.name }) : `${step.name}: ${step.text}`;
    case "call":
      return cycles.some(({ cycle, numbered }) => numbered && cycle === step.cycle)
        ? t("step-call", { cycle: step.cycle, variant: step.variant })
        : t("step-call-only", { cycle: step.cycle });
    case "return":
      return t("step-return");
  }
}
