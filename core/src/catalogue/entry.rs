//! The shape of a catalogue entry. Plain data, read by form, check, program, docs and run.

use crate::SIMULATES;
use crate::check::Inputs;
use crate::control::{Control, Plane};
use crate::diagnostic::Code;
use crate::form::picture::Picture;
use crate::run::{Machine, Stop};
use crate::workpiece::tool::Tool;
use crate::workpiece::tool_probe::ToolProbe;
use crate::workpiece::{Solid, Workpiece};

/// The language of the part program, and with it the control.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Dialect {
    /// SINUMERIK 840D/840Di/810D.
    Sinumerik,
    /// NCT milling controls.
    Nct,
}

/// One measuring cycle or macro.
pub struct Cycle {
    /// Control that has it.
    pub dialect: Dialect,
    /// Name as called: `CYCLE977`, `G110`.
    pub name: &'static str,
    /// Stem of its message keys: `cycle977` → `cycle977-title`, `cycle977-help`, `cycle977-words` (search words).
    pub key: &'static str,
    /// Measuring variants, in the manual's order. Never empty.
    pub variants: &'static [Variant],
    /// Parameters in the order in which the snippet writes them.
    pub params: &'static [Param],
    /// Where it belongs: the probe it uses, the sort of machine, whether it calibrates.
    pub purpose: Purpose,
    /// Calls with arguments in brackets that mean this cycle.
    pub lists: &'static [super::ArgumentList],
    /// Data of the machine that decide what the form shows or what is right in it: `_CBIT[12]`, `_MT_COMP`, …
    pub settings: &'static [&'static str],
    /// What it leaves in the result data.
    pub results: &'static [ResultField],
    /// Numbers (or NCT messages) that the manual names for it, in groups; see [`Cycle::alarms`].
    pub alarms: &'static [&'static [Code]],
    /// Checks over several parameters; everything about one parameter is in its [`Param`].
    /// A value that is missing or wrong is absent from the inputs; nothing more is said about it.
    pub checks: fn(&Inputs, &Control, &mut Vec<crate::diagnostic::Diagnostic>),
    /// The help page of each variant.
    pub help: super::help::Help,
    /// What the values mean, drawn.
    pub picture: Drawing,
    /// A worked measurement: values as typed, by parameter name.
    pub example: &'static [(&'static str, &'static str)],
    /// What happens at the call; none while only form, checks and text are known. See [`Cycle::work`].
    pub simulation: Option<Simulation>,
    /// Place in the manual.
    pub source: &'static str,
}

impl Cycle {
    /// All alarms, SINUMERIK by number, NCT as listed.
    pub fn alarms(&self) -> Vec<Code> {
        let number = |code: &Code| match code {
            Code::Alarm(number) => *number,
            _ => 0,
        };
        let mut list: Vec<Code> = Vec::new();
        for code in self.alarms.iter().copied().flatten() {
            let place = list.partition_point(|known| number(known) <= number(code));
            list.insert(place, *code);
        }
        list
    }

    /// Name of the parameter that takes the number of the variant.
    pub fn variant_param(&self) -> Option<&'static str> {
        self.params
            .iter()
            .find(|param| matches!(param.kind, Kind::Variant(_)))
            .map(|param| param.name)
    }

    /// The cycle at work; none where it is not simulated, or not in this build (feature `simulation`).
    pub fn work(&self) -> Option<&Work> {
        let simulation = self.simulation.as_ref().filter(|_| SIMULATES)?;
        simulation.work.as_ref()
    }

    /// How it scans a surface in pieces; none where it does not, or not in this build.
    pub fn scan(&self) -> Option<Scan> {
        self.simulation.as_ref()?.scan
    }

    /// A parameter by its name.
    pub fn param(&self, name: &str) -> Option<&'static Param> {
        self.params.iter().find(|param| param.name == name)
    }
}

/// Where a cycle belongs.
pub struct Purpose {
    /// What touches what.
    pub probe: ProbeUse,
    /// Sort of machine.
    pub machine: MachineSort,
    /// Variants that calibrate the probe.
    pub calibrates: When,
    /// What of it the other control can do too.
    pub tasks: &'static [super::task::Shared],
}

