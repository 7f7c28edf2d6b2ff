//! The simulated machine: moves the probe among the solids and records what happens.

use super::{Clock, Entry, Files, InUse, Machine, MotionKind, Pretended, Route, Setup, Step, Stop, Trace, route::LOOK};
use crate::control::{Control, MachineSort};
use crate::geometry::{Around, Degrees, FARTHEST, Mcs, Wcs};
use crate::message::Message;
use crate::scan::{FORM_POINTS, FORM_POINTS_WITH_BODY, Sent};
use crate::workpiece::{Boundary, Contact, Noise, Probe, Tool, ToolProbe, Workpiece, chuck};
use std::collections::{BTreeMap, BTreeSet};

/// Messages of the program that are told where nothing else of it is recorded.
const MESSAGES: usize = 10_000;

/// A control, a probe and a part, and what has happened so far.
#[derive(Clone, Debug)]
pub struct Sim {
    /// State of the control.
    pub control: Control,
    /// Where the point to which the tool length refers stands, machine coordinates, mm.
    pub position: Mcs,
    /// What happened so far.
    pub trace: Trace,
    /// What was scanned so far.
    pub scans: Vec<Sent>,
    /// Files that the run leaves on the control.
    pub files: Files,
    /// Date and time of the control at the start.
    pub clock: Clock,
    /// How long the motions took so far, s.
    pub seconds: f64,
    /// Line of the program that is being carried out.
    pub line: Option<u32>,
    /// Entries after which a call is given up, and so is the run; motions of the program itself do not count.
    pub trace_limit: usize,
    /// Motions of the program itself, outside of calls, that are recorded.
    pub own_limit: usize,
    /// What the program itself writes and shows, that is recorded.
    pub told_limit: usize,
    /// Entries of the program itself so far: motions, and others.
    own: [usize; 2],
    /// Messages of the program so far, where nothing else of it is recorded.
    messages: usize,
    /// Whether one of these limits is reached: from then on nothing of the program itself is recorded.
    over: bool,
    /// Whether something of the program itself was not recorded.
    pub unrecorded: bool,
    /// Whether something had no room that has to be recorded.
    refused: bool,
    /// Most points that a call may scan.
    pub point_limit: usize,
    /// Whether nothing is recorded.
    quiet: bool,
    /// Machines of the cycle that measures a workpiece now: then the probe is in use whatever the tool data say.
    pub measuring: Option<MachineSort>,
    probe: Probe,
    /// The part where it stands now.
    part: Boundary,
    /// The part as it is clamped, rotary axes and the spindle of a turning machine at 0.
    clamped: Workpiece,
    /// How far the spindle of a turning machine has turned the part.
    turned: Degrees,
    /// How the spindle that holds a turning machine's probe stands: milling cycles alone turn it.
    held_at: Degrees,
    noise: Noise,
    tool_probes: Vec<ToolProbe>,
    /// Tools as they are, by T and D number: those that were told, and others as they were when they were first moved.
    real_tools: BTreeMap<(i64, i64), Tool>,
    /// Tools that were told.
    told_tools: BTreeSet<(i64, i64)>,
    /// Whether a turning tool that was not told lies mirrored in the ordinate now; see [`Sim::recode`].
    recoded: bool,
    tool_noise: Noise,
    /// Where the last measuring motion ended, at its signal or without one; WCS of that moment, mm.
    pub skipped: Option<Wcs>,
    /// Whether part and tool probes are assumed; see [`Sim::equip`].
    gives_way: bool,
    /// Whether a measuring cycle is running.
    pub in_cycle: bool,
    /// What of a measurement only seems so.
    pub pretended: Pretended,
    /// Measuring in JOG: nobody cuts, so a tool that meets the part is a collision, and only a probe measures it.
    pub in_jog: bool,
    /// No axis moves, though it is drawn where it would go: nothing is hit.
    pub still: bool,
    /// Way so far with the signal of the probe watched, mm.
    watched: f64,
    /// Whether the last signal came from a contact.
    touching: bool,
    /// Whether the stylus touched instead of the ball since this was last asked for.
    stylus_touched: bool,
    /// Feed of which the deflection of the probe was told last, mm/min.
    deflected_at: BTreeSet<u64>,
    /// What was looked at on arcs, and by a heavy part outside of cycles, since last asked for; see [`Route::search`].
    effort: usize,
}

