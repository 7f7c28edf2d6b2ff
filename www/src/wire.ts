// Questions and answers of the core. Written from core/src/app by a test of the core (json/tests/wire.rs) when it runs
// with PROBEWRIGHT_UPDATE=1; not by hand.

export type Vec3 = [number, number, number];

/** What the machine can do. */
export type Abilities = {
  /** Software limit switches on the minus side (MD36100) of the machine axes X Y Z; null: none. */
  limitsMinus: [number | null, number | null, number | null],
  /** Software limit switches on the plus side (MD36110) of the machine axes X Y Z; null: none. */
  limitsPlus: [number | null, number | null, number | null],
  /** Whether the spindle can be positioned with SPOS. */
  spindlePositions: boolean,
  /**
   * Point X Y Z on the lines about which the rotary axes turn the part. Which there are: MD20080 and MD30300 in
   * `data`.
   */
  rotaryCentre: [number, number, number],
  /**
   * How far the workpiece probe may be deflected in the directions of measuring, mm; none: not known. With MD10050,
   * MD10070, MD32300 and MD32200 in `data` feeds beyond it are told.
   */
  deflection?: number,
  /** The turret of a turning machine. */
  turret: Turret,
};

/** What is active at the start. */
export type Active = {
  /** T number in the spindle, 0 none. */
  tool: number,
  /** D number (NCT: H), 0 none. */
  edge: number,
  /** Settable frame, for example `G54`. */
  frame: string,
  /** G function of units: `G70`, `G71`, `G700`, `G710` (NCT `G20`, `G21`); none: that of the basic system. */
  units: UnitFunction,
  /** How positions of the transverse axis X of a lathe are given. */
  transverse: Transverse,
  /** Position of the spindle, degree, positive as M3 turns it. */
  spindle: number,
  /** Where the rotary axes A B C stand, machine, degree. */
  rotary: [number, number, number],
};

/** What a variant is for. */
export type Aim = {
  /** What is measured. */
  element: Element,
  /** What is corrected. */
  corrects: Array<Corrected>,
  /** What is left to choose: keys of question and answer. */
  options: Array<[string, string]>,
};

/** An alarm, or a text for the operator. */
export type AlarmInfo = {
  /** Name of the alarm: `61303`, `PROBE FAIL`; of a text for the operator the text itself. */
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
  source: Cited,
};

/** What a call came to. */
export type Answer = {
  /** What is measured, in words. */
  feature: Message,
  /** What was measured, the most important first. */
  figures: Array<Figure>,
  /** What was corrected; none: nothing. */
  corrected: Array<Correction>,
  /** Where the deviations lie in their limits; absent: nothing limits them. */
  gauge?: Gauge,
  /** What follows. */
  verdict: Verdict,
  /** The verdict in words. */
  verdict_words: Message,
  /** Number or text of the alarm or operator message behind the verdict. */
  alarm?: string,
  /** Why, in a sentence. */
  why: Message,
  /** The measuring result screen; absent: the control shows none. */
  screen?: ResultScreen,
};

/** One argument of a message. */
export type Arg = number | string;

/** How a way between two points goes round an axis. */
export type Around = {
  /** A point of the axis. */
  centre: Mcs,
  /** Unit vector along it. */
  axis: [number, number, number],
  /** Degrees from start to end, right-handed about the axis; whole turns included. */
  degrees: number,
};

/** A block that a control cannot have. */
export type AroundAbsent = {
  /** Key of its title. */
  key: string,
  /** Key of the sentence that says why. */
  why: string,
};

/** A block. */
export type AroundBlock = {
  /** Its name. */
  name: string,
  /** Key of its title; with `-help` what it does. */
  key: string,
  /** Whether it is wanted. */
  wanted: boolean,
  /** Whether it suits the call. */
  suits: boolean,
  /** Its fields. */
  fields: Array<AroundField>,
  /** Keys of its comments and texts. */
  says: Array<string>,
};

/** A field of a block. */
export type AroundField = {
  /** Its name. */
  name: string,
  /** Key of its label. */
  key: string,
  /** As typed, else as the program has it. */
  value: string,
  /** What counts without: a value, of a text its key. */
  preset: string,
  /** Whether that is the key of a text. */
  text: boolean,
  /** What can be chosen, each with the key of its name; empty: anything can be entered. */
  choices: Array<[string, string]>,
  /** What is wrong with it. */
  problem: Message | null,
};

/** A block that can stand around a call. */
export type AroundInfo = {
  /** Control that has it. */
  control: Dialect,
  /** Its name. */
  name: string,
  /** Key of its title; with `-words` by what it is found. */
  key: string,
};

/** What is asked about the blocks around a call. */
export type AroundRequest = {
  /** Control. */
  control: Dialect,
  /** Cycle of a call that is still to be written. */
  cycle: string,
  /** Its values as typed. */
  values?: { [key in string]: string },
  /** Text of the program. */
  text: ProgramText,
  /** Which of its calls, from 0; absent: the call is still to be written. */
  call?: number,
  /** The blocks that are wanted; absent: those that stand there. */
  wanted?: Array<AroundWanted>,
  /** Words by key, for comments and operator texts. */
  words?: { [key in string]: string },
  /** Whether each line gets its comment. */
  comments?: boolean,
  /** Machine; absent: the core's own as it is. */
  setup?: Machine,
  /** Files beside it, of which definition files count; absent: none. */
  with?: Array<Beside>,
};

/** The blocks around a call. */
export type AroundView = {
  /** Those that suit the call or stand there, the outermost first. */
  blocks: Array<AroundBlock>,
  /** Lines before a call that is still to be written. */
  before: string,
  /** Lines behind it. */
  after: string,
  /** The only places of the text that change, where the call is in the program. */
  edits: Array<Edit>,
  /** Blocks that this control cannot have. */
  absent: Array<AroundAbsent>,
};

/** A block that is wanted. */
export type AroundWanted = {
  /** Its name. */
  name: string,
  /** Its values as typed. */
  values: { [key in string]: string },
};

/** A value that arrives at a call. */
export type Arrival = {
  /** As it is written. */
  value: string,
  /** Line of the assignment, from 1. */
  line: number,
};

/** A face that was touched. */
export type Arrow = {
  /** Index of the call. */
  call: number,
  /** The point that is touched, machine coordinates, mm. */
  at: Mcs,
  /** From where the face should be to where it is, machine coordinates, mm. */
  by: [number, number, number],
};

/** An assignment that would be another. */
export type Assignment = {
  /** The number that it would assign, as it is written. */
  value: string,
  /** The only places of the text that change. */
  edits: Array<Edit>,
  /** Its line, as it is and as it would be. */
  line: TouchedLine,
  /** What the calls of the program would say otherwise. */
  values: Array<ComparedValue>,
};

/** Ball, stylus and body of the probe. */
export type Ball = {
  /** Radius of the ball. */
  radius: number,
  /** From the spindle nose to its centre. */
  length: number,
  /** Radius of the stylus above it. */
  stylus: number,
  /** What holds the stylus, where that is known. */
  body?: ProbeBody,
};

/** A part of a scale. */
export type Band = {
  /** What a deviation there means. */
  kind: BandKind,
  /** Left end. */
  from: number,
  /** Right end. */
  to: number,
};

/** What a deviation means. */
export type BandKind = "good" | "mean" | "bad";

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
  /** User data that definition files add: lines with `DEF`. */
  definitions?: Array<string>,
};

/** A file beside a program. */
export type Beside = {
  /** Name of the file, by which calls find it. */
  name: string,
  /** Its text. */
  text: string,
};

/** The parts of a braking path, mm. */
export type BrakingPath = {
  /** Until the command to brake. */
  delay: number,
  /** While the set speed falls to zero. */
  braking: number,
  /** What the axis lags behind its set position. */
  following: number,
  /** All of it. */
  sum: number,
};

/** An axis, and what is asked of it. */
export type BrakingRequest = {
  /** From the signal to the braking command, s. */
  delay: number,
  /** Deceleration, m/s². */
  acceleration: number,
  /** Servo gain, (m/min)/mm. */
  gain: number,
  /** Feed whose path is asked for, mm/min. */
  feed?: number,
  /** Deflection whose largest feed is asked for, mm. */
  deflection?: number,
};

/** What an axis needs to stop. */
export type BrakingView = {
  /** Path of the feed. */
  path?: BrakingPath,
  /** Largest feed of the deflection, mm/min. */
  feed?: number,
};

/** Whence the calibration of a probe. */
export type CalibrationState = "calibrates" | "run" | "stored" | "differs";

/** A call and how certain it is. */
export type CallCertainty = {
  /** What it measures, as far as it spreads. */
  figures: Array<Certain>,
  /** Line of the call, from 1. */
  line?: number,
  /** Cycle that is called. */
  cycle?: string,
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
  /** What it is called, where it is written in a list of newer controls and its variant is known. */
  title?: Message,
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
  /** Where each value is written that is written in one place: first UTF-16 unit, and one past the end. */
  places: { [key in Name]: [number, number] },
  /** Working plane there. */
  plane: Plane,
  /** How X is given there. */
  transverse: Transverse,
  /** G function of units active there. */
  units: UnitFunction,
  /** What is wrong with it. */
  diagnostics: Array<Diagnostic>,
  /**
   * Notes at values that come from other programs of the text, or differ by the way to the call; without a parameter
   * those about the user's programs that run before and after it.
   */
  arrivals: Array<Diagnostic>,
};

/** Capability of a process that is normal, with intervals of 95 %. */
export type Capability = {
  /** `(TU − TL)/(6s)`: by its spread alone. */
  cp: number,
  /** `min(TU − x̄, x̄ − TL)/(3s)`: also by where its mean lies. */
  cpk: number,
  /** Where the first lies with 95 % confidence, by chi-square. */
  cpInterval: [number, number],
  /** Where the second does (A. F. Bissell, Applied Statistics 39, 1990). */
  cpkInterval: [number, number],
};

/** What came of a case. */
export type CaseView = {
  /** What it is called. */
  id: string,
  /** Where the expectation comes from. */
  oracle: string,
  /** How it differs from the expectation; empty: it holds. */
  differences: Array<Message>,
  /** What it does not prove although it holds. */
  unproven: Array<Message>,
};

/** Everything that can be measured. */
export type Catalogue = {
  /** In the order in which they are offered. */
  cycles: Array<CycleInfo>,
  /** Axis of the machine (X 0, Y 1, Z 2) about which the error `tilt` of the sliders turns a part, by plane. */
  applicate: Record<Plane, 0 | 1 | 2>,
  /** Controls with which measuring in JOG can be practised. */
  practises: Array<Dialect>,
  /** Blocks that can stand around a call. */
  around: Array<AroundInfo>,
  /** Guides by id, as links name them: keys `guide-…` of their titles, and with `-words` by what they are found. */
  guides: Array<string>,
  /** Concepts, terms and connections, which can be looked up. */
  explained: Array<ExplainedInfo>,
};

/** A text for a field. */
export type CellText = {
  /** Its table. */
  table: EquipmentTable,
  /** Its row. */
  row: string,
  /** Key of its name. */
  cell: string,
  /** What is typed. */
  text: string,
};

/** A quantity and how certain it is, in its unit. */
export type Certain = {
  /** The result that has its actual value: `_OVR[4]`. */
  name: string,
  /** Meaning of the result. */
  label: Message,
  /** What stands before its value: `Ø`, `X`; empty: nothing. */
  symbol: string,
  /** Unit at the call. */
  unit: string,
  /** As measured. */
  value: number,
  /** Expanded uncertainty U = k·u, rounded up to two digits. */
  expanded: number,
  /** Decimal places with which value and U are told. */
  decimals: number,
  /** Coverage factor k. */
  coverage: number,
  /** What the value proves about its limits; absent: nothing limits it. */
  proof?: Proof,
  /** The same as chances of the part at hand. */
  chances?: CertainChances,
  /** What makes how much of the uncertainty, the largest first. */
  budget: Array<Contribution>,
};

/** Chances of a part, together 1. */
export type CertainChances = {
  /** Within the limits. */
  good: number,
  /** Beyond, metal is left. */
  rework: number,
  /** Beyond, metal is missing. */
  scrap: number,
  /** Beyond, of what can be neither. */
  beyond: number,
};

/** What is asked. */
export type CertaintyRequest = {
  /** The form, with its machine and the errors of part and probe. */
  form: FormRequest,
  /** How many measurements, up to 10 000; absent: 1000. */
  runs?: number,
  /** Seed of all random numbers; absent: that of the machine's series. */
  seed?: number,
};

/** How certain a measurement is. */
export type CertaintyView = {
  /** How many measurements; 0: nothing spreads, or nothing is measured. */
  runs: number,
  /** Share of them that did not come to an end. */
  stopped: number,
  /** What was measured, the most important first. */
  figures: Array<Certain>,
};

/** The limits of a form. Places are mm, or degrees where the limits are angles, from the setpoint. */
export type Chain = {
  /** The scale reaches so far on both sides. */
  end: number,
  /**
   * Up to about here the scale is even, beyond it ever closer: the widest limit may be a hundred times the
   * narrowest.
   */
  bend: number,
  /** A bar each, in the order in which a deviation is compared: the widest first. */
  bars: Array<ChainBar>,
};

/** A bar between two limits, or of one limit to both sides. */
export type ChainBar = {
  /** Place from which its limits count. */
  zero: number,
  /** One that counts to both sides, or the lower and the upper one. */
  limits: Array<ChainLimit>,
};

/** An end of a bar. Its figures are in the unit of its field. */
export type ChainLimit = {
  /** Parameter. */
  name: Name,
  /** Its name in words. */
  label: Message,
  /** Unit of its field. */
  unit: string,
  /** mm in one of that unit. */
  per: number,
  /** What it is: what was entered, else what counts then. */
  value: number,
  /** Least value that keeps the order of the limits. */
  least: number,
  /** Greatest one; none: any. */
  most?: number,
  /** Smallest difference that matters. */
  step: number,
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
  text: ProgramText,
  /** Which of its calls, from 0. */
  call: number,
  /** Parameter. */
  name: string,
  /** New value, as typed; empty: the parameter is removed. */
  value: string,
  /** Parameters that are typed along with it: where it chooses another variant, their values are meant for that. */
  along?: Array<string>,
  /** Machine on which the program starts; absent: the core's own as it is. */
  setup?: Machine,
  /** Files beside it, of which definition files count; absent: none. */
  with?: Array<Beside>,
};

