//! Measuring length or radius of the tool in use (B:4747-5029).

use super::params::{APPLICATE, ROTATING};
use super::place::Task;
use super::spindle;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::measuring_block::Point;
use crate::catalogue::tool_probe::correct::{Measured, active};
use crate::evaluate::tool_offset::RADIUS;

/// Length or radius, as `_MA` says.
pub fn measure(machine: &mut dyn Machine, task: &Task) -> Result<Measured, Stop> {
    if APPLICATE.holds(task.inputs) { length(machine, task) } else { radius(machine, task) }
}

/// What L1 has to be longer by is how much higher than the upper side the position of the tool's end is at contact.
fn length(machine: &mut dyn Machine, task: &Task) -> Result<Measured, Stop> {
    let offset = task.inputs.integer(names::MA) / 100;
    let offset = task.offset(machine, usize::from(offset == 2));
    task.over(machine, task.place.middle(), offset)?;
    let (touched, compensated) = touch(machine, task, &task.above())?;
    Ok(Measured { part: 0, result: 8, value: active(machine.control(), 0) + touched - task.place.top() - compensated })
}

/// The radius is how far the axis of the tool is from the side at contact; its widest place stands `_ID` above its end,
/// so that it goes lower by that (B:4849).
fn radius(machine: &mut dyn Machine, task: &Task) -> Result<Measured, Stop> {
    let axis = usize::from(task.inputs.integer(names::MA) == 2);
    let direction = task.direction(machine, axis)?;
    let point = task.beside(axis, direction);
    let lower = task.inputs.given(names::ID).unwrap_or(0.0);
    let low = task.place.low() - lower;
    task.enter(machine, &point, task.place.sides.middle(1 - axis), low)?;
    let (touched, compensated) = touch(machine, task, &point)?;
    Ok(Measured {
        part: RADIUS,
        result: 10,
        value: direction * (task.place.sides.trigger(axis, direction) - touched) - compensated,
    })
}

/// Position at contact, and what the table of the probe takes off, mm.
fn touch(machine: &mut dyn Machine, task: &Task, point: &Point) -> Result<(f64, f64), Stop> {
    match ROTATING.holds(task.inputs) {
        true => spindle::touch(machine, task, point),
        false => Ok((task.block.latch(machine, point)?, 0.0)),
    }
}
