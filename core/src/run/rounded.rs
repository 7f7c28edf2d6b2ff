//! Corners between two straight blocks of the plane: rounded (RND, RNDM) or chamfered (CHF, CHR). The block drives to
//! where the corner begins and then the corner; the next block goes on from there. What is too large for its lines is
//! made smaller, as the control does.

use super::addresses::{coordinate, number};
use super::contour::{Point, distance, left};
use super::{Address, Coordinate, Interpreter, Motion, Path, motion, path::Corner, plain};
use crate::diagnostic::Severity;
use crate::geometry::{Around, Degrees, Dir};
use crate::problem::Problem;
use crate::syntax::Plain;
use crate::syntax::tree::{Block, WordKind};
use std::rc::Rc;

/// Blocks without motion over which the next one is looked for.
const AHEAD: usize = 10;
/// Changes of direction that make no corner, radian.
const STRAIGHT: f64 = 1e-6;
/// Lines that are shorter are none, mm.
const SHORT: f64 = 1e-9;
/// G functions beside which the next block is a line as before: exact stop, blending, feed, corners of compensation.
const BESIDE: [i64; 14] = [1, 9, 60, 64, 90, 91, 94, 95, 450, 451, 601, 602, 641, 642];

/// How a corner is driven, in the coordinates of the blocks.
#[derive(Clone, Copy, Debug)]
pub struct Rounded {
    pub begin: [f64; 3],
    pub end: [f64; 3],
    /// Round what; none: a chamfer.
    pub around: Option<Around<[f64; 3]>>,
}

/// The corner behind a block from one point to another; none: the block ends in its own end. Where the block asks for
/// one that is not driven, that is told.
pub fn corner(run: &mut Interpreter, path: &Path, ends: [[f64; 3]; 2]) -> Option<Rounded> {
    let modal = Some(Corner::Radius(run.modal.rounding)).filter(|_| run.modal.rounding > 0.0);
    let wanted = path.corner.or(modal)?;
    let straight = run.modal.motion == Motion::Line && path.measure.is_none();
    let next = if straight { next(run, ends[1]) } else { None };
    if let Some(next) = next {
        return between(run, wanted, ends[0], ends[1], next);
    }
    if path.corner.is_some() {
        run.tell(Severity::Warning, &Problem::new("run-not-simulated", path.span, wanted.word()));
    }
    None
}

/// The corner between two lines of the plane; none: they go on straight, turn back or leave the plane.
fn between(run: &Interpreter, wanted: Corner, from: [f64; 3], at: [f64; 3], to: [f64; 3]) -> Option<Rounded> {
    let [a, o, p] = run.sim.control.plane.axes();
    let seen = |point: [f64; 3]| Point::new(point[a], point[o]);
    let lengths = [distance(seen(from), seen(at)), distance(seen(at), seen(to))];
    let level = (from[p] - at[p]).abs() < SHORT && (at[p] - to[p]).abs() < SHORT;
    if !level || lengths.iter().any(|length| *length < SHORT) {
        return None;
    }
    let [arrives, departs] = [(seen(at) - seen(from)) / lengths[0], (seen(to) - seen(at)) / lengths[1]];
    let turn = arrives.perp(&departs).atan2(arrives.dot(&departs));
    let half = (turn.abs() / 2.0).tan();
    if turn.abs() < STRAIGHT || std::f64::consts::PI - turn.abs() < STRAIGHT {
        return None;
    }
    let leg = match wanted {
        Corner::Radius(radius) => radius * half,
        Corner::Chamfer(length) => length / (2.0 * (turn / 2.0).cos()),
        Corner::Leg(length) => length,
    };
    let leg = leg.min(lengths[0]).min(lengths[1]);
    if leg < SHORT {
        return None;
    }
    let placed = |point: Point| {
        let mut place = at;
        (place[a], place[o]) = (point.x, point.y);
        place
    };
    let begin = seen(at) - arrives * leg;
    let around = match wanted {
        Corner::Radius(_) => {
            let mut axis = Dir::default();
            axis[p] = 1.0;
            let centre = placed(begin + left(arrives) * (leg / half * turn.signum()));
            Some(Around { centre, axis, degrees: Degrees::of(turn) })
        }
        Corner::Chamfer(_) | Corner::Leg(_) => None,
    };
    Some(Rounded { begin: placed(begin), end: placed(seen(at) + departs * leg), around })
}

/// Where the next line ends that begins in this point; none: what comes is something else, or is not known yet.
fn next(run: &mut Interpreter, at: [f64; 3]) -> Option<[f64; 3]> {
    let program = Rc::clone(&run.program);
    let own = run.levels.last()?.blocks.clone();
    for index in own.filter(|index| *index > run.at).take(AHEAD) {
        let block = program.blocks.get(index)?;
        if block.skip.is_some_and(|level| run.skip.contains(&level)) {
            continue;
        }
        let line = line(run, block)?;
        if line.axes.iter().any(Option::is_some) {
            let absolute = std::mem::replace(&mut run.modal.absolute, line.absolute);
            let to = std::array::from_fn(|i| motion::target(run, at[i], at[i], line.axes[i], i));
            run.modal.absolute = absolute;
            return Some(to);
        }
    }
    None
}

/// What the axis words of a line say.
struct Line {
    axes: [Option<Coordinate>; 3],
    absolute: bool,
}

/// A block as a line, perhaps without motion; none: it is something else.
fn line(run: &Interpreter, block: &Block) -> Option<Line> {
    let mut found = Line { axes: [None; 3], absolute: run.modal.absolute };
    for part in run.program.plain(block).iter().flat_map(Plain::parts) {
        take(run, &plain::address(part), &mut found)?;
    }
    for word in run.program.words_of(block) {
        if matches!(word.kind, WordKind::Label(_) | WordKind::Header) {
            continue;
        }
        take(run, &Address::of(run, word).ok()??, &mut found)?;
    }
    Some(found)
}

/// Takes an address of a line; none: it makes the block something else.
fn take(run: &Interpreter, address: &Address, line: &mut Line) -> Option<()> {
    let value = number(address).ok()?;
    match address.name.as_str() {
        "G" if value == 90.0 => line.absolute = true,
        "G" if value == 91.0 => line.absolute = false,
        "G" if BESIDE.iter().any(|code| *code as f64 == value) => {}
        "F" | "S" | "M" | "H" | "RND" | "CHF" | "CHR" | "FRC" | "FRCM" | "RNDM" => {}
        axis => {
            let place = crate::control::AXES.iter().position(|known| *known == axis)?;
            let coordinate = coordinate(address, run.sim.control.active_factor()).ok()?;
            *line.axes.get_mut(place).filter(|_| address.extension.is_none())? = Some(coordinate);
        }
    }
    Some(())
}
