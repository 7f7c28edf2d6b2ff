//! Tool radius compensation (G41, G42): the path of the tool centre beside the programmed contour.
//!
//! Where a block ends depends on the next one, so each waits until that is known. What the blocks between them record
//! (M functions, texts, values) comes behind it all the same. What needs the real position before (a measurement,
//! STOPRE, another tool) has the waiting block end at right angles to its own end, and so does the end of the program.
//!
//! Everything here counts from the spindle nose in machine coordinates, so that another tool length moves nothing.

mod corner;
mod drive;
mod element;
mod plane;

pub use corner::Outside;
pub use element::{Point, distance, left};

use super::{Compensation, Halt, Interpreter};
use crate::diagnostic::Span;
use crate::geometry::{Dir, Mcs};
use crate::machine::{MotionKind, Route};
use crate::problem::Problem;
use corner::{Beside, Corner, corner};
use drive::{Manner, Piece, Waiting, Way};
use element::{Element, Round};
use plane::Plane;

/// A contour that the tool follows.
#[derive(Clone, Debug)]
pub struct Contour {
    plane: Plane,
    side: Compensation,
    /// Where the program stands.
    programmed: Mcs,
    /// Blocks that are not driven yet: one along the contour or to it, and behind it some that only rise or fall.
    waiting: Vec<Waiting>,
    /// The block that was driven to its end before the next one was known.
    driven: Option<Beside>,
}

/// A programmed motion.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    /// Programmed way, machine coordinates.
    pub way: Route,
    pub kind: MotionKind,
    /// mm/min.
    pub feed: f64,
    pub span: Span,
}

/// Where the program stands: the end of the last block as programmed, beside which the tool may be.
pub fn stands(run: &Interpreter) -> Mcs {
    match &run.contour {
        Some(contour) => contour.programmed + -run.sim.control.active_length(),
        None => run.sim.position,
    }
}

/// Whether a motion is driven beside, or goes back from there: an arc has to lie in the working plane.
pub fn concerns(run: &Interpreter, way: &Route) -> bool {
    let on = run.modal.compensation != Compensation::Off || run.contour.is_some();
    on && Plane::of(&run.sim.control).element(way).is_some()
}

/// Takes a motion with compensation on, or the one that takes it off. A fault ends the contour.
pub fn follow(run: &mut Interpreter, motion: &Motion) -> Result<(), Halt> {
    let way = motion.way.moved(run.sim.control.active_length());
    let seen = Plane::of(&run.sim.control);
    let mut contour = run.contour.take().unwrap_or(Contour {
        plane: seen,
        side: Compensation::Off,
        programmed: way.from,
        waiting: Vec::new(),
        driven: None,
    });
    let (plane, side) = (contour.plane, run.modal.compensation);
    let Some((hand, element)) = plane.hand_of(&seen).zip(plane.element(&way)) else {
        return refused(motion, "run-contour-plane"); // alarm 10757
    };
    contour.programmed = way.to;
    let heights = [way.from, way.to].map(|point| plane.split(point).1);
    let step = Step { element, by: offset(run, side, hand), heights, motion };
    if !element.moves() {
        contour.rise(run, &step)?;
    } else if side == contour.side {
        contour.go_on(run, &step)?;
    } else {
        contour.finish(run)?;
        (contour.side, contour.driven) = (side, None);
        if side == Compensation::Off {
            return contour.depart(run, &step);
        }
        contour.approach(run, &step)?;
    }
    // what only rose before the contour has not begun one
    run.contour = (contour.side != Compensation::Off).then_some(contour);
    Ok(())
}

/// Drives what waits, to its end at right angles to it: the real position counts, or nothing more comes.
pub fn finish(run: &mut Interpreter) -> Result<(), Halt> {
    if let Some(mut contour) = run.contour.take() {
        contour.finish(run)?;
        run.contour = Some(contour);
    }
    Ok(())
}

/// Drives what waits and ends the contour: the program stands where the tool stands then.
pub fn leave(run: &mut Interpreter) -> Result<(), Halt> {
    let done = finish(run);
    run.contour = None;
    done
}

/// Whether a block waits for the next one.
pub fn waits(run: &Interpreter) -> bool {
    let contour = run.contour.as_ref();
    contour.is_some_and(|contour| !contour.waiting.is_empty())
}

/// A motion as the contour sees it.
struct Step<'a> {
    element: Element,
    /// How far the tool centre is to the left of it, mm.
    by: f64,
    /// Along the applicate, at its start and at its end.
    heights: [f64; 2],
    motion: &'a Motion,
}

impl Contour {
    /// Only along the applicate: where the tool stands then, behind the block that waits.
    fn rise(&mut self, run: &mut Interpreter, step: &Step) -> Result<(), Halt> {
        let rise = self.waiting(run, step, Piece::Rise);
        if self.waiting.is_empty() {
            return drive::all(run, &self.plane, &[rise.way(Point::zeros(), 0.0)]);
        }
        self.waiting.push(rise);
        Ok(())
    }

