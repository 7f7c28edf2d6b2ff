//! Measuring in JOG as a page shows it: a session carried out from its script, with its part as it lies.

mod program;
mod screen;
mod view;

pub use program::{PracticeCall, PracticeCallRequest, PracticeProgram, as_mask, as_program, call_text, jog_program};
pub use view::{
    PracticeActivation, PracticeApproach, PracticeArea, PracticeChoice, PracticeDeviation, PracticeFace, PracticeField,
    PracticeFigure, PracticeKeys, PracticeMachine, PracticeMask, PracticePart, PracticePoint, PracticeRefusal,
    PracticeRequest, PracticeShow, PracticeUse, PracticeView, PracticeWord,
};

use super::Error;
use super::ahead::{ahead, hidden};
use super::changes::Change;
use super::jog::{act, all, changed, jog_in_mm, note, raised};
use super::record::Record;
use super::start::{Machine, start};
use crate::control::Store;
use crate::dialect::Dialect;
use crate::geometry::{Dir, Mcs, Rpy};
use crate::jog::approach;
use crate::jog::chance::Truth;
use crate::jog::practice::{self, Piece};
use crate::jog::script::{Command, Line, Wrong, behind, read};
use crate::jog::shadow::{Deviation, Shadow};
use crate::jog::{Session, help, measures};
use crate::machine::{MotionKind, Setup, Step};
use crate::message::Message;
use crate::refused::Path;
use crate::run::outcome::Outcome;
use crate::scene::Source;

/// Carries out a session; what is to be seen of it begins where the mask was opened.
///
/// # Errors
/// A control that does not measure in JOG, or a machine that cannot be.
pub fn practise(asked: PracticeRequest) -> Result<(PracticeView, Source), Error> {
    Practice::default().practise(asked)
}

/// A session that goes on: what it carried out is kept, so that a line more costs that line and not all before it.
#[derive(Clone, Debug, Default)]
pub struct Practice {
    kept: Option<Kept>,
}

/// A session as far as it came.
#[derive(Clone, Debug)]
struct Kept {
    /// What was asked for, without lines.
    asked: PracticeRequest,
    /// The lines that were carried out.
    lines: Vec<Line>,
    course: Course,
    /// Before the last of them, which an axis key makes longer.
    before: Option<Box<Course>>,
}

impl Practice {
    /// As [`practise`], and with the same answer whatever was asked before.
    ///
    /// # Errors
    /// As there.
    pub fn practise(&mut self, asked: PracticeRequest) -> Result<(PracticeView, Source), Error> {
        let hides = asked.hides;
        let (course, refused) = self.carried_out(asked)?;
        Ok(course.seen(refused, hides))
    }

    /// The session as far as its lines can be carried out, and why not all of them.
    fn carried_out(&mut self, mut asked: PracticeRequest) -> Result<(Course, Option<PracticeRefusal>), Error> {
        let script = std::mem::take(&mut asked.script);
        let (lines, wrong) = legible(&script);
        asked.hides = false; // changes what is told, not what is done
        let kept = self.kept.take().filter(|kept| kept.asked == asked).and_then(|kept| kept.within(&lines));
        let mut kept = match kept {
            Some(kept) => kept,
            None => Kept { course: Course::of(asked.clone())?, asked, lines: Vec::new(), before: None },
        };
        let mut refused = wrong.map(|Wrong { line, message, hint }| (line, message, Some(hint)));
        for line in &lines[kept.lines.len()..] {
            if let Err(why) = kept.carry_out(line, lines.len()) {
                refused = Some(why);
                break;
            }
        }
        let refusal = |(line, message, hint)| PracticeRefusal { left: behind(&script, line), line, message, hint };
        let course = kept.course.clone();
        // what a refused line further up left is not gone on from; before the last one it stands again
        self.kept = (kept.lines.len() + 1 >= lines.len()).then_some(kept);
        Ok((course, refused.map(refusal)))
    }
}

impl Kept {
    /// As far as these lines begin with those that were carried out, all or all but the last of them.
    fn within(self, lines: &[Line]) -> Option<Kept> {
        if lines.starts_with(&self.lines) {
            return Some(self);
        }
        let (_, first) = self.lines.split_last()?;
        let (course, lines) = (*self.before.filter(|_| lines.starts_with(first))?, first.to_vec());
        Some(Kept { asked: self.asked, lines, course, before: None })
    }

