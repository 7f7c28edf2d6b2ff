//! Measuring in JOG as a page shows it: a session carried out from its script, and what is on the screen and under the
//! hand then.

use super::Error;
use super::changes::Change;
use super::jog::{JogPoint, act, changed, note, stored};
use super::outcome::Raised;
use super::predict::PartSliders;
use super::start::{Machine, start};
use crate::control::{AXES, Control, Plane, ROTARY, Store};
use crate::dialect::Dialect;
use crate::geometry::Rpy;
use crate::jog::activation::Activation;
use crate::jog::chance::Truth;
use crate::jog::mask::{Area, Field, Function, Kind, Mask, Show, key};
use crate::jog::practice::{self, Piece};
use crate::jog::script::{Command, Line, Wrong, read};
use crate::jog::shadow::{Deviation, Shadow};
use crate::jog::states::Key;
use crate::jog::values::{Value, words};
use crate::jog::{FUNCTIONS, Session, State, measures, settings};
use crate::machine::{MotionKind, Setup, Step};
use crate::message::Message;
use crate::refused::Path;
use crate::run::outcome::Outcome;
use crate::scene::Source;
use serde::{Deserialize, Serialize};

/// A session of measuring in JOG.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeRequest {
    /// Control.
    pub control: Dialect,
    /// Machine with its part; absent, and where it has no part or turns: one to practise on.
    pub setup: Option<Machine>,
    /// What lies on the table of the machine to practise on; absent: a block.
    pub piece: Option<Piece>,
    /// What was done, a line a thing.
    pub script: String,
    /// The part lies as chance puts it by this seed; absent: as `part` says.
    pub seed: Option<u32>,
    /// How the part lies: displacement, size and tilt; absent: as in the setup.
    pub part: Option<PartSliders>,
}

/// What is on the screen and under the hand.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeView {
    /// The functions as the softkeys have them.
    pub areas: Vec<PracticeArea>,
    /// What is on the screen.
    pub state: State,
    /// The line at which it ended, as it did nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<PracticeRefusal>,
    /// The alarm that is pending, or what was hit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub raised: Option<Raised>,
    /// What the user should know of the last touch.
    pub notes: Vec<Message>,
    /// The mask that is open.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mask: Option<PracticeMask>,
    /// The activation screen.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub activation: Option<PracticeActivation>,
    /// Keys that do something now.
    pub keys: PracticeKeys,
    /// P1 to P4, where the mask has softkeys for them.
    pub points: Vec<PracticePoint>,
    /// Bits 0 to 7 of the PLC.
    pub plc: [bool; 8],
    /// The machine.
    pub machine: PracticeMachine,
    /// The piece of the machine to practise on; absent: the machine is the user's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub piece: Option<Piece>,
    /// How the part lies.
    pub truth: Truth,
    /// How far the zero offset that the mask wrote is from where it should be.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviation: Option<PracticeDeviation>,
    /// What the mask wrote last.
    pub changes: Vec<Change>,
    /// The machine as it was before all that, its part where it really lies.
    pub setup: Setup,
    /// The first entry of the trace that belongs to the last line.
    pub from: usize,
}

/// A softkey of the vertical bar.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeArea {
    /// What it says.
    pub label: Message,
    /// Its functions.
    pub functions: Vec<PracticeFunction>,
}

/// A function.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeFunction {
    /// Name.
    pub name: &'static str,
    /// Its masks.
    pub masks: Vec<PracticeChoice>,
}

/// A mask that can be opened.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeChoice {
    /// Name in a script.
    pub name: &'static str,
    /// Title.
    pub label: Message,
    /// The piece on which it can be practised.
    pub piece: Piece,
}

/// A line that was not carried out.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeRefusal {
    /// Its number, from 1.
    pub line: u32,
    /// Why.
    pub message: Message,
    /// What helps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hint: Option<Message>,
}

/// A mask with its values.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeMask {
    /// Name in a script.
    pub name: &'static str,
    /// Title.
    pub label: Message,
    /// Fields that are shown, in their order.
    pub fields: Vec<PracticeField>,
    /// Lines of the left part, in their order.
    pub shows: Vec<PracticeShow>,
}

/// A field of a mask or of the activation screen.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeField {
    /// Name in a script.
    pub name: &'static str,
    /// What it is called.
    pub label: Message,
    /// `mm` or `deg` of a number, else empty.
    pub unit: &'static str,
    /// What it holds.
    pub value: Value,
    /// What can be chosen; none: it takes a number.
    pub choices: Vec<PracticeWord>,
    /// What is wrong with it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wrong: Option<Message>,
}