/** What a new value does to a program. */
export type Changed = {
  /** Lists of edits, each for the text after the ones before it; the only places that change. */
  steps: Array<Array<Edit>>,
  /** Lines outside of the call's own that they change. */
  elsewhere: Array<TouchedLine>,
  /** The expression of the program that the value takes the place of; null: there is none, or the value is one too. */
  replaced: Replaced | null,
  /** Parameters that the new variant does not know, or whose value does not fit it, taken out of the call. */
  taken: Array<Name>,
  /** Those of them whose value does not fit. */
  unfit: Array<Unfit>,
  /** What the calls of the program would say otherwise. */
  values: Array<ComparedValue>,
  /** Whether more changes than this value of this call: other lines, other calls that read it, other values of it. */
  reaches: boolean,
  /** What that means. */
  findings: Array<Diagnostic>,
};

/** A number with its name. */
export type Choice = {
  /** Number as it is written. */
  value: number,
  /** Name of the choice. */
  label: Message,
};

/**
 * Lines of manuals where a fact is found, such as `B:2408-2469;A:2591`; shown and serialized as titles, editions and
 * chapters (`Measuring Cycles 04/2006, 3.1.2; Measuring Cycles 10/2004, 3.1.2`).
 */
export type Cited = string;

/** Where a problem is named. */
export type Code = string;

/** A column of a text. */
export type Column = {
  /** As it stands there. */
  text: string,
  /** What it shows. */
  label: Message,
  /** The whole text, as typed, without it. */
  without: string,
};

/** A column that can be added. */
export type ColumnOffer = {
  /** As it is written; empty: what is typed then. */
  text: string,
  /** What it shows. */
  label: Message,
};

/** The columns of a text. */
export type Columns = {
  /** Those in it, in their order. */
  list: Array<Column>,
  /** The text, as typed, up to where a further column is written: its separator is there. */
  before: string,
  /** What stands behind that. */
  after: string,
  /** What can be added. */
  offers: Array<ColumnOffer>,
  /** The lines that are printed, with the values of the last measurement or of an example. */
  printed: Array<string>,
  /** The last of them with the mark behind values that exceed a limit; empty: there is no mark, or no such value. */
  marked: string,
  /** Values that do not fit their columns. */
  narrow: Array<Message>,
};

/** A way to commission. */
export type CommissioningPath = {
  /** By which it is known. */
  id: string,
  /** For which machine it is. */
  title: Message,
  /** Its steps, in their order. */
  steps: Array<CommissioningStep>,
};

/** A step of it. */
export type CommissioningStep = {
  /** By which it is known in all ways: `adv-old/6-3`. */
  id: string,
  /** As other steps name it: `6.3`; empty: none does. */
  number: string,
  /** What it is about. */
  title: Message,
  /** What is to be done. */
  action: Message,
  /** When it is due; absent: always. */
  condition?: Message,
  /** How it is seen to be right. */
  check?: Message,
  /** Versions for which it is; empty: all. */
  versions: string,
  /** Files and archives. */
  files: string,
  /** Softkeys and lines, as the control has them. */
  softkeys: string,
  /** Place in the manual. */
  source: Cited,
};

/** All ways to commission, and all connections. */
export type CommissioningView = {
  /** The ways, by operator panel and its version. */
  paths: Array<CommissioningPath>,
  /** Connections of probes. */
  connections: Array<ConnectionView>,
};

/** A value that a call has in one way of writing only, or otherwise in the other. */
export type ComparedValue = {
  /** Line of the call as it is, from 1. */
  line: number,
  /** Cycle. */
  cycle: string,
  /** Parameter, or the argument of a newer control. */
  param: string,
  /** Key of its label; empty: it has none. */
  key: string,
  /** As it arrives at the call now; null: it does not, and the value is added. */
  before: string | null,
  /** As it would arrive; null: it would not, and the value is lost. */
  after: string | null,
};

/** For which machine the versions are asked. */
export type CompatibilityRequest = {
  /** Machine; absent: none in particular. */
  setup?: Machine,
};

/** Software of a component. */
export type CompatibilityRow = {
  /** NCU, CCU or operator panel. */
  component: string,
  /** Version of its software. */
  version: string,
  /** Whether each function works with it. */
  works: Array<Message>,
  /** Whether the machine may have it. */
  here: boolean,
  /** Place in the manual. */
  source: Cited,
};

/** Which versions work together. */
export type CompatibilityView = {
  /** What works with a software or not. */
  functions: Array<Message>,
  /** Software of the components, those of a component together. */
  rows: Array<CompatibilityRow>,
  /** What the machine says of its software. */
  told: Message,
};

/** What is dragged in the picture of a concept. */
export type ConceptExample = {
  /** Name of the parameter; empty: it is none. */
  name: string,
  /** What it is, in words. */
  label: Message,
  /** Unit of its values. */
  unit: string,
  /** Least value. */
  from: number,
  /** Greatest value. */
  to: number,
  /** Value with which the picture begins. */
  value: number,
  /** Smallest step. */
  step: number,
  /** Whether only whole numbers are values of it. */
  whole: boolean,
};

/** The picture of a concept. */
export type ConceptPicture = {
  /** The same paper for each value: what grows is seen to grow. */
  picture: Picture,
  /** Values of its parameters. */
  values: { [key in string]: string },
  /** What it comes to. */
  told?: Message,
};

/** Which picture. */
export type ConceptRequest = {
  /** The concept. */
  concept: string,
  /** What is dragged, in its unit; beyond an end of its range that end counts. */
  value: number,
};

/** A concept with its page. */
export type ConceptView = {
  /** By which a field names it. */
  id: string,
  /** Group in which it stands. */
  group: Message,
  /** Title of the page. */
  title: Message,
  /** What it says. */
  lines: Array<Message>,
  /** Parameters and data that it explains. */
  names: Array<string>,
  /** Place in the manual. */
  source: Cited,
  /** Its live picture; absent: no picture carries it. */
  example?: ConceptExample,
  /** Why no picture carries it; absent: it has one. */
  still?: Message,
};

/** A connection. */
export type ConnectionView = {
  /** Pin, plug or address. */
  signal: string,
  /** Its name. */
  title: Message,
  /** What it carries, and what is to be set and checked. */
  meaning: Message,
  /** Place in the manual. */
  source: Cited,
};

/** A part of an uncertainty. */
export type Contribution = {
  /** What it comes from. */
  source: Message,
  /** Share of the square of the uncertainty. */
  share: number,
};

/** A call in another style. */
export type ConvertRequest = {
  /** Control. */
  control: Dialect,
  /** Text of the program. */
  text: ProgramText,
  /** Which of its calls, from 0; absent: all that can be written so. */
  call?: number,
  /** The call style. */
  style: Style,
  /** Machine on which the program starts; absent: the core's own as it is. */
  setup?: Machine,
  /** Files beside it, of which definition files count; absent: none. */
  with?: Array<Beside>,
};

/** Edits that write calls in another way. */
export type Converted = {
  /** The only places of the text that change; none: it is not possible, see the findings. */
  edits: Array<Edit>,
  /** What has to be said about it. */
  findings: Array<Diagnostic>,
  /** The values that the calls would gain, lose or have otherwise. */
  values: Array<ComparedValue>,
  /** How many calls are written anew. */
  calls: number,
};

/** What a variant corrects. */
export type Corrected = {
  /** What it is. */
  corrects: Corrects,
  /** Key of its name. */
  key: string,
  /** Values, as typed, that the worked measurement has for it instead. */
  values: { [key in string]: string },
};

/** A frame, tool, register or probe that was corrected. */
export type Correction = {
  /** What it is. */
  target: Message,
  /** By how much; none: its data are new. */
  parts: Array<Part>,
};

/** What is corrected, in the order in which it is offered. */
export type Corrects = "zero" | "tool" | "probe" | "setter" | "nothing";

/** Edits that fix a finding. */
export type Cure = {
  /** What they do. */
  label: Message,
  /** The only places of the text that change. */
  edits: Array<Edit>,
};

/** All findings of a kind, to be cured at once. */
export type CureRequest = {
  /** Control. */
  control: Dialect,
  /** Text of the program. */
  text: ProgramText,
  /** Name of the findings. */
  code: string,
  /** Key of their cause. */
  key: string,
  /** Machine on which the program starts; absent: the core's own as it is. */
  setup?: Machine,
  /** Files beside it, of which definition files count; absent: none. */
  with?: Array<Beside>,
};

/** Edits that cure findings of a kind. */
export type CuredAll = {
  /** The only places of the text that change. */
  edits: Array<Edit>,
  /** Findings that are gone then. */
  gone: number,
  /** Findings with a cure that are left then. */
  left: number,
};

/** What cuts. */
export type Cut = { "cutter": Cutter } | { "nose": Nose };

/** A milling cutter or drill about its axis, with a flat end or one that ends in a point. */
export type Cutter = {
  /** Radius to the cutting edge, mm. */
  radius: number,
  /** Radius between end and side, mm. */
  corner: number,
  /** How far the lowest place of an edge lies inside of the widest, and below it, mm; beside `corner`. */
  chamfer: [number, number],
  /** Number of teeth, evenly spread; 0: smooth all round. */
  teeth: number,
  /** Where the first tooth stands with the spindle at 0, degree. */
  angle: number,
  /**
   * How far the axis of the cutter stands beside that of the spindle, and how much lower than in the mean a tooth in
   * that direction stands, mm. A smooth cutter has neither.
   */
  runout: [number, number],
  /** Direction of the run-out with the spindle at 0. */
  runoutAngle: number,
  /** Axis of the plane along which it stands, its end in minus direction: 0 abscissa, 1 ordinate, 2 applicate. */
  axis: number,
  /**
   * Width of a groove mill, mm, whose length goes to its upper edge, that at the shank; 0: another cutter, whose
   * length goes to the lowest edge. What holds a groove mill is out of the way.
   */
  disc: number,
};

/** A measuring cycle or macro. */
export type CycleInfo = {
  /** Control that has it. */
  control: Dialect,
  /** Name of the cycle: `CYCLE977`. */
  cycle: string,
  /** Stem of its messages: `cycle977` of `cycle977-title`, `cycle977-words`, `cycle977-help`. */
  key: string,
  /** Where it belongs. */
  purpose: Purpose,
  /** The styles that its call has, direct first. */
  styles: Array<Style>,
  /** Whether a parameter takes the number of the variant; else that number is ours, and no program writes it. */
  numbered: boolean,
  /** Measuring variants of the cycle. */
  variants: Array<VariantInfo>,
  /** Parameters of the cycle, in the order in which they are written. */
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
  source: Cited,
};

/** A value of user data. */
export type Datum = number | string;

/** A machine, and how many channels measure on it. */
export type DefinitionsRequest = {
  /** Machine; absent: the core's own as it is. */
  setup?: Machine,
  /** Channels; absent: one. */
  channels?: number,
  /** Whether it measures in JOG too; absent: it does. */
  jog?: boolean,
};

/** Lines for a file. */
export type DefinitionsText = {
  /** The file on the control. */
  name: string,
  /** Name under which the lines are saved. */
  saved: string,
  /** The lines. */
  text: string,
};

/** What goes into the files of a machine. */
export type DefinitionsView = {
  /** The files of which lines differ, and behind them the program of value assignments. */
  files: Array<DefinitionsText>,
  /** Memory of each array whose size is chosen. */
  memory: Array<MemoryShare>,
  /** What the machine data for it have to be, for these channels. */
  needs: Array<MemoryNeed>,
  /** In which order it is done, and what should be known. */
  notes: Array<Message>,
};

/** How far points are from the true surface, mm. */
export type Deviation = {
  /** Greatest. */
  greatest: number,
  /** Root of the mean square. */
  mean: number,
};

/** What is wrong, where, and how to fix it. */
export type Diagnostic = {
  /** How bad. */
  severity: Severity,
  /** Name of the finding: `61307`, `FORMAT ERROR`, `PW012`. */
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
  /** Fixes it at once. */
  cure?: Cure,
  /** Lines that the cure changes elsewhere than where the finding is told. */
  elsewhere?: Array<TouchedLine>,
  /** Files that are wanted, by the names that calls have for them. */
  wants?: Array<string>,
  /** What the machine lacks, each a fix. */
  offers?: Array<Offer>,
};

/** The language of the part program, and with it the control. */
export type Dialect = "sinumerik" | "nct";

/** A diameter, mm. */
export type Diameter = {
  /** Both ends as it is, machine coordinates. */
  ends: [[number, number, number], [number, number, number]],
  /** Along the axis, away from the part. */
  out: [number, number, number],
  /** As it should be. */
  set: number,
  /** As it is. */
  real: number,
};

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

/** What a drawing of the part of a turning machine shows. */
export type Drawing = {
  /** Diameters of the part. */
  diameters: Array<Diameter>,
  /** Diameters at which the part was touched. */
  touched: Array<Touched>,
  /** How the control counts. */
  reading: Reading,
};