impl Sim {
    /// A machine as set up, nothing recorded.
    pub fn new(setup: &Setup) -> Sim {
        Sim {
            control: setup.control.clone(),
            position: setup.position,
            trace: Trace::default(),
            scans: Vec::new(),
            files: Files::default(),
            clock: setup.clock,
            seconds: 0.0,
            line: None,
            trace_limit: usize::MAX,
            own_limit: usize::MAX,
            told_limit: usize::MAX,
            own: [0; 2],
            messages: 0,
            over: false,
            unrecorded: false,
            refused: false,
            point_limit: if setup.probe.body.is_some() { FORM_POINTS_WITH_BODY } else { FORM_POINTS },
            quiet: false,
            measuring: None,
            probe: setup.probe,
            part: Boundary::of(&on_table(&setup.control, &setup.workpiece, Degrees(0.0))),
            clamped: setup.workpiece.clone(),
            turned: Degrees(0.0),
            held_at: Degrees(0.0),
            noise: Noise::new(setup.probe.repeatability.1),
            tool_noise: self::tool::noise(&setup.tool_probes),
            tool_probes: setup.tool_probes.clone(),
            real_tools: setup.real_tools.clone(),
            told_tools: setup.real_tools.keys().copied().collect(),
            recoded: false,
            skipped: None,
            gives_way: false,
            in_cycle: false,
            pretended: Pretended::default(),
            in_jog: false,
            still: false,
            watched: 0.0,
            touching: true,
            stylus_touched: false,
            deflected_at: BTreeSet::new(),
            effort: 0,
        }
    }

    /// Motion to a machine position, straight or round an axis; see [`Machine::travel`].
    pub(crate) fn travel_machine(
        &mut self,
        to: Mcs,
        around: Option<Around<Mcs>>,
        kind: MotionKind,
        feed: f64,
        monitored: bool,
    ) -> Result<(), Stop> {
        let way = Route { from: self.position, to, around };
        self.admit(&way)?;
        if self.still || (monitored && !self.pretended.whole) {
            self.go(&way, kind, feed);
            return Ok(());
        }
        let mut hit = if self.has_probe() { self.obstacle(&way) } else { self.tool_stopped(&way) };
        if hit.is_some() && self.gives_way && !monitored && !self.in_cycle {
            self.equip(Workpiece::default(), Vec::new(), None);
            hit = None;
        }
        let free = hit.map_or(way, |hit| way.until(hit.part, hit.stop));
        if monitored && self.false_signal(&free, kind, feed).is_some() {
            return Err(Stop::Alarm(self.collision()));
        }
        self.go(&free, kind, feed);
        let Some(hit) = hit else { return Ok(()) };
        if !monitored || !hit.by.switches() {
            return Err(self.crash(&hit));
        }
        self.switched(&hit);
        Err(Stop::Alarm(self.collision()))
    }

    /// Straight measuring motion to a machine position; see [`Machine::probe`].
    pub(crate) fn probe_machine(&mut self, to: Mcs, feed: f64) -> Result<Option<Mcs>, Stop> {
        let from = self.position;
        let latched = self.seek(to, feed)?.map(|at| self.pretended.latched(from, to, at));
        self.skipped = Some(self.control.to_workpiece(latched.unwrap_or(to)));
        Ok(latched)
    }

    /// How much was looked at since the last question, beyond what any motion takes.
    pub fn effort(&mut self) -> usize {
        std::mem::take(&mut self.effort)
    }

    /// Goes on behind a signal to the end of the motion: the stylus gives way (`MEAW`).
    pub fn press_on(&mut self, to: Mcs, feed: f64) {
        self.go(&Route::straight(self.position, to), MotionKind::Measuring, feed);
    }