/// A choice.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeWord {
    /// As a script has it.
    pub word: String,
    /// What it is called; absent: as it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub label: Option<Message>,
}

/// A line of the left part.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeShow {
    /// What it is called.
    pub label: Message,
    /// Name of a zero offset, where the line has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub offset: Option<String>,
    /// Numbers, each with the letter of its axis; of a result without one.
    pub figures: Vec<PracticeFigure>,
}

/// A number.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeFigure {
    /// Letter of its axis, or empty.
    pub axis: &'static str,
    /// mm or degree.
    pub value: f64,
    /// `mm` or `deg`.
    pub unit: &'static str,
}

/// The activation screen.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeActivation {
    /// Its lines.
    pub lines: Vec<Message>,
    /// Its fields.
    pub fields: Vec<PracticeField>,
}

/// Which keys do something.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeKeys {
    /// NC start.
    pub start: bool,
    /// RESET.
    pub reset: bool,
    /// Calculate.
    pub calculate: bool,
    /// `<<`.
    pub back: bool,
    /// Another mode.
    pub mode: bool,
}

/// A softkey P1 to P4.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticePoint {
    /// `P1`.
    pub name: String,
    /// What is stored; absent: the softkey is grey.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stored: Option<JogPoint>,
}

/// The machine.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeMachine {
    /// Position X Y Z in the WCS of the measurement, mm.
    pub wcs: [f64; 3],
    /// Position X Y Z of the machine, mm.
    pub mcs: [f64; 3],
    /// The zero offset that is active.
    pub active: String,
    /// Letters of the axes of the plane in which is measured.
    pub axes: [&'static str; 2],
    /// Planes in which can be measured.
    pub planes: Vec<PracticeUse>,
    /// Zero offsets that can be in use while measuring.
    pub offsets: Vec<PracticeUse>,
    /// Whether one is offered because it was activated: no other can be chosen until the area is left.
    pub offered: bool,
    /// What can be in the spindle.
    pub tools: Vec<PracticeUse>,
    /// Whether it is a probe.
    pub probe: bool,
}

/// Something that can be in use.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeUse {
    /// Its name: `G54`; empty: an empty spindle.
    pub name: String,
    /// The line of a script that brings it into use.
    pub line: String,
    /// Whether it is.
    pub used: bool,
}

/// How far a zero offset is from where it should be.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeDeviation {
    /// Its name.
    pub offset: String,
    /// Along the axes, mm, then about them, degree.
    pub figures: Vec<PracticeFigure>,
}

/// Carries out a session; what is to be seen of it begins where the mask was opened.
///
/// # Errors
/// A control that does not measure in JOG, or a machine that cannot be.
pub fn practise(asked: PracticeRequest) -> Result<(PracticeView, Source), Error> {
    if !measures(asked.control) {
        return Err(Error::new("jog-no-jog", Path::of(&["control"])));
    }
    let mut stands = Stands::new(asked.control, asked.setup, asked.piece)?;
    let truth = asked.seed.map_or_else(|| placed(asked.part, &stands.setup), |seed| Truth::by(seed.into()));
    let mut course = Course::new(&mut stands.setup, truth);
    let (lines, wrong) = legible(&asked.script);
    let mut refused = wrong.map(|Wrong { line, message, hint }| PracticeRefusal { line, message, hint: Some(hint) });
    for line in &lines {
        if let Err(message) = course.carry_out(line) {
            refused = Some(PracticeRefusal { line: line.number, message, hint: None });
            break;
        }
    }
    Ok(course.seen(stands, refused))
}

/// The machine on which is practised.
struct Stands {
    setup: Setup,
    piece: Option<Piece>,
}

impl Stands {
    fn new(control: Dialect, machine: Option<Machine>, piece: Option<Piece>) -> Result<Stands, Error> {
        let described = matches!(machine, Some(Machine::File(_)));
        let start = start(control, machine)?;
        let mills = described && !start.setup.workpiece.solids.is_empty() && !start.setup.control.turns();
        let piece = piece.unwrap_or_default();
        Ok(match mills {
            true => Stands { setup: start.setup, piece: None },
            false => Stands { setup: practice::machine(piece), piece: Some(piece) },
        })
    }
}

