//! What CYCLE998 does: touch points of a surface, and correct what their heights tell (B:7530-7582, B:7788-7808).

use super::angles::Surface;
use super::correction::Correction;
use super::params::{AT_ANGLE, DIFFERENTIAL};
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::differential::twice;
use crate::catalogue::sinumerik::measuring_block::{Block, Point, same_calibration, turnable};
use crate::catalogue::sinumerik::tolerance;
use crate::evaluate::mean;

/// Runs the cycle from the present position, which is opposite the first point.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    results::begin(machine, inputs, 998);
    let block = Block::prepare(machine, inputs)?;
    let Some(surface) = Surface::of(inputs) else { return Err(alarm(machine, 61325)) };
    if DIFFERENTIAL.holds(inputs) {
        turnable(machine)?; // a probe that was never calibrated will do
    } else {
        same_calibration(machine, &block)?;
    }
    let correction = Correction::prepare(machine, inputs)?;
    begin(machine, inputs);
    let start = machine.position();
    let direction = direction(inputs, start[block.axes[surface.measuring]]);
    let probing = Probing {
        inputs,
        block: &block,
        plain: if DIFFERENTIAL.holds(inputs) { block.uncalibrated() } else { block.clone() },
        surface: &surface,
        point: block.point(surface.measuring, direction, inputs.number(names::SETVAL)),
    };
    until_done(|repetition| {
        let rises = probing.measure(machine, start)?;
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
    let stored = machine.control().number(&format!("_EV[{}]", memory - 1)); // without a memory 0
    results::angle(machine, 30, stored);
    results::integer(machine, 0, inputs.integer(names::KNUM));
    results::integer(machine, 7, memory);
    results::integer(machine, 11, 0);
}

/// Towards the set position (B:7488); without one as `_MD` says (B:7412).
fn direction(inputs: &Inputs, here: f64) -> f64 {
    let minus =
        if AT_ANGLE.holds(inputs) { inputs.number(names::SETVAL) < here } else { inputs.integer(names::MD) == 1 };
    if minus { -1.0 } else { 1.0 }
}

/// A surface that is touched.
struct Probing<'a> {
    inputs: &'a Inputs,
    block: &'a Block,
    /// The block with the probe of the calculation: in differential measurement one that was never calibrated.
    plain: Block,
    surface: &'a Surface,
    /// The first point.
    point: Point,
}

impl Probing<'_> {
    /// Touches the first point and the others, from it and back to it; ends at the last one. How much higher the
    /// surface is there than at the first, mm.
    fn measure(&self, machine: &mut dyn Machine, start: Wcs) -> Result<Vec<f64>, Stop> {
        let Probing { inputs, block, plain, surface, point } = self;
        let Point { axis, direction, .. } = *point;
        let at_angle = AT_ANGLE.holds(inputs);
        let mut first_start = start;
        if at_angle {
            // before the set position, without one where the cycle is called (B:7530-7560)
            first_start[block.axes[axis]] = plain.start(point);
        }
        block.travel(machine, first_start)?;
        let (first, skew) = self.first_point(machine)?;
        let from = machine.position();
        let mut rises = Vec::new();
        for leg in &surface.legs {
            block.travel(machine, from)?;
            let mut to = from;
            to[block.axes[leg.axis]] += leg.distance;
            if at_angle {
                // along the set angle, and away from the surface by the safe area (B:7546)
                to[block.axes[axis]] += leg.rise(leg.set - leg.sense * direction * inputs.degrees(names::TSA).0);
            }
            block.travel(machine, to)?;
            rises.push(plain.measure_from_here(machine, point)? + skew - first);
        }
        Ok(rises)
    }

    /// Coordinate of the surface at the first point, and what the skew of an uncalibrated probe adds at the others, mm.
    fn first_point(&self, machine: &mut dyn Machine) -> Result<(f64, f64), Stop> {
        let Probing { inputs, block, point, .. } = self;
        if DIFFERENTIAL.holds(inputs) {
            let found = twice(machine, inputs, block, point)?;
            return Ok((found.surface, found.skew));
        }
        let found = match AT_ANGLE.holds(inputs) {
            true => block.measure(machine, point)?,
            false => block.measure_from_here(machine, point)?,
        };
        Ok((found, 0.0))
    }
}

/// Set angle, actual angle, difference: of one angle, or first about the abscissa, then about the ordinate
/// (B:7332-7337); the actual angles in the order of the ways.
fn report(machine: &mut dyn Machine, surface: &Surface, rises: &[f64]) -> Vec<f64> {
    let legs = surface.legs.iter();
    let angles: Vec<f64> = legs.zip(rises).map(|(leg, rise)| leg.angle(*rise)).collect();
    for (index, (leg, angle)) in surface.legs.iter().zip(&angles).rev().enumerate() {
        results::angle(machine, index, leg.set);
        results::angle(machine, 4 + index, *angle);
        results::angle(machine, 16 + index, angle - leg.set);
    }
    angles
}