/** Data of a cutting edge. */
export type EdgeData = {
  /** `$TC_DP1`: 710 3D probe, 120 end mill, 580 probe of a turning machine. */
  type: number,
  /** `$TC_DP2`: cutting edge position of a turning tool or lathe probe, 1 to 9. */
  tip: number,
  /** Geometry L1 L2 L3. */
  length: [number, number, number],
  /** Geometry radius. */
  radius: number,
  /** Wear of L1 L2 L3. */
  lengthWear: [number, number, number],
  /** Wear of the radius. */
  radiusWear: number,
  /** Additive offsets by DL number: L1 L2 L3 radius. */
  additive: { [key in number]: [number, number, number, number] },
  /** Setup offsets by DL number: L1 L2 L3 radius. */
  setup: { [key in number]: [number, number, number, number] },
  /** Other tool data by number, `$TC_DP7` to 11 and 16 to 25; 21 to 23 are the lengths of the adapter. */
  further: { [key in number]: number },
  /** The tool as it really is where it touches a tool probe; none: as its data say at the start. */
  real?: RealTool,
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

/** What is measured, in the order in which it is offered. */
export type Element = "hole" | "shaft" | "groove" | "web" | "pocket" | "boss" | "edge" | "corner" | "angle" | "sphere" | "turned" | "tool" | "probe" | "points" | "surface" | "move";

/** Something of such a control. */
export type Elsewhere = {
  /** Its name there: `SD54600`, `S_MD`, `CYCLE996`, `61444`, `TCH PROBE 421`. */
  code: string,
  /** Whether it is an alarm. */
  alarm: boolean,
  /** Key of what it means. */
  key: string,
  /** Key of what more there is to say; not every language file has it. */
  help: string,
  /** Other names by which it is looked for. */
  words: string,
  /** What else is known of it. */
  lines: Array<Message>,
  /** Its arguments or parameters, in their order. */
  parts: Array<ElsewherePart>,
  /** Calls that have it, each with its place there: `CYCLE977 (9)`. */
  owners: Array<string>,
};

/** An argument or a parameter of a cycle. */
export type ElsewherePart = {
  /** Its name; empty: none is published. */
  name: string,
  /** Key of what it means. */
  key: string,
};

/** What is recognised. Whoever shows the text may know more, to be chosen by hand. */
export type Encoding = "utf-8" | "utf-8-marked" | "utf-16le" | "utf-16le-marked" | "utf-16be" | "utf-16be-marked" | "gbk" | "gb18030" | "shift_jis" | "windows-1252";

/** What was in effect when an environment was stored. */
export type Environment = {
  /** T number. */
  tool: number,
  /** D number, 0 none. */
  edge: number,
  /** DL number, 0 none. */
  location: number,
  /** Working plane: it decides which length works in which axis. */
  plane: Plane,
};

/** Which machine is changed how. */
export type EquipRequest = {
  /** Control. */
  control: Dialect,
  /** Machine; absent: the core's own as it is. */
  setup?: Machine,
  /** What is done to it; absent: nothing. */
  change?: EquipmentChange,
  /** The program that it is for. */
  text?: string,
  /** Files beside it; absent: none. */
  with?: Array<Beside>,
  /** The call whose part it gets. */
  call?: FormRequest,
};

/** The machine afterwards. */
export type EquipView = {
  /** The machine. */
  setup: Setup,
  /** Its tables. */
  tables: Array<EquipmentRows>,
  /** The row that was changed or added, as it is called now. */
  row?: string,
  /** Why nothing was changed. */
  problem?: Refusal,
};

/** A field. */
export type EquipmentCell = {
  /** As typed. */
  value: string,
  /** As a program writes it: `_WP[0,1]`, `MD18600`. */
  name: string,
  /** What else it is looked for as: the identifier of a setting datum, the user datum of older controls. */
  also?: string,
  /** Key of its name; `.help`, and `.v0`, `.v1`, … of a choice, may stand behind it. */
  key: string,
  /** Unit as it counts on this machine. */
  unit: string,
  /** What is allowed, in that unit. */
  range: Range,
  /** Place in the manual. */
  source: Cited,
  /** Whether nothing in the simulation reads it. */
  idle: boolean,
  /** Versions of the measuring cycles in which it is there, where that is told. */
  versions?: Versions,
} & ({ "kind": "real" } | { "kind": "integer" } | { "kind": "choice",
  /** The numbers. */
  choices: Array<number>,
} | { "kind": "text" });

/** What is done to a machine. */
export type EquipmentChange = { "give": Supply } | { "set": CellText } | { "add": RowOf } | { "copy": RowOf } | { "remove": RowOf } | { "use": RowOf } | { "earlier": RowOf } | { "later": RowOf } | "measured" | { "define": string };

/** A row of a table. */
export type EquipmentRow = {
  /** Which one it is in its table. */
  id: string,
  /** What it is called. */
  title: Message,
  /** Whether it is in use at the start; absent: none of its table ever is. */
  active?: boolean,
  /** Whether it can be taken away. */
  removable: boolean,
  /** Its fields. */
  cells: Array<EquipmentCell>,
};

/** A table with its rows. */
export type EquipmentRows = {
  /** Which table. */
  table: EquipmentTable,
  /** Its rows. */
  rows: Array<EquipmentRow>,
  /** Sorts of rows that can be added: keys of their names, empty where there is one sort only; none: no row can. */
  adds: Array<string>,
};

/** A table of the machine. */
export type EquipmentTable = "machine" | "tools" | "offsets" | "probe" | "toolprobes" | "part";

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

/** What must come of a run. What is absent is not compared. */
export type Expected = {
  /** What stops it: the number of an alarm, a message of NCT, the key of a fault; absent: it reaches its end. */
  stop?: Datum,
  /** Alarms and operator messages in their order. */
  alarms?: Array<Datum>,
  /** What the measuring calls leave in their result data, in the order of their lines. */
  calls?: Array<ExpectedCall>,
  /** All that is corrected or calibrated, with the value afterwards: nothing else may change. */
  changes?: { [key in string]: number },
  /** User data afterwards. */
  data?: { [key in string]: number },
  /** Results that a cycle writes, with their last value. */
  written?: { [key in string]: number },
  /** Tool and frame data afterwards. */
  variables?: { [key in string]: number },
  /** Zero points of settable frames afterwards, by name. */
  origins?: { [key in string]: [number, number, number] },
  /** Where each measuring motion starts, machine coordinates. */
  starts?: Array<[number, number, number]>,
  /** Where the probe switches, machine coordinates. */
  touches?: Array<[number, number, number]>,
  /** Where the machine stands at the end of each call, machine coordinates. */
  ends?: Array<[number, number, number]>,
  /** Feed of all measuring motions, mm/min. */
  feed?: number,
  /** To where the spindle is turned, degree. */
  orientations?: Array<number>,
  /** Lines of the print-out, and blocks that are sent. */
  log?: Array<string>,
  /** Files that it leaves on the control, by name: the log of measurements. */
  files?: { [key in string]: Array<string> },
  /** By how much a number may differ; absent: 0.000001. */
  tolerance?: number,
};

/** What a measuring call leaves. */
export type ExpectedCall = {
  /** Line of the call, from 1. */
  line: number,
  /** What is called. */
  cycle: string,
  /** Its results. */
  results: { [key in string]: number },
};

/** Something that is explained: where the manuals take it for granted, or a connection of a probe. */
export type ExplainedInfo = {
  /** What it is. */
  kind: ExplainedKind,
  /** Plug, pin or address of a connection; else empty. */
  code: string,
  /** Key of its name: `concept-…`, `term-…`, `connection-…`. */
  key: string,
};

/** What is explained. */
export type ExplainedKind = "concept" | "term" | "connection";

/** A file that the control exported. */
export type ExportedFile = {
  /** Its name. */
  name: string,
  /** Its text. */
  text: string,
};

/** A field of a form. Numbers of `fallback` and `range` are in its unit. */
export type Field = {
  /** Parameter, as the manual writes it: `_SETVAL`. */
  name: Name,
  /** Name of the field in words. */
  label: Message,
  /** What it means. */
  help: Message,
  /** Section of the form in which it is asked for. */
  topic: Topic,
  /** As typed; empty: nothing is. */
  value: string,
  /** The expression of the program of which the value is the worth. */
  expression?: string,
  /** As a program has the value, where it was typed with a decimal comma. */
  written?: string,
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
  /** Which argument of the list of a newer control it is, where the call is written so. */
  argument?: Message,
  /** Place in the manual. */
  source: Cited,
  /** The concept that explains what it is about. */
  concept?: string,
} & ({ "kind": "real",
  /** What the control takes. */
  range: Range,
} | { "kind": "integer",
  /** What the control takes. */
  range: Range,
} | { "kind": "choice",
  /** What can be chosen. */
  choices: Array<Choice>,
} | { "kind": "digits",
  /** Digits that mean something of their own. */
  digits: Array<DigitGroup>,
} | { "kind": "text",
  /** Where it lists columns: these. */
  columns?: Columns,
});

/** A quantity that was measured. */
export type Figure = {
  /** The result that has its actual value: `_OVR[4]`. */
  name: string,
  /** Meaning of the result. */
  label: Message,
  /** Sort of the quantity in a word or two. */
  heading: Message,
  /** What stands before its value: `Ø`, `X`, `L1`; empty: nothing. */
  symbol: string,
  /** As measured, in its unit. */
  actual: number,
  /** As it should be. */
  set?: number,
  /** Actual minus set; of a calibration, new minus stored. */
  deviation?: number,
  /** Unit at the call. */
  unit: string,
  /** Its tolerance; absent: it has none. */
  limits?: Limited,
};

/** Where a file beside the program begins: places and lines of an answer go on there. */
export type FileStart = {
  /** Name of the file. */
  name: string,
  /** Its first character, UTF-16 units. */
  from: number,
  /** Its first line, from 1. */
  line: number,
};

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
  /** G function of units active at the call, where it is not that of the machine. */
  units?: UnitFunction,
  /** Working plane at the call, where it is not that of the machine. */
  plane?: Plane,
  /** How X is given at the call; absent: as diameters in a turning cycle. */
  transverse?: Transverse,
  /** What is wrong with part and probe; absent: nothing. */
  errors?: ErrorSliders,
  /** Words by parameter for a comment line each in the snippet. */
  comments?: { [key in string]: string },
  /** Call style of the call of a program that the form shows: a list of newer controls has rules of its own. */
  written?: Style,
  /** Call style of the snippet; absent: as the machine's forms have it, else direct. */
  style?: Style,
  /** The measuring calls of the program, where the form is about a log: what it prints is named as these name it. */
  measured?: Array<LoggedCall>,
  /** Whether to simulate. */
  predict?: boolean,
  /** Whether to look for the largest errors of the part that the call survives: takes a hundred runs. */
  limits?: boolean,
  /** Whether to look for the same task on other controls. */
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
  /** Where the values are written in it: first UTF-16 unit, and one past the end. */
  snippetPlaces: { [key in Name]: [number, number] },
  /** What this call style cannot say. */
  snippetFindings: Array<Diagnostic>,
  /** Call style that counts until another is chosen: the machine may say so. */
  preset: Style,
  /** Whether there is no error. */
  complete: boolean,
  /** The variant that the values choose. */
  mvar: number | null,
  /** The limits of the tolerances as a picture, where there are any. */
  chain?: Chain,
  /** What the call is called, where a list of newer controls says less than the name of the variant. */
  title?: Message,
  /** What the values mean, drawn. */
  picture?: Picture,
  /** When asked for: the same task on other controls; empty where none has it. */
  twins?: Array<TwinView>,
  /** When simulating was asked for and there is no outcome: parameters whose values only a run tells. */
  unknown?: Array<Name>,
  /** When simulating was asked for, of a complete form of a cycle that is simulated. */
  outcome?: Outcome,
  /** When simulating was asked for: the machine, for an outcome with the proposed part, its errors and the start. */
  setup?: Setup,
  /** Whether the calibration data in that setup agree with its probe, for the probe that the call names. */
  calibrated?: boolean,
};

/** Where Probewright finds what raises an alarm. */
export type Found = "check" | "run" | "both" | "nowhere";

/** A frame: position and rotation of a coordinate system in the one before it. */
export type Frame = {
  /** Coarse translation X Y Z, mm. */
  coarse: [number, number, number],
  /** Fine translation X Y Z, mm. */
  fine: [number, number, number],
  /** Rotation about X Y Z (RPY), degree. */
  rotation: [number, number, number],
  /** Coarse translation of the rotary axes A B C, degree. */
  rotary: [number, number, number],
  /** Fine translation of the rotary axes A B C, degree. */
  rotaryFine: [number, number, number],
  /** Scale factors along its own X Y Z; 1: none. Measuring does not work with any other (61310). */
  scale: [number, number, number],
  /** Whether the direction of X Y Z is reversed; counts before scale and rotation. */
  mirror: [boolean, boolean, boolean],
};

/** A scale with limits and needles; all figures in one unit. */
export type Gauge = {
  /** Unit of all figures. */
  unit: string,
  /** Left end. */
  low: number,
  /** Right end. */
  high: number,
  /** From end to end, in order. */
  bands: Array<Band>,
  /** Limits that lie on the scale. */
  marks: Array<Mark>,
  /** What was measured; beyond an end it is drawn there. */
  needles: Array<Needle>,
};

/** A guide with its page. */
export type GuideView = {
  /** By which a link names it. */
  id: string,
  /** Group in which it stands. */
  group: Message,
  /** Title of the page. */
  title: Message,
  /** What it says. */
  lines: Array<Message>,
  /** Command of the page that leads there. */
  way: string,
  /** Lines for the terminal that do the same. */
  terminal: Array<string>,
  /** Place in the manual; empty: they do not tell of it. */
  source: Cited,
};

/** Heights in rows along X, the first row at the least Y. The middle of the grid is the origin. */
export type Heights = {
  /** Heights a row. */
  columns: number,
  /** Distance of neighbours along X and Y, mm. */
  step: [number, number],
  /** All heights Z, row by row, mm. */
  values: Array<number>,
};

/** Which page. */
export type HelpRequest = {
  /** Control. */
  control: Dialect,
  /** Cycle. */
  cycle: string,
  /** Number of the variant. */
  mvar: number,
  /** Call style of the call that the page is about; absent: that of the cycle. */
  style?: Style,
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
  /** Heading of the section. */
  label: Message,
  /** What it says. */
  lines: Array<HelpText>,
};

/** A line of a help page. */
export type HelpText = {
  /** What it says. */
  message: Message,
  /** Place in the manual. */
  source: Cited,
};

/** The help page of a variant. */
export type HelpView = {
  /** What of the page does not count for a call in the list of a newer control. */
  note?: Message,
  /** Sections of the page, in order; none is empty. */
  sections: Array<HelpSection>,
  /** Parameters that every call of the variant gives. */
  required: Array<Name>,
  /** Results that a call can leave. */
  results: Array<HelpResult>,
  /** Alarms that can come. */
  alarms: Array<AlarmInfo>,
  /** Where it is on the control, or why it is not. */
  places: Array<HelpText>,
};

/**
 * What NC start would do from where the probe is, with Calculate where it stores the last point; what Calculate would
 * do where all are stored.
 */
export type JogAhead = {
  /** Whether NC start is the next key; else Calculate. */
  start: boolean,
  /** The point that would be stored, `P2`. */
  point?: string,
  /** Whether it would wait for the user to store it. */
  waits: boolean,
  /** Positions at which the probe would switch, in the WCS of the measurement, mm. */
  touches: Array<[number, number, number]>,
  /** The alarm that would come, or what would be hit. */
  raised?: Raised,
  /** Why nothing comes of the points. */
  refused?: Message,
  /** What the user should know of the touches. */
  notes: Array<Message>,
  /** Results that would be shown. */
  results: Array<JogResult>,
  /** What would be written. */
  changes: Array<Change>,
  /** Whether the activation screen would come up. */
  activates: boolean,
  /** What is known although nobody is to know yet how the part lies: there are no touches, results and changes then. */
  hidden?: JogHidden,
};

/** What the call alone tells of a result. */
export type JogHidden = {
  /** What would be shown. */
  shows: Array<Message>,
  /** The zero offset that would be corrected. */
  corrects?: string,
};

