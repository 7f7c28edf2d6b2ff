// Questions and answers of the core. Written from core/src/app by a test of the core (json/tests/wire.rs) when it runs
// with PROBEWRIGHT_UPDATE=1; not by hand.

/** An alarm, or a text for the operator. */
export type AlarmInfo = {
  /** Its name: `61303`, `PROBE FAIL`; of a text for the operator the text itself. */
  code: string,
  /** Key of its words; `.cause` (where it says more) and `.cure` stand behind it. */
  key: string,
  /** Whether the program stops. */
  stops: boolean,
  /** Who raises it: cycles of the catalogue, then other programs. */
  cycles: Array<string>,
  /** Where what raises it is found. */
  found: Found,
  /** Place in the manual. */
  source: string,
};

/** One argument of a message. */
export type Arg = number | string;

/** A value that arrives at a call. */
export type Arrival = {
  /** As it is written. */
  value: string,
  /** Its line, from 1. */
  line: number,
};

/** System of units. */
export type BasicSystem = "mm" | "inch";

/** What the core's own machine begins with. */
export type Beginning = {
  /** Basic system of units; none: metric. */
  basic?: BasicSystem,
  /** Working plane; absent: G17. */
  plane: Plane,
  /** G function of units; none: that of the basic system. */
  units: UnitFunction,
  /** User and machine data that differ. */
  data?: { [key in string]: Datum },
};

/** A measuring call of a program. */
export type CallView = {
  /** Control. */
  control: Dialect,
  /** Cycle. */
  cycle: string,
  /** Stem of its messages. */
  key: string,
  /** Number of the variant, where it is known. */
  mvar: number | null,
  /** First line with an assignment that belongs to it, from 1. */
  line: number,
  /** Line of the call itself. */
  lastLine: number,
  /** Where the call itself begins in the text, UTF-16 units. */
  from: number,
  /** One past its end. */
  to: number,
  /** How it is written. */
  style: Style,
  /** Values that arrive at it, as a form wants them. */
  values: { [key in string]: string },
  /** Of those that are the worth of an expression: as it is written. */
  expressions: { [key in string]: string },
  /** Of the values that differ by the way or from pass to pass: those that arrive first. */
  first: { [key in Name]: Arrival },
  /** Working plane there. */
  plane: Plane,
  /** How X is given there. */
  transverse: Transverse,
  /** G function of units in force there. */
  units: UnitFunction,
  /** What is wrong with it. */
  diagnostics: Array<Diagnostic>,
  /** Notes at values that come from other programs of the text, or differ by the way to the call. */
  arrivals: Array<Diagnostic>,
};

/** Everything that can be measured. */
export type Catalogue = {
  /** In the order in which they are offered. */
  cycles: Array<CycleInfo>,
};

/** A quantity that is different after a run. */
export type Change = {
  /** As a program would name it: `$TC_DP15[20,1]`, `$P_UIFR[1,X,FI]`, `_MV[9]`. */
  name: string,
  /** In words. */
  label: Message,
  /** Before, in its unit. */
  before: number,
  /** After. */
  after: number,
  /** A length has that of the basic system of the machine. */
  unit: string,
};

/** A new value of a call. */
export type ChangeRequest = {
  /** Control. */
  control: Dialect,
  /** Text of the program. */
  text: string,
  /** Which of its calls, from 0. */
  call: number,
  /** Parameter. */
  name: string,
  /** Its new value, as typed; empty: it goes. */
  value: string,
  /** Machine on which the program starts; absent: the core's own as it is. */
  setup?: Machine,
};

/** What a new value does to a program. */
export type Changed = {
  /** Lists of edits, each for the text after the ones before it; the only places that change. */
  steps: Array<Array<Edit>>,
  /** Lines outside of the call's own that they change. */
  elsewhere: Array<TouchedLine>,
  /** Parameters that the new variant does not know, taken out of the call. */
  taken: Array<Name>,
  /** What that means. */
  findings: Array<Diagnostic>,
};

/** A number with its name. */
export type Choice = {
  /** Number as it is written. */
  value: number,
  /** Its name. */
  label: Message,
};

/** Where a problem is named. */
export type Code = string;