/// The probe that a cycle uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProbeUse {
    /// The workpiece probe is in the spindle or turret and touches the part or a gauge.
    Workpiece,
    /// The tool in use touches the tool probe.
    Tool,
    /// None: it computes.
    None,
    /// None: it belongs to the log of measurements; nothing but the log depends on it.
    Log,
}

impl ProbeUse {
    /// Whether anything is touched.
    pub fn measures(self) -> bool {
        matches!(self, ProbeUse::Workpiece | ProbeUse::Tool)
    }
}

/// Sort of machine that a cycle is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MachineSort {
    /// Milling machines and machining centres.
    Milling,
    /// Lathes.
    Turning,
    /// Both.
    Any,
}

impl MachineSort {
    /// The plane in which such a machine works unless told otherwise (B:8718); none where any may be meant.
    pub fn plane(self) -> Option<Plane> {
        match self {
            MachineSort::Milling => Some(Plane::G17),
            MachineSort::Turning => Some(Plane::G18),
            MachineSort::Any => None,
        }
    }
}

impl Purpose {
    /// Measures workpieces on milling machines.
    pub const MILLING: Purpose = Purpose {
        probe: ProbeUse::Workpiece,
        machine: MachineSort::Milling,
        calibrates: NEVER,
        tasks: &[],
    };
    /// Measures workpieces on lathes.
    pub const TURNING: Purpose = Purpose {
        machine: MachineSort::Turning,
        ..Purpose::MILLING
    };
}

/// A condition that does not hold.
pub const NEVER: When = When::Any(&[]);

/// Values as typed where the condition holds, later ones win.
pub type Examples = &'static [(When, &'static [(&'static str, &'static str)])];

/// A scan before its first point.
pub type Scan = fn(&mut dyn Machine, &Inputs) -> Result<Box<dyn crate::scan::Scanner>, Stop>;

/// That a cycle is simulated.
pub struct Simulation {
    work: Option<Work>,
    scan: Option<Scan>,
    tool: Option<fn(i64) -> ProposedTool>,
    /// What a variant's worked measurement has beside [`Cycle::example`], or instead.
    pub examples: Examples,
}

impl Simulation {
    /// The only way to make one: no entry can forget that a build which does not simulate holds no [`Work`], so that
    /// nothing of it is linked.
    pub const fn new(work: Work, examples: Examples) -> Simulation {
        let work = if SIMULATES { Some(work) } else { None };
        Simulation {
            work,
            scan: None,
            tool: None,
            examples,
        }
    }

    /// The same for a cycle that scans a surface, which can be done in pieces too.
    pub const fn scanning(work: Work, examples: Examples, scan: Scan) -> Simulation {
        let scan = if SIMULATES { Some(scan) } else { None };
        Simulation {
            scan,
            ..Simulation::new(work, examples)
        }
    }

    /// The same of a cycle that needs another tool in use for each sort of variant.
    pub const fn with_tool(self, tool: fn(i64) -> ProposedTool) -> Simulation {
        let tool = if SIMULATES { Some(tool) } else { None };
        Simulation { tool, ..self }
    }

    /// The tool that a variant needs in use, on a machine that has none yet; none where any will do.
    pub fn tool(&self, variant: i64) -> Option<ProposedTool> {
        Some(self.tool?(variant))
    }
}

/// A cycle at work.
pub struct Work {
    /// A nominal part and a safe start position for the values of a form, for a control in this state (plane, frames).
    pub propose: fn(&Inputs, &Control) -> Proposal,
    /// What the control does.
    pub simulate: fn(&mut dyn Machine, &Inputs) -> Result<(), Stop>,
}

/// How a cycle is drawn.
pub struct Drawing {
    draw: Option<fn(&Inputs) -> Picture>,
    /// Whether there is anything to draw; also in a build that does not draw.
    pub drawn: bool,
}

impl Drawing {
    /// There is nothing to draw.
    pub const NONE: Drawing = Drawing {
        draw: None,
        drawn: false,
    };

    /// A build that does not simulate links no drawing either: the page's first module is the form alone.
    pub const fn new(draw: fn(&Inputs) -> Picture) -> Drawing {
        let draw = if SIMULATES { Some(draw) } else { None };
        Drawing { draw, drawn: true }
    }

