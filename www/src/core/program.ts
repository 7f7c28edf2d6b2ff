// All of the core: forms with what the call would do; reading, changing and running programs. Short programs are read
// on the page's thread, what may take long is asked in a worker (aside.ts), with the same module.

import init, * as wasm from "@pkg/core/core.js";
import address from "@pkg/core/core_bg.wasm?url";
import type { Splice } from "../eol";
import type {
  AlarmInfo,
  AroundView,
  BrakingRequest,
  BrakingView,
  Catalogue,
  Changed,
  CommissioningView,
  CompatibilityRequest,
  CompatibilityView,
  ConceptPicture,
  ConceptRequest,
  Converted,
  CuredAll,
  CureRequest,
  DefinitionsRequest,
  DefinitionsView,
  Dialect,
  Elsewhere,
  EquipRequest,
  EquipView,
  FormRequest,
  FormView,
  HelpRequest,
  HelpView,
  MachineCheckRequest,
  MachineCheckView,
  MachineRequest,
  MachineView,
  PointedRequest,
  PointedView,
  PracticeApproach,
  PracticeCall,
  PracticeCallRequest,
  PracticeFace,
  PracticeProgram,
  PracticeRequest,
  PracticeView,
  ReadBack,
  ReadBackRequest,
  ReadRequest,
  ReadView,
  Recognised,
  RepeatRequest,
  RepeatView,
  RunRecord,
  RunRequest,
  SeriesRequest,
  SeriesStart,
  Setup,
  Story,
  Style,
  TermsView,
  Unfit,
  UserProgramsRequest,
  UserProgramsView,
  WholeCertaintyRequest,
} from "../wire";
import type { FormCore, Formed } from "./core";
import { call, compile } from "./module";
import { asked, hasToReplace, type Pending } from "./pending";
import { NOTHING, onlyPath, type SceneData, takeScene } from "./scene";
import { type Columns, takeSteps } from "./steps";

/**
 * All values of one call that were changed in the form: `pending` of `control` at `at`, the call being number `call`.
 */
export interface ChangeRequest extends ReadRequest {
  call: number;
  at: number;
  pending: readonly Pending[];
}

/** A call, by its number, in another way of writing; without a number all calls that have it. */
export interface ConvertRequest extends ReadRequest {
  call?: number;
  style: Style;
}

/** A run, with the errors of the part drawn so many times as large. `known`: what it came to; then its scene only. */
export interface RunQuestion extends RunRequest {
  times: number;
  known: boolean;
}

/** What the machine is to get for a program. */
export interface SupplyRequest extends EquipRequest {
  text: string;
}

/** How certain the call of a form is. `asked`: the request as JSON, by which the same question is known again. */
export interface CertaintyQuestion {
  control: Dialect;
  text: string; // of no program
  asked: string;
}

/** A program to be run many times. */
export type SeriesQuestion = SeriesRequest;
/** A program on a machine, whatever is asked of it. */
export type ProgramQuestion = WholeCertaintyRequest;

/** What is asked aside: about a whole program, or how certain a measurement is. */
export type Question =
  | ({ ask: "read" } & ReadRequest)
  | ({ ask: "change" } & ChangeRequest)
  | ({ ask: "convert" } & ConvertRequest)
  | ({ ask: "cure" } & CureRequest)
  | ({ ask: "equip" } & SupplyRequest)
  | ({ ask: "certainty" } & CertaintyQuestion)
  | ({ ask: "whole_certainty" } & ProgramQuestion)
  | ({ ask: "series" } & SeriesQuestion)
  | ({ ask: "run" } & RunQuestion);

/** What came of a session of measuring in JOG, and what is to be seen of it. */
export interface Practised extends PracticeView {
  scene: SceneData;
}