/** A call in another way of writing. */
export type ConvertRequest = {
  /** Control. */
  control: Dialect,
  /** Text of the program. */
  text: string,
  /** Which of its calls, from 0. */
  call: number,
  /** The way of writing. */
  style: Style,
  /** Machine on which the program starts; absent: the core's own as it is. */
  setup?: Machine,
};

/** Edits that write a call in another way. */
export type Converted = {
  /** The only places of the text that change; none: it is not possible, see the findings. */
  edits: Array<Edit>,
  /** What has to be said about it. */
  findings: Array<Diagnostic>,
};

/** Edits that mend a finding. */
export type Cure = {
  /** What they do. */
  label: Message,
  /** The only places of the text that change. */
  edits: Array<Edit>,
};

/** A measuring cycle or macro. */
export type CycleInfo = {
  /** Control that has it. */
  control: Dialect,
  /** Its name: `CYCLE977`. */
  cycle: string,
  /** Stem of its messages: `cycle977` of `cycle977-title`, `cycle977-words`, `cycle977-help`. */
  key: string,
  /** Where it belongs. */
  purpose: Purpose,
  /** The ways of writing that its call has, direct first. */
  styles: Array<Style>,
  /** Its measuring variants. */
  variants: Array<VariantInfo>,
  /** Its parameters, in the order in which they are written. */
  parameters: Array<ParameterInfo>,
  /** What it leaves in the result data. */
  results: Array<ResultInfo>,
  /** Names of its alarms: `61303`, `PROBE FAIL`. */
  alarms: Array<Code>,
  /** Values of a worked measurement, as typed. */
  example: { [key in string]: string },
  /** Whether the other control has some of its tasks too. */
  twins: boolean,
  /** Whether it is simulated; else there are form, checks and text only, and a form has no outcome. */
  simulated: boolean,
  /** Names of our surfaces where it scans one, which a scan answers in pieces; else none. */
  surfaces: Array<string>,
  /** Place in the manual. */
  source: string,
};

/** A value of user data. */
export type Datum = number | string;

/** How far points are from the true surface, mm. */
export type Deviation = {
  /** Greatest. */
  greatest: number,
  /** Root of the mean square. */
  mean: number,
};

/** What is wrong, where, and how to mend it. */
export type Diagnostic = {
  /** How bad. */
  severity: Severity,
  /** Its name: `61307`, `FORMAT ERROR`, `PW012`. */
  code: Code,
  /** Cause. */
  message: Message,
  /** What helps. */
  hint?: Message,
  /** Parameter to which it belongs. */
  param?: Name,
  /** Where it begins in the text of the program, UTF-16 units. */
  from?: number,
  /** One past its end, UTF-16 units. */
  to?: number,
  /** Line in which it begins, from 1. */
  line?: number,
  /** Character of that line, from 1. */
  column?: number,
  /** Mends it at once. */
  cure?: Cure,
  /** Lines that the cure changes elsewhere than where the finding is told. */
  elsewhere?: Array<TouchedLine>,
};

/** The language of the part program, and with it the control. */
export type Dialect = "sinumerik" | "nct";

/** Digits that mean something of their own. */
export type DigitGroup = {
  /** What they mean. */
  label: Message,
  /** Value of the lowest digit: 1, 10, 100, … */
  place: number,
  /** How many. */
  digits: number,
  /** What they are now. */
  value: number,
  /** Named values; empty: any number of that many digits. */
  choices: Array<Choice>,
  /** The whole number to which each choice leads; empty: the digits alone change. */
  leads?: Array<number>,
};

/** Replaces a place of the text; places count in UTF-16 units. */
export type Edit = {
  /** First unit that goes. */
  from: number,
  /** One past the last; the same: nothing goes. */
  to: number,
  /** What comes. */
  insert: string,
};

/** What is recognised. Whoever shows the text may know more, to be chosen by hand. */
export type Encoding = "utf-8" | "utf-8-marked" | "utf-16le" | "utf-16le-marked" | "utf-16be" | "utf-16be-marked" | "gbk" | "gb18030" | "shift_jis" | "windows-1252";