/// The part as sliders put it: turned about the applicate.
fn placed(part: Option<PartSliders>, setup: &Setup) -> Truth {
    let part = part.unwrap_or_default();
    let [.., applicate] = setup.control.plane.axes();
    let tilt = Rpy::about(applicate, part.tilt);
    Truth { seed: 0, shift: [part.dx, part.dy, part.dz], tilt, size: part.size }
}

/// The lines up to the first that cannot be read.
fn legible(script: &str) -> (Vec<Line>, Option<Wrong>) {
    match read(script) {
        Ok(lines) => (lines, None),
        Err(wrong) => {
            let before = script.lines().take(wrong.line.saturating_sub(1) as usize).collect::<Vec<_>>().join("\n");
            (read(&before).unwrap_or_default(), Some(wrong))
        }
    }
}

/// A session on its way.
struct Course {
    session: Session,
    shadow: Shadow,
    truth: Truth,
    /// The machine as it was when the mask was opened, and how many entries the trace had.
    begun: (Setup, usize),
    /// Entries before the last line.
    last: usize,
    notes: Vec<Message>,
    changes: Vec<Change>,
    deviation: Option<(Store, Deviation)>,
}

impl Course {
    /// Puts the part, too.
    fn new(setup: &mut Setup, truth: Truth) -> Course {
        let shadow = Shadow::new(setup, truth);
        truth.put(setup);
        let session = Session::new(setup);
        let begun = (setup.clone(), 0);
        let (notes, changes) = (Vec::new(), Vec::new());
        let mut course = Course { session, shadow, truth, begun, last: 0, notes, changes, deviation: None };
        course.begin();
        course
    }

    /// What is to be seen begins here: with the tool where it is.
    fn begin(&mut self) {
        let sim = &mut self.session.sim;
        self.begun.0.control = sim.control.clone();
        self.begun.0.position = sim.position;
        self.begun.1 = sim.trace.entries.len();
        let at = sim.position;
        sim.note(Step::Motion { kind: MotionKind::Rapid, from: at, to: at, around: None, feed: 0.0 });
        self.changes.clear();
        self.deviation = None;
    }

    fn carry_out(&mut self, line: &Line) -> Result<(), Message> {
        let from = self.session.sim.position;
        let shown = self.session.outcome().clone();
        let before = self.session.sim.trace.entries.len();
        act(&mut self.session, &line.command)?;
        self.last = before;
        match &line.command {
            Command::Start(false) => self.shadow.measure(from, &self.session),
            Command::Move(..) | Command::Start(true) | Command::Reset | Command::Activate => {
                self.shadow.follow(|_| Ok(()), &self.session);
            }
            other => self.shadow.follow(|session| act(session, other), &self.session),
        }
        let steps: Vec<Step> = self.session.sim.trace.entries.behind(before).map(|entry| entry.step).collect();
        self.notes = steps.iter().filter_map(note).collect();
        let control = &self.session.sim.control;
        let written: Vec<Change> = steps.iter().filter_map(|step| changed(control, step)).collect();
        if self.session.outcome() != &shown && !self.session.outcome().results.is_empty() {
            self.changes.clear();
            let deviation = self.shadow.deviation(&self.session);
            self.deviation = self.session.chosen().zip(deviation);
        }
        self.changes.extend(written);
        let begins = match line.command {
            Command::Mask(_) | Command::Tool(..) => true,
            Command::Back => self.session.mask().is_none(),
            _ => false,
        };
        if begins {
            self.begin();
        }
        Ok(())
    }

    fn seen(self, stands: Stands, refused: Option<PracticeRefusal>) -> (PracticeView, Source) {
        let session = &self.session;
        let (setup, first) = self.begun;
        let view = PracticeView {
            areas: areas(),
            state: session.state(),
            refused,
            raised: session.stopped().map(|stop| match Raised::stop(stop) {
                raised if session.state() == State::Alarm || raised.hint.is_some() => raised,
                raised => Raised { hint: Some(Message::new("jog-crash-hint")), ..raised },
            }),
            notes: self.notes,
            mask: session.mask().map(|mask| shown(session, mask)),
            activation: session.activation().map(|screen| activation(session, screen)),
            keys: keys(session),
            points: points(session),
            plc: session.plc(),
            machine: machine(session),
            piece: stands.piece,
            truth: self.truth,
            deviation: self.deviation.map(|(store, deviation)| told(&session.sim.control, store, deviation)),
            changes: self.changes,
            setup: stands.setup,
            from: self.last.saturating_sub(first),
        };
        let mut outcome = Outcome::left_by(self.session.sim, &setup, None);
        let mut entries = crate::machine::Entries::default();
        outcome.trace.entries.behind(first).for_each(|entry| entries.push(entry));
        outcome.trace.entries = entries;
        let (zones, limits) = (Vec::new(), Vec::new());
        (view, Source { setup, outcome, zones, limits, call: None, apart: true })
    }
}