export interface ProgramCore extends FormCore {
  module: WebAssembly.Module; // for the workers
  read(request: ReadRequest): ReadView;
  change(request: ChangeRequest): Changed[];
  convert(request: ConvertRequest): Converted;
  cure(request: CureRequest): CuredAll;
  catalogue(): Catalogue; // of all cycles
  alarms(): AlarmInfo[];
  elsewhere(): Elsewhere[];
  help(request: HelpRequest): HelpView;
  commissioning(): CommissioningView; // with the words of the help pages
  /** `why`: the machine cannot be. */
  compatibility(request: CompatibilityRequest): CompatibilityView | { why: string };
  terms(): TermsView; // with the words of the help pages
  /** `why`: no picture carries the concept. */
  conceptPicture(request: ConceptRequest): ConceptPicture | { why: string };
  /** What is told of a place of a line; null: nothing. */
  pointed(request: PointedRequest): PointedView | null;
  machine(request: MachineRequest): MachineView;
  /** `why`: there is no such axis. */
  braking(request: BrakingRequest): BrakingView | { why: string };
  /** `why`: nothing of it can be checked. */
  repeat(request: RepeatRequest): RepeatView | { why: string };
  userPrograms(request: UserProgramsRequest): UserProgramsView | { why: string };
  definitions(request: DefinitionsRequest): DefinitionsView | { why: string };
  /** The machine with the values of files; `why`: they give none. */
  readBack(request: ReadBackRequest): ReadBack | { why: string };
  machineCheck(request: MachineCheckRequest): MachineCheckView | { why: string };
  /** What a series begins with; `why`: the machine cannot be. */
  seriesStart(request: SeriesQuestion): SeriesStart | { why: string };
  equip(request: EquipRequest): EquipView;
  story(request: FormRequest): Story;
  practise(request: PracticeRequest): Practised;
  /** What the session of a script in the file of this name has measured. */
  practiceRecord(request: PracticeRequest, script: string): RunRecord;
  practiceSetup(request: PracticeRequest): Setup;
  /** How the probe gets in front of a face. */
  approach(request: PracticeFace): PracticeApproach;
  /** What the mask that is open means as a program. */
  asProgram(request: PracticeRequest): PracticeProgram;
  /** The mask that measures what a call measures; null: there is none. */
  asMask(request: PracticeCallRequest): PracticeCall | null;
  /** Lines of the table of a record, whose calls say what they mean. `words`: those of a key. */
  recordTable(
    request: { calls: unknown; first: number; files: RunRecord["files"] },
    words: (key: string) => string,
  ): string;
  /** Takes the bytes of a file in pieces. */
  recogniser(): { take(bytes: Uint8Array): void; finish(): Recognised };
  /** The setup of a file, with its defaults; or why it is none. */
  setup(text: string): Setup | { why: string };
}

/** A text in the module, so that questions about a long program come without it. */
export type Held = wasm.Held;

/** An empty one with room for so many bytes. */
export const hold = (bytes: number): Held => new wasm.Held(bytes);

/** Edits that do not overlap, offsets before all of them. */
export function edit(text: Held, edits: readonly Splice[]): void {
  const last = [...edits].sort((a, b) => b.from - a.from || b.to - a.to);
  for (const { from, to, insert } of last) text.replace(from, to, insert);
}

/** Text of a question that is asked about a text in the module. */
const HELD = "";

/** One answer a value, each for the text after the ones before it, but for what would replace an expression. */
function changes(
  { control, text, setup, with: beside, call: index, at, pending }: ChangeRequest,
  held: Held | null,
): Changed[] {
  const now = held ? held.copy() : hold(text.length);
  if (!held) now.push(new TextEncoder().encode(text));
  const all = asked(pending, { control, text, at });
  const answers = all.map(one => {
    const { name, value } = one;
    const along = all.filter(other => other !== one).map(other => other.name);
    const asked = { control, text: HELD, call: index, name, value, along, setup, with: beside };
    const changed = JSON.parse(call("change", () => now.ask("change", JSON.stringify(asked)))) as Changed;
    if (!hasToReplace(one, changed)) for (const step of changed.steps) edit(now, step);
    return changed;
  });
  now.free();
  return answers;
}

/** What is run, once or many times: nothing of the program changes by its answer. */
type Carried = "run" | "certainty" | "whole_certainty" | "series";
/** A question about a program that is answered at once. */
export type AtOnce = Exclude<Question, { ask: Carried }>;