/** Up to which errors of the part a call comes to its end, the others being as they are. */
export type ErrorLimit = {
  /** Name of the error among those of the part. */
  error: keyof PartSliders,
  /** The smallest; none: any. */
  low: number | null,
  /** The largest; none: any. */
  high: number | null,
};

/** What is wrong with part and probe, as the sliders of the page set it. */
export type ErrorSliders = {
  /** The part; a tool probe in its place. */
  part: PartSliders,
  /** The workpiece probe; of a tool at a tool probe the tool. */
  probe: ProbeSliders,
};

/** A field of a form. Numbers of `fallback` and `range` are in its unit. */
export type Field = {
  /** Parameter, as the manual writes it: `_SETVAL`. */
  name: Name,
  /** Its name in words. */
  label: Message,
  /** What it means. */
  help: Message,
  /** How it is entered. */
  kind: FieldKind,
  /** As typed; empty: nothing is. */
  value: string,
  /** The expression of the program of which the value is the worth. */
  expression?: string,
  /** There where it chooses the variant, on which the other fields depend. */
  chooses?: boolean,
  /** What the number is a code of, where that is not the same in all variants. */
  code?: string,
  /** What counts while nothing is typed. */
  fallback?: number,
  /** `mm`, `inch`, `deg`, `mm/min`, `inch/min` or nothing. */
  unit: string,
  /** Whether it has to be given. */
  required: boolean,
  /** Why it is required or optional. */
  reason: Message,
  /** What the control takes, of a number. */
  range?: Range,
  /** What can be chosen, of a choice. */
  choices?: Array<Choice>,
  /** Digits that mean something of their own, of a number that is put together from such. */
  digits?: Array<DigitGroup>,
  /** Place in the manual. */
  source: string,
};

/** How a field is entered. */
export type FieldKind = "real" | "integer" | "choice" | "digits" | "text";

/** What a form is asked for. */
export type FormRequest = {
  /** Control. */
  control: Dialect,
  /** Cycle. */
  cycle: string,
  /** Values as typed, by parameter; absent: never typed. */
  values: { [key in string]: string },
  /** Of the values that are the worth of an expression of the program: as it is written. The snippet carries it. */
  expressions?: { [key in string]: string },
  /** Values that an outcome counts with instead of those of the form, which depend on the way to the call. */
  assumed?: { [key in string]: string },
  /** Machine; absent: the core's own as it is. */
  setup?: Machine,
  /** G function of units in force at the call, where it is not that of the machine. */
  units?: UnitFunction,
  /** Working plane at the call, where it is not that of the machine. */
  plane?: Plane,
  /** How X is given at the call; absent: as diameters in a turning cycle. */
  transverse?: Transverse,
  /** What is wrong with part and probe; absent: nothing. */
  errors?: ErrorSliders,
  /** Words by parameter for a comment line each in the snippet. */
  comments?: { [key in string]: string },
  /** Way of writing of the call of a program that the form shows: a list of newer controls has rules of its own. */
  written?: Style,
  /** Way of writing of the snippet; absent: as the machine's forms have it, else direct. */
  style?: Style,
  /** Whether to simulate. */
  predict?: boolean,
  /** Whether to look for the largest errors of the part that the call survives: takes a hundred runs. */
  limits?: boolean,
  /** Whether to look for the same task on the other control. */
  twin?: boolean,
};

/** A form. */
export type FormView = {
  /** Fields in the order in which they are shown; hidden ones are left out. */
  fields: Array<Field>,
  /** All findings; those of a field name its parameter. */
  diagnostics: Array<Diagnostic>,
  /** Text of the program, also for incomplete values as far as it can be written; empty: not in this way. */
  snippet: string,
  /** What this way of writing cannot say. */
  snippetFindings: Array<Diagnostic>,
  /** Way of writing that counts until another is chosen: the machine may say so. */
  preset: Style,
  /** Whether there is no error. */
  complete: boolean,
  /** The variant that the values choose. */
  mvar: number | null,
  /** What the values mean, drawn; only from a build that simulates. */
  picture?: Picture,
  /** When asked for: the same task on the other control; null where that has none. */
  twin?: TwinView | null,
  /** When simulating was asked for and there is no outcome: parameters whose values only a run tells. */
  unknown?: Array<Name>,
  /** When simulating was asked for, of a complete form of a cycle that is simulated. */
  outcome?: Outcome,
  /** When simulating was asked for: the machine, for an outcome with the proposed part, its errors and the start. */
  setup: Setup,
};

