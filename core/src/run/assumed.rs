//! A run on a machine that nobody described. It fits the program as well as it can be known: its sort and plane follow
//! from the calls, a tool is made when it is selected and becomes a probe when a call measures with it, and at each
//! call stands the part that its values describe. What was assumed is told.

use super::{Interpreter, Limits, Outcome, Session, call, outcome::set};
use crate::check::variants;
use crate::control::{Edge, LATHE_PROBE, MachineSort, Plane, Tool, probe::PROBE};
use crate::dialect::Dialect;
use crate::entry::{Cycle, Inputs, ProbeUse, Proposal, Typed};
use crate::geometry::{Degrees, Mcs, Rpy, V3, rigid};
use crate::machine::{Setup, Sim, Step, probe_data, probe_place};
use crate::message::Message;
use crate::program::calls::{CallSite, calls};
use crate::syntax::programs::programs;
use crate::syntax::tree::{Program, Word, WordKind};
use crate::workpiece::{Solid, ToolProbe, Workpiece, tool::Tool as RealTool};
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// Type of an end mill.
const MILL: i64 = 120;
/// Type of a turning tool.
const TURNING_TOOL: i64 = 500;
/// Most solids of the part that is shown.
const SHOWN: usize = 50;
/// A difference that is none, mm.
const NONE: f64 = 1e-6;

/// What a program came with and what was assumed for it.
pub struct Assumed {
    /// The machine before the first block, with every tool and every part that was made.
    pub setup: Setup,
    /// What the program did.
    pub outcome: Outcome,
    /// What was assumed.
    pub told: Vec<Message>,
}

/// Runs a program on a machine that fits it.
pub fn run(program: &Program, limits: Limits) -> Assumed {
    run_on(program, start(program, None), limits)
}

/// Runs a program on a machine that fits it, prepared with more than the program, telling how far it is. `main`: the
/// program of the text that is run, where the preparation names one.
pub fn run_with(
    program: &Rc<Program>,
    main: Option<&str>,
    limits: Limits,
    prepare: impl FnOnce(Session) -> Session,
    told: &mut dyn FnMut(&Session),
) -> Assumed {
    let setup = start(program, main);
    carried_out(prepare(Session::new(Rc::clone(program), &setup, limits)), setup, told)
}

/// Runs a program on this machine with what it lacks.
pub fn run_on(program: &Program, setup: Setup, limits: Limits) -> Assumed {
    carried_out(Session::new(Rc::new(program.clone()), &setup, limits), setup, &mut |_| {})
}

fn carried_out(mut session: Session, mut setup: Setup, told: &mut dyn FnMut(&Session)) -> Assumed {
    session.run.assumed = Some(Made::default());
    let mut messages = Vec::from_iter((!session.is_over()).then(|| machine(&setup)));
    session.go_on(told);
    let made = session.run.assumed.take().unwrap_or_default();
    let mut outcome = session.outcome();
    for ((tool, edge), data) in made.tools {
        let name = outcome.control.tools.get(&tool).map_or(String::new(), |tool| tool.name.clone());
        messages.push(told_tool((tool, edge), &name, &data));
        for control in [&mut setup.control, &mut outcome.before] {
            let tool = control.tools.entry(tool).or_default();
            tool.name.clone_from(&name);
            tool.edges.insert(edge, data.clone());
        }
    }
    messages.extend(made.told);
    setup.workpiece.solids = made.parts;
    setup.workpiece.solids.truncate(SHOWN);
    setup.tool_probes = made.tool_probes;
    Assumed { setup, outcome, told: messages }
}

