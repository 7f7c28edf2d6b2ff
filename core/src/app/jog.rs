//! A session of measuring in JOG, carried out from a script: what each line did.

use super::ahead::{JogAhead, ahead};
use super::changes::Change;
use super::outcome::Raised;
use super::record::Recorder;
use super::run::RunAnswer;
use crate::control::machine_data::MACHINE_DATA;
use crate::control::{AXES, BASIC_SYSTEM, Control, FORMS, GENERATION, OLDER_JOG, Value, gud};
use crate::geometry::{Mcs, TOLERANCE};
use crate::jog::chance::{self, Truth};
use crate::jog::help;
use crate::jog::mask::key;
use crate::jog::script::{Command, Line, Way, Wrong, read};
use crate::jog::values::Values;
use crate::jog::{Input, Point, Session, State, measures};
use crate::machine::{Machine, MotionKind, Setup, Sim, Step, Stop};
use crate::message::Message;
use crate::range::Range;
use crate::run::is_length;
use serde::Serialize;

/// What a script did.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct JogView {
    /// Its lines, as far as they were carried out.
    pub lines: Vec<JogLine>,
    /// Lines behind one that was refused, which were not carried out.
    pub left: u32,
    /// How the part was put, where chance put it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub truth: Option<Truth>,
    /// What the next key would do then.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ahead: Option<JogAhead>,
    /// The machine, as the setup file has it, when all is done.
    pub setup: Setup,
    /// What was measured, for the record.
    #[serde(skip)]
    pub calls: Vec<RunAnswer>,
}

/// What a line did.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct JogLine {
    /// Number, from 1.
    pub line: u32,
    /// As it is written.
    pub text: String,
    /// What is on the screen then.
    pub state: State,
    /// The mask that is open.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mask: Option<Message>,
    /// Letters of abscissa and ordinate, in which centres count.
    pub plane: [&'static str; 2],
    /// Why it did nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<Message>,
    /// What helps then.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hint: Option<Message>,
    /// The alarm that it raised, or what was hit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub raised: Option<Raised>,
    /// What the user should know of a touch: the stylus touched instead of the ball.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<Message>,
    /// Position in the WCS then, mm.
    pub position: [f64; 3],
    /// Name of the zero offset that is active then.
    pub offset: String,
    /// Points that it stored.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub points: Vec<JogPoint>,
    /// Results that it brought to the screen.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub results: Vec<JogResult>,
    /// What it wrote.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub changes: Vec<Change>,
    /// Lines of the activation screen, where it came up.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub screen: Vec<Message>,
    /// Values of the mask, or of the activation screen.
    pub values: Values,
    /// Bits 0 to 7 of the PLC.
    pub plc: [bool; 8],
}

/// A point that was stored.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct JogPoint {
    /// `P1`.
    pub name: String,
    /// Position at switching in the WCS of the measurement, mm, where it is a touch.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub touch: Option<[f64; 3]>,
    /// Centre in abscissa and ordinate, mm, where it is an element.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre: Option<[f64; 2]>,
}

/// A result.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct JogResult {
    /// `meas_x0`.
    pub name: &'static str,
    /// As the mask shows it.
    pub label: Message,
    /// Value, mm or degree.
    pub value: f64,
    /// `mm` or `deg`.
    pub unit: &'static str,
}

/// Why a script is not carried out.
#[derive(Clone, Debug, PartialEq)]
pub enum JogWrong {
    /// A line cannot be read.
    Line(Wrong),
    /// The machine has no measuring in JOG.
    Machine(Message),
}

/// Carries out a script on a machine; with a seed the part lies as chance puts it. It ends behind an alarm or a
/// collision that the script does not acknowledge, and at a line that is refused.
///
/// # Errors
/// A line that cannot be read, or a machine that does not measure in JOG.
pub fn jog(script: &str, setup: &Setup, seed: Option<u64>) -> Result<JogView, JogWrong> {
    let lines = read(script).map_err(JogWrong::Line)?;
    if !measures(setup.control.dialect) {
        return Err(JogWrong::Machine(Message::new("jog-no-jog")));
    }
    let mut setup = setup.clone();
    let truth = seed.map(|seed| chance::put(&mut setup, seed));
    Ok(JogView { truth, ..all(&lines, &setup) })
}

/// Carries out these lines on a machine whose part lies.
pub(super) fn all(lines: &[Line], begun: &Setup) -> JogView {
    let mut session = Session::new(begun);
    let mut done = Vec::new();
    let mut recorder = Recorder::new(begun);
    for line in lines {
        let from = session.sim.trace.entries.len();
        let told = carry_out(&mut session, line);
        recorder.follow(&session, &told, from);
        let ends = told.refused.is_some();
        done.push(told);
        if ends {
            break;
        }
    }
    let (control, position) = (session.sim.control.clone(), session.sim.position);
    let setup = Setup { control, position, ..begun.clone() };
    let left = u32::try_from(lines.len() - done.len()).unwrap_or(u32::MAX);
    JogView { lines: done, left, truth: None, ahead: ahead(&session), setup, calls: recorder.calls }
}