/** A point that was stored. */
export type JogPoint = {
  /** `P1`. */
  name: string,
  /** Position at switching in the WCS of the measurement, mm, where it is a touch. */
  touch?: [number, number, number],
  /** Centre in abscissa and ordinate, mm, where it is an element. */
  centre?: [number, number],
};

/** A result. */
export type JogResult = {
  /** `meas_x0`. */
  name: string,
  /** As the mask shows it. */
  label: Message,
  /** Value, mm or degree. */
  value: number,
  /** `mm` or `deg`. */
  unit: string,
};

/** What is on the screen. */
export type JogState = "menu" | "mask" | "ready" | "busy" | "activate" | "moving" | "alarm";

/** A value. */
export type JogValue = number | string;

/** What a label tells. */
export type LabelKind = "frame" | "diameter" | "nominal" | "touched" | "touch" | "collision" | "size" | "anchor";

/** The tolerance of a quantity, as the drawing gives it. A safe area or a dimension difference is none. */
export type Limited = {
  /** Smallest deviation within the tolerance. */
  low: number,
  /** Largest one. */
  high: number,
  /**
   * Share of the limit on its side that the deviation takes, empirical value included: 1 on the limit; absent: there
   * is no room on that side.
   */
  used?: number,
};

/** A part of the lines. */
export type LineGroup = {
  /** What it is. */
  kind: LineKind,
  /** Part of the lines that belongs to the group, from and to (excluded), in lines. */
  lines: [number, number],
  /** Where it stands, by index in the places of a standing; none: machine coordinates. */
  place?: number,
  /** In which of the standings it is there; none: in all. */
  standing?: number,
  /** Parameter that it explains; of a size and another dimension of a call. */
  field?: Name,
};

/** What a group of lines is. */
export type LineKind = "grid" | "edge" | "zone" | "limit" | "nominal" | "axisX" | "axisY" | "axisZ" | "beforeX" | "beforeY" | "beforeZ" | "dimension" | "size" | "anchor";

/** A measuring call. */
export type LoggedCall = {
  /** Its cycle. */
  cycle: string,
  /** Number of its variant. */
  variant: number,
};

/** The machine of a question. */
export type Machine = OwnMachine | Setup;

/** What the export says of the slowest axis. */
export type MachineAxis = {
  /** From the signal to the braking command, s. */
  delay: number,
  /** Lowest deceleration, m/s². */
  acceleration: number,
  /** Lowest servo gain, (m/min)/mm. */
  gain: number,
};

/** What the control exported. */
export type MachineCheckRequest = {
  /** Its files, or what somebody typed, in their order. */
  files: Array<ExportedFile>,
  /** What this machine does not do. */
  without: Array<Use>,
  /** Whether the control is an NCU 3, for which the manual prints larger memories (B:12955, A:14218). */
  large: boolean,
  /** Deflection that the probe allows, mm: feeds with a longer braking path are told. */
  deflection?: number,
};

/** What is wrong with a machine. */
export type MachineCheckView = {
  /** What is wrong, the worst first, then in the order of the manual. */
  faults: Array<MachineFault>,
  /** How many data were compared and what came of it, in words. */
  ending: Message,
  /** Data that a check held against something. */
  read: number,
  /** Machine data that measuring needs and that no file gives, as their control calls them. */
  missing: Array<string>,
  /** The lines to change, as a control reads them; empty: none. */
  changes: string,
  /** The slowest axis, where the files say what its braking path follows from. */
  axis?: MachineAxis,
};

/** Something that is wrong with a machine. */
export type MachineFault = {
  /** How bad it is. */
  severity: Severity,
  /** The datum: `MD18120`, `_CBIT[3]`. */
  name: string,
  /** Its identifier, where it is a machine datum and the manual prints it. */
  identifier: string,
  /** The channel that it is of. */
  channel?: number,
  /** Its value, as a control writes it; empty: it has none. */
  value: string,
  /** What is wrong. */
  message: Message,
  /** What follows from it. */
  effect?: Message,
  /** The alarm that follows: number and, in words, meaning. */
  alarm?: Message,
  /** What it has to be, by each place that says so. */
  limits: Array<MachineLimit>,
  /** As delivered, with system software up to 59 and from 63 on; the same once. */
  delivered: Array<string>,
  /** Where it stands. */
  place?: MachinePlace,
  /** Place in the manual. */
  source: Cited,
  /** The line that mends it, as a control reads it; empty: none does. */
  change: string,
};

/** A datum of the machine. */
export type MachineField = {
  /** Which field of data it belongs to. */
  set?: Message,
  /** As typed; empty: as delivered. */
  value: string,
  /** As delivered; empty: not known. */
  fallback: string,
  /** What is to be said of its value as it counts; absent: nothing. */
  warned?: Diagnostic,
  /** As a program writes it: `_WP[0,1]`, `MD18600`. */
  name: string,
  /** What else it is looked for as: the identifier of a setting datum, the user datum of older controls. */
  also?: string,
  /** Key of its name; `.help`, and `.v0`, `.v1`, … of a choice, may stand behind it. */
  key: string,
  /** Unit as it counts on this machine. */
  unit: string,
  /** What is allowed, in that unit. */
  range: Range,
  /** Place in the manual. */
  source: Cited,
  /** Whether nothing in the simulation reads it. */
  idle: boolean,
  /** Versions of the measuring cycles in which it is there, where that is told. */
  versions?: Versions,
} & ({ "kind": "real" } | { "kind": "integer" } | { "kind": "choice",
  /** The numbers. */
  choices: Array<number>,
} | { "kind": "text" });

/** Data of one subject. */
export type MachineGroup = {
  /** The subject. */
  label: Message,
  /** Data of the group. */
  fields: Array<MachineField>,
};

/** A value that a datum has to be or to reach. */
export type MachineLimit = {
  /** How bad it is to miss it. */
  severity: Severity,
  /** The value, as a control writes it. */
  value: string,
  /** Place in the manual. */
  source: Cited,
};

/** A line of a file. */
export type MachinePlace = {
  /** Name of the file. */
  file: string,
  /** Line, from 1. */
  line: number,
};

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

/** A value that was assumed. */
export type MachineValue = {
  /** As the program names it: `$A_IN[1]`. */
  name: string,
  /** What it was taken for. */
  value: Datum,
  /** Line that asked for it first, from 1. */
  line: number,
};

/** What is set once per machine. */
export type MachineView = {
  /** Machine data by subject. */
  groups: Array<MachineGroup>,
  /** Basic system of the machine now. */
  basic: BasicSystem,
  /** What differs from delivery now, for the setup. */
  data: { [key in string]: Datum },
  /** Values that were not taken. */
  problems: Array<MachineProblem>,
  /** What differs, as blocks of a part program. */
  assignments: string,
};

/** A limit. */
export type Mark = {
  /** Parameter that gives it. */
  name: string,
  /** Where it is. */
  value: number,
};

/** What a piece of the triangles is. */
export type Matter = "part" | "cut" | "chuck" | "ball" | "stem" | "ring" | "stylus" | "body" | "carrier" | "zone";

/** A point X Y Z in machine (basic) coordinates, mm. */
export type Mcs = [number, number, number];

/** A result of a call. */
export type Measured = {
  /** `_OVR[4]`. */
  name: string,
  /** Meaning of the result. */
  label: Message,
  /** Value of the result. */
  value: number,
  /** Unit on this machine. */
  unit: string,
  /** There where this call did not write it. */
  earlier: 0,
};

/** A machine datum for the memory of user data. */
export type MemoryNeed = {
  /** Its number, `MD18150`. */
  number: string,
  /** The least value for the measuring cycles alone. */
  value: number,
  /** Place in the manual. */
  source: Cited,
};

/** Memory of an array. */
export type MemoryShare = {
  /** Name and sizes, `_TP[2,10]`. */
  name: string,
  /** Whether each channel needs it. */
  channel: boolean,
  /** Bytes of its values. */
  bytes: number,
  /** Bytes as delivered. */
  delivered: number,
};

/** A text to be shown: key of the message files, with its arguments. */
export type Message = {
  /** Key in the message files, for example `check-out-of-range`; stems of the catalogue make others (`alarm-61307`). */
  key: string,
  /** Named arguments, in no particular order. */
  args: { [key in string]: Arg },
};

/** What a run of a series starts from. */
export type Mode = "independent" | "production";

/** Kind of a motion. */
export type MotionKind = "rapid" | "positioning" | "measuring" | "retract";

/** Name of a parameter as the manual writes it (`_SETV[0]`, `D`): one constant for an entry and what reads it. */
export type Name = string;

/** A deviation. */
export type Needle = {
  /** Axis or quantity; empty: the only one. */
  label: string,
  /** Deviation that the limits watch, empirical value included. */
  value: number,
  /** Where it lies. */
  kind: BandKind,
};

/** A tool that is not there. */
export type NewTool = {
  /** T number; 0: the next free one, of an NCT control the registers. */
  tool: number,
  /** Name under tool management. */
  name: string,
  /** D number (NCT: H). */
  edge: number,
  /** `$TC_DP1`. */
  kind: number,
};

/** The nose of a turning tool. It lies in the plane. */
export type Nose = {
  /** Radius, mm. */
  radius: number,
  /** From the centre S to the point P in abscissa and ordinate, in nose radii: -1, 0 or 1. */
  side: [number, number],
};

/** A run of which a scenario is made. */
export type NoteRequest = {
  /** What is run. */
  run: RunRequest,
  /** Name of the file with the program. */
  name: string,
  /** What the case is called. */
  case: string,
};

/** The call of a program to which something belongs; absent: none. */
export type OfCall = {
  /** Line of the call, from 1. */
  line?: number,
  /** Cycle that is called. */
  cycle?: string,
};

/** Something that fixes a finding by giving it to the machine. */
export type Offer = {
  /** What it does. */
  label: Message,
  /** What is given. */
  supply: Supply,
};

/** A call of a cycle that has no form. */
export type OtherCall = {
  /** Cycle as it is called. */
  cycle: string,
  /** What it does. */
  title: Message,
  /** Line of the call, from 1. */
  line: number,
  /** Where it begins in the text, UTF-16 units. */
  from: number,
  /** What stands at its arguments, by their names in the published list. */
  values?: { [key in string]: string },
};

/** What a call does. */
export type Outcome = {
  /** What it came to; absent where nothing is measured. */
  answer?: Answer,
  /** What it wrote, and what it would have written but left as it was. */
  results: Array<Measured>,
  /** Decisions of the tolerance chain in order, the branch taken last. */
  decisions: Array<Message>,
  /** Alarms raised, the one that stopped it last. */
  alarms: Array<Raised>,
  /** Tool wear, zero offsets, memories, … */
  changes: Array<Change>,
  /** Lines of the print-out, and blocks that were sent. */
  log: Array<string>,
  /** Files that it leaves on the control: the log of measurements. */
  written?: Array<WrittenFile>,
  /** Everything that happened. */
  trace: Source,
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
  source: Cited,
};

/** A value of it. */
export type Part = {
  /** Axis, length or radius: `X`, `L1`, `R`. */
  name: string,
  /** After minus before, in its unit. */
  by: number,
  /** Unit of the basic system of the machine, or degree. */
  unit: string,
};

/** What is wrong with a part. All zero: nothing. A sphere has neither taper nor lobes. */
export type PartErrors = {
  /** Displacement X Y Z, mm, machine axes. */
  shift: [number, number, number],
  /** Added to every diameter, width and length, mm. */
  size: number,
  /** Turned about the machine's X Y Z (RPY) about the shape's origin, degree. */
  tilt: [number, number, number],
  /** Diameter (width, length) grows by this per mm of depth (cone), mm/mm. */
  taper: number,
  /** Amplitude of the radius over the angle, mm, and number of lobes: `r + amplitude·cos(lobes·angle)`. */
  outOfRound: [number, number],
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
  /** As it is in the program. */
  word: string,
  /** Line of the word, from 1. */
  line: number,
};

/** How often something is drawn. */
export type Per = "part" | "series";

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
  circle?: { x: number, y: number, r: number },
  /** A round opening in it: centre and radius, mm. */
  opening?: { x: number, y: number, r: number },
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

/** A place of a line. */
export type PointedRequest = {
  /** Control. */
  control: Dialect,
  /** The line. */
  line: string,
  /** The place, UTF-16 units. */
  at: number,
};

/** What is told of it. */
export type PointedView = {
  /** First unit of what it is about. */
  from: number,
  /** One past its end. */
  to: number,
  /** Its name; empty: none is published. */
  name: string,
  /** What it means. */
  meaning: Message,
  /** More about that, where there are words for it. */
  help: Message,
  /** What else is known, a line each. */
  about: Array<Message>,
};

/** The activation screen. */
export type PracticeActivation = {
  /** Its lines. */
  lines: Array<Message>,
  /** Its fields. */
  fields: Array<PracticeField>,
};

/** How the probe gets in front of a face. */
export type PracticeApproach = {
  /** The line of a script that moves it there; absent, where nothing is refused: it is there. */
  line?: string,
  /** Why it cannot get there. */
  refused?: Message,
};

/** A softkey of the vertical bar. */
export type PracticeArea = {
  /** What it says. */
  label: Message,
  /** The masks that it offers. */
  masks: Array<PracticeChoice>,
};

/** A call as its mask. */
export type PracticeCall = {
  /** The mask. */
  mask: PracticeChoice,
  /** What opens it and fills it in, a line a thing. */
  lines: Array<string>,
  /** What of the call has no place in it. */
  told: Array<Message>,
};

/** A call that is to be practised. */
export type PracticeCallRequest = {
  /** Control. */
  control: Dialect,
  /** Cycle. */
  cycle: string,
  /** Values as typed, by parameter. */
  values: { [key in string]: string },
  /** Machine; absent: the core's own as it is. */
  setup?: Machine,
  /** G function of units active at the call, where it is not that of the machine. */
  units?: UnitFunction,
  /** Working plane at the call, where it is not that of the machine. */
  plane?: Plane,
};

/** A mask that can be opened. */
export type PracticeChoice = {
  /** Name in a script. */
  name: string,
  /** Title. */
  label: Message,
  /** The piece on which it can be practised. */
  piece: PracticePiece,
};

/** How far a zero offset is from where it should be. */
export type PracticeDeviation = {
  /** Its name. */
  offset: string,
  /** Along the axes, mm, then about them, degree. */
  figures: Array<PracticeFigure>,
};