/// The machine that the calls need, before the first block of the program with this name, else of the first one.
fn start(program: &Program, main: Option<&str>) -> Setup {
    let sites = calls(program);
    let measures_turned = sites.iter().any(|site| site.cycle.purpose.machine == MachineSort::Turning);
    let turning = measures_turned || sites.is_empty() && turns(program);
    let mut setup = Setup::calibrated(program.dialect, if turning { Plane::G18 } else { Plane::G17 });
    if turning {
        setup.make_turning();
    }
    for site in sites.iter().rev() {
        setup.suit(site.cycle, variants::chosen(site.cycle, &site.values, &setup.control).unwrap_or(0));
    }
    if turning {
        setup.position = Mcs([250.0, 0.0, 250.0]); // no program of a lathe moves along Y
    }
    let own = main.and_then(|name| programs(program).named(&name.to_uppercase()).cloned());
    let within = |site: &&CallSite| own.as_ref().is_none_or(|own| own.blocks.contains(&(site.line as usize)));
    let mut measuring = sites.iter().filter(|site| site.cycle.purpose.probe.measures());
    let first = measuring.clone().find(within).or_else(|| measuring.next());
    if first.is_some_and(|site| site.cycle.purpose.probe == ProbeUse::Workpiece) {
        (setup.control.tool, setup.control.edge) = probe_place(setup.control.make());
    }
    setup
}

/// Whether a program without measuring calls is one for a lathe: it has diameters or a constant cutting speed.
fn turns(program: &Program) -> bool {
    let cutting = |word: &Word| program.constant(word, "G") == Some(96.0);
    let limit = |word: &Word| matches!(&word.kind, WordKind::Assign { name, .. } if program.is(*name, "LIMS"));
    let diameters = |word: &Word| program.is_call(word, &["DIAMON", "DIAM90"]);
    let sinumerik = program.dialect == Dialect::Sinumerik;
    sinumerik && program.words.iter().any(|word| cutting(word) || limit(word) || diameters(word))
}

/// What is said of the machine as a whole.
fn machine(setup: &Setup) -> Message {
    let sort = match setup.control.make().registers {
        true => "assumed-nct",
        false if setup.control.all_as_turning_tools() => "assumed-turning",
        false => "assumed-milling",
    };
    let plane = format!("{:?}", setup.control.plane);
    placed(Message::new("assumed-machine").text("sort", sort).text("plane", plane), setup.position)
}

/// With a position, to a thousandth.
fn placed(message: Message, at: Mcs) -> Message {
    let names = ["x", "y", "z"].into_iter().zip(at.0);
    names.fold(message, |message, (name, value)| message.number(name, (value * 1e3).round() / 1e3))
}

/// What is said of a tool with this name that was made.
fn told_tool((tool, edge): (i64, i64), name: &str, data: &Edge) -> Message {
    let place = match (tool, name) {
        (0, _) => format!("H{edge}"),
        (_, "") => format!("T{tool} D{edge}"),
        _ => format!("T{tool} \"{name}\" D{edge}"),
    };
    let sort = match data.kind {
        PROBE | LATHE_PROBE => "assumed-probe",
        500..=599 => "assumed-turning-tool",
        _ => "assumed-mill",
    };
    let told = Message::new("assumed-tool").text("tool", place).text("sort", sort);
    told.number("length", data.length[0]).number("radius", data.radius)
}

/// What was made on the way.
#[derive(Default)]
pub(super) struct Made {
    /// Edges of tools, by T and D number (NCT: 0 and the register).
    tools: BTreeMap<(i64, i64), Edge>,
    /// The parts of the calls, machine coordinates.
    parts: Vec<Solid>,
    tool_probes: Vec<ToolProbe>,
    told: Vec<Message>,
    lines: BTreeSet<u32>,
}

impl Made {
    /// Puts the part of a call where it can be measured, with the tools and tool probes that it needs.
    fn part(&mut self, sim: &mut Sim, inputs: &Inputs) {
        let Some(work) = inputs.cycle.work() else { return };
        let proposal = (work.propose)(inputs, &sim.control);
        for tool in &proposal.tools {
            let there = sim.control.tools.entry(tool.tool).or_default();
            if there.name.is_empty() {
                there.name.clone_from(&tool.name);
            }
            if let Entry::Vacant(free) = there.edges.entry(tool.edge) {
                free.insert(tool.data.clone());
                self.tools.insert((tool.tool, tool.edge), tool.data.clone());
            }
        }
        let line = sim.line.unwrap_or(0);
        let recorded = std::mem::take(&mut sim.trace);
        let found = place(sim, inputs, &proposal);
        sim.trace = recorded;
        let Some((stand, measures)) = found else { return };
        let shown = stand.tool_probes.first().map(|probe| probe.solid.at);
        let at = stand.part.first().map(|solid| solid.at).or(shown).unwrap_or_default();
        let new = stand.part.iter().filter(|solid| !self.parts.contains(solid));
        self.parts.extend(new.cloned().collect::<Vec<_>>());
        self.tool_probes.clone_from(&stand.tool_probes);
        stand.put(sim);
        if self.lines.insert(line) {
            let key = match (measures, shown) {
                (false, _) => "assumed-no-part",
                (true, None) => "assumed-part",
                (true, Some(_)) => "assumed-tool-probe",
            };
            let told = Message::new(key).number("line", f64::from(line + 1));
            self.told.push(placed(told.text("cycle", inputs.cycle.name), at));
        }
    }
}