fn carry_out(session: &mut Session, line: &Line) -> JogLine {
    let before = session.sim.trace.entries.len();
    let points = session.points().to_vec();
    let shown = session.outcome().results.clone();
    let screen = session.activation().is_some();
    let stop = session.stopped().cloned();
    let refused = act(session, &line.command).err();
    let control = &session.sim.control;
    let steps: Vec<Step> = session.sim.trace.entries.behind(before).map(|entry| entry.step).collect();
    // who runs against the same place again is told again
    let crashed = steps.iter().any(|step| matches!(step, Step::Crash { .. }));
    let activation = session.activation();
    let [abscissa, ordinate, _] = control.plane.axes();
    JogLine {
        line: line.number,
        text: line.text.clone(),
        state: session.state(),
        mask: session.mask().map(|mask| Message::new(key("mask", mask.name))),
        plane: [abscissa, ordinate].map(|axis| AXES[axis]),
        hint: refused.as_ref().and_then(|why| help::cure_of(why, session.mask())),
        refused,
        raised: session.stopped().filter(|now| crashed || stop.as_ref() != Some(now)).map(|stop| raised(session, stop)),
        notes: steps.iter().filter_map(note).collect(),
        position: session.sim.position().0,
        offset: control.make().settable_name(control.settable),
        points: stored(&points, session.points()),
        results: if session.outcome().results == shown { Vec::new() } else { results(session) },
        changes: steps.iter().filter_map(|step| changed(control, step)).collect(),
        screen: activation.filter(|_| !screen).map_or(Vec::new(), |activation| activation.lines(control)),
        values: activation.map_or(session.values(), |activation| &activation.values).clone(),
        plc: session.plc(),
    }
}

/// What a step tells the user beside results.
pub(super) fn note(step: &Step) -> Option<Message> {
    match step {
        Step::Decision { message } => Some(message.clone()),
        _ => None,
    }
}

/// Why the machine stopped, and what helps: an axis that ran into something goes back, behind RESET where an NC start
/// ended with it; and no tool measures the workpiece.
pub(super) fn raised(session: &Session, stop: &Stop) -> Raised {
    let raised = Raised::stop(stop);
    let cure = match stop {
        Stop::Alarm(code) => Some(Message::new(help::cure(*code, session.mask()))),
        Stop::Fault(message) => help::cure_of(message, session.mask()),
    };
    let raised = Raised { hint: cure.or(raised.hint), ..raised };
    let alarm = session.state() == State::Alarm;
    let workpiece = session.mask().is_some_and(|mask| !mask.task.of_tool());
    let hint = match raised.message.key.as_ref() {
        _ if raised.hint.is_some() => return raised,
        _ if !alarm => "jog-crash-hint",
        "jog-crash-cutter" | "run-crash-tool" if workpiece => "jog-probe-hint",
        key if key.contains("-crash") => "jog-crash-reset-hint",
        _ => return raised,
    };
    Raised { hint: Some(Message::new(hint)), ..raised }
}

pub(super) fn changed(control: &Control, step: &Step) -> Option<Change> {
    let Step::Set { name, before, after } = step else { return None };
    // calibrated values stand in the unit of the machine, tools and frames in mm
    let factor = if gud::named(name).is_some() && is_length(name) { control.basic_factor() } else { 1.0 };
    Some(Change::of(control, name.clone(), before * factor, after * factor)).filter(|_| before != after)
}

/// Points that are there now and were not before.
pub(super) fn stored(before: &[Option<Point>], now: &[Option<Point>]) -> Vec<JogPoint> {
    let new = now.iter().enumerate().filter(|(number, _)| before.get(*number).copied().flatten().is_none());
    new.filter_map(|(number, point)| {
        let name = format!("P{}", number + 1);
        Some(match point.as_ref()? {
            Point::Touch(touch) => JogPoint { name, touch: Some(touch.at.0), centre: None },
            Point::Element(found) => JogPoint { name, touch: None, centre: Some(found.centre) },
        })
    })
    .collect()
}

pub(super) fn results(session: &Session) -> Vec<JogResult> {
    let results = session.outcome().results.iter();
    let angle = |name: &str| ["alpha", "beta"].contains(&name);
    results
        .map(|(name, value)| JogResult {
            name,
            label: session.label("result", name),
            value: *value,
            unit: if angle(name) { "deg" } else { "mm" },
        })
        .collect()
}

