// What the core says to the page and back: the JSON of probewright-web (core/src/json). Numbers in mm, degree, mm/min.
// Texts never travel: a Message is a key of core/messages/<language>/*.ftl with arguments.

import type { Encoding } from "./encoding";

export type Dialect = "sinumerik" | "nct";
export interface Message {
  key: string;
  args: Record<string, number | string>;
}
export type Style = "direct" | "indirect" | "operate";
export type Severity = "error" | "warning" | "note";
export interface Diagnostic {
  severity: Severity;
  code: string; // "61307", "FORMAT ERROR", "PW012"
  message: Message;
  hint?: Message;
  param?: string;
  from?: number;
  to?: number; // UTF-16 offsets into the program text
  line?: number;
  column?: number; // from 1
  cure?: { label: Message; edits: Edit[] }; // one click mends it
  elsewhere?: TouchedLine[]; // lines that the cure changes elsewhere than where it is told
}

/** What a file is, by its bytes: a program, or why it is none. */
export type Recognised = { encoding: Encoding } | { why: Message };

// catalogue() -> Catalogue
export interface Catalogue {
  cycles: CycleInfo[];
}
export interface CycleInfo {
  control: Dialect;
  cycle: string; // "CYCLE977"
  key: string; // "cycle977": messages cycle977-title, cycle977-words, cycle977-each-words, cycle977-help
  purpose: Purpose;
  styles: Style[]; // the ways of writing that its call has, direct first
  variants: {
    mvar: number;
    key: string;
    source: string;
    choices: string[]; // keys of what the digits of its number choose
    values: Record<string, string>;
    example: Record<string, string>;
    planes: Partial<Record<Plane, { values: Record<string, string>; example: Record<string, string> }>>;
  }[]; // values: as typed, they choose this variant; planes: where other addresses name the axes
  parameters: { name: string; key: string; unit: string; default: number | null; source: string }[];
  results: { name: string; key: string; unit: string; source: string }[];
  alarms: string[];
  example: Record<string, string>; // values of a worked measurement, as typed
  twins: boolean; // the other control has some of its tasks too
  surfaces: string[]; // names of our surfaces, where it scans one, which a Scan answers in pieces; else none
  simulated: boolean; // false: form, checks and text only; a FormView has no outcome
  source: string;
}

// alarms() -> AlarmInfo[]
export interface AlarmInfo {
  code: string; // "61303", "PROBE FAIL"
  key: string; // messages KEY, KEY.cause (where it says more), KEY.cure
  stops: boolean;
  cycles: string[]; // who raises it: cycles of the catalogue, then other programs
  found: "check" | "run" | "both" | "nowhere"; // where Probewright finds what raises it
  source: string;
}

/**
 * Where a cycle belongs. plane: in which such a machine works unless told otherwise. calibrates: it does nothing else.
 */
export interface Purpose {
  machine: "milling" | "turning" | "any";
  plane: Plane | null;
  probe: "workpiece" | "tool" | "none" | "log";
  calibrates: boolean;
}

export type Plane = "G17" | "G18" | "G19";
/** How positions of the transverse axis X are given: radii, diameters, diameters where they are absolute. */
export type Transverse = "DIAMOF" | "DIAMON" | "DIAM90";
export type UnitFunction = "G70" | "G71" | "G700" | "G710" | "G20" | "G21";

/** What a machine is built for: its data and, with some G functions, its feeds and lengths count in it. */
export type BasicSystem = "mm" | "inch";

/** The core's own machine with this basic system (absent: mm), beginning in this plane and with these units. */
export interface OwnMachine {
  own: { basic?: BasicSystem; plane: Plane; units: UnitFunction; data?: Setup["data"] };
}