/** The answer as JSON text, so that a worker can hand it over as it is; about the text in the module, if one is. */
export function answer(question: Exclude<Question, { ask: "run" }>, held: Held | null = null): string {
  if (question.ask === "certainty") return call(question.ask, () => wasm.certainty(question.asked));
  const { ask, ...request } = question;
  if (ask === "change") return JSON.stringify(changes(question as ChangeRequest, held));
  const json = JSON.stringify(request);
  return call(ask, () => (held ? held.ask(ask, json) : wasm[ask](json)));
}

/** A form, and its scene once that is asked for: nobody does where the view is out of sight. */
function formed(request: FormRequest): Formed {
  const answer = call("form", () => wasm.form_seen(JSON.stringify(request)));
  const view = JSON.parse(answer.view()) as FormView;
  if (!view.outcome) {
    answer.free();
    return view;
  }
  const scenes = new Map<number, SceneData>();
  const scene = (times: number): SceneData => {
    const made = scenes.get(times) ?? sceneIn(answer, times);
    scenes.set(times, made);
    return made;
  };
  return { ...view, scene };
}

/** The session that goes on: a line more costs that line. */
let session: wasm.Practice | null = null;

function practised(request: PracticeRequest): Practised {
  session ??= new wasm.Practice();
  const going = session;
  const answer = call("practise", () => going.practise(JSON.stringify(request)));
  const view = JSON.parse(answer.view()) as PracticeView;
  const scene = sceneIn(answer, 1);
  answer.free();
  return { ...view, scene };
}

/** The scene of an answer, in which the errors of the part are so many times as large. */
function sceneIn(answer: wasm.Answer, times: number): SceneData {
  const scene = answer.scene(times);
  return scene ? takeScene(scene) : NOTHING;
}

const PIECE = 500; // blocks between two looks at the clock
const SLICE = 40; // ms between two messages of others

/** The last run, and what was asked for: to draw it with other errors it is not run again. */
let ran: { asked: string; answer: wasm.Answer; json: string } | null = null;

/** How far a run is: the share that is done, now and then its motions so far. */
export interface Way {
  share: number;
  seen?: SceneData;
}
type Between = (way: Way) => Promise<void>;

const FIRST_SEEN = 400; // ms of a run until its motions are shown
const THEN = 4; // times as long until they are shown again, so that it takes the run no more than a part of its time

/** Runs a program. Before each slice `between` is told how far it is, and the run waits for it. */
async function runOf(asked: string, held: Held | null, between: Between): Promise<NonNullable<typeof ran>> {
  if (ran?.asked === asked) return ran;
  ran?.answer.free();
  ran = null;
  const run = held ? held.run(asked) : new wasm.Run(asked);
  let worked = 0; // ms
  let next = FIRST_SEEN;
  for (let over = false; !over; ) {
    const seen = worked > next ? motionsIn(run) : undefined;
    if (seen) next *= THEN;
    await between({ share: run.share(), ...(seen && { seen }) });
    worked += SLICE;
    const until = performance.now() + SLICE;
    while (!over && performance.now() < until) over = run.advance(PIECE);
  }
  const answer = run.finish();
  ran = { asked, answer, json: answer.view() }; // which it hands out once
  return ran;
}

/** The motions of a run that goes on, as soon as they are many. */
function motionsIn(run: wasm.Run): SceneData | undefined {
  const { path, view } = takeScene(run.motions());
  return path ? onlyPath(path, view.entries) : undefined;
}

/** What a run came to, as JSON text and its steps (neither where that is known), and its scene. */
export async function runInPieces(
  { ask: _, times, known, ...request }: RunQuestion & { ask: "run" },
  held: Held | null,
  between: Between,
): Promise<{ json: string; scene: SceneData; steps?: Columns }> {
  const { answer, json } = await runOf(JSON.stringify(request), held, between);
  const scene = sceneIn(answer, times);
  if (known) return { json: "", scene };
  const steps = answer.steps();
  return { json, scene, ...(steps && { steps: takeSteps(steps) }) };
}