    /// The picture for these values; none in a build that does not draw.
    pub fn draw(&self, inputs: &Inputs) -> Option<Picture> {
        Some(self.draw?(inputs))
    }
}

/// One measuring variant.
pub struct Variant {
    /// SINUMERIK: the number `_MVAR`. NCT: 0, 1, … in the order of the table.
    pub number: i64,
    /// Key of its name.
    pub key: &'static str,
    /// Place in the manual.
    pub source: &'static str,
}

/// A parameter of a cycle.
pub struct Param {
    /// As the manual writes it: `_SETVAL`, `_SETV[0]`, `D`.
    pub name: &'static str,
    /// Stem of its message keys: `setval` → `param-setval` and `param-setval-help`; see [`Param::labels`].
    pub key: &'static str,
    /// What can be entered.
    pub kind: Kind,
    /// Unit and in which unit system it counts.
    pub unit: Unit,
    /// Value when it is not written; `None`: it has to be.
    pub default: Option<f64>,
    /// The same in inch, where the manual gives a round value of its own (NCT: 5 mm or 0.2 inch, C:94).
    pub default_inch: Option<f64>,
    /// Outside of this the control alarms (or the call makes no sense).
    pub range: Range,
    /// Outside of this a colleague would ask.
    pub usual: Range,
    /// Alarm (or message) for a value outside `range` or missing.
    pub alarm: Option<crate::diagnostic::Code>,
    /// First rule that holds decides; none: not used.
    pub needs: &'static [Need],
    /// Variants that are chosen by giving it (even 0), in a cycle that has no parameter for the variant (NCT: the address
    /// of the tool axis makes a boss out of a bore). The first that holds counts.
    pub chooses: &'static [Chooses],
    /// Wording that differs by variant: stem of the first that holds, else [`Param::key`].
    pub labels: &'static [(When, &'static str)],
    /// Place in the manual.
    pub source: &'static str,
}

/// A variant that an address chooses.
pub struct Chooses {
    /// Where it does so.
    pub when: When,
    /// Number of the variant.
    pub variant: i64,
    /// A value as typed that does it.
    pub typed: &'static str,
}

/// What can be entered.
pub enum Kind {
    /// Real number.
    Real,
    /// Whole number.
    Integer,
    /// One of these numbers, each with the key of its name.
    Choice(&'static [(i64, &'static str)]),
    /// The same where other values decide what can be chosen: the first list whose condition holds.
    ChoiceBy(&'static [(When, &'static [(i64, &'static str)])]),
    /// One of these numbers, without a unit, in the variants for which the condition holds; else a real number.
    ChoiceIf(When, &'static [(i64, &'static str)]),
    /// The measuring variant: choices are the cycle's variants; where its digits are choices of their own, the groups.
    Variant(&'static [DigitGroup]),
    /// A number whose digits are choices of their own.
    Digits(&'static [DigitGroup]),
    /// Correction target `_KNUM`: a tool offset code or a zero offset code, decided by the variant.
    Knum,
    /// Text of at most this many characters.
    Text(usize),
}

/// A group of digits of a coded number.
pub struct DigitGroup {
    /// Key of its name.
    pub key: &'static str,
    /// Value of its lowest digit: 1, 10, 100, …
    pub place: i64,
    /// How many digits.
    pub digits: u32,
    /// Named values; empty: any number of that many digits.
    pub choices: &'static [(i64, &'static str)],
}

/// Unit of a parameter and the system it counts in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// No unit.
    None,
    /// mm or inch by the active G70/G71/G700/G710 (NCT: G20/G21).
    ActiveLength,
    /// mm or inch by the basic system of the machine.
    BasicLength,
    /// Always mm, also on an inch machine (`_FA`).
    Millimetre,
    /// Degree.
    Degree,
    /// mm/min or inch/min by the basic system (NCT: active system).
    BasicFeed,
}

/// Range of a number. `f64::NEG_INFINITY`/`INFINITY` for an open end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Lower end.
    pub min: f64,
    /// Whether `min` itself is allowed.
    pub min_included: bool,
    /// Upper end.
    pub max: f64,
    /// Whether `max` itself is allowed.
    pub max_included: bool,
}

