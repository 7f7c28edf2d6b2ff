// The stage while one practises: the part as it lies, the probe where it is; what NC start began is seen as it happens.

import type { SceneData } from "../core/scene";
import { FACE, type Practice, START } from "../desk/practice";
import { el, setAttribute, setText, show } from "../dom";
import type { IconName } from "../icons";
import type { Hand, Preview, ViewName } from "../preview/view";
import type { JogState, State } from "../state/state";
import { say, t } from "../texts";
import { type Shown, shownTheme } from "../theme";
import { type Stage, tool, watchTaken } from "../views/stage";

const still = matchMedia("(prefers-reduced-motion: reduce)");
const FINE = 100; // µm a step of a drag where an axis moves as long as its key is held down
const LONGEST = 2.5; // s that a measurement is shown for

export function createJogStage(root: HTMLElement, stage: Stage, practice: Practice): (state: State) => void {
  const note = el("p", { class: "empty over-stage", role: "status" }, t("view-loading"));
  const corner = el("div", { class: "stage-corner" });
  const hint = el("p", { class: "jog-hint", role: "status" });
  root.append(el("div", { class: "stage-box" }, corner, note), hint);
  let shown: { data: SceneData | null; theme: Shown | null } = { data: null, theme: null };
  let dressed = false;
  let now: JogState | null = null;
  /** Dragged along an axis in steps of the increment, until something is hit, or onto a face. */
  const grab = (): Hand => {
    let done = 0;
    let hit = false;
    return {
      along(axis, way) {
        const step = (now?.step || FINE) / 1000;
        const by = Math.round((way - done) / step) * step;
        hit ||= done !== 0 && !!now?.seen?.raised;
        if (by === 0 || hit) return;
        done += by;
        practice.jog("XYZ".charAt(axis), by);
      },
      onto: ({ at, normal }) => practice.face(at, normal),
    };
  };
  const dress = (preview: Preview): void => {
    if (dressed) return;
    dressed = true;
    const view = (name: ViewName, of: IconName): HTMLElement =>
      tool(of, t(`view-${name}`), () => preview.setView(name));
    corner.append(
      view("iso", "view"),
      view("top", "solid"),
      tool("fit", t("view-fit"), () => preview.fit()),
    );
    watchTaken(stage.box, [corner, hint], preview);
  };
  return ({ jog, page }) => {
    const box = root.firstElementChild;
    if (page.place !== "jog") {
      if (shown.data) listenTo(stage.preview, null);
      shown = { data: null, theme: null };
      return;
    }
    if (stage.box.parentElement !== box) box?.prepend(stage.box);
    const { preview, failed } = stage;
    if (failed) setText(note, t("view-failed", { problem: failed }));
    show(note, !preview);
    if (!preview) return stage.fetch();
    dress(preview);
    now = jog;
    listenTo(preview, { face: ({ at, normal }) => practice.face(at, normal), grab });
    const refused = jog.refused?.field === FACE ? jog.refused : null;
    setText(hint, refused ? say(refused.message) : t("practice-face"));
    show(hint, !!refused || !jog.lines.includes(START)); // whoever has measured knows how to move the probe
    setAttribute(hint, "data-refused", String(!!refused));
    const theme = shownTheme(page.theme);
    const colours = stage.colours(theme);
    if (colours && theme !== shown.theme) preview.setColours(colours);
    const data = jog.seen?.scene ?? null;
    if (data && data !== shown.data) {
      const fresh = shown.data === null;
      preview.setCloud(null);
      preview.setDrawing(false);
      preview.setSection(false);
      preview.setCovered(0);
      preview.setScene(data, null);
      const last = data.view.entries - 1;
      const measured = !fresh && jog.lines.at(-1) === START && !still.matches;
      practice.running(measured);
      play(preview, data, measured ? Math.min(jog.seen?.from ?? last, last) : last, () => practice.running(false));
      if (fresh) preview.fit();
    }
    shown = { data, theme };
  };
}

/** What a click on the part and a drag of the probe do; null: nothing. */
function listenTo(
  preview: Preview | null,
  what: { face: Parameters<Preview["onFace"]>[0]; grab: Parameters<Preview["onGrab"]>[0] } | null,
): void {
  preview?.onFace(what?.face ?? null);
  preview?.onGrab(what?.grab ?? null);
}

let playing = 0;

/** From an entry to the last one, in real time, faster where that would take long; then `ended`. */
function play(preview: Preview, { begins }: SceneData, from: number, ended: () => void): void {
  cancelAnimationFrame(playing);
  const last = begins.length - 2;
  const [first = 0, end = 0] = [begins[from], begins[last + 1]];
  const speed = Math.max(1, (end - first) / LONGEST);
  const start = performance.now();
  const frame = (now: number): void => {
    const at = first + (Math.max(0, now - start) / 1000) * speed;
    if (at >= end || from >= last) {
      preview.setStep(Math.max(0, last), 1);
      ended();
      return;
    }
    let step = from;
    while (step < last && (begins[step + 1] ?? end) <= at) step++;
    const [begin = 0, over = 0] = [begins[step], begins[step + 1]];
    preview.setStep(step, over > begin ? (at - begin) / (over - begin) : 1);
    playing = requestAnimationFrame(frame);
  };
  frame(start);
}