/** Where Probewright finds what raises an alarm. */
export type Found = "check" | "run" | "both" | "nowhere";

/** Which page. */
export type HelpRequest = {
  /** Control. */
  control: Dialect,
  /** Cycle. */
  cycle: string,
  /** Number of the variant. */
  mvar: number,
};

/** A result by its name and the key of its meaning. */
export type HelpResult = {
  /** `_OVR[4]`. */
  name: string,
  /** Key of its meaning. */
  key: string,
};

/** A section of a help page. */
export type HelpSection = {
  /** Its heading. */
  label: Message,
  /** What it says. */
  lines: Array<HelpText>,
};

/** A line of a help page. */
export type HelpText = {
  /** What it says. */
  message: Message,
  /** Place in the manual. */
  source: string,
};

/** The help page of a variant. */
export type HelpView = {
  /** Its sections, in order; none is empty. */
  sections: Array<HelpSection>,
  /** Parameters that every call of the variant gives. */
  required: Array<Name>,
  /** Results that a call can leave. */
  results: Array<HelpResult>,
  /** Alarms that can come. */
  alarms: Array<AlarmInfo>,
};

/** What a label tells. */
export type LabelKind = "frame" | "diameter" | "nominal" | "touched" | "collision";

/** A part of the lines. */
export type LineGroup = {
  /** What it is. */
  kind: LineKind,
  /** Its part of the lines, from and to (excluded), in lines. */
  lines: [number, number],
  /** Where it stands, by index in the places of a standing; none: machine coordinates. */
  place?: number,
  /** In which of the standings it is there; none: in all. */
  standing?: number,
};

/** What a group of lines is. */
export type LineKind = "grid" | "edge" | "zone" | "limit" | "axisX" | "axisY" | "axisZ" | "beforeX" | "beforeY" | "beforeZ" | "dimension";

/** The machine of a question. */
export type Machine = OwnMachine | Setup;

/** A datum of the machine. */
export type MachineField = {
  /** As a program writes it: `_WP[0,1]`, `MD18600`. */
  name: string,
  /** Key of its name; `.help`, and `.v0`, `.v1`, … of a choice, may stand behind it. */
  key: string,
  /** Which field of data it belongs to. */
  set?: Message,
  /** How it is entered. */
  kind: MachineKind,
  /** As typed; empty: as delivered. */
  value: string,
  /** As delivered; empty: not known. */
  fallback: string,
  /** Unit on this machine. */
  unit: string,
  /** What is allowed. */
  range: Range,
  /** The numbers of a choice. */
  choices?: Array<number>,
  /** Place in the manual. */
  source: string,
};

/** Data of one subject. */
export type MachineGroup = {
  /** The subject. */
  label: Message,
  /** Its data. */
  fields: Array<MachineField>,
};

/** How a datum of the machine is entered. */
export type MachineKind = "real" | "integer" | "choice" | "text";

/** A typed value that is not taken. */
export type MachineProblem = {
  /** Name of the datum. */
  name: string,
  /** What is wrong. */
  message: Message,
  /** The cure. */
  hint: Message,
};

/** Which machine, and what is typed into its form. */
export type MachineRequest = {
  /** Control. */
  control: Dialect,
  /** Machine; absent: the core's own as it is. */
  setup?: Machine,
  /** Basic system that it is to be built for from now on; the data keep their sizes. */
  basic?: BasicSystem,
  /** Typed values by name; an empty one goes back to what is delivered. */
  values: { [key in string]: string },
};

/** Sort of machine that a cycle is made for. */
export type MachineSort = "milling" | "turning" | "any";

/** What is set once per machine. */
export type MachineView = {
  /** Its data by subject. */
  groups: Array<MachineGroup>,
  /** Its basic system now. */
  basic: BasicSystem,
  /** What differs from delivery now, for the setup. */
  data: { [key in string]: Datum },
  /** Values that were not taken. */
  problems: Array<MachineProblem>,
  /** What differs, as blocks of a part program. */
  assignments: string,
  /** The same as lines of the definition file. */
  definitions: string,
};