    /// A line more of so many; the last one leaves everything as it was where it is refused.
    fn carry_out(&mut self, line: &Line, count: usize) -> Result<(), (u32, Message, Option<Message>)> {
        let is_last = self.lines.len() + 1 == count;
        self.before = is_last.then(|| Box::new(self.course.clone()));
        if let Err(message) = self.course.carry_out(line) {
            let hint = help::cure_of(&message, self.course.session.mask());
            if let Some(before) = self.before.take() {
                self.course = *before;
            }
            return Err((line.number, message, hint));
        }
        self.lines.push(line.clone());
        Ok(())
    }
}

/// How the probe gets in front of a face of the part.
///
/// # Errors
/// As of a session.
pub fn approach(asked: PracticeFace) -> Result<PracticeApproach, Error> {
    let (course, _) = Practice::default().carried_out(asked.practice)?;
    let found = approach::to_face(&course.session, Mcs(asked.at), Dir::new(asked.normal));
    Ok(match found {
        Ok(line) => PracticeApproach { line, refused: None },
        Err(message) => PracticeApproach { line: None, refused: Some(message) },
    })
}

/// The record of a session as far as its lines can be carried out; `script`: name of the file.
///
/// # Errors
/// As of a session.
pub fn practice_record(asked: PracticeRequest, script: &str) -> Result<Record, Error> {
    let (lines, _) = legible(&asked.script);
    let (Stands { mut setup, .. }, truth) = begun(asked)?;
    truth.put(&mut setup);
    Ok(Record::of_jog(script.to_owned(), &setup, all(&lines, &setup)))
}

/// The machine of a session as it was before the first line, with the part as it lies.
///
/// # Errors
/// As of a session.
pub fn practice_setup(asked: PracticeRequest) -> Result<Setup, Error> {
    let (Stands { mut setup, .. }, truth) = begun(asked)?;
    truth.put(&mut setup);
    Ok(setup)
}

/// The machine of a session, and how its part lies.
fn begun(asked: PracticeRequest) -> Result<(Stands, Truth), Error> {
    if !measures(asked.control) {
        return Err(Error::new("jog-no-jog", Path::of(&["control"])));
    }
    let stands = Stands::new(asked.control, asked.setup, asked.piece)?;
    let truth = asked.seed.map_or_else(|| placed(asked.part, &stands.setup), |seed| Truth::by(seed.into()));
    Ok((stands, truth))
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

/// The part as sliders put it: turned about the axes of the plane.
fn placed(part: Option<PracticePart>, setup: &Setup) -> Truth {
    let part = part.unwrap_or_default();
    let axes = setup.control.plane.axes();
    let about = [part.lean_abscissa, part.lean_ordinate, part.tilt];
    let turn = |axis| axes.into_iter().zip(about).find(|(own, _)| *own == axis).map_or(0.0, |(_, angle)| angle.0);
    let tilt = Rpy(std::array::from_fn(turn));
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
#[derive(Clone, Debug)]
struct Course {
    session: Session,
    /// What lies on the table of the machine to practise on.
    piece: Option<Piece>,
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
    /// Before the first line, with the part as it lies.
    fn of(asked: PracticeRequest) -> Result<Course, Error> {
        let (Stands { mut setup, piece }, truth) = begun(asked)?;
        let shadow = Shadow::new(&setup, truth);
        truth.put(&mut setup);
        let session = Session::new(&setup);
        let begun = (setup, 0);
        let (notes, changes) = (jog_in_mm(&session.sim.control).into_iter().collect(), Vec::new());
        let mut course = Course { session, piece, shadow, truth, begun, last: 0, notes, changes, deviation: None };
        course.begin();
        Ok(course)
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
        let control = &self.session.sim.control;
        let begins = matches!(line.command, Command::Mask(_));
        let units = jog_in_mm(control).filter(|_| begins);
        self.notes = units.into_iter().chain(steps.iter().filter_map(note)).collect();
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

    fn seen(self, refused: Option<PracticeRefusal>, hides: bool) -> (PracticeView, Source) {
        let session = &self.session;
        let (setup, first) = self.begun;
        let view = PracticeView {
            areas: screen::areas(&session.sim.control),
            state: session.state(),
            refused,
            raised: session.stopped().map(|stop| raised(session, stop)),
            notes: self.notes,
            mask: session.mask().map(|mask| screen::shown(session, mask)),
            activation: session.activation().map(|screen| screen::activation(session, screen)),
            keys: screen::keys(session),
            points: screen::points(session),
            plc: session.plc(),
            machine: screen::machine(session),
            piece: self.piece,
            ahead: if hides { hidden(session) } else { ahead(session) },
            truth: self.truth,
            deviation: self.deviation.map(|(store, deviation)| screen::told(&session.sim.control, store, deviation)),
            changes: self.changes,
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