/// The functions under their softkeys.
fn areas() -> Vec<PracticeArea> {
    let mut areas: Vec<(Area, PracticeArea)> = Vec::new();
    for function in FUNCTIONS {
        let entry = listed(function);
        match areas.iter_mut().find(|(area, _)| *area == function.area) {
            Some((_, area)) => area.functions.push(entry),
            None => {
                let label = Message::new(function.area.key());
                areas.push((function.area, PracticeArea { label, functions: vec![entry] }));
            }
        }
    }
    areas.into_iter().map(|(_, area)| area).collect()
}

fn listed(function: &Function) -> PracticeFunction {
    let one = |mask: &Mask| PracticeChoice {
        name: mask.name,
        label: Message::new(key("mask", mask.name)),
        piece: practice::piece(mask),
    };
    PracticeFunction { name: function.name, masks: function.masks.iter().map(one).collect() }
}

fn shown(session: &Session, mask: &'static Mask) -> PracticeMask {
    let values = session.values();
    let wrong = values.missing(mask);
    let fields = mask.fields.iter().filter(|field| values.shown(field)).map(|field| {
        let wrong = wrong.as_ref().filter(|(one, _)| one.name == field.name).map(|(_, why)| why.clone());
        PracticeField { wrong, ..asked(session, field) }
    });
    let label = Message::new(key("mask", mask.name));
    let shows = mask.shows.iter().filter_map(|show| line(session, *show)).collect();
    PracticeMask { name: mask.name, label, fields: fields.collect(), shows }
}

fn asked(session: &Session, field: &'static Field) -> PracticeField {
    let (values, control) = (session.values(), &session.sim.control);
    let unit = match field.kind {
        Kind::Length(_) => "mm",
        Kind::Angle => "deg",
        _ => "",
    };
    let mut choices = words(field, values, control).unwrap_or_default();
    // a zero offset that was entered by its name, or was active
    let held = values.word(field.name);
    if !choices.is_empty() && !choices.iter().any(|word| word == held) {
        choices.push(held.to_owned());
    }
    PracticeField {
        name: field.name,
        label: session.label("field", field.name),
        unit,
        value: values.get(field.name).cloned().unwrap_or(Value::Number(0.0)),
        choices: choices.into_iter().map(|word| choice(control, word)).collect(),
        wrong: None,
    }
}

/// A word with what it is called; names of axes and zero offsets, signs and numbers are called what they are.
fn choice(control: &Control, word: String) -> PracticeWord {
    let plain = word.len() < 2 || word.starts_with('$') || control.make().settable_named(&word).is_some();
    let label = (!plain).then(|| Message::new(key("word", &word)));
    PracticeWord { word, label }
}

/// A line of the left part; none: a result that is not there yet.
fn line(session: &Session, show: Show) -> Option<PracticeShow> {
    let control = &session.sim.control;
    let frame = session.chosen().map(|store| (told_name(control, store), control.stored_frame(store)));
    let offset = frame.as_ref().map(|(name, _)| name.clone());
    let axes = |values: [f64; 3], unit: &'static str| -> Vec<PracticeFigure> {
        AXES.into_iter().zip(values).map(|(axis, value)| PracticeFigure { axis, value, unit }).collect()
    };
    let result = |name: &'static str, unit: &'static str| {
        let value = session.outcome().results.iter().find(|(known, _)| *known == name)?.1;
        let figures = vec![PracticeFigure { axis: "", value, unit }];
        Some(PracticeShow { label: session.label("result", name), offset: None, figures })
    };
    let rotation = || PracticeShow {
        label: Message::new("jog-show-rotation"),
        offset: offset.clone(),
        figures: frame.as_ref().map_or(Vec::new(), |(_, frame)| axes(frame.rotation.0, "deg")),
    };
    Some(match show {
        Show::Length(name) => return result(name, "mm"),
        Show::Angle(name) => return result(name, "deg"),
        Show::Measuring => PracticeShow {
            label: Message::new("jog-show-measuring"),
            offset: Some(control.make().settable_name(session.measuring())),
            figures: Vec::new(),
        },
        Show::Translation => PracticeShow {
            label: Message::new("jog-show-translation"),
            figures: frame.as_ref().map_or(Vec::new(), |(_, frame)| {
                axes(std::array::from_fn(|axis| frame.coarse[axis] + frame.fine[axis]), "mm")
            }),
            offset,
        },
        Show::Rotation => rotation(),
        Show::Turned => match ROTARY.iter().position(|axis| *axis == session.values().word("angle_offset")) {
            None => rotation(),
            Some(axis) => PracticeShow {
                label: Message::new("jog-show-turned"),
                figures: frame.as_ref().map_or(Vec::new(), |(_, frame)| {
                    vec![PracticeFigure { axis: ROTARY[axis], value: frame.rotary[axis].0, unit: "deg" }]
                }),
                offset,
            },
        },
    })
}