/// What stands on the machine at a call.
#[derive(Clone)]
struct Stand {
    part: Vec<Solid>,
    tool_probes: Vec<ToolProbe>,
    real_tool: Option<RealTool>,
    /// Where the proposal lets the call begin, machine coordinates.
    start: V3,
}

impl Stand {
    fn put(self, sim: &mut Sim) {
        sim.equip(Workpiece { solids: self.part }, self.tool_probes, self.real_tool);
    }

    fn solids(&mut self) -> impl Iterator<Item = &mut Solid> {
        self.part.iter_mut().chain(self.tool_probes.iter_mut().map(|probe| &mut probe.solid))
    }

    /// What stands there, turned half about the applicate at its first solid: for who comes from the other side.
    fn turned(mut self, sim: &Sim) -> Stand {
        let [_, _, applicate] = sim.control.plane.axes();
        let turn = rigid::rotation(Rpy::about(applicate, Degrees(180.0)));
        let Some(centre) = self.solids().next().map(|solid| V3::from(solid.at)) else { return self };
        self.start = centre + turn * (self.start - centre);
        for solid in self.solids() {
            solid.at = (centre + turn * (V3::from(solid.at) - centre)).into();
            solid.rotation = rigid::angles(&(turn * rigid::rotation(solid.rotation)));
        }
        self
    }

    fn moved(mut self, way: V3) -> Stand {
        self.solids().for_each(|solid| solid.at = (V3::from(solid.at) + way).into());
        self
    }
}

/// How a call ends: first whether it does, then without alarms, then with the least difference from its setpoints.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
struct Grade(usize, f64);

/// What a call measures, moved to where the probe (or the tool) stands along those axes along which the call then finds
/// what it was told; none: it finds that already on what stands there, or measures nothing.
fn place(sim: &Sim, inputs: &Inputs, proposal: &Proposal) -> Option<(Stand, bool)> {
    let proposed = Stand {
        part: proposal.workpiece.solids.iter().chain(&proposal.fixture).cloned().collect(),
        tool_probes: proposal.tool_probes.clone(),
        real_tool: proposal.real_tool.clone(),
        start: sim.control.to_machine(proposal.start).0.into(),
    };
    let empty = proposed.part.is_empty() && proposed.tool_probes.is_empty();
    if empty || grade(sim.clone(), inputs) <= Grade(0, NONE) {
        return None;
    }
    let mut best: Option<(Grade, Stand)> = None;
    let moved = |stand: Stand| {
        let away = V3::from(sim.position.0) - stand.start;
        let along = move |axes: usize| V3::from_fn(|axis, _| if axes >> axis & 1 == 1 { away[axis] } else { 0.0 });
        // along all axes first, along none last
        [7, 3, 5, 6, 1, 2, 4, 0].into_iter().map(move |axes| stand.clone().moved(along(axes)))
    };
    for stand in moved(proposed.clone()).chain(moved(proposed.turned(sim))) {
        let mut tried = sim.clone();
        stand.clone().put(&mut tried);
        let grade = grade(tried, inputs);
        let better = |known: Grade| grade.0 < known.0 || grade.0 == known.0 && grade.1 < known.1 - NONE;
        if best.as_ref().is_none_or(|(known, _)| better(*known)) {
            best = Some((grade, stand));
        }
        if grade <= Grade(0, NONE) {
            break; // none is better
        }
    }
    best.map(|(grade, stand)| (stand, grade.0 < 2))
}

