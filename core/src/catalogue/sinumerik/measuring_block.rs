//! One measuring block, along an axis or any direction of the plane: to the start, `_FA` towards the surface and `_FA`
//! into it, back (B:1111-1121, B:2213-2225).
//!
//! Axes count 0 abscissa, 1 ordinate, 2 applicate. Directions are +1 and -1 along the axis.

mod positioning;
mod prepare;
mod ray;

pub use prepare::{follow, followed};
pub use ray::Ray;

use crate::catalogue::prelude::*;
use crate::machine::trace::MotionKind;

/// Pulled back between the fast and the slow touch, mm (B:13772).
const PULL_BACK: f64 = 2.0;

/// How the spindle stands while probing.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Spindle {
    /// As it is.
    Stays,
    /// A mono probe is turned into the direction of probing, plus this angle (B:864-871, B:13624).
    Follows(Degrees),
}

/// Everything a measuring block needs besides the point.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Indices X Y Z of abscissa, ordinate, applicate.
    pub axes: [usize; 3],
    /// Radius of the probe in the tool memory, mm.
    pub radius: f64,
    /// `_FA`, mm.
    pub path: f64,
    /// How far the ball centre is from the point to which L1 refers, along the applicate of the WCS, mm: 0, or with
    /// `_CBIT[14]` the radius (B:13652), minus it where a frame mirrors the applicate.
    pub centre: f64,
    /// Trigger values by axis: probing in minus and plus direction, mm; position at switching minus surface.
    triggers: [[f64; 2]; 3],
    /// Ball centre minus spindle axis in abscissa and ordinate, mm (`_WP[k,7]`, `_WP[k,8]`).
    pub skew: [f64; 2],
    /// Active radius of the ball, mm: half of `_WP[k,0]`, 0 where it was never determined (B:6873, B:13442).
    pub ball: f64,
    /// Whether the probe was calibrated otherwise than it is used now (`_CBIT[16]`).
    other: bool,
    feed: f64,
    fast: Option<f64>,
    attempts: u32,
    /// How often a place is touched (`_NMSP`).
    pub repeats: u32,
    monitored: bool,
    feed_plane: f64,
    feed_depth: f64,
    rapid_retract: bool,
    spindle: Spindle,
}

/// A surface to be touched along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Axis.
    pub axis: usize,
    /// Direction of the probe, +1 or -1.
    pub direction: f64,
    /// Set coordinate of the surface, mm.
    pub set: f64,
    /// Distance of start and end from the set switching position, mm.
    pub path: f64,
}

/// The way of a measuring block.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Way {
    /// Start.
    start: Wcs,
    /// End.
    end: Wcs,
    /// Unit vector from start to end.
    direction: [f64; 3],
}

impl Block {
    /// Position at switching minus coordinate of the surface, mm.
    pub fn trigger(&self, axis: usize, direction: f64) -> f64 {
        self.triggers[axis.min(2)][usize::from(direction > 0.0)]
    }

    /// This block with a probe that was never calibrated: plus or minus the radius (B:6402-6418), and along the
    /// applicate from the point to which L1 refers (B:5581-5583).
    pub fn uncalibrated(&self) -> Block {
        let ideal = [self.radius, -self.radius];
        Block {
            triggers: [ideal, ideal, ideal.map(|trigger| trigger - self.centre)],
            skew: [0.0; 2],
            ball: self.radius,
            ..self.clone()
        }
    }

    /// This block, calculating with the active ball alone, which needs no trigger values (B:10901-10906).
    pub fn by_ball(&self) -> Block {
        Block { triggers: [[self.ball, -self.ball]; 3], ..self.clone() }
    }

    /// This block with one measuring feed, mm/min, so many times.
    pub fn at_feed(&self, feed: f64, repeats: u32) -> Block {
        Block { feed, fast: None, repeats, ..self.clone() }
    }

    /// Where the centre of the ball is when the probe stands here, X Y Z of the WCS, mm, as far as the control knows.
    pub fn ball_at(&self, position: [f64; 3]) -> [f64; 3] {
        let [abscissa, ordinate, applicate] = self.axes;
        let mut ball = position;
        ball[abscissa] += self.skew[0];
        ball[ordinate] += self.skew[1];
        ball[applicate] += self.centre;
        ball
    }