    /// Puts another part (given as while the rotary axes stand at 0), other tool probes and the tool in use as it lies.
    /// They are assumed: a motion that nobody watches goes through them, and they are gone.
    pub fn equip(&mut self, part: Workpiece, tool_probes: Vec<ToolProbe>, real_tool: Option<Tool>) {
        self.clamped = part;
        self.stands();
        self.tool_noise = self::tool::noise(&tool_probes);
        self.tool_probes = tool_probes;
        self.gives_way = true;
        if let Some(tool) = real_tool {
            self.real_tools.entry(self.control.active_place()).or_insert(tool);
        }
    }

    /// The part as rotary axes and spindle have turned it, which from now on is what can be touched.
    fn stands(&mut self) -> Workpiece {
        let part = on_table(&self.control, &self.clamped, self.turned);
        self.part = Boundary::of(&part);
        part
    }

    fn go(&mut self, way: &Route, kind: MotionKind, feed: f64) {
        self.position = way.to;
        self.seconds += way.seconds(feed);
        self.note(Step::Motion { kind, from: way.from, to: way.to, around: way.around, feed });
    }

    /// Changes what decides over the tool length; the spindle nose stays where it is.
    pub fn with_length<T>(&mut self, change: impl FnOnce(&mut Control) -> T) -> T {
        let before = self.control.active_length();
        let outcome = change(&mut self.control);
        let after = self.control.active_length();
        self.position = self.position + before + -after;
        outcome
    }

    /// Adds a step to the trace, with the present line.
    pub fn note(&mut self, step: Step) {
        if self.quiet {
            return;
        }
        let told = !self.in_cycle && self.tells(&step);
        let own = !self.in_cycle && step.may_be_left_out() && !told;
        let motion = own && matches!(step, Step::Motion { .. });
        let full = self.full() && !motion;
        if own {
            let [count, limit] = if motion { [self.own[0], self.own_limit] } else { [self.own[1], self.told_limit] };
            self.over |= full || count >= limit;
            if self.over {
                self.unrecorded = true;
                self.trace.leave_out(step);
                return;
            }
            self.own[usize::from(!motion)] += 1;
        }
        if full {
            self.refused = true;
            return;
        }
        let in_use = self.in_use();
        self.trace.record(Entry { line: self.line, step, in_use });
    }

    /// Counts a message of the program; true: it is told where nothing else of the program itself is recorded, as
    /// whether it stops, and why, is what is looked for. A loop without an end says it over and over.
    fn tells(&mut self, step: &Step) -> bool {
        let message = self.told_limit == 0 && matches!(step, Step::Message { .. });
        self.messages += usize::from(message);
        message && self.messages <= MESSAGES
    }

    /// Entries of the program itself so far.
    pub fn recorded(&self) -> usize {
        self.own.iter().sum()
    }

    /// Most entries that the trace may have now.
    pub fn room_for(&self) -> usize {
        self.trace_limit.saturating_add(self.own[0])
    }

    /// Whether the trace has no room.
    fn full(&self) -> bool {
        self.trace.entries.len() >= self.room_for()
    }

    /// Where in the trace stands what is in use now.
    fn in_use(&mut self) -> usize {
        let known = self.trace.in_use.iter().rposition(|one| one.lasts(self));
        known.unwrap_or_else(|| {
            self.trace.in_use.push(InUse::of(self));
            self.trace.in_use.len() - 1
        })
    }

    /// Index of the axis along which the tool stands: the applicate.
    pub fn tool_axis(&self) -> usize {
        self.control.plane.axes()[2]
    }

    /// Distance of a point from the part, negative inside.
    pub fn distance(&self, point: Mcs) -> f64 {
        self.part.distance(point)
    }

    /// Refuses to go on where the trace is full, unless what comes now need not be recorded.
    pub(crate) fn room(&self) -> Result<(), Stop> {
        if self.refused || self.full() && self.in_cycle {
            return Err(Stop::Fault(Message::new("run-trace-limit").number("limit", self.trace_limit as f64)));
        }
        Ok(())
    }