fn grade(mut sim: Sim, inputs: &Inputs) -> Grade {
    let ended = call::perform(&mut sim, inputs).is_ok();
    let steps = || sim.trace.entries.others().map(|other| other.step);
    let alarms = steps().any(|step| matches!(step, Step::Alarm(_)));
    let difference =
        |key: &str| key.starts_with("result-") && key.contains("difference") && !key.contains("dimensional");
    let tells = |name: &str| inputs.cycle.results.iter().any(|field| field.name == name && difference(field.key));
    let differences = steps().filter_map(set).filter(|(name, _)| tells(name)).map(|(_, after)| after.abs());
    Grade(if !ended { 2 } else { usize::from(alarms) }, differences.sum())
}

impl Interpreter {
    /// The number of a tool that is called by name; one that is not there is made, where tools are.
    pub(super) fn tool_named(&mut self, name: &str) -> Option<i64> {
        let control = &mut self.sim.control;
        if let (None, Some(_)) = (control.tool_named(name), &self.assumed) {
            let free = control.free_tool();
            control.tools.insert(free, Tool { name: name.to_owned(), edges: BTreeMap::new() });
        }
        control.tool_named(name)
    }

    /// Makes the edge of a tool that is selected, where tools are made: as long as the probe, which it may become.
    pub(super) fn make_tool(&mut self, tool: i64, edge: i64) {
        let Some(made) = self.assumed.as_mut().filter(|_| tool > 0) else { return };
        let turning = self.sim.control.all_as_turning_tools();
        let edges = &mut self.sim.control.tools.entry(tool).or_default().edges;
        if edge > 0 && !edges.contains_key(&edge) {
            let data = match turning {
                true => Edge { kind: TURNING_TOOL, tip: 3, radius: 0.8, ..probe_data(turning) },
                false => Edge { kind: MILL, radius: 5.0, ..probe_data(turning) },
            };
            edges.insert(edge, data.clone());
            made.tools.insert((tool, edge), data);
        }
    }

    /// Makes what is in use what a cycle needs there, where tools are made: the probe, or a tool that it measures.
    pub(super) fn fit(&mut self, cycle: &'static Cycle, typed: &Typed) {
        let control = &mut self.sim.control;
        let Some(made) = self.assumed.as_mut().filter(|_| control.edge > 0) else { return };
        let (tool, number) = control.active_place();
        let edge = control.edge_of(tool, number).cloned().unwrap_or_default();
        let is_probe = [PROBE, LATHE_PROBE].contains(&edge.kind);
        let turning = control.all_as_turning_tools();
        let data = match (control.make().registers, cycle.purpose.probe) {
            (true, ProbeUse::Workpiece) if edge.length == [0.0; 3] => {
                Edge { length: [53.0, 0.0, 0.0], ..probe_data(false) }
            }
            (false, ProbeUse::Workpiece) if !is_probe => probe_data(turning),
            (false, ProbeUse::Tool) if is_probe || made.tools.contains_key(&(tool, number)) => {
                let variant = variants::chosen(cycle, typed, control).unwrap_or(0);
                let needed = cycle.simulation.as_ref().and_then(|simulation| simulation.tool(variant));
                let mill = || Edge { kind: MILL, radius: 5.0, ..probe_data(turning) };
                needed.map_or_else(mill, |needed| needed.data)
            }
            _ => return,
        };
        if data.kind == edge.kind && cycle.purpose.probe == ProbeUse::Tool {
            return; // it may have been corrected since
        }
        self.sim.with_length(|control| {
            control.tools.entry(tool).or_default().edges.insert(number, data.clone());
        });
        made.tools.insert((tool, number), data);
    }

    /// Puts the part that a call describes where it is measured, where parts are made.
    pub(super) fn put_part(&mut self, inputs: &Inputs) {
        if let Some(made) = &mut self.assumed {
            made.part(&mut self.sim, inputs);
        }
    }
}
