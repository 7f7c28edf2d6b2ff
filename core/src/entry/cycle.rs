//! The shape of a catalogue entry. Plain data, read by form, check, program, docs and run.

use super::{Drawing, Kind, NEVER, Param, Scan, Simulation, Unit, When, Work};
use crate::control::{Control, MachineSort};
use crate::diagnostic::{Code, Diagnostic};
use crate::dialect::Dialect;
use crate::entry::Inputs;
use crate::name::Name;
use crate::own;
use serde::Serialize;

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
    /// What its variants are for: by this they are found.
    pub aims: super::Aims,
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
    pub checks: fn(&Inputs, &Control, &mut Vec<Diagnostic>),
    /// The help page of each variant.
    pub help: super::help::Help,
    /// What the values mean, drawn.
    pub picture: Drawing,
    /// What a variant's worked measurement has beside that of its parameters, or instead.
    pub examples: super::Examples,
    /// What happens at the call; none while only form, checks and text are known. See [`Cycle::work`].
    pub simulation: Option<Simulation>,
    /// Place in the manual.
    pub source: &'static str,
}

/// Entries are told apart by their names.
impl PartialEq for Cycle {
    fn eq(&self, other: &Cycle) -> bool {
        (self.dialect, self.name) == (other.dialect, other.name)
    }
}

impl std::fmt::Debug for Cycle {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

impl Cycle {
    /// Whether it is a measuring cycle, with the user data, the results and the user's programs of SINUMERIK; macros of
    /// NCT have none of these.
    pub fn is_measuring_cycle(&self) -> bool {
        self.dialect == Dialect::Sinumerik && self.purpose.probe.measures()
    }

    /// All alarms, SINUMERIK by number, NCT as listed.
    pub fn alarms(&self) -> Vec<Code> {
        let mut list: Vec<Code> = self.alarms.iter().copied().flatten().copied().collect();
        list.sort_by_key(|code| if let Code::Alarm(number) = code { *number } else { 0 });
        list
    }

    /// Name of the parameter that takes the number of the variant.
    pub fn variant_param(&self) -> Option<Name> {
        self.params.iter().find(|param| matches!(param.kind, Kind::Variant(_))).map(|param| param.name)
    }

    /// A worked measurement: values as typed, by parameter name.
    pub fn example(&self) -> impl Iterator<Item = (Name, &'static str)> {
        self.params.iter().filter(|param| !param.example.is_empty()).map(|param| (param.name, param.example))
    }

    /// What the digits of a variant's number choose: keys of the choices, the lowest place first.
    pub fn choices(&self, number: i64) -> impl Iterator<Item = &'static str> + '_ {
        let groups = self.params.iter().flat_map(|param| match param.kind {
            Kind::Variant(groups) => groups,
            _ => &[],
        });
        groups.filter_map(move |group| group.choice(number))
    }

    /// The cycle at work; none where it is not simulated.
    pub fn work(&self) -> Option<&Work> {
        Some(&self.simulation.as_ref()?.work)
    }

    /// How it scans a surface in pieces; none where it does not.
    pub fn scan(&self) -> Option<Scan> {
        self.simulation.as_ref()?.scan
    }

    /// The result that takes the number of the alarm which the call raised; none: it leaves no such result.
    pub fn alarm_result(&self) -> Option<&'static ResultField> {
        self.results.iter().find(|field| field.key == "result-alarm")
    }

    /// Whether a block that names the G function of this macro is no call of it: it has addresses, and none that the
    /// macro knows. Controls with other macros have other functions of these numbers (`G103 P1`).
    pub fn is_foreign<'a>(&self, addresses: impl IntoIterator<Item = &'a str>) -> bool {
        let others = addresses.into_iter();
        let mut others = others.filter(|name| !["G", "M", "N", "O"].contains(name)).peekable();
        others.peek().is_some() && !others.any(|name| self.param(name).is_some())
    }

    /// What is said of such a block, which names the macro by this word.
    pub fn foreign(&self, word: &str) -> Diagnostic {
        own::NCT_FOREIGN.finding().text("word", word).hint_text("cycle", self.name)
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
    /// Variants whose tool probe is described in the active workpiece system (`_TPW`, B:4186-4196).
    pub in_workpiece: When,
    /// What of it the other control can do too.
    pub tasks: &'static [super::task::Shared],
}

/// The probe that a cycle uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
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

impl Purpose {
    /// Measures workpieces on milling machines.
    pub const MILLING: Purpose = Purpose {
        probe: ProbeUse::Workpiece,
        machine: MachineSort::Milling,
        calibrates: NEVER,
        in_workpiece: NEVER,
        tasks: &[],
    };
    /// Measures workpieces on lathes.
    pub const TURNING: Purpose = Purpose { machine: MachineSort::Turning, ..Purpose::MILLING };

    /// The array with the data of the probe of a call.
    pub fn probe_array(&self, inputs: &Inputs) -> &'static str {
        match (self.probe, self.in_workpiece.holds(inputs)) {
            (ProbeUse::Tool, true) => "_TPW",
            (ProbeUse::Tool, false) => "_TP",
            _ => "_WP",
        }
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

/// A datum that a cycle leaves.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ResultInfo"))]
pub struct ResultField {
    /// `_OVR[4]`, `_OVI[0]`; of NCT a name of ours: `deviation`, …
    pub name: &'static str,
    /// Key of its meaning.
    pub key: &'static str,
    /// When it is set.
    #[serde(skip)]
    pub when: When,
    /// Rule of its unit.
    pub unit: Unit,
    /// Place in the manual.
    pub source: &'static str,
}