/** A face of the part in front of which the probe is put. */
export type PracticeFace = {
  /** The session so far. */
  practice: PracticeRequest,
  /** A point of the face, X Y Z of the machine, mm. */
  at: [number, number, number],
  /** Direction out of the part there, X Y Z of the machine. */
  normal: [number, number, number],
};

/** A field of a mask or of the activation screen. */
export type PracticeField = {
  /** Name in a script. */
  name: string,
  /** What it is called. */
  label: Message,
  /** `mm` or `deg` of a number, else empty. */
  unit: string,
  /** What it holds. */
  value: JogValue,
  /** What can be chosen; none: it takes a number. */
  choices: Array<PracticeWord>,
  /** What is wrong with it. */
  wrong?: Message,
};

/** A number. */
export type PracticeFigure = {
  /** Letter of its axis, or empty. */
  axis: string,
  /** mm or degree. */
  value: number,
  /** `mm` or `deg`. */
  unit: string,
};

/** Which keys do something. */
export type PracticeKeys = {
  /** NC start. */
  start: boolean,
  /** RESET. */
  reset: boolean,
  /** Calculate. */
  calculate: boolean,
  /** `<<`. */
  back: boolean,
  /** Another mode. */
  mode: boolean,
};

/** The machine. */
export type PracticeMachine = {
  /** Position X Y Z in the WCS of the measurement, mm. */
  wcs: [number, number, number],
  /** Position X Y Z of the machine, mm. */
  mcs: [number, number, number],
  /** The zero offset that is active. */
  active: string,
  /** Letters of the axes of the plane in which is measured. */
  axes: [string, string],
  /** Versions of the measuring cycles by which the masks are: from SW 6.3, up to SW 6.2. */
  versions: Array<PracticeUse>,
  /** Planes in which can be measured. */
  planes: Array<PracticeUse>,
  /** Zero offsets that can be in use while measuring. */
  offsets: Array<PracticeUse>,
  /** Whether one is offered because it was activated: no other can be chosen until the area is left. */
  offered: boolean,
  /** What can be in the spindle. */
  tools: Array<PracticeUse>,
  /** Whether it is a probe. */
  probe: boolean,
};

/** A mask with its values. */
export type PracticeMask = {
  /** Name in a script. */
  name: string,
  /** Title. */
  label: Message,
  /** Fields that are shown, in their order. */
  fields: Array<PracticeField>,
  /** Whether the user stores each point after its touch; then none is rejected, by the PLC neither. */
  stores: boolean,
  /** Lines of the left part, in their order. */
  shows: Array<PracticeShow>,
  /** What to do: sections of its help, in order. */
  help: Array<HelpSection>,
};

/** How a part lies, mm and degree. */
export type PracticePart = {
  /** Displacement along X of the machine. */
  dx: number,
  /** Along Y. */
  dy: number,
  /** Along Z. */
  dz: number,
  /** Added to every diameter, width and length. */
  size: number,
  /** Turned about the applicate. */
  tilt: number,
  /** About the abscissa. */
  leanAbscissa: number,
  /** About the ordinate. */
  leanOrdinate: number,
};

/** What lies on the table. */
export type PracticePiece = "block" | "pocket" | "hole" | "holes" | "island" | "spigot" | "spigots" | "probe";

/** A softkey P1 to P4. */
export type PracticePoint = {
  /** `P1`. */
  name: string,
  /** What is stored; absent: the softkey is grey. */
  stored?: JogPoint,
  /** Whether it was touched and waits to be stored. */
  waits: boolean,
  /** The line of a script that presses it. */
  line: string,
};

/** What the mask that is open means as a program. */
export type PracticeProgram = {
  /** Text: plane and zero offset, where the probe stands, the call; empty: there is none. */
  text: string,
  /** Cycle that is called. */
  cycle?: string,
  /** Its values, as typed. */
  values: { [key in string]: string },
  /** What is different; why there is none. */
  told: Array<Message>,
  /** The line with which the session ended before its end. */
  refused?: PracticeRefusal,
};

/** A line that was not carried out. */
export type PracticeRefusal = {
  /** Its number, from 1. */
  line: number,
  /** Why. */
  message: Message,
  /** What helps. */
  hint?: Message,
  /** Lines behind it, which were not carried out either. */
  left: number,
};

/** A session of measuring in JOG. */
export type PracticeRequest = {
  /** Control. */
  control: Dialect,
  /** Machine with its part; absent, and where it has no part or turns: one to practise on. */
  setup?: Machine,
  /** What lies on the table of the machine to practise on; absent: a block. */
  piece?: PracticePiece,
  /** What was done, a line a thing. */
  script: string,
  /** The part lies as chance puts it by this seed; absent: as `part` says. */
  seed?: number,
  /** How the part lies; absent: as in the setup. */
  part?: PracticePart,
  /** Nobody is to know yet how the part lies: what the next key would do is told as far as the call says it. */
  hides: boolean,
};

/** A line of the left part. */
export type PracticeShow = {
  /** What it is called. */
  label: Message,
  /** Name of a zero offset, where the line has one. */
  offset?: string,
  /** Numbers, each with the letter of its axis; of a result without one. */
  figures: Array<PracticeFigure>,
};

/** Something that can be in use. */
export type PracticeUse = {
  /** Its name: `G54`; empty: an empty spindle. */
  name: string,
  /** The line of a script that brings it into use. */
  line: string,
  /** Whether it is. */
  used: boolean,
};

/** What is on the screen and under the hand. */
export type PracticeView = {
  /** The functions as the softkeys have them. */
  areas: Array<PracticeArea>,
  /** What is on the screen. */
  state: JogState,
  /** The line at which it ended, as it did nothing. */
  refused?: PracticeRefusal,
  /** The alarm that is pending, or what was hit. */
  raised?: Raised,
  /** What the user should know of the last touch. */
  notes: Array<Message>,
  /** The mask that is open. */
  mask?: PracticeMask,
  /** The activation screen. */
  activation?: PracticeActivation,
  /** Keys that do something now. */
  keys: PracticeKeys,
  /** P1 to P4, where the mask has softkeys for them. */
  points: Array<PracticePoint>,
  /** Bits 0 to 7 of the PLC. */
  plc: Array<boolean>,
  /** The machine. */
  machine: PracticeMachine,
  /** The piece of the machine to practise on; absent: the machine is the user's. */
  piece?: PracticePiece,
  /** What the next key would do. */
  ahead?: JogAhead,
  /** How the part lies. */
  truth: Truth,
  /** How far the zero offset that the mask wrote is from where it should be. */
  deviation?: PracticeDeviation,
  /** What the mask wrote last. */
  changes: Array<Change>,
  /** The first entry of the trace that belongs to the last line. */
  from: number,
};

/** A choice. */
export type PracticeWord = {
  /** As a script has it. */
  word: string,
  /** What it is called; absent: as it is. */
  label?: Message,
};

/** The probe as it is, not as the control believes. */
export type Probe = {
  /** Real ball radius, mm. */
  radius: number,
  /** Real length from the spindle nose to the ball centre, mm. */
  length: number,
  /**
   * Ball centre minus spindle axis at spindle position 0, X Y, mm. In a turret: ball centre minus the point where L1
   * and L2 end, abscissa and ordinate; the length does not count there.
   */
  skew: [number, number],
  /** Travel after contact until the signal, mm: constant part and amplitude of the three-lobed part. */
  preTravel: [number, number],
  /** Delay of the signal, s; multiplies the feed. */
  delay: number,
  /** Standard deviation of the switching point along the travel, mm, and seed of the pseudo-random sequence. */
  repeatability: [number, number],
  /** Way with the signal watched after which it comes once without contact, mm; none: never. */
  falseSignal?: number,
  /**
   * Radius of the straight stylus between ball and body, mm; none: 0.45 of that of the ball; 0: not looked at, for a
   * stylus of another shape. In a turret it is looked at where `body` tells how long it is.
   */
  stylus?: number,
  /** The body that holds the stylus; none: the stylus goes as far as the spindle. */
  body?: ProbeBody,
};

/** The body of a probe: a cylinder as far as the spindle. */
export type ProbeBody = {
  /** Radius, mm. */
  radius: number,
  /** From the centre of the ball to its lower face, mm: how long the stylus is. */
  distance: number,
};

/** The probe of a call. */
export type ProbeOfCall = {
  /** Number of its data field, from 1. */
  number: number,
  /** Whether it is a tool probe. */
  tool: boolean,
  /** Both in words. */
  name: Message,
  /** Whence its calibration. */
  state: CalibrationState,
  /** The same in words. */
  calibration: Message,
  /** Line of the call that calibrated it in this run, from 1. */
  line?: number,
};

