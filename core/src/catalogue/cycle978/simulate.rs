//! What CYCLE978 does: one point of a surface, plain or differential (B:6376-6418).

use super::params::DIFFERENTIAL;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::differential::twice;
use crate::catalogue::sinumerik::measuring_block::{Block, all_calibrated, turnable};
use crate::catalogue::sinumerik::one_point::OnePoint;
use crate::catalogue::sinumerik::target::Target;

/// Runs the cycle from the present position, which is opposite the surface.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    results::begin(machine, inputs, 978);
    let block = Block::prepare(machine, inputs)?;
    let axis = axis(machine, inputs, 1..=3)?;
    let differential = DIFFERENTIAL.holds(inputs);
    if differential {
        turnable(machine)?;
    }
    let start = machine.position();
    let set = inputs.number(names::SETVAL);
    let direction = if set < start[block.axes[axis]] { -1.0 } else { 1.0 };
    if !differential {
        all_calibrated(machine, &block, &[(axis, direction)])?;
    }
    let target = Target::of(machine, inputs, Some(axis))?;
    let point = block.point(axis, direction, set);
    until_done(|repetition| {
        let (actual, calculated) = match differential {
            true => {
                let found = twice(machine, inputs, &block, &point)?;
                (found.surface, block.uncalibrated()) // turned over, the ball stood evenly about the spindle axis
            }
            false => (block.measure(machine, &point)?, block.clone()),
        };
        let ball = calculated.ball_at(machine.position().0);
        let found = OnePoint { axis, corrected: axis, direction, ball, set, actual, per: 1.0 };
        target.finish(machine, inputs, &found, repetition)
    })
}
