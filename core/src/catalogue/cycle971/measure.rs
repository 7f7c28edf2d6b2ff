//! Measuring length or radius of the tool in use (B:4747-5029).

use super::params::{APPLICATE, ROTATING};
use super::spindle;
use crate::catalogue::prelude::*;
use crate::catalogue::tool_probe::Stand;
use crate::catalogue::tool_probe::correct::{Measured, active};
use crate::evaluate::tool_offset::RADIUS;

/// Length or radius, as `_MA` says.
pub fn measure(machine: &mut dyn Machine, stand: &Stand) -> Result<Measured, Stop> {
    if APPLICATE.holds(stand.inputs) { length(machine, stand) } else { radius(machine, stand) }
}

/// What L1 has to be longer by is how much higher than the upper side the position of the tool's end is at contact.
fn length(machine: &mut dyn Machine, stand: &Stand) -> Result<Measured, Stop> {
    let axis = usize::from(stand.inputs.integer(names::MA) / 100 == 2);
    stand.over(machine, stand.probe.centre(), axis)?;
    let (touched, compensated) = touch(machine, stand, &stand.above())?;
    let value = active(machine.control(), 0) + touched - stand.probe.top() - compensated;
    Ok(Measured { part: 0, result: 8, value })
}

/// The radius is how far the axis of the tool is from the side at contact; its widest place stands `_ID` above its end,
/// so that it goes lower by that (B:4849).
fn radius(machine: &mut dyn Machine, stand: &Stand) -> Result<Measured, Stop> {
    let axis = usize::from(stand.inputs.integer(names::MA) == 2);
    let direction = stand.approach(machine, axis)?;
    let point = stand.beside(axis, direction);
    let low = stand.probe.low() - stand.inputs.number(names::ID);
    stand.enter(machine, &point, stand.probe.middle(1 - axis), low)?;
    let (touched, compensated) = touch(machine, stand, &point)?;
    let value = direction * (stand.probe.trigger(axis, direction) - touched) - compensated;
    Ok(Measured { part: RADIUS, result: 10, value })
}

/// Position at contact, and what the table of the probe takes off, mm.
fn touch(machine: &mut dyn Machine, stand: &Stand, point: &Point) -> Result<(f64, f64), Stop> {
    match ROTATING.holds(stand.inputs) {
        true => spindle::touch(machine, stand, point),
        false => Ok((stand.block.latch(machine, point)?, 0.0)),
    }
}