/** What a piece of the triangles is. */
export type Matter = "part" | "cut" | "chuck" | "ball" | "stylus" | "body" | "carrier" | "zone";

/** A result of a call. */
export type Measured = {
  /** `_OVR[4]`. */
  name: string,
  /** Its meaning. */
  label: Message,
  /** Its value. */
  value: number,
  /** Unit on this machine. */
  unit: string,
  /** There where this call did not write it. */
  earlier: 0,
};

/** A text to be shown: key of the message files, with its arguments. */
export type Message = {
  /** Key in the message files, for example `check-out-of-range`; stems of the catalogue make others (`alarm-61307`). */
  key: string,
  /** Named arguments, in no particular order. */
  args: { [key in string]: Arg },
};

/**
 * Name of a parameter, as the manual writes it: `_SETVAL`, `_SETV[0]`, `D`. An entry and what reads
 * it use one constant.
 */
export type Name = string;

/** The call of a program to which something belongs; absent: none. */
export type OfCall = {
  /** Its line, from 1. */
  line?: number,
  /** Its cycle. */
  cycle?: string,
};

/** What a call does. */
export type Outcome = {
  /** What it wrote, and what it would have written but left as it was. */
  results: Array<Measured>,
  /** Decisions of the tolerance chain in order, the branch taken last. */
  decisions: Array<Message>,
  /** Alarms raised, the one that stopped it last. */
  alarms: Array<Raised>,
  /** Tool wear, zero offsets, memories, … */
  changes: Array<Change>,
  /** Lines of the log, and blocks that were sent. */
  log: Array<string>,
  /** Everything that happened. */
  trace: Trace,
  /** Where asked for: up to which errors it comes to its end. */
  limits?: Array<ErrorLimit>,
};

/** The core's own machine. */
export type OwnMachine = {
  /** What it begins with. */
  own: Beginning,
};

/** A parameter. */
export type ParameterInfo = {
  /** As the manual writes it: `_SETVAL`. */
  name: Name,
  /** Stem of its messages: `setval` of `param-setval`. */
  key: string,
  /** Rule of its unit. */
  unit: Unit,
  /** What counts while it is not written; none: it has to be. */
  default: number | null,
  /** Place in the manual. */
  source: string,
};

/** What is wrong with a part, mm and degree. */
export type PartSliders = {
  /** Displacement along X of the machine. */
  dx: number,
  /** Along Y. */
  dy: number,
  /** Along Z. */
  dz: number,
  /** Added to every diameter, width and length. */
  size: number,
  /** Turned about the applicate, degree. */
  tilt: number,
  /** Growth of the diameter per mm of depth. */
  taper: number,
  /** Amplitude of the three lobes of the radius. */
  outOfRound: number,
};

/** A word or call that the run went on without. */
export type PassedOver = {
  /** As it stands in the program. */
  word: string,
  /** Its line, from 1. */
  line: number,
};

/** A drawing. */
export type Picture = {
  /** From where. */
  view: View,
  /** Figures, those in front last. */
  shapes: Array<PictureShape>,
};

/** One figure. */
export type PictureShape = {
  /** What it stands for. */
  kind: ShapeKind,
  /** Polyline, or polygon when `closed`, mm; a dimension: its two ends. */
  points: Array<[number, number]>,
  /** Circle: centre and radius, mm. */
  circle?: Circle,
  /** A round opening in it: centre and radius, mm. */
  opening?: Circle,
  /** Whether the last point joins the first. */
  closed?: boolean,
  /** Name of a parameter or a number; never a sentence. */
  text?: string,
  /** Parameter that it explains. */
  field?: Name,
  /** Parameters without a figure of their own that are shown here too. */
  also?: Array<Name>,
};

/** Where the zero of a frame lies, machine coordinates, mm, and its directions. */
export type Place = {
  /** Zero. */
  at: [number, number, number],
  /** Directions X Y Z. */
  axes: [[number, number, number], [number, number, number], [number, number, number]],
};

/** Working plane. */
export type Plane = "G17" | "G18" | "G19";