    /// The straight block that leads to the contour: to where the next one begins, at right angles to it (NORM).
    fn approach(&mut self, run: &mut Interpreter, step: &Step) -> Result<(), Halt> {
        if step.element.round.is_some() {
            return refused(step.motion, "run-contour-begin"); // alarm 10753
        }
        if !run.sim.control.make().registers && run.sim.control.tool == 0 {
            return refused(step.motion, "run-contour-tool"); // alarm 10750
        }
        self.waiting = vec![self.waiting(run, step, Piece::Approach(beside(run, step, step.by)?))];
        Ok(())
    }

    /// A block along the contour: what waits ends where this one begins, and now this one waits.
    fn go_on(&mut self, run: &mut Interpreter, step: &Step) -> Result<(), Halt> {
        let before = match self.waiting.first().map(|waiting| waiting.piece) {
            Some(Piece::Along { beside, begun }) => Some((beside, begun)),
            Some(_) => None,
            None => self.driven.take().map(|beside| (beside, 0.0)),
        };
        let beside = beside(run, step, before.map_or(step.by, |(before, _)| before.by[1]))?;
        let corner = match &before {
            Some((before, begun)) => corner(before, &beside, *begun, run.modal.outside),
            None => Some(Corner::Smooth),
        };
        let corner = corner.ok_or_else(|| narrow(run, step.motion))?;
        let open = !self.waiting.is_empty();
        let (at, cut, begun) = match (corner, before) {
            (Corner::Meet { at, cut }, _) if open => (at, cut[0], cut[1]),
            (Corner::Round(_), Some((before, _))) => (before.path.end, 0.0, 0.0),
            _ => (beside.path.start, 0.0, 0.0),
        };
        let between = match corner {
            Corner::Round(sweep) => Some(Some(Round { centre: step.element.start, sweep })),
            _ => (!open).then_some(None),
        };
        let mut ways = self.ways(at, cut);
        ways.extend(between.map(|round| Way {
            at: Some(beside.path.start),
            height: step.heights[0],
            round,
            manner: Manner::now(run, step.motion),
        }));
        drive::all(run, &self.plane, &ways)?;
        self.waiting = vec![self.waiting(run, step, Piece::Along { beside, begun })];
        Ok(())
    }

    /// The straight block that leads away: from where the tool stands at right angles to its programmed end.
    fn depart(&self, run: &mut Interpreter, step: &Step) -> Result<(), Halt> {
        if step.element.round.is_some() {
            return refused(step.motion, "run-contour-end"); // alarm 10754
        }
        let mut manner = Manner::now(run, step.motion);
        manner.tip = Dir::default();
        let way = Way { at: Some(step.element.end), height: step.heights[1], round: None, manner };
        drive::all(run, &self.plane, &[way])
    }

    fn finish(&mut self, run: &mut Interpreter) -> Result<(), Halt> {
        let first = self.waiting.first().map(|waiting| waiting.piece);
        if let Some(Piece::Approach(beside) | Piece::Along { beside, .. }) = first {
            let ways = self.ways(beside.path.end, 0.0);
            drive::all(run, &self.plane, &ways)?;
            self.driven = Some(beside);
        }
        Ok(())
    }

    /// What waits, which ends there, so much before or behind its own end; then nothing waits any more.
    fn ways(&mut self, at: Point, cut: f64) -> Vec<Way> {
        let waiting = std::mem::take(&mut self.waiting);
        waiting.iter().map(|waiting| waiting.way(at, cut)).collect()
    }

    fn waiting(&self, run: &Interpreter, step: &Step, piece: Piece) -> Waiting {
        Waiting { piece, height: step.heights[1], manner: Manner::now(run, step.motion) }
    }
}

/// The path beside a block that begins so far from it.
fn beside(run: &Interpreter, step: &Step, by: f64) -> Result<Beside, Problem> {
    Beside::of(step.element, [by, step.by]).ok_or_else(|| narrow(run, step.motion))
}

/// How far to the left of the contour the tool centre is, mm.
fn offset(run: &Interpreter, side: Compensation, hand: f64) -> f64 {
    let side = match side {
        Compensation::Off => 0.0,
        Compensation::Left => hand,
        Compensation::Right => -hand,
    };
    side * (radius(run) + run.modal.allowance)
}

/// Active radius with its wear, mm; on NCT that of the register in D.
fn radius(run: &Interpreter) -> f64 {
    let control = &run.sim.control;
    if control.make().registers { control.register(run.modal.radius).total_radius() } else { control.active_radius() }
}

fn refused(motion: &Motion, key: &'static str) -> Result<(), Halt> {
    Err(Problem::new(key, motion.span, "").into())
}

/// The tool has no room (alarm 10751).
fn narrow(run: &Interpreter, motion: &Motion) -> Problem {
    Problem::at("run-contour-narrow", motion.span).number("radius", radius(run))
}