impl Range {
    /// Any finite number.
    pub const ANY: Range = Range {
        min: f64::NEG_INFINITY,
        min_included: false,
        max: f64::INFINITY,
        max_included: false,
    };
    /// Greater than 0.
    pub const POSITIVE: Range = Range {
        min: 0.0,
        ..Range::ANY
    };
    /// 0 or greater.
    pub const NOT_NEGATIVE: Range = Range {
        min: 0.0,
        min_included: true,
        ..Range::ANY
    };

    /// From `min` to `max`, both allowed.
    pub const fn closed(min: f64, max: f64) -> Range {
        Range {
            min,
            min_included: true,
            max,
            max_included: true,
        }
    }

    /// Whether the number lies inside; NaN never does.
    pub fn contains(&self, value: f64) -> bool {
        let low = value > self.min || (self.min_included && value == self.min);
        let high = value < self.max || (self.max_included && value == self.max);
        low && high
    }
}

/// Whether a parameter is needed, under a condition.
pub struct Need {
    /// Condition.
    pub when: When,
    /// Consequence.
    pub level: Level,
    /// Key of the reason, shown at the field (`need-tool-offset`).
    pub reason: &'static str,
}

/// How much a parameter is needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Has to be given.
    Required,
    /// May be given.
    Optional,
}

/// A condition on the values of a call. Data, so that docs can print it.
pub enum When {
    /// Always.
    Always,
    /// The measuring variant is one of these.
    Variant(&'static [i64]),
    /// The number of this parameter, divided by `place` (whole), modulo 10, is one of these.
    Digit {
        /// Parameter.
        param: &'static str,
        /// 1, 10, 100, …
        place: i64,
        /// Accepted digits.
        is: &'static [i64],
    },
    /// The parameter is given and not zero (a text: not empty).
    Given(&'static str),
    /// The number of this parameter is one of these.
    Number {
        /// Parameter.
        param: &'static str,
        /// Accepted numbers.
        is: &'static [f64],
    },
    /// The number of this parameter is larger.
    Above {
        /// Parameter.
        param: &'static str,
        /// Than this.
        than: f64,
    },
    /// A datum of the machine, one of [`Cycle::settings`], has one of these values; unset data are 0.
    Setting {
        /// Datum.
        name: &'static str,
        /// Accepted numbers.
        is: &'static [f64],
    },
    /// The type of the tool in use (`$TC_DP1`) lies between these numbers, both included.
    ToolType(i64, i64),
    /// The working plane is this one.
    Plane(crate::control::Plane),
    /// All of these.
    All(&'static [When]),
    /// One of these.
    Any(&'static [When]),
    /// Not this.
    Not(&'static When),
}

/// One datum that a cycle leaves.
pub struct ResultField {
    /// `_OVR[4]`, `_OVI[0]`; NCT: `deviation`, …
    pub name: &'static str,
    /// Key of its meaning.
    pub key: &'static str,
    /// When it is set.
    pub when: When,
    /// Unit.
    pub unit: Unit,
    /// Place in the manual.
    pub source: &'static str,
}

/// A nominal part with a start position from which the cycle may be called.
#[derive(Clone, Debug, Default)]
pub struct Proposal {
    /// Nominal part in machine coordinates; errors are added by the caller.
    pub workpiece: Workpiece,
    /// What stands beside it and can be touched too, machine coordinates; it has no errors.
    pub fixture: Vec<Solid>,
    /// Protection zones, machine coordinates, to be shown and not touched: a shaft, a web or an island whose walls
    /// part where the probe may go from where it may not.
    pub zones: Vec<Solid>,
    /// Position of the ball centre in the active WCS at the call, X Y Z, mm.
    pub start: [f64; 3],
    /// Tools that the call corrects, for a machine that has none yet.
    pub tools: Vec<ProposedTool>,
    /// Tool probes, machine coordinates, for a machine that has none yet; errors are added by the caller.
    pub tool_probes: Vec<ToolProbe>,
    /// How the tool in use lies, where its data do not tell it.
    pub real_tool: Option<Tool>,
}

/// A tool with one edge.
#[derive(Clone, Debug)]
pub struct ProposedTool {
    /// T number.
    pub tool: i64,
    /// Name under tool management.
    pub name: String,
    /// D number.
    pub edge: i64,
    /// Its data.
    pub data: crate::control::Edge,
}