/** What is wrong with a probe, mm. */
export type ProbeSliders = {
  /** Centre of the ball off the axis, along X; of a tool its length L1. */
  skewX: number,
  /** Along Y; of a tool its length L2. */
  skewY: number,
  /** Added to the radius of the ball, or of the tool. */
  radius: number,
  /** Travel after contact until the signal. */
  preTravel: number,
  /** Standard deviation of the switching point. */
  repeatability: number,
};

/** The probe that a cycle uses. */
export type ProbeUse = "workpiece" | "tool" | "none" | "log";

/** Where a cycle belongs. */
export type Purpose = {
  /** Sort of machine. */
  machine: MachineSort,
  /** In which plane such a machine works unless told otherwise. */
  plane: Plane | null,
  /** The probe that it uses. */
  probe: ProbeUse,
  /** Whether calibrating is all that it does. */
  calibrates: boolean,
};

/** An alarm that was raised, or why a simulation went no further. */
export type Raised = {
  /** Its name; empty: none of the control. */
  code: string,
  /** What it says. */
  message: Message,
  /** What helps. */
  hint?: Message,
  /** Whether it stops the program. */
  stops: boolean,
};

/** Range of a number. `f64::NEG_INFINITY`/`INFINITY` for an open end. */
export type Range = {
  /** Lower end. */
  min?: number,
  /** Whether `min` itself is allowed. */
  minIncluded: boolean,
  /** Upper end. */
  max?: number,
  /** Whether `max` itself is allowed. */
  maxIncluded: boolean,
};

/** Which program is read. */
export type ReadRequest = {
  /** Control. */
  control: Dialect,
  /** Its text. */
  text: string,
  /** Machine on which it starts; absent: the core's own as it is. */
  setup?: Machine,
};

/** A program. */
export type ReadView = {
  /** Its measuring calls in order. */
  calls: Array<CallView>,
  /** What is wrong with it. */
  diagnostics: Array<Diagnostic>,
};

/** Where positions count from, machine coordinates. */
export type Reading = {
  /** Zero, mm. */
  at: [number, number, number],
  /** Directions. */
  axes: [[number, number, number], [number, number, number], [number, number, number]],
  /** Whether X counts as a diameter. */
  diameter: boolean,
};

/** What a file is, by its bytes. */
export type Recognised = {
  /** How it is encoded. */
  encoding: Encoding,
} | {
  /** What it is instead. */
  why: Message,
};

/** A datum that a cycle leaves. */
export type ResultInfo = {
  /** `_OVR[4]`; of NCT a name of ours. */
  name: string,
  /** Key of its meaning. */
  key: string,
  /** Rule of its unit. */
  unit: Unit,
  /** Place in the manual. */
  source: string,
};

/** An alarm of a run. */
export type RunAlarm = {
  /** Its name; empty: none of the control. */
  code: string,
  /** What it says. */
  message: Message,
  /** What helps. */
  hint?: Message,
  /** Whether it stops the program. */
  stops: boolean,
  /** Its line, from 1. */
  line?: number,
  /** Its cycle. */
  cycle?: string,
};

/** What was assumed for a program that came without a machine. */
export type RunAssumed = {
  /** In words. */
  messages: Array<Message>,
  /** The machine on which it ran. */
  setup: Setup,
};

/** A decision of a cycle. */
export type RunDecision = {
  /** What was decided. */
  message: Message,
  /** Its line, from 1. */
  line?: number,
  /** Its cycle. */
  cycle?: string,
};

/** What is run. */
export type RunRequest = {
  /** Control. */
  control: Dialect,
  /** Text of the program. */
  text: string,
  /** Machine; absent: the core's own as it is. */
  setup?: Machine,
};

/** A result of a run. */
export type RunResult = {
  /** `_OVR[4]`. */
  name: string,
  /** Its value. */
  value: number,
  /** Its meaning, where a call left it. */
  label?: Message,
  /** Its unit, where a call left it. */
  unit?: string,
  /** Its line, from 1. */
  line?: number,
  /** Its cycle. */
  cycle?: string,
};