    /// Whether a motion may begin: the trace has room, the axes may take all its positions.
    fn admit(&mut self, way: &Route) -> Result<(), Stop> {
        self.room()?;
        self.hold();
        if self.measuring.is_none() {
            self.effort += LOOK * self.part.weight().saturating_sub(1);
        }
        let length = self.control.active_length();
        let problem = if !way.to.iter().all(|value| value.is_finite()) {
            Message::new("run-not-finite")
        } else if !way.is_near() || length.iter().any(|length| length.abs() > FARTHEST) {
            Message::new("run-far").number("limit", FARTHEST)
        } else if !way.within_limits(&self.control) {
            Message::new("run-limit")
        } else {
            return Ok(());
        };
        Err(Stop::Fault(problem))
    }
}

/// The part as the rotary axes and, so far, the spindle of a turning machine turn it.
fn on_table(control: &Control, clamped: &Workpiece, turned: Degrees) -> Workpiece {
    let solids = clamped.solids.iter().map(|solid| control.on_table(&chuck::turned(solid, turned)));
    Workpiece { solids: solids.collect() }
}

impl Machine for Sim {
    fn control(&mut self) -> &mut Control {
        &mut self.control
    }

    fn position(&self) -> Wcs {
        self.control.to_workpiece(self.position)
    }

    fn travel(&mut self, to: Wcs, kind: MotionKind, feed: f64, monitored: bool) -> Result<(), Stop> {
        self.travel_machine(self.control.to_machine(to), None, kind, feed, monitored)
    }

    fn travel_around(
        &mut self,
        to: Wcs,
        around: &Around<Wcs>,
        kind: MotionKind,
        feed: f64,
        monitored: bool,
    ) -> Result<(), Stop> {
        let on_machine = around.mapped(|point| self.control.to_machine(point));
        let around = on_machine.ok_or_else(|| Stop::Fault(Message::new("run-arc")))?;
        let to = self.control.to_machine(to);
        self.travel_machine(to, Some(around), kind, feed, monitored)
    }

    fn probe(&mut self, to: Wcs, feed: f64) -> Result<Option<Wcs>, Stop> {
        let latched = self.probe_machine(self.control.to_machine(to), feed)?;
        Ok(latched.map(|position| self.control.to_workpiece(position)))
    }

    fn in_contact(&self) -> bool {
        let ball = self.position + self.ball();
        let contact = self.part.first(self.probe.radius, ball, ball);
        matches!(contact, Contact::Already(..))
    }

    fn signal_stands(&self) -> bool {
        self.touching
    }

    fn correct(&mut self, name: &str, value: f64) {
        if self.corrects() {
            self.with_length(|control| control.set_variable(name, value));
        }
    }

    fn corrects(&self) -> bool {
        self.pretended.whole || !self.in_cycle
    }

    fn reports(&self) -> bool {
        self.pretended.whole
    }

    fn select(&mut self, edge: i64) {
        self.with_length(|control| control.edge = edge);
    }

    fn orient(&mut self, angle: Degrees) {
        self.control.spindle = angle;
        self.control.spindle_speed = 0.0;
        match (self.in_turret(), self.measuring) {
            (false, _) => {}
            (true, Some(MachineSort::Milling)) => self.held_at = angle,
            (true, _) => {
                self.turned = angle;
                self.stands();
            }
        }
        self.note(Step::Orient { angle });
    }

    fn quiet(&mut self, on: bool) {
        self.quiet = on;
    }

    fn point_limit(&self) -> usize {
        self.point_limit
    }

    fn send(&mut self, scan: Sent) {
        self.scans.push(scan);
    }

    fn files(&mut self) -> &mut Files {
        &mut self.files
    }

    fn now(&self) -> Clock {
        self.clock.after(self.seconds)
    }

    fn spin(&mut self, speed: f64) {
        if self.control.spindle_speed != speed {
            self.control.spindle_speed = speed;
            self.note(Step::Spin { speed });
        }
    }

    fn record(&mut self, step: Step) {
        self.note(step);
    }
}

mod probe;
pub mod state;
mod table;
mod tool;

#[cfg(test)]
mod tests;