fn told_name(control: &Control, store: Store) -> String {
    crate::jog::offset::name(control, store)
}

fn activation(session: &Session, screen: &Activation) -> PracticeActivation {
    let control = &session.sim.control;
    let one = |name: &'static str| PracticeField {
        name,
        label: Message::new(key("field", name)),
        unit: "",
        value: screen.values.get(name).cloned().unwrap_or(Value::Word(String::new())),
        choices: crate::jog::activation::YES.map(|word| choice(control, word.to_owned())).into(),
        wrong: None,
    };
    PracticeActivation { lines: screen.lines(control), fields: screen.fields().into_iter().map(one).collect() }
}

fn keys(session: &Session) -> PracticeKeys {
    let [start, reset, calculate, back, mode] =
        [Key::Start, Key::Reset, Key::Calculate, Key::Back, Key::Mode].map(|key| session.takes(key));
    PracticeKeys { start, reset, calculate, back, mode }
}

/// A mask that NC start alone fills has no softkeys.
fn points(session: &Session) -> Vec<PracticePoint> {
    let several = session.mask().is_some_and(|mask| !mask.at_once());
    let mut known = stored(&[], session.points()).into_iter().peekable();
    let one = |number: usize| {
        let name = format!("P{}", number + 1);
        let stored = known.next_if(|point| point.name == name);
        PracticePoint { name, stored }
    };
    (0..if several { session.points().len() } else { 0 }).map(one).collect()
}

fn machine(session: &Session) -> PracticeMachine {
    let sim = &session.sim;
    let control = &sim.control;
    let mut measuring = control.clone();
    measuring.activate(session.measuring());
    let plane = settings::plane(control);
    let planes = Plane::ALL.map(|one| {
        let number = 17 + one as u16;
        PracticeUse { name: format!("G{number}"), line: format!("set _JM_I[3] = {number}"), used: one == plane }
    });
    let others = control.frames.keys().copied().filter(|number| *number > 4);
    let offsets = (0..=4).chain(others).map(|number| PracticeUse {
        name: control.make().settable_name(number),
        line: format!("set _JM_I[4] = {}", settings::number(number)),
        used: number == session.measuring(),
    });
    let empty = PracticeUse { name: String::new(), line: "tool T0".to_owned(), used: control.tool == 0 };
    let tools = control.tools.iter().filter(|(tool, _)| **tool > 0).flat_map(|(tool, data)| {
        let one = |edge: &i64| PracticeUse {
            name: format!("T{tool} D{edge} {}", data.name),
            line: format!("tool T{tool} D{edge}"),
            used: control.active_place() == (*tool, *edge),
        };
        data.edges.keys().map(one).collect::<Vec<_>>()
    });
    let [abscissa, ordinate, _] = plane.axes();
    PracticeMachine {
        wcs: measuring.to_workpiece(sim.position).0,
        mcs: sim.position.0,
        active: control.make().settable_name(control.settable),
        axes: [abscissa, ordinate].map(|axis| AXES[axis]),
        planes: planes.into(),
        offsets: offsets.collect(),
        offered: session.offers(),
        tools: std::iter::once(empty).chain(tools).collect(),
        probe: sim.has_probe(),
    }
}

fn told(control: &Control, store: Store, deviation: Deviation) -> PracticeDeviation {
    let figure = |unit: &'static str| move |(axis, value): (&'static str, f64)| PracticeFigure { axis, value, unit };
    let lengths = deviation.lengths.into_iter().map(figure("mm"));
    let figures = lengths.chain(deviation.angles.into_iter().map(figure("deg"))).collect();
    PracticeDeviation { offset: told_name(control, store), figures }
}
