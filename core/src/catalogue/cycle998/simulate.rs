//! What CYCLE998 does: touch two or three points of a surface, and correct what their heights tell (B:7530-7582,
//! B:7788-7808).

use super::angles::{Leg, Surface};
use super::correction::Correction;
use super::params::{AT_ANGLE, DIFFERENTIAL};
use crate::catalogue::sinumerik::differential::twice;
use crate::catalogue::sinumerik::measuring_block::{Block, Point, same_calibration, turnable};
use crate::catalogue::sinumerik::{Next, alarm, results, tolerance, until_done};
use crate::entry::{Inputs, names};
use crate::evaluate::mean;
use crate::geometry::Wcs;
use crate::machine::{Machine, Stop};

/// Runs the cycle from the present position, which is opposite the first point.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    results::begin(machine, inputs, 998);
    let block = Block::prepare(machine, inputs)?;
    let Some(surface) = Surface::of(inputs) else {
        return Err(alarm(machine, 61325));
    };
    if DIFFERENTIAL.holds(inputs) {
        turnable(machine)?; // a probe that was never calibrated will do
    } else {
        same_calibration(machine, &block)?;
    }
    let correction = Correction::prepare(machine, inputs)?;
    begin(machine, inputs);
    let start = machine.position();
    until_done(|repetition| {
        let rises = measure(machine, inputs, &block, &surface, start.0)?;
        let angles = report(machine, &surface, &rises);
        let offset = tolerance::empirical_angle(machine.control(), inputs);
        let wrong: Vec<f64> = surface.legs.iter().zip(&angles).map(|(leg, angle)| angle - offset - leg.set).collect();
        let next = tolerance::safe(machine, inputs, &wrong, repetition)?;
        if next == Next::Done {
            correction.write(machine, &surface, &wrong);
        }
        Ok(next)
    })
}

/// What is known before the first motion (B:7350-7356).
fn begin(machine: &mut dyn Machine, inputs: &Inputs) {
    let memory = mean::memories(inputs.integer(names::EVNUM)).empirical;
    let stored = match memory {
        0 => 0.0,
        number => machine.control().number(&format!("_EV[{}]", number - 1)),
    };
    results::angle(machine, 30, stored);
    results::integer(machine, 0, inputs.integer(names::KNUM));
    results::integer(machine, 7, memory);
    results::integer(machine, 11, 0);
}

/// Touches the first point and the others, from it and back to it; ends at the last one. How much higher the surface is
/// there than at the first, mm.
fn measure(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    block: &Block,
    surface: &Surface,
    start: [f64; 3],
) -> Result<Vec<f64>, Stop> {
    let axis = surface.measuring;
    let at_angle = AT_ANGLE.holds(inputs);
    let direction = direction(inputs, start[block.axes[axis]]);
    block.travel(machine, Wcs(first_start(inputs, block, start, axis, direction)))?;
    let (first, skew) = first_point(machine, inputs, block, axis, direction)?;
    let from = machine.position();
    let mut rises = Vec::new();
    for leg in &surface.legs {
        block.travel(machine, from)?;
        let away = if at_angle { beside(inputs, leg, direction) } else { 0.0 };
        let mut to = from;
        to[block.axes[leg.axis]] += leg.distance;
        to[block.axes[axis]] += away;
        block.travel(machine, to)?;
        let other = plain(inputs, block).measure_from_here(machine, axis, direction, 2.0 * block.path)?;
        rises.push(other + skew - first);
    }
    Ok(rises)
}

/// The probe as it is reckoned with: in differential measurement as one that was never calibrated.
fn plain(inputs: &Inputs, block: &Block) -> Block {
    if DIFFERENTIAL.holds(inputs) { block.uncalibrated() } else { block.clone() }
}

/// Towards the set position (B:7488); without one as `_MD` says (B:7412).
fn direction(inputs: &Inputs, here: f64) -> f64 {
    let minus =
        if AT_ANGLE.holds(inputs) { inputs.number(names::SETVAL) < here } else { inputs.integer(names::MD) == 1 };
    if minus { -1.0 } else { 1.0 }
}

/// Where the first touch begins: before the set position, without one where the cycle is called (B:7530-7560).
fn first_start(inputs: &Inputs, block: &Block, start: [f64; 3], axis: usize, direction: f64) -> [f64; 3] {
    let mut from = start;
    if AT_ANGLE.holds(inputs) {
        let point = set_point(inputs, block, axis, direction);
        from[block.axes[axis]] = plain(inputs, block).start(&point);
    }
    from
}

fn set_point(inputs: &Inputs, block: &Block, axis: usize, direction: f64) -> Point {
    block.point(axis, direction, inputs.or_zero(names::SETVAL))
}

/// Coordinate of the surface at the first point, and what the skew of an uncalibrated probe adds at the others, mm.
fn first_point(
    machine: &mut dyn Machine,
    inputs: &Inputs,
    block: &Block,
    axis: usize,
    direction: f64,
) -> Result<(f64, f64), Stop> {
    let point = set_point(inputs, block, axis, direction);
    if DIFFERENTIAL.holds(inputs) {
        let found = twice(machine, inputs, block, &point)?;
        return Ok((found.surface, found.skew));
    }
    if AT_ANGLE.holds(inputs) {
        return Ok((block.measure(machine, &point)?, 0.0));
    }
    Ok((block.measure_from_here(machine, axis, direction, 2.0 * block.path)?, 0.0))
}

/// How far the measuring axis moves on the way to another point: along the set angle, and away from the surface by the
/// safe area (B:7546).
fn beside(inputs: &Inputs, leg: &Leg, direction: f64) -> f64 {
    let angle = leg.sense * leg.set - direction * inputs.number(names::TSA);
    leg.distance * angle.to_radians().tan()
}

/// Set angle, actual angle, difference: of one angle, or first about the abscissa, then about the ordinate
/// (B:7332-7337).
/// The actual angles in the order of the ways.
fn report(machine: &mut dyn Machine, surface: &Surface, rises: &[f64]) -> Vec<f64> {
    let legs = surface.legs.iter();
    let angles: Vec<f64> = legs.zip(rises).map(|(leg, rise)| leg.angle(*rise)).collect();
    let by_axis = surface.legs.iter().zip(&angles).rev().enumerate();
    for (index, (leg, angle)) in by_axis {
        results::angle(machine, index, leg.set);
        results::angle(machine, 4 + index, *angle);
        results::angle(machine, 16 + index, angle - leg.set);
    }
    angles
}