// form(FormRequest) -> FormView. Called at every keystroke.
export interface FormRequest {
  control: Dialect;
  cycle: string;
  values: Record<string, string>; // as typed, per parameter name; absent: never typed
  // of the values that are the worth of one: as the program has it, and the snippet carries it
  expressions?: Record<string, string>;
  assumed?: Record<string, string>; // an outcome counts with these instead
  setup?: Setup | OwnMachine; // absent: the core's own machine as it is
  plane?: Plane; // at the call, where it is not that of the setup
  transverse?: Transverse; // at the call; absent: diameters in a turning cycle
  units?: UnitFunction; // likewise
  errors?: ErrorSliders;
  limits?: boolean; // also look for the largest errors that the call survives: takes a hundred runs
  comments?: Record<string, string>; // words by parameter name: a comment line each in the snippet
  style?: Style; // way of writing of the snippet; absent: preset
  written?: Style; // of the call of the program that the form shows: a list of newer controls has rules of its own
  predict?: boolean; // also simulate
  twin?: boolean; // also the same task on the other control
}
export interface ErrorSliders {
  part: { dx: number; dy: number; dz: number; size: number; tilt: number; taper: number; outOfRound: number };
  probe: { skewX: number; skewY: number; radius: number; preTravel: number; repeatability: number };
}
export interface FormView {
  fields: Field[]; // in the order to show; hidden ones are left out
  diagnostics: Diagnostic[]; // all, those of a field carry `param`
  snippet: string; // program text, LF; also for incomplete values as far as it can be written; empty: not in this way
  snippetFindings: Diagnostic[]; // what this way of writing cannot say
  preset: Style; // way of writing that counts until another is chosen: the machine may say so
  complete: boolean; // no error
  mvar: number | null; // the variant that the values choose
  picture?: Picture; // only from the full module, which comes after the first form
  // when asked for, from the full module; null: the other control has no such task for these values
  twin?: TwinView | null;
  unknown?: string[]; // when predict and there is no outcome: parameters whose values only a run tells
  outcome?: Outcome; // when predict and complete, of a cycle that is simulated
  // when predict: the machine, for an outcome with the proposed part, its errors and the start; exported, and what a
  // program runs on
  setup?: Setup;
}
export interface TwinView {
  control: Dialect;
  cycle: string;
  key: string; // messages KEY-title, …
  task: Message; // what both measure
  values: Record<string, string>; // as typed there
  snippet: string;
  shared: { label: Message; value: number }[]; // what both say; lengths in the active unit
  differences: Message[];
}
export interface Field {
  name: string; // "_SETVAL"
  label: Message;
  help: Message;
  kind: "real" | "integer" | "choice" | "digits" | "text";
  value: string; // as typed, else ""
  expression?: string; // of the program, of which the value is the worth
  chooses?: boolean; // it chooses the variant, on which the other fields depend
  code?: string; // what the number is a code of, where that is not the same in all variants
  fallback?: number; // default that counts when empty
  unit: "" | "mm" | "inch" | "deg" | "mm/min" | "inch/min";
  required: boolean;
  reason: Message; // why it is required or optional
  range?: { min?: number; minIncluded: boolean; max?: number; maxIncluded: boolean };
  choices?: { value: number; label: Message }[];
  digits?: {
    label: Message;
    place: number;
    digits: number;
    value: number;
    choices: { value: number; label: Message }[];
    leads?: number[];
  }[]; // leads: the whole number of each choice, where it is more than this digit
  source: string; // place in the manual
}
// Drawn as SVG, millimetres of the working plane; `field` is highlighted while that field has the focus.
export interface Picture {
  view: "plane" | "section";
  shapes: PictureShape[];
}
/** Centre and radius, mm. */
export interface Circle {
  x: number;
  y: number;
  r: number;
}
export interface PictureShape {
  kind:
    | "material"
    | "cut"
    | "edge"
    | "zone"
    | "probe"
    | "path"
    | "dimension"
    | "label"
    | "tolerance"
    | "axis"
    | "touch";
  points: [number, number][]; // polygon or polyline; dimension: its two ends
  circle?: Circle;
  /** A round opening in it. */
  opening?: Circle;
  closed?: boolean;
  text?: string; // name of a parameter or a number
  field?: string; // parameter it explains
  also?: string[]; // parameters without a figure of their own that are shown here too
}
export interface Outcome {
  // earlier: not written by this call
  results: { name: string; label: Message; value: number; unit: string; earlier?: 0 }[];
  decisions: Message[]; // tolerance chain, in order, the branch taken last
  alarms: { code: string; message: Message; hint?: Message; stops: boolean }[];
  changes: { name: string; label: Message; before: number; after: number; unit: string }[]; // tool wear, zero offset, …
  log: string[];
  trace: Trace;
  // up to which errors it comes to its end; null: any
  limits?: { error: keyof ErrorSliders["part"]; low: number | null; high: number | null }[];
}
export type Vec3 = [number, number, number];
export type MotionKind = "rapid" | "positioning" | "measuring" | "retract";
/** A way round an axis, right-handed; absent: straight. Between different heights it climbs evenly. */
export interface Around {
  centre: Vec3;
  axis: Vec3;
  degrees: number;
}
/** What of the probe touches; where it is left out, the ball. */
export type Touching = "ball" | "stylus" | "body";
export type Step =
  | { step: "motion"; kind: MotionKind; from: Vec3; to: Vec3; feed: number; around?: Around }
  | { step: "touch"; latched: Vec3; ball: Vec3; point: Vec3; normal: Vec3; by?: Touching }
  | { step: "crash"; point: Vec3; normal: Vec3; by?: Touching }
  | { step: "orient"; angle: number }
  | { step: "spin"; speed: number } // 1/min, negative as M4; 0: it stops
  | { step: "table"; axis: string; from: number; to: number; solids: Solid[] } // the part as it stands then
  | { step: "tool"; tool: number; edge: number }
  | { step: "set"; name: string; before: number; after: number }
  | { step: "decision"; message: Message }
  | { step: "alarm"; code: string; message: Message; hint?: Message; stops: boolean }
  | { step: "message"; text: string }
  | { step: "log"; text: string }
  | { step: "call"; cycle: string; variant: number }
  | { step: "return" };
