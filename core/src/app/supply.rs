//! What a machine lacks for a program or a call, offered at the finding that says so, and how the machine gets it.

use crate::control::probe::PROBE;
use crate::control::{Control, LATHE_PROBE, MachineSort, Units};
use crate::diagnostic::Code;
use crate::entry::{Cycle, ProbeUse, Typed, names};
use crate::evaluate::knum;
use crate::machine::Setup;
use crate::message::{Arg, Message};
use crate::program::calls::{CallSite, Way, calls_on};
use crate::program::flow::Tool;
use crate::run::{Limits, assumed};
use crate::syntax::Program;
use serde::{Deserialize, Serialize};

/// Type of an end mill.
const MILL: i64 = 120;
/// Type of a turning tool.
const TURNING_TOOL: i64 = 500;
/// The probe meets nothing.
const NOTHING_TOUCHED: Code = Code::Alarm(61301);
/// The tool to be corrected is not there; no tool has its name; it has no such edge.
const NOT_THERE: [Code; 3] = [Code::Alarm(61320), Code::Alarm(61343), Code::Alarm(61410)];

/// What a machine is given.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Supply {
    /// A tool with an edge, or one more edge of a tool.
    Tool(NewTool),
    /// Every tool that the program uses.
    Tools,
    /// Those, and the parts that its calls measure.
    Parts,
}

/// A tool that is not there.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct NewTool {
    /// T number; 0: the next free one, of an NCT control the registers.
    pub tool: i64,
    /// Name under tool management.
    pub name: String,
    /// D number (NCT: H).
    pub edge: i64,
    /// `$TC_DP1`.
    pub kind: i64,
}

/// Something that fixes a finding by giving it to the machine.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Offer {
    /// What it does.
    pub label: Message,
    /// What is given.
    pub supply: Supply,
}

impl Supply {
    /// As a fix.
    pub(super) fn offer(self) -> Offer {
        let label = match &self {
            Supply::Tools => Message::new("supply-tools"),
            Supply::Parts => Message::new("supply-parts"),
            Supply::Tool(new) => new.label(),
        };
        Offer { label, supply: self }
    }
}

impl NewTool {
    fn label(&self) -> Message {
        let place = match (self.tool, self.name.as_str()) {
            (0, "") => format!("H{}", self.edge),
            (tool, "") => format!("T{tool} D{}", self.edge),
            (_, name) => name.to_owned(),
        };
        let key = if [PROBE, LATHE_PROBE].contains(&self.kind) { "supply-probe" } else { "supply-tool" };
        Message::new(key).text("tool", place)
    }
}

/// Whether a problem of a run is that the machine lacks something.
pub(super) fn lacking(problem: &Message) -> bool {
    ["run-no-tool", "run-no-edge"].contains(&&*problem.key)
}

/// Whether an alarm may be that the machine lacks something.
pub(super) fn curable(code: Code) -> bool {
    code == NOTHING_TOUCHED || NOT_THERE.contains(&code)
}

/// What a program asks of a machine.
pub(super) struct Needs<'a> {
    setup: &'a Setup,
    sites: Vec<CallSite>,
}