    /// A position moved to a place of the plane: abscissa, ordinate, mm.
    pub fn placed(&self, position: [f64; 3], [abscissa, ordinate]: [f64; 2]) -> [f64; 3] {
        let mut to = position;
        (to[self.axes[0]], to[self.axes[1]]) = (abscissa, ordinate);
        to
    }

    /// A surface to be touched along an axis with the path of this block; direction +1 or -1, set coordinate in mm.
    pub fn point(&self, axis: usize, direction: f64, set: f64) -> Point {
        Point { axis, direction, set, path: self.path }
    }

    /// Start of the measuring block in the measuring axis: the ball `path` before the set surface, WCS, mm.
    pub fn start(&self, point: &Point) -> f64 {
        point.set + self.trigger(point.axis, point.direction) - point.direction * point.path
    }

    /// End of the measuring block in the measuring axis, WCS, mm.
    pub fn end(&self, point: &Point) -> f64 {
        point.set + self.trigger(point.axis, point.direction) + point.direction * point.path
    }

    /// Touches a surface `_NMSP` times and returns to the start of the block. Coordinate of the surface, mm.
    pub fn measure(&self, machine: &mut dyn Machine, point: &Point) -> Result<f64, Stop> {
        Ok(self.latch(machine, point)? - self.trigger(point.axis, point.direction))
    }

    /// Touches as [`Block::measure`] does; mean position at switching, mm.
    pub fn latch(&self, machine: &mut dyn Machine, point: &Point) -> Result<f64, Stop> {
        self.face(machine, point);
        let mut start = machine.position();
        start[self.axes[point.axis.min(2)]] = self.start(point);
        self.travel_as_far(machine, start)?;
        self.towards(machine, point, self.end(point))
    }

    /// Touches a surface whose place is not known `_NMSP` times from where the probe stands, on a way of twice the
    /// path, and returns there. Coordinate of the surface, mm.
    pub fn measure_from_here(&self, machine: &mut dyn Machine, point: &Point) -> Result<f64, Stop> {
        Ok(self.latch_from_here(machine, point)? - self.trigger(point.axis, point.direction))
    }

    /// Touches as [`Block::measure_from_here`] does; mean position at switching, mm.
    pub fn latch_from_here(&self, machine: &mut dyn Machine, point: &Point) -> Result<f64, Stop> {
        self.face(machine, point);
        let here = machine.position()[self.axes[point.axis.min(2)]];
        self.towards(machine, point, here + point.direction * 2.0 * point.path)
    }

    /// From here along the measuring axis as far as this coordinate; mean position at switching, mm.
    fn towards(&self, machine: &mut dyn Machine, point: &Point, end: f64) -> Result<f64, Stop> {
        let axis = self.axes[point.axis.min(2)];
        let start = machine.position();
        let mut way = Way { start, end: start, direction: [0.0; 3] };
        (way.end[axis], way.direction[axis]) = (end, point.direction);
        Ok(self.mean(machine, &way)?[axis])
    }

    /// Mean position of `_NMSP` measurements (B:2348-2356); the probe stands at the start and returns there.
    fn mean(&self, machine: &mut dyn Machine, way: &Way) -> Result<Wcs, Stop> {
        let mut sum = [0.0; 3];
        for _ in 0..self.repeats {
            let position = self.attempt(machine, way)?;
            (0..3).for_each(|axis| sum[axis] += position[axis]);
        }
        Ok(Wcs(sum.map(|sum| sum / f64::from(self.repeats))))
    }

    /// Probes up to five times until the probe switches (B:13999-14001); each attempt begins at the start. Where a
    /// software limit switch ends the way before the probe switches, it is 61401 instead of 61301 (A:15920).
    fn attempt(&self, machine: &mut dyn Machine, way: &Way) -> Result<Wcs, Stop> {
        let limited = machine.control().limited(way.start, way.end);
        let reached = Way { end: limited.unwrap_or(way.end), ..*way };
        for _ in 0..self.attempts {
            let touched = self.touch(machine, &reached)?;
            self.back(machine, way.start)?;
            if let Some(position) = touched {
                return Ok(position);
            }
        }
        Err(alarm(machine, if limited.is_some() { 61401 } else { 61301 }))
    }