// ball.stylus: radius above the ball; body: what holds it, where that is known, and the distance of its lower face.
// tools: whatever was in use; inUse: which of them from which entry on, absent: a ball that stands upright.
// zones: walls of protection zones, as shaft, web or island; shown, not touched.
// limits: the part with the largest errors on both sides.
/** A coordinate system, by the name of its zero offset; `moved`: by a correction. */
export interface FrameView {
  name: string;
  at: Vec3;
  axes: [Vec3, Vec3, Vec3];
  moved?: "before" | "after";
}
export interface Trace {
  entries: (Step & { line?: number })[];
  ball: Ball;
  tools?: ToolView[];
  inUse?: [from: number, tool: number][];
  turning?: boolean;
  drawing?: Drawing;
  solids: Solid[];
  toolProbes?: Solid[];
  zones?: Solid[];
  limits?: Solid[];
  frames: FrameView[];
}
export interface Ball {
  radius: number;
  length: number;
  stylus?: number;
  body?: { radius: number; distance: number };
}
/** What is in use, from the position of the machine on: the ball of the probe or the pieces of a tool. */
export interface ToolView {
  length: Vec3; // in effect, along X Y Z: where it changes, the axes stand still
  ball?: Vec3; // direction from the ball to what holds it; absent: no probe
  pieces: ToolPiece[];
  carrier: ToolPiece[]; // what holds it on a turning machine
  tip: Vec3; // its end
}
/**
 * Half of a section turned about an axis: distance from it and height; or a convex flat piece, with its thickness.
 * cuts: an insert.
 */
export type ToolPiece = { cuts?: boolean } & (
  | { outline: [number, number][]; axis: Vec3; at: Vec3 }
  | { corners: Vec3[]; thick: Vec3 }
);
/**
 * A turned part as on a drawing. ends: of a diameter as it is; out: along the axis, away from the part; touched:
 * diameters as the control reads them.
 */
export interface Drawing {
  diameters: { ends: [Vec3, Vec3]; out: Vec3; set: number; real: number }[];
  touched: { entry: number; diameter: number }[];
  // where positions count from, and whether X is a diameter
  reading: { at: Vec3; axes: [Vec3, Vec3, Vec3]; diameter: boolean };
}
export interface Solid {
  shape:
    | "hole"
    | "shaft"
    | "groove"
    | "web"
    | "pocket"
    | "island"
    | "block"
    | "turned"
    | "chuck"
    | "sphere"
    | "outerCorner"
    | "innerCorner"
    | "surface";
  // hole [diameter, depth]; shaft [diameter, height]; groove/web [width, depth, length]; pocket/island [x, y, depth];
  // block [x, y, z]; turned [diameter, length, bore, its depth]; chuck [diameter, length, diameter gripped]; sphere
  // [diameter]; outerCorner/innerCorner [degrees between the edges, edge along X, other edge, z]
  size: number[];
  surface?: Surface; // of the shape "surface", which has no size
  at: Vec3;
  rotation: Vec3; // mm; RPY degree
  errors: { shift: Vec3; size: number; tilt: Vec3; taper: number; outOfRound: [number, number] };
}

