//! Blocks that waited, driven by the machine as if they had been when they were programmed: with their own line, before
//! what was recorded since, with the tool length of that moment.

use super::{Beside, Halt, Interpreter, Motion, Plane, Point, Round};
use crate::control::tools::side;
use crate::diagnostic::Span;
use crate::geometry::{Around, Degrees, Dir, Mcs};
use crate::machine::{MotionKind, Stop};

/// A block that waits.
#[derive(Clone, Copy, Debug)]
pub struct Waiting {
    pub piece: Piece,
    /// End of the block along the applicate.
    pub height: f64,
    pub manner: Manner,
}

/// What a block does.
#[derive(Clone, Copy, Debug)]
pub enum Piece {
    /// Leads to the contour.
    Approach(Beside),
    /// Goes along it, after so much of its path has been left out.
    Along {
        beside: Beside,
        /// In the unit of [`super::element::Element::extent`].
        begun: f64,
    },
    /// Moves along the applicate only.
    Rise,
}

impl Waiting {
    /// Way of the block once its end is known; so much of its path is left out there.
    pub fn way(&self, at: Point, cut: f64) -> Way {
        let (at, round) = match &self.piece {
            Piece::Rise => (None, None),
            Piece::Approach(_) => (Some(at), None),
            Piece::Along { beside, begun } => {
                let sweep = beside.path.sweep(*begun, cut);
                let centre = beside.path.round.map(|round| round.centre);
                (Some(at), centre.zip(sweep).map(|(centre, sweep)| Round { centre, sweep }))
            }
        };
        Way { at, height: self.height, round, manner: self.manner }
    }
}

/// Kind and feed of a motion, and when it was programmed.
#[derive(Clone, Copy, Debug)]
pub struct Manner {
    kind: MotionKind,
    feed: f64,
    span: Span,
    line: Option<u32>,
    /// Entries of the trace before it.
    behind: usize,
    /// Tool length, machine axes.
    length: Dir<Mcs>,
    /// From the centre of a turning tool's nose to the point to which its lengths refer.
    pub tip: Dir<Mcs>,
}

impl Manner {
    /// As things are now.
    pub fn now(run: &Interpreter, motion: &Motion) -> Manner {
        Manner {
            kind: motion.kind,
            feed: motion.feed,
            span: motion.span,
            line: run.sim.line,
            behind: run.sim.trace.entries.len(),
            length: run.sim.control.active_length(),
            tip: tip(run),
        }
    }
}

/// From the centre of a turning tool's nose to its point P, machine axes; no way for other tools.
fn tip(run: &Interpreter) -> Dir<Mcs> {
    let control = &run.sim.control;
    let mut tip = Dir::default();
    if let Some(edge) = control.active_edge().filter(|edge| edge.is_turning()) {
        let [a, o, _] = control.plane.axes();
        [tip[a], tip[o]] = side(edge.tip, false).map(|towards| towards * control.active_radius());
    }
    tip
}

/// A way of the tool centre.
#[derive(Clone, Copy, Debug)]
pub struct Way {
    /// End in the plane; none: the tool stays there.
    pub at: Option<Point>,
    /// End of the block along the applicate.
    pub height: f64,
    /// Round what; none: straight.
    pub round: Option<Round>,
    pub manner: Manner,
}

/// Drives ways one after the other; what was recorded between them stays between them.
pub fn all(run: &mut Interpreter, plane: &Plane, ways: &[Way]) -> Result<(), Halt> {
    let entries = &mut run.sim.trace.entries;
    let mut passed = ways.first().map_or(0, |way| way.manner.behind);
    let mut later = entries.split_off(passed.min(entries.len())).into_iter();
    let line = run.sim.line;
    for way in ways {
        run.sim.trace.entries.extend(later.by_ref().take(way.manner.behind.saturating_sub(passed)));
        passed = way.manner.behind;
        run.sim.line = way.manner.line;
        one(run, plane, way).map_err(Halt::at(way.manner.span))?;
    }
    run.sim.trace.entries.extend(later);
    run.sim.trace.entries.truncate(run.sim.room_for());
    run.sim.line = line;
    Ok(())
}

fn one(run: &mut Interpreter, plane: &Plane, way: &Way) -> Result<(), Stop> {
    let Manner { kind, feed, length, tip, .. } = way.manner;
    // the position is told as the tool length of that time has it
    let since = run.sim.control.active_length() + -length;
    run.sim.position = run.sim.position + since;
    let seen = |at| plane.place(at, way.height) + tip + -length;
    let to = match way.at {
        Some(at) => seen(at),
        None => {
            let (_, height) = plane.split(run.sim.position + length);
            run.sim.position + plane.up() * (way.height - height)
        }
    };
    let around = way.round.map(|round| Around {
        centre: seen(round.centre),
        axis: plane.up(),
        degrees: Degrees::of(round.sweep),
    });
    let still = around.is_none() && (0..3).all(|i| (to[i] - run.sim.position[i]).abs() < 1e-9);
    if !still {
        run.sim.travel_machine(to, around, kind, feed, false)?;
    }
    run.sim.position = run.sim.position + -since;
    Ok(())
}