    /// Towards the surface; with `_CHBIT[17]` fast, back by 2 mm (not behind the start) and slowly again.
    fn touch(&self, machine: &mut dyn Machine, way: &Way) -> Result<Option<Wcs>, Stop> {
        if let Some(fast) = self.fast {
            let Some(first) = machine.probe(way.end, fast)? else { return Ok(None) };
            let gone = |axis: usize| (first[axis] - way.start[axis]) * way.direction[axis];
            let room = (0..3).map(gone).sum::<f64>().min(PULL_BACK);
            self.back(machine, Wcs(std::array::from_fn(|axis| first[axis] - way.direction[axis] * room)))?;
        }
        machine.probe(way.end, self.feed)
    }

    /// Away from the surface (B:1121, B:14005-14007).
    fn back(&self, machine: &mut dyn Machine, to: Wcs) -> Result<(), Stop> {
        let at_feed = self.monitored && !self.rapid_retract;
        let feed = if at_feed { self.positioning_feed(machine.position(), to) } else { 0.0 };
        machine.travel(to, MotionKind::Retract, feed, false)
    }

    /// Turns the spindle under a multi probe; false: a mono probe stands as the direction of probing wants.
    pub fn reverse(&self, machine: &mut dyn Machine, angle: Degrees) -> bool {
        let multi = self.spindle == Spindle::Stays;
        if multi {
            machine.orient(angle.positive());
        }
        multi
    }

    /// Turns a probe that follows towards a surface; along the applicate it stands as it is.
    fn face(&self, machine: &mut dyn Machine, point: &Point) {
        let backwards = if point.direction > 0.0 { 0.0 } else { 180.0 };
        if point.axis < 2 {
            self.orient(machine, Degrees(90.0 * point.axis as f64 + backwards));
        }
    }

    /// Turns a probe that follows into the direction of probing, from the abscissa of the WCS.
    fn orient(&self, machine: &mut dyn Machine, angle: Degrees) {
        if let Spindle::Follows(offset) = self.spindle {
            let seen = on_machine(machine.control(), angle);
            machine.orient((offset - seen).positive());
        }
    }
}

/// A direction of the WCS on the machine, from the abscissa to the ordinate: frames may be turned and mirrored.
fn on_machine(control: &Control, angle: Degrees) -> Degrees {
    let [abscissa, ordinate, _] = control.plane.axes();
    let mut direction = [0.0; 3];
    (direction[ordinate], direction[abscissa]) = angle.sin_cos();
    let seen = control.direction_to_machine(Dir::new(direction)).0;
    if seen == direction { angle } else { Degrees::of(seen[ordinate].atan2(seen[abscissa])) }
}

/// Asks for a spindle that a measuring variant can turn (61372, A:15916).
pub fn turnable(machine: &mut dyn Machine) -> Result<(), Stop> {
    let turns = machine.control().spindle_positions;
    holds(machine, turns, 61372)
}

/// Ends the cycle with this alarm where something does not hold.
fn holds(machine: &mut dyn Machine, holds: bool, number: u32) -> Result<(), Stop> {
    if holds { Ok(()) } else { Err(alarm(machine, number)) }
}

/// Refuses a probe that was calibrated otherwise than it is used now (61341, B:13658-13667).
pub fn same_calibration(machine: &mut dyn Machine, block: &Block) -> Result<(), Stop> {
    holds(machine, !block.other, 61341)
}

/// Whether the trigger of this axis and direction is there: it is not the one of the other direction, nor 0, as
/// deleted data are (B:13642) while only the other direction was found anew, and comes from a calibration as the probe
/// is used now (61341 otherwise, B:13565-13667).
fn calibrated(block: &Block, axis: usize, direction: f64) -> bool {
    let [minus, plus] = block.triggers[axis.min(2)];
    // a length that ends at the circumference of the ball is touched with no trigger at all (B:5581-5583)
    let none = axis == 2 && direction * block.centre < 0.0;
    let found = none || block.trigger(axis, direction) != 0.0;
    minus != plus && found && !block.other
}

/// Refuses a probe of which one of these triggers, axis and direction, was never found (61341).
pub fn all_calibrated(machine: &mut dyn Machine, block: &Block, sides: &[(usize, f64)]) -> Result<(), Stop> {
    holds(machine, sides.iter().all(|(axis, direction)| calibrated(block, *axis, *direction)), 61341)
}

/// Refuses a probe without an active ball, which measures nothing at an angle (61341, B:6873); as [`calibrated`].
pub fn ball_known(machine: &mut dyn Machine, block: &Block) -> Result<(), Stop> {
    holds(machine, block.ball > 0.0 && !block.other, 61341)
}