/** Heights in rows along X over a grid about the origin, or single triangles. */
export type Surface =
  | { heights: { columns: number; step: [number, number]; values: number[] } }
  | { triangles: [Vec3, Vec3, Vec3][] };

// Setup: docs/setup.schema.json is its schema; also what the terminal reads and the page exports.
export interface Setup {
  control: Dialect;
  units: BasicSystem;
  plane: Plane;
  active?: {
    tool?: number;
    edge?: number;
    frame?: string;
    units?: UnitFunction;
    transverse?: Transverse;
    spindle?: number;
  }; // in force at the start
  machine?: { limitsMinus?: (number | null)[]; limitsPlus?: (number | null)[]; spindlePositions?: boolean };
  tools: Record<
    string,
    {
      name?: string;
      edges: Record<
        string,
        {
          type: number;
          length: Vec3;
          radius: number;
          lengthWear?: Vec3;
          radiusWear?: number;
          additive?: Record<string, number[]>;
          setup?: Record<string, number[]>;
          real?: RealTool;
        }
      >;
    }
  >;
  frames: Record<string, { coarse: Vec3; fine?: Vec3; rotation?: Vec3; scale?: Vec3 }>; // "G54"
  environments?: Record<string, { tool: number; edge: number; location?: number; plane?: Plane }>; // of TOOLENV("NAME")
  data: Record<string, number | string>; // "_WP[0,1]", "_CHBIT[4]", "MD18600", "R10", "#500"
  probe: {
    radius: number;
    length: number;
    skew?: [number, number];
    preTravel?: [number, number];
    delay?: number;
    repeatability?: [number, number];
    falseSignal?: number;
    stylus?: number;
    body?: { radius: number; distance: number };
  };
  // block or turned
  toolProbes?: { solid: Solid; preTravel?: number; delay?: number; repeatability?: [number, number] }[];
  workpiece: Solid[];
  position?: Vec3; // at the start, machine coordinates
  skip?: number[]; // levels switched on: blocks with /, /1.. are left out
}

/** A tool as it is where it touches a tool probe; runoutAngle and angle in degree with the spindle at 0. */
export interface RealTool {
  length: Vec3; // L1 L2 L3
  cut:
    | {
        cutter: {
          radius: number;
          corner?: number;
          chamfer?: [number, number];
          teeth?: number;
          angle?: number;
          runout?: [number, number];
          runoutAngle?: number;
          axis?: number;
        };
      }
    | { nose: { radius: number; side: [number, number] } };
}

// help(HelpRequest) -> HelpView: the help page of a variant
export interface HelpRequest {
  control: Dialect;
  cycle: string;
  mvar: number;
}
export interface HelpView {
  sections: { label: Message; lines: { message: Message; source: string }[] }[];
  required: string[]; // parameters that every call of the variant gives
  results: { name: string; key: string }[]; // that a call can leave
  alarms: AlarmInfo[]; // that can come
}

// machine(MachineRequest) -> MachineView: what is set once per machine
export interface MachineRequest {
  control: Dialect;
  setup?: Setup | OwnMachine;
  basic?: BasicSystem; // the machine is to be built for it from now on; the data keep their sizes
  values: Record<string, string>; // typed; empty: as delivered
}
export interface MachineView {
  groups: MachineGroup[];
  basic: BasicSystem; // now
  data: Setup["data"]; // what differs from delivery now, for the setup
  problems: { name: string; message: Message; hint: Message }[]; // of values that were not taken
  assignments: string; // the same as blocks of a part program
  definitions: string; // and as lines of the definition file
}
export interface MachineGroup {
  label: Message;
  fields: MachineField[];
}
export interface MachineField {
  name: string; // "_WP[0,1]", "MD18600"
  key: string; // its name; .help and .v0, .v1, … of a choice may be there
  set?: Message; // which field of data it belongs to
  kind: "real" | "integer" | "choice" | "text";
  value: string; // "": as delivered
  fallback: string; // as delivered; "": not known
  unit: string;
  range: NonNullable<Field["range"]>;
  choices?: number[];
  source: string;
}

