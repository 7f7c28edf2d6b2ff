//! What CYCLE976 does: in a hole, on a surface, or on a surface with the length of the probe.

use super::directions::angle;
use super::hole;
use super::params::{HOLE, LENGTH, UNKNOWN};
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::calibration::{Calibration, Trigger, store};
use crate::catalogue::sinumerik::measuring_block::turnable;

/// Runs the cycle from the present position: in the hole, or opposite the surface.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    results::begin(machine, inputs, 976);
    results::integer(machine, 3, inputs.variant);
    results::angle(machine, 24, angle(inputs).0);
    results::length(machine, 27, inputs.number(names::TZL));
    let block = Block::prepare(machine, inputs)?;
    if UNKNOWN.holds(inputs) {
        turnable(machine)?;
    }
    let start = machine.position();
    let measure = if HOLE.holds(inputs) { hole::measure } else { surface };
    until_done(|repetition| {
        let found = measure(machine, inputs, &block, start)?;
        store(machine, inputs, &found, repetition)
    })
}

/// One direction of one axis. With the length the block begins where the probe stands and is twice `_FA` long: nobody
/// knows yet where the surface will be met (B:5579, B:5589-5593).
fn surface(machine: &mut dyn Machine, inputs: &Inputs, block: &Block, start: Wcs) -> Result<Calibration, Stop> {
    let block = block.uncalibrated();
    let point = Point {
        axis: axis(machine, inputs, if LENGTH.holds(inputs) { 3..=3 } else { 1..=3 })?,
        direction: if inputs.integer(names::MD) == 1 { -1.0 } else { 1.0 },
        set: inputs.number(names::SETVAL),
        path: block.path,
    };
    let with_length = LENGTH.holds(inputs);
    let position = if with_length { block.latch_from_here(machine, &point)? } else { block.latch(machine, &point)? };
    if point.axis < 2 {
        block.travel(machine, start)?; // B:5449-5455: along the applicate it stays before the surface
    }
    let found = position - point.set;
    let ideal = block.trigger(point.axis, point.direction);
    let (value, length) = if with_length { (ideal, Some(found - ideal)) } else { (found, None) };
    let trigger = Trigger { axis: point.axis, sign: point.direction, value };
    Ok(Calibration { triggers: vec![trigger], length, ..Calibration::default() })
}
