//! What CYCLE974 does: one point of a turned part, as it stands or at two places 180 degree apart (B:10409-10872).

use super::params::REVERSAL;
use crate::catalogue::lathe::measure;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::measuring_block::{Block, Point, all_calibrated, turnable};
use crate::catalogue::sinumerik::one_point::OnePoint;
use crate::catalogue::sinumerik::target::Target;
use crate::catalogue::sinumerik::until_done;

/// Runs the cycle from the present position, which is opposite the point.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    measure::begin(machine, inputs, 974);
    let block = Block::prepare(machine, inputs)?;
    let axis = axis(machine, inputs, 1..=3)?;
    let reversal = REVERSAL.holds(inputs);
    if reversal {
        turnable(machine)?;
    }
    let per = measure::per(machine.control(), inputs);
    let set = inputs.number(names::SETVAL);
    let start = machine.position()[block.axes[axis]];
    let direction = if set / per < start { -1.0 } else { 1.0 };
    all_calibrated(machine, &block, &[(axis, direction)])?;
    let corrected = measure::corrected(inputs, axis);
    let target = Target::of(machine, inputs, Some(corrected))?;
    let point = block.point(axis, direction, set / per);
    until_done(|repetition| {
        let surface = match reversal {
            true => both_sides(machine, inputs, &block, &point)?,
            false => block.measure(machine, &point)?,
        };
        let ball = block.ball_at(machine.position().0);
        let found = OnePoint { axis, corrected, direction, ball, set, actual: surface * per, per };
        target.finish(machine, inputs, &found, repetition)
    })
}

/// Mean of the same point with the part turned to `_STA1` and 180 degree further (B:10784).
fn both_sides(machine: &mut dyn Machine, inputs: &Inputs, block: &Block, point: &Point) -> Result<f64, Stop> {
    let mut sum = 0.0;
    for further in [0.0, 180.0].map(Degrees) {
        machine.orient((inputs.degrees(names::STA1) + further).positive());
        sum += block.measure(machine, point)?;
    }
    Ok(sum / 2.0)
}