impl<'a> Needs<'a> {
    /// Of the program that runs on this machine.
    pub fn of(program: &Program, setup: &'a Setup) -> Needs<'a> {
        Needs { setup, sites: calls_on(program, setup.control.clone()) }
    }

    /// What fixes a problem of a run.
    pub fn offers(&self, problem: &Message) -> Vec<Offer> {
        let Some(word) = problem.word("word") else { return Vec::new() };
        let edge = problem.args.iter().find_map(|(name, arg)| match arg {
            Arg::Number(edge) if *name == "edge" => Some(*edge as i64),
            _ => None,
        });
        let new = match (&*problem.key, edge) {
            ("run-no-tool", _) => self.tool(word),
            ("run-no-edge", Some(edge)) => NewTool { edge, ..self.tool(word) },
            _ => return Vec::new(),
        };
        [Supply::Tool(new), Supply::Tools].into_iter().map(Supply::offer).collect()
    }

    /// What fixes an alarm of the call in this line, from 1.
    pub fn offers_at(&self, code: Code, line: Option<u32>) -> Vec<Offer> {
        if code == NOTHING_TOUCHED {
            return vec![Supply::Parts.offer()];
        }
        let site = self.sites.iter().find(|site| line == Some(site.line + 1));
        let new = site.and_then(|site| corrected(code, site.cycle, &site.values, &self.setup.control));
        new.map(|new| Supply::Tool(new).offer()).into_iter().collect()
    }

    /// The tool that a program calls by this number or name; its type follows from what it is used for.
    fn tool(&self, word: &str) -> NewTool {
        let registers = self.setup.control.make().registers;
        let register = word.strip_prefix('H').filter(|_| registers).and_then(|number| number.parse().ok());
        let number = word.parse().ok();
        let uses = || self.sites.iter().flat_map(|site| site.ways.iter().map(move |way| (site, way)));
        let (site, way) = uses().find(|(_, way)| calls(way, word)).unzip();
        let edge = way.and_then(|way: &Way| way.state.edge.is().copied()).filter(|edge| *edge > 0);
        NewTool {
            tool: number.filter(|_| !registers).unwrap_or(0),
            name: if number.is_none() && register.is_none() { word.to_owned() } else { String::new() },
            edge: register.or(edge).unwrap_or(1),
            kind: kind(site.map(|site| site.cycle), &self.setup.control),
        }
    }
}

/// Whether a program comes to a call with the tool of this number or name.
fn calls(way: &Way, word: &str) -> bool {
    match way.state.tool.is() {
        Some(Tool::Number(number)) => word.parse() == Ok(*number),
        Some(Tool::Name(name)) => name.eq_ignore_ascii_case(word),
        None => false,
    }
}

/// Type of a tool that this cycle uses: a probe where it measures a part, else what cuts.
fn kind(cycle: Option<&Cycle>, control: &Control) -> i64 {
    let probes = cycle.is_some_and(|cycle| cycle.purpose.probe == ProbeUse::Workpiece);
    match (probes, turns(cycle, control)) {
        (true, true) => LATHE_PROBE,
        (true, false) => PROBE,
        (false, _) => cutting(cycle, control),
    }
}

/// Type of a tool that cuts.
fn cutting(cycle: Option<&Cycle>, control: &Control) -> i64 {
    if turns(cycle, control) { TURNING_TOOL } else { MILL }
}

/// Whether tools are turning tools there.
fn turns(cycle: Option<&Cycle>, control: &Control) -> bool {
    control.all_as_turning_tools() || cycle.is_some_and(|cycle| cycle.purpose.machine == MachineSort::Turning)
}

/// The tool that a call corrects, where the alarm says that it is not there.
pub(super) fn corrected(code: Code, cycle: &Cycle, values: &Typed, control: &Control) -> Option<NewTool> {
    if !NOT_THERE.contains(&code) {
        return None;
    }
    let value = |name: &str| values.get(name).map(|text| text.trim().trim_matches('"').to_owned()).unwrap_or_default();
    let tool: i64 = value(names::TNUM.as_str()).parse().unwrap_or(0);
    let name = if tool > 0 { String::new() } else { value(names::TNAME.as_str()) };
    let target = value(names::KNUM.as_str()).parse().unwrap_or(0);
    let edge = knum::tool(target, knum::five_digit_edges(control)).ok().flatten().map_or(1, |target| target.edge);
    let named = tool > 0 || !name.is_empty();
    named.then(|| NewTool { tool, name, edge: edge.max(1), kind: cutting(Some(cycle), control) })
}

/// A click asks, and waits.
fn unwatched(program: &Program) -> Limits {
    Limits { own: 0, ..Limits::unwatched(program.blocks.len()) }
}

impl Setup {
    /// The machine with a tool more, or with an edge more of a tool.
    pub(super) fn give_tool(&mut self, new: &NewTool) {
        let data = self.new_edge(new.kind);
        let control = &mut self.control;
        let registers = control.make().registers;
        let number = match (registers, new.tool) {
            (true, _) => 0,
            (false, 0) => control.tool_named(&new.name).unwrap_or_else(|| control.free_tool()),
            (false, number) => number,
        };
        let tool = control.tools.entry(number).or_default();
        if tool.name.is_empty() {
            tool.name.clone_from(&new.name);
        }
        let like = tool.edges.values().next().cloned().filter(|_| !registers);
        // after a tool change D1 is in use until another one is programmed
        let first = (!registers && tool.edges.is_empty()).then_some(1);
        for edge in first.into_iter().chain([new.edge]) {
            tool.edges.entry(edge).or_insert_with(|| like.clone().unwrap_or_else(|| data.clone()));
        }
    }

    /// The machine with what a program uses: the tools that are not there, and with `parts` the parts of its calls.
    pub(super) fn give_all(&mut self, program: &Program, parts: bool) {
        let made = assumed::run_on(program, self.clone(), unwatched(program)).setup;
        for (number, tool) in made.control.tools {
            let own = self.control.tools.entry(number).or_default();
            if own.edges.is_empty() {
                own.name = tool.name;
            }
            for (edge, data) in tool.edges {
                own.edges.entry(edge).or_insert(data);
            }
        }
        if !parts {
            return;
        }
        if !made.workpiece.solids.is_empty() {
            self.workpiece = made.workpiece;
        }
        if self.tool_probes.is_empty() {
            self.tool_probes = made.tool_probes;
        }
    }

    /// The core's own machine becomes the one that fits a program, and keeps the data that were typed.
    pub(super) fn become_of(&mut self, program: &Program) {
        let Control { dialect, plane, basic_units, .. } = self.control;
        let delivered = Setup::calibrated_in(dialect, plane, basic_units).control.data;
        let fits = match basic_units {
            Units::Metric => assumed::run(program, unwatched(program)).setup,
            Units::Inch => assumed::run_on(program, self.clone(), unwatched(program)).setup,
        };
        let own = std::mem::replace(self, fits).control.data;
        for (name, value) in own.iter().filter(|(name, value)| delivered.get(name) != Some(*value)) {
            self.control.data.insert(name.clone(), value.clone());
        }
    }
}