/** What a program did. */
export type RunView = {
  /** Everything that happened. */
  trace: Trace,
  /** What was found on the way. */
  diagnostics: Array<Diagnostic>,
  /** The results of each call; behind them what the program wrote beside them. */
  results: Array<RunResult>,
  /** What the cycles decided, in order. */
  decisions: Array<RunDecision>,
  /** What is different afterwards. */
  changes: Array<Change>,
  /** The alarms in order. */
  alarms: Array<RunAlarm>,
  /** Lines of the log, and blocks that were sent. */
  log: Array<string>,
  /** Whether it reached its end. */
  finished: boolean,
  /** What it went on without. */
  passedOver: Array<PassedOver>,
  /** How it ended. */
  ending: Message,
  /** Of a program that came without a machine: what was assumed. */
  assumed?: RunAssumed,
};

/** Which surface is scanned, and how. */
export type ScanRequest = {
  /** Control. */
  control: Dialect,
  /** A cycle that scans. */
  cycle: string,
  /** Values as typed, by parameter. */
  values: { [key in string]: string },
  /** Machine, with a surface as its part: that of a form. */
  setup: Machine,
  /** Working plane at the call, where it is not that of the machine. */
  plane?: Plane,
  /** G function of units at the call, likewise. */
  units?: UnitFunction,
  /** Another surface in its place, as large; absent: that of the machine. */
  surface?: SurfaceChoice,
};

/** A way to write a scan. */
export type ScanText = "program" | "points" | "surface";

/** What came out of a scan. */
export type ScanView = {
  /** How many points were scanned. */
  points: number,
  /** In how many lines. */
  lines: number,
  /** Why it did not come to its end. */
  alarms: Array<Raised>,
  /** How far the points as sent are from the true surface. */
  sent: Deviation,
  /** The same with the ball taken out. */
  surface: Deviation,
  /** The part. */
  solids: Solid[],
  /** Radius of the ball, mm. */
  radius: number,
  /** From where the points count, machine coordinates, mm. */
  origin: [number, number, number],
};

/** A coordinate system, machine coordinates. */
export type SceneFrame = {
  /** `MCS`, or the name of its zero offset. */
  name: string,
  /** Its zero, mm. */
  at: [number, number, number],
  /** Its directions. */
  axes: [[number, number, number], [number, number, number], [number, number, number]],
  /** `before` and `after` of one that a correction moved. */
  moved?: "before" | "after",
};

/** Words at a place. */
export type SceneLabel = {
  /** What it tells. */
  kind: LabelKind,
  /** Where, machine coordinates, mm. */
  at: [number, number, number],
  /** What is said, one after the other. */
  text: Array<Message>,
  /** Whether it stands at the upper end of a dimension line: neighbours have their words at different ends. */
  upper?: boolean,
  /** Parameter that the dimension explains, where a form asked. */
  field?: Name,
  /** Entry of the trace with which it comes; none: it is always there. */
  from?: number,
  /** Entry with which it goes again. */
  to?: number,
};

/** A part of the triangles. */
export type ScenePiece = {
  /** What it is. */
  matter: Matter,
  /** Its part of the corners, from and to (excluded). */
  corners: [number, number],
  /** Its part of the vertices. */
  vertices: [number, number],
  /** Where it stands, by index in the places of a standing; none: from the position of the machine on. */
  place?: number,
  /** With which of the tools it is there; none: always. */
  tool?: number,
};

/** Sizes of the probe as it is drawn, mm. */
export type SceneProbe = {
  /** Radius of the ball. */
  ball: number,
  /** From the centre of the ball to the spindle. */
  length: number,
  /** Radius of the stylus. */
  stylus: number,
  /** From the centre of the ball to the end of the stylus. */
  reach: number,
};

/** What is in use. */
export type SceneTool = {
  /** Direction from the ball to what holds it; none: no probe. */
  ball?: [number, number, number],
  /** Its end, from the position of the machine on. */
  tip: [number, number, number],
  /**
   * Box around a tool without what carries it, from the position of the machine on; none for a probe, of which the
   * stylus may be cut off.
   */
  extent?: [[number, number, number], [number, number, number]],
  /** Whether a turret is drawn that carries it. */
  carried: boolean,
};