/** The answer, or why there is none: the text of the user may be anything. */
function orWhy<T>(ask: () => string): T | { why: string } {
  try {
    return JSON.parse(ask()) as T;
  } catch (problem) {
    return { why: problem instanceof Error ? problem.message : String(problem) };
  }
}

function recogniser(): ReturnType<ProgramCore["recogniser"]> {
  const its = new wasm.Recogniser();
  return { take: bytes => its.take(bytes), finish: () => JSON.parse(its.finish()) as Recognised };
}

export async function loadProgramCore(): Promise<ProgramCore> {
  const module = await compile(address);
  await init({ module_or_path: module });
  return {
    module,
    simulates: "yes",
    practise: practised,
    practiceRecord: (request, script) =>
      JSON.parse(call("practice_record", () => wasm.practice_record(JSON.stringify(request), script))) as RunRecord,
    practiceSetup: request =>
      JSON.parse(call("practice_setup", () => wasm.practice_setup(JSON.stringify(request)))) as Setup,
    approach: request => JSON.parse(call("approach", () => wasm.approach(JSON.stringify(request)))) as PracticeApproach,
    asProgram: request =>
      JSON.parse(call("as_program", () => wasm.as_program(JSON.stringify(request)))) as PracticeProgram,
    asMask: request => JSON.parse(call("as_mask", () => wasm.as_mask(JSON.stringify(request)))) as PracticeCall | null,
    setup: text => orWhy<Setup>(() => wasm.setup(text)),
    unfit: request => JSON.parse(call("unfit", () => wasm.unfit(JSON.stringify(request)))) as Unfit[],
    around: request => JSON.parse(call("around", () => wasm.around(JSON.stringify(request)))) as AroundView,
    change: request => changes(request, null),
    recordTable: (request, words) => call("record_table", () => wasm.record_table(JSON.stringify(request), words)),
    recogniser,
    form: formed,
    read: request => JSON.parse(answer({ ask: "read", ...request })) as ReadView,
    cure: request => JSON.parse(answer({ ask: "cure", ...request })) as CuredAll,
    convert: request => JSON.parse(answer({ ask: "convert", ...request })) as Converted,
    commissioning: () => JSON.parse(call("commissioning", () => wasm.commissioning())) as CommissioningView,
    compatibility: request => orWhy<CompatibilityView>(() => wasm.compatibility(JSON.stringify(request))),
    conceptPicture: request => orWhy<ConceptPicture>(() => wasm.concept_picture(JSON.stringify(request))),
    terms: () => JSON.parse(call("terms", () => wasm.terms())) as TermsView,
    help: request => JSON.parse(call("help", () => wasm.help(JSON.stringify(request)))) as HelpView,
    pointed: request => JSON.parse(call("pointed", () => wasm.pointed(JSON.stringify(request)))) as PointedView | null,
    equip: request => JSON.parse(call("equip", () => wasm.equip(JSON.stringify(request)))) as EquipView,
    story: request => JSON.parse(call("story", () => wasm.story(JSON.stringify(request)))) as Story,
    braking: request => orWhy<BrakingView>(() => wasm.braking(JSON.stringify(request))),
    repeat: request => orWhy<RepeatView>(() => wasm.repeat(JSON.stringify(request))),
    userPrograms: request => orWhy<UserProgramsView>(() => wasm.user_programs(JSON.stringify(request))),
    definitions: request => orWhy<DefinitionsView>(() => wasm.definitions(JSON.stringify(request))),
    readBack: request => orWhy<ReadBack>(() => wasm.read_back(JSON.stringify(request))),
    machineCheck: request => orWhy<MachineCheckView>(() => wasm.machine_check(JSON.stringify(request))),
    seriesStart: request => orWhy<SeriesStart>(() => wasm.series_start(JSON.stringify(request))),
    machine: request => JSON.parse(call("machine", () => wasm.machine(JSON.stringify(request)))) as MachineView,
    catalogue: () => JSON.parse(call("catalogue", () => wasm.catalogue())) as Catalogue,
    alarms: () => JSON.parse(call("alarms", () => wasm.alarms())) as AlarmInfo[],
    elsewhere: () => JSON.parse(call("elsewhere", () => wasm.elsewhere())) as Elsewhere[],
  };
}
