//! What CYCLE978 does: one point of a surface, plain or differential (B:6376-6418).

use crate::catalogue::sinumerik::differential::twice;
use crate::catalogue::sinumerik::measuring_block::{Block, all_calibrated, turnable};
use crate::catalogue::sinumerik::one_point::OnePoint;
use crate::catalogue::sinumerik::target::Target;
use crate::catalogue::sinumerik::{Next, alarm, one_point, results};
use crate::entry::{Inputs, names};
use crate::machine::{Machine, Stop};

/// Runs the cycle from the present position, which is opposite the surface.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    results::begin(machine, inputs, 978);
    let block = Block::prepare(machine, inputs)?;
    let axis = match inputs.integer(names::MA) {
        axis @ 1..=3 => axis as usize - 1,
        _ => return Err(alarm(machine, 61325)),
    };
    let differential = inputs.variant / 1000 % 10 == 1;
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
    for repetition in 0.. {
        let (actual, reckoned) = match differential {
            true => {
                let found = twice(machine, inputs, &block, &point)?;
                (found.surface, block.uncalibrated()) // turned over, the ball stood evenly about the spindle axis
            }
            false => (block.measure(machine, &point)?, block.clone()),
        };
        let found = OnePoint {
            axis,
            corrected: axis,
            direction,
            ball: reckoned.ball_at(machine.position().0),
            set,
            actual,
            per: 1.0,
        };
        if one_point::finish(machine, inputs, &found, &target, repetition)? == Next::Done {
            break;
        }
    }
    Ok(())
}