// read(ReadRequest) -> ReadView
export interface ReadRequest {
  control: Dialect;
  text: string;
  setup?: Setup | OwnMachine;
} // absent: the core's own machine as it is
export interface ReadView {
  calls: CallView[];
  diagnostics: Diagnostic[];
}
export interface CallView {
  control: Dialect;
  cycle: string;
  mvar: number | null;
  key: string;
  line: number;
  lastLine: number; // from 1: first assignment line that belongs to it, line of the call
  style: Style;
  from: number;
  to: number; // UTF-16 offsets of the call itself
  values: Record<string, string>; // as the form wants them
  expressions: Record<string, string>; // of the values that are the worth of one: as it is written
  // of the values that differ by the way or from pass to pass, those that arrive first; line from 1
  first: Record<string, { value: string; line: number }>;
  plane: Plane;
  units: UnitFunction;
  transverse: Transverse; // in force at the call
  diagnostics: Diagnostic[];
  // notes at the values that come from other programs of the text, or differ by the way to the call
  arrivals: Diagnostic[];
}
// change({control, text, setup?, call: index, name, value}) -> Changed; the only bytes that change
export interface Edit {
  from: number;
  to: number;
  insert: string;
}
/** A line that would be another one; from 1. */
export interface TouchedLine {
  line: number;
  before: string;
  after: string;
}
// steps: lists of edits, each for the text after the ones before it. elsewhere: lines outside of the call's own. taken:
// parameters that the new variant does not know, taken out of the call.
export interface Changed {
  steps: Edit[][];
  elsewhere: TouchedLine[];
  taken: string[];
  findings: Diagnostic[];
}
// A value changed in the form and not yet in the program: of the call that begins at UTF-16 offset `at` there. asks: it
// would change these lines of that text outside of its call, and waits for a word; agreed: that was given.
export interface Pending {
  control: Dialect;
  at: number;
  name: string;
  value: string;
  asks?: { text: string; lines: TouchedLine[] };
  agreed?: boolean;
}
// convert({control, text, setup?, call: index, style}) -> Converted: the call in another way of writing; no edits: not
// possible, see findings
export interface Converted {
  edits: Edit[];
  findings: Diagnostic[];
}
// run(RunRequest) -> RunView
/** The call of a program to which something belongs; absent: none. Line from 1. */
export interface OfCall {
  line?: number;
  cycle?: string;
}
export interface RunRequest {
  control: Dialect;
  text: string;
  setup?: Setup | OwnMachine;
} // absent: the core's own machine as it is
export interface RunView {
  trace: Trace;
  diagnostics: Diagnostic[];
  results: ({ name: string; label?: Message; value: number; unit?: string } & OfCall)[];
  decisions: ({ message: Message } & OfCall)[];
  changes: Outcome["changes"];
  alarms: (Outcome["alarms"][number] & OfCall)[];
  log: string[];
  finished: boolean;
  passedOver: { word: string; line: number }[];
  ending: Message;
}

// Scan(ScanRequest, bytes): a surface scanned in pieces. setup: that of the FormView; its surface, or another one as
// large.
export interface ScanRequest {
  control: Dialect;
  cycle: string;
  values: Record<string, string>;
  setup: Setup;
  plane?: Plane;
  units?: UnitFunction;
  surface?: SurfaceChoice;
}
/** One of ours by name; a picture whose rows have so many grey values, or an STL file: of both the bytes go along. */
export type SurfaceChoice = { example: string } | { picture: number } | "stl";
export type ScanText = "program" | "points" | "surface";
/** mm; of the points as sent, and with the ball taken out. origin: of the points, machine coordinates. */
export interface ScanView {
  points: number;
  lines: number;
  alarms: Outcome["alarms"];
  sent: Deviation;
  surface: Deviation;
  solids: Solid[];
  radius: number;
  origin: Vec3;
}
export interface Deviation {
  greatest: number;
  mean: number;
}