/** What the arrays of a scene hold. */
export type SceneView = {
  /** Parts of the triangles: what hides, then what is seen through. */
  pieces: Array<ScenePiece>,
  /** Parts of the lines. */
  groups: Array<LineGroup>,
  /** How everything stands, from which entry on; at least one. */
  standings: Array<Standing>,
  /** Whatever was in use, each once. */
  tools: Array<SceneTool>,
  /** From which entry on, on which of them. */
  inUse: Array<[number, number]>,
  /** The probe. */
  probe: SceneProbe,
  /** Diagonal of what is to be seen, mm. */
  size: number,
  /** Length of the normal at a touch, mm. */
  normal: number,
  /** Length of the axes of a coordinate system, mm. */
  axis: number,
  /** Coordinate systems. */
  frames: Array<SceneFrame>,
  /** What is written beside all that. */
  labels: Array<SceneLabel>,
  /** Of a turning machine: how the control counts. Dimensions of its part are lines of that kind, and labels. */
  reading?: Reading,
  /** Whether it is a turning machine. */
  turning: boolean,
  /** How many entries the trace has. */
  entries: number,
};

/** How bad it is. */
export type Severity = "error" | "warning" | "note";

/** What a figure stands for. */
export type ShapeKind = "material" | "cut" | "edge" | "zone" | "probe" | "path" | "dimension" | "label" | "tolerance" | "axis" | "touch";

/** What both calls say. */
export type Shared = {
  /** What it is. */
  label: Message,
  /** Its value; a length in the active unit. */
  value: number,
};

/** How everything stands from an entry of the trace on: rotary axes turn the part. */
export type Standing = {
  /** From when this one is done on. */
  entry: number,
  /** Where each solid stands: those of the part, then what stays. */
  places: Array<Place>,
  /** What is to be seen whole, without the tool: least and greatest coordinates. */
  whole: [[number, number, number], [number, number, number]],
};

/** A way to write a call. */
export type Style = "direct" | "indirect" | "operate";

/** What stands in the place of a surface, as large as that. */
export type SurfaceChoice = { "example": string } | { "picture": number } | "stl";

/** A line that would be another one. */
export type TouchedLine = {
  /** Its number, from 1. */
  line: number,
  /** As it is. */
  before: string,
  /** As it would be; empty where it goes. */
  after: string,
};

/** How the program gives positions of the transverse axis X of a lathe. */
export type Transverse = "DIAMOF" | "DIAMON" | "DIAM90";

/** The same task on the other control. */
export type TwinView = {
  /** That control. */
  control: Dialect,
  /** Its cycle. */
  cycle: string,
  /** Stem of its messages. */
  key: string,
  /** What both measure. */
  task: Message,
  /** Values as typed there. */
  values: { [key in string]: string },
  /** Text of the program there. */
  snippet: string,
  /** What both say. */
  shared: Array<Shared>,
  /** What is different there. */
  differences: Array<Message>,
};

/** Unit of a parameter and the system it counts in. */
export type Unit = "" | "active length" | "basic length" | "mm" | "deg" | "basic feed";

/** G function that chooses the system of units; those below 70 are of NCT. */
export type UnitFunction = "G20" | "G21" | "G70" | "G71" | "G700" | "G710";

/** Values of a variant as typed, by parameter name. */
export type Values = {
  /** Those that choose it. */
  values: { [key in string]: string },
  /** Those of its worked measurement. */
  example: { [key in string]: string },
};

/** A measuring variant. Its values, as typed, choose it; its example is a worked measurement. */
export type VariantInfo = {
  /** Its number. */
  mvar: number,
  /** Key of its name. */
  key: string,
  /** Place in the manual. */
  source: string,
  /** Keys of what the digits of its number choose, the lowest place first. */
  choices: Array<string>,
  /** In the planes in which other addresses name the axes. */
  planes: { [key in Plane]?: Values },
  /** Those that choose it. */
  values: { [key in string]: string },
  /** Those of its worked measurement. */
  example: { [key in string]: string },
};

/** From where the drawing is seen. */
export type View = "plane" | "section";

// What is drawn of a run, and the setup file: described by hand (core/src/json/tests/drawn.ts), as they are written by
// hand.

export type Vec3 = [number, number, number];

/** Centre and radius, mm. */
export interface Circle {
  x: number;
  y: number;
  r: number;
}

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