/// Carries out a command; an error says why it does nothing.
pub(super) fn act(session: &mut Session, command: &Command) -> Result<(), Message> {
    match command {
        Command::Mask(name) => {
            if matches!(session.state(), State::Mask | State::Ready) {
                session.press(Input::Back)?;
            }
            session.press(Input::Function(name))
        }
        Command::Field(name, text) => session.press(Input::Field(name, text)),
        Command::Move(axes, way) => travel(session, axes, *way),
        Command::Start(false) => session.carry_out(Input::Start),
        Command::Start(true) => {
            session.press(Input::Start)?;
            session.press(Input::Reset)
        }
        Command::Reset => session.press(Input::Reset),
        Command::Reject(_) if session.kept_by_hand() => Err(Message::new("jog-older-reject")),
        Command::Reject(number) => session.press(Input::Point(*number)),
        Command::Store(_) if !session.kept_by_hand() => Err(Message::new("jog-stores-itself")),
        Command::Store(number) => session.press(Input::Point(*number)),
        Command::Plc(number, set) => session.press(Input::Plc(*number, *set)),
        Command::Calculate => session.press(Input::Calculate),
        Command::Activate if session.state() != State::Activate => Err(Message::new("jog-nothing-to-activate")),
        Command::Activate => session.carry_out(Input::Start),
        Command::Back => session.press(Input::Back),
        Command::Mode => session.press(Input::Mode),
        Command::Tool(tool, edge) => session.take_tool(*tool, *edge),
        Command::Set(name, value) => set(session, name, *value),
    }
}

/// Moves the axes one after the other. Nobody watches: what is hit stops the machine, and is told.
fn travel(session: &mut Session, axes: &[(usize, f64)], way: Way) -> Result<(), Message> {
    session.by_hand(|sim, measuring| {
        for (axis, value) in axes {
            let to = match way {
                Way::Machine => {
                    let mut to = sim.position;
                    to[*axis] = *value;
                    to
                }
                _ => measuring.along(sim.position, *axis, *value, way == Way::By),
            };
            withdrawing(sim, Mcs(to.0), |sim| sim.travel_machine(Mcs(to.0), None, MotionKind::Rapid, 0.0, false))?;
        }
        Ok(())
    })
}

/// Moves; what reaches into something already is drawn out of it along itself, whatever it meets there.
fn withdrawing<T>(sim: &mut Sim, to: Mcs, go: impl FnOnce(&mut Sim) -> T) -> T {
    let (from, axis) = (sim.position, sim.tool_axis());
    let along = (0..3).all(|other| other == axis || (to[other] - from[other]).abs() <= TOLERANCE);
    sim.still = along && to[axis] > from[axis] && sim.reaches_in();
    let outcome = go(sim);
    sim.still = false;
    outcome
}

/// Writes a datum of the control, or a value of a tool or a frame.
fn set(session: &mut Session, name: &str, value: f64) -> Result<(), Message> {
    cannot_be(name, value).map_or(Ok(()), Err)?;
    let sim = &mut session.sim;
    if sim.control.variable(name).is_some() {
        sim.write_correction(name.to_owned(), value);
    } else if sim.control.knows(name, &Value::Number(value)) {
        sim.write(name, value);
    } else {
        return Err(Message::new("jog-no-datum").text("name", name));
    }
    session.settle();
    Ok(())
}

/// What a datum can be.
struct Permitted<'a> {
    range: Range,
    choices: &'a [i64],
    whole: bool,
}

/// What the tables say of a datum of the user, of the machine or of ours; none: they say nothing.
fn permitted(name: &str) -> Option<Permitted<'static>> {
    let of = |choices: &'static [i64]| Some(Permitted { range: Range::ANY, choices, whole: false });
    if let Some((gud, at)) = gud::place(name) {
        let element = gud.element(&at)?;
        if gud.kind == gud::Kind::Bool {
            return of(&[0, 1]);
        }
        let whole = gud.kind == gud::Kind::Integer;
        return Some(Permitted { range: element.range, choices: element.choices, whole });
    }
    match name {
        FORMS | OLDER_JOG => return of(&[0, 1]),
        GENERATION => return of(&[0, 1, 2, 3]),
        _ => {}
    }
    let mut data = MACHINE_DATA.iter().filter(|datum| name.starts_with(datum.number));
    let datum = data.find(|datum| datum.names().iter().any(|known| known == name))?;
    if datum.number == BASIC_SYSTEM {
        return of(&[0, 1]);
    }
    Some(Permitted { range: datum.range(), choices: &[], whole: datum.is_whole() })
}

/// Why a datum cannot have a value; none: it can, or nothing says so.
fn cannot_be(name: &str, value: f64) -> Option<Message> {
    let Permitted { range, choices, whole } = permitted(name)?;
    let chosen = choices.is_empty() || choices.iter().any(|choice| *choice as f64 == value);
    let key = match choices {
        [] if whole && value.fract() != 0.0 => "jog-datum-whole",
        _ if range.contains(value) && chosen => return None,
        [] if range.max.is_finite() => "jog-datum-range",
        [] if range.min_included => "jog-datum-least",
        [] => "jog-datum-above",
        _ => "jog-datum-choice",
    };
    let choices: Vec<String> = choices.iter().map(i64::to_string).collect();
    let message = Message::new(key).text("name", name).number("value", value).text("choices", choices.join(", "));
    let ends = [("min", range.min), ("max", range.max)].into_iter().filter(|(_, end)| end.is_finite());
    Some(ends.fold(message, |message, (end, value)| message.number(end, value)))
}

/// What is told where a session begins: JOG shows mm on any machine.
pub fn jog_in_mm(control: &Control) -> Option<Message> {
    (control.basic_factor() != 1.0).then(|| Message::new("jog-in-mm"))
}