/** What is wrong with a probe, mm. */
export type ProbeSliders = {
  /** Centre of the ball off the axis, along the abscissa; of a tool its length L1. */
  skewX: number,
  /** Centre of the ball off the axis, along the ordinate; of a tool its length L2. */
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

/** A parameter of the `PROC` of a program that is run as main program. */
export type ProgramParameter = {
  /** Its name, in upper case. */
  name: string,
  /** Its type, as the control calls it. */
  kind: string,
  /** Whether it has a default. */
  optional: boolean,
};

/** A program of a text that holds several. */
export type ProgramPlace = {
  /** As a call writes it. */
  name: string,
  /** Its first block, UTF-16 units. */
  from: number,
  /** Line of that block, from 1. */
  line: number,
  /** Parameters of its `PROC`. */
  parameters?: Array<ProgramParameter>,
};

/** Text of a program in UTF-8. Who asks several questions about a long one holds it, so that none brings it anew. */
export type ProgramText = string;

/** What a measurement proves by ISO 14253-1: who proves bears the uncertainty. */
export type Proof = "good" | "undecided" | "bad";

/** Columns of a table, each by its heading or its number from 1. */
export type ProtocolColumns = {
  /** Number of the call, from 1. */
  number?: string,
  /** Line of the call in the program. */
  line?: string,
  /** Name of the result: `_OVR[4]`. */
  result?: string,
  /** Setpoint. */
  nominal?: string,
  /** Actual value. */
  actual?: string,
  /** Actual value minus setpoint. */
  deviation?: string,
};

/** A line of a protocol that is told. */
export type ProtocolLine = {
  /** Index of the file. */
  file: number,
  /** Number of the line in it, from 1. */
  line: number,
  /** What stands in it, shortened. */
  text: string,
  /** Why it fits no call, or what is in doubt, and what helps. */
  why: Message,
};

/** A protocol, and the program that it is about. */
export type ProtocolRequest = {
  /** The program and the machine. */
  run: RunRequest,
  /** The files of the protocol in their order: a log goes on in files that follow. */
  protocol: Array<string>,
  /** Their names, by which a file that is missing is noticed; absent: nobody knows. */
  names?: Array<string>,
  /** What stands in which column; absent: the figures of a line tell it. */
  columns?: ProtocolColumns,
};

/** A protocol laid onto the calls of a program. */
export type ProtocolView = {
  /** What each call came to on the machine. */
  answers: Array<RunAnswer>,
  /** Where the values come from. */
  about: RecordAbout,
  /** How many lines fit, and how many calls have no value, in words. */
  ending: Message,
  /** Lines of the protocol whose values stand in the answers. */
  fitted: number,
  /** Calls of which the protocol has no value. */
  missing: number,
  /** Lines that fit no call, in their order. */
  unfit: Array<ProtocolLine>,
  /** Lines that were laid though something in them contradicts it, in their order. */
  doubtful: Array<ProtocolLine>,
  /** A file of the log that is missing; absent: none is. */
  gap?: Message,
  /** How the faces that were touched lie, in their order. */
  arrows: Array<Arrow>,
  /**
   * Fields of the line with the headings, else of the first line of the protocol: names of its columns, where it is
   * a table.
   */
  heads: Array<string>,
  /** What stands in which column, each by its number, where nobody chose it and the headings tell it. */
  recognised: ProtocolColumns,
};

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
  /** Name of the alarm; empty: none of the control. */
  code: string,
  /** What it says. */
  message: Message,
  /** What helps. */
  hint?: Message,
  /** Whether it stops the program. */
  stops: boolean,
  /** What the machine lacks, each a fix. */
  offers?: Array<Offer>,
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

/** A machine with the values of files. */
export type ReadBack = {
  /** The machine now; values that it cannot have are its problems. */
  machine: MachineView,
  /** Data of the machine that the files give. */
  read: number,
  /** How many of them are another value than before. */
  changed: number,
  /** Lines of definition files that the machine keeps: what it had, and the sizes of arrays that the files give. */
  definitions: Array<string>,
  /** Arrays whose size no datum counts and that is another one than is delivered; absent: none. */
  sizes?: Message,
  /** Lines of which a value or a size cannot be read: the machine keeps what it has there. */
  unread: Array<MachineFault>,
  /** In words. */
  ending: Message,
};

/** Files of a control whose values a machine is to have. */
export type ReadBackRequest = {
  /** Machine; absent: the core's own as it is. */
  setup?: Machine,
  /** Definition files, programs of value assignments, start-up files. */
  files: Array<ExportedFile>,
};

/** Which program is read. */
export type ReadRequest = {
  /** Control. */
  control: Dialect,
  /** Text of the program. */
  text: ProgramText,
  /** Machine on which it starts; absent: the core's own as it is. */
  setup?: Machine,
  /** Files beside it: its subprograms, definition files; absent: none. */
  with?: Array<Beside>,
};

/** A program. */
export type ReadView = {
  /** Measuring calls of the program in order. */
  calls: Array<CallView>,
  /** Calls of cycles that have no form: they are read and explained. */
  others?: Array<OtherCall>,
  /** What is wrong with it. */
  diagnostics: Array<Diagnostic>,
  /** Where the files beside it begin. */
  files?: Array<FileStart>,
  /** Its programs, where the text holds several. */
  programs?: Array<ProgramPlace>,
  /** Parameters of its own `PROC`, which have no caller where it is run. */
  parameters?: Array<ProgramParameter>,
};

/** Where positions count from, machine coordinates. */
export type Reading = {
  /** Zero, mm. */
  at: [number, number, number],
  /** Directions. */
  axes: [[number, number, number], [number, number, number], [number, number, number]],
  /** Whether X counts as a diameter. */
  diameter: boolean,
  /** Whether lengths count in inches. */
  inch: boolean,
};

/** A tool. */
export type RealTool = {
  /** L1, L2 and L3 as they are, mm: to the lowest edge of a cutter in its axis; to the point P of a turning tool. */
  length: [number, number, number],
  /** What cuts. */
  cut: Cut,
};

/** What a file is, by its bytes. */
export type Recognised = {
  /** How it is encoded. */
  encoding: Encoding,
  /** The control that its beginning tells; absent: it tells none. */
  control?: Dialect,
  /** That it is the log of measurements, which is opened beside its program; absent: it is none. */
  log?: Message,
} | {
  /** What it is instead. */
  why: Message,
};

/** Where the values of a record come from. */
export type RecordAbout = {
  /** Control. */
  control: Dialect,
  /** What the user calls the machine; empty: nothing. */
  machine: string,
  /** Date and time of the control when the program began, `2026-05-31T08:00:00`; empty: the setup gives none. */
  clock: string,
  /** Diameter of the ball of the workpiece probe, mm. */
  ball: number,
  /** What such values are worth, and what they are not, a sentence each. */
  worth: Array<Message>,
};

/** A file beside the program. */
export type RecordFile = {
  /** Name of the file. */
  name: string,
  /** Its first line, from 1. */
  line: number,
};

/** Why a typed value is not taken, and what would be. */
export type Refusal = {
  /** What is wrong. */
  message: Message,
  /** The cure. */
  hint: Message,
};

/** What repeated touches come to, in the unit of the view. */
export type RepeatFound = {
  /** The values in their order. */
  values: Array<number>,
  /** Mean. */
  mean: number,
  /** Standard deviation of a sample. */
  deviation: number,
  /** Smallest value. */
  smallest: number,
  /** Largest value. */
  largest: number,
  /** Largest minus smallest. */
  range: number,
  /** Largest distance from the mean. */
  furthest: number,
  /** How many values lie in each interval from the smallest to the largest. */
  intervals: Array<number>,
  /** A straight line through them. */
  trend?: RepeatTrend,
  /** `_TZL` for one touch. */
  zone: number,
  /** `_TZL` for what two touches make. */
  zoneOfTwo: number,
};

/** What is tested. */
export type RepeatRequest = {
  /** Axis that moves: `X`, `Y`, `Z`; absent: X. */
  axis?: string,
  /** Where the motion begins, in the unit that is active; absent: 0. */
  from?: number,
  /**
   * Where it ends without a signal; absent: 50 mm or 2 inch from there, in the function test twice that, in plus
   * direction, or with the ball of the probe ahead.
   */
  to?: number,
  /** Feed a minute in that unit; absent: 150 mm/min or 6 inch/min. */
  feed?: number,
  /** Measuring input, 1 or 2; absent: that of the workpiece probe, `_CHBIT[0]`. */
  input?: number,
  /** Touches; absent: 10. */
  count?: number,
  /** Whether the values are those of the machine system; absent: of the workpiece system. */
  machine?: boolean,
  /** First R parameter that keeps the values; absent: an array of the program does. */
  parameters?: number,
  /** Whether M6 changes the tool; absent: it does not. */
  changes?: boolean,
  /** Values of a real machine, with blanks between them; absent: the program is run. */
  values?: string,
  /** Words by key, for comments and operator texts. */
  words?: { [key in string]: string },
  /** Machine; absent: the core's own as it is. */
  setup?: Machine,
};

/** A straight line through values in their order. */
export type RepeatTrend = {
  /** Change from one touch to the next. */
  slope: number,
  /** Correlation with the order, −1 to 1. */
  correlation: number,
  /** Student's t of it. */
  t: number,
  /** Whether it is one with 95 % confidence. */
  certain: boolean,
};

/** What is taken where nothing else is asked for, in the unit of the view. */
export type RepeatUsual = {
  /** Where the motion begins. */
  from: number,
  /** Where it ends without a signal. */
  to: number,
  /** Feed a minute. */
  feed: number,
  /** Touches. */
  count: number,
};

/** The programs, and what the values come to. */
export type RepeatView = {
  /** One touch: whether the probe switches. */
  function: string,
  /** Repeated touches. */
  program: string,
  /** Keys of the words in them. */
  says: Array<string>,
  /** `mm` or `inch`. */
  unit: string,
  /** What is taken where nothing else is asked for. */
  usual: RepeatUsual,
  /** What the values come to, a line each. */
  told: Array<Message>,
  /** What should be known beside it. */
  notes: Array<Message>,
  /** What the values come to. */
  found: RepeatFound,
};

/** An expression of a call that another value would take the place of. */
export type Replaced = {
  /** As the call has it. */
  text: string,
  /** What it is worth there; null: only the run tells. */
  worth: string | null,
  /** Its variables. */
  variables: Array<Variable>,
};

/** A datum that a cycle leaves. */
export type ResultInfo = {
  /** `_OVR[4]`, `_OVI[0]`; of NCT a name of ours: `deviation`, … */
  name: string,
  /** Key of its meaning. */
  key: string,
  /** Rule of its unit. */
  unit: Unit,
  /** Place in the manual. */
  source: string,
};

/** A measuring result screen. */
export type ResultScreen = {
  /** Which of the four screens it is. */
  title: Message,
  /** Cycle that measured. */
  cycle: string,
  /** Number of the measuring variant. */
  variant: number,
  /** Name of the measuring variant. */
  measures: Message,
  /** What was measured, a row each. */
  rows: Array<ScreenRow>,
  /** Single values below, in the order of the manual's list. */
  values: Array<ScreenValue>,
  /** Decimals of its values. */
  digits: number,
  /** How long it is shown. */
  until: ScreenUntil,
  /** Index of the entry of the trace with which it appears. */
  at: number,
};

/** A row, or the sort of a new one. */
export type RowOf = {
  /** Its table. */
  table: EquipmentTable,
  /** Which one it is in its table; of a new one its sort. */
  row: string,
};

/** An alarm of a run. */
export type RunAlarm = {
  /** Name of the alarm; empty: none of the control. */
  code: string,
  /** What it says. */
  message: Message,
  /** What helps. */
  hint?: Message,
  /** Whether it stops the program. */
  stops: boolean,
  /** What the machine lacks, each a fix. */
  offers?: Array<Offer>,
  /** Line of the call, from 1. */
  line?: number,
  /** Cycle that is called. */
  cycle?: string,
};

/** What a measuring call of a run came to. */
export type RunAnswer = {
  /** The probe that measured. */
  probe: ProbeOfCall,
  /** Numbers or texts of the alarms and operator messages raised in it. */
  alarms: Array<string>,
  /** Amid the points that were touched, machine coordinates X Y Z, mm. */
  place?: [number, number, number],
  /** Index of its first entry of the trace. */
  from: number,
  /** Index of its last one. */
  to: number,
  /** What is measured, in words. */
  feature: Message,
  /** What was measured, the most important first. */
  figures: Array<Figure>,
  /** What was corrected; none: nothing. */
  corrected: Array<Correction>,
  /** Where the deviations lie in their limits; absent: nothing limits them. */
  gauge?: Gauge,
  /** What follows. */
  verdict: Verdict,
  /** The verdict in words. */
  verdict_words: Message,
  /** Number or text of the alarm or operator message behind the verdict. */
  alarm?: string,
  /** Why, in a sentence. */
  why: Message,
  /** The measuring result screen; absent: the control shows none. */
  screen?: ResultScreen,
  /** Line of the call, from 1. */
  line?: number,
  /** Cycle that is called. */
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
  /** Line of the call, from 1. */
  line?: number,
  /** Cycle that is called. */
  cycle?: string,
};

/** How a program is carried out. */
export type RunMode = "automatic" | "dry-run" | "program-test" | "block-search" | "simulation" | "jobshop";

/**
 * The record of a run. Lengths in the unit beside them, angles in degree. Every `key` names a text of Probewright and
 * stays the same in all languages; `text` is what it says.
 */
export type RunRecord = {
  /** Version of this format: 1. */
  format: number,
  /** Name of the file with the program. */
  program: string,
  /** Where the values come from. */
  about: RecordAbout,
  /** Files beside the program: lines go on there. */
  files: Array<RecordFile>,
  /** How the run ended. */
  ending: Message,
  /** The measuring calls in their order. */
  calls: Array<RunAnswer>,
};

/** What is run. */
export type RunRequest = {
  /** Control. */
  control: Dialect,
  /** Text of the program. */
  text: ProgramText,
  /** Machine; absent: the core's own as it is. */
  setup?: Machine,
  /** Which program of the text is run, by its name; absent: the first. */
  program?: string,
  /** Values for the parameters of the program itself, by name; absent: none. */
  arguments?: { [key in string]: Datum },
  /** Whether what is not there stops the run: a subprogram, a value that only the machine has; absent: no. */
  strict?: boolean,
  /** How it is carried out; absent: in AUTOMATIC. */
  mode?: RunMode,
  /** Line, from 1, up to which a block search goes; absent: the whole program is searched through. */
  target?: number,
  /** Work in blocks after which the run is given up; absent: never. */
  blocks?: number,
  /** Files beside the program: its subprograms, definition files; absent: none. */
  with?: Array<Beside>,
  /** Name of its file, `part.mpf`, which no log can have; absent: none, or the text tells it. */
  file?: string,
};

/** A result of a run. */
export type RunResult = {
  /** `_OVR[4]`. */
  name: string,
  /** Value of the result. */
  value: number,
  /** Meaning of the result, where a call left it. */
  label?: Message,
  /** Unit of the result, where a call left it. */
  unit?: string,
  /** Line of the call, from 1. */
  line?: number,
  /** Cycle that is called. */
  cycle?: string,
};

/** What a program did. */
export type RunView = {
  /** Everything that happened. */
  trace: Source,
  /** What was found on the way. */
  diagnostics: Array<Diagnostic>,
  /** The results of each call; behind them what the program wrote beside them. */
  results: Array<RunResult>,
  /** What each measuring call came to, in order. */
  answers: Array<RunAnswer>,
  /** What the cycles decided, in order. */
  decisions: Array<RunDecision>,
  /** What is different afterwards. */
  changes: Array<Change>,
  /** Where it waits for NC START: M0, a text of the operator that halts. */
  waits?: Array<RunWait>,
  /** The alarms in order. */
  alarms: Array<RunAlarm>,
  /** Lines of the print-out, and blocks that were sent. */
  log: Array<string>,
  /** Files that it left on the control: the log of measurements. */
  written?: Array<WrittenFile>,
  /** Whether it reached its end. */
  finished: boolean,
  /** What it went on without. */
  passedOver: Array<PassedOver>,
  /** Values that only the machine has and that were assumed. */
  machineValues?: Array<MachineValue>,
  /** Where the files beside the program begin. */
  files?: Array<FileStart>,
  /** How it ended. */
  ending: Message,
  /** Where the values come from, for the record. */
  about: RecordAbout,
  /** Of a program that came without a machine: what was assumed. */
  assumed?: RunAssumed,
};

/** A halt of a run. */
export type RunWait = {
  /** Index of the entry of the trace. */
  at: number,
  /** What the operator reads: the last text, `M0` where there is none. */
  text: string,
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
  /** How far the points are from the true surface, with the ball taken out. */
  surface: Deviation,
  /** The part. */
  solids: Array<Solid>,
  /** Radius of the ball, mm. */
  radius: number,
  /** From where the points count, machine coordinates, mm. */
  origin: [number, number, number],
};

/** A program on a machine, and case by case what must come of it. Lengths in mm, angles in degree. */
export type Scenario = {
  /** What it is about, and where its figures come from. */
  source?: string,
  /** The program. */
  program: ScenarioText,
  /** Files beside it: its subprograms, definition files. */
  with?: Array<ScenarioText>,
  /** Which program of the text is run, by its name; absent: the first. */
  main?: string,
  /** Values for the parameters of the program itself, by name. */
  arguments?: { [key in string]: Datum },
  /** Whether what is not there stops the run: a subprogram, a value that only the machine has. */
  strict?: boolean,
  /** How it is carried out; absent: in AUTOMATIC. */
  mode?: RunMode,
  /** Line, from 1, up to which a block search goes; absent: the whole program is searched through. */
  target?: number,
  /** The machine with its probe, as a setup file describes it. */
  setup: Setup,
  /** What is carried out, each from the beginning. */
  cases: Array<ScenarioCase>,
};

/** A case: what differs from program and machine of the scenario, and what must come of it. */
export type ScenarioCase = {
  /** What it is called. */
  id: string,
  /** Where the expectation comes from. */
  oracle?: string,
  /** Texts of the program, each with what stands in its place. */
  replace?: Array<[string, string]>,
  /** The part; absent: that of the setup. */
  workpiece?: Array<Solid>,
  /** Tools that differ, by T number. */
  tools?: { [key in number]: ToolData },
  /** User and machine data that differ. */
  data?: { [key in string]: Datum },
  /** Tool and frame data that differ, as a program names them: `$P_UIFR[1,X,FI]`, `H98`. */
  variables?: { [key in string]: number },
  /** What must come of it. */
  expect: Expected,
};

/** A scenario to carry out. */
export type ScenarioRequest = {
  /** The scenario. */
  scenario: Scenario,
  /** Files that it names without their text; absent: none. */
  beside?: Array<Beside>,
};

/** A file with a program. */
export type ScenarioText = {
  /** Name of the file. */
  name: string,
  /** Its text; absent: the file lies beside the scenario. */
  text?: string,
};

/** What came of a scenario. */
export type ScenarioView = {
  /** What it is about, and where its figures come from. */
  source: string,
  /** Its cases in their order. */
  cases: Array<CaseView>,
};

/** A coordinate system, machine coordinates. */
export type SceneFrame = {
  /** The name of its zero offset; empty: the machine's own. */
  name: string,
  /** Zero of the frame, mm. */
  at: [number, number, number],
  /** Directions of the axes. */
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
  /** What is said, one after the other; nothing: the name of the parameter. */
  text: Array<Message>,
  /** Whether it stands at the upper end of a dimension line: neighbours have their words at different ends. */
  upper?: boolean,
  /** Which touch of its call it is, from 1 on. */
  number?: number,
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
  /** Part of the corners that belongs to the piece, from and to (excluded). */
  corners: [number, number],
  /** Part of the vertices that belongs to the piece. */
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
  /** End of the tool, from the position of the machine on. */
  tip: [number, number, number],
  /** Box around a tool alone, from the position of the machine on; none for a probe, whose stylus may be cut off. */
  extent?: [[number, number, number], [number, number, number]],
  /** Whether a turret is drawn that carries it. */
  carried: boolean,
};

/** What the arrays of a scene hold. */
export type SceneView = {
  /** Parts of the triangles: what is always there, then what may hide a part, then what is seen through. */
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
  /** How many times as large the errors of the part are drawn; none: as they are. */
  exaggerated?: number,
};

/** A row of a result screen: what has no setpoint or difference leaves it empty. */
export type ScreenRow = {
  /** What it is. */
  label: Message,
  /** Setpoint. */
  set: number | null,
  /** Actual value, trigger value of a calibration. */
  actual: number | null,
  /** Actual value minus setpoint, of a calibration the change. */
  difference: number | null,
  /** Unit of all of them. */
  unit: string,
};

/** How long a result screen is shown. */
export type ScreenUntil = "end" | "start" | "next";

/** A single value of a result screen. */
export type ScreenValue = {
  /** What it is. */
  label: Message,
  /** Its value. */
  value: number,
  /** Its unit; empty: none. */
  unit: string,
};

/** A program that is run many times, and what varies from run to run. */
export type Series = {
  /** How many runs, 1 to 1 000 000. */
  runs: number,
  /** Seed of all random numbers. */
  seed: number,
  /** Whether a run finds what the one before it left. */
  mode: Mode,
  /** What varies. The scatter of a touch is the repeatability of the probe. */
  vary: Array<Vary>,
};

/** An alarm over all runs. */
export type SeriesAlarm = {
  /** In how many runs it came. */
  count: number,
  /** Share of all runs. */
  share: number,
  /** Standard error of this share; of all or none of the runs: how much it may be off with 95 % confidence. */
  error: number,
  /** Count and share in words, with no more digits than are certain. */
  told: Message,
  /** Name of the alarm; empty: none of the control. */
  code: string,
  /** What it says. */
  message: Message,
  /** What helps. */
  hint?: Message,
  /** Whether it stops the program. */
  stops: boolean,
  /** What the machine lacks, each a fix. */
  offers?: Array<Offer>,
};

/** A measuring call over all runs. */
export type SeriesCall = {
  /** What is measured, in words. */
  feature: Message,
  /** What was measured, the most important first. */
  measured: Array<SeriesFigure>,
  /** What was corrected. */
  corrected: Array<SeriesCorrection>,
  /** What followed, with the share of the runs. */
  verdicts: Array<SeriesShare>,
  /** In production: what would have followed had no part been corrected. */
  uncorrected?: Array<SeriesShare>,
  /** Weight of its mean value, where it keeps one. */
  weight?: SeriesWeight,
  /** Mean and empirical value after each run, where the call has a memory for them. */
  memories?: Array<SeriesMemory>,
  /** Line of the call, from 1. */
  line?: number,
  /** Cycle that is called. */
  cycle?: string,
};

/** A datum that was corrected. */
export type SeriesCorrection = {
  /** Frame, tool or register. */
  target: Message,
  /** Axis, length or radius: `X`, `L1`, `R`. */
  part: string,
  /** Unit of the correction. */
  unit: string,
  /** By how much in each of the first 1000 runs; 0: not at all. */
  course: Array<number>,
  /** How many. */
  count: number,
  /** Mean. */
  mean: number,
  /** Its standard error. */
  meanError: number,
  /** Standard deviation. */
  deviation: number,
  /** Its standard error. */
  deviationError: number,
  /** The smallest. */
  min: number,
  /** 2.5 % are smaller. */
  low: number,
  /** Half are smaller. */
  median: number,
  /** 2.5 % are larger. */
  high: number,
  /** The largest. */
  max: number,
};

/** A program with its series, on a machine of its own. */
export type SeriesExample = {
  /** Control. */
  control: Dialect,
  /** The program. */
  text: string,
  /** Its series. */
  series: Series,
};

/** A quantity over all runs, in its unit. */
export type SeriesFigure = {
  /** The result that has its actual value: `_OVR[4]`. */
  name: string,
  /** Meaning of the result. */
  label: Message,
  /** Unit at the call. */
  unit: string,
  /** How many lie in each of 20 intervals from the smallest to the largest. */
  histogram: Array<number>,
  /** Smallest and largest deviation that is permitted; absent: nothing limits it. */
  limits?: [number, number],
  /** How well the values hold these limits. */
  capability?: Capability,
  /** Setpoint at the call; absent: there is none. */
  set?: number,
  /** The actual value in each of the first 1000 runs; null: nothing was measured. */
  course: Array<number | null>,
  /** How many. */
  count: number,
  /** Mean. */
  mean: number,
  /** Its standard error. */
  meanError: number,
  /** Standard deviation. */
  deviation: number,
  /** Its standard error. */
  deviationError: number,
  /** The smallest. */
  min: number,
  /** 2.5 % are smaller. */
  low: number,
  /** Half are smaller. */
  median: number,
  /** 2.5 % are larger. */
  high: number,
  /** The largest. */
  max: number,
};

/** A correction that reaches the next part. */
export type SeriesFollow = {
  /** What it changes: name of a variation. */
  what: string,
  /** The datum that is corrected: `$TC_DP15[20,1]`. */
  variable: string,
  /** What one unit more of it adds there. */
  factor: number,
  /** Frame, tool or register. */
  target: Message,
  /** Axis, length or radius: `X`, `L1`, `R`. */
  part: string,
};

/** A memory of the control over the first runs. */
export type SeriesMemory = {
  /** As a program would name it: `_MV[0]`. */
  name: string,
  /** Whether it is a mean value, else an empirical value. */
  mean: boolean,
  /** Unit of the call. */
  unit: string,
  /** Its value after each of the first 1000 runs, in that unit. */
  course: Array<number>,
};

/** Something that can vary. */
export type SeriesName = {
  /** Its name in the setup file. */
  name: string,
  /** In words. */
  label: Message,
  /** Which part of those on the machine, from 1; absent: it is of the probe. */
  part?: number,
};

/** A variation that is complete. */
export type SeriesPreset = {
  /** What it is, in words. */
  label: Message,
  /** The correction that it belongs to; absent: none. */
  of?: SeriesFollow,
  /** Which part of those on the machine, from 1; absent: all of them. */
  part?: number,
  /** The variation. */
  vary: Vary,
};

/** A program to be run many times. */
export type SeriesRequest = {
  /** Control. */
  control: Dialect,
  /** Text of the program. */
  text: ProgramText,
  /** Machine; absent: the core's own as it is. */
  setup?: Machine,
  /** Which program of the text is run, by its name; absent: the first. */
  program?: string,
  /** Files beside the program; absent: none. */
  with?: Array<Beside>,
  /** How often, and what varies; absent: what the machine says. */
  series?: Series,
  /** Whether the machine is that of the example; absent: no. */
  example?: boolean,
};

/** Share of the runs in which something happened. */
export type SeriesShare = {
  /** What. */
  verdict: Verdict,
  /** In words. */
  words: Message,
  /** In how many runs. */
  count: number,
  /** Share of all runs. */
  share: number,
  /** Standard error of this share; of all or none of the runs: how much it may be off with 95 % confidence. */
  error: number,
  /** Count and share in words, with no more digits than are certain. */
  told: Message,
};

/** What a series begins with. */
export type SeriesStart = {
  /** That of the machine. */
  series: Series,
  /** What can vary of its parts and probe. */
  names: Array<SeriesName>,
  /** Corrections of the program that reach the next part. */
  follows: Array<SeriesFollow>,
  /** Variations that are complete: wear of a tool, a part that gets warm. */
  presets: Array<SeriesPreset>,
  /** How to choose the limits of a correction, a paragraph each. */
  help: Array<Message>,
  /** The example of the manual. */
  example: SeriesExample,
};

/** How the results of a program spread over many runs. */
export type SeriesView = {
  /** How many runs. */
  runs: number,
  /** Seed of all random numbers: the same seed gives the same results. */
  seed: number,
  /** Whether a run found what the one before it left. */
  mode: Mode,
  /** How many runs reached the end of the program. */
  finished: number,
  /** The measuring calls, in order. */
  calls: Array<SeriesCall>,
  /** How many of them are listed, where the program has more. */
  more?: Message,
  /** Alarms and operator messages, each with the share of the runs in which it came. */
  alarms: Array<SeriesAlarm>,
};

/** The weight with which a call forms its mean value (B:1244-1263). */
export type SeriesWeight = {
  /** The parameter that has it. */
  name: string,
  /** Its value. */
  value: number,
};

/**
 * Machine, probe and part that a program runs on. Lengths in mm, angles in degree, feeds in mm/min, except in `data`,
 * where a number means what it means on the control: on an inch machine most lengths are inches. Unknown members are
 * refused, so that a slip is told and not ignored.
 */
export type Setup = {
  /** Control. */
  control: Dialect,
  /** What the user calls the machine. */
  name?: string,
  /** Basic system of units of the machine. */
  units: BasicSystem,
  /** Working plane at the start. */
  plane: Plane,
  /** What else is active at the start. */
  active: Active,
  /** What the machine can do. */
  machine: Abilities,
  /** Tools by T number (NCT: offset registers under T 0). */
  tools: { [key in number]: ToolData },
  /** Frames by name: `G54`, `G505`, `COMMON` (NCT), `$P_CHBFR[0]`, `$P_NCBFR[0]`, `$P_SETFR`. */
  frames: { [key in string]: Frame },
  /** Stored tool environments by name, as `TOOLENV("NAME")` makes them. */
  environments: { [key in string]: Environment },
  /**
   * What differs from delivery in user data, R parameters, machine data, # variables: `_WP[0,1]`, `_CHBIT[4]`,
   * `R10`, `MD18600`, `#500`; `PW-FORMS`, 1 where `_MZ_MASK` decides forms and
   * code; `PW-JOG`, 1 where measuring in JOG has the masks up to SW 6.2; `PW-GENERATION`, 1 to 3, the generation of
   * the control; `PW-MACRO-LEVELS` and `PW-SUBPROGRAM-LEVELS`, how many an NCT control has.
   */
  data: { [key in string]: Datum },
  /**
   * User data that the definition files of the machine add (GUD4.DEF, UGUD.DEF …), as they are written there:
   * `DEF NCK REAL LIMIT[2,3]=SET(1,2)`. Their values are in `data`, where they differ.
   */
  definitions?: Array<string>,
  /** The probe as it really is, not as the control believes. */
  probe: Probe,
  /** The tool probes of the machine as they really are, not as `_TP` and `_TPW` in `data` believe. */
  toolProbes: Array<ToolProbe>,
  /** The part: every solid can be touched. It is given as it is clamped while the rotary axes stand at 0. */
  workpiece: Array<Solid>,
  /** Where the machine stands at the start: the point to which L1 refers, machine coordinates X Y Z. */
  position: [number, number, number],
  /**
   * Date and time of the control at the start, `2026-05-31T08:00:00`; motions take their time from then on. The log
   * of measurements prints them. Default: 2000-01-01T00:00:00.
   */
  clock?: string,
  /** Skip levels 0 to 9 that are switched on at the panel: blocks with `/`, `/1` to `/9` are left out. */
  skip: Array<number>,
  /** What varies where a program is run many times: `probewright series`. */
  series?: Series,
  /** How well the temperature of the part is known: a part of how uncertain a measured length is. */
  temperature?: Temperature,
};

/** How bad it is. */
export type Severity = "error" | "warning" | "note";

/** How numbers are spread about their mean. */
export type Shape = "normal" | "uniform" | "triangular" | "arcsine";

/** What a figure stands for. */
export type ShapeKind = "material" | "cut" | "edge" | "zone" | "probe" | "path" | "dimension" | "label" | "tolerance" | "axis" | "touch" | "plane";

export type ShapeName = "hole" | "shaft" | "groove" | "web" | "pocket" | "island" | "block" | "turned" | "chuck" | "sphere" | "outerCorner" | "innerCorner" | "surface";

/** What both calls say. */
export type Shared = {
  /** What it is. */
  label: Message,
  /** Value on both controls; a length in the active unit. */
  value: number,
};

/** A solid. */
export type Solid = {
  /** Element. */
  shape: ShapeName,
  /**
   * hole: diameter, depth; shaft: diameter, height; groove and web: width, depth, length; pocket and island:
   * X, Y, depth; block: X, Y, Z; turned: diameter, length, diameter and depth of the bore (0: none); chuck:
   * diameter, length, diameter that it grips; sphere: diameter; outerCorner and innerCorner: angle between the edges
   * in degree, lengths of the edge along X and of the other one, depth; surface: none.
   */
  size: Array<number>,
  /** What a surface looks like, of this shape only. */
  surface?: Surface,
  /**
   * Centre of the element at its upper face, of a sphere its centre, of a corner the corner, machine coordinates X Y
   * Z.
   */
  at: [number, number, number],
  /** Orientation about X Y Z (RPY), degree. */
  rotation: [number, number, number],
  /** What is wrong with it. */
  errors: PartErrors,
};

/** What a scene is made of. */
export type Source = {
  /** In order, with lines of the program from 1. */
  entries: Array<Step & { line?: number }>,
  /** The probe. */
  ball: Ball,
  /** Whatever was in use. */
  tools: Array<ToolView>,
  /** From which entry on which of them. */
  inUse: Array<[number, number]>,
  /** Whether the machine turns. */
  turning: boolean,
  /** The part as it stands at the start. */
  solids: Array<Solid>,
  /** The caps of the tool probes. */
  toolProbes: Array<Solid>,
  /** Coordinate systems. */
  frames: Array<SceneFrame>,
  /** The part of a turning machine as on a drawing. */
  drawing?: Drawing,
  /** Walls of protection zones, as shaft, web or island; shown, not touched. */
  zones: Array<Solid>,
  /** The part with the largest errors on both sides. */
  limits: Array<Solid>,
};

/** How everything stands from an entry of the trace on: rotary axes turn the part. */
export type Standing = {
  /** From when this one is done on. */
  entry: number,
  /** Where each solid stands: those of the part, then what stays. */
  places: Array<Place>,
  /** What is shown at first, without the tool: least and greatest coordinates. */
  whole: [[number, number, number], [number, number, number]],
  /** Of the ground: its height along the upright axis, and the spacing of its grid, mm. */
  ground: [number, number],
};

/** One step. Directions are in machine (basic) coordinates X Y Z, as the points. */
export type Step = { "step": "motion",
  /** Kind. */
  kind: MotionKind,
  /** Start: the point to which the tool length refers. */
  from: Mcs,
  /** Real end. */
  to: Mcs,
  /** Round what it went; none: straight. */
  around?: Around,
  /** mm/min; 0: rapid traverse. */
  feed: number,
} | { "step": "touch",
  /** Position latched by the control. */
  latched: Mcs,
  /** Centre of the ball at contact; of a tool at a tool probe the point to which its lengths refer. */
  ball: Mcs,
  /** Point touched on the part. */
  point: Mcs,
  /** Outward unit normal of the part there. */
  normal: [number, number, number],
  /** What touched; left out: what measures, the ball or a tool. */
  by?: Touching,
} | { "step": "crash",
  /** Point touched on the part. */
  point: Mcs,
  /** Outward unit normal of the part there. */
  normal: [number, number, number],
  /** What touched; left out: what measures, the ball or a tool. */
  by?: Touching,
} | { "step": "orient",
  /** Degree. */
  angle: number,
} | { "step": "spin",
  /** 1/min: positive with M3, negative with M4; 0: it stops. */
  speed: number,
} | { "step": "table",
  /** Which one: 0 A, 1 B, 2 C. */
  axis: string,
  /** Before, machine, degree. */
  from: number,
  /** After. */
  to: number,
  /** The part as it stands then, machine coordinates. */
  solids: Array<Solid>,
} | { "step": "tool",
  /** T number. */
  tool: number,
  /** D number. */
  edge: number,
} | { "step": "set",
  /** `_OVR[4]`, `$P_UIFR[1,X,FI]`, `$TC_DP15[20,1]`, `#505`. */
  name: string,
  /** Value before. */
  before: number,
  /** Value after. */
  after: number,
} | { "step": "decision",
  /** In words. */
  message: Message,
} | { "step": "alarm" } & Raised | { "step": "message",
  /** As it is shown. */
  text: string,
  /** Whether the program waits for NC START. */
  waits?: boolean,
} | { "step": "log",
  /** As it is written. */
  text: string,
} | { "step": "file",
  /** `LOG_1.MPF`. */
  name: string,
  /** The line; none: it is made, and empty. */
  text?: string,
} | { "step": "call",
  /** Name. */
  cycle: string,
  /** Number of the measuring variant. */
  variant: number,
} | { "step": "return" };

/** The program of a story. */
export type Story = {
  /** Its text; empty where the call corrects no zero offset. */
  text: string,
};

/** A way to write a call. */
export type Style = "direct" | "indirect" | "operate";

/** What a machine is given. */
export type Supply = { "tool": NewTool } | "tools" | "parts";

/** Free surface of a solid; its own X and Y along the part, Z up, lengths in mm. */
export type Surface = { "example": {
  /** `dome`, `waves`, `saddle`, `step`. */
  name: string,
  /** X, Y, and how far the lowest point lies below 0. */
  size: [number, number, number],
} } | { "heights": Heights } | { "triangles": Array<[[number, number, number], [number, number, number], [number, number, number]]> };

/** What replaces a surface, as large as that. */
export type SurfaceChoice = { "example": string } | { "picture": number } | "stl";

/** How well the temperature of the part is known. It has no effect on a run; it makes measured lengths uncertain. */
export type Temperature = {
  /** Standard deviation of its temperature from that for which the setpoints hold, K. 0: it is that temperature. */
  spread: number,
  /** How much it grows, µm per m and K. */
  expansion: number,
};

/** A term with its definition. */
export type TermView = {
  /** The term. */
  term: Message,
  /** What it means. */
  meaning: Message,
  /** Parameters and data that hold it. */
  names: Array<string>,
  /** Terms that help to understand it. */
  see: Array<Message>,
  /** Place in the manual. */
  source: Cited,
};

/** All of them. */
export type TermsView = {
  /** Guides, those of a group together. */
  guides: Array<GuideView>,
  /** Concepts, those of a group together. */
  concepts: Array<ConceptView>,
  /** Terms, by the alphabet of English. */
  terms: Array<TermView>,
};

/** A tool. */
export type ToolData = {
  /** Name under tool management. */
  name: string,
  /** Edges by D number. */
  edges: { [key in number]: EdgeData },
};

/** A piece of what is drawn, machine axes, mm from the point to which the tool length refers. */
export type ToolPiece = {
  /** Distance from the axis and height over `at`. */
  outline: Array<[number, number]>,
  /** Direction of the axis. */
  axis: [number, number, number],
  /** Where it begins. */
  at: [number, number, number],
} | {
  /** Corners in turn; convex. */
  corners: Array<[number, number, number]>,
  /** From there to the other face. */
  thick: [number, number, number],
  /** Whether it is an insert, which cuts. */
  cuts: boolean,
};

/** A tool probe as it really is: a cube (`block`) or a disc (`turned` without bore). */
export type ToolProbe = {
  /** Cap of the tool probe. */
  solid: Solid,
  /** Travel after contact until the signal. */
  preTravel: number,
  /** Delay of the signal, s. */
  delay: number,
  /** Standard deviation of the switching point, and the seed of its pseudo-random sequence. */
  repeatability: [number, number],
};

/**
 * What is drawn of what is in use, from the position of the machine on: the ball of the probe or the pieces of a tool;
 * on a turning machine also what carries it.
 */
export type ToolView = {
  /** Length in effect along X Y Z, mm: where it changes, the axes stand still. */
  length: [number, number, number],
  /** Direction from the ball to what holds it; none: no probe. */
  ball?: [number, number, number],
  /** Pieces of the tool. */
  pieces: Array<ToolPiece>,
  /** What holds it on a turning machine. */
  carrier: Array<ToolPiece>,
  /** End of the tool. */
  tip: [number, number, number],
};

/** A section of a form; sections are shown in this order. */
export type Topic = "task" | "correction" | "approach" | "tolerances" | "statistics" | "probe" | "list";

/** A diameter as the control reads it, mm. */
export type Touched = {
  /** Place of the touch in the trace. */
  entry: number,
  /** Diameter. */
  diameter: number,
};

/** A line that would be another one. */
export type TouchedLine = {
  /** Number of the line, from 1. */
  line: number,
  /** As it is. */
  before: string,
  /** As it would be; empty where it goes. */
  after: string,
};

/** What touches. */
export type Touching = "ball" | "stylus" | "body" | "tool" | "cutter";

/** Everything that happened, with what is needed to draw it. Machine coordinates, mm. */
export type Trace = {
  /** In order, with lines of the program from 1. */
  entries: Array<Step & { line?: number }>,
  /** The probe. */
  ball: Ball,
  /** Whatever was in use. */
  tools: Array<ToolView>,
  /** From which entry on which of them. */
  inUse: Array<[number, number]>,
  /** Whether the machine turns. */
  turning: boolean,
  /** The part as it stands at the start. */
  solids: Array<Solid>,
  /** The caps of the tool probes. */
  toolProbes: Array<Solid>,
  /** Coordinate systems. */
  frames: Array<SceneFrame>,
  /** The part of a turning machine as on a drawing. */
  drawing?: Drawing,
  /** Walls of protection zones, as shaft, web or island; shown, not touched. */
  zones: Array<Solid>,
  /** The part with the largest errors on both sides. */
  limits: Array<Solid>,
};

/** How the program gives positions of the transverse axis X of a lathe. */
export type Transverse = "DIAMOF" | "DIAMON" | "DIAM90";

/** How a part was put: what a measurement should find. */
export type Truth = {
  /** Seed that made it; 0: none did. */
  seed: number,
  /** Displacement X Y Z of the first solid, mm. */
  shift: [number, number, number],
  /** Rotation about the machine's X Y Z (RPY), degree. */
  tilt: [number, number, number],
  /** Added to every diameter, width and length, mm. */
  size: number,
};

/** The disc of a turret, its axis parallel to that of the spindle. */
export type Turret = {
  /** Diameter, mm; 0: none is drawn. */
  diameter: number,
  /** Width, mm. */
  width: number,
};

/** A task as another control does it. */
export type TwinView = {
  /** Name of that control, the same in every language. */
  control: string,
  /** Cycle of the other control. */
  cycle: string,
  /** Stem of its messages. */
  key: string,
  /** What both measure. */
  task: Message,
  /** Values as typed there. */
  values: { [key in string]: string },
  /** Text of the program there; empty: it is not written. */
  snippet: string,
  /** Why it is not written. */
  refused?: Message,
  /** What both say. */
  shared: Array<Shared>,
  /** What is different there. */
  differences: Array<Message>,
};

/** A value that does not fit the variant. */
export type Unfit = {
  /** Parameter: `_KNUM`. */
  name: Name,
  /** As it was typed. */
  value: string,
  /** Key of the name of what it was a code of before; absent: the new variant does not take the number. */
  before?: string,
};

/** The values of a form before another variant was chosen in it, and after. */
export type UnfitRequest = {
  /** Control. */
  control: Dialect,
  /** Cycle. */
  cycle: string,
  /** Values before, by parameter. */
  before: { [key in string]: string },
  /** Values after. */
  values: { [key in string]: string },
  /** Machine; absent: the core's own as it is. */
  setup?: Machine,
};

/** Unit of a parameter and the system it counts in. */
export type Unit = "" | "active length" | "basic length" | "mm" | "deg" | "basic feed";

/** G function that chooses the system of units; those below 70 are of NCT. */
export type UnitFunction = "G20" | "G21" | "G70" | "G71" | "G700" | "G710";

/** What a machine measures with. */
export type Use = "cycles" | "jog" | "log" | "tool-probe";

/** Lines of a cycle. */
export type UserBranch = {
  /** The cycle. */
  cycle: string,
  /** Lines before its measurement. */
  before: string,
  /** Lines behind it. */
  behind: string,
};

/** A cycle that can be chosen. */
export type UserLabel = {
  /** The cycle. */
  cycle: string,
  /** Stem of its messages. */
  key: string,
  /** Label of its lines. */
  label: string,
};

/** Which cycles get lines of their own. */
export type UserProgramsRequest = {
  /** The cycles that were chosen. */
  branches: Array<UserBranch>,
  /** Variable of the CASE in the delivered file; absent: lines to insert are written. */
  variable?: string,
  /** Words by key, for comments: of `user-program-before-line` and `user-program-behind-line` for each cycle. */
  words?: { [key in string]: string },
};

/** The two programs. */
export type UserProgramsView = {
  /** Cycles that can be chosen. */
  labels: Array<UserLabel>,
  /** CYCLE198; empty: nothing is chosen. */
  before: string,
  /** CYCLE199. */
  behind: string,
  /** What should be known beside them. */
  notes: Array<Message>,
  /** Places in the manual. */
  sources: [Cited, Cited],
};

/** Values of a variant as typed, by parameter name. */
export type Values = {
  /** Values that choose the variant. */
  values: { [key in string]: string },
  /** Values of the worked measurement. */
  example: { [key in string]: string },
  /** Those of them that are lengths in the active system of units, in inches: the same measurement. */
  inch: { [key in string]: string },
};

/** A variable of an expression. */
export type Variable = {
  /** Its name, in upper case. */
  name: string,
  /** Lines, from 1, that read what it holds at the call. */
  uses: Array<number>,
  /** Lines, from 1, that may have given it its value. */
  assigned: Array<number>,
  /** The assignment with which the expression is worth the new value; null: see `why`. */
  change: Assignment | null,
  /** Why there is none. */
  why: Message | null,
};

/** A measuring variant. Its values, as typed, choose it; its example is a worked measurement. */
export type VariantInfo = {
  /** Number of the variant. */
  mvar: number,
  /** Key of its name. */
  key: string,
  /** Place in the manual. */
  source: Cited,
  /** Keys of what the digits of its number choose, the lowest place first. */
  choices: Array<string>,
  /** What it is for; none: it is found by its number alone. */
  aim: Aim | null,
  /** In the planes in which other addresses name the axes. */
  planes: { [key in Plane]?: Values },
  /** Values that choose the variant. */
  values: { [key in string]: string },
  /** Values of the worked measurement. */
  example: { [key in string]: string },
  /** Those of them that are lengths in the active system of units, in inches: the same measurement. */
  inch: { [key in string]: string },
};

/** Something that varies: what is drawn is added to what the file says. */
export type Vary = {
  /**
   * Member of the file: `workpiece[0].errors.size`, `.taper`, `.shift[0]`, `.tilt[2]`, `.outOfRound[0]`;
   * `temperature.part`, K, by which the part is warmer; `probe.radius`, `.length`, `.delay`, `.skew[0]`,
   * `.preTravel[0]`; a datum or a tool or frame variable as `data._WP[0,1]`, `data.$TC_DP3[9,1]`.
   */
  what: string,
  /** How it is spread. */
  as?: Shape,
  /** Standard deviation, of `normal`. */
  sigma?: number,
  /** Half width, of the others. */
  half?: number,
  /** Its mean. */
  mean?: number,
  /** By how much the mean grows from one part to the next: wear of the tool that makes them, a machine that warms up. */
  drift?: number,
  /** How often it is drawn. */
  per?: Per,
  /** Added as well, one after the other from part to part, from the first again: a series as it was measured. */
  values?: Array<number>,
  /**
   * In production, how much of a correction reaches the next part: by variable, what one unit more of it adds here.
   * A hole that is cut with T20 D1 gets smaller by twice the wear of the radius: `{ "$TC_DP15[20,1]": -2 }`.
   */
  follows?: { [key in string]: number },
};

/** What follows from a measurement. */
export type Verdict = "within" | "beyond" | "rework" | "scrap" | "alarm" | "stopped" | "measured";

/** Versions of a datum. */
export type Versions = {
  /** The first one; empty: it is older than all that is told. */
  from: string,
  /** The last one; empty: still there. */
  until: string,
};

/** From where the drawing is seen. */
export type View = "plane" | "section" | "space";

/** How certain the measurements of a program are. */
export type WholeCertainty = {
  /** How many runs; 0: nothing is known. */
  runs: number,
  /** Why nothing is known. */
  nothing?: Message,
  /** Share of them that did not come to the end. */
  stopped: number,
  /** For each measuring call of the run, in order. */
  calls: Array<CallCertainty>,
};

/** A program whose measurements are to be judged. */
export type WholeCertaintyRequest = {
  /** Control. */
  control: Dialect,
  /** Text of the program. */
  text: ProgramText,
  /** Machine; absent: the core's own as it is. */
  setup?: Machine,
  /** Which program of the text is run, by its name; absent: the first. */
  program?: string,
  /** Files beside the program; absent: none. */
  with?: Array<Beside>,
  /** How many runs, up to 10 000; absent: 400. */
  runs?: number,
  /** Seed of all random numbers; absent: that of the machine's series. */
  seed?: number,
};

/** A file that a run left on the control: the log of measurements. */
export type WrittenFile = {
  /** As the control shows it: `LOG_1.MPF`. */
  name: string,
  /** Its lines. */
  lines: Array<string>,
  /** Index of the entry of the trace with which each line was written. */
  at: Array<number>,
};
